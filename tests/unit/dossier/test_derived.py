"""Numbers that follow from constants, each against a formula of its own."""

import math
import re

import numpy as np
import pytest
import second_routes

from hugoniot.dossier import derived
from hugoniot.dossier.describe import described
from hugoniot.dossier.wording import differences, row_summary
from hugoniot.errors import DeckError, NoSolution
from hugoniot.laws.eos.contract import EOS, pressure, reference_state, temperature
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.jwl_isentrope import JWLIsentrope
from hugoniot.materials import library, schema
from hugoniot.theory.chapman_jouguet import cj, on_isentrope


def test_elastic_limit_by_poissons_ratio():
    """HEL = Y (1 - nu)/(1 - 2 nu) and c_L from nu, E: other forms of the same elasticity."""
    found = derived.derived_quantities(library.find("al6061"))
    nu, g, y = (found[k].value for k in ("poisson_ratio", "shear_modulus", "yield_stress"))
    young = 2.0 * g * (1.0 + nu)
    assert found["hugoniot_elastic_limit"].value == pytest.approx(y * (1.0 - nu) / (1.0 - 2.0 * nu), rel=1e-12)
    speed = math.sqrt(young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)) / 2703.0)
    assert found["longitudinal_sound_speed"].value == pytest.approx(speed, rel=1e-12)
    assert found["bulk_modulus"].value == pytest.approx(young / (3.0 * (1.0 - 2.0 * nu)), rel=1e-12)


@pytest.mark.parametrize("name", ["copper", "iron", "lead", "pmma", "water", "granite", "helium"])
@pytest.mark.parametrize("up", [50.0, 600.0, 1800.0])
def test_hugoniot_satisfies_the_jump_conditions(name, up):
    """Us from the solver puts p = p0 + rho0 Us up and e = e0 + (p + p0) dv/2 on the equation of state."""
    par = library.find(name).eos
    rho0, e0 = reference_state(par)
    p0 = pressure(rho0, e0, par)
    us = derived.material_hugoniot(library.find(name), up)
    rho, p = rho0 * us / (us - up), p0 + rho0 * us * up
    assert pressure(rho, e0 + 0.5 * (p + p0) * (1.0 / rho0 - 1.0 / rho), par) == pytest.approx(p, rel=1e-10)


def test_ideal_gas_hugoniot_has_a_closed_form():
    par = library.find("argon").eos
    rho0, e0 = reference_state(par)
    c = math.sqrt(par.gamma * pressure(rho0, e0, par) / rho0)
    up = 900.0
    half = 0.25 * (par.gamma + 1.0) * up
    assert derived.material_hugoniot(library.find("argon"), up) == pytest.approx(half + math.sqrt(half * half + c * c), rel=1e-12)


@pytest.mark.parametrize("identity", [i for i, r in schema.table("us_up").items() if r["form"] == "steinberg_cubic"])
def test_implicit_cubic_is_solved(identity):
    row = schema.row(identity)
    for up in (10.0, 300.0, 1000.0):
        us = derived.shock_velocity(row, up)
        x = up / us
        assert us == pytest.approx(row["c0"] + (row["s"] + row["s2"] * x + row["s3"] * x * x) * up, rel=1e-10)
        assert us > up


def test_forms_of_hugoniots():
    quadratic, exponential = schema.row("U208"), schema.row("U160")
    assert derived.shock_velocity(quadratic, 2500.0) == pytest.approx(3530.73 + 1.91402 * 2500.0 - 6.0553e-05 * 2500.0 ** 2)
    assert derived.shock_velocity(exponential, 8000.0) == pytest.approx(6278.0 + 1.193 * 8e3 - 2.505 * 8e3 * math.exp(-2.9608), rel=1e-5)


def test_beyond_the_end_of_a_cubic_fit_the_highest_particle_velocity_is_named():
    row = schema.row("U043")
    with pytest.raises(NoSolution, match="the fitted Hugoniot ends at particle velocity") as told:
        derived.shock_velocity(row, 60000.0)
    eta = np.linspace(0.0, 0.5, 100001)
    up = row["c0"] * eta / (1.0 - row["s"] * eta - row["s2"] * eta**2 - row["s3"] * eta**3)
    named = float(re.search(r"ends at particle velocity (\S+) m/s", str(told.value)).group(1))
    assert named == pytest.approx(up.max(), rel=1e-4)
    assert derived.shock_velocity(row, 0.9999 * named) > named


