"""The recorder: what is recorded comes back, the same bytes however often the run was set down, and clear words when it cannot."""

import errno
import json
import os
import pathlib

import acoustic_flyer
import h5py
import numpy as np
import pytest

from hugoniot.errors import FileTrouble, UnphysicalState
from hugoniot.output import atomic, hdf5
from hugoniot.output.run import load, read_post_mortem
from hugoniot.output.run_folder import RunFolder

SMALL = dict(flyer=20, target=40, cycles=160)


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    folder = tmp_path_factory.mktemp("run") / "whole"
    acoustic_flyer.run(folder, **SMALL)
    return folder


def same_bytes(a, b):
    return all((a / name).read_bytes() == (b / name).read_bytes() for name in ("result.h5", "gauges.csv", "deck.toml"))


def test_recorded_values_come_back_exactly(whole):
    run = load(whole)
    flyer = acoustic_flyer.AcousticFlyer(20, 40)
    rows, velocity = [], []
    for _ in range(SMALL["cycles"]):
        flyer.step()
        velocity.append(flyer.face_right[-1])
        if flyer.cycle % 8 == 0:
            rows.append(flyer.fields()["density"])
    assert np.array_equal(run.arrays("snapshots")["density"], rows)
    assert np.array_equal(run.gauge("velocity", "free surface")[1], velocity)
    assert np.array_equal(run.arrays("peaks")["stress"], flyer.peak)


def test_bytes_do_not_depend_on_how_often_the_run_was_set_down(whole, tmp_path):
    for every in (1, 7, 64):
        acoustic_flyer.run(tmp_path / str(every), checkpoint_every=every, **SMALL)
        assert same_bytes(whole, tmp_path / str(every)), every
        assert not (tmp_path / str(every) / "pieces").exists() and not (tmp_path / str(every) / "checkpoint").exists()


def test_rows_beyond_the_memory_limit_are_set_down_without_a_trace(whole, tmp_path, monkeypatch):
    monkeypatch.setattr("hugoniot.output.series.SPILL_BYTES", 20_000)
    pieces = []
    acoustic_flyer.run(tmp_path / "a", after_step=lambda f: pieces.append(len(list((tmp_path / "a").glob("pieces/*.h5")))), **SMALL)
    assert max(pieces) >= 3
    assert same_bytes(whole, tmp_path / "a")


def test_result_describes_itself_to_h5py(whole):
    with h5py.File(whole / "result.h5") as file:
        assert file.attrs["solver"] == "acoustic"
        assert {name for name in file} == {"snapshots", "gauges", "budget", "peaks", "events", "setup"}
        stress = file["snapshots/stress"]
        assert stress.attrs["units"] == "Pa" and "longitudinal stress" in stress.attrs["long_name"]
        assert [dim[0].name for dim in stress.dims] == ["/snapshots/time", "/snapshots/zone"]
        assert file["budget/kinetic_energy"].attrs["units"] == "J/m^2"
        for group in ("snapshots", "gauges", "budget", "peaks"):
            for name, data in file[group].items():
                assert data.dtype.kind in "iO" or data.attrs.get("units") or name == "energy_error", (group, name)


def test_result_opens_with_xarray_alone(whole):
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("h5netcdf")
    for group in ("snapshots", "gauges", "budget", "peaks"):
        with xarray.open_dataset(whole / "result.h5", group=group) as there:
            ours = load(whole).dataset(group)
            for name in ours.data_vars:
                assert there[name].dims == ours[name].dims
                assert np.array_equal(there[name].values, ours[name].values), (group, name)


def test_datasets_carry_units_and_names(whole):
    run = load(whole)
    assert run.gauges["velocity"].sel(gauge="free surface").attrs["units"] == "m/s"
    assert run.snapshots["stress"].dims == ("time", "zone") and set(run.snapshots.coords) >= {"region", "centre", "mass", "cycle"}
    assert list(run.events["kind"].values)[0] == "void_opened"
    assert json.loads(run.events["numbers"].values[0])["position"] > 0


