"""Reacting mixtures of any two equations of state: states, slopes, limits, adiabats and frozen Hugoniots.

The closures for general use are `thermal_isolation` (equal pressures, the reactants on their isentrope) and `thermal_equilibrium` (equal
pressures and temperatures); `weighted_pressures` and `two_state` are for comparison. Q is the chemical energy, which the energy of the
reactants includes.

Source: Starkenberg, ARL-TR-2161, sections 3 to 5 and appendix B, with the corrections S-E1 to S-E3 and S-E13.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.mixture import contract
from hugoniot.laws.mixture.build import detonation_energy, mixture, require_temperature
from hugoniot.laws.mixture.contract import MIXTURE, Mixed

__all__ = ["FrozenHugoniot", "MixtureState", "VanishingSeries", "adiabat", "detonation_energy", "energy_with", "frozen_hugoniot",
           "hugoniot_volume", "mixture", "solve", "vanishing_series"]

COMPILE_ABOVE = 200  # states


@dataclass(frozen=True)
class MixtureState:
    """Solved states of a mixture: all fields are arrays of the same shape.

    density, energy                     of the mixture, kg/m3 and J/kg with Q
    burn_fraction                       mass fraction of the products
    pressure                            Pa
    reactant_density, reactant_energy   kg/m3, and J/kg with Q
    product_density, product_energy     kg/m3 and J/kg
    pressure_by_volume                  derivative of p(v, e, burn fraction), Pa kg/m3
    pressure_by_energy                  derivative, Pa kg/J
    pressure_by_burn_fraction           derivative, Pa
    status                              0 where the search converged
    par                                 parameters of the mixture

    At burn fraction 0 the products may have no state. Their density and energy are then NaN, and so is pressure_by_burn_fraction.
    """

    par: Any
    density: np.ndarray
    energy: np.ndarray
    burn_fraction: np.ndarray
    pressure: np.ndarray
    reactant_density: np.ndarray
    reactant_energy: np.ndarray
    product_density: np.ndarray
    product_energy: np.ndarray
    status: np.ndarray
    pressure_by_volume: np.ndarray
    pressure_by_energy: np.ndarray
    pressure_by_burn_fraction: np.ndarray

    @property
    def impedance_squared(self):
        """Square of the acoustic impedance, rho^2 c^2 = p p_e - p_v, (kg/m2/s)^2."""
        return self.pressure * self.pressure_by_energy - self.pressure_by_volume

    @property
    def sound_speed(self):
        """Frozen sound speed, m/s."""
        return np.sqrt(self.impedance_squared) / self.density

    @property
    def gruneisen(self):
        """Grüneisen parameter v p_e."""
        return self.pressure_by_energy / self.density

    @property
    def adiabatic_exponent(self):
        """Adiabatic exponent rho c^2/p."""
        with np.errstate(divide="ignore"):      # without pressure
            return self.impedance_squared / (self.density * self.pressure)

    @property
    def volume_fraction(self):
        """Volume fraction of the products."""
        return np.where(self.burn_fraction > 0.0, self.burn_fraction * self.density / self.product_density, 0.0)

    def mixed(self, index=()) -> Mixed:
        """The scalar state at an index, as the laws of `laws/mixture` take it."""
        return Mixed(*(float(a[index]) for a in (self.pressure, self.reactant_density, self.reactant_energy, self.product_density,
                                                 self.product_energy, self.status)))

    def _each(self, function) -> np.ndarray:
        values = [function(float(self.burn_fraction[i]), self.mixed(i), self.par) for i in np.ndindex(self.density.shape)]
        return np.array(values).reshape(self.density.shape + np.shape(values[0]))

    def _require_temperature(self) -> None:
        for role in ("reactants", "products"):
            if hasattr(self.par, role):
                require_temperature("the mixture's temperature", role, getattr(self.par, role))

    @property
    def temperature(self):
        """Temperature, K: of the products (thermal_isolation), common (thermal_equilibrium, two_state) or the
        mass-weighted mean (weighted_pressures). OutOfRange if an equation of state has none."""
        self._require_temperature()
        return self._each(contract.mixture_temperature)

    @property
    def specific_heat(self):
        """Specific heat at constant volume and burn fraction, J/(kg K); OutOfRange if the closure or an equation of state has none."""
        if "specific_heat" not in MIXTURE.of(self.par).functions:
            raise OutOfRange(f"mixtures of kind '{MIXTURE.of(self.par).name}' have no specific heat: use thermal_isolation or "
                             "thermal_equilibrium")
        self._require_temperature()
        return self._each(contract.mixture_specific_heat)

    def table(self) -> dict:
        """Field word -> array: the columns of a CSV file and the keys of JSON output; None for what closure or laws lack."""
        found: dict[str, Any] = {"burn_fraction": self.burn_fraction, "pressure": self.pressure, "density": self.density,
                                 "specific_internal_energy": self.energy}
        for name in ("temperature", "sound_speed", "gruneisen", "adiabatic_exponent", "specific_heat", "volume_fraction"):
            try:
                found[name] = getattr(self, name)
            except OutOfRange:
                found[name] = None
        names = ("reactant_density", "reactant_energy", "product_density", "product_energy", "pressure_by_volume", "pressure_by_energy",
                 "pressure_by_burn_fraction")
        return {**found, **{name: getattr(self, name) for name in names}}

    def phase_slopes(self) -> contract.PhaseSlopes:
        """Derivatives of the volumes and energies v_r, e_r, v_p, e_p of reactants and products with respect to v, e and burn fraction: a
        tuple of twelve arrays such as v_r_e (v_r by e; the last letter is v, e or l, the burn fraction). OutOfRange at burn fraction 0."""
        if np.any(self.burn_fraction <= 0.0):
            raise OutOfRange("the derivatives of the products' state with respect to volume and energy are infinite at burn fraction 0: "
                             "give a positive burn fraction, or use vanishing_series")
        return contract.PhaseSlopes(*np.moveaxis(self._each(contract.phase_slopes), -1, 0))


def solve(density, energy, burn_fraction, par, reference=None) -> MixtureState:
    """Both phases and the derivatives of the pressure at densities (kg/m3), energies (J/kg, with Q) and burn fractions.

    par         parameters of the mixture, made by `theory.mixture.mixture(closure, reactants, products)`
    reference   (density, energy with Q) of a point on the isentrope of the reactants, such as the state just behind the last shock; needed
                for `thermal_isolation` only

    At burn fraction 0 the state is that of the reactants alone, even where the first products would have no state, as at zero pressure.
    Raises NoSolution with the first state that has no solution, OutOfRange for burn fractions outside 0 to 1 and for densities
    that are not positive.
    """
    if reference is None:
        if "follows_isentrope" in MIXTURE.of(par).flags:
            raise OutOfRange("thermal isolation needs the reactant's reference state: pass reference = (density, energy) behind the shock")
        reference = (density, energy)
    rho, e, lam, rho_k, e_k = (np.array(a, float) for a in np.broadcast_arrays(density, energy, burn_fraction, *reference))
    if np.any(~(rho > 0.0)) or np.any(~(rho_k > 0.0)):
        raise OutOfRange("densities of a mixture must be positive")
    if np.any(~((lam >= 0.0) & (lam <= 1.0))):
        raise OutOfRange(f"burn fractions must lie between 0 and 1, got {float(np.min(lam)):.6g} to {float(np.max(lam)):.6g}")
    out = np.empty((9, rho.size))
    rows = (rho.ravel(), e.ravel(), lam.ravel(), rho_k.ravel(), e_k.ravel())
    if rho.size > COMPILE_ABOVE:
        from hugoniot.laws.mixture_kernels import equilibrate_rows

        equilibrate_rows(*rows, par, out)
    else:
        _solve_plainly(rows, par, out)
    out[5][~np.all(np.isfinite(out), axis=0)] = contract.NOT_FINITE
    for j in np.flatnonzero((rows[2] == 0.0) & (out[5] == contract.NO_BRACKET)):
        out[:, j] = unburned_row(float(rows[0][j]), float(rows[1][j]), par)
    bad = np.flatnonzero(out[5] != contract.CONVERGED)
    if bad.size:
        j = bad[0]
        raise NoSolution(f"no mixture state at density {rho.flat[j]:.6g} kg/m^3, energy {e.flat[j]:.6g} J/kg, burn fraction "
                         f"{lam.flat[j]:.6g}: {contract.MEANING[out[5, j]]}"
                         + (f" ({bad.size} of the {rho.size} states fail)" if rho.size > 1 else ""))
    return MixtureState(par, rho, e, lam, *(row.reshape(rho.shape) for row in out))


def _solve_plainly(rows, par, out) -> None:
    """What `mixture_kernels.equilibrate_rows` does, without a compiler: for a few states it is faster than loading one."""
    for j, (r, k, fraction, r_before, k_before) in enumerate(zip(*(row.tolist() for row in rows))):
        found = contract.equilibrate(r, k, fraction, Mixed(0.0, r_before, k_before, 0.0, 0.0, 0.0), par)
        out[:6, j] = found
        out[6:, j] = contract.slopes(r, k, fraction, found, par)


def unburned_row(rho: float, e: float, par) -> tuple[float, ...]:
    """The fields of a `MixtureState`, beginning with pressure, for the reactants alone; NaN in the fields of the products."""
    e_r = e - par.detonation_energy
    p, (p_v, p_e) = float(eos.pressure(rho, e_r, par.reactants)), contract.volume_slopes(rho, e_r, par.reactants)
    status = contract.CONVERGED if p * p_e - p_v > 0.0 else contract.UNSTABLE
    return p, rho, e, math.nan, math.nan, status, p_v, p_e, math.nan


def energy_with(density: float, burn_fraction: float, par, reference, **given) -> float:
    """Energy, J/kg with Q, at which a mixture of given density (kg/m3) and burn fraction has a pressure (Pa) or a temperature (K).

    par         parameters of the mixture
    reference   as in `solve`; the search begins at its energy
    given       pressure=... or temperature=...

    Raises NoSolution where no energy is found, OutOfRange for a temperature that an equation of state does not have.
    """
    (name, target), = given.items()
    e = float(reference[1])
    state = solve(density, e, burn_fraction, par, reference)
    for _ in range(100):
        now = float(getattr(state, name))
        slope = float(state.pressure_by_energy) if name == "pressure" else _temperature_slope(state, reference)
        if not slope > 0.0:
            break
        step = (target - now) / slope
        if abs(step) <= 1e-14 * (abs(e) + par.detonation_energy):
            _require_warm(state, f"{name} of {target:.6g} {'Pa' if name == 'pressure' else 'K'}")
            return e + step
        for _ in range(30):
            try:
                state = solve(density, e + step, burn_fraction, par, reference)
                break
            except NoSolution:
                step *= 0.5
        else:
            break
        e += step
    raise NoSolution(f"no energy gives the mixture of {density:.6g} kg/m^3 at burn fraction {burn_fraction:.6g} a {name} of {target:.6g} "
                     f"{'Pa' if name == 'pressure' else 'K'}: give its energy, or a state nearer to the reference")


def _require_warm(state: MixtureState, wanted: str) -> None:
    """NoSolution where both laws have temperatures and the mixture's is not positive: the laws then extrapolate below absolute zero."""
    try:
        t = float(state.temperature)
    except OutOfRange:
        return
    if not t > 0.0:
        raise NoSolution(f"at density {float(state.density):.6g} kg/m^3 and burn fraction {float(state.burn_fraction):.6g} a {wanted} "
                         f"would need a temperature below absolute zero ({t:.6g} K): no such state exists")


