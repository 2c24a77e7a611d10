"""A deck to a problem, and back to the same bits."""

import dataclasses
import tomllib

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hugoniot.errors import DeckError, FileTrouble
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials import library
from hugoniot.problem import catalogue
from hugoniot.problem.deck import read_deck, read_deck_text, write_deck
from hugoniot.problem.defaults import completed
from hugoniot.problem.model import Boundary, Gauge, Interface, Pulse

REGION = '[[region]]\nname = "a"\nmaterial = "m"\nfrom = 0.0\nto = {to}\n{more}\n'
MATERIAL = '[material.m.eos]\nlaw = "mie_gruneisen"\nrho0 = 2700\nc0 = 5200.0\ns = 1.5\ngamma0 = 2.0\nspecific_heat = 900.0\n'


def deck(more="zones = 10", to="1.0", top="", end=""):
    return f'stop_time = "1 us"\n{top}\n' + REGION.format(to=to, more=more) + MATERIAL + end


def problem(*args, **kwargs):
    return read_deck_text(deck(*args, **kwargs)).problem


def test_quantities_become_si_and_defaults_are_filled_in():
    p = read_deck_text(catalogue.deck_text("flyer"), "flyer.toml").problem
    flyer, target = p.regions
    assert (p.stop_time, flyer.start, flyer.end, flyer.zones, flyer.velocity, target.velocity) == (2.5e-6, 0.0, 0.002, 200, 700.0, 0.0)
    assert flyer.end == target.start
    eos = p.materials["al"].eos
    assert isinstance(eos, MieGruneisen) and eos[:4] == (2700.0, 5200.0, 1.5, 2.0)
    assert p.materials["al"].strength._asdict() == {"shear_modulus": 24.8e9, "yield_stress": 0.3e9}
    assert p.gauges[-2:] == (Gauge("free surface", "free surface right"), Gauge("free surface left", "free surface left"))
    assert p.output.snapshots == 2e-8 and p.solver.integrator == "compatible"


@pytest.mark.parametrize("name", [entry.name for entry in catalogue.problems()])
def test_resolved_decks_read_back_to_the_same_bits(name):
    first = read_deck_text(catalogue.deck_text(name), f"{name}.toml")
    again = read_deck_text(first.resolved, "again")
    assert again.problem == first.problem
    assert again.resolved == first.resolved


@pytest.mark.parametrize("name", library.names())
def test_every_material_of_the_library_survives_a_resolved_deck(name):
    try:
        lit = "lighting = [{at = 0.0}]\n" if library.find(name).burn is not None else ""
        first = read_deck_text('stop_time = 1e-6\n' + lit + REGION.format(to=1.0, more="zones = 2").replace('"m"', f'"{name}"'))
    except DeckError as error:  # a library material may lack an equation of state, never its explanation
        assert "region.a.material" in str(error)
        return
    assert read_deck_text(first.resolved).problem == first.problem


@settings(max_examples=60)
@given(numbers=st.lists(st.floats(1e-9, 1e9), min_size=5, max_size=5), zones=st.integers(1, 10**6),
       title=st.text(st.characters(exclude_categories=("Cc", "Cs")), max_size=40), name=st.text(st.characters(exclude_categories=("C", "Z"), exclude_characters="/:"), min_size=1, max_size=20))
def test_any_problem_survives_being_saved(numbers, zones, title, name):
    base = problem()
    width, stop, speed, pressure, start = numbers
    speed = min(speed, 1e8)
    region = dataclasses.replace(base.regions[0], name=name, end=width, zones=zones, velocity=(speed, -speed), pressure=pressure)
    left = Boundary("pressure", Pulse("table", times=(0.0, start), values=(pressure, -speed)))
    saved = dataclasses.replace(base, title=title or "x", stop_time=stop, regions=(region,), left=left,
                                output=dataclasses.replace(base.output, snapshots=(stop / 3.0, stop)))
    try:
        again = read_deck_text(write_deck(saved)).problem
    except DeckError as error:
        assert "squared sound speed" in str(error) or "does not reach" in str(error) or "not a valid state" in str(error), error
        return
    assert again == saved


def test_zone_size_and_ratio_give_the_number_of_zones():
    assert problem('zone_size = "10 mm"').regions[0].zones == 100
    assert problem('zone_size = "10 cm"\nratio = 1.1').regions[0].zones == 7  # 0.1 (1.1^7 - 1)/0.1 = 0.949, nearest to 1
    graded = problem('zone_size = "200 mm"\nratio = 0.9').regions[0]
    assert sum(0.2 * 0.9**k for k in range(graded.zones)) == pytest.approx(1.0, abs=0.1)
    with pytest.raises(DeckError, match="fill only 500 mm"):
        problem('zone_size = "50 mm"\nratio = 0.9')


