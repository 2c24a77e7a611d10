r"""The equations inside a steady shock, and how they are integrated.

With $u = m v$ the Navier-Stokes equations of a steady plane wave integrate once to

$$\left(\tfrac43\mu+\zeta\right) m\,\frac{dv}{dx} = p + m^2 v - P_0, \qquad k\,\frac{dT}{dx} = m\,h, \qquad h = e - e_R(v),$$

with $P_0 = p_1 + m^2 v_1$ and $e_R$ the energy of the Rayleigh line (`ends`). Both right-hand sides vanish at the ends. With the identity
$(\partial T/\partial v)_e = p\,T_e - T\,p_e$, $T_e = 1/c_v$, the second becomes an equation for h, so that any law with
pressure, its derivatives, temperature and specific heat can be integrated (for laws that do not satisfy it, difference quotients are used):

$$\frac{dh}{dx} = \frac{m c_v}{k}\,h + \left[T p_e c_v - (p + m^2 v - P_0)\right]\frac{dv}{dx}.$$

The upstream end is an unstable node and the downstream end a saddle. Followed towards -x, the one trajectory along the stable direction of
the saddle runs into the upstream end. The two-point problem is thus an initial-value problem without iteration, in which errors decay.
Without conduction h = 0 and only one equation remains.
"""

import math
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos.contract import EOS, has_temperature, require_temperature
from hugoniot.laws.transport import contract as transport_contract
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT
from hugoniot.theory.structure.ends import Ends
from hugoniot.theory.structure.slow_manifold import slow_manifold

STIFF = 8.0  # ratio of the upstream rates above which the trajectory is found as a curve, not along x
TOO_STIFF = 300.0  # ratio above which it cannot be found along x: that would take minutes
_COARSEST = 2e-6  # relative tolerance that round-off allows
_START, _STOP = 1e-7, 1e-9  # distance from the ends, as a part of the jump
_ALONG = (0.003, 0.01, 0.03, 0.1, 0.3, 0.5, 0.9)  # of the way from one end to the other
_LEAST_RATIO = 1e-4  # of c_v / c_p that a stable state has
_DIFFERENCE = 1e-8  # where a difference quotient stands in for an identity
_ROUND_OFF = 1e-14  # of a pressure on the Rayleigh line, which the excess of a weak shock makes visible