def _temperature_slope(state: MixtureState, reference) -> float:
    """dT/de at constant density and burn fraction, by a central difference: not every closure has a specific heat."""
    h = 1e-5 * (abs(float(state.energy)) + state.par.detonation_energy)
    low, high = (solve(state.density, state.energy + k * h, state.burn_fraction, state.par, reference).temperature for k in (-1.0, 1.0))
    return float(high - low) / (2.0 * h)


@dataclass(frozen=True)
class VanishingSeries:
    """Coefficients of series in the burn fraction lambda, a[0] + a[1] lambda + a[2] lambda^2 for the reactants and a[0] + a[1] lambda for
    the products.

    v_r, v_p   specific volumes of reactants and products, m3/kg
    e_r, e_p   their energies, J/kg; that of the reactants with Q
    """

    v_r: tuple[float, float, float]
    e_r: tuple[float, float, float]
    v_p: tuple[float, float]
    e_p: tuple[float, float]


def vanishing_series(density: float, energy: float, par) -> VanishingSeries:
    """Expansion about burn fraction 0 at constant density (kg/m3) and energy (J/kg with Q), in thermal isolation.

    The isentrope of the reactants passes through this state. Raises NoSolution if there is no state of the first products.
    Starkenberg section 5.9, corrected (S-E3).
    """
    state = solve(density, energy, 0.0, par, reference=(density, energy))
    mixed = state.mixed()
    if math.isnan(mixed.rho_p):
        raise NoSolution(f"the products that form first (burn fraction 0) have no state at density {density:.6g} kg/m^3, energy "
                         f"{energy:.6g} J/kg: {contract.MEANING[contract.NO_BRACKET]}; give another density or energy")
    v, v_p0, e_p0, p = 1.0 / density, 1.0 / mixed.rho_p, mixed.e_p, mixed.pressure
    i_r = contract.impedance_squared(density, energy - par.detonation_energy, par.reactants)
    p_v, p_e = contract.volume_slopes(mixed.rho_p, e_p0, par.products)
    p0 = -i_r * (v - v_p0)
    e0 = (v - v_p0) * (p + 0.5 * p0) + (energy - e_p0)
    i_p = p * p_e - p_v
    v_p1, e_p1 = (e0 * p_e - p0) / i_p, (p0 * p - e0 * p_v) / i_p
    return VanishingSeries((v, v - v_p0, v - v_p0 - v_p1), (energy, energy - e_p0, energy - e_p0 - e_p1), (v_p0, v_p1), (e_p0, e_p1))


