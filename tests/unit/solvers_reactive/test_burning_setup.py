"""What a burning problem is made of: closures, heat, start states, lighting, refusals; and the diagnostics of fronts."""

import dataclasses
import re
import tomllib

import numpy as np
import pytest

from hugoniot.diagnostics import detonation
from hugoniot.errors import DeckError, OutOfRange, UnphysicalState
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.burn.programmed import Programmed
from hugoniot.laws.burn.threshold import Threshold
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.mixture import build, reference_state
from hugoniot.materials import burning, library
from hugoniot.materials.material import Material
from hugoniot.problem.deck import read_deck_text
from hugoniot.problem.explosives import defects, programmed_bodies
from hugoniot.problem.model import Boundary, Lighting, Problem, Region, SolverOptions
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d import post_mortem, reactive
from hugoniot.solvers.lagrange1d.layout import B, Z
from hugoniot.theory import mixture as mixture_theory
from hugoniot.theory.chapman_jouguet import cj

GAS = IdealGas(3.0, 1000.0, 1600.0)
SLOW, FAST = (Material(name, GAS, burn=Programmed(speed), detonation_energy=4e6) for name, speed in (("slow", 4000.0), ("fast", 8000.0)))


def two_explosives(*lighting) -> Problem:
    regions = (Region("a", "slow", 0.0, 0.04, 4), Region("b", "fast", 0.04, 0.08, 4))
    return Problem("two", "planar", 1e-5, regions, {"slow": SLOW, "fast": FAST}, lighting=tuple(Lighting(*p) for p in lighting))


def test_closures_of_the_burn_laws():
    comp_b = library.find("comp_b")
    assert burning.closure(comp_b) == "burned_products" and burning.resting(comp_b) is comp_b.eos
    assert burning.heat_of(comp_b) == comp_b.eos.e0 / comp_b.eos.rho0
    lx17 = library.find("LX-17 reactive")
    assert burning.closure(lx17) == "thermal_isolation" and burning.resting(lx17) is lx17.unreacted
    rho, e = burning.start_state(lx17)
    assert (rho, e) == pytest.approx((1905.0, lx17.eos.e0 / lx17.eos.rho0), rel=1e-12)
    kb = Material("kb", GAS, burn=Threshold(2e10), unreacted=MieGruneisen(1770.0, 3080.0, 2.01, 1.0), detonation_energy=6.27e6)
    assert burning.closure(kb) == "weighted_pressures"


@pytest.mark.parametrize(("change", "words"), [
    ({"detonation_energy": None}, "no chemical energy"),
    ({"burn": Threshold(1e10)}, "unreacted"),
    ({"burn": Threshold(1e10), "mixture": "burned_products"}, "choose another mixture"),
    ({"burn": Threshold(1e10), "unreacted": GAS, "mixture": "thermal_isolation", "detonation_energy": -1.0}, "would release"),
])
def test_explosives_without_what_they_need_are_refused(change, words):
    with pytest.raises(OutOfRange, match=words):
        burning.reactive(dataclasses.replace(FAST, **change))


def test_a_front_runs_through_touching_explosives_each_at_its_speed():
    problem = two_explosives((0.02, 1e-6))
    assert programmed_bodies(problem) == [[0, 1]]
    zones, charge = np.zeros((len(Z), 8)), np.zeros((len(B), 8))
    places = [np.linspace(0.0, 0.04, 5), np.linspace(0.04, 0.08, 5)]
    reactive.prepare(problem, zones, charge, places, [(0, 4), (4, 8)])
    expected = 1e-6 + np.array([0.01 / 4000, 0, 0, 0.01 / 4000, 0.02 / 4000] + [0.02 / 4000 + k * 0.01 / 8000 for k in (1, 2, 3)])
    assert -charge[B.since] == pytest.approx(expected, rel=1e-12)
    assert charge[B.size] == pytest.approx(0.01)


@pytest.mark.parametrize(("problem", "words"), [
    (two_explosives(), "needs a lighting point"),
    (two_explosives((0.02, 0.0), (0.09, 0.0)), "move the lighting point into 'a' and 'b', 0 m to 80 mm"),
])
def test_defects_of_a_problem(problem, words):
    assert any(words in f"{message} {hint}" for _, message, hint in defects(problem))
    with pytest.raises(OutOfRange, match=words):
        reactive.check(problem)


