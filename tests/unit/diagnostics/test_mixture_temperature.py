"""Temperatures of what burns: the mixture law's own, at snapshots and gauges, and before, during and after burning."""

import dataclasses

import numpy as np
import pytest

from hugoniot import simulate
from hugoniot.diagnostics.temperature import laws_with_temperature, mixed_temperature
from hugoniot.laws.eos.contract import temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.mixture.contract import Mixed, mixture_temperature
from hugoniot.materials import burning, library
from hugoniot.problem.model import Boundary, Gauge, OutputOptions, Problem, Pulse, Region

LX17 = dataclasses.replace(library.find("LX-17 reactive"), name="lx-17")


def pushed(material, lighting=()):
    region = Region("charge", material.name, 0.0, 4e-3, 160)
    left = Boundary("fixed") if lighting else Boundary("velocity", Pulse("constant", amplitude=1700.0))
    return Problem("pushed", "planar", 0.45e-6, (region,), {material.name: material}, left, Boundary("free"), lighting=lighting,
                   gauges=(Gauge("on a face", 1e-3), Gauge("in a zone", 1.0125e-3)), output=OutputOptions(report=False, snapshots=0.05e-6))


@pytest.mark.parametrize("mixture", ["thermal_isolation", *(pytest.param(name, marks=pytest.mark.slow)
                                                            for name in ("thermal_equilibrium", "weighted_pressures"))])
def test_snapshots_and_gauges_hold_burn_fraction_and_temperature(tmp_path, mixture):
    material = dataclasses.replace(LX17, mixture=mixture)
    run = simulate.run(pushed(material), tmp_path / "run")
    shots = run.arrays("snapshots")
    assert shots["temperature"][0] == pytest.approx(298.0, rel=1e-9) and np.isfinite(shots["temperature"]).all()
    burned = shots["burn_fraction"][-1] == 1.0
    direct = [temperature(rho, e, material.eos) for rho, e in zip(shots["density"][-1][burned], shots["energy"][-1][burned])]
    assert burned.sum() > 20 and shots["temperature"][-1][burned] == pytest.approx(direct, rel=1e-12)
    for name in ("on a face", "in a zone"):
        time, kelvin = run.gauge("temperature", name)
        fraction = run.gauge("burn_fraction", name)[1]
        assert kelvin[0] == pytest.approx(298.0, rel=1e-9) and np.isfinite(kelvin).all() and fraction[0] == 0.0 and fraction[-1] > 0.99
        assert (np.diff(fraction) >= 0.0).all()
        centre = np.interp(1e-3 if name == "on a face" else 1.0125e-3, shots["centre"], shots["temperature"][-1])
        assert kelvin[-1] == pytest.approx(centre, rel=2e-3)


def test_the_sweep_over_many_states_is_the_law_itself():
    par = burning.reactive(LX17).mixture
    lam = np.linspace(0.0, 1.0, 301)
    phases = np.stack([lam, np.full(301, 2500.0), np.full(301, 4.5e6), np.full(301, 2300.0), np.full(301, 4.4e6)], axis=1)
    one = [mixture_temperature(row[0], Mixed(0.0, *row[1:], 0.0), par) for row in phases.tolist()]
    assert mixed_temperature(phases, par) == pytest.approx(one, rel=1e-13)
    assert mixed_temperature(phases[:5], par) == pytest.approx(one[:5], rel=1e-13)


def test_no_temperature_where_a_phase_has_none_or_products_have_not_formed(tmp_path):
    cold = dataclasses.replace(LX17, unreacted=MieGruneisen(1905.0, 2500.0, 2.0, 1.0))
    assert laws_with_temperature(pushed(cold)) == [None]
    lit = dataclasses.replace(library.find("lx_17"), name="lx-17")
    par = burning.reactive(dataclasses.replace(lit, eos=LX17.eos)).mixture
    found = mixed_temperature(np.array([[0.0, 1905.0, 3.6e6, 1905.0, 3.6e6], [1.0, 1905.0, 3.6e6, 2000.0, 3.6e6]]), par)
    assert np.isnan(found[0]) and found[1] == pytest.approx(temperature(2000.0, 3.6e6, LX17.eos), rel=1e-12)