def adiabat(start: MixtureState, volumes, burn_fraction: Callable[[float], float] | None = None) -> MixtureState:
    """States along the adiabat de + p dv = 0 of a mixture, from a single solved state.

    start           the state; the isentrope of the reactants runs through it
    volumes         specific volumes along the adiabat, m3/kg, monotonic
    burn_fraction   function that returns the burn fraction at a volume; None: no reaction, and the adiabat is an isentrope

    Raises NoSolution where no mixture state exists on the way.
    """
    par, mixed = start.par, start.mixed()
    if math.isnan(mixed.rho_p):
        mixed = mixed._replace(rho_p=0.0, e_p=0.0)      # which the closures take for unknown
    lam = burn_fraction or (lambda v: float(start.burn_fraction))
    volumes = np.asarray(volumes, float)

    def slope(v, e):
        found = contract.equilibrate(1.0 / v, float(e[0]), lam(v), mixed, par)
        if found.status == contract.NO_BRACKET and lam(v) == 0.0:
            found = Mixed(*unburned_row(1.0 / v, float(e[0]), par)[:6])
        if found.status != contract.CONVERGED:
            raise NoSolution(f"the adiabat has no mixture state at volume {v:.6g} m^3/kg and burn fraction {lam(v):.6g}: "
                             f"{contract.MEANING[found.status]}; stop the range of volumes before it")
        return [-found.pressure]

    way = solve_ivp(slope, (1.0 / float(start.density), float(volumes[-1])), [float(start.energy)], method="DOP853", rtol=1e-12,
                    atol=1e-12 * (abs(float(start.energy)) + par.detonation_energy), t_eval=volumes)
    if not way.success:
        raise NoSolution(f"the adiabat could not be followed to {volumes[-1]:.6g} m^3/kg: {way.message}")
    return solve(1.0 / volumes, way.y[0], [lam(v) for v in volumes], par, (mixed.rho_r, mixed.e_r))


