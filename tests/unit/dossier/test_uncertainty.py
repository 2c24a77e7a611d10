"""What the library knows of its constants' uncertainty: the covariance of fits and of sources, and what it does not know."""

from dataclasses import replace

import numpy as np
import pytest

from hugoniot.dossier import fits
from hugoniot.dossier.uncertainty import uncertainty_of
from hugoniot.materials import library, schema


def covariance(found, names):
    """Of the directions."""
    shifts = np.array([[direction.shifts.get(name, 0.0) for name in names] for direction in found.directions])
    return shifts.T @ shifts


def test_constants_of_several_sources_have_the_covariance_of_the_sources():
    found = uncertainty_of(library.entry("copper"))
    rows = [schema.row(identity) for identity in ("U007", "U194", "U202")]     # U058 repeats the Hugoniot of U007
    values = np.array([[row["c0"], row["s"]] for row in rows])
    assert np.allclose(covariance(found, ["eos.c0", "eos.s"]), np.cov(values.T), rtol=1e-9)
    assert found.deviations["eos.c0"] == pytest.approx(values[:, 0].std(ddof=1))
    gammas = [schema.row(identity)["gamma0"] for identity in ("U007", "U058", "U194")]     # its Gamma is its own
    assert found.deviations["eos.gamma0"] == pytest.approx(np.std(gammas, ddof=1))
    assert covariance(found, ["eos.c0", "eos.s"])[0, 1] < 0.0      # a line through the same states: higher where it is flatter


@pytest.mark.parametrize("name, row, names", [("fused_silica", "U212", ["eos.c0", "eos.s"]), ("water", "U205", ["eos.c0", "eos.s1", "eos.s2"])])
def test_constants_of_a_fit_have_its_covariance(name, row, names):
    found = uncertainty_of(library.entry(name))
    assert np.allclose(covariance(found, names), fits.recorded(row).covariance, rtol=1e-9)
    assert found.deviations["eos.c0"] == pytest.approx(schema.row(row)["c0_deviation"], rel=1e-4)


def test_what_the_library_does_not_know_is_listed():
    found = uncertainty_of(library.entry("copper"))
    assert "fracture.strength" in found.unknown and found.unknown["fracture.strength"].startswith("one source")
    assert not set(found.unknown) & set(found.deviations)
    assert any(words.startswith("S042: ") for words in found.left_out)        # marked DOUBT
    assert any("density differs" in words for words in uncertainty_of(library.entry("gabbroic_anorthosite")).left_out)


def test_constants_that_a_deck_gives_are_its_own():
    entry = library.entry("copper")
    eos = entry.material.eos
    own = replace(entry.material, eos=eos._replace(gamma0=1.9))
    found = uncertainty_of(entry, own)
    assert found.unknown["eos.gamma0"] == "given by the deck" and "eos.gamma0" not in found.deviations
    assert found.deviations["eos.c0"] == uncertainty_of(entry).deviations["eos.c0"]


def test_every_material_of_the_library_has_an_answer():
    some = 0
    for entry in library.find_all():
        found = uncertainty_of(entry)
        some += bool(found.directions)
        assert all(value > 0.0 for value in found.deviations.values())
    assert some >= 40
