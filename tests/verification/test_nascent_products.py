"""Nascent products in thermal isolation where they fill bubbles: little has burned, and the explosive is released to no pressure."""

import pytest
from scipy.optimize import brentq

import hugoniot.laws.eos  # noqa: F401  (enrols the equations of state)
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.mixture import contract
from hugoniot.laws.mixture.isentrope import isentrope_energy
from hugoniot.materials import burning, library
from hugoniot.theory import mixture as tool


def shocked(par, pressure):
    """(rho, thermal energy) behind a shock of that pressure into the explosive at rest."""
    rho, e = eos.reference_state(par)
    p = eos.pressure(rho, e, par)
    v = tool.hugoniot_volume(pressure, rho, e, p, par)
    return 1.0 / v, e + 0.5 * (pressure + p) * (1.0 / rho - v)


@pytest.mark.parametrize("burned", [6e-4, 5e-5])
def test_nascent_products_open_bubbles_in_what_is_released_to_no_pressure(burned):
    """PBX-9404 at 3 GPa with little burned expands fivefold in steps as of a run, as its frozen adiabat does: both phases on their isentropes.

    Taken through the mixture state all the way, the isentrope of the reactants gave these a tension and the products its energy: here 2.7
    GPa at a quarter of the density, where there are 20 kPa, and rising.
    """
    par = burning.reactive(library.find("PBX-9404 reactive")).mixture
    rho, e = shocked(par.reactants, 3e9)
    mixed = contract.solve(rho, e + par.detonation_energy, burned, contract.at_rest(rho, e + par.detonation_energy), par)
    v, e, start = 1.0 / rho, e + par.detonation_energy, mixed

    def frozen(volume):
        """Pressure with both phases on the isentropes through the start."""
        def phases(w):
            v_r, v_p = volume + burned * w, volume - (1.0 - burned) * w
            e_r = isentrope_energy(1.0 / start.rho_r, start.e_r - par.detonation_energy, v_r, par.reactants)
            e_p = isentrope_energy(1.0 / start.rho_p, start.e_p, v_p, par.products)
            return eos.pressure(1.0 / v_r, e_r, par.reactants), eos.pressure(1.0 / v_p, e_p, par.products)
        low, high = -0.9 * volume / burned, 0.9 * volume
        w = brentq(lambda w: phases(w)[0] - phases(w)[1], low, high, xtol=1e-16, rtol=1e-14)
        return phases(w)[1]

    for _ in range(160):
        wider = 1.01 * v
        trial = contract.solve(1.0 / wider, e - mixed.pressure * (wider - v), burned, mixed, par)
        e -= 0.5 * (mixed.pressure + trial.pressure) * (wider - v)
        v, mixed = wider, contract.solve(1.0 / wider, e, burned, mixed, par)
        assert mixed.status == contract.CONVERGED
        assert abs(mixed.pressure - frozen(v)) < (5e7 if v < 1.2 / 1842.0 else 4e6)


def test_hardly_any_products_leave_the_reactants_their_tension():
    """Less than 1e-5 burned: the reactants alone, where they are in tension."""
    par = burning.reactive(library.find("PBX-9404 reactive")).mixture
    rho, e = eos.reference_state(par.reactants)
    e += par.detonation_energy
    stretched = contract.solve(0.97 * rho, e, 5e-6, contract.at_rest(rho, e), par)
    assert stretched == (eos.pressure(0.97 * rho, e - par.detonation_energy, par.reactants), 0.97 * rho, e, 0.0, 0.0, 0.0)
    assert stretched.pressure < -5e7 and contract.slopes(0.97 * rho, e, 5e-6, stretched, par).by_volume < 0.0