DECK = """stop_time = "1 us"
{top}
[[region]]
name = "charge"
material = "comp_b"
from = "0 cm"
to = "1 cm"
zones = 10
{region}
"""


def test_a_deck_keeps_lighting_and_explosive():
    lit = 'lighting = [{at = "2 mm", time = "0.1 us"}, {at = "1 cm"}]'
    first = read_deck_text(DECK.format(top=lit, region=""))
    assert first.problem.lighting == (Lighting(2e-3, 1e-7), Lighting(1e-2, 0.0))
    assert read_deck_text(first.resolved).problem == first.problem
    mixed = ('[material.x]\nbase = "LX-17 reactive"\nmixture = "thermal_equilibrium"\ndetonation_energy = "4 MJ/kg"\n'
             '[material.x.unreacted]\nspecific_heat = 1200.0\n')
    deck = read_deck_text(DECK.format(top="", region=mixed).replace("comp_b", "x"))
    assert deck.problem.materials["x"].mixture == "thermal_equilibrium" and deck.problem.materials["x"].detonation_energy == 4e6
    assert deck.problem.materials["x"].unreacted.specific_heat == 1200.0
    assert read_deck_text(deck.resolved).problem == deck.problem


@pytest.mark.parametrize(("top", "region", "words"), [
    ("", "", "needs a lighting point"),
    ('lighting = [{at = "2 cm"}]', "", "lighting[1].at: no explosive with programmed burn at 20 mm"),
    ('lighting = [{at = "2 s"}]', "", "lighting[1].at"),
    ('lighting = [{at = 0.0}]', 'pressure = "1 GPa"', "region.charge.pressure"),
    ('lighting = [{at = 0.0}]', '[material.comp_b]\nbase = "comp_b"\nmixture = "thermal_isolaton"', "thermal_isolation"),
    ('lighting = [{at = 0.0}]', '[material.comp_b]\nbase = "comp_b"\ndetonation_energy = -1.0', "greater than 0"),
    ('', '[material.comp_b]\nbase = "copper"\n[material.comp_b.burn]\nlaw = "threshold"\ninitiation_pressure = "20 GPa"', "unreacted"),
])
def test_bad_decks_say_where_and_what(top, region, words):
    with pytest.raises(DeckError) as caught:
        read_deck_text(DECK.format(top=top, region=region))
    assert words in str(caught.value)


FROZEN = '[material.x]\nbase = "{base}"\nreference_state = "frozen"\n{more}'


def test_a_deck_keeps_the_choice_of_the_reference_state():
    deck = read_deck_text(DECK.format(top="", region=FROZEN.format(base="LX-17 reactive", more="")).replace("comp_b", "x"))
    assert deck.problem.materials["x"].reference_state == "frozen"
    assert read_deck_text(deck.resolved).problem == deck.problem


@pytest.mark.parametrize(("base", "more", "words"), [
    ("LX-17 reactive", 'mixture = "thermal_equilibrium"', "does not keep the reactants on an isentrope"),
    ("LX-17 reactive", 'mixture = "weighted_pressures"', "does not keep the reactants on an isentrope"),
    ("comp_b", "", "'burned_products' does not keep the reactants on an isentrope"),
    ("LX-17 reactive", '[material.x.burn]\nlaw = "threshold"\ninitiation_pressure = "20 GPa"', "does not keep the reactants on an isentrope"),
    ("LX-17 reactive", 'mixture = "thermal_isolation"\n[material.x.burn]\nlaw = "threshold"\ninitiation_pressure = "20 GPa"',
     "leaves no reactants behind a shock"),
    ("LX-17 reactive", 'mixture = "thermal_isolation"\n[material.x.burn]\nlaw = "programmed"\ndetonation_velocity = "7.6 km/s"',
     "leaves no reactants behind a shock"),
    ("copper", "", "applies only to a material that burns"),
])
def test_a_reference_state_is_frozen_only_where_reactants_have_one(base, more, words):
    with pytest.raises(DeckError) as caught:
        read_deck_text(DECK.format(top="", region=FROZEN.format(base=base, more=more)).replace("comp_b\"", "x\"", 1))
    assert words in str(caught.value) and any(word in str(caught.value) for word in ("leave", "omit"))


