"""Equations of state in kernels: the same numbers as in Python, and packed arithmetic where it pays."""

import os
import sys
import traceback
import warnings

import numba as nb
import numpy as np
import pytest

import hugoniot.laws.eos  # noqa: F401
from hugoniot.core.target import SWEEP
from hugoniot.errors import OutOfRange
from hugoniot.laws import arrays
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS, gives
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.p_alpha import PAlpha
from hugoniot.laws.eos.shifted_energy import ShiftedEnergy
from hugoniot.laws.eos.tension_cutoff import TensionCutoff

LAWS = sorted(EOS, key=lambda law: law.name)
BY_QUANTITY = ("mie_gruneisen", "jwl", "table", "p_alpha")      # a formula, exponentials, an interpolation, a search around another law
COUNT = arrays.SMALL + 44


def sample(law, count=COUNT):
    rng = np.random.default_rng(3)
    return rng.uniform(*law.box["rho"], count), rng.uniform(*law.box["e"], count)


def apart(work):
    """Do the work in a fork, whose memory goes with it; where there are no forks, here."""
    if sys.platform == "win32":
        work()
        return
    child = os.fork()
    if child == 0:
        status = 1
        try:
            work()
            status = 0
        except BaseException:
            traceback.print_exc()
        finally:
            os._exit(status)
    assert os.waitpid(child, 0)[1] == 0, "see what the fork has printed"


def test_every_law_in_a_kernel_agrees_with_python():
    """All a law has, in one kernel for each law but those whose sweeps are looked at below: three loops around the same functions."""
    from hugoniot.laws import array_kernels  # noqa: F401  (binds the laws)
    from hugoniot.laws.eos.contract import pressure, pressure_derivatives, temperature

    @nb.njit(**{**SWEEP, "cache": False})
    def cold(rho, e, par, p, p_rho, p_e, t):
        for j in range(p.shape[0]):
            p[j] = pressure(rho[j], e[j], par)
            p_rho[j], p_e[j] = pressure_derivatives(rho[j], e[j], par)

    @nb.njit(**{**SWEEP, "cache": False})
    def warm(rho, e, par, p, p_rho, p_e, t):
        for j in range(p.shape[0]):
            p[j] = pressure(rho[j], e[j], par)
            p_rho[j], p_e[j] = pressure_derivatives(rho[j], e[j], par)
            t[j] = temperature(rho[j], e[j], par)

    def work():
        for law in (law for law in LAWS if law.name not in BY_QUANTITY):
            (rho, e), has = sample(law), gives(law.example, "temperature")
            p, p_rho, p_e, t = (np.empty_like(rho) for _ in range(4))
            (warm if has else cold)(rho, e, arrays.float_parameters(law.example), p, p_rho, p_e, t)
            check_pressures(law, rho, e, p, p_rho, p_e)
            if has:
                check_temperatures(law, rho, e, t)

    apart(work)


def quick(laws):
    """The laws as parameters, those beyond `BY_QUANTITY` slow."""
    return [pytest.param(law, id=law.name, marks=() if law.name in BY_QUANTITY else pytest.mark.slow) for law in laws]


@pytest.mark.parametrize("law", quick(LAWS))
def test_compiled_sweep_agrees_with_python(law):
    rho, e = sample(law)
    check_pressures(law, rho, e, arrays.pressure_array(rho, e, law.example), *arrays.derivatives_array(rho, e, law.example))


def check_pressures(law, rho, e, p, p_rho, p_e):
    """Pressure and its derivatives at the states are those of the law in Python."""
    par = law.example
    expected = np.array([law.functions["pressure"](r, u, par) for r, u in zip(rho.tolist(), e.tolist())])
    slopes = np.array([law.functions["pressure_derivatives"](r, u, par) for r, u in zip(rho.tolist(), e.tolist())])
    stiffness = np.abs(slopes[:, 0]) * rho
    assert np.max(np.abs(p - expected) / (np.abs(expected) + 1e-2 * stiffness)) < 1e-12
    np.testing.assert_allclose(p_rho, slopes[:, 0], rtol=1e-10, atol=1e-11 * np.abs(slopes[:, 0]).max())
    np.testing.assert_allclose(p_e, slopes[:, 1], rtol=1e-10, atol=1e-13 * np.abs(slopes[:, 1]).max())


@pytest.mark.parametrize("law", quick(law for law in LAWS if gives(law.example, "temperature")))
def test_compiled_temperature_agrees_with_python(law):
    rho, e = sample(law)
    check_temperatures(law, rho, e, arrays.temperature_array(rho, e, law.example))