def hugoniot_volume(pressure: float, rho_u: float, e_u: float, p_u: float, par) -> float:
    """Specific volume, m3/kg, on the Hugoniot of one phase at a pressure (Pa).

    rho_u, e_u, p_u   state ahead of the shock, kg/m3, J/kg (without Q) and Pa
    par               parameters of the equation of state of this phase, such as `mixture.reactants`

    Raises NoSolution if the Hugoniot does not reach the pressure.
    """
    v_u = 1.0 / rho_u
    low = 1.0 / min(float(eos.density_limits(par)[1]), 20.0 * rho_u)

    def miss(v):
        return eos.pressure(1.0 / v, e_u + 0.5 * (pressure + p_u) * (v_u - v), par) - pressure

    if miss(v_u) >= 0.0:
        return v_u
    # from rest towards the limit in small strides: the first crossing is the physical branch
    inner = v_u
    for _ in range(2000):
        outer, inner = inner, inner + 0.02 * (low - inner)
        if miss(inner) >= 0.0:
            return brentq(miss, inner, outer, xtol=1e-15 * v_u, rtol=8.9e-16)
    raise NoSolution(f"the Hugoniot from {rho_u:.6g} kg/m^3 does not reach {pressure:.6g} Pa below its "
                     f"compression limit {1.0 / low:.6g} kg/m^3")