def test_an_unknown_reference_state_is_refused_in_decks_and_in_python():
    text = DECK.format(top="", region=FROZEN.format(base="LX-17 reactive", more="")).replace("comp_b", "x").replace("frozen", "frozn")
    with pytest.raises(DeckError, match="unknown reference state 'frozn'") as caught:
        read_deck_text(text)
    assert "frozen" in str(caught.value)
    with pytest.raises(OutOfRange, match="rolling, frozen"):
        burning.reactive(dataclasses.replace(library.find("LX-17 reactive"), reference_state="tracked"))


def test_the_detector_waits_for_the_shock_to_pass_and_begins_anew_with_the_next():
    stiffness = 1e10
    history = [(0.0, 0.0, 0.0), (5e3, 1.0, 0.0), (2e9, 4e9, 0.0), (3e7, 6e9, 0.0), (1e9, 8e9, 0.02), (0.0, 1.5e10, 0.03), (0.0, -1e9, 0.1)]
    code, codes = reference_state.NO_SHOCK, []
    for q, p, fraction in history:
        shocked = reference_state.is_passing(q, p, stiffness)
        code = reference_state.found_state(code, shocked, fraction)
        codes.append(code)
        assert reference_state.reactants_share(7.0, shocked, 1.0) == (7.0 if shocked else 0.0)
        assert reference_state.reactants_share(7.0, shocked, 0.0) == 7.0
    assert [reference_state.MEANING[code].split()[0] for code in codes] == ["with", "with", "with", "behind", "with", "while", "while"]
    assert codes == [0.0, 0.0, 1.0, 2.0, 1.0, 3.0, 3.0]


def test_a_run_tells_how_the_reference_state_was_found(tmp_path):
    import hugoniot
    deck = ('stop_time = "0.25 us"\n[[region]]\nname = "charge"\nmaterial = "x"\nfrom = "0 mm"\nto = "2 mm"\nzones = 80\n'
            '[boundary]\nleft = {velocity = "1.4 km/s"}\n[[gauge]]\nname = "1 mm"\nat = "1 mm"\n')
    place = tmp_path / "deck.toml"
    place.write_text(deck + FROZEN.format(base="LX-17 reactive", more=""))
    run = hugoniot.run(place, out=tmp_path / "run", report=False)
    rows = run.arrays("events")
    told = [text for kind, text in zip(rows["kind"], rows["text"]) if kind == "reference_state"]
    assert len(told) == 1 and told[0].startswith("reference state of the reactants of region 'charge' (frozen), by zones: ")
    assert "behind the shock" in told[0] and "0 while burning" not in told[0]


def test_a_front_slower_than_its_products_is_told():
    slow = '[material.comp_b]\nbase = "comp_b"\n[material.comp_b.burn]\ndetonation_velocity = "7 km/s"'
    warnings = read_deck_text(DECK.format(top="lighting = [{at = 0.0}]", region=slow)).warnings
    assert any("programmed front runs at 7000" in text and "7979" in text and "overtake it" in text for text in warnings)
    published = slow.replace("comp_b", "pbx_9502").replace("7 km/s", "7607.8 m/s")
    fast = read_deck_text(DECK.format(top="lighting = [{at = 0.0}]", region=published).replace("comp_b", "pbx_9502")).warnings
    assert any("7607.8" in text and "about 5.6 % below the CJ pressure" in text for text in fast)     # 5.55: roots of p(rho, e) on the Rayleigh line
    assert read_deck_text(DECK.format(top="lighting = [{at = 0.0}]", region="")).warnings == ()
    for speed, warned in ((7978.0, True), (7979.5, False), (7983.0, False), (7985.0, True)):     # -0.023, -0.004, 0.039, 0.065 % of 7979.85
        near = read_deck_text(DECK.format(top="lighting = [{at = 0.0}]", region=slow.replace("7 km/s", f"{speed} m/s"))).warnings
        assert any("programmed front runs at" in text for text in near) == warned


