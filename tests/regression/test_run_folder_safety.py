"""What stands in a run folder is neither lost nor changed unnoticed: two processes, links, foreign files, leftovers, checksums."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import acoustic_flyer
import h5py
import numpy as np
import pytest
from pace import PATIENCE

from hugoniot import simulate
from hugoniot.cli.main import main
from hugoniot.errors import FileTrouble, UnphysicalState
from hugoniot.output.atomic import digest
from hugoniot.output.lock import Lock
from hugoniot.output.run import load, read_post_mortem
from hugoniot.output.run_folder import RunFolder
from hugoniot.output.seal import sealed_json
from hugoniot.output.verify import verify
from hugoniot.problem import catalogue

SMALL = dict(flyer=20, target=40, cycles=160)
unix = pytest.mark.skipif(sys.platform == "win32", reason="links and signals are a Unix matter")


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    folder = tmp_path_factory.mktemp("safe") / "whole"
    acoustic_flyer.run(folder, **SMALL)
    return folder


@pytest.fixture(scope="module")
def tube(tmp_path_factory):
    """A deck and its finished run, with a report."""
    folder = tmp_path_factory.mktemp("tube")
    (folder / "tube.toml").write_text(catalogue.deck_text("sod").replace("zones = 100", "zones = 20"))
    simulate.run(folder / "tube.toml", folder / "tube.run")
    return folder


def command(capsys, *arguments):
    with pytest.raises(SystemExit) as ended:
        main([str(a) for a in arguments])
    out, err = capsys.readouterr()
    return ended.value.code or 0, out, err


def flip(path, place=0.5):
    data = bytearray(path.read_bytes())
    data[int(place * (len(data) - 1))] ^= 4
    path.write_bytes(data)


# -- checksums --------------------------------------------------------------------------------------------------------
def test_every_file_of_a_finished_run_is_found_sound_and_each_change_is_found(tube, tmp_path, capsys):
    folder = shutil.copytree(tube / "tube.run", tmp_path / "run")
    code, out, _ = command(capsys, "info", folder, "--verify")
    assert code == 0 and out.count("sound") == 6
    names = sorted(path.name for path in folder.iterdir())
    assert names == ["deck.toml", "gauges.csv", "report.html", "result.h5", "run.log", "summary.json"]
    for name in names:
        data = (folder / name).read_bytes()
        for place in (0.0, 0.3, 0.77, 1.0):
            flip(folder / name, place)
            assert [f.file for f in verify(folder) if f.bad] == [name], place
        (folder / name).write_bytes(data)
    (folder / "gauges.csv").unlink()
    code, out, _ = command(capsys, "info", folder, "--verify", "--json")
    told = json.loads(out)
    assert code == 4 and not told["sound"] and [f["state"] for f in told["files"]].count("missing") == 1


def test_a_damaged_column_is_refused_and_the_others_can_be_had_on_demand(whole, tmp_path, capsys):
    folder = shutil.copytree(whole, tmp_path / "run")
    density = load(whole).arrays("snapshots")["density"]
    data = bytearray((folder / "result.h5").read_bytes())
    place = data.find(density[3].tobytes())
    assert place > 0
    data[place + 5] ^= 1
    (folder / "result.h5").write_bytes(data)
    with pytest.raises(FileTrouble, match="changed since the run ended"):
        load(folder).arrays("snapshots")
    code, out, _ = command(capsys, "info", folder, "--verify")
    assert code == 4 and "changed" in out and "columns can be read with hugoniot.load(folder, partial=True), not snapshots/density" in out
    rest = load(folder, partial=True)
    assert np.array_equal(rest.arrays("snapshots")["stress"], load(whole).arrays("snapshots")["stress"])
    with pytest.raises(FileTrouble, match="snapshots/density: damaged"):
        rest.arrays("snapshots")["density"]
    (folder / "summary.json").write_bytes(b"\xff" + (folder / "summary.json").read_bytes())
    assert load(folder, partial=True).summary["status"] == "damaged"


def test_a_result_that_is_replaced_while_it_is_open_is_noticed(whole, tmp_path):
    folder = shutil.copytree(whole, tmp_path / "run")
    run = load(folder)
    assert len(run.arrays("peaks")["zone"]) == 60
    flip(folder / "result.h5")
    with pytest.raises(FileTrouble, match="changed since the run ended"):
        run.arrays("budget")["time"]


def test_an_early_run_without_checksums_is_read_and_said_to_have_none(whole, tmp_path):
    folder = shutil.copytree(whole, tmp_path / "run")
    summary = json.loads((folder / "summary.json").read_text())
    for key in ("sha256", "run_log_bytes", "sha256_of_this_text"):
        del summary[key]
    (folder / "summary.json").write_text(json.dumps(summary))
    assert load(folder).summary["cycles"] == 160 and len(load(folder).arrays("gauges")["time"]) == 160
    assert [f.state for f in verify(folder)] == ["no checksum"]


FORGED = {"a title that is a list": lambda s: s | {"title": [1]}, "no time": lambda s: {k: v for k, v in s.items() if k != "time"},
          "a time in words": lambda s: s | {"time": "\x1b[31m"}, "nothing": lambda s: {}, "a list of checksums": lambda s: s | {"sha256": [1]},
          "a file elsewhere": lambda s: s | {"sha256": {"../../deck.toml": "0" * 64}}, "a length in words": lambda s: s | {"run_log_bytes": "a"}}


@pytest.mark.parametrize("name", FORGED)
def test_a_summary_of_another_program_is_refused_in_words(whole, tmp_path, capsys, name):
    """Its own checksum is right: whoever made it made that too."""
    folder = shutil.copytree(whole, tmp_path / "run")
    (folder / "summary.json").write_text(sealed_json(FORGED[name](load(whole).summary)))
    told = [command(capsys, "info", folder, *more) for more in ((), ("--verify",))]
    assert 4 in {code for code, _, _ in told} and {code for code, _, _ in told} <= {0, 4}
    assert not any("unexpected" in err or "\x1b" in err for _, _, err in told)


@pytest.mark.parametrize("lost", ["gauges", "setup/document", "snapshots"])
def test_a_result_of_another_program_is_refused_in_words(whole, tmp_path, capsys, lost):
    folder = shutil.copytree(whole, tmp_path / "run")
    with h5py.File(folder / "result.h5", "a") as file:
        del file[lost]
    summary = load(whole).summary
    summary["sha256"]["result.h5"] = digest(folder / "result.h5").sha256
    (folder / "summary.json").write_text(sealed_json(summary))
    code, _, err = command(capsys, "info", folder)
    assert code == 4 and "unexpected" not in err and ("not written by hugoniot" in err or "damaged" in err)


def test_an_unfinished_run_is_verified_too(tmp_path):
    def stop(flyer):
        if flyer.cycle == 100:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        acoustic_flyer.run(tmp_path / "run", checkpoint_every=30, after_step=stop, **SMALL)
    found = verify(tmp_path / "run")
    assert [f.file for f in found] == ["deck.toml", "checkpoint/start.json", "checkpoint/000001", "checkpoint/000002", "pieces/000000.h5",
                                       "pieces/000001.h5", "pieces/000002.h5"]
    assert not any(f.bad for f in found)
    flip(tmp_path / "run" / "pieces" / "000001.h5")
    flip(tmp_path / "run" / "checkpoint" / "000002.json")
    assert [f.file for f in verify(tmp_path / "run") if f.bad] == ["checkpoint/000002", "pieces/000001.h5"]
    with pytest.raises(FileTrouble, match="not a run folder"):
        verify(tmp_path)


def test_a_damaged_post_mortem_is_noticed(tmp_path):
    flyer = acoustic_flyer.AcousticFlyer(20, 40)
    with RunFolder(tmp_path / "run") as recorder:
        recorder.start(flyer.problem, acoustic_flyer.DECK, flyer.meta())
        recorder.post_mortem(UnphysicalState("the density is negative", zone=3), flyer.payload())
    assert not any(f.bad for f in verify(tmp_path / "run"))
    for name in ("post_mortem.h5", "post_mortem.txt"):
        data = (tmp_path / "run" / name).read_bytes()
        flip(tmp_path / "run" / name)
        with pytest.raises(FileTrouble, match="changed since it was written"):
            read_post_mortem(tmp_path / "run")
        assert any(f.bad for f in verify(tmp_path / "run"))
        (tmp_path / "run" / name).write_bytes(data)


# -- two processes ----------------------------------------------------------------------------------------------------
HOLDER = """
import sys, time
from hugoniot.output.run_folder import RunFolder
with RunFolder(sys.argv[1], resume=True):
    print("held", flush=True)
    time.sleep(60)