class Equations:
    """Scaled equations of one shock.

    x is measured in `length` = mu_l1 / m, v in v1 (w = v/v1), h in c1^2. The unknowns are (1 - w)/J, h/J^2 and the two entropies in
    units of `entropy_scale`, with J = 1 - w2 the jump: all of order one for weak and strong shocks alike.
    """

    def __init__(self, ends: Ends, transport):
        self.ends, self.transport, self.par = ends, transport, ends.eos
        law = EOS.of(self.par)
        self._pressure, self._derivatives = law.functions["pressure"], law.functions["pressure_derivatives"]
        self._temperature: Any = law.functions["temperature"] if has_temperature(self.par) else None
        self._heat: Any = law.functions.get("specific_heat")
        self.conducting = transport_contract.conducts(transport)
        if transport_contract.needs_temperature(transport):
            require_temperature(self.par)
        if self.conducting and self._heat is None:
            raise OutOfRange(f"{law.name}: heat conduction needs a specific heat, which this law does not give; choose conduction 'none'")
        self._viscosity = TRANSPORT.of(transport.shear).functions["viscosity"]
        self._conductivity = CONDUCTION.of(transport.conduction).functions["conductivity"]
        one = ends.upstream
        self.v1, self.c1, self.m = 1.0 / one.density, one.sound_speed, ends.mass_flux
        self.scale = self.m**2 * self.v1
        self.pi0 = one.pressure / self.scale + 1.0
        self.mu1 = self._viscosities(one.density, one.temperature)[1]
        if not 0.0 < self.mu1 < math.inf:
            raise OutOfRange(f"transport law '{TRANSPORT.of(transport.shear).name}' gives no viscosity ahead of the shock")
        self.length = self.mu1 / self.m
        self.w2 = one.density / ends.downstream.density
        self._consistent = self._temperature is None or self._heat is None or self._is_consistent()
        for end in (ends.upstream, ends.downstream) if self.conducting else ():
            self._require_thermal_stability(end)
        self.jump = 1.0 - self.w2
        self.entropy_scale = self.jump**3 * (self.c1**2 / one.temperature if one.temperature == one.temperature else 1.0)

    def temperature_slopes(self, rho, e, p, T, p_e):
        """(dT/dv at constant e, dT/de at constant v), K kg/m3 and K kg/J: p/c_v - T p_e and 1/c_v, or differences where these fail."""
        if not self._consistent:
            return self._temperature_differences(1.0 / rho, e)
        T_e = 1.0 / self._heat(rho, e, self.par)
        return p * T_e - T * p_e, T_e

    def _temperature_differences(self, v, e):
        """The same by central differences."""
        d, b = 3e-5 * v, 3e-5 * self.c1**2
        return ((self._temperature(1.0 / (v + d), e, self.par) - self._temperature(1.0 / (v - d), e, self.par)) / (2.0 * d),
                (self._temperature(1.0 / v, e + b, self.par) - self._temperature(1.0 / v, e - b, self.par)) / (2.0 * b))

    def _is_consistent(self) -> bool:
        """Whether the law keeps T_v = p T_e - T p_e and T_e = 1/c_v all along the Rayleigh line (porous and tabulated laws do not)."""
        v2 = 1.0 / self.ends.downstream.density
        for part in _ALONG:
            v = self.v1 + part * (v2 - self.v1)
            e, rho = self.ends.rayleigh_energy(v), 1.0 / v
            p, T, p_e = self._pressure(rho, e, self.par), self._temperature(rho, e, self.par), self._derivatives(rho, e, self.par)[1]
            cv = self._heat(rho, e, self.par)
            T_v, T_e = self._temperature_differences(v, e)
            if abs(p / cv - T * p_e - T_v) > 1e-6 * (abs(p / cv) + abs(T * p_e)) or abs(T_e * cv - 1.0) > 1e-6:
                return False
        return True

    def _require_thermal_stability(self, end):
        p_e = self._derivatives(end.density, end.energy, self.par)[1]
        heat = (p_e / end.density) ** 2 * self._heat(end.density, end.energy, self.par) * end.temperature
        if self._consistent and not end.sound_speed**2 > heat > -math.inf:
            raise OutOfRange(f"law '{EOS.of(self.par).name}' has no such shock with heat conduction: at rho = {end.density:.6g} kg/m3 its "
                             f"Gamma^2 c_v T = {heat:.4g} m2/s2 exceeds c^2 = {end.sound_speed**2:.4g} m2/s2, so that its c_p is negative; "
                             "use a smaller Grüneisen parameter or specific heat, or conduction 'none'")

    def _viscosities(self, rho, T):
        mu = self._viscosity(rho, T, self.transport.shear)
        return mu, transport_contract.longitudinal_viscosity(mu, self.transport)

    def state(self, w: float, h: float) -> dict:
        """Fields and their x-derivatives at one point, SI; h in J/kg here scaled by c1^2 as in `rates`."""
        par, m = self.par, self.m
        v = w * self.v1
        x = self.v1 - v
        rho = 1.0 / v
        one = self.ends.upstream
        e = one.energy + one.pressure * x + 0.5 * (m * x) ** 2 + h * self.c1**2
        p = self._pressure(rho, e, par)
        T = self._temperature(rho, e, par) if self._temperature else math.nan
        mu, mu_l = self._viscosities(rho, T)
        tension = self.scale * (p / self.scale + w - self.pi0)
        v_x = tension / (mu_l * m)
        found = {"w": w, "h": h, "density": rho, "energy": e, "pressure": p, "temperature": T, "velocity": m * v, "viscosity": mu,
                 "longitudinal_viscosity": mu_l, "viscous_stress": tension, "v_x": v_x, "conductivity": 0.0, "h_x": 0.0, "heat_ratio": 1.0}
        if self.conducting:
            p_rho, p_e = self._derivatives(rho, e, par)
            T_v, T_e = self.temperature_slopes(rho, e, p, T, p_e)
            cp = transport_contract.isobaric_heat(rho, p_rho + p * p_e / (rho * rho), p_rho, p_e, T_v, T_e)
            k = self._conductivity(rho, T, mu, cp, self.transport.conduction)
            found["conductivity"], found["heat_ratio"] = k, 1.0 / (T_e * cp)
            found["h_x"] = m / (k * T_e) * h * self.c1**2 + (p - tension - T_v / T_e) * v_x
        return found

    def rates(self, _, y):
        """d/dxi of the unknowns."""
        s = self.state(1.0 - self.jump * y[0], self.jump**2 * y[1] if self.conducting else 0.0)
        w_x, T = s["v_x"] / self.v1 * self.length, s["temperature"]
        if not math.isfinite(w_x):
            raise NoSolution(f"law '{EOS.of(self.par).name}' gives no finite state inside the shock at rho = {s['density']:.6g} kg/m3, "
                             f"e = {s['energy']:.6g} J/kg; choose a weaker shock or another law")
        viscous = conductive = h_x = 0.0
        if T == T:
            viscous = s["longitudinal_viscosity"] / self.mu1 * (self.m * self.v1 * w_x) ** 2 / T
        if self.conducting:
            conductive = self.mu1 * (s["h"] * self.c1**2 / T) ** 2 / s["conductivity"]
            h_x = s["h_x"] / self.c1**2 * self.length
        return (-w_x / self.jump, h_x / self.jump**2, viscous / self.entropy_scale, conductive / self.entropy_scale)

    def _jacobian(self, y):
        """Derivatives of the first two rates by the first two unknowns, by central differences about an end."""
        columns, step = [], 1e-5
        for a, b in ((step, 0.0), (0.0, step)):
            up, down = self.rates(0.0, (y + a, b)), self.rates(0.0, (y - a, -b))
            columns.append([(up[i] - down[i]) / (2.0 * step) for i in (0, 1)])
        return np.array(columns).T

    def directions(self):
        """(rate and direction of the way into the downstream end, upstream rates ascending), per unit xi."""
        behind, ahead = self._jacobian(1.0), self._jacobian(0.0)
        if not self.conducting:
            return behind[0, 0], np.array([1.0, 0.0]), np.array([ahead[0, 0]])
        values, vectors = np.linalg.eig(behind)
        stable = np.flatnonzero(values.real < 0.0)
        if len(stable) != 1 or abs(values.imag).max() > 0.0:
            raise NoSolution(f"the state behind the shock is not a saddle of the structure equations (rates {values}); the law is "
                             "not thermodynamically consistent there")
        direction = vectors[:, stable[0]].real
        return values[stable[0]].real, direction / direction[0], np.sort(np.linalg.eigvals(ahead).real)

    def integrate(self, rtol: float):
        """(dense solution over xi <= 0 from the downstream to the upstream end, slow manifold or None, rate behind, slow rate ahead).

        With a slow manifold the second unknown is that curve's value and not part of the solution.
        """
        if not _ROUND_OFF / self.jump**2 < _COARSEST:
            raise NoSolution(f"the shock is too weak: its volume falls by {self.jump:.2g} of itself, and round-off hides the stress that "
                             "drives it; try a stronger shock")
        rate, direction, ahead = self.directions()
        if not (rate < 0.0 and ahead[0] > 0.0):
            raise NoSolution("the ends of this shock are too close to be distinguished in double precision; try a stronger shock")
        start = np.array([1.0 - _START * direction[0], -_START * direction[1], 0.0, 0.0])

        def arrived(_, y):
            return y[0] - _STOP

        def unstable(_, y):  # c_p beyond all bounds or negative: the isothermal stiffness has vanished, or the pressure leaps
            return self.state(1.0 - self.jump * y[0], self.jump**2 * y[1])["heat_ratio"] - _LEAST_RATIO
        arrived.terminal = unstable.terminal = True
        span = 10.0 * (math.log(1.0 / _START) / -rate + math.log(1.0 / _STOP) / ahead[0]) + 300.0
        rtol = max(rtol, _ROUND_OFF / self.jump**2, _DIFFERENCE if self.conducting and not self._consistent else 0.0)
        rates: Any = self.rates
        curve = None
        with np.errstate(all="ignore"):
            if ahead[-1] / ahead[0] > STIFF:
                curve = self._curve(10.0 * rtol)
            if curve is None and ahead[-1] / ahead[0] > TOO_STIFF:
                raise NoSolution("the heat flux spreads over a length so different from that of the viscous stress, as in weak shocks and "
                                 "strong conductors, that the equations are too stiff, and the profile is not smooth enough for the "
                                 "method that treats stiff ones; try a stronger shock or another conductivity")
            if curve is not None:
                start[1] = curve(start[0])

                def along(xi, y, curve=curve):
                    slope = self.rates(xi, (y[0], curve(y[0])))
                    return slope[0], 0.0, slope[2], slope[3]
                rates = along
            events = [arrived, unstable] if self.conducting and curve is None else [arrived]
            found = solve_ivp(rates, (0.0, -span), start, method="DOP853", rtol=rtol, atol=1e-2 * rtol, events=events, dense_output=True)
        if len(found.t_events[-1]) and events[-1] is unstable:
            raise self._lost(found.y[:, -1])
        if found.status != 1:
            raise NoSolution(f"the structure did not reach the state ahead within {span * self.length:.3g} m ({found.message}); "
                             "the law or the transport law may not be smooth between the two states")
        return found, curve, rate, ahead[0]

    def _curve(self, tolerance: float):
        """The slow manifold, or None where the law has kinks that no polynomial follows (pores that close): x is the way then."""
        try:
            return slow_manifold(self.rates, tolerance)
        except NoSolution:
            return None

    def _lost(self, y) -> NoSolution:
        s = self.state(1.0 - self.jump * y[0], self.jump**2 * y[1])
        return NoSolution(f"law '{EOS.of(self.par).name}' has no such shock with this heat conduction: the heat that runs ahead of it "
                          f"warms the material at rho = {s['density']:.6g} kg/m3 to {s['temperature']:.4g} K, where the law has no "
                          "single stable state (its c_p is not positive); try a weaker shock, less conduction, or conduction 'none'")