def test_touching_ends_are_made_equal_and_gaps_kept():
    second = '[[region]]\nname = "b"\nmaterial = "m"\nfrom = {}\nto = 2.0\nzones = 10\n'
    p = problem(end=second.format(repr(1.0 + 1e-13)))
    assert p.regions[0].end == p.regions[1].start
    gap = problem(end=second.format(1.25))
    assert gap.regions[1].start == 1.25


def test_regions_are_ordered_by_position():
    second = '[[region]]\nname = "b"\nmaterial = "m"\nfrom = -1.0\nto = 0.0\nzones = 10\n'
    p = problem(end=second + '[[interface]]\nbetween = ["a", "b"]\nkind = "bond"\nstrength = "1 GPa"\n')
    assert [r.name for r in p.regions] == ["b", "a"]
    assert p.interfaces == (Interface("b", "a", "bond", 1e9),)


@pytest.mark.parametrize("text, expected", [
    ('"fixed"', Boundary("fixed")), ('"transmitting"', Boundary("transmitting")),
    ('{velocity = "10 m/s"}', Boundary("velocity", Pulse("constant", 10.0))),
    ('{pressure = {shape = "half_sine", amplitude = "1 GPa", duration = "2 us"}}', Boundary("pressure", Pulse("half_sine", 1e9, 0.0, 2e-6))),
    ('{pressure = {times = ["0 us", "1 us"], values = ["1 GPa", 0]}}', Boundary("pressure", Pulse("table", times=(0.0, 1e-6), values=(1e9, 0.0)))),
])
def test_boundaries(text, expected):
    assert problem(end=f"[boundary]\nleft = {text}\n").left == expected


def test_a_word_written_as_a_table_of_a_boundary_is_answered_with_the_right_form():
    with pytest.raises(DeckError) as told:
        problem(end='[boundary.right]\nkind = "transmitting"\n')
    assert [str(p) for p in told.value.problems][0].endswith(
        "boundary.right: 'transmitting' must be given as a string, not in a table; write [boundary] with right = \"transmitting\"")
    assert len(told.value.problems) == 1


def test_a_deck_with_a_table_for_a_sweep_names_the_command_that_runs_it():
    with pytest.raises(DeckError, match="sweep: only hugoniot sweep runs a deck with this table"):
        problem(end='[sweep]\nvary = ["stop_time = 1..2 us : 2"]\n')


def test_the_centre_needs_no_boundary():
    assert problem(top='geometry = "spherical"').left == Boundary("fixed")
    assert problem(top='geometry = "planar"').left == Boundary("free")


def test_a_base_material_is_overridden_number_by_number():
    text = deck(end='[material.c]\nbase = "copper"\nfracture = "none"\n[material.c.eos]\nc0 = "4 km/s"\n').replace('material = "m"', 'material = "c"')
    found = read_deck_text(text).problem.materials["c"]
    base = library.find("copper")
    assert found.eos == base.eos._replace(c0=4000.0)
    assert found.strength == base.strength and found.fracture is None
    told = {source.quantity for source in found.sources}
    assert "eos.rho0" in told and "eos.c0" not in told


def test_forgotten_units_are_warned_of():
    text = deck(end="").replace("rho0 = 2700", "rho0 = 8.19").replace("c0 = 5200.0", "c0 = 4.6")
    found = [w for w in read_deck_text(text).warnings if "A bare number is SI" in w]
    assert len(found) == 2 and '"8.19 g/cm^3"' in found[0] and '"4.6 km/s"' in found[1]
    heavy = read_deck_text(deck(end="").replace("rho0 = 2700", "rho0 = 2.7e6")).warnings
    assert any("2.7e+06 kg/m^3 for a solid or liquid? No known material" in w for w in heavy)
    for name in library.names():
        lit = "lighting = [{at = 0.0}]\n" if library.find(name).burn is not None else ""
        plain = 'stop_time = 1e-6\n' + lit + REGION.format(to=1.0, more="zones = 2").replace('"m"', f'"{name}"')
        assert not any("for a solid or liquid?" in w for w in read_deck_text(plain).warnings), name


def test_a_porous_law_takes_a_material_of_the_library_as_its_solid():
    porous = '[material.m.eos]\nlaw = "p_alpha"\nbase = "{base}"\nalpha0 = 1.3\nelastic_pressure = 1e8\ncompaction_pressure = 1e9\n'
    text = 'stop_time = "1 us"\n' + REGION.format(to="1.0", more="zones = 10") + porous
    first = read_deck_text(text.format(base="copper"))
    assert first.problem.materials["m"].eos.base == library.find("copper").eos
    assert read_deck_text(first.resolved).problem == first.problem
    with pytest.raises(DeckError, match="unknown material 'coper'; .*copper"):
        read_deck_text(text.format(base="coper"))


