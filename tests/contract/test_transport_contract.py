"""Every registered transport and conduction law: its example works over its box, in Python and compiled."""

import math

import numpy as np
import pytest

from hugoniot.laws import transport  # noqa: F401
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT, conductivity, make, viscosity

LAWS = [*TRANSPORT, *CONDUCTION]


@pytest.mark.parametrize("law", LAWS, ids=lambda law: f"{law.family}-{law.name}")
def test_example_is_documented_and_cited(law):
    assert law.references and law.summary.endswith(".")
    assert set(law.units) == set(law.parameters._fields) == set(law.meaning)
    for name, value in zip(law.parameters._fields, law.example):
        assert value > 0.0, name


@pytest.mark.parametrize("law", list(TRANSPORT), ids=lambda law: law.name)
def test_viscosity_is_positive_smooth_and_grows_with_temperature(law):
    low, high = law.box["T"]
    temperatures = np.geomspace(low, high, 60)
    mu = np.array([viscosity(1.0, T, law.example) for T in temperatures])
    assert np.all(mu > 0.0) and np.all(np.diff(mu) >= 0.0)
    depends = not np.all(mu == mu[0])
    assert depends == ("needs_temperature" in law.flags)
    if not depends:
        assert viscosity(1.0, math.nan, law.example) == mu[0]   # works with laws that have no temperature


@pytest.mark.parametrize("law", list(CONDUCTION), ids=lambda law: law.name)
def test_conductivity_is_not_negative_and_none_is_none(law):
    for T in np.geomspace(*law.box["T"], 20):
        k = conductivity(1.0, T, 2e-5, 520.0, law.example)
        assert (k == 0.0) if law.name == "none" else (k > 0.0 and math.isfinite(k))


@pytest.mark.parametrize("law", list(TRANSPORT), ids=lambda law: law.name)
def test_a_table_makes_the_example(law):
    assert make({"law": law.name, **law.example._asdict()}).shear == law.example
