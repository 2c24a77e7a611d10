"""`hugoniot eos convert`: the series of appendix C with units, and a law a deck accepts."""

import json

import pytest
from typer.testing import CliRunner

from hugoniot.cli.main import build_app
from hugoniot.laws.eos.contract import pressure
from hugoniot.problem.deck import read_deck_text


def convert(*arguments):
    return CliRunner().invoke(build_app("eos"), ["eos", "convert", *arguments])


def test_linear_fit_becomes_a_law_of_a_deck():
    given = ["linear", "rho0=2.785 g/cm^3", "c0=5.328 km/s", "s=1.338", "gamma0=2"]
    found = json.loads(convert(*given, "--json").stdout)
    assert found["hugoniot"]["k0"] == pytest.approx(2785.0 * 5328.0**2, rel=1e-12)
    assert (found["hugoniot"]["k1"], found["hugoniot"]["k2"]) == pytest.approx((2.676, 3 * 1.338**2), rel=1e-12)
    table = convert(*given).output.partition("[material.x.eos]")[2]
    deck = ('geometry = "planar"\nstop_time = "1 us"\n[[region]]\nname = "a"\nmaterial = "x"\nfrom = "0 mm"\nto = "1 mm"\nzones = 5\n'
            f"[material.x.eos]{table}")
    par = read_deck_text(deck).problem.materials["x"].eos
    up = 150.0  # weak: the series is good to compressions of about 0.1
    us = 5328.0 + 1.338 * up
    assert pressure(2785.0 / (1.0 - up / us), 0.5 * up * up, par) == pytest.approx(2785.0 * us * up, rel=3e-4)


def test_gamma_from_expansion():
    found = json.loads(convert("murnaghan", "a=18 GPa", "exponent=5", "rho0=8930", "expansion=5e-5 1/K", "heat_at_pressure=385 J/kg/K",
                               "--json").stdout)
    assert found["gamma0"] == pytest.approx(18e9 * 5 * 5e-5 / (8930 * 385), rel=1e-12)
    assert found["law"]["h0"] == pytest.approx(8930 * found["gamma0"], rel=1e-12)


@pytest.mark.parametrize("arguments, said", [(["lineer", "c0=1"], "linear"), (["linear", "rho0=1000", "s=1.3"], "c0"),
                                             (["linear", "c00=3 km/s"], "c0"), (["linear", "c0"], "c0: has no value")])
def test_bad_input_names_the_way_out(arguments, said):
    result = convert(*arguments)
    assert result.exit_code != 0 and said in f"{result.output} {result.exception!r} {getattr(result.exception, 'problems', '')}"
