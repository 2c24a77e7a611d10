"""Materials the library makes of others: with a measured spall strength, porous ones of a row, and where the numbers come from."""

import pytest

from hugoniot.diagnostics.tension import spall_scale
from hugoniot.laws.eos.contract import pressure, reference_state
from hugoniot.materials import library, schema
from hugoniot.materials.record import material_record
from hugoniot.problem.deck import read_deck_text
from hugoniot.theory.hugoniot import shock


@pytest.mark.parametrize("name", [name for name in library.index() if library.spall_row(name)])
def test_a_variant_with_spall_is_its_material_and_a_measured_strength(name):
    plain, made = library.find(name), library.entry(f"{name.replace('_', ' ')} with spall")
    row = schema.row(library.spall_row(name))
    assert (made.material.eos, made.material.strength) == (plain.eos, plain.strength) and plain.fracture is None
    assert made.material.fracture.strength == row["spall_strength"] and made.missing
    assert row.id in made.rows and any(s.source == row.source for s in made.material.sources)
    assert abs(row["rho0"] / made.material.eos.rho0 - 1.0) < 0.02, "measured on another material"


def test_materials_without_a_measured_strength_say_which_have_one():
    with pytest.raises(library.UnknownMaterial, match="no measured spall strength for 'lead'.*tantalum"):
        library.find("lead with spall")
    assert library.find("copper with spall").fracture == library.find("copper").fracture
    assert {hit.name for hit in library.search("tantalum spall")} == {"tantalum with spall"}


def test_tension_is_judged_by_the_measured_strength_of_the_material():
    assert spall_scale("steel_304")[0] == schema.row(library.spall_row("steel_304"))["spall_strength"]


def test_a_porous_material_by_name_rests_at_its_density_and_crushes_onto_its_solid():
    porous = library.find("porous aluminium")
    rho, e = reference_state(porous.eos)
    assert rho == pytest.approx(2700.0 / 1.275, rel=1e-12) and abs(pressure(rho, e, porous.eos)) < 1.0
    state = shock(porous, pressure=5e9)
    assert state.specific_internal_energy == pytest.approx(0.5 * 5e9 * (1.0 / rho - 1.0 / state.density), rel=1e-9)
    assert pressure(state.density, state.specific_internal_energy, porous.eos.base) == pytest.approx(5e9, rel=1e-9)
    sources = {c["quantity"]: c["source"] for c in material_record(porous)}
    assert "Meyers" in sources["eos.base.c0"] and "Jutzi" in sources["eos.alpha0"]
    again = read_deck_text(read_deck_text('stop_time = "1 us"\n[[region]]\nname = "a"\nmaterial = "basalt p-alpha"\nfrom = "0 mm"\n'
                                          'to = "1 mm"\nzones = 10\n').resolved)
    assert again.problem.materials["basalt p-alpha"].eos == library.find("basalt_porous").eos


def test_a_porous_material_without_a_temperature_has_a_hugoniot():
    assert shock(library.find("basalt_porous"), pressure=1e9).temperature is None
