r"""The wave curve of one side of a Riemann problem: what the material becomes behind its waves, against the longitudinal stress.

A fluid answers compression with one shock and release with one fan. An elastic-perfectly plastic solid in uniaxial strain answers with an
elastic wave up to its yield point and a plastic wave behind it; where the plastic shock would outrun the elastic one, both are one shock.
Feeble expansions may be asked for as jumps (`as_jumps`), which keeps the conservation laws exact where a fan has to be cut up.

Material whose pores stay crushed answers release, and compression up to its elastic limit, on the elastic branch of its law; beyond the
limit the pores go on closing. The compaction wave follows the elastic precursor as the plastic wave follows it in a solid, and merges with
it where it would be the faster one. Where the crush curve bends the other way at first, it begins with a fan (`spreading`).

Source: Courant and Friedrichs, sections 54 to 81; Wilkins B.1 items 5 and 9 for the yield condition; Herrmann, J. Appl. Phys. 40, 2490
(1969) for the two waves in porous material.
"""

import math
from dataclasses import dataclass, replace

from hugoniot.core.ops import NO_LIMIT
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import elastic_limit
from hugoniot.laws.riemann import jump, spreading
from hugoniot.laws.riemann.branch import (
    Branch,
    Matter,
    State,
    elastic,
    has_memory,
    loading,
    plastic,
    shocks_only,
    wave_speed_squared,
    yield_density,
)
from hugoniot.laws.riemann.fan import SPRAY, Fan
from hugoniot.laws.riemann.medium import Solid, is_gas, name_of, strength_left
from hugoniot.laws.riemann.solid import TURNS, turned
from hugoniot.laws.riemann.spreading import AT_LIMIT, NARROW, Spreading


@dataclass(frozen=True)
class Wave:
    """One wave.

    kind         "shock" (a jump of either sign), "fan"
    elastic      whether it is the elastic wave of a solid, or of porous material below its elastic limit
    direction    -1 into the left, +1 into the right material
    ahead, behind, head, tail   states, and velocities of the edges in the laboratory, m/s (equal for a shock)
    path         the `Fan` behind a fan, None for a shock
    attached     whether it runs directly behind the wave ahead of it, at the same speed: a shock at the tail of a fan, a fan behind a jump
    smooth       whether it is a jump of rising stress that stands for a fan
    """

    kind: str
    elastic: bool
    direction: int
    ahead: State
    behind: State
    head: float
    tail: float
    path: Fan | None = None
    stiffness: float = 0.0
    attached: bool = False
    smooth: bool = False

    @property
    def strength(self) -> float:
        """Change of stress over rho c^2 of the softer side: 0 for nothing, of order 1 for a strong wave."""
        rise = abs(self.behind.sigma - self.ahead.sigma)
        return rise / max(abs(self.ahead.sigma), abs(self.behind.sigma), self.stiffness)


