"""Killed without warning, a recorded run goes on from its newest sound checkpoint and ends in the same bytes.

The recorder is driven by the exact acoustic flyer of tests/unit/output, whose state is a few arrays; each kill is a SIGKILL of
another process at a random moment, several in a row on one folder. Damaged checkpoints are made by hand.
"""

import json
import pathlib
import random
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from pace import PATIENCE

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[0] / "unit" / "output"))

import acoustic_flyer  # noqa: E402

from hugoniot.errors import FileTrouble  # noqa: E402
from hugoniot.output.run import load  # noqa: E402
from hugoniot.output.run_folder import RunFolder  # noqa: E402

SIZE = dict(flyer=30, target=60, cycles=300)
CHILD = """
import sys
sys.path.insert(0, sys.argv[1])
import acoustic_flyer
acoustic_flyer.run(sys.argv[2], resume=sys.argv[3] == "resume", checkpoint_every=5, flyer=30, target=60, cycles=300,
                   after_step=lambda flyer: flyer.cycle % 5 or (sys.stdout.write("."), sys.stdout.flush()))
"""


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    folder = tmp_path_factory.mktemp("kill") / "whole"
    acoustic_flyer.run(folder, **SIZE)
    return folder


def same_bytes(a, b):
    return all((a / name).read_bytes() == (b / name).read_bytes() for name in ("result.h5", "gauges.csv", "deck.toml"))


def start(folder, how):
    return subprocess.Popen([sys.executable, "-c", CHILD, acoustic_flyer.__file__.rpartition("/")[0], str(folder), how], stdout=subprocess.PIPE)


def kill_after(process, delay):
    """Kill -9 `delay` seconds after the process has made its first steps; False if it was done before."""
    process.stdout.read(1)
    time.sleep(delay)
    process.send_signal(signal.SIGKILL)
    return process.wait(timeout=PATIENCE) == -signal.SIGKILL


@pytest.mark.skipif(sys.platform == "win32", reason="kill -9 is a Unix matter")
def test_killed_again_and_again_the_run_ends_in_the_same_bytes(whole, tmp_path):
    chance = random.Random(20)
    folder, kills, ended = tmp_path / "run", 0, False
    assert kill_after(start(folder, "new"), 0.05), "the first run was not killed"
    for _ in range(8):
        if ended := not kill_after(start(folder, "resume"), chance.uniform(0.0, 0.12)):
            break
        kills += 1
    assert kills >= 2
    if not (folder / "summary.json").is_file():
        assert start(folder, "resume").wait(timeout=PATIENCE) == 0
        ended = True
    assert same_bytes(whole, folder)
    if ended:       # a kill may also meet a run that has written its summary and is tidying up
        assert not (folder / "pieces").exists() and not (folder / "checkpoint").exists()


class Stop(Exception):
    """Ends a run in the middle, as a crash of the solver would."""


def interrupted(folder, at=120, every=20):
    def crash(flyer):
        if flyer.cycle == at:
            raise Stop

    with pytest.raises(Stop):
        acoustic_flyer.run(folder, checkpoint_every=every, after_step=crash, **SIZE)
    return sorted((folder / "checkpoint").glob("*.h5"))


def truncate(path):
    path.write_bytes(path.read_bytes()[:-100])


def flip(path):
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(data)


def empty(path):
    path.write_bytes(b"")


def test_two_checkpoints_are_kept(tmp_path):
    found = interrupted(tmp_path / "run")
    assert [path.name for path in found] == ["000004.h5", "000005.h5"]
    manifest = json.loads(found[-1].with_suffix(".json").read_text())
    assert manifest["bytes"] == found[-1].stat().st_size and len(manifest["pieces"]) == 6


@pytest.mark.parametrize("damage", [truncate, flip, empty])
@pytest.mark.parametrize("what", ["h5", "json"])
def test_a_damaged_checkpoint_falls_back_to_the_one_before(whole, tmp_path, damage, what):
    newest = interrupted(tmp_path / "run")[-1]
    damage(newest.with_suffix(f".{what}"))
    with RunFolder(tmp_path / "run", resume=True) as recorder:
        payload = recorder.latest_checkpoint()
    assert payload["cycle"] == 100
    assert len(recorder.warnings) == 1 and "checkpoint 000005 is skipped" in recorder.warnings[0]
    assert "is skipped" in (tmp_path / "run" / "run.log").read_text()
    acoustic_flyer.run(tmp_path / "run", resume=True, **SIZE)
    assert same_bytes(whole, tmp_path / "run")


def test_a_damaged_piece_falls_back_too(whole, tmp_path):
    interrupted(tmp_path / "run")
    flip(tmp_path / "run" / "pieces" / "000005.h5")
    recorder = acoustic_flyer.run(tmp_path / "run", resume=True, **SIZE)
    assert "piece" in recorder.warnings[0] and same_bytes(whole, tmp_path / "run")
    assert load(tmp_path / "run").summary["checkpoint_warnings"] == recorder.warnings


def test_with_no_sound_checkpoint_the_run_starts_again_and_says_so(whole, tmp_path):
    for path in interrupted(tmp_path / "run"):
        flip(path)
    recorder = acoustic_flyer.run(tmp_path / "run", resume=True, **SIZE)
    assert "starts from the beginning" in recorder.warnings[-1] and same_bytes(whole, tmp_path / "run")


@pytest.mark.parametrize("every", [20, 1000])
def test_a_changed_deck_is_refused_with_the_difference_and_comes_back(whole, tmp_path, every):
    """Also of a run that was killed before its first checkpoint."""
    interrupted(tmp_path / "run", every=every)
    deck = tmp_path / "run" / "deck.toml"
    before = sorted(path.name for path in (tmp_path / "run").rglob("*"))
    for text, shown in ((acoustic_flyer.DECK.replace("planar", "p1anar"), '-geometry = "planar"\n  +geometry = "p1anar"'),
                        (acoustic_flyer.DECK + "\x1b[31m", "+?[31m")):
        deck.write_text(text)
        with RunFolder(tmp_path / "run", resume=True) as recorder, pytest.raises(FileTrouble, match="not the deck this run was started with") as caught:
            recorder.checked_deck()
        assert shown in str(caught.value) and caught.value.exit_code == 4
    for damage in (lambda: deck.write_bytes(b"\xff\xfe"), deck.unlink):
        damage()
        with RunFolder(tmp_path / "run", resume=True) as recorder:
            with pytest.raises(FileTrouble, match="--restore-deck"):
                recorder.checked_deck()
            assert recorder.checked_deck(restore=True) == acoustic_flyer.DECK
    assert sorted(path.name for path in (tmp_path / "run").rglob("*")) == before
    acoustic_flyer.run(tmp_path / "run", resume=True, **SIZE)
    assert same_bytes(whole, tmp_path / "run")


def test_a_checkpoint_restores_every_bit(tmp_path):
    interrupted(tmp_path / "run")
    with RunFolder(tmp_path / "run", resume=True) as recorder:
        payload = recorder.latest_checkpoint()
    flyer = acoustic_flyer.AcousticFlyer(30, 60)
    while flyer.cycle < 120:
        flyer.step()
    for name, value in flyer.payload()["arrays"].items():
        assert np.array_equal(payload["arrays"][name], value), name
    assert payload["time"] == flyer.time
