"""Temperatures of a run have the same bits however many states are looked at at once: a burst's length is a matter of the clock."""

import numpy as np
import pytest

import hugoniot
from hugoniot.diagnostics.temperature import gauge_temperature, laws_with_temperature
from hugoniot.laws.eos.contract import EOS, has_temperature, reference_state
from hugoniot.problem.deck import read_deck_text


@pytest.mark.parametrize("name", ["mie_gruneisen", "p_alpha"])
def test_a_record_cut_into_bursts_is_the_record(name):
    law = EOS.get(name).example
    if not has_temperature(law):
        law = law._replace(base=EOS.get("mie_gruneisen").example)
    rho0 = reference_state(law)[0]
    rng = np.random.default_rng(1)
    rows = {"density": rho0 * rng.uniform(1.0, 1.3, (300, 2)), "energy": rng.uniform(1e4, 1e6, (300, 2)), "compaction": rng.uniform(0.0, 1.0, (300, 2))}
    rows["compaction"][:20] = 0.0
    whole = gauge_temperature(rows, [law, law])
    assert np.isfinite(whole).all()
    cuts = [0, 1, 8, 20, 290, 300]
    parts = [gauge_temperature({key: value[a:b] for key, value in rows.items()}, [law, law]) for a, b in zip(cuts, cuts[1:])]
    assert np.array_equal(np.concatenate(parts), whole)


@pytest.mark.parametrize("solver", ["lagrange1d", "lagrange2d"])
def test_material_with_voids_has_the_temperature_of_the_material(tmp_path, solver):
    """Spalled copper at rest and at no pressure has the temperature of its heat, e = cv (T - T0); with the density of material and voids
    together the law gave -5000 K after 4 us, and a hundred thousand below zero later."""
    places = (("flyer", 0, 1, 20, 1500), ("target", 1, 3, 40, 0))
    if solver == "lagrange1d":
        text = "".join(f'[[region]]\nname = "{name}"\nmaterial = "copper"\nfrom = "{a} mm"\nto = "{b} mm"\nzones = {n}\nvelocity = "{v} m/s"\n'
                       for name, a, b, n, v in places)
        text += '[[gauge]]\nname = "spall"\nat = "1.98 mm"\n'
    else:
        text = "".join(f'[[block]]\nname = "{name}"\nmaterial = "copper"\nx = ["{a} mm", "{b} mm"]\ny = ["0 mm", "0.05 mm"]\nzones = [{n}, 1]\n'
                       f'velocity = ["{v} m/s", "0 m/s"]\n' for name, a, b, n, v in places)
        text += '[[boundary]]\non = ["flyer.top", "flyer.bottom", "target.top", "target.bottom"]\nkind = "wall"\n'
        text += '[[gauge]]\nname = "spall"\nat = ["1.98 mm", "0.02 mm"]\n'
    output = '[output]\nreport = false\nsnapshots = "1 us"\nfields = ["temperature", "energy", "void_fraction", "entropy", "density"]\n'
    text = f'geometry = "plane"\n{text}' if solver == "lagrange2d" else text
    deck = read_deck_text(f'stop_time = "4 us"\n{text}{output}[solver]\nkind = "{solver}"\n')
    run = hugoniot.run(deck, tmp_path / "run")
    rows, gauge, law = run.arrays("snapshots"), run.arrays("gauges"), deck.problem.materials["copper"].eos
    open_ = rows["void_fraction"][-1] > 0.2
    assert open_.any()
    heat = 298.15 + rows["energy"][-1][open_] / law.specific_heat
    assert rows["temperature"][-1][open_] == pytest.approx(heat, abs=5.0)
    cold = law.specific_heat * np.log(heat / 298.15)      # of the reference state, which has the entropy 0 here, at little expansion
    assert rows["entropy"][-1][open_] - rows["entropy"][0][0] == pytest.approx(cold, abs=10.0)
    assert gauge["temperature"].min() > 200.0


@pytest.mark.parametrize("energy", [True, False])
@pytest.mark.parametrize(("gas", "known"), [("", False), ("specific_heat = 1500.0", True), ("specific_heat = 717.5", True)])
def test_a_gas_has_no_temperature_of_air(tmp_path, gas, energy, known):
    """A gamma-law gas, or products, without a specific heat got the 717.5 J/kg/K of air, and with just this value none."""
    burn = 'detonation_energy = "4.5 MJ/kg"\nburn = {law = "programmed", detonation_velocity = "8485 m/s"}' if energy else ""
    text = f"""
stop_time = "0.5 us"
region = [{{name = "x", material = "x", from = "0 cm", to = "1 cm", zones = 20}}]
{'lighting = [{at = "0 cm"}]' if energy else ''}
output = {{fields = ["density", "temperature"], report = false}}
[material.x]
{burn}
[material.x.eos]
law = "ideal_gas"
gamma = 3.0
rho0 = "1700 kg/m^3"
{gas}
"""
    deck = read_deck_text(text)
    assert (laws_with_temperature(deck.problem)[0] is not None) == known
    if energy:
        found = hugoniot.run(deck, tmp_path / "run").arrays("snapshots").get("temperature", np.full((1, 20), np.nan))
        assert np.isfinite(found[-1]).any() == known
