"""Materials from tables, for every registered law, and back."""

import pytest

from hugoniot.errors import DeckProblem
from hugoniot.laws import viscosity  # noqa: F401  (enrols the laws)
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials.collect import Collector
from hugoniot.materials.law_reader import read_law
from hugoniot.materials.read import build_material
from hugoniot.materials.tables import accepted, families, law_table, material_tables, same_parameters

LAWS = [(family, law.name) for family, registry in {**families(), "viscosity": VISCOSITY}.items() for law in registry]


def registry_of(family):
    return {**families(), "viscosity": VISCOSITY}[family]


@pytest.mark.parametrize("family, name", LAWS)
def test_the_example_of_every_law_survives_its_table(family, name):
    registry = registry_of(family)
    law = registry.get(name)
    problems: list[DeckProblem] = []
    again = read_law(registry, law_table(registry, law.example), Collector(problems, "f", lambda path: None), (family,))
    assert not problems
    assert same_parameters(again, law.example)


@pytest.mark.parametrize("family, name", LAWS)
def test_every_law_tells_each_missing_parameter(family, name):
    registry = registry_of(family)
    required = accepted(registry.get(name))[1]
    problems: list[DeckProblem] = []
    read_law(registry, {"law": name}, Collector(problems, "f", lambda path: None), (family,))
    assert [p.key for p in problems] == [f"{family}.{parameter}" for parameter in required]


def build(tables):
    problems: list[DeckProblem] = []
    return build_material("x", tables, problems, "file.toml", lambda path: len(path)), problems


EOS = {"law": "mie_gruneisen", "rho0": "2.7 g/cc", "c0": "5.2 km/s", "s": 1.5, "gamma0": 2.0}


def test_sources_and_range_are_kept():
    material, problems = build({"eos": EOS, "valid_up_to": "2 km/s", "sources": [
        "a report", {"quantity": "eos.c0", "value": 5200.0, "unit": "m/s", "source": "a paper", "status": "verified"}]})
    assert not problems and material is not None
    assert material.valid_up_to == 2000.0
    assert [s.source for s in material.sources] == ["a report", "a paper"]
    again, problems = build(material_tables(material))
    assert again == material and not problems


def test_a_law_inside_a_law_is_named_by_a_material():
    from hugoniot.materials import library

    porous = {"law": "p_alpha", "base": "copper", "alpha0": 1.3, "elastic_pressure": 1e8, "compaction_pressure": 1e9}
    material, problems = build({"eos": porous})
    assert not problems and material is not None and same_parameters(material.eos.base, library.find("copper").eos)
    around = {"law": "tension_cutoff", "base": {"law": "shifted_energy", "base": "copper", "shift": 1e5}, "tension": 1e9}
    assert same_parameters(build({"eos": around})[0].eos.base.base, library.find("copper").eos)
    none, problems = build({"eos": porous | {"base": "coper"}})
    assert none is None and [(p.key, "unknown material 'coper'" in p.message) for p in problems] == [("material.x.eos.base", True)]


def test_derived_parameters_are_saved_as_they_are():
    material, _ = build({"eos": EOS | {"gamma_form": "constant"}})
    assert material is not None and type(material.eos).__name__ == "MieGruneisenLinearGamma"
    assert build(material_tables(material))[0] == material


@pytest.mark.parametrize("tables, part", [
    ({}, "no equation of state"), ({"eos": 3}, "must be a table"), ({"eos": {}}, "missing"), ({"eos": EOS | {"c0": "5 km"}}, "expected a velocity"),
    ({"eos": EOS | {"c0": -5.0}}, "must be positive"), ({"eos": EOS, "strenght": {}}, "did you mean 'strength'?"),
    ({"eos": EOS, "fracture": {"law": "spall_stress", "strength": "-1 GPa"}}, "positive"),
    ({"eos": EOS, "strength": {"law": "perfectly_plastic", "shear_modulus": -1.0, "yield_stress": 1.0}}, "must not be negative"),
    ({"eos": EOS, "strength": {"law": "johnson_cook", "shear_modulus": 46e9, "yield_stress": 9e7, "hardening_coefficient": 2.9e8,
                               "hardening_exponent": 0.31, "rate_coefficient": 0.025, "thermal_exponent": 1.09, "room_temperature": 294.0,
                               "melt_temperature": 1356.0}}, "needs temperatures"),
    ({"eos": EOS, "valid_up_to": "2 km"}, "expected a velocity"), ({"eos": EOS, "sources": [3]}, "as a string or a table"),
    ({"base": "coper"}, "copper"), ({"eos": {"law": "ideal_gas", "gamma": 0.5}}, "must be greater than 1"),
    ({"eos": {"law": "polynomial", "rho0": 2700.0, "a": -73e9, "b": 0.0, "c": 0.0, "d": 1.6}}, "no real sound speed in the reference state"),
    ({"eos": {"law": "ideal_gas", "gamma": 1.4, "specific_heat": 0.0}}, "a specific heat must be positive, got 0"),
])
def test_what_is_wrong_is_collected_with_a_way_out(tables, part):
    material, problems = build(tables)
    assert material is None
    assert any(part in f"{p.message}; {p.hint}" for p in problems), problems
    assert all(p.file == "file.toml" and p.line for p in problems)