def test_cj_states_by_a_second_route():
    """Theory's CJ states of every products row that can be closed, against bisection on the jump conditions."""
    rows = [row for row in schema.table("jwl").values() if row["role"] == "products" and "e0" in row]
    assert len(rows) >= 50
    for row in rows:
        par = JWL(row["a"], row["b"], row["r1"], row["r2"], row["omega"], row["rho0"], row["e0"])
        mine, theirs = second_routes.chapman_jouguet(par), cj(par)
        assert theirs.detonation_velocity == pytest.approx(mine.velocity, rel=1e-10), row.id
        assert theirs.state.pressure == pytest.approx(mine.pressure, rel=1e-8) and theirs.state.density == pytest.approx(mine.density, rel=1e-8)
        assert theirs.adiabatic_exponent == pytest.approx(mine.exponent, rel=1e-8)


def test_hugoniots_by_a_second_route():
    """Theory's shocks in every curated material that has a principal Hugoniot, against bisection on the jump conditions."""
    solids = [e for e in library.find_all() if "reacted" not in EOS.of(e.material.eos).flags]
    assert len(solids) > 50
    for entry in solids:
        for up in (100.0, 500.0, 0.99 * (entry.material.valid_up_to or 500.0)):
            assert derived.material_hugoniot(entry.material, up) == pytest.approx(second_routes.shock_velocity(entry.material.eos, up), rel=1e-9), entry.name


def test_a_tangency_on_an_isentrope_is_the_cj_state_of_its_set():
    """E0 found from the isentrope through the CJ state of a set must be the set's own E0."""
    row = schema.row("J002")
    par = JWL(row["a"], row["b"], row["r1"], row["r2"], row["omega"], row["rho0"], row["e0"])
    state = second_routes.chapman_jouguet(par)
    v = row["rho0"] / state.density
    cold = row["a"] * math.exp(-row["r1"] * v) + row["b"] * math.exp(-row["r2"] * v)
    c = (state.pressure - cold) * v ** (1.0 + row["omega"])
    found = on_isentrope(JWLIsentrope(((row["a"], row["r1"]), (row["b"], row["r2"])), c, row["omega"]), row["rho0"])
    assert found.energy == pytest.approx(row["e0"], rel=1e-9) and found.volume == pytest.approx(v, rel=1e-8)
    assert (found.detonation_velocity, found.pressure) == (pytest.approx(state.velocity, rel=1e-9), pytest.approx(state.pressure, rel=1e-9))


def test_a_jwl_isentrope_is_the_integral_of_its_slopes():
    """-dp/dV and -dE/dV = p by differences, four exponentials as in JWLB."""
    s = JWLIsentrope(((400e9, 12.0), (80e9, 6.0), (9e9, 2.5), (1e9, 1.1)), 0.9e9, 0.33)
    v, h = np.linspace(0.7, 6.0, 40), 1e-5
    assert s.steepness(v) == pytest.approx((s.pressure(v - h) - s.pressure(v + h)) / (2 * h), rel=1e-7)
    assert s.pressure(v) == pytest.approx((s.energy(v - h) - s.energy(v + h)) / (2 * h), rel=1e-7)
    assert s.pressure(v) == pytest.approx(np.sum(s.parts(v), axis=0)) and s.energy(1e12) < 1e6


def test_unreacted_explosives_rest_as_calibrated():
    """The energy given to an unreacted JWL puts it at the calibration's own pressure and temperature."""
    for name in ("tnt", "lx_17", "c4", "pbx_9404"):
        par = library.entry(name).unreacted
        rho, e = reference_state(par)
        assert temperature(rho, e, par) == pytest.approx(298.0, rel=1e-12)
        assert abs(pressure(rho, e, par)) < 5e6
        assert 1000.0 < derived.derived_quantities(library.find(name), par)["unreacted_sound_speed"].value < 4500.0


def test_numbers_are_plain():
    for entry in library.find_all():
        for quantity in derived.derived_quantities(entry.material, entry.unreacted).values():
            assert type(quantity.value) is float and np.isfinite(quantity.value)


@pytest.mark.parametrize("name, begins", [("iron", 1540.0), ("fused_silica", 6660.0), ("copper", None)])
def test_derived_constants_of_a_law_fitted_beyond_a_transition_are_called_so(name, begins):
    """Iron's c0 of 3.72 km/s is an intercept: the sound speed of iron is 4.6 km/s."""
    about = described(library.entry(name))
    assert about["data_begin"] == begins
    assert (f"whose valid range begins at a particle velocity of {begins or 0:g} m/s" in differences(about)) == (begins is not None)


