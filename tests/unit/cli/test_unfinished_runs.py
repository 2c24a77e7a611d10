"""A run that was interrupted can be looked at up to its last checkpoint, marked as partial, and goes on as if nobody had looked."""

import shutil
from types import SimpleNamespace

import numpy as np
import pytest

import hugoniot
from hugoniot import simulate
from hugoniot.cli.main import main
from hugoniot.cli.progress import end_interrupted
from hugoniot.errors import FileTrouble
from hugoniot.problem import catalogue


def call(capsys, *arguments):
    """(exit code, standard output, standard error) of one command."""
    with pytest.raises(SystemExit) as ended:
        main([str(a) for a in arguments])
    out, err = capsys.readouterr()
    return ended.value.code or 0, out, err


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    """A folder with a whole run, whole.run, and the same one interrupted after a checkpoint, part.run."""
    folder = tmp_path_factory.mktemp("part")
    deck = folder / "tube.toml"
    deck.write_text(catalogue.deck_text("sod").replace("zones = 100", "zones = 40").replace("[output]", "[output]\ncheckpoint_cycles = 20"))
    simulate.run(deck, folder / "whole.run")

    def stop(report):
        if list((folder / "part.run" / "checkpoint").glob("[0-9]*.json")):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        simulate.run(deck, folder / "part.run", progress=SimpleNamespace(update=stop))
    return folder


def standing(folder):
    return sorted((str(path.relative_to(folder)), path.stat().st_mtime_ns) for path in folder.rglob("*"))


def test_the_results_so_far_are_those_of_the_whole_run(place, tmp_path):
    before = standing(place / "part.run")
    run = simulate.so_far(place / "part.run", tmp_path)
    whole = hugoniot.load(place / "whole.run")
    time, velocity = run.gauge("velocity", "contact")
    all_times, all_velocities = whole.gauge("velocity", "contact")
    assert 5 < len(time) < len(all_times) and run.summary["status"].startswith("partial") and run.summary["wall_seconds"] is None
    assert np.array_equal(time, all_times[:len(time)]) and np.array_equal(velocity, all_velocities[:len(time)])
    assert time[-1] == run.summary["time"] and standing(place / "part.run") == before


def test_info_plot_report_and_compare_show_it_as_partial(place, capsys):
    part = place / "part.run"
    code, out, _ = call(capsys, "info", part)
    assert code == 0 and "partial (stop time" in out and "contact" in out and "warning: the results end at" in out and "resume" in out
    code, out, _ = call(capsys, "plot", part, "gauge", "velocity", "--out", place / "part.png")
    assert code == 0 and "partial" in out and (place / "part.png").stat().st_size > 5000
    code, out, _ = call(capsys, "compare", part, place / "whole.run")
    assert code == 0 and "a: partial (stop time" in out and f"a = {part}" in out
    code, _, _ = call(capsys, "report", part)
    assert code == 0 and "The run did not reach its end: partial (stop time" in (part / "report.html").read_text()


def test_looked_at_or_not_it_goes_on_to_the_same_bytes(place, tmp_path, capsys):
    folder = shutil.copytree(place / "part.run", tmp_path / "part.run")
    call(capsys, "report", folder)
    assert simulate.resume(folder).summary["status"] == "done"
    assert (folder / "gauges.csv").read_bytes() == (place / "whole.run" / "gauges.csv").read_bytes()
    assert (folder / "result.h5").read_bytes() == (place / "whole.run" / "result.h5").read_bytes()
    assert "did not reach its end" not in (folder / "report.html").read_text()


def test_the_report_of_an_unfinished_run_does_not_outlive_it(place, tmp_path, capsys):
    """Where the run ends but its report cannot be written, the partial one is not left beside the results."""
    folder = shutil.copytree(place / "part.run", tmp_path / "part.run")
    call(capsys, "report", folder)
    simulate.resume(folder, report=False)
    assert (folder / "summary.json").is_file() and not (folder / "report.html").exists()


def test_without_a_checkpoint_there_is_nothing_to_look_at(place, tmp_path, capsys):
    folder = shutil.copytree(place / "part.run", tmp_path / "part.run")
    for path in folder.glob("checkpoint/0*.h5"):
        path.write_bytes(path.read_bytes()[:-100])
    code, _, err = call(capsys, "info", folder)
    assert code == 4 and "no intact checkpoint with results; continue with `hugoniot resume" in err
    shutil.rmtree(folder / "checkpoint")
    shutil.rmtree(folder / "pieces")
    code, _, err = call(capsys, "info", folder)
    assert code == 4 and "no checkpoint yet" in err


def test_a_result_without_its_summary_says_what_to_do(place, tmp_path, capsys):
    folder = shutil.copytree(place / "whole.run", tmp_path / "whole.run")
    (folder / "summary.json").unlink()
    code, _, err = call(capsys, "info", folder)
    assert code == 4 and "summary.json is missing" in err and "`hugoniot resume" in err
    with pytest.raises(FileTrouble, match="summary.json is missing"):
        hugoniot.load(folder)
    unchecked, whole = hugoniot.load(folder, partial=True), hugoniot.load(place / "whole.run")
    assert np.array_equal(unchecked.gauge("velocity")[1], whole.gauge("velocity")[1])
    assert simulate.resume(folder).summary["status"] == "done"
    assert (folder / "result.h5").read_bytes() == (place / "whole.run" / "result.h5").read_bytes()


@pytest.mark.parametrize("run, words", [("whole.run", "the results are complete"), ("part.run", "a checkpoint is kept; continue with")])
def test_an_interruption_says_what_is_left_to_do(run, words, place, capsys):
    with pytest.raises(BaseException) as ended:
        end_interrupted(place / run)
    assert ended.value.exit_code == 130 and words in capsys.readouterr().err