@dataclass(frozen=True)
class FrozenHugoniot:
    """Shocked mixtures at given pressures, without reaction in the shock: every field is an array.

    pressure                            Pa
    density, energy                     of the mixture, kg/m3 and J/kg with Q
    reactant_density, reactant_energy   kg/m3, and J/kg with Q
    product_density, product_energy     kg/m3 and J/kg; NaN for products that have no state ahead
    particle_velocity, shock_velocity   relative to the state ahead, m/s
    """

    pressure: np.ndarray
    density: np.ndarray
    energy: np.ndarray
    reactant_density: np.ndarray
    reactant_energy: np.ndarray
    product_density: np.ndarray
    product_energy: np.ndarray
    particle_velocity: np.ndarray
    shock_velocity: np.ndarray

    def table(self) -> dict:
        """Field word -> array, as of the other tools."""
        names = ("pressure", "density", "particle_velocity", "shock_velocity")
        phases = ("reactant_density", "reactant_energy", "product_density", "product_energy")
        return {**{n: getattr(self, n) for n in names}, "specific_internal_energy": self.energy, **{n: getattr(self, n) for n in phases}}


def frozen_hugoniot(upstream: MixtureState, pressures) -> FrozenHugoniot:
    """Shocks in a mixture without reaction: each phase on its own Hugoniot, from the state ahead to the same pressures.

    upstream    the mixture ahead of the shocks, a single solved state
    pressures   pressures behind the shocks, Pa

    Returns a `FrozenHugoniot`. Raises NoSolution beyond a limit of compression.
    """
    par, u = upstream.par, upstream.mixed()
    lam, q, v_u = float(upstream.burn_fraction), upstream.par.detonation_energy, 1.0 / float(upstream.density)
    p = np.atleast_1d(np.asarray(pressures, float))
    p_u = u.pressure
    v_r = np.array([hugoniot_volume(x, u.rho_r, u.e_r - q, p_u, par.reactants) for x in p])
    none = math.isnan(u.rho_p)      # before any burning
    v_p = np.array([math.nan if none else hugoniot_volume(x, u.rho_p, u.e_p, p_u, par.products) for x in p])
    e_r, e_p = u.e_r + 0.5 * (p + p_u) * (1.0 / u.rho_r - v_r), u.e_p + 0.5 * (p + p_u) * (1.0 / u.rho_p - v_p)
    v, e = (v_r, e_r) if none else ((1.0 - lam) * v_r + lam * v_p, (1.0 - lam) * e_r + lam * e_p)
    jump = np.sqrt(np.maximum((p - p_u) * (v_u - v), 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        speed = np.where((v < v_u) & (p > p_u), v_u * np.sqrt((p - p_u) / (v_u - v)), float(upstream.sound_speed))
    return FrozenHugoniot(p, 1.0 / v, e, 1.0 / v_r, e_r, 1.0 / v_p, e_p, jump, speed)