def test_unused_materials_and_mass_jumps_are_warned_of():
    second = '[[region]]\nname = "b"\nmaterial = "m"\nfrom = 1.0\nto = 2.0\nzones = 1000\n'
    warnings = read_deck_text(deck(end=second + MATERIAL.replace("material.m", "material.spare"))).warnings
    assert any("'spare'" in w for w in warnings) and any("factor of 100" in w for w in warnings)


@pytest.mark.parametrize(("more", "message"), [("zons = 10", "region.a.zons: unknown key; did you mean 'zones'?"), ("zones = 0", "region.a.zones: must be")])
def test_what_refers_to_a_region_that_could_not_be_read_is_no_second_mistake(more, message):
    second = '[[region]]\nname = "b"\nmaterial = "n"\nfrom = 1.0\nto = 2.0\nzones = 10\n' + MATERIAL.replace("material.m", "material.n")
    refers = '[[interface]]\nbetween = ["a", "b"]\nkind = "separable"\n[[gauge]]\nname = "g"\nat = 0.5\n[[gauge]]\nname = "h"\nat = "a/b"\n'
    with pytest.raises(DeckError) as told:
        read_deck_text(deck(more=more, end=second + refers))
    assert len(told.value.problems) == 1 and message in str(told.value)
    with pytest.raises(DeckError, match=r"no region 'c'") as told:
        read_deck_text(deck(more=more, end=second + refers.replace('["a", "b"]', '["a", "c"]')))
    assert len(told.value.problems) == 2


def test_changes_may_be_numbers_and_arrays_of_numpy(tmp_path):
    path = tmp_path / "d.toml"
    path.write_text(deck())
    changes = {"region.a.zones": np.int64(7), "stop_time": np.float32(2.0), "region.a.velocity": np.array([1.0, 2.0]), "output.snapshots": (0.5, np.int64(1))}
    p = read_deck(path, changes).problem
    assert (p.regions[0].zones, p.stop_time, p.regions[0].velocity, p.output.snapshots) == (7, 2.0, (1.0, 2.0), (0.5, 1.0))


def test_a_file_that_is_no_deck_is_not_read_to_its_end(tmp_path):
    path = tmp_path / "result.toml"
    with path.open("wb") as file:
        file.truncate(10**12)
    with pytest.raises(DeckError, match="a TOML deck cannot have more than [0-9 ]+ characters; is this the right file"):
        read_deck(path)


def test_overrides_reach_regions_by_name_and_are_checked(tmp_path):
    path = tmp_path / "d.toml"
    path.write_text(deck())
    p = read_deck(path, {"region.a.velocity": "3 km/s", "solver": {"courant": 0.25}, "stop_time": 2e-6}).problem
    assert (p.regions[0].velocity, p.solver.courant, p.stop_time) == (3000.0, 0.25, 2e-6)
    with pytest.raises(DeckError, match="region.a.velocity: expected a velocity"):
        read_deck(path, {"region.a.velocity": "3 km"})
    with pytest.raises(DeckError, match="no such key to override"):
        read_deck(path, {"region.b.velocity": 3.0})


def test_only_values_that_the_file_gives_have_a_line(tmp_path):
    path = tmp_path / "d.toml"
    path.write_text(deck())
    for overrides, key in (({"region.a.velocity": "3 km"}, "region.a.velocity"), ({"solver": {"courant": "x"}}, "solver.courant")):
        with pytest.raises(DeckError) as caught:
            read_deck(path, overrides)
        assert [(p.line, p.key) for p in caught.value.problems] == [(None, key)]
    path.write_text(deck("zones = 0"))
    with pytest.raises(DeckError) as caught:
        read_deck(path, {"region.a.velocity": "3 km/s"})
    assert all(p.line is not None for p in caught.value.problems)


def test_an_end_of_the_bodies_is_guessed_from_its_words():
    with pytest.raises(DeckError, match="unknown place 'right surface'; did you mean 'free surface right'"):
        read_deck_text(deck_of_copper() + '[[gauge]]\nname = "g"\nat = "right surface"\n')


def test_an_override_reaches_a_constant_of_a_library_material():
    """The deck names copper without a table of its own: the other constants stay those of the library."""
    text = deck_of_copper()
    found = read_deck_text(text, overrides={"material.copper.strength.yield_stress": "0.5 GPa"}).problem.materials["copper"]
    plain = read_deck_text(text).problem.materials["copper"]
    assert found.strength == plain.strength._replace(yield_stress=0.5e9) and found.eos == plain.eos