def check_temperatures(law, rho, e, found):
    """Temperatures at the states are those of the law in Python."""
    with np.errstate(invalid="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        expected = np.array([law.functions["temperature"](r, u, law.example) for r, u in zip(rho.tolist(), e.tolist())], dtype=float)
    warm = expected > 10.0
    assert warm.sum() > 50
    np.testing.assert_allclose(found[warm], expected[warm], rtol=1e-11, atol=1e-8)


@pytest.mark.parametrize("name", ["mie_gruneisen", "jwl"])
def test_sweeps_are_packed(name):
    """A lost vectorisation costs 4 to 9 times and nobody sees it: the machine code must divide eight (four) numbers at a time."""
    from hugoniot.core.inspection import packed
    from hugoniot.laws import array_kernels

    law = EOS.get(name)
    rho, e = sample(law)
    arrays.pressure_array(rho, e, law.example)
    arrays.derivatives_array(rho, e, law.example)
    for kernel in (array_kernels.pressure_sweep, array_kernels.derivatives_sweep):
        fresh = type(kernel)(kernel.py_func, targetoptions=dict(kernel.targetoptions))
        outs = 1 if kernel is array_kernels.pressure_sweep else 2
        fresh(rho, e, arrays.float_parameters(law.example), *(np.empty_like(rho) for _ in range(outs)))
        counted = packed(fresh)
        assert counted["div"] >= 1
        assert counted["fmadd"] + counted["fnmadd"] >= 2


def test_pressure_and_slopes_of_mie_gruneisen_share_their_divisions():
    """The hot path of every hydrocode run: p, dp/drho and dp/de together cost two packed divisions: rho0/rho, which needs none where v is known, and the pole."""
    import re

    import numba as nb

    from hugoniot.laws import array_kernels  # noqa: F401  (binds the laws)
    from hugoniot.laws.eos.contract import pressure, pressure_derivatives

    @nb.njit(fastmath=True, error_model="numpy")
    def all_three(rho, e, par, p, p_rho, p_e):
        for j in range(p.shape[0]):
            r, u = rho[j], e[j]
            value = pressure(r, u, par)
            by_rho, by_e = pressure_derivatives(r, u, par)
            p[j], p_rho[j], p_e[j] = value, by_rho, by_e

    rho, e = sample(EOS.get("mie_gruneisen"))
    all_three(rho, e, EOS.get("mie_gruneisen").example, *(np.empty_like(rho) for _ in range(3)))
    assert len(re.findall(r"\svdivpd", all_three.inspect_asm(all_three.signatures[0]))) == 2


def test_three_laws_deep_compile():
    deep = PAlpha(TensionCutoff(ShiftedEnergy(MieGruneisen(2700.0, 5350.0, 1.34, 2.0, 863.0), 1e5), 2e9), 1.275, 0.08e9, 0.7e9)
    rho = np.linspace(2100.0, 3500.0, COUNT)
    expected = np.array([contract.pressure(r, 0.0, deep) for r in rho.tolist()])
    np.testing.assert_allclose(arrays.pressure_array(rho, 0.0, deep), expected, rtol=1e-11)


@pytest.mark.parametrize("name", ["mie_gruneisen", "davis_products"])
def test_energy_array_inverts_pressure_array(name):
    law = EOS.get(name)
    for count in (COUNT, 10):
        rho, e = sample(law, count)
        np.testing.assert_allclose(arrays.energy_array(rho, arrays.pressure_array(rho, e, law.example), law.example), e, rtol=1e-10, atol=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("name, sweep, states_per_second", [("mie_gruneisen", "pressure_sweep", 2e8), ("jwl", "pressure_sweep", 5e7),
                                                            ("table", "temperature_sweep", 1e7)])
def test_speed_per_core(name, sweep, states_per_second):
    """The best of many sweeps over 20 000 states, in processor time; the table has 200 x 200 points."""
    import time

    from hugoniot.laws import array_kernels
    from hugoniot.laws.eos import table

    law = EOS.get(name)
    par = law.example
    if name == "table":
        par = table.from_law(EOS.get("mie_gruneisen").example, np.linspace(2500.0, 6000.0, 200), np.geomspace(150.0, 40000.0, 200))
    rho, e = sample(law, 20_000)
    out, best = np.empty_like(rho), np.inf
    for _ in range(300):
        start = time.thread_time()
        getattr(array_kernels, sweep)(rho, e, arrays.float_parameters(par), out)
        best = min(best, time.thread_time() - start)
    assert rho.size / best > states_per_second


def test_broadcasting_and_scalars():
    par = EOS.get("mie_gruneisen").example
    grid = arrays.pressure_array(np.linspace(2800.0, 3500.0, 40)[:, None], np.linspace(0.0, 1e6, 10), par)
    assert grid.shape == (40, 10)
    assert grid[3, 4] == pytest.approx(contract.pressure(np.linspace(2800.0, 3500.0, 40)[3], np.linspace(0.0, 1e6, 10)[4], par), rel=1e-13)
    assert arrays.pressure_array(3000.0, 1e5, par) == pytest.approx(contract.pressure(3000.0, 1e5, par), rel=1e-14)


def test_few_states_and_many_agree():
    law = EOS.get("davis_products")
    rho, e = sample(law)
    few = arrays.evaluate(law.example, rho[:20], e[:20], *arrays.QUANTITIES)
    many = arrays.evaluate(law.example, rho, e, *arrays.QUANTITIES)
    for name in arrays.QUANTITIES:
        np.testing.assert_allclose(np.array(few[name]), np.array(many[name])[..., :20], rtol=1e-11)


def test_unstable_states_give_nan_sound_speed_not_a_crash():
    par = EOS.get("tillotson").example
    assert np.isnan(arrays.sound_speed_array(1000.0, 0.0, par))


def test_quantities_a_law_lacks_are_refused():
    with pytest.raises(OutOfRange, match="has no temperature"):
        arrays.temperature_array(2700.0, 0.0, EOS.get("tillotson").example)
    with pytest.raises(OutOfRange, match="unknown quantity 'presure'"):
        arrays.evaluate(EOS.get("jwl").example, 1000.0, 5e6, "presure")
    with pytest.raises(OutOfRange, match="gives no entropy"):
        arrays.entropy_array(2700.0, 0.0, EOS.get("p_alpha").example)


def test_integer_parameters_do_not_change_the_answer():
    whole = MieGruneisen(2785, 5328, 1, 2, 863)
    rho = np.linspace(2800.0, 3000.0, COUNT)
    np.testing.assert_array_equal(arrays.pressure_array(rho, 1e5, whole), arrays.pressure_array(rho, 1e5, arrays.float_parameters(whole)))
