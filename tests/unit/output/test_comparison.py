"""Runs against runs and against tables of data."""

import acoustic_flyer
import numpy as np
import pytest
from typer.testing import CliRunner

from hugoniot.cli.main import build_app
from hugoniot.errors import DeckError, FileTrouble
from hugoniot.output.compare import compare, read_table
from hugoniot.output.run import load
from hugoniot.units import format_si


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    base = tmp_path_factory.mktemp("runs")
    for name, width in (("a", 1e-5), ("b", 1.02e-5)):
        acoustic_flyer.run(base / name, flyer=20, target=40, cycles=160, width=width)
    return load(base / "a"), load(base / "b")


def test_a_run_equals_itself(runs):
    found = compare(runs[0], runs[0].folder)
    assert {(p.a.gauge, p.a.field) for p in found.pairs} == {(g, f) for g in ("middle", "free surface") for f in ("stress", "velocity")}
    assert all(row["linf"] == 0.0 for row in found.rows()) and not found.unmatched


def test_a_thicker_target_arrives_later_by_the_travel_time(runs):
    row = next(r for r in compare(*runs).rows() if (r["gauge"], r["field"]) == ("free surface", "velocity"))
    step = 1e-5 / acoustic_flyer.C
    assert row["time_shift"] == pytest.approx(0.02 * 40 * step, abs=0.6 * step)


def test_data_in_laboratory_units_are_compared_in_si(runs, tmp_path):
    time, velocity = runs[0].gauge("velocity", "free surface")
    lines = ["# a comment", "time [us], velocity [km/s]"] + [f"{t * 1e6!r},{(u + 10) / 1e3!r}" for t, u in zip(time.tolist(), velocity.tolist())]
    (tmp_path / "visar.csv").write_text("\n".join(lines))
    pair = compare(runs[0], tmp_path / "visar.csv").pairs[0]
    assert pair.a.gauge == "free surface"
    assert pair.norms.l1 == pytest.approx(10, rel=1e-9) and pair.norms.linf == pytest.approx(10, rel=1e-9)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_data_of_the_other_sign_are_noted(runs, tmp_path, sign):
    """An interferometer to the left of a surface counts its velocity towards itself, a gauge to the right."""
    time, velocity = runs[0].gauge("velocity", "free surface")
    lines = ["time [s], velocity [m/s]"] + [f"{t!r},{sign * 0.9 * u!r}" for t, u in zip(time.tolist(), velocity.tolist())]
    (tmp_path / "visar.csv").write_text("\n".join(lines))
    found = compare(runs[0], tmp_path / "visar.csv")
    assert any("change the sign" in note for note in found.notes) == (sign < 0.0)


def test_heads_may_name_a_gauge(runs, tmp_path):
    time, stress = runs[0].gauge("stress", "middle")
    (tmp_path / "d.csv").write_text("time [ns],middle stress [kbar],middle colour [1]\n" + "\n".join(
        f"{t * 1e9!r},{s / 1e8!r},0" for t, s in zip(time.tolist(), stress.tolist())))
    found = compare(runs[0], tmp_path / "d.csv")
    assert found.unmatched == ("middle colour",) or "colour" in found.unmatched[0]
    assert found.pairs[0].a.gauge == "middle" and found.pairs[0].norms.linf < 1e-3


def test_the_runs_own_csv_compares_with_the_run(runs):
    found = compare(runs[0], runs[0].folder / "gauges.csv")
    assert len(found.pairs) == 4
    # ten digits of time, against a jump within one of 160 steps
    assert max(row["linf_relative"] for row in found.rows()) < 160e-10 and max(row["l1_relative"] for row in found.rows()) < 1e-9


@pytest.mark.parametrize("table, words", [
    ("time [us], velocity\n0,1\n", "has no unit"),
    ("time [us], velocity [GPa]\n0,1\n", "one kind"),
    ("time [us], velocity [furlong]\n0,1\n", "furlong"),
    ("time [us], velocity [m/s]\n0,abc\n", "'abc' is not a number"),
    ("time [us], velocity [m/s]\n0,1,2\n", "values: 3, column headers: 2"),
    ("time [us], velocity [m/s]\n1,1\n0,1\n", "d.csv:3: .*not later than that of the line before"),
    ("time [us], velocity [m/s]\n0,nan\n1,1\n", "d.csv:2: velocity: not a finite number"),
    ("", "needs a line of column headers"), ("time [us], velocity [m/s]\n", "no values below the column headers"),
    ("time [us], colour [1]\n0,1\n1,1\n", "no record here matches a gauge of .* has: free surface stress"),
    ("time [s], velocity [m/s]\n5,0\n6,0\n", "no record here overlaps in time"),
])
def test_broken_tables_are_answered_with_the_place(runs, tmp_path, table, words):
    (tmp_path / "d.csv").write_text(table)
    with pytest.raises(DeckError, match=words.replace("'", ".")) as caught:
        compare(runs[0], tmp_path / "d.csv")
    assert "d.csv" in str(caught.value)


def test_missing_things_are_file_trouble(runs, tmp_path):
    with pytest.raises(FileTrouble):
        compare(runs[0], tmp_path / "none.csv")
    with pytest.raises(FileTrouble):
        compare(tmp_path / "none", runs[0])


def test_units_survive_the_reader(tmp_path):
    (tmp_path / "d.csv").write_text("time [ms], free surface velocity [mm/us]\n0,0\n1,2\n")
    record = read_table(tmp_path / "d.csv")[0]
    assert (record.gauge, record.field, record.unit) == ("free surface", "velocity", "m/s")
    assert np.allclose(record.time, [0, 1e-3]) and np.allclose(record.values, [0, 2000])


def test_the_command_states_the_time_that_was_compared(runs, tmp_path):
    time, velocity = runs[0].gauge("velocity", "free surface")
    kept = slice(len(time) // 4, 3 * len(time) // 4)
    (tmp_path / "part.csv").write_text("time [us], velocity [m/s]\n" + "\n".join(
        f"{t * 1e6!r},{u + 1.0!r}" for t, u in zip(time[kept].tolist(), velocity[kept].tolist())))
    told = CliRunner().invoke(build_app("compare"), ["compare", str(runs[0].folder), str(tmp_path / "part.csv")]).stdout
    assert f"compared from {format_si(float(time[kept][0]), 's', 4)} to {format_si(float(time[kept][-1]), 's', 4)}" in told