PRESSED = 'density = "1500 kg/m^3"\n'
BETA = '[material.x]\nbase = "comp_b"\n[material.x.burn]\nlaw = "beta"\nrho0 = "1717 kg/m^3"\nrho_cj = "2351 kg/m^3"'
GASEOUS = '[material.x.eos]\nlaw = "ideal_gas"\ngamma = 3.0\nrho0 = 1600.0\n[material.x]\ndetonation_energy = "5 MJ/kg"'


@pytest.mark.parametrize(("top", "region", "words"), [
    ("lighting = [{at = 0.0}]", PRESSED, "runs at 7980 m/s, but its products would drive one at 7167.7"),       # pressed to another density
    ("lighting = [{at = 0.0}]", '[material.comp_b]\nbase = "comp_b"\n[material.comp_b.burn]\ndetonation_velocity = "70 km/s"', "far below the CJ pressure"),
    ('lighting = [{at = 0.0}, {at = 0.0, time = "5 us"}]', "", "lighting point 2 fires at 5 us, after the end of the run"),
    ('lighting = [{at = 0.0, time = "-1 us"}]', "", "lighting point 1 fires 1 us before the run starts"),
    ("", 'density = "1800 kg/m^3"\n' + BETA, "starts at 1800 kg/m3, and its burn law 'beta' measures compression from rho0 = 1717"),
    ("", '[material.x]\nbase = "LX-17 reactive"\n[material.x.unreacted]\nlaw = "ideal_gas"\ngamma = 1.4', "'ignition_growth' measures compression from rho0 = 1905"),
    ("", '[material.x]\nbase = "LX-17 reactive"\ndetonation_energy = "5e12 J/kg"', "its equations of state give"),
    ("", GASEOUS, "has no burn law: its detonation_energy is not used"),
    ("", '[material.x]\nbase = "copper"\nmixture = "thermal_isolation"', "has no burn law: its mixture is not used"),
    ("lighting = [{at = 0.0}]", '[solver.viscosity]\nlaw = "limited"\nlinear = 1.0', "linear = 1 has no effect in 'comp_b', which burns by 'programmed' into 'burned_products'"),
])
def test_what_is_allowed_but_seldom_meant_is_told(top, region, words):
    text = DECK.format(top=top, region=region)
    found = read_deck_text(text.replace('"comp_b"\nfrom', '"x"\nfrom') if "[material.x]" in region else text).warnings
    assert any(words in told for told in found), found


@pytest.mark.parametrize(("closure", "warned"), [("thermal_isolation", True), ("thermal_equilibrium", True), ("weighted_pressures", False), ("two_state", False)])
@pytest.mark.parametrize("law", ["beta", "programmed_beta"])
def test_burning_by_compression_that_outruns_the_detonation_is_warned_of(law, closure, warned):
    """The speed of small waves that burn, c^2 = dp/drho + dp/dF dF/drho at F = 1e-4, is above D (24 and 12 km/s) exactly where warned."""
    lx17 = library.find("LX-17 reactive")
    point, mixed = cj(lx17), build.mixture(closure, lx17.unreacted, lx17.eos)
    rho0, e = burning.start_state(lx17)
    volume = 1.0 - rho0 / point.state.density
    rho = rho0 / (1.0 - 1e-4 * volume)
    state = mixture_theory.solve(rho, e, 1e-4, mixed, (rho0, e))
    speed = np.sqrt(state.sound_speed**2 + state.pressure_by_burn_fraction * rho0 / rho**2 / volume)
    assert (speed > point.detonation_velocity) == warned

    front = f', detonation_velocity = "{point.detonation_velocity} m/s"' if law == "programmed_beta" else ""
    material = (f'[material.x]\nbase = "LX-17 reactive"\nmixture = "{closure}"\n'
                f'burn = {{law = "{law}", rho0 = {rho0}, rho_cj = {point.state.density}{front}}}')
    text = DECK.format(top="lighting = [{at = 0.0}]" if front else "", region=material).replace('"comp_b"\nfrom', '"x"\nfrom')
    assert any("run ahead of the detonation" in told for told in read_deck_text(text).warnings) == warned


