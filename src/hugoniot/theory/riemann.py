r"""Exact Riemann problem of two arbitrary laws, with shocks, isentropic fans and vacuum.

A wave runs into each side: a shock where the pressure $p$ between the waves exceeds the initial pressure $p_0$ of the side, otherwise a
fan. The velocity behind it is

$$u = u_0 + d\,\sqrt{(p - p_0)(v_0 - v_H)} \;(\text{shock}), \qquad u = u_0 + d\int_{p_0}^{p} \frac{dp'}{\rho c} \;(\text{fan})$$

* index 0: the initial state of the side; $v = 1/\rho$; $v_H(p)$: specific volume on the Hugoniot of the side
* $d$: $-1$ on the left side, $+1$ on the right; the integral is along the isentrope

The pressure is the one at which both sides have the same velocity. If the two materials, released to zero pressure, move apart, a vacuum
opens between them, unless they are bonded and the contact supports tension. A porous material is released elastically, with the compaction
that its loading has produced.

Implementation: `theory.jump` and `theory.expansion` compute both curves without an approximate solver; the pressure is found by Newton's
method inside a bracket, with slopes d/(rho c) on the fan and the differentiated jump conditions on the shock.

Source: Starkenberg, ARL-TR-2161, section 6; Courant and Friedrichs, Supersonic Flow and Shock Waves.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.theory import isentrope as release_path
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.states import States, law_of

FEEBLE = 1e-6     # strain up to which a shock is found as an isentrope


@dataclass(frozen=True)
class Wave:
    """The wave on one side.

    kind            "shock", "fan" or "none"
    ahead, behind   `States` ahead of the wave and behind it
    head, tail      velocities of its edges in the laboratory frame, m/s (equal for a shock)
    direction       -1: the wave runs into the material on the left; +1: into that on the right
    """

    kind: str
    ahead: States
    behind: States
    head: float
    tail: float
    direction: int


@dataclass(frozen=True)
class Riemann:
    """Solution of a Riemann problem: a wave to each side, and between them a contact or a vacuum.

    left, right          the `Wave` on each side
    pressure, velocity   at the contact, Pa and m/s; with a vacuum 0 and NaN
    vacuum               whether the materials have separated

    Called with positions x (from the initial interface, m) and a time t (s) it returns a dict of the fields density, pressure, velocity and
    energy (specific internal) in SI, and side: -1 in the material on the left, +1 in that on the right, 0 in a vacuum.
    """

    left: Wave
    right: Wave
    pressure: float
    velocity: float
    vacuum: bool

    def __call__(self, x, t=1.0) -> dict:
        """The fields as a dict: `density`, `pressure`, `velocity` and `energy` (specific internal) in SI, and `side`.

        x   positions from the initial interface, m: a number or an array, whose shape the fields have
        t   time, s, above 0

        `side` is -1 in the material on the left, +1 in that on the right, and 0 in a vacuum, where density and pressure are 0, and
        velocity and energy are NaN.
        """
        if not t > 0.0:
            raise OutOfRange(f"a Riemann solution needs a time above 0 s, got {t}")
        speed = np.asarray(x, float) / t
        xi = np.atleast_1d(speed).ravel()
        middle = 0.5 * (self.left.behind.particle_velocity + self.right.behind.particle_velocity)
        names = ("density", "pressure", "specific_internal_energy", "particle_velocity")
        rows = {name: np.zeros(xi.size) for name in names}
        side = np.where(xi < middle, -1, 1)
        for wave in (self.left, self.right):
            _fill(rows, names, xi, side == wave.direction, wave)
        if self.vacuum:
            empty = (xi > self.left.behind.particle_velocity) & (xi < self.right.behind.particle_velocity)
            for name in names:
                rows[name][empty] = np.nan if name in ("particle_velocity", "specific_internal_energy") else 0.0
            side[empty] = 0
        out = {"density": rows["density"], "pressure": rows["pressure"], "velocity": rows["particle_velocity"],
               "energy": rows["specific_internal_energy"], "side": side}
        return {k: (v.reshape(speed.shape) if speed.ndim else v[0]) for k, v in out.items()}

    @property
    def jumps(self) -> list[tuple[str, float]]:
        """Edges of the waves from left to right: pairs (name, velocity in m/s)."""
        edges = []
        for wave in (self.left, self.right):
            names = {"shock": [("shock", wave.head)], "fan": [("fan head", wave.head), ("fan tail", wave.tail)], "none": []}[wave.kind]
            edges += names if wave.direction < 0 else names[::-1]
            if wave.direction < 0:
                edges += [("contact", self.velocity)] if not self.vacuum else [
                    ("vacuum left", self.left.behind.particle_velocity), ("vacuum right", self.right.behind.particle_velocity)]
        return edges


def riemann(left, left_state: States, right, right_state: States, *, bonded: bool = False) -> Riemann:
    """Solve the Riemann problem of two materials in contact.

    left, right               materials, or parameters of equations of state
    left_state, right_state   single states, such as `state` returns
    bonded                    True: the contact supports tension; False: the materials separate under tension

    Returns a `Riemann`. Raises `OutOfRange` if a state is outside the range of a law, such as a tension that a bonded material does
    not support, and `NoSolution` if the search for the pressure does not converge.

    >>> found = riemann(copper, state(copper, velocity=500.0), water, state(water))
    >>> found.pressure, found.velocity     # Pa, m/s
    """
    sides = (_Side(law_of(left), left_state, -1), _Side(law_of(right), right_state, 1))
    with np.errstate(all="ignore"):
        if not bonded and (apart := _separated(*sides)):
            return apart
        p = _meet(*sides, bonded)
        waves = [side.wave(p) for side in sides]
    u = 0.5 * (waves[0].behind.particle_velocity + waves[1].behind.particle_velocity)
    return Riemann(*waves, pressure=p, velocity=u, vacuum=False)


class _Side:
    """The wave curve of one side: velocity and slope against pressure."""

    def __init__(self, par, state: States, direction: int):
        self.par = par = release_path.history(par, state)
        self.elastic = release_path.elastic(par)
        self.state, self.direction = state, direction
        self.ahead = Initial.of(state)
        square = contract.sound_speed_squared(state.density, state.specific_internal_energy, par)
        if not square > 0.0:
            raise OutOfRange(f"the {'left' if direction < 0 else 'right'} state ({state.density:.6g} kg/m3, {state.pressure:.6g} Pa) is "
                             f"unstable under law '{EOS.of(par).name}': c^2 = {square:.4g} m2/s2")
        self.c = math.sqrt(square)
        self.head = math.sqrt(contract.sound_speed_squared(state.density, state.specific_internal_energy, self.elastic))
        self._fan = replace(state, par=self.elastic)
        # below this rise a shock and an isentrope agree to round-off (third order), and the isentrope is the better conditioned
        self.weak = FEEBLE * state.density * square

    def behind(self, p: float) -> States:
        if p > self.state.pressure + self.weak:
            return shock(self.par, self.ahead, pressure=p, direction=self.direction)
        if p == self.state.pressure:
            return self.state
        # continue from the last state found on the same isentrope
        self._fan = release_path.isentrope(self.elastic if p < self.state.pressure else self.par, self._fan, pressure=p,
                                           direction=self.direction)
        if p > self.state.pressure and self._fan.density > (1.0 + FEEBLE) * self.state.density:     # pores, softer than any sound tells
            return shock(self.par, self.ahead, pressure=p, direction=self.direction)
        return replace(self._fan, par=self.par, shock_velocity=self._feeble_speed(p) if p > self.state.pressure else None)

    def _feeble_speed(self, p: float) -> float:
        """Velocity of a shock too weak to be told from an isentrope: by its momentum, and of sound where round-off is all there is."""
        gained = abs(self._fan.particle_velocity - self.state.particle_velocity)
        rise = p - self.state.pressure
        speed = rise / (self.state.density * gained) if rise > 0.01 * self.weak else self.c
        return self.state.particle_velocity + self.direction * speed

    def slope(self, p: float, behind: States) -> float:
        """|du/dp| on the curve at p."""
        rho, e = behind.density, behind.specific_internal_energy
        if p <= self.state.pressure + self.weak:
            law = self.elastic if p < self.state.pressure else self.par
            return 1.0 / (rho * math.sqrt(contract.sound_speed_squared(rho, e, law)))
        rise, x = p - self.state.pressure, 1.0 / self.state.density - 1.0 / rho
        p_rho, p_e = contract.pressure_derivatives(rho, e, self.par)
        # dx/dp along the Hugoniot from p = p_law(1/(v0 - x), e0 + (p + p0) x / 2)
        x_p = (1.0 - 0.5 * p_e * x) / (rho * rho * p_rho + 0.5 * p_e * (p + self.state.pressure))
        if x <= 0.0:
            return 1.0 / (rho * self.c)
        return 0.5 * (x + rise * x_p) / math.sqrt(rise * x)

    def wave(self, p: float) -> Wave:
        behind, state, d = self.behind(p), self.state, self.direction
        if abs(p - state.pressure) <= 1e-15 * max(abs(p), abs(state.pressure)):
            edge = state.particle_velocity + d * self.c
            return Wave("none", state, state, edge, edge, d)
        if p > state.pressure:
            return Wave("shock", state, behind, behind.shock_velocity, behind.shock_velocity, d)
        return Wave("fan", replace(state, par=self.elastic), behind, state.particle_velocity + d * self.head,
                    behind.particle_velocity + d * behind.sound_speed, d)

    def cavity(self) -> tuple[States, float]:
        """State and velocity of a surface into nothing: zero pressure (by a shock if in tension), or full expansion for a gas."""
        if self.state.pressure < 0.0:
            surface = self.behind(0.0)
            return surface, surface.particle_velocity
        if self.state.pressure == 0.0 and "gas" not in EOS.of(self.par).flags:
            return self.state, self.state.particle_velocity
        try:
            speed = release_path.escape(self.elastic, self.state)
        except OutOfRange:
            surface = self.behind(0.0)
            return surface, surface.particle_velocity
        u = self.state.particle_velocity - self.direction * speed
        return States(self.par, 0.0, 0.0, 0.0, u), u


def _separated(left: _Side, right: _Side) -> Riemann | None:
    """The solution with a vacuum in the middle, if the two surfaces run apart."""
    if right.state.particle_velocity <= left.state.particle_velocity and min(left.state.pressure, right.state.pressure) >= 0.0:
        return None
    surfaces = left.cavity(), right.cavity()
    if surfaces[0][1] >= surfaces[1][1]:
        return None
    waves = []
    for side, (surface, u) in zip((left, right), surfaces):
        d = side.direction
        tail = u if surface.density == 0.0 else u + d * surface.sound_speed
        head = side.state.particle_velocity + d * side.head
        if side.state.pressure < 0.0:
            waves.append(side.wave(0.0))
        else:
            kind = "fan" if side.state.pressure > 0.0 else "none"
            waves.append(Wave(kind, replace(side.state, par=side.elastic), surface, head, tail, d))
    return Riemann(*waves, pressure=0.0, velocity=math.nan, vacuum=True)


def _meet(left: _Side, right: _Side, bonded: bool) -> float:
    """The pressure at which both curves have one velocity."""
    def gap(p):
        a, b = left.behind(p), right.behind(p)
        return b.particle_velocity - a.particle_velocity, right.slope(p, b) + left.slope(p, a)

    za, zb = left.state.density * left.c, right.state.density * right.c
    p = (zb * left.state.pressure + za * right.state.pressure
         + za * zb * (left.state.particle_velocity - right.state.particle_velocity)) / (za + zb)
    floor = -math.inf if bonded else 0.0
    lowest_given = min(left.state.pressure, right.state.pressure)
    if p <= floor:
        highest = max(left.state.pressure, right.state.pressure, 1e-9 * (za * left.c + zb * right.c))
        p = 0.5 * (floor + (lowest_given if lowest_given > floor else highest)) if math.isfinite(floor) else lowest_given
    low, high = floor, math.inf
    for _ in range(200):
        g, slope = gap(p)
        if g == 0.0:
            return p
        low, high = (p, high) if g < 0.0 else (low, p)
        new = p - g / slope
        if math.isfinite(high) and math.isfinite(low) and not low < new < high:
            new = math.sqrt(low * high) if low > 0.0 else 0.5 * (low + high)
        elif new <= low:
            new = 0.1 * p if low == 0.0 else 0.5 * (p + low)
        elif new >= high:
            new = 0.5 * (p + high)
        new = min(new, 100.0 * p) if p > 0.0 else new
        if abs(new - p) <= 2e-15 * max(abs(p), 1e-3 * (za + zb) * 1e-6):
            return new
        p = new
    if abs(g) <= 1e-9 * (left.c + right.c):
        return p
    raise NoSolution(f"the wave curves of '{EOS.of(left.par).name}' and '{EOS.of(right.par).name}' did not intersect "
                     f"between {low:.6g} and {high:.6g} Pa")


def _fill(rows, names, xi, mine, wave: Wave):
    """Write the states of one side: ahead, inside the fan, behind."""
    d = wave.direction
    outer = mine & (d * xi >= d * wave.head)
    inside = mine & (d * xi < d * wave.head) & (d * xi > d * wave.tail) & (wave.kind == "fan")
    for name in names:
        rows[name][mine] = getattr(wave.behind, name)
        rows[name][outer] = getattr(wave.ahead, name)
    if inside.any():
        order = np.argsort(-d * xi[inside])
        index = np.flatnonzero(inside)[order]
        here = wave.ahead
        for i in index:
            here = _in_fan(wave, here, xi[i])
            for name in names:
                rows[name][i] = getattr(here, name)


def _in_fan(wave: Wave, near: States, xi: float) -> States:
    """The state of the fan on the characteristic u + d c = xi, from a neighbouring state of the same fan."""
    d, par, here = wave.direction, wave.ahead.par, near
    for _ in range(100):
        rho, e = here.density, here.specific_internal_energy
        c = math.sqrt(contract.sound_speed_squared(rho, e, par))
        miss = d * (xi - here.particle_velocity) - c
        # d(u + c)/dln(rho) = c G, G = 1 + dln(c)/dln(rho) the fundamental derivative, by a one-sided difference along the isentrope
        near_by = release_path.isentrope(par, here, density=rho * (1.0 - 1e-5), direction=d)
        slope = c + (c - near_by.sound_speed) / 1e-5
        step = min(max(miss / slope, -0.7), 0.1)
        if abs(step) < 1e-14:
            break
        here = release_path.isentrope(par, here, density=rho * math.exp(step), direction=d)
        if abs(step) < 1e-8:
            break
    return here
