"""The contract of design section 3, over every registered equation of state."""

import math
import re

import numpy as np
import pytest
from dual import Dual, slopes, value

import hugoniot.laws.eos  # noqa: F401  (enrols every law)
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS, check_state, gives, has_temperature, require_temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.shifted_energy import ShiftedEnergy
from hugoniot.laws.eos.tillotson import Tillotson

LAWS = sorted(EOS, key=lambda law: law.name)
EXPECTED = {"ideal_gas", "stiffened_gas", "jwl", "jwl_proportional", "jwl_unreacted", "mie_gruneisen", "mie_gruneisen_linear_gamma", "mie_gruneisen_quadratic",
            "mie_gruneisen_cubic", "polynomial", "herrmann_series", "mie_gruneisen_cold", "mie_gruneisen_cold_series", "nonideal_gas",
            "tillotson", "murnaghan", "tait", "vinet", "birch_murnaghan", "davis_reactants", "davis_products", "p_alpha", "p_lambda",
            "snow_plough", "grain_contact", "shifted_energy", "tension_cutoff", "table", "wilkins_cubic", "ambient",
            "temperature_power"}


def states(law, count, seed=7):
    rng = np.random.default_rng(seed)
    return zip(rng.uniform(*law.box["rho"], count).tolist(), rng.uniform(*law.box["e"], count).tolist())


def test_every_law_of_the_sources_is_enrolled():
    assert set(EOS.names()) >= EXPECTED


@pytest.mark.parametrize("count", [2_000, pytest.param(10_000, marks=pytest.mark.slow)])
@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_derivatives_against_dual_numbers_and_stability(law, count):
    p_of, d_of, par = law.functions["pressure"], law.functions["pressure_derivatives"], law.example
    worst, least = 0.0, math.inf
    for rho, e in states(law, count):
        p = p_of(Dual(rho, 1.0, 0.0), Dual(e, 0.0, 1.0), par)
        p_rho, p_e = (float(d) for d in d_of(rho, e, par))
        s_rho, s_e = slopes(p)
        thermal = float(value(p)) * p_e / (rho * rho)
        # c^2 is the sum of two terms: the slope's error counts against the larger
        worst = max(worst, abs(s_rho - p_rho) / (abs(p_rho) + abs(thermal)), abs(s_e - p_e) / max(abs(p_e), 1e-6 * rho))
        least = min(least, p_rho + thermal)
    assert worst < 1e-11
    assert least > 0.0


def varied(par, rng):
    """The parameters, those of laws inside included, each up to 15 % off; what `build` fills in from others stays."""
    kept = {"rho_solid", "stiffness", "rho_rest", "contact_density"}
    return type(par)(*(varied(v, rng) if hasattr(v, "_fields") else v * rng.uniform(0.85, 1.15) if isinstance(v, float) and f not in kept else v
                       for f, v in zip(par._fields, par)))


@pytest.mark.parametrize("law", [law for law in LAWS if law.name != "table"], ids=lambda law: law.name)
def test_derivatives_of_other_parameters_than_the_example(law):
    rng, worst = np.random.default_rng(11), 0.0
    for k in range(10):
        par = varied(law.example, rng)
        for rho, e in states(law, 30, seed=k):
            p = law.functions["pressure"](Dual(rho, 1.0, 0.0), Dual(e, 0.0, 1.0), par)
            p_rho, p_e = law.functions["pressure_derivatives"](rho, e, par)
            s_rho, s_e = slopes(p)
            worst = max(worst, abs(s_rho - p_rho) / (abs(p_rho) + abs(value(p) * p_e / rho**2)), abs(s_e - p_e) / max(abs(p_e), 1e-6 * rho))
    assert worst < 1e-11


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_pressure_and_slopes_at_once_are_the_same_numbers(law):
    for rho, e in states(law, 300):
        p, p_rho, p_e = contract.pressure_and_derivatives(rho, e, law.example)
        assert p == pytest.approx(contract.pressure(rho, e, law.example), rel=1e-14)
        assert (p_rho, p_e) == tuple(contract.pressure_derivatives(rho, e, law.example))