@pytest.mark.parametrize(("state", "warned"), [("1800", True), ("1890", False), ('1800, temperature = "300 K"', False)])
def test_an_explosive_of_low_density_is_said_to_be_hot_and_not_porous(state, warned):
    """The temperature at zero pressure by hand: p = 0 gives e, and e above the isentrope through (rho0, 298 K) gives T."""
    law = library.find("LX-17 reactive").unreacted
    terms = ((law.a, law.r1), (law.b, law.r2))

    def cold(v):      # (energy with e = 0 and p = 0 on the exponentials alone, energy of the isentrope up to c V^-omega)
        return (-sum(k * (1.0 - law.omega / (r * v)) * np.exp(-r * v) for k, r in terms) * v / (law.omega * law.rho0),
                sum(k / r * np.exp(-r * v) for k, r in terms) / law.rho0)

    v = 1905.0 / 1800.0
    (energy, own), (rest, first) = cold(v), cold(1.0)
    hot = 298.0 * v**-law.omega + (energy - own - (rest - first) * v**-law.omega) / law.specific_heat
    deck = f"""
stop_time = "1 us"
region = [{{name = "he", material = "LX-17 reactive", from = "0 cm", to = "1 cm", zones = 20, density = {state}}}]
"""
    found = [text for text in read_deck_text(deck).warnings if "has no pores" in text]
    assert len(found) == warned
    assert not warned or float(re.search(r"heated to (\S+) K", found[0])[1]) == pytest.approx(hot, rel=1e-3)


@pytest.mark.parametrize(("geometry", "lit", "told"), [("spherical", "1 cm", True), ("cylindrical", "7 mm", True), ("spherical", "5 mm", False), ("planar", "1 cm", False)])
def test_a_front_that_is_programmed_to_converge_is_told_with_the_law_to_take(geometry, lit, told):
    text = DECK.format(top=f'geometry = "{geometry}"\nlighting = [{{at = "{lit}"}}]', region="").replace('from = "0 cm"', 'from = "5 mm"')
    found = [warning for warning in read_deck_text(text).warnings if "real converging front would outrun" in warning]
    assert len(found) == told
    assert not told or 'law = "programmed_beta", rho0 = 1717, rho_cj = 2351' in found[0]
    for warning in found:
        assert read_deck_text(text + warning.split("use\n", 1)[1] + "\n").warnings == ()


def test_the_law_to_take_has_the_detonation_velocity_of_the_density():
    """The least velocity of a Rayleigh line that meets the detonation Hugoniot of the JWL set at 1800 kg/m3, by hand: 8249 m/s, not 7980."""
    law, v0 = library.find("comp_b").eos, 1.0 / 1800.0
    x = np.linspace(0.2, 0.35, 100_001) * v0
    v = law.rho0 * (v0 - x)
    cold = sum(k * (1.0 - law.omega / (r * v)) * np.exp(-r * v) for k, r in ((law.a, law.r1), (law.b, law.r2)))
    p = (cold + law.omega / (v0 - x) * law.e0 / law.rho0) / (1.0 - 0.5 * law.omega * x / (v0 - x))
    velocity = v0 * np.sqrt((p / x).min())

    text = DECK.format(top='geometry = "spherical"\nlighting = [{at = "1 cm"}]', region="density = 1800").replace('from = "0 cm"', 'from = "5 mm"')
    lines = next(text for text in read_deck_text(text).warnings if "real converging front would outrun" in text).split("use\n", 1)[1]
    assert float(re.search(r'detonation_velocity = "(\S+) m/s"', lines)[1]) == pytest.approx(velocity, rel=1e-5)
    assert read_deck_text(text + lines + "\n").warnings == ()


PAIR = """
stop_time = "5 us"
region = [{{name = "one", material = "{}", from = "0 cm", to = "1.5 cm", zones = 20}}, {{name = "two", material = "{}", from = "1.5 cm", to = "3 cm", zones = 20}}]
lighting = [{{at = "{}"}}]
solver.kind = "{}"
"""


