"""Fitting a rate to a Pop plot: the constant that made a line is found again from another, and what cannot be sought is refused."""

import dataclasses
import json

import numpy as np
import pytest

from hugoniot.campaign.pop_plot import pop_plot
from hugoniot.campaign.rate_fit import fit_rate
from hugoniot.cli.main import main
from hugoniot.diagnostics.detonation import PopLine
from hugoniot.errors import OutOfRange
from hugoniot.materials import library

LX17 = library.find("LX-17 reactive")
PRESSURES = (15e9, 18e9)


def with_rate(**changes):
    return dataclasses.replace(LX17, burn=LX17.burn._replace(**changes))


def call(capsys, *arguments):
    with pytest.raises(SystemExit) as ended:
        main(["fit-rate", *arguments])
    out, err = capsys.readouterr()
    return ended.value.code or 0, out, err


def test_the_constant_behind_a_line_is_found_again():
    """The line through two run distances of LX-17, from a growth four tenths weaker."""
    line = pop_plot(LX17, PRESSURES, zone_size=3e-5).line
    found = fit_rate(with_rate(g1=0.6 * LX17.burn.g1), line, PRESSURES, ("g1",), zones=70)
    assert found.after["g1"] == pytest.approx(LX17.burn.g1, rel=0.05) and found.before["g1"] == 0.6 * LX17.burn.g1
    assert found.ratios == pytest.approx((1.0, 1.0), abs=0.03) and found.refined == pytest.approx((1.0, 1.0), abs=0.05)
    assert found.material.burn._replace(g1=0.0) == LX17.burn._replace(g1=0.0)
    sought = found.fit.parameters[0]      # a fit as any other
    assert sought.low < sought.value < sought.high and found.fit.matches and found.fit.freedom == 1
    rise = np.log(found.after["g1"]) - np.log(0.6 * LX17.burn.g1)
    assert sought.name.startswith("ln of the rate of g1 at 16") and 0.0 < sought.sigma < 0.2 * rise


LINE = PopLine(1.39, -0.31, *(np.nan,) * 3)


@pytest.mark.parametrize(("material", "adjust", "pressures", "words"), [
    (LX17, ("g3",), PRESSURES, "no constant 'g3'"), (LX17, ("g1", "g1"), PRESSURES, "twice"), (LX17, (), PRESSURES, "no constant to"),
    (LX17, ("y",), PRESSURES, "without its coefficient 'g1'"), (with_rate(g2=0.0), ("g2",), PRESSURES, "starts from 0"),
    (LX17, ("g1", "y"), (15e9,), "as many input pressures"), (LX17, ("g1",), (-1.0,), "all positive"),
    (library.find("comp_b"), ("g1",), PRESSURES, "has no rate-based burn law")])
def test_what_cannot_be_sought_is_refused(material, adjust, pressures, words):
    with pytest.raises(OutOfRange, match=words):
        fit_rate(material, LINE, pressures, adjust)


def test_a_start_that_never_turns_is_told():
    with pytest.raises(OutOfRange, match="no run detonated within 8 times .*: the rate is too low; .*closer to the data"):
        fit_rate(with_rate(g1=1e-40, g2=0.0), LINE, (15e9,), ("g1",), zones=50)


def test_a_start_that_detonates_at_once_is_told():
    with pytest.raises(OutOfRange, match="every run detonated at once: the rate is too high"):
        fit_rate(with_rate(i=1e6 * LX17.burn.i, g1=1e6 * LX17.burn.g1, g2=1e6 * LX17.burn.g2), LINE, (10e9,), ("g1",), zones=50)


def test_the_command_gives_a_table_for_a_deck(capsys, tmp_path):
    arguments = ("LX-17 reactive", "--line", "1.37, -0.23", "-p", "15, 18 GPa", "--adjust", "g1", "--start", "g2 = 1e-4", "--zones", "50", "--out",
                 str(tmp_path / "rate"))
    code, out, _ = call(capsys, *arguments, "--json")
    told = json.loads(out)
    assert code == 0 and told["burn"]["law"] == "ignition_growth" and told["burn"]["g2"] == 1e-4
    assert told["burn"]["g1"] == told["after"]["g1"] != told["before"]["g1"] == 4.5e-24 and len(told["points"]) == 2
    record = json.loads((tmp_path / "rate" / "fit.json").read_text())      # the files of any fit
    assert record["parameters"] == told["fit"]["parameters"] and "run distance" in (tmp_path / "rate" / "report.html").read_text()
    rows = (tmp_path / "rate" / "residuals.csv").read_text().splitlines()
    assert "input pressure" in rows[0] and len(rows) == 3 and "ignition_growth" in (tmp_path / "rate" / "fitted.toml").read_text()


def test_pressures_beyond_the_measured_ones_and_what_the_deviations_assume_are_stated(capsys):
    """R004 was measured from 10.1 to 15 GPa."""
    code, out, _ = call(capsys, "LX-17 reactive", "--to", "R004", "-p", "15, 18 GPa", "--adjust", "g1", "--zones", "50", "--json")
    notes = json.loads(out)["notes"]
    assert code == 0 and any("at 18 GPa the line is extrapolated" in note for note in notes) and any("5 %" in note for note in notes)


@pytest.mark.parametrize(("arguments", "words"), [
    (("LX-17 reactive",), "R004"), (("LX-17 reactive", "--to", "R004", "--start", "g9 = 1"), "g9"),
    (("LX-17 reactive", "--to", "R004", "--start", "y"), "--start"), (("LX-17 reactive", "--line", "1.1"), "--line"),
    (("LX-17 reactive", "--line", "1.1, 0.3"), "negative"), (("comp_b", "--to", "R005"), "has no rate-based burn law")])
def test_what_the_command_refuses(capsys, arguments, words):
    code, _, err = call(capsys, *arguments)
    assert code == 2 and words in err