def test_large_columns_of_a_dataset_stay_in_the_file(whole, monkeypatch):
    from hugoniot.output import result_columns

    kept = load(whole).snapshots
    monkeypatch.setattr(result_columns, "KEPT", 100)
    selections, read = [], result_columns.Columns._read

    def watched(columns, name, part=()):
        selections.append((name, part))
        return read(columns, name, part)

    monkeypatch.setattr(result_columns.Columns, "_read", watched)
    again = load(whole).snapshots
    assert {name for name, _ in selections} <= {"cycle", "time", "zone", "region"} | {n for n in kept.variables if kept[n].ndim < 2}
    assert "stress" in repr(again) and not [name for name, _ in selections if name == "stress"]
    for k in (0, -1, slice(1, None), slice(None, None, -1), [2, 0, 2]):
        assert np.array_equal(again["stress"].isel(time=k).values, kept["stress"].isel(time=k).values), k
    asked = [part for name, part in selections if name == "stress"]
    assert asked[0][0] == 0 and len(asked) == 5         # of the first selection one record is read
    assert np.array_equal((again["stress"] - again["pressure"]).values, (kept["stress"] - kept["pressure"]).values)
    changed = again["stress"].copy()
    changed[0, 0] = 1.0
    assert changed[0, 0] == 1.0 and again["stress"][0, 0] == kept["stress"][0, 0]


def test_a_group_that_is_not_there_is_told_with_those_that_are(whole):
    with pytest.raises(KeyError, match="no group 'gauge' in a run; it has: budget, events, gauges, peaks, snapshots"):
        load(whole).arrays("gauge")


def test_gauges_csv_holds_the_gauges(whole):
    lines = (whole / "gauges.csv").read_text().splitlines()
    assert lines[0] == "time [s],middle velocity [m/s],middle stress [Pa],free surface velocity [m/s],free surface stress [Pa]"
    rows = load(whole).arrays("gauges")
    table = np.array([[float(x) for x in line.split(",")] for line in lines[1:]])
    assert np.allclose(table[:, 3], rows["velocity"][:, 1], rtol=1e-9) and len(table) == SMALL["cycles"]


def test_summary_holds_what_is_promised(whole):
    summary = json.loads((whole / "summary.json").read_text())
    assert set(summary) >= {"title", "solver", "status", "cycles", "zone_updates", "time", "wall_seconds", "kernel_seconds", "mass_error",
                            "momentum_error", "energy_error", "voids_opened", "voids_closed", "version", "deck_sha256"}
    import hashlib
    assert summary["deck_sha256"] == hashlib.sha256((whole / "deck.toml").read_bytes()).hexdigest()


def test_setup_names_every_constant_with_its_source(whole):
    law = load(whole).setup["materials"]["al"]["laws"][0]
    gamma = next(c for c in law["constants"] if c["name"] == "gamma")
    assert (gamma["value"], gamma["unit"], gamma["source"], gamma["status"]) == (1.4, "1", "A table of the tests", "recalled")
    assert "d'Alembert 1747" in load(whole).setup["references"] and law["references"][0] in load(whole).setup["references"]


def test_the_method_is_cited_only_where_it_was_used():
    from hugoniot.output.setup_record import setup_record

    flyer = acoustic_flyer.AcousticFlyer(20, 40)
    assert "J. Comput. Phys. 146" in setup_record(flyer.problem, {**flyer.meta(), "solver": "lagrange1d"})["references"][0]
    assert not any("J. Comput. Phys. 146" in reference for reference in setup_record(flyer.problem, flyer.meta())["references"])