"""


@unix
@pytest.mark.parametrize("words", [("run", "tube.toml", "--out", "busy", "--overwrite"), ("resume", "busy")])
def test_the_second_process_on_a_folder_ends_with_code_four_and_a_killed_one_holds_nothing(tube, tmp_path, capsys, monkeypatch, words):
    monkeypatch.chdir(tmp_path)
    shutil.copy(tube / "tube.toml", "tube.toml")
    shutil.copytree(tube / "tube.run", "busy")
    before = {path.name: path.read_bytes() for path in pathlib.Path("busy").iterdir()}
    holder = subprocess.Popen([sys.executable, "-c", HOLDER, "busy"], stdout=subprocess.PIPE)
    try:
        assert holder.stdout.readline().strip() == b"held"
        code, _, err = command(capsys, *words, "-q")
        assert code == 4 and f"in use by another process (process {holder.pid} on" in err
        assert {path.name: path.read_bytes() for path in pathlib.Path("busy").iterdir() if path.name != ".lock"} == before
    finally:
        holder.send_signal(signal.SIGKILL)
        holder.wait()
    assert os.path.exists("busy/.lock")     # what a kill leaves says nothing
    code, _, err = command(capsys, *words, "-q")
    assert code == 0, err
    assert not os.path.exists("busy/.lock")


@unix
def test_of_many_that_want_a_folder_one_at_a_time_has_it(tmp_path):
    """Takers and givers in eight processes: a counter in a plain file, raised under the lock, misses nobody."""
    (tmp_path / "count").write_text("0")
    code = ("import sys, pathlib, time\nfrom hugoniot.errors import FileTrouble\nfrom hugoniot.output.lock import Lock\n"
            "folder, done = pathlib.Path(sys.argv[1]), 0\n"
            "while done < 40:\n"
            "    try: lock = Lock(folder)\n"
            "    except FileTrouble: time.sleep(0.0005); continue\n"
            "    number = int((folder / 'count').read_text()); (folder / 'count').write_text(str(number + 1))\n"
            "    lock.release(); done += 1\n")
    processes = [subprocess.Popen([sys.executable, "-c", code, str(tmp_path)]) for _ in range(4)]
    assert [process.wait(timeout=PATIENCE) for process in processes] == [0] * 4
    assert (tmp_path / "count").read_text() == "160" and not (tmp_path / ".lock").exists()


def test_a_lock_is_given_back_however_a_run_ends(tmp_path):
    with pytest.raises(ZeroDivisionError), RunFolder(tmp_path / "a"):
        raise ZeroDivisionError
    Lock(tmp_path / "a").release()


# -- links and foreign files ------------------------------------------------------------------------------------------
@unix
@pytest.mark.parametrize("names", [[".deck.toml.part", ".run.log.part", ".result.h5.part", ".gauges.csv.part", ".summary.json.part", ".report.html.part"],
                                   ["deck.toml"]])
def test_a_planted_link_is_never_written_through(tube, tmp_path, names):
    folder = tmp_path / "run"
    folder.mkdir()
    for name in names:
        (tmp_path / f"victim of {name}").write_text("precious")
        (folder / name).symlink_to(tmp_path / f"victim of {name}")
    if names == ["deck.toml"]:
        with pytest.raises(FileTrouble, match="holds deck.toml already"):
            simulate.run(tube / "tube.toml", folder)
    else:
        simulate.run(tube / "tube.toml", folder)
        assert not any(f.bad for f in verify(folder)) and not any(path.is_symlink() for path in folder.iterdir())
    assert [(tmp_path / f"victim of {name}").read_text() for name in names] == ["precious"] * len(names)


@unix
@pytest.mark.parametrize("name", ["pieces", "checkpoint"])
def test_what_lies_behind_a_linked_folder_is_left_alone(tube, tmp_path, name):
    behind = tmp_path / "behind"
    behind.mkdir()
    for file in ("notes.txt", "000000.h5", "000000.json"):
        (behind / file).write_text("precious")
    folder = shutil.copytree(tube / "tube.run", tmp_path / "run")
    (folder / name).symlink_to(behind)
    for call in (lambda: simulate.run(tube / "tube.toml", folder, overwrite=True), lambda: simulate.resume(folder)):
        with pytest.raises(FileTrouble, match=f"{name}: this is a link"):
            call()
    assert [(behind / file).read_text() for file in sorted(os.listdir(behind))] == ["precious"] * 3


@unix
@pytest.mark.parametrize("make", [lambda path, victim: path.symlink_to(victim), lambda path, victim: os.mkfifo(path)])
@pytest.mark.parametrize("name", ["run.log", ".lock"])
def test_log_and_lock_are_plain_files_or_the_run_is_refused(tmp_path, make, name):
    victim = tmp_path / "victim"
    victim.write_text("precious")
    with pytest.raises(KeyboardInterrupt):
        acoustic_flyer.run(tmp_path / "run", checkpoint_every=40, after_step=lambda flyer: interrupt(flyer, 100), **SMALL)
    (tmp_path / "run" / name).unlink(missing_ok=True)
    make(tmp_path / "run" / name, victim)
    with pytest.raises(FileTrouble, match=f"{name}: (this is a link|not a regular file|No such device)"):
        acoustic_flyer.run(tmp_path / "run", resume=True, **SMALL)
    assert victim.read_text() == "precious"


def interrupt(flyer, cycle):
    if flyer.cycle == cycle:
        raise KeyboardInterrupt


def test_only_what_a_run_wrote_is_removed(whole, tmp_path):
    folder = shutil.copytree(whole, tmp_path / "run")
    for name in ("pieces", "checkpoint"):
        (folder / name).mkdir()
        (folder / name / "mine.txt").write_text("precious")
        (folder / name / "000007.h5").write_text("left by a killed run")
    acoustic_flyer.run(folder, overwrite=True, **SMALL)
    assert sorted(str(path.relative_to(folder)) for path in folder.rglob("*/*")) == ["checkpoint/mine.txt", "pieces/mine.txt"]


@pytest.mark.parametrize("edit", ["somebody's own deck\n", "# edited\n"])
def test_a_deck_that_is_not_the_runs_own_is_not_replaced(whole, tmp_path, edit):
    folder = shutil.copytree(whole, tmp_path / "run")
    deck = folder / "deck.toml"
    deck.write_text(edit if "own" in edit else deck.read_text() + edit)
    before = deck.read_text()
    with pytest.raises(FileTrouble, match="not the deck of the run in this folder"):
        RunFolder(folder, overwrite=True)
    assert deck.read_text() == before and (folder / "result.h5").exists()


def test_a_log_of_another_program_makes_no_run_folder(tmp_path):
    (tmp_path / "deck.toml").write_text("precious")
    (tmp_path / "run.log").write_text("Solver started, all is well\n")
    with pytest.raises(FileTrouble, match="contains run.log, but no run.log written by hugoniot"):
        RunFolder(tmp_path, overwrite=True)


# -- the end of a run -------------------------------------------------------------------------------------------------
def test_resuming_a_finished_run_writes_what_is_missing_and_tidies_up(tube, tmp_path, capsys):
    folder = shutil.copytree(tube / "tube.run", tmp_path / "run")
    written = {name: (folder / name).read_bytes() for name in ("deck.toml", "gauges.csv")}
    for name in ("deck.toml", "gauges.csv", "report.html"):
        (folder / name).unlink()
    for name in ("pieces/000000.h5", "checkpoint/000003.json", "checkpoint/start.json", ".report.html.part"):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text("left over")
    code, out, err = command(capsys, "resume", folder, "-q")
    assert code == 0, err
    assert {name: (folder / name).read_bytes() for name in written} == written
    assert sorted(path.name for path in folder.iterdir()) == ["deck.toml", "gauges.csv", "report.html", "result.h5", "run.log", "summary.json"]
    assert not any(f.bad for f in verify(folder))


@pytest.mark.parametrize("name", ["gauges.csv", "deck.toml", "report.html"])
def test_resuming_a_finished_run_tells_of_a_changed_file(tube, tmp_path, capsys, name):
    folder = shutil.copytree(tube / "tube.run", tmp_path / "run")
    flip(folder / name)
    before = (folder / name).read_bytes()
    code, _, err = command(capsys, "resume", folder, "-q")
    assert code == 0 and f"changed since the run ended, and left as it is: {name};" in err and (folder / name).read_bytes() == before


def test_a_damaged_finished_run_is_not_completed_from_damage(tube, tmp_path):
    folder = shutil.copytree(tube / "tube.run", tmp_path / "run")
    (folder / "gauges.csv").unlink()
    flip(folder / "result.h5")
    with pytest.raises(FileTrouble, match="changed since the run ended"):
        simulate.resume(folder)
    assert not (folder / "gauges.csv").exists()


@unix
def test_a_resume_of_a_damaged_deck_ends_with_code_four_and_shows_the_line(tube, tmp_path, capsys):
    """The reproduction of a user's loss: another viscosity in deck.toml ran to the end as if nothing had happened."""
    folder = tmp_path / "run"
    deck = tmp_path / "tube.toml"
    deck.write_text((tube / "tube.toml").read_text() + "\n[solver.viscosity]\nlaw = \"limited\"\nquadratic = 0.6\n")

    class Stop:
        def update(self, report):
            if (folder / "checkpoint" / "000001.json").exists():
                raise KeyboardInterrupt

    settings = {"output.checkpoint_cycles": 5}
    with pytest.raises(KeyboardInterrupt):
        simulate.run(deck, folder, progress=Stop(), **settings)
    good = (folder / "deck.toml").read_text()
    (folder / "deck.toml").write_text(good.replace("quadratic = 0.6", "quadratic = 2.6"))
    code, _, err = command(capsys, "resume", folder, "-q")
    assert code == 4 and "-quadratic = 0.6" in err and "+quadratic = 2.6" in err
    assert not (folder / "summary.json").exists() and (folder / "checkpoint" / "000001.json").exists()
    code, _, err = command(capsys, "resume", folder, "-q", "--restore-deck")
    assert code == 0 and (folder / "deck.toml").read_text() == good
    simulate.run(deck, tmp_path / "whole", **settings)
    assert (folder / "result.h5").read_bytes() == (tmp_path / "whole" / "result.h5").read_bytes()


@unix
def test_a_request_to_end_outside_the_loop_is_an_interrupt_too():
    """SIGTERM is answered like Ctrl-C while a run is on, and by the system's default again afterwards."""
    from hugoniot.signals import end_like_interrupt

    with pytest.raises(KeyboardInterrupt), end_like_interrupt():
        os.kill(os.getpid(), signal.SIGTERM)
        time.sleep(5)
    assert signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
