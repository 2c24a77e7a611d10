r"""The steady profile: every field through the shock, its thicknesses, and where its entropy comes from.

The thickness is that of the steepest gradient of a field f, $\delta_f = |f_2 - f_1| / \max|df/dx|$ (Jordan eq. 6.2.5 with f = density);
widths are taken between 10 % and 90 % of the jump. The entropy gained follows from the corrected integral (J-E2: Jordan eq. 2.4.1.20 lacks
$1/(\rho u)$)

$$\Delta s = \frac1m\int\left[\frac{\tau\,u_x}{T} + \frac{(kT_x)_x}{T}\right]dx
 = \frac1m\int\left[\frac{(\frac43\mu+\zeta)\,u_x^2}{T} + \frac{k\,T_x^2}{T^2}\right]dx,$$

whose two parts are production by viscosity and by conduction; the sum equals the jump of the law's entropy for any transport law.
"""

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract as eos_laws
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.transport.mean_free_path import mean_free_path, viscosity_exponent
from hugoniot.theory.structure.ends import Ends, find_ends
from hugoniot.theory.structure.equations import Equations

FIELDS = ("density", "velocity", "pressure", "energy", "temperature", "viscous_stress", "heat_flux", "viscosity", "conductivity",
          "entropy", "entropy_production_viscous", "entropy_production_conductive")
STIFFEST_GAS = 2.0     # rho c^2 / p: 5/3 or less in dilute gases, 2.6 in water at 1 GPa
_DECAYS = 24    # e-folding lengths that the tails are followed beyond the integration
_PER_STEP = 4   # points per step of the integration at which gradients are looked at


