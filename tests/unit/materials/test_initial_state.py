"""States from two of density, pressure, temperature and energy, far from rest too, and of laws that search for their pressure."""

import math

import numpy as np
import pytest
from typer.testing import CliRunner

import hugoniot.laws.eos  # noqa: F401  (enrols the laws)
from hugoniot.cli.main import build_app
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS, reference_state
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials import library
from hugoniot.materials.initial_state import energy_at_pressure, initial_state

GAS = IdealGas(1.4, 717.5, 1.2)


@pytest.mark.parametrize(("pressure", "temperature"), [(1e7, 1000.0), (1e9, 300.0), (1.0, 3000.0), (101325.0, 298.15)])
def test_a_gas_has_a_state_at_any_pressure_and_temperature(pressure, temperature):
    rho, e = initial_state(GAS, pressure_=pressure, temperature_=temperature)
    assert rho == pytest.approx(pressure / (0.4 * 717.5 * temperature), rel=1e-12) and e == pytest.approx(717.5 * temperature, rel=1e-12)
    rho, e = initial_state(GAS, pressure_=pressure, energy=717.5 * temperature)
    assert rho == pytest.approx(pressure / (0.4 * e), rel=1e-12)


def test_products_are_found_thin():
    tnt = JWL(371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630.0, 7.0e9, 613.5)
    rho, e = initial_state(tnt, pressure_=1e5, energy=5e6)
    assert rho == pytest.approx(1e5 / (0.3 * 5e6), rel=1e-9)


def test_a_solid_that_has_no_such_state_says_so():
    with pytest.raises(OutOfRange, match="does not reach it"):
        initial_state(MieGruneisen(8930.0, 3940.0, 1.489, 1.99, 385.0), pressure_=-1e12, temperature_=300.0)


@pytest.mark.parametrize("name", [law.name for law in EOS if "energy" not in law.functions])
def test_every_pressure_the_law_has_at_a_density_gives_an_energy(name):
    law = EOS.get(name)
    rest, rng = reference_state(law.example)[0], np.random.default_rng(0)
    for _ in range(150):
        rho, e = rest * rng.uniform(1.0, 1.5), rng.uniform(law.box["e"][0], min(law.box["e"][1], 5e6))
        p = float(contract.pressure(rho, e, law.example))
        if p > 0.0:
            found = energy_at_pressure(rho, p, law.example)
            assert contract.pressure(rho, found, law.example) == pytest.approx(p, rel=1e-12, abs=1e-6)


def test_a_pressure_the_law_has_not_is_refused():
    with pytest.raises(OutOfRange, match=r"no energy gives -1e.09 Pa at 1900 kg/m3 in the law 'snow_plough'"):
        energy_at_pressure(1900.0, -1e9, EOS.get("snow_plough").example)


def test_a_state_below_absolute_zero_is_refused():
    """A solid compressed without pressure has lost more energy than all its heat; with a temperature the same density is a state."""
    copper = MieGruneisen(8930.0, 3940.0, 1.489, 1.99, 385.0)
    with pytest.raises(OutOfRange, match="9500 kg/m3 and 0 Pa would be a state at -[0-9]+ K, below absolute zero; give the density and a temperature"):
        initial_state(copper, density=9500.0)
    rho, e = initial_state(copper, density=9500.0, temperature_=300.0)
    assert contract.temperature(rho, e, copper) == pytest.approx(300.0) and contract.pressure(rho, e, copper) > 9e9
    assert initial_state(copper, density=8800.0)[0] == 8800.0       # expanded, and so hot


def test_products_colder_than_their_cold_isentrope_are_refused_without_a_specific_heat():
    """Composition B products at 1717 kg/m3 have 11.88 GPa; 1 GPa there needs -13.7 MJ/kg, 15 MJ/kg below e_c: a gas that bore tension."""
    par = library.find("comp_b").eos
    assert not par.specific_heat > 0.0
    cold = (par.a / par.r1 * math.exp(-par.r1) + par.b / par.r2 * math.exp(-par.r2)) / par.rho0
    least = float(contract.pressure(par.rho0, cold, par))
    assert initial_state(par, pressure_=1.001 * least)[1] > cold
    with pytest.raises(OutOfRange, match="below absolute zero, whatever its specific heat"):
        initial_state(par, pressure_=0.999 * least)
    told = CliRunner().invoke(build_app("eos"), ["eos", "riemann", "comp_b", "copper", "--left", "pressure = 1 GPa"])
    assert told.exit_code == 3 and "below absolute zero" in told.output