@pytest.mark.parametrize("law", [law for law in LAWS if gives(law.example, "energy")], ids=lambda law: law.name)
def test_energy_inverts_pressure(law):
    for rho, e in states(law, 500):
        p = law.functions["pressure"](rho, e, law.example)
        assert law.functions["energy"](rho, p, law.example) == pytest.approx(e, rel=1e-11, abs=1e-4)


@pytest.mark.parametrize("law", [law for law in LAWS if gives(law.example, "entropy")], ids=lambda law: law.name)
def test_temperature_and_entropy_obey_the_first_law(law):
    """T ds = de + p dv, so T s_e = 1 and T s_rho = -p/rho^2."""
    par, checked = law.example, 0
    for rho, e in states(law, 600):
        with np.errstate(invalid="ignore"):  # states colder than 0 K, skipped next
            t = law.functions["temperature"](rho, e, par)
        if not t > 1.0:
            continue
        s_rho, s_e = slopes(law.functions["entropy"](Dual(rho, 1.0, 0.0), Dual(e, 0.0, 1.0), par))
        flow = law.functions["pressure"](rho, e, par) / (rho * rho)
        assert abs(t * s_e - 1.0) < 1e-11
        assert abs(t * s_rho + flow) < 1e-11 * (abs(flow) + e / rho)
        _, t_e = slopes(law.functions["temperature"](Dual(rho), Dual(e, 0.0, 1.0), par))
        assert t_e * law.functions["specific_heat"](rho, e, par) == pytest.approx(1.0, rel=1e-11)
        checked += 1
    assert checked > 100


@pytest.mark.parametrize("law", [law for law in LAWS if gives(law.example, "reference_isentrope")], ids=lambda law: law.name)
def test_the_reference_isentrope_is_one_and_energies_beside_it_grow_as_the_law_says(law):
    """de_S/drho = p(rho, e_S)/rho^2 and d ln phi/drho = p_e/rho^2: any e_S + constant phi is then an isentrope of a law linear in e."""
    par = law.example
    assert "linear_in_energy" in law.flags
    for rho, _ in states(law, 500):
        energy, growth = law.functions["reference_isentrope"](Dual(rho, 1.0, 0.0), par)
        p = law.functions["pressure"](rho, float(value(energy)), par)
        p_e = law.functions["pressure_derivatives"](rho, float(value(energy)), par)[1]
        scale = abs(law.functions["pressure"](rho, 1e6, par)) / rho**2     # pressures may cancel to almost nothing
        assert slopes(energy)[0] == pytest.approx(p / rho**2, rel=1e-10, abs=1e-12 * scale)
        assert slopes(growth)[0] == pytest.approx(p_e / rho**2, rel=1e-10)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_reference_state_is_at_rest(law):
    rho, e = law.functions["reference_state"](law.example)
    low, high = law.functions["density_limits"](law.example)
    assert low < rho < high
    if not {"gas", "loaded"} & law.flags:
        stiffness = rho * contract.sound_speed_squared(rho, e, law.example)
        assert abs(law.functions["pressure"](rho, e, law.example)) < 1e-11 * stiffness
    check_state(rho, e, law.example)


@pytest.mark.parametrize("law", [law for law in LAWS if gives(law.example, "temperature") and not ({"gas"} & law.flags)
                                 and law.name != "stiffened_gas"], ids=lambda law: law.name)
def test_reference_temperature(law):
    temperature = law.functions["temperature"](*law.functions["reference_state"](law.example), law.example)
    assert 250.0 < temperature < 350.0


def test_stiffened_gas_has_no_reference_temperature_of_its_own():
    """It follows from P_infinity and c_v: 126 K for the water-like set."""
    par = EOS.get("stiffened_gas").example
    assert contract.temperature(*contract.reference_state(par), par) == pytest.approx(6e8 / (3.4 * 1000.0 * 1400.0))


