"""A run of tracked fronts beside one of `lagrange1d` of the same deck: compared gauge by gauge, and warned of the same tension."""

import numpy as np
import pytest
from aluminium_decks import EOS, gauge, impact
from typer.testing import CliRunner

import hugoniot
from hugoniot.cli.main import build_app
from hugoniot.output.run_numbers import highest

DECK = f"""title = "Plate on plate"
stop_time = "1.2 us"
{impact(20, 40)}{EOS}[material.al]
library = "aluminum_6061"
{gauge("mid-target", "4 mm")}\
[solver]
kind = "KIND"
"""
KINDS = {"algebraic": "fronts", "cells": 'fronts"\noptions = {mode = "cells"}\n#"', "lagrange1d": "lagrange1d"}


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("beside")
    found = {}
    for name, kind in KINDS.items():
        path = folder / f"{name}.toml"
        path.write_text(DECK.replace("KIND", kind))
        found[name] = hugoniot.run(path, folder / f"{name}.run", report=False)
    return found


def warned(run):
    events = run.arrays("events")
    return [str(text) for kind, text in zip(events["kind"], events["text"]) if kind == "warning" and "under a tension of" in str(text)]


def test_tension_without_a_fracture_law_is_warned_of_by_both_solvers(runs):
    assert len(warned(runs["lagrange1d"])) == 1 and "add [material.al.fracture]" in warned(runs["lagrange1d"])[0]
    for mode in ("algebraic", "cells"):
        assert len(warned(runs[mode])) == 1 and "run it with lagrange1d and [material.al.fracture]" in warned(runs[mode])[0]
        tension = [float(warned(runs[name])[0].split("tension of ")[1].split(" GPa")[0]) for name in (mode, "lagrange1d")]
        assert tension[0] == pytest.approx(tension[1], rel=0.04)


@pytest.mark.parametrize("mode", ["algebraic", "cells"])
def test_peaks_of_zones_are_those_of_lagrange1d(runs, mode):
    """But for the zones beside faces: where it was struck an artificial viscosity heats, and at a free surface it spreads the shock."""
    found, other = runs[mode].arrays("peaks"), runs["lagrange1d"].arrays("peaks")
    inner = np.min(np.abs(other["centre"][:, None] - np.array([0.0, 2e-3, 6e-3])), axis=1) > 6e-4
    for name in ("peak_stress", "peak_density", "peak_pressure"):
        assert found[name][inner] == pytest.approx(other[name][inner], rel=0.01)
    assert found["peak_tension"].max() == pytest.approx(other["peak_tension"].max(), rel=0.25)
    assert highest(runs[mode])["stress"] == pytest.approx(found["peak_stress"].max())
    runs[mode].plot.peaks()


@pytest.mark.parametrize("mode", ["algebraic", "cells"])
def test_gauges_and_surfaces_are_compared_with_those_of_lagrange1d(runs, mode):
    found = CliRunner().invoke(build_app("compare"), ["compare", str(runs[mode].folder), str(runs["lagrange1d"].folder)])
    assert found.exit_code == 0, found.output
    assert f"a was run with fronts ({mode}), b with lagrange1d; otherwise the same problem" in found.output
    from hugoniot.output.compare import compare

    pairs = compare(runs[mode], runs["lagrange1d"])
    rows = {(row["gauge"], row["field"]): row for row in pairs.rows()}
    for name in ("mid-target", "free surface left", "free surface right"):
        row = rows[name, "velocity"]
        assert row["l1_relative"] < 0.06 and abs(row["time_shift"]) < 0.05 * 4e-3 / 5200.0
        assert rows[name, "position"]["linf"] < 0.2e-3 / 2
    assert not any(np.isnan(row["l1"]) for row in rows.values())
    back = compare(runs["lagrange1d"], runs[mode])
    assert set(back.unmatched) == set(pairs.unmatched) and "mid-target damage" in back.unmatched
