"""A law added as the architecture page shows: the page's own code keeps the contract and runs, also after other runs of the process."""

import importlib
import math
import pathlib
import re
import sys

import numpy as np
import pytest
import test_eos_arrays as in_kernels
import test_eos_laws as in_python

import hugoniot
from hugoniot.core import binder
from hugoniot.laws import arrays
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "architecture.md"
DECK = """
title = "Impact of two bodies of the page's law"
geometry = "planar"
stop_time = "2 us"
[[region]]
name = "flyer"
material = "m"
from = "0 mm"
to = "5 mm"
zones = 100
velocity = "100 m/s"
[[region]]
name = "target"
material = "m"
from = "5 mm"
to = "10 mm"
zones = 100
[material.m.eos]
law = "acoustic"
rho0 = "1000 kg/m^3"
c0 = "1500 m/s"
[[gauge]]
name = "inside"
at = "6 mm"
[output]
report = false
"""


def recipe():
    """The first Python block of the page's section on adding a law."""
    section = PAGE.read_text(encoding="utf-8").split("## Adding a law")[1]
    return re.search(r"```python\n(.*?)```", section, re.S).group(1)


@pytest.fixture
def file_of_a_user(tmp_path, monkeypatch):
    """A function that imports a text as a file beside a user's script; laws it enrols are taken out again."""
    before = set(EOS.names())
    monkeypatch.syspath_prepend(tmp_path)
    written = []

    def write(name, text):
        (tmp_path / f"{name}.py").write_text(text, encoding="utf-8")
        importlib.invalidate_caches()
        written.append(name)
        return importlib.import_module(name)

    yield write
    for name in set(EOS.names()) - before:
        EOS.remove(name)
    for name in written:
        sys.modules.pop(name, None)


def test_the_law_of_the_page_keeps_the_contract_and_runs(file_of_a_user, tmp_path):
    file_of_a_user("law_of_the_page", recipe())
    law = EOS.get("acoustic")
    in_python.test_derivatives_against_dual_numbers_and_stability(law, 2_000)
    for check in (in_python.test_derivatives_of_other_parameters_than_the_example,
                  in_python.test_pressure_and_slopes_at_once_are_the_same_numbers, in_python.test_reference_state_is_at_rest,
                  in_python.test_linear_in_energy_means_it, in_python.test_documented,
                  in_python.test_states_beyond_the_limits_are_refused_with_the_limit, in_kernels.test_compiled_sweep_agrees_with_python):
        check(law)
    assert "linear_in_energy" in law.flags
    (tmp_path / "impact.toml").write_text(DECK, encoding="utf-8")
    run = hugoniot.run(tmp_path / "impact.toml", out=tmp_path / "run")
    # of two alike each takes half the velocity; jump conditions with p = c0^2 (rho - rho0): U (U - u) = c0^2
    u = 50.0
    shock = 0.5 * u + math.sqrt(1500.0**2 + 0.25 * u * u)
    late = run.gauges.sel(gauge="inside").isel(time=slice(-5, None))
    assert np.all(np.abs(late["velocity"].values - u) < 0.01 * u)
    assert np.all(np.abs(late["pressure"].values - 1000.0 * shock * u) < 0.01 * 1000.0 * shock * u)


HELPER = "def doubled(x):\n    return 2.0 * x\n"
WITH_HELPERS = recipe().replace("Acoustic", "Stiff").replace('"acoustic"', '"stiff"').replace(
    "def pressure(", "from helper_of_a_user import doubled\nimport helper_of_a_user as other\n\n\ndef own(x):\n    return other.doubled(0.25 * x)\n\n\n"
    "def pressure(").replace("return par.c0 * par.c0 * (rho - par.rho0)", "return doubled(own(par.c0)) * par.c0 * (rho - par.rho0)")


def test_a_law_with_helpers_in_other_files_may_come_after_kernels_were_compiled(file_of_a_user):
    arrays.pressure_array(np.linspace(2800.0, 3000.0, in_kernels.COUNT), 0.0, EOS.get("mie_gruneisen").example)
    file_of_a_user("helper_of_a_user", HELPER)
    file_of_a_user("law_with_helpers", WITH_HELPERS)
    law = EOS.get("stiff")
    in_python.test_derivatives_against_dual_numbers_and_stability(law, 2_000)
    in_kernels.test_compiled_sweep_agrees_with_python(law)


def test_a_law_that_was_taken_out_is_unknown_and_its_name_free(file_of_a_user):
    file_of_a_user("law_of_the_page", recipe())
    EOS.remove("acoustic")
    with pytest.raises(KeyError):
        EOS.get("acoustic")
    with pytest.raises(KeyError):
        EOS.remove("acoustic")
    importlib.reload(sys.modules["law_of_the_page"])
    assert "acoustic" in EOS.names()


def test_a_law_that_is_edited_and_registered_again_is_the_new_one_in_kernels_too(file_of_a_user):
    """As in a notebook, where a cell is run twice: the compiler knows an argument by the name of its class."""
    rho = np.linspace(1001.0, 1100.0, in_kernels.COUNT)
    for factor in (1.0, 3.0):
        text = recipe().replace("return par.c0 * par.c0 * (rho - par.rho0)", f"return {factor} * par.c0 * par.c0 * (rho - par.rho0)")
        law = file_of_a_user(f"law_edited_{factor:.0f}", text).EOS.get("acoustic")
        np.testing.assert_allclose(arrays.pressure_array(rho, 0.0, law.example), factor * 1500.0**2 * (rho - 1000.0), rtol=1e-12)
        EOS.remove("acoustic")


def test_one_function_cannot_be_bound_in_two_ways():
    def searched(x):
        return x

    binder.bind(searched, fastmath=False)
    binder.bind(searched, fastmath=False)
    binder.bind(searched)
    with pytest.raises(ValueError, match="searched is bound to kernels already"):
        binder.bind(searched, fastmath=True)
    with pytest.raises(ValueError, match="bound to kernels already"):
        binder.bind_dispatch(contract.pressure, EOS, "energy")
    with pytest.raises(ValueError, match="bound to kernels already"):
        binder.bind_choice(searched, lambda cls: None)