@pytest.mark.parametrize(("first", "second", "lit", "weaker"), [
    ("comp_b", "tnt", "0 cm", "two"), ("comp_b", "tnt", "3 cm", ""), ("comp_b", "tnt", "1.5 cm", "two"), ("tnt", "comp_b", "3 cm", "one"),
    ("tnt", "comp_b", "0 cm", ""), ("comp_b", "comp_b", "0 cm", "")])
def test_a_front_that_passes_into_a_weaker_explosive_is_warned_of_with_lines_to_paste(first, second, lit, weaker):
    """CJ pressures of 29.5 and 21 GPa: the weaker was compressed to 46 GPa, or the run stopped. `fronts` follows the overdriven front."""
    text = PAIR.format(first, second, lit, "lagrange1d")
    found = [told for told in read_deck_text(text).warnings if "stronger products" in told]
    assert len(found) == bool(weaker) and all(f"into '{weaker}' (21 GPa)" in told for told in found)
    for told in found:
        assert not [again for again in read_deck_text(text + told.split(":\n", 1)[1] + "\n").warnings if "stronger" in again]
    assert not [told for told in read_deck_text(PAIR.format(first, second, lit, 'fronts"\nsolver.options.mode = "cells')).warnings if "stronger" in told]


@pytest.mark.parametrize("solver", ['[solver.viscosity]\nlaw = "limited"\nlinear = 0.3', '[solver.viscosity]\nlaw = "limited"\nlinear = 0',
                                    '[solver]\nintegrator = "wilkins"\n[solver.viscosity]\nlaw = "wilkins"\nlinear = 2.0'])
def test_a_linear_viscosity_that_is_the_default_or_acts_is_not_warned_of(solver):
    assert read_deck_text(DECK.format(top="lighting = [{at = 0.0}]", region=solver)).warnings == ()


def test_zones_crushed_before_a_front_lit_them_are_told_with_the_law_to_take():
    """What ended as a sound speed that is no number (nothing burned yet) or as tension (burned since), beside crushed zones."""
    region = Region("charge", "comp_b", 0.0, 0.02, 20)
    problem = Problem("x", "spherical", 1e-6, (region,), {"comp_b": library.find("comp_b")}, lighting=(Lighting(0.02),))
    zones, charge = np.zeros((len(Z), 20)), np.zeros((len(B), 20))
    zones[Z.peak_density] = 1.8 * 1717.0
    assert post_mortem.ill_burned(problem, zones, charge, np.zeros(20, int), 3) is None
    zones[Z.peak_density, 5] = 5000.0
    cause, remedy = post_mortem.ill_burned(problem, zones, charge, np.zeros(20, int), 3)
    assert "crushed, to 5000 kg/m3, before the programmed front lit them" in cause
    assert 'law = "programmed_beta", rho0 = 1717, rho_cj = 2351' in remedy


@pytest.mark.parametrize("law", ["copper", "aluminum_6061", "tungsten"])
def test_a_plate_at_rest_beside_explosive_that_is_not_lit_stays_in_contact(law):
    """Unlit explosive has neither pressure nor stiffness: a traction of round-off opened the interface in the first step."""
    regions = (Region("charge", "comp_b", 0.0, 0.02, 100), Region("plate", "plate", 0.02, 0.023, 30))
    materials = {"plate": dataclasses.replace(library.find(law), name="plate"), "comp_b": library.find("comp_b")}
    solver = make_solver(Problem("x", "planar", 3e-6, regions, materials, left=Boundary("fixed"), lighting=(Lighting(0.0),)))
    assert solver.march(1e-6, 10_000) == []


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_a_plate_that_crushes_an_explosive_before_it_is_lit_ends_the_run(integrator):
    """Without a pressure, unlit zones were pressed to 2.5e6 kg/m3 in steps of 6e-17 s: the run hung."""
    regions = (Region("plate", "copper", 0.0, 0.002, 20, velocity=1000.0), Region("charge", "comp_b", 0.002, 0.006, 80))
    materials = {"copper": dataclasses.replace(library.find("copper"), strength=None, fracture=None), "comp_b": library.find("comp_b")}
    solver = make_solver(Problem("x", "planar", 5e-6, regions, materials, solver=SolverOptions(integrator=integrator),
                                 lighting=(Lighting(0.006, 4e-6),)))
    with pytest.raises(UnphysicalState, match="crushed, .* before the programmed front lit them: what pushes them arrives earlier, such as a plate"):
        solver.march(3.5e-6, 2000)