class Curve:
    """The wave curve from `state` of `matter`, for waves that run in `direction`.

    as_jumps        releases are jumps too (their entropy falls with the cube of their strength)
    elastic_jumps   elastic releases are, which are as feeble as the elastic range is narrow
    Raises `OutOfRange` for a state the law does not answer.
    """

    def __init__(self, matter: Matter, state: State, direction: int, as_jumps: bool = False, elastic_jumps: bool = False):
        self.matter, self.state, self.direction, self.as_jumps = matter, state, direction, as_jumps
        self.elastic_jumps = as_jumps or elastic_jumps
        self.solid = matter.yield_stress > 0.0
        self.branch = elastic(matter, state)
        square = wave_speed_squared(state.rho, state.e, self.branch) if state.rho > 0.0 else math.nan
        if not square >= 0.0:
            side = "left" if direction < 0 else "right"
            raise OutOfRange(f"the {side} state ({state.rho:.6g} kg/m3, {state.e:.6g} J/kg) is not a valid state of law "
                             f"'{name_of(matter.par)}': c^2 = {square:.4g} m2/s2")
        if square == 0.0 and state.sigma < 0.0:
            raise OutOfRange(SPRAY.format(name_of(matter.par), -state.sigma))
        self.c = math.sqrt(square)
        self.stiffness = state.rho * square
        self._limits: dict[int, tuple[State, float]] = {}
        self._fans: dict[str, Fan] = {}
        self._compaction: Spreading | None = None
        self.loading, self.crushing = self.branch, NO_LIMIT
        if has_memory(matter.par):
            self.loading = loading(matter, state)
            self.crushing = elastic_limit(self.loading.par)
        self.porous = self.crushing < NO_LIMIT
        self.straight = has_memory(matter.par) or shocks_only(matter.par)      # branches may be straight in p and v

    # -- elastic limits ----------------------------------------------------------------------------------------------
    def _limit(self, way: int) -> tuple[State, float]:
        """(state at the elastic limit in compression 1 or extension -1, mass flux of the jump to it)."""
        if way not in self._limits and self.porous:
            at_limit = self.crushing - self.state.sigma <= AT_LIMIT * self.stiffness
            self._limits[way] = (self.state, math.inf) if at_limit else jump.behind(self.crushing, self.state, self.branch, self.direction)
        if way not in self._limits:
            rho = yield_density(self.matter, self.state, way)
            s = -way * 2.0 / 3.0 * self.matter.yield_stress
            if abs(rho / self.state.rho - 1.0) < 1e-13:
                found = self.state, math.inf
            elif way > 0 or self.elastic_jumps:
                found = jump.to_density(rho, self.state, self.branch, self.direction, s)
            else:
                fan = self._fan("elastic", self.state, self.branch)
                found = fan.state(fan.at_density(rho), self.direction)._replace(s=s), math.inf
            self._limits[way] = found
        return self._limits[way]

    def _fan(self, name: str, ahead: State, branch: Branch) -> Fan:
        if name not in self._fans:
            self._fans[name] = Fan(ahead, branch)
        return self._fans[name]

    # -- the curve ---------------------------------------------------------------------------------------------------
    def waves(self, sigma: float) -> list[Wave]:
        """The waves, outermost first, that leave the stress sigma behind them."""
        if sigma == self.state.sigma:
            return []
        way = 1 if sigma > self.state.sigma else -1
        if not self.solid and not (self.porous and way > 0):
            return [self._one(sigma, self.state, self.branch, False)]
        limit, flux = self._limit(way)
        if limit is self.state:
            return self._crush(sigma, limit) if self.porous else [
                self._one(sigma, self.state, self._plastic(sigma, self.state, way)[0], False)]
        if (sigma - limit.sigma) * way <= 0.0:
            return [self._one(sigma, self.state, self.branch, True)]
        first = self._one(limit.sigma, self.state, self.branch, True, limit, flux)
        if self.porous:
            return self._behind_precursor(sigma, first)
        second = self._one(sigma, limit, self._plastic(sigma, limit, way)[0], False)
        if way > 0 and second.head * self.direction >= first.tail * self.direction:
            branch, deviator = self._plastic(sigma, self.state, way)
            return [self._one(sigma, self.state, branch, False, deviator=deviator)]
        return [first, second]

    # -- pores that close ----------------------------------------------------------------------------------------------
    def _behind_precursor(self, sigma: float, first: Wave) -> list[Wave]:
        """The precursor and the waves that close pores behind it; one shock where they would outrun it."""
        found = self._crush(sigma, first.behind)
        lead = (found[0].head - first.tail) * self.direction
        if found[0].kind == "shock":
            return [self._lasting(self._one(sigma, self.state, self.loading, False))] if lead >= 0.0 else [first, *found]
        if lead > NARROW * self.c:
            raise OutOfRange(spreading.REVERSED.format(name_of(self.matter.par)))
        if lead < -NARROW * self.c:
            return [first, *found]
        return [first, replace(found[0], head=first.tail, attached=True), *found[1:]]

    def _crush(self, sigma: float, ahead: State) -> list[Wave]:
        """The waves that close pores, from a state at its elastic limit to a stress above it: a shock, a fan, or a fan and a shock."""
        direct = self._one(sigma, ahead, self.loading, False)
        flux, least = (direct.head - ahead.u) * self.direction * ahead.rho, math.sqrt(direct.stiffness * ahead.rho)
        feeble = sigma - ahead.sigma <= spreading.FEEBLE * direct.stiffness      # its own speed is lost in rounding: sound behind decides
        if flux >= least * (1.0 - NARROW) and not (feeble and spreading.overtaken(direct.behind, flux, self.loading)):
            return [self._lasting(direct)]
        if self.as_jumps:
            return [replace(direct, smooth=True)]
        path = self._spreading(ahead)
        node = path.shock_to(sigma)
        end = path.at_stress(sigma) if node is None else node
        after, d = path.state(end, self.direction), self.direction
        tail = after.u + d * path.speed(end)
        fan = Wave("fan", False, d, ahead, after if node else after._replace(sigma=sigma), ahead.u + d * path.speed(path.nodes[0]), tail,
                   path.until(end), self.stiffness)
        if node is None:
            return [fan]
        shock = self._one(sigma, after, loading(self.matter, after), False)
        return [replace(fan, tail=shock.head), self._lasting(replace(shock, attached=True))]

    def _lasting(self, wave: Wave) -> Wave:
        """A shock that closes pores; `OutOfRange` where it would outrun the sound behind it."""
        flux = (wave.head - wave.ahead.u) * self.direction * wave.ahead.rho
        rise = wave.behind.sigma - wave.ahead.sigma
        missed = AT_LIMIT * self.stiffness / max(rise, AT_LIMIT * self.stiffness)
        if spreading.overtaken(wave.behind, flux, self.loading, missed):
            raise OutOfRange(spreading.OVERTAKEN.format(name_of(self.matter.par), wave.behind.sigma))
        return wave

    def _spreading(self, ahead: State) -> Spreading:
        if self._compaction is None:
            self._compaction = Spreading(ahead, self.loading, self.matter.par)
        return self._compaction

    def _plastic(self, sigma: float, ahead: State, way: int) -> tuple[Branch, float]:
        """(branch, s1 behind) of a plastic wave to a stress; in a cylinder it turns the stress (solid.py)."""
        most, hoop = 2.0 / 3.0 * self.matter.yield_stress, self.matter.hoop
        if not hoop:
            return plastic(self.matter, way), -way * most
        shear = self.matter.shear_modulus
        law = Solid(self.matter.par, shear, math.hypot(self.matter.yield_stress, math.sqrt(3.0) * shear * hoop))
        branch, left, last = plastic(self.matter, way), most, 0.0
        for _ in range(TURNS):
            strain = abs(self._strain(sigma, ahead, branch))
            if abs(strain - last) <= 1e-13 * strain:
                break
            left, last = strength_left(turned(hoop, strain, law), law), strain
            stiff = (left - most) / strain
            branch = Branch(self.matter.par, way * most - stiff * math.log(ahead.rho), stiff)
        return branch, -way * left

    def _strain(self, sigma: float, ahead: State, branch: Branch) -> float:
        """ln of the densities behind and ahead of a wave."""
        if sigma > ahead.sigma or self.as_jumps:
            return -math.log1p(-ahead.rho * jump.volume_drop(sigma, ahead, branch))
        return Fan(ahead, branch).at_stress(sigma)[0]

    def _one(self, sigma, ahead: State, branch: Branch, is_elastic, after: State | None = None, flux=0.0, deviator=None) -> Wave:
        d = self.direction
        if self.porous and not is_elastic and sigma > ahead.sigma:
            square = spreading.loading_square(ahead, branch)
            after, flux = jump.behind(sigma, ahead, branch, d, None, square)
            speed = ahead.u + d * flux / ahead.rho
            return Wave("shock", False, d, ahead, spreading.crushed(after, self.matter.par), speed, speed, None, ahead.rho * square)
        if sigma > ahead.sigma or self.as_jumps or (is_elastic and self.elastic_jumps):
            if after is None:
                after, flux = jump.behind(sigma, ahead, branch, d, deviator)
            speed = ahead.u + d * flux / ahead.rho
            return Wave("shock", is_elastic, d, ahead, after, speed, speed, None, self.stiffness)
        fan = self._fan("elastic" if is_elastic else "plastic", ahead, branch) if not branch.b or is_elastic else Fan(ahead, branch)
        node = fan.at_stress(sigma)
        after = fan.state(node, d)._replace(sigma=sigma)
        head, tail = ahead.u + d * fan.speed(fan.nodes[0]), after.u + d * fan.speed(node)
        if self.straight and abs(head - tail) <= NARROW * self.c:      # a branch straight in the volume: a jump is as exact
            after, flux = jump.behind(sigma, ahead, branch, d, deviator)
            speed = ahead.u + d * flux / ahead.rho
            return Wave("shock", has_memory(self.matter.par), d, ahead, after, speed, speed, None, self.stiffness)
        return Wave("fan", is_elastic, d, ahead, after, head, tail, fan, self.stiffness)

    def at(self, sigma: float) -> tuple[State, float, list[Wave]]:
        """(innermost state, d|u|/dsigma, waves) at the stress sigma."""
        found = self.waves(sigma)
        if not found:
            return self.state, 1.0 / (self.state.rho * self.c) if self.c else math.inf, found
        last = found[-1]
        branch = self._branch_of(last)
        if last.kind == "fan":
            impedance = last.behind.rho * math.sqrt(wave_speed_squared(last.behind.rho, last.behind.e, branch))
            return last.behind, 1.0 / impedance if impedance > 0.0 else math.inf, found
        flux = (last.head - last.ahead.u) * self.direction * last.ahead.rho
        return last.behind, jump.slope(sigma, last.ahead, last.behind, branch, flux), found

    def _branch_of(self, wave: Wave) -> Branch:
        if self.porous and not wave.elastic and wave.behind.sigma > wave.ahead.sigma:
            return self.loading
        if not self.solid or wave.elastic:
            return self.branch
        return self._plastic(wave.behind.sigma, wave.ahead, 1 if wave.behind.s < 0.0 else -1)[0]

    # -- the end of the curve ----------------------------------------------------------------------------------------
    @property
    def gas(self) -> bool:
        """Whether the material expands without bound."""
        return is_gas(self.matter.par)

    @property
    def bears_tension(self) -> bool:
        """Whether it can be held where it is pulled."""
        return not self.gas and not shocks_only(self.matter.par)

    def surface(self) -> tuple[float, list[Wave]]:
        """(velocity, waves) of the surface towards nothing: zero stress, or for a gas the complete expansion."""
        fan = self._fan("plastic" if not self.solid else "elastic", self.state, self.branch)
        reach = fan.complete() if self.gas and self.state.sigma > 0.0 and not self.as_jumps else None
        if reach is None:
            after, _, found = self.at(0.0)
            return after.u, found
        edge = self.state.u + self.direction * reach
        head = self.state.u + self.direction * self.c
        return edge, [Wave("fan", False, self.direction, self.state, State(0.0, edge, 0.0, 0.0), head, edge, fan, self.stiffness)]