@pytest.mark.parametrize("law", [law for law in LAWS if "linear_in_energy" in law.flags], ids=lambda law: law.name)
def test_linear_in_energy_means_it(law):
    for rho, e in states(law, 100):
        p0, p1, p2 = (law.functions["pressure"](rho, x, law.example) for x in (0.0, e, 2.0 * e))
        slope = law.functions["pressure_derivatives"](rho, e, law.example)[1]
        scale = abs(p0) + abs(p2)
        assert abs(p0 + p2 - 2.0 * p1) < 1e-12 * scale
        assert abs(p1 - p0 - slope * e) < 1e-12 * scale


@pytest.mark.parametrize("law", [law for law in LAWS if "linear_in_energy" not in law.flags and law.name != "table"],
                         ids=lambda law: law.name)
def test_a_law_that_is_linear_in_the_energy_is_flagged(law):
    """Solvers and theory ask the flag for closed forms. A law made of another cannot know what it is made of."""
    bent = 0.0
    for rho, e in states(law, 100):
        p0, p1, p2 = (law.functions["pressure"](rho, x, law.example) for x in (0.0, e, 2.0 * e))
        bent = max(bent, abs(p0 + p2 - 2.0 * p1) / (abs(p0) + abs(p2)))
    assert bent > 1e-9 or any(EOS.knows(inner) for inner in law.example)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_documented(law):
    assert law.summary.endswith(".")
    assert "Source:" in law.module.__doc__
    assert "$$" in law.module.__doc__
    assert all(law.references)
    assert set(law.units) == set(law.meaning)
    assert set(law.box) == {"rho", "e"}
    assert all(low < high for low, high in law.box.values())


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_states_beyond_the_limits_are_refused_with_the_limit(law):
    low, high = law.functions["density_limits"](law.example)
    e = law.functions["reference_state"](law.example)[1]
    if math.isfinite(high):
        with pytest.raises(OutOfRange, match=re.escape(f"{high:.6g}")):
            check_state(1.001 * high, e, law.example)
    with pytest.raises(OutOfRange, match=f"must be above {low:.6g}"):
        check_state(low, e, law.example)
    with pytest.raises(OutOfRange, match="finite"):
        check_state(math.nan, e, law.example)


def test_strong_tension_is_refused_where_the_law_has_no_stable_state():
    tension = Tillotson(2700.0, 0.5, 1.63, 75.2e9, 65e9, 5.0, 5.0, 5e6, 3e6, 13.9e6)
    # without energy p = A mu + B mu^2 and dp/de = (a + b) rho: c^2 is a polynomial over rho
    x = np.poly1d([1.0, 0.0])
    mu = x - 1.0
    edge = max(((75.2 + 130.0 * mu) * x + 2.13 * mu * (75.2 + 65.0 * mu)).roots)
    with pytest.raises(OutOfRange, match=f"stable only above {2700.0 * edge:.6g} kg/m3"):
        check_state(1000.0, 0.0, tension)
    solid = EOS.get("mie_gruneisen").example
    with pytest.raises(OutOfRange, match="stable only above 1.*, where p = -"):
        check_state(500.0, 0.0, solid)


def test_duplicate_name_is_refused():
    law = EOS.get("jwl")
    with pytest.raises(ValueError, match="registered already"):
        EOS.add("jwl", law.parameters, functions=dict(law.functions), example=law.example, units=law.units, meaning=law.meaning, box=law.box,
                references=law.references)


def test_unknown_name_offers_the_nearest():
    with pytest.raises(KeyError, match="did you mean 'mie_gruneisen'"):
        EOS.get("mie_grueneisen")


def test_missing_specific_heat_is_one_clear_message():
    cold = MieGruneisen(2785.0, 5328.0, 1.338, 2.0)
    assert not has_temperature(cold)
    with pytest.raises(OutOfRange, match="specific_heat"):
        require_temperature(cold)
    with pytest.raises(OutOfRange, match="has no temperature"):
        require_temperature(EOS.get("tillotson").example)
    with pytest.raises(OutOfRange, match="shifted_energy: this equation of state has no temperature"):
        require_temperature(ShiftedEnergy(EOS.get("tillotson").example, 0.0))
    assert has_temperature(cold._replace(specific_heat=863.0))
    assert not has_temperature(EOS.get("ideal_gas").example._replace(specific_heat=0.0))
