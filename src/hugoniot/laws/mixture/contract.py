"""What a mixture of reactants and products must provide: the state of both phases, the pressure, and their slopes.

A mixture is described by (rho, e, burn_fraction): density kg/m3, specific internal energy J/kg and mass fraction of products.
`par` holds `reactants` and `products` (parameter tuples of any two registered equations of state) and `detonation_energy`
Q >= 0 (J/kg; Starkenberg ARL-TR-2161 section 3 counts it negative): the reactant's energy on the mixture's scale is
e_r = e_thermal + Q, and its equation of state is evaluated at e_r - Q. No heat is added during burning, so the conservation
laws keep their form.

    solve(rho, e, burn_fraction, before, par)            Mixed: the phases and their common pressure
    equilibrate(rho, e, burn_fraction, before, par)      the same with both phases always found, also the one that carries no mass
    attempt(rho, e, burn_fraction, before, par)          as much of `solve` as a packed loop can do; else NOT_CONVERGED
    slopes(rho, e, burn_fraction, mixed, par)            Slopes of the pressure: by v at e, by e at v, by burn fraction at v and e
    phase_slopes(burn_fraction, mixed, par)              the twelve slopes of (v_r, e_r, v_p, e_p) by v, e, burn fraction
    temperature(burn_fraction, mixed, par)               T of the mixture, K (laws that have one); of the products in thermal isolation
    specific_heat(burn_fraction, mixed, par)             C_v = de/dT at constant v and burn fraction, J/(kg K)

`before` is the `Mixed` of the step before: the reactant isentrope runs through it (thermal isolation) and the search starts there.
A density of zero means that the phase is not known: products before burning begins, reactants after it has ended. Slopes are by
specific volume v = 1/rho, as in the source. The functions below dispatch on the class of `par`, in Python and, through
`core.binder`, inside kernels.
"""

from typing import NamedTuple

from hugoniot.core.registry import Registry
from hugoniot.laws.eos.contract import pressure, pressure_derivatives

MIXTURE = Registry("mixture", contract=("solve", "attempt", "equilibrate", "slopes", "phase_slopes"),
                   optional=("temperature", "specific_heat"))

CONVERGED = 0.0
NOT_CONVERGED = 1.0     # the iteration limit was reached
NO_BRACKET = 2.0        # the bracket shrank to nothing without a root: no state of mechanical equilibrium exists
UNSTABLE = 3.0          # a root, but the mixture's sound speed is imaginary there
NOT_FINITE = 4.0        # set by the Python face when a number is not finite

MEANING = {
    CONVERGED: "converged", NOT_CONVERGED: "the iteration limit was reached",
    NO_BRACKET: "no state of mechanical equilibrium exists between the compression limits of the phases",
    UNSTABLE: "its sound speed would be imaginary", NOT_FINITE: "a number is not finite",
}


class Mixed(NamedTuple):
    """A solved mixture: p (Pa), phase densities (kg/m3) and energies (J/kg, the reactant's with Q), and a status (0: converged)."""

    pressure: float
    rho_r: float
    e_r: float
    rho_p: float
    e_p: float
    status: float


class Slopes(NamedTuple):
    """Slopes of the mixture pressure: by_volume (Pa kg/m3), by_energy (Pa kg/J), by_burn_fraction (Pa)."""

    by_volume: float
    by_energy: float
    by_burn_fraction: float


class PhaseSlopes(NamedTuple):
    """Slopes of the phase volumes and energies by v (at e, burn fraction), by e (at v), and by burn fraction (`_l`, at v and e)."""

    v_r_v: float
    e_r_v: float
    v_p_v: float
    e_p_v: float
    v_r_e: float
    e_r_e: float
    v_p_e: float
    e_p_e: float
    v_r_l: float
    e_r_l: float
    v_p_l: float
    e_p_l: float


def at_rest(rho, e):
    """The `before` of material that has not begun to burn: reactants alone at (rho, e), no product state known."""
    return Mixed(0.0, rho, e, 0.0, 0.0, 0.0)


def heated(before, heat):
    """`before` after heat (J/kg of mixture: viscous work, plastic work, conduction) that both phases take in equal shares per mass.

    In thermal isolation the reactant's isentrope would otherwise stay behind, and the products, which take what is left, would receive
    all of it: heat/lambda per mass, without bound as burning begins.
    """
    return Mixed(before.pressure, before.rho_r, before.e_r + heat, before.rho_p, before.e_p + heat, before.status)


def solve(rho, e, burn_fraction, before, par):
    """Phases in equilibrium, as `Mixed`; `status` tells whether the search ended well."""
    return MIXTURE.of(par).functions["solve"](rho, e, burn_fraction, before, par)


def attempt(rho, e, burn_fraction, before, par):
    """As `solve` from a state of the step before, or `before` with the status NOT_CONVERGED where all of `solve` is needed."""
    return MIXTURE.of(par).functions["attempt"](rho, e, burn_fraction, before, par)


def equilibrate(rho, e, burn_fraction, before, par):
    """As `solve`, with both phases found at the ends of burning too (theory; a solver calls `solve`, which is cheap there)."""
    return MIXTURE.of(par).functions["equilibrate"](rho, e, burn_fraction, before, par)


def slopes(rho, e, burn_fraction, mixed, par):
    """`Slopes` of the pressure at a solved state."""
    return MIXTURE.of(par).functions["slopes"](rho, e, burn_fraction, mixed, par)


def phase_slopes(burn_fraction, mixed, par):
    """`PhaseSlopes` at a solved state."""
    return MIXTURE.of(par).functions["phase_slopes"](burn_fraction, mixed, par)


def mixture_temperature(burn_fraction, mixed, par):
    """Temperature of the mixture, K."""
    return MIXTURE.of(par).functions["temperature"](burn_fraction, mixed, par)


def mixture_specific_heat(burn_fraction, mixed, par):
    """Specific heat of the mixture at constant volume and burn fraction, J/(kg K)."""
    return MIXTURE.of(par).functions["specific_heat"](burn_fraction, mixed, par)


GENERICS = {"solve": solve, "attempt": attempt, "equilibrate": equilibrate, "slopes": slopes, "phase_slopes": phase_slopes,
            "temperature": mixture_temperature, "specific_heat": mixture_specific_heat}


# -- shared by the mixture laws ----------------------------------------------------------------------------------
def volume_slopes(rho, e, par):
    """(dp/dv at e, dp/de at v) of one phase."""
    p_rho, p_e = pressure_derivatives(rho, e, par)
    return -rho * rho * p_rho, p_e


def impedance_squared(rho, e, par):
    """Square of the acoustic impedance of one phase, i^2 = p p_e - p_v = (rho c)^2 (Starkenberg section 5.3)."""
    p_v, p_e = volume_slopes(rho, e, par)
    return pressure(rho, e, par) * p_e - p_v


def sound_speed_squared(rho, p, slope):
    """Square of the frozen sound speed, m2/s2, from the pressure slopes: c^2 = v^2 (p p_e - p_v)."""
    return (p * slope.by_energy - slope.by_volume) / (rho * rho)
