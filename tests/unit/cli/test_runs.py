"""The commands around a run, on a small shock tube."""

import json

import pytest

from hugoniot.cli.main import main
from hugoniot.problem import catalogue


def call(capsys, *arguments):
    """(exit code, standard output, standard error) of one command."""
    with pytest.raises(SystemExit) as ended:
        main([str(a) for a in arguments])
    out, err = capsys.readouterr()
    return ended.value.code or 0, out, err


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    """A folder with a deck and its run, tube.run."""
    folder = tmp_path_factory.mktemp("tube")
    (folder / "tube.toml").write_text(catalogue.deck_text("sod").replace("zones = 100", "zones = 20"))
    with pytest.raises(SystemExit) as ended:
        main(["run", str(folder / "tube.toml"), "--out", str(folder / "tube.run"), "--quiet"])
    assert (ended.value.code or 0) == 0
    return folder


def test_a_run_leaves_what_the_readme_promises(place):
    names = {path.name for path in (place / "tube.run").iterdir()}
    assert names >= {"deck.toml", "result.h5", "gauges.csv", "summary.json", "report.html", "run.log"}


def test_info_tells_people_and_programs(place, capsys):
    code, out, _ = call(capsys, "info", place / "tube.run")
    assert code == 0 and "Sod's shock tube: done" in out and "contact" in out
    code, out, _ = call(capsys, "info", place / "tube.run", "--json")
    told = json.loads(out)
    assert told["summary"]["status"] == "done" and told["gauges"][0]["gauge"] == "contact"
    code, out, _ = call(capsys, "info", place / "tube.run", "--deck")
    assert code == 0 and "every default is written out" in out


def test_a_wave_that_has_not_come_has_no_arrival(place, capsys):
    code, out, _ = call(capsys, "run", place / "tube.toml", "--set", "stop_time=0.1", "--set", "gauge=[{name='near', at=0.5}, {name='far', at=0.95}]",
                        "--out", place / "early.run", "--no-report", "-q")
    rows = {line.split()[0]: line for line in out.splitlines() if line.startswith(("near", "far"))}
    assert code == 0 and rows["far"].split()[1] == "none" and rows["near"].split()[1] != "none"


def test_the_resolved_deck_runs_again_to_the_same_bits(place, capsys):
    code, *_ = call(capsys, "run", place / "tube.run" / "deck.toml", "--out", place / "again.run", "-q", "--no-report")
    assert code == 0
    assert (place / "again.run" / "gauges.csv").read_bytes() == (place / "tube.run" / "gauges.csv").read_bytes()
    assert (place / "again.run" / "deck.toml").read_bytes() == (place / "tube.run" / "deck.toml").read_bytes()


def test_set_changes_a_run_and_compare_tells_by_how_much(place, capsys):
    code, out, _ = call(capsys, "run", place / "tube.toml", "--set", "region.high.pressure=1.1", "--out", place / "more.run", "--json", "--no-report")
    assert code == 0 and json.loads(out)["summary"]["status"] == "done"
    code, out, _ = call(capsys, "compare", place / "tube.run", place / "more.run", "--json")
    pairs = {(p["gauge"], p["field"]): p for p in json.loads(out)["pairs"]}
    assert pairs["contact", "velocity"]["linf"] > 0.01
    code, out, _ = call(capsys, "compare", place / "tube.run", place / "tube.run", "--json")
    assert all(p["linf"] == 0.0 for p in json.loads(out)["pairs"])


def test_compare_with_measured_data_draws_a_picture(place, capsys):
    data = place / "probe.csv"
    data.write_text("time [ms], contact velocity [m/s]\n50, 0.9\n100, 0.92\n150, 0.93\n")
    code, out, _ = call(capsys, "compare", place / "tube.run", data, "--plot", place / "compare.png")
    assert code == 0 and "contact" in out
    assert (place / "compare.png").read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"


def test_compare_refuses_a_picture_of_an_unknown_kind(place, capsys):
    code, out, err = call(capsys, "compare", place / "tube.run", place / "tube.run", "--plot", place / "compare.doc")
    assert code == 2 and not out and "--plot: cannot draw 'compare.doc'" in err


@pytest.mark.parametrize("arguments, name", [
    (["xt", "pressure"], "xt-pressure.png"), (["gauge", "velocity"], "gauge-velocity.png"), (["profile", "density"], "profile-density.png"),
    (["budget"], "budget.png"), (["setup"], "setup.png"), (["xt", "velocity"], "xt-velocity.png"),
])
def test_plot_draws(arguments, name, place, capsys):
    code, out, _ = call(capsys, "plot", place / "tube.run", *arguments)
    assert code == 0 and name in out
    assert (place / "tube.run" / name).stat().st_size > 5000


@pytest.mark.parametrize("arguments, hint", [
    (["xtt"], "did you mean 'xt'?"), (["budget", "--time", "1 us"], "it applies to profile"), (["profile", "--time", "1 mm"], "expected a time"),
    (["xt", "--out", "wave.gif"], ".png"), (["profile", "--time", "9 s"], "the run has no state at 9 s; its snapshots run from 0 s to"),
    (["free_surface", "--delay", "-1 ns"], "delay: must not be negative"), (["free_surface", "--gauge", "nowhere"], "no gauge 'nowhere'; this run has: contact"),
    (["profile", "--time", "9"], "the run has no state at 9 s"),
    (["xt", "--x", "5..6 m"], "--x: these positions lie outside the run; it covers 0 m to 1 m"),
])
def test_plot_refuses_what_it_cannot_draw(arguments, hint, place, capsys):
    code, _, err = call(capsys, "plot", place / "tube.run", *arguments)
    assert code == 2 and hint in err


def test_report_is_written_again(place, capsys):
    (place / "tube.run" / "report.html").unlink()
    code, out, _ = call(capsys, "report", place / "tube.run")
    assert code == 0 and (place / "tube.run" / "report.html").is_file() and "report.html" in out


def test_a_run_is_never_overwritten_unasked(place, capsys):
    code, _, err = call(capsys, "run", place / "tube.toml", "--out", place / "tube.run", "-q")
    assert code == 4 and "--overwrite" in err


@pytest.mark.parametrize("command", ["info", "report", "resume", "plot"])
def test_a_folder_that_is_no_run_is_a_matter_of_files(command, place, capsys):
    code, _, err = call(capsys, command, place / "nothing.run")
    assert code == 4 and "nothing.run" in err and "Traceback" not in err


def test_a_finished_run_resumes_to_itself(place, capsys):
    before = (place / "tube.run" / "result.h5").read_bytes()
    code, out, _ = call(capsys, "resume", place / "tube.run", "-q")
    assert code == 0 and "done" in out and "was finished already" in out
    assert (place / "tube.run" / "result.h5").read_bytes() == before


def test_physics_that_fails_ends_with_code_three_and_a_post_mortem(place, capsys):
    # a first step a hundred times too long beside a piston at ten thousand times the speed of sound
    deck = catalogue.deck_text("sod").replace('left = "fixed"', "left = {velocity = 1e4}").replace("zones = 100", "zones = 20")
    (place / "wild.toml").write_text(deck + "\n[solver]\ninitial_step = 0.19\n")
    code, _, err = call(capsys, "run", place / "wild.toml", "--out", place / "wild.run", "-q")
    assert code == 3 and "zone" in err and "Traceback" not in err
    assert list((place / "wild.run").glob("post_mortem*"))


