"""The pages of the laws: what they show as an example of a deck is read back as the law's own example."""

import dataclasses
import importlib.util
import tomllib
from pathlib import Path

import numpy as np
import pytest

from hugoniot.materials.burning import reactive
from hugoniot.materials.read import build_material

SCRIPT = Path(__file__).parents[3] / "docs" / "generate_laws.py"


@pytest.fixture(scope="module")
def pages():
    spec = importlib.util.spec_from_file_location("generate_laws", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(SCRIPT.parent)      # it imports the script beside it
        spec.loader.exec_module(module)
    return module


def flat(par):
    """Numbers of a parameter tuple, of laws inside it too."""
    return [x for value in par for x in (flat(value) if isinstance(value, tuple) else [value])]


def test_the_deck_of_a_page_gives_its_example(pages):
    read = set()
    for law in pages.EOS:
        lines = pages.deck_lines(law, law.example, "material.x.eos")
        if lines is None:
            continue
        problems = []
        found = build_material("x", tomllib.loads("\n".join(lines))["material"]["x"], problems, "page", lambda key: None)
        assert found is not None and not problems, (law.name, problems)
        assert type(found.eos) is type(law.example), law.name
        np.testing.assert_allclose(flat(found.eos), flat(law.example), rtol=1e-12, err_msg=law.name)
        read.add(law.name)
    assert {law.name for law in pages.EOS} - read == {name for name in pages.WRITTEN if name in pages.EOS.names()}


def test_decks_written_by_hand_are_read(pages):
    for name, lines in pages.WRITTEN.items():
        [(material, tables)] = tomllib.loads("\n".join(lines))["material"].items()
        if burns := "burn" in tables:
            tables = {"eos": {"law": "ideal_gas", "gamma": 3.0}, **tables}
        problems = []
        found = build_material(material, tables, problems, "page", lambda key: None)
        assert found is not None and not problems, (name, problems)
        law = pages.BURN.get(name) if burns else pages.EOS.get(name)
        assert type(found.burn if burns else found.eos) is type(law.example), name
        if burns:
            np.testing.assert_allclose(flat(found.burn), flat(law.example), rtol=1e-12, err_msg=name)


def test_the_deck_of_a_mixture_gives_its_example(pages):
    for law in pages.MIXTURE:
        problems = []
        found = build_material("explosive", tomllib.loads("\n".join(pages.mixture_lines(law)))["material"]["explosive"], problems, "page",
                               lambda key: None)
        assert found is not None and not problems and found.mixture == law.name, (law.name, problems)
        np.testing.assert_allclose(flat(found.eos), flat(law.example.products), rtol=1e-12, err_msg=law.name)
        if "reactants" in law.parameters._fields:
            np.testing.assert_allclose(flat(found.unreacted), flat(law.example.reactants), rtol=1e-12, err_msg=law.name)
            assert found.detonation_energy == law.example.detonation_energy
        burn = pages.BURN.get("programmed" if "no_reactants" in law.flags else "pressure_power").example
        reactive(dataclasses.replace(found, burn=burn))      # raises where a run would refuse the material
    np.testing.assert_allclose(pages.EOS.get("mie_gruneisen_cold_series").example[:8],
                               build_material("x", tomllib.loads("\n".join(pages.WRITTEN["mie_gruneisen_cold_series"]))["material"]["copper"],
                                              [], "page", lambda key: None).eos[:8], rtol=1e-12)


def test_every_page_tells_equation_parameters_validity_and_source(pages):
    for family, registry in pages.REGISTRIES.items():
        for law in registry:
            text = pages.page(law, None)
            assert "## Parameters" in text and "## References" in text and law.summary in text, law.name
            assert all(f"`{name}`" in text for name in pages.accepted(law)[0]), law.name
            assert "$$" in text or law.name == "none", law.name
            assert family != "eos" or "gives the limit" in text, law.name


def test_the_page_of_tables_says_what_a_file_replaces(pages):
    law = pages.EOS.get("table")
    rows = {line.split("`")[1]: line for line in pages.page(law, None).splitlines() if line.startswith("| `")}
    assert "optional" in rows["file"]
    assert {name for name, row in rows.items() if "required without `file`" in row} == set(pages.accepted(law)[1])
    assert not any("| required |" in row for row in rows.values())