@pytest.mark.parametrize("deck", ['[material.x]\nbase = "comp_b"\nburn = "none"', '[material.x]\nbase = "LX-17 reactive"\nburn = "none"',
                                  '[material.x]\nbase = "PBX-9404 reactive"\nmixture = "thermal_equilibrium"'])
def test_nothing_is_told_of_products_at_once_and_of_sets_as_they_are(deck):
    assert read_deck_text(DECK.format(top="", region=deck).replace('"comp_b"\nfrom', '"x"\nfrom')).warnings == ()


@pytest.mark.parametrize(("law", "words"), [
    ('law = "pressure_power"\nrate_constant = 1e6\npressure_exponent = 1.0\ndepletion_exponent = 1.0\nreference_pressure = 0.0', "reference_pressure must be positive"),
    ('law = "forest_fire"\ncoefficients = [1.0]\np_min = 1e9\np_max = 3e10\ntime_scale = 0.0', "pressure_scale and time_scale must be positive"),
])
def test_a_rate_of_no_unit_is_refused(law, words):
    deck = f'[material.x]\nbase = "LX-17 reactive"\n[material.x.burn]\n{law}'
    with pytest.raises(DeckError, match=words):
        read_deck_text(DECK.format(top="", region=deck).replace('"comp_b"\nfrom', '"x"\nfrom'))


# -- diagnostics ---------------------------------------------------------------------------------------------------
def travelling(speeds, n=200):
    """(times, field, left, right): a ramp two zones wide whose middle moves at the speeds given for each of 30 intervals."""
    left, right = np.arange(n) * 1e-3, np.arange(1, n + 1) * 1e-3
    times = np.arange(31) * 1e-7
    where = 0.01 + np.concatenate(([0.0], np.cumsum(np.asarray(speeds) * 1e-7)))
    centre = 0.5 * (left + right)
    field = np.clip(0.5 + (where[:, None] - centre) / 2e-3, 0.0, 1.0)
    return times, field, np.tile(left, (31, 1)), np.tile(right, (31, 1)), where


def test_front_path_and_speed_in_both_directions():
    times, field, left, right, where = travelling([5000.0] * 30)
    path = detonation.front_path(field, left, right)
    assert path == pytest.approx(where, abs=1e-9)
    assert detonation.front_speed(times, path) == pytest.approx(5000.0, rel=1e-6)
    mirrored = detonation.front_path(field[:, ::-1], -right[:, ::-1], -left[:, ::-1], toward="left")
    assert mirrored == pytest.approx(-where, abs=1e-9)
    assert np.isnan(detonation.front_path(np.zeros((1, 5)), left[:1, :5], right[:1, :5])).all()
    with pytest.raises(OutOfRange, match="more snapshots"):
        detonation.front_speed(times, path, start=1.0)


def test_run_distance_of_a_shock_that_turns_at_a_known_place():
    speeds = [3000.0] * 12 + [8000.0] * 18
    times, field, left, right, where = travelling(speeds)
    distance, time = detonation.run_to_detonation(times, detonation.front_path(field, left, right), 8000.0)
    assert distance == pytest.approx(where[12] - where[0], abs=3e-4) and time == pytest.approx(1.2e-6, abs=5e-8)
    with pytest.raises(OutOfRange, match="no run distance"):
        detonation.run_to_detonation(times, where[0] + 3000.0 * times, 8000.0)


def test_run_distance_with_the_entering_shock_given():
    times, field, left, right, where = travelling([3000.0] * 12 + [8000.0] * 18)
    path = detonation.front_path(field, left, right)
    assert detonation.run_to_detonation(times, path, 8000.0, 3000.0) == pytest.approx(detonation.run_to_detonation(times, path, 8000.0), rel=1e-2)
    with pytest.raises(OutOfRange, match="no run distance"):
        detonation.run_to_detonation(times, path, 14000.0, 3000.0)