def deck_of_copper():
    return 'stop_time = "1 us"\n[[region]]\nname = "a"\nmaterial = "copper"\nfrom = "0 mm"\nto = "1 mm"\nzones = 4\n'


def test_a_text_for_a_flag_or_a_number_is_quoted():
    for line, message in (('zones = "4"', "expected a whole number, got '4'; omit the quotes"), ('[output]\nreport = "yes"', "expected true or false, got 'yes'")):
        with pytest.raises(DeckError, match=message):
            read_deck_text(deck_of_copper().replace("zones = 4", "") + line)


def test_a_missing_file_names_the_decks_that_are_there(tmp_path):
    (tmp_path / "flyer.toml").write_text("")
    with pytest.raises(FileTrouble, match="decks here: flyer.toml"):
        read_deck(tmp_path / "flier.toml")


def test_the_resolved_deck_is_plain_toml_in_si():
    tables = tomllib.loads(read_deck_text(catalogue.deck_text("flyer"), "flyer.toml").resolved)
    assert tables["region"][0]["to"] == 0.002 and tables["solver"]["growth"] == 1.1 and tables["boundary"] == {"left": "free", "right": "free"}


def test_a_run_that_burns_takes_the_viscosity_of_detonation_products():
    """(gamma + 1)/4 is 2/3 in a monatomic gas and in most metals, 1 in products; the resolved deck says which."""
    for template, quadratic, condensed in (("flyer", 2.0 / 3.0, 1.0), ("detonation", 1.0, 1.0)):
        whole = read_deck_text(catalogue.deck_text(template)).problem
        assert whole.solver.viscosity == ("limited", {"quadratic": quadratic, "linear": 0.3, "linear_condensed": condensed})
        assert read_deck_text(write_deck(whole)).problem.solver.viscosity == whole.solver.viscosity


@pytest.mark.parametrize(("given", "linear", "condensed"), [
    ("linear = 0.1", 0.1, 0.1), ("linear = 0.1\nlinear_condensed = 0.7", 0.1, 0.7), ("linear_condensed = 0.7", 0.3, 0.7), ("", 0.3, 1.0),
    ("parameters = {linear = 0.1}", 0.1, 0.1)])
@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_a_linear_viscosity_given_alone_holds_in_every_material(given, linear, condensed, integrator):
    text = deck(end=f'[solver]\nintegrator = "{integrator}"\n[solver.viscosity]\nlaw = "limited"\n{given}\n')
    whole = read_deck_text(text)
    assert dict(whole.problem.solver.viscosity[1]) == {"quadratic": 2.0 / 3.0, "linear": linear, "linear_condensed": condensed}
    assert read_deck_text(whole.resolved, "deck.toml").resolved == whole.resolved


def test_a_linear_viscosity_of_a_problem_made_in_python_holds_in_every_material():
    whole = read_deck_text(catalogue.deck_text("flyer")).problem
    given = dataclasses.replace(whole, solver=dataclasses.replace(whole.solver, viscosity=("limited", {"linear": 0.1})))
    assert completed(given).solver.viscosity[1]["linear_condensed"] == 0.1
    assert completed(completed(given)) == completed(given)


@pytest.mark.parametrize("solver", ['kind = "lagrange1d"\n[solver.viscosity]\nlaw = "wilkins"',
                                    'integrator = "wilkins"\n[solver.viscosity]\nlaw = "landshoff"',
                                    '[solver.viscosity]\nlaw = "kb"', 'kind = "fronts"\n[solver.viscosity]\nlaw = "limited"'])
def test_only_the_limited_viscosity_has_a_coefficient_of_condensed_material(solver):
    with pytest.raises(DeckError, match="unknown key"):
        read_deck_text(deck(end=f"[solver]\n{solver}\nlinear_condensed = 0.5\n"))


def test_a_deck_with_a_wrong_solver_is_told_what_every_solver_would_refuse():
    text = catalogue.deck_text("flyer")
    text = text.replace("\nstop_time", "\nstop_tme", 1) + "\n[solvr]\nx = 1\n[material.bad.eos]\nlaw = \"mie_grneisen\"\n"
    text = text.replace("\n[solver]", "\n[solver]\nkind = \"lagrange7d\"", 1)
    with pytest.raises(DeckError) as told:
        read_deck_text(text, "deck.toml")
    found = {p.key: p.message for p in told.value.problems}
    assert found["solver.kind"] == "unknown solver 'lagrange7d'" and found["stop_tme"] == found["solvr"] == "unknown key"
    assert "stop_time" in found and "unknown eos law" in found["material.bad.eos.law"]