@dataclass(frozen=True)
class Profile:
    """A steady shock in its own frame; gas flows towards +x; x = 0 where the density is midway between its ends.

    ends, transport    the two end states and the transport tuple
    entropy_viscous, entropy_conductive   production through the whole shock, J/(kg K); NaN where the law has no temperature
    x                  m, points of the adaptive integration, upstream first
    """

    ends: Ends
    transport: Any
    x: np.ndarray
    entropy_viscous: float
    entropy_conductive: float
    steps: int
    _equations: Equations = field(repr=False)
    _solution: Any = field(repr=False)
    _shift: float = field(repr=False)
    _rates: tuple[float, float] = field(repr=False)
    _curve: Any = field(repr=False, default=None)

    # -- fields ------------------------------------------------------------------------------------------------------
    def _wh(self, x):
        """Scaled (w, h) at positions x, m; exponential tails beyond the integration."""
        xi = np.atleast_1d(np.asarray(x, float)) / self._equations.length + self._shift
        first, last, jump = self._solution.t[-1], self._solution.t[0], self._equations.jump
        y, h = self._solution.sol(np.clip(xi, first, last))[:2]
        for mask, edge, rate, end in ((xi < first, first, self._rates[1], 0.0), (xi > last, last, self._rates[0], 1.0)):
            decay = np.exp(rate * (xi[mask] - edge))
            y[mask], h[mask] = end + (y[mask] - end) * decay, h[mask] * decay
        if self._curve is not None:
            h = np.array([self._curve(a) for a in y.tolist()])
        return 1.0 - jump * y, jump**2 * h if self._equations.conducting else np.zeros_like(h)

    def _points(self, x) -> list[dict]:
        with np.errstate(all="ignore"):
            return [self._equations.state(w, h) for w, h in zip(*(a.tolist() for a in self._wh(x)))]

    def at(self, x) -> dict[str, np.ndarray]:
        """Field word -> values at positions x (m), SI: `FIELDS`, `sound_speed` left to the law. Heat flux q = -k dT/dx, towards +x.

        entropy counts from the state ahead (NaN where the law has none); its production by viscosity and conduction is W/(K m3).
        """
        found, eq = self._points(x), self._equations
        table = {name: np.array([s[name] for s in found], float) for name in FIELDS[:6] + ("viscosity", "conductivity")}
        table["heat_flux"] = -eq.m * eq.c1**2 * np.array([s["h"] for s in found], float)
        T, u_x = table["temperature"], eq.m * np.array([s["v_x"] for s in found], float)
        table["entropy"] = self._entropy(table["density"], table["energy"])
        table["entropy_production_viscous"] = table["viscous_stress"] * u_x / T
        k = np.where(table["conductivity"] > 0.0, table["conductivity"], math.inf)   # none conducts none
        table["entropy_production_conductive"] = table["heat_flux"] ** 2 / (k * T * T)
        return {name: table[name] for name in FIELDS}

    def _entropy(self, density, energy):
        """The law's entropy above that ahead, J/(kg K)."""
        if not math.isfinite(self.ends.entropy_jump):
            return np.full_like(density, math.nan)
        one = self.ends.upstream
        start = eos_laws.entropy(one.density, one.energy, self.ends.eos)
        return np.array([eos_laws.entropy(rho, e, self.ends.eos) - start for rho, e in zip(density.tolist(), energy.tolist())], float)

    def gradient(self, name: str, x):
        """dx-derivative of "density", "velocity", "pressure", "energy" or "temperature" at positions x, SI."""
        return np.array([self._slopes(s)[name] for s in self._points(x)])

    def _slopes(self, s: dict) -> dict:
        eq = self._equations
        v_x, rho = s["v_x"], s["density"]
        e_x = s["h_x"] - (self.ends.upstream.pressure + eq.m**2 * (eq.v1 - s["w"] * eq.v1)) * v_x
        p_rho, p_e = eq._derivatives(rho, s["energy"], eq.par)
        T_x = eq.m * s["h"] * eq.c1**2 / s["conductivity"] if eq.conducting else math.nan
        if not eq.conducting and s["temperature"] == s["temperature"] and eq._heat:
            T_v, T_e = eq.temperature_slopes(rho, s["energy"], s["pressure"], s["temperature"], p_e)
            T_x = T_v * v_x + T_e * e_x
        return {"density": -rho * rho * v_x, "velocity": eq.m * v_x, "energy": e_x, "temperature": T_x,
                "pressure": -p_rho * rho * rho * v_x + p_e * e_x}

    # -- terms of the balances, as Jordan figures 6.4.1 to 6.7.3 plot them ---------------------------------------------------
    def balance_terms(self, x) -> dict[str, np.ndarray]:
        """The right-hand sides of the momentum (N/m3) and energy (W/m3) equations at positions x; each set sums to zero.

        momentum_*: d tau/dx, -d(j u)/dx, -dp/dx (Jordan eq. 6.4.1); energy_*: d(tau u)/dx, -d(j H)/dx, -dq/dx (eq. 6.5.1), with H the total
        enthalpy e + p/rho + u^2/2.
        """
        m = self._equations.m
        rows = []
        for s in self._points(x):
            d = self._slopes(s)
            stress_x = d["pressure"] + m * d["velocity"]
            u, u_x, p, v = s["velocity"], d["velocity"], s["pressure"], 1.0 / s["density"]
            enthalpy_x = d["energy"] + d["pressure"] * v + p * s["v_x"] + u * u_x
            rows.append((stress_x, -m * u_x, -d["pressure"], stress_x * u + s["viscous_stress"] * u_x, -m * enthalpy_x, m * s["h_x"]))
        names = ("momentum_shear", "momentum_flux", "momentum_pressure", "energy_shear", "energy_enthalpy", "energy_conduction")
        return dict(zip(names, np.array(rows).T))

    # -- measures -------------------------------------------------------------------------------------------------------
    def thickness(self, name: str = "density") -> float:
        """|jump| / steepest gradient of a field, m."""
        if f"steepest_{name}" not in self.__dict__:
            self.__dict__[f"steepest_{name}"] = self._steepest(name)
        one, two = getattr(self.ends.upstream, name), getattr(self.ends.downstream, name)
        return abs(two - one) / self.__dict__[f"steepest_{name}"]

    def _steepest(self, name) -> float:
        slopes = abs(self.gradient(name, self.x))
        i = int(np.nanargmax(slopes))
        low, high = self.x[max(i - 1, 0)], self.x[min(i + 1, len(self.x) - 1)]
        best = minimize_scalar(lambda x: -abs(self.gradient(name, x)[0]), bounds=(low, high), method="bounded",
                               options={"xatol": 1e-6 * (high - low)})
        return max(-float(best.fun), float(slopes[i]))

    def width(self, name: str = "density", low: float = 0.1, high: float = 0.9) -> float:
        """Distance between `low` and `high` parts of a field's jump, m."""
        start, end = self._places(name, low, high)
        return end - start

    def extent(self, part: float = 1e-3) -> tuple[float, float]:
        """(x upstream, x downstream), m, beyond which the density is within `part` (1e-12 or more) of the jump of its ends."""
        start, end = self._places("density", part, 1.0 - part)
        return start, end

    def _places(self, name: str, *levels: float) -> tuple[float, ...]:
        """Where a field has first gained these parts of its jump, m; in the tails beyond the integration too."""
        one, two = getattr(self.ends.upstream, name), getattr(self.ends.downstream, name)
        decays = np.arange(1.0, _DECAYS) * self._equations.length
        x = np.concatenate([self.x[0] - decays[::-1] / self._rates[1], self.x, self.x[-1] - decays / self._rates[0]])

        def gained(x):
            return (self.at(x)[name] - one) / (two - one)
        values = gained(x)
        places = []
        for level in levels:
            i = int(np.flatnonzero(values >= level)[0])
            places.append(brentq(lambda x, level=level: gained(x)[0] - level, x[i - 1], x[i], xtol=1e-12 * self._equations.length))
        return tuple(places)

    @property
    def entropy_produced(self) -> float:
        """Sum of both productions, J/(kg K)."""
        return self.entropy_viscous + self.entropy_conductive

    def entropy_literal(self) -> float:
        """Jordan eq. 2.4.1.20 as printed, without 1/(rho u), in units of Jordan's scaled variables (J-E2); the wrong one."""
        fine = np.linspace(*self.extent(1e-8), 4001)
        terms, s = self.balance_terms(fine), self.at(fine)
        with np.errstate(all="ignore"):
            production = (s["viscous_stress"] * self.gradient("velocity", fine) + terms["energy_conduction"]) / s["temperature"]
        return float(np.trapezoid(production, fine)) / (self.ends.upstream.density * self.ends.upstream.sound_speed)

    def mean_free_path(self, definition: str, exponent: float | None = None) -> float:
        """Mean free path ahead, m, in a named definition (laws.transport.mean_free_path).

        exponent   omega of mu ~ T^omega, for "vhs"; default that of the viscosity law at the temperature ahead
        Raises `OutOfRange` where the material ahead is no gas, so that p/rho says nothing about the speed of its molecules.
        """
        one = self.ends.upstream
        stiffness = one.density * one.sound_speed**2
        if EOS.of(self.ends.eos).name != "ideal_gas" and stiffness > STIFFEST_GAS * one.pressure:
            raise OutOfRange(f"a mean free path needs a gas: rho c^2 ahead is {stiffness:.3g} Pa at a pressure of {one.pressure:.3g} Pa; "
                             "give lengths in m")
        mu = self._points(np.array([self.x[0]]))[0]["viscosity"]
        omega = viscosity_exponent(one.density, one.temperature, self.transport.shear) if exponent is None else exponent
        return mean_free_path(definition, mu, one.density, one.pressure, omega)