def test_pop_line_returns_the_line_it_was_made_from():
    x = np.array([2e-3, 5e-3, 1e-2])
    p = 10.0 ** (1.11 - 0.66 * np.log10(x * 1e3)) * 1e9
    line = detonation.pop_line(p, x)
    assert (line.a, line.b) == pytest.approx((1.11, -0.66), rel=1e-9) and line.deviation < 1e-9
    assert line.distance(p) == pytest.approx(x, rel=1e-9)
    assert np.isnan(detonation.pop_line(p[:2], x[:2]).deviation)
    with pytest.raises(OutOfRange):
        detonation.pop_line([1e9], [1e-3])


def test_deviations_of_a_pop_line_are_those_of_many_noisy_ones():
    """Standard deviations of a and b as the scatter of 4000 lines through the same points with noise of 0.03 in log10 p."""
    noise, u = np.random.default_rng(5), np.linspace(0.0, 1.2, 8)
    lines = [detonation.pop_line(1e9 * 10.0 ** (1.1 - 0.6 * u + noise.normal(0.0, 0.03, 8)), 1e-3 * 10.0**u) for _ in range(4000)]
    for name, told in (("a", "a_deviation"), ("b", "b_deviation")):
        assert np.std([getattr(k, name) for k in lines]) == pytest.approx(np.sqrt(np.mean([getattr(k, told) ** 2 for k in lines])), rel=0.04)


def test_the_set_up_record_names_the_unreacted_explosive_with_its_own_sources():
    from hugoniot.output.setup_record import material_record

    material = library.find("LX-17 reactive")
    laws = {law["family"]: law for law in material_record(material)["laws"]}
    assert set(laws) == {"eos", "burn", "unreacted"}
    first = {family: next(c for c in laws[family]["constants"] if c["name"] == "a") for family in ("eos", "unreacted")}
    assert first["unreacted"]["value"] == material.unreacted.a and first["eos"]["value"] == material.eos.a
    assert first["unreacted"]["source"]


@pytest.mark.parametrize("law", BURN.names())
def test_every_burn_law_may_take_the_leapfrog(law):
    lx17 = dataclasses.replace(library.find("LX-17 reactive"), name="x", burn=BURN.get(law).example, mixture="weighted_pressures")
    if "temperature_driven" in BURN.get(law).flags:
        lx17 = dataclasses.replace(lx17, unreacted=GAS, eos=GAS, detonation_energy=4e6)
    problem = Problem("x", "planar", 1e-6, (Region("a", "x", 0.0, 0.04, 4),), {"x": lx17}, lighting=(Lighting(0.0),))
    if "programmed" not in BURN.get(law).flags:
        problem = dataclasses.replace(problem, lighting=())
    assert defects(dataclasses.replace(problem, solver=dataclasses.replace(problem.solver, integrator="wilkins"))) == []


def test_a_table_that_a_message_tells_to_write_is_toml():
    """[material.LX-17 reactive.unreacted] is not."""
    region = Region("charge", "LX-17 reactive", 0.0, 0.02, 4)
    problem = Problem("x", "planar", 1e-6, (region,), {"LX-17 reactive": library.find("LX-17 reactive")})
    (told,) = reactive.pulled(problem, np.full(4, 1e9), [(0, 4)])
    for header in re.findall(r"\[material[^]]*\]", told):
        assert "LX-17 reactive" in tomllib.loads(header)["material"]
    assert told.count("[material") == 2


def test_the_record_of_a_material_holds_the_laws_that_the_run_uses():
    """A programmed burn goes from no pressure to the products: its report listed and cited the unreacted explosive all the same."""
    from hugoniot.output.setup_record import material_record

    alone = material_record(library.find("comp_b"))
    assert [law["family"] for law in alone["laws"]] == ["eos", "burn"]
    assert not [source for source in alone["other_sources"] if source["quantity"].startswith("unreacted.")]
    mixed = material_record(dataclasses.replace(library.find("comp_b"), mixture="weighted_pressures"))
    assert [law["family"] for law in mixed["laws"]] == ["eos", "burn", "unreacted"]