# -- refusals ---------------------------------------------------------------------------------------------------------
def test_a_run_is_not_overwritten_unasked(whole, tmp_path):
    before = (whole / "result.h5").read_bytes()
    with pytest.raises(FileTrouble, match="holds summary.json already.*--out"):
        RunFolder(whole)
    assert (whole / "result.h5").read_bytes() == before
    acoustic_flyer.run(tmp_path / "a", **SMALL)
    (tmp_path / "a" / "notes.txt").write_text("mine")
    acoustic_flyer.run(tmp_path / "a", overwrite=True, **SMALL)
    assert (tmp_path / "a" / "notes.txt").read_text() == "mine" and same_bytes(whole, tmp_path / "a")


def test_the_folder_of_somebodys_deck_is_never_taken(tmp_path):
    (tmp_path / "deck.toml").write_text("precious")
    with pytest.raises(FileTrouble, match="not recognised as a run folder"):
        RunFolder(tmp_path, overwrite=True)
    assert (tmp_path / "deck.toml").read_text() == "precious"


def test_a_file_in_the_way_is_named(tmp_path):
    (tmp_path / "taken").write_text("")
    with pytest.raises(FileTrouble, match="taken: a file or folder of that name is in the way"):
        RunFolder(tmp_path / "taken")
    with pytest.raises(FileTrouble, match="in the way"):
        RunFolder(tmp_path / "taken" / "below")


def test_an_unwritable_folder_is_named(tmp_path, monkeypatch):
    def refuse(*args, **kwargs):
        raise PermissionError(errno.EACCES, "Permission denied")

    monkeypatch.setattr(pathlib.Path, "mkdir", refuse)
    with pytest.raises(FileTrouble, match="no permission.*--out") as caught:
        RunFolder(tmp_path / "a")
    assert caught.value.exit_code == 4


def test_loading_what_is_not_a_finished_run_says_what_it_is(tmp_path):
    with pytest.raises(FileTrouble, match="no such run folder"):
        load(tmp_path / "nowhere")
    with pytest.raises(FileTrouble, match="not a run folder"):
        load(tmp_path)
    (tmp_path / "checkpoint").mkdir()
    with pytest.raises(FileTrouble, match="unfinished; continue with `hugoniot resume"):
        load(tmp_path)


def test_a_result_that_may_not_be_read_is_named(whole, monkeypatch):
    def refuse(*_, **__):
        raise PermissionError(errno.EACCES, "Permission denied")

    with monkeypatch.context() as forbidden:
        forbidden.setattr("os.open", refuse)
        with pytest.raises(FileTrouble, match=r"summary\.json: no permission to read it$"):
            _ = load(whole).summary
    monkeypatch.setattr("h5py.File", refuse)
    with pytest.raises(FileTrouble, match=r"result\.h5: no permission to read it$"):
        load(whole).arrays("gauges")


