"""The summary of `hugoniot verify` fits a terminal of 80 columns with every name in full."""

from hugoniot.campaign.verify import PROBLEMS, Judged, Verified
from hugoniot.cli.verify import _total


def test_the_summary_of_all_problems_fits_80_columns(capsys):
    results = []
    for name, problem in PROBLEMS.items():
        judged = [Judged(name, bar.measure, bar.zones, 0.0, bar.ko, bar.g2, bar.goal, bar.sense, bar.peer) for bar in problem.bars]
        results.append(Verified(problem, judged, {}, 12345.6, 1.2e-10, 0.0))
    _total(results)
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 80 and {line.split(maxsplit=1)[0] for line in lines if line} >= set(PROBLEMS)
    assert "second-order Godunov" in lines[-2] and "open codes" in lines[-1] and lines[1].split() == ["second-order", "open", "energy"]