@pytest.mark.parametrize("name, words", [("U204", "begin at a particle velocity of 900 m/s; other rows of the library whose data begin below 1000 m/s give 1484 to 1833 m/s"),
                                         ("copper", ""), ("U242", "")])
def test_an_intercept_that_other_sources_contradict_is_no_measured_sound_speed(name, words):
    """A line through water's states from 0.9 km/s on meets zero at 2233 m/s; sound runs at 1.48 km/s."""
    told = differences(described(library.entry(name)))
    assert words in told and ("is extrapolated from data" in told) == bool(words)


def test_the_yield_stress_says_which_strain_and_rate_it_is_for():
    """The 0.80 GPa of uranium are twice the constant of its law: they include the hardening by the initial strain."""
    for entry in library.find_all():
        about = described(entry)
        if "yield_stress" not in about["derived"]:
            continue
        stated = {c["quantity"]: c["value"] for c in about["constants"]}
        strain = stated.get("strength.initial_strain", 0.0)
        ratio = about["derived"]["yield_stress"]["value"] / stated["strength.yield_stress"]
        how, said = about["derived"]["yield_stress"]["meaning"], differences(about)
        assert ("initial strain" in how) == ("initial strain" in said) == (strain > 0.0)
        assert ("strain rate" in how) == (about["laws"]["strength"] == "johnson_cook")
        if "300 K" in said and not strain:
            assert 1.0 < ratio < 1.01
        assert ("no thermal softening up to" in said) == (about["laws"]["strength"] == "johnson_cook" and ratio < 1.0)
    assert differences(described(library.entry("uranium"))).endswith("by the initial strain of 0.0375.")


@pytest.mark.parametrize("name, quantity, remark", [
    ("tin", "eos.specific_heat", "converted from c_p = 220 J/kg/K"), ("diamond", "eos.gamma0", "estimated"),
    ("iron", "eos.c0", "fitted by hugoniot"), ("iron", "eos.rho0", "mean of the measured states"),
    ("pbx_9502", "unreacted.reference_temperature", "assumed"), ("pbx_9502", "rate.z", "calibrated by hugoniot"),
    ("pbx_9502", "rate.i", "taken from row G003"), ("comp_b", "rate.g2", "set by hugoniot"),
    ("pbx_9404", "rate.i", "taken from row G010 (not checked against the printed source)"),
    ("octol", "burn.detonation_velocity", "computed from constants not checked against the printed source"),
    ("hns", "eos.rho0", "assumed"), ("hns", "unreacted.rho0", "assumed"), ("J034", "eos.rho0", "assumed"),
    ("rdx", "eos.e0", "computed from the isentrope, doubtful")])
def test_a_derived_constant_says_how_it_was_found(name, quantity, remark):
    assert next(c["mark"] for c in described(library.entry(name))["constants"] if c["quantity"] == quantity) == remark


def test_the_line_of_a_strength_that_rises_with_pressure_names_the_cohesion():
    """Row S096 is granite of Collins et al. 2004: cohesion 0.09 GPa, limiting strength 1.5 GPa."""
    assert row_summary(schema.row("S096")) == "Collins/Drucker-Prager, cohesion 0.09 GPa"


@pytest.mark.parametrize("name, words", [("U233", "up (m/s), for particle velocities from 2639 to 7780 m/s"), ("U002", "range inferred: particle velocities up to 3763 m/s"),
                                         ("U058", "compared with states at particle velocities from 210 to 2946 m/s"), ("U008", "range not stated")])
def test_the_line_of_a_fit_says_where_its_data_begin(name, words):
    assert row_summary(schema.row(name)).endswith(words)


def test_low_density_polyethylene_is_not_the_dense_one():
    """The curated set is for 952 kg/m3; row U081 has the low-density polymer, 915 kg/m3."""
    with pytest.raises(DeckError):
        library.find("LDPE")
    assert library.find("HDPE").eos.rho0 == 952.0 and library.find("U081").eos.rho0 == 915.0


def test_alpha_iron_is_not_the_iron_above_its_transition():
    with pytest.raises(DeckError, match="alpha iron"):
        library.find("alpha iron")