def test_a_damaged_result_is_not_read(whole, tmp_path):
    for name in ("result.h5", "summary.json"):
        (tmp_path / name).write_bytes((whole / name).read_bytes())
    data = bytearray((whole / "result.h5").read_bytes())
    data[len(data) // 2] ^= 1
    for damaged in (bytes(data), bytes(data[:100])):
        (tmp_path / "result.h5").write_bytes(damaged)
        with pytest.raises(FileTrouble, match="result.h5: changed since the run ended .*SHA-256.*info .* --verify"):
            load(tmp_path).arrays("gauges")
    (tmp_path / "summary.json").write_text("{")
    with pytest.raises(FileTrouble, match="summary.json: changed since it was written"):
        assert load(tmp_path).summary


def test_a_summary_with_another_number_is_not_believed(whole, tmp_path):
    for name in ("result.h5", "summary.json"):
        (tmp_path / name).write_bytes((whole / name).read_bytes())
    text = (tmp_path / "summary.json").read_text()
    for old, new in (('"cycles": 160', '"cycles": 161'), ('"sha256_of_this_text"', '"sha256_of_this_test"'), ("\n  ", "\n\t ")):
        assert old in text
        (tmp_path / "summary.json").write_text(text.replace(old, new, 1))
        with pytest.raises(FileTrouble, match="summary.json: changed since it was written"):
            assert load(tmp_path).summary


# -- a disk that fills up -----------------------------------------------------------------------------------------------
class FullDisk:
    """Lets `room` bytes through, then refuses; `atomic.put` is the one door to the disk."""

    def __init__(self, monkeypatch, room):
        self.room, self.real = room, atomic.put
        monkeypatch.setattr(atomic, "put", self)

    def __call__(self, handle, data):
        if self.room <= 0:
            raise OSError(errno.ENOSPC, "No space left on device")
        taken = self.real(handle, memoryview(data)[: self.room])
        self.room -= taken
        return taken


@pytest.mark.parametrize("fraction", [0.1, 0.35, 0.6, 0.8, 0.95, 0.9999])
@pytest.mark.parametrize("in_memory", [hdf5.IN_MEMORY, 0])
def test_a_full_disk_loses_nothing_and_resume_finishes(whole, tmp_path, monkeypatch, fraction, in_memory):
    monkeypatch.setattr(hdf5, "IN_MEMORY", in_memory)
    with monkeypatch.context() as patched:
        disk = FullDisk(patched, 10**12)
        acoustic_flyer.run(tmp_path / "roomy", checkpoint_every=40, **SMALL)
        disk.room = int(fraction * (10**12 - disk.room))
        with pytest.raises(FileTrouble, match="the disk is full; nothing that was there before is lost"):
            acoustic_flyer.run(tmp_path / "a", checkpoint_every=40, **SMALL)
    assert not list((tmp_path / "a").rglob("*.part"))
    acoustic_flyer.run(tmp_path / "a", resume=True, checkpoint_every=40, **SMALL)
    assert same_bytes(whole if in_memory else tmp_path / "roomy", tmp_path / "a")


def test_a_size_limit_of_the_process_is_explained(tmp_path):
    """A real refusal by the operating system: RLIMIT_FSIZE makes write fail with EFBIG."""
    resource = pytest.importorskip("resource")
    import signal

    old, handler = resource.getrlimit(resource.RLIMIT_FSIZE), signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    (tmp_path / "x").write_bytes(b"old")
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, old[1]))
    try:
        with pytest.raises(FileTrouble, match="size limit"):
            atomic.write_whole(tmp_path / "x", b"new" * 4096)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, old)
        signal.signal(signal.SIGXFSZ, handler)
    assert (tmp_path / "x").read_bytes() == b"old" and os.listdir(tmp_path) == ["x"]


def test_a_disk_that_returns_other_bytes_is_noticed(tmp_path, monkeypatch):
    monkeypatch.setattr(atomic, "put", lambda handle, data: os.write(handle, bytes(data[:-1]) + b"?"))
    (tmp_path / "x").write_bytes(b"old")
    with pytest.raises(FileTrouble, match="could not be read back"):
        atomic.write_whole(tmp_path / "x", b"new")
    assert (tmp_path / "x").read_bytes() == b"old"


def test_post_mortem_keeps_the_state_and_the_words(tmp_path):
    recorder = RunFolder(tmp_path / "a")
    flyer = acoustic_flyer.AcousticFlyer(20, 40)
    recorder.start(flyer.problem, acoustic_flyer.DECK, flyer.meta())
    error = UnphysicalState("the density is negative", "smaller steps", zone=3, region="flyer", time=1e-6, cycle=7, values={"density": -1.0})
    path = recorder.post_mortem(error, flyer.payload())
    assert "zone 3 of region 'flyer'" in path.read_text() and "density = -1.0" in path.read_text()
    assert np.array_equal(read_post_mortem(tmp_path / "a")["arrays"]["u"], flyer.u)
    with pytest.raises(FileTrouble, match="post_mortem.txt"):
        load(tmp_path / "a")