def steady(material, transport, upstream=None, *, rtol: float = 1e-8, **shock) -> Profile:
    """The steady structure of a shock.

    material    a material, or the parameter tuple of an equation of state
    transport   a `laws.transport.contract.Transport` (see `make` there)
    upstream    `theory.hugoniot.Initial`, the state ahead (default: the law's reference state)
    shock       mach, or one of shock_velocity, particle_velocity, pressure, density (see `ends.find_ends`)
    rtol        relative tolerance of the integration; measures are good to about ten times that (with kinks, where pores
                begin or end to close, to 1e-6)
    Raises `OutOfRange` and `NoSolution` that say what the law, the transport law or the shock lacks.
    """
    ends = find_ends(material, upstream, **shock)
    equations = Equations(ends, transport)
    found, curve, rate, ahead = equations.integrate(rtol)
    middle = (1.0 - 2.0 / (1.0 + ends.downstream.density / ends.upstream.density)) / equations.jump
    shift = brentq(lambda xi: found.sol(xi)[0] - middle, found.t[-1], found.t[0], xtol=1e-13 * abs(found.t[-1]), rtol=1e-14)
    nodes = found.t[::-1]
    xi = np.unique(np.concatenate([nodes[:-1] + np.diff(nodes) * i / _PER_STEP for i in range(_PER_STEP)] + [nodes[-1:]]))
    thermal = ends.upstream.temperature == ends.upstream.temperature
    viscous, conductive = (0.0 - found.y[2:, -1] * equations.entropy_scale) if thermal else (math.nan, math.nan)
    return Profile(ends, transport, (xi - shift) * equations.length, float(viscous), float(conductive), len(nodes) - 1,
                   equations, found, float(shift), (float(rate), float(ahead)), curve)
