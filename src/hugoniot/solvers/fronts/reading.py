"""Zones and gauges of a line of tracked fronts: material points, read off from whatever stands there.

Both modes follow no zones: a zone, or a gauge, is a fraction of a region's mass, and a `Column` says where that is and in what state.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from hugoniot.laws.eos.contract import flagged
from hugoniot.laws.riemann.branch import elastic, wave_speed_squared
from hugoniot.laws.riemann.medium import Frozen, mixed_phases
from hugoniot.problem.model import Problem
from hugoniot.problem.profiles import velocities_at
from hugoniot.solvers.fronts import extremes, setup
from hugoniot.solvers.protocol import Event, NothingToAdd
from hugoniot.state import State

SLICES = 8            # of a zone, for the mass of a region whose density varies
SAMPLES = 1000        # of the gauges over a run, where no interval is given
GAUGE_FIELDS = ("position", "velocity", "density", "energy", "pressure", "deviator_radial", "deviator_hoop", "stress", "compaction")
ZONE_FIELDS = ("density", "energy", "pressure", "deviator_radial", "deviator_hoop", "stress", "sound_speed", "compaction")


class Reading(NothingToAdd):
    """What both modes hand out; a mode gives `matters`, `time`, `cycle`, `column(region)`, `totals`, `exchanged`, `size` and `lives`."""

    voids_opened = voids_closed = 0
    lives: Any
    matters: list
    burning = False      # whether something burns: then a burn fraction is recorded

    def __init__(self, problem: Problem):
        self.problem = problem
        left, right, self.region_of = setup.zone_faces(problem)
        self.initial_nodes = left, right
        self.remembers = any(flagged(problem.materials[region.material].eos, "remembers") for region in problem.regions)
        self._masses: dict[int, tuple[np.ndarray, np.ndarray]] = {}
        ends = zip(left, right, self.region_of.tolist())
        self.fractions = tuple(np.array(row) for row in zip(*((self._share(k, a), self._share(k, b)) for a, b, k in ends)))
        self._events: list[Event] = []
        self.cycle, self.step = 0, 0.0
        self.length = problem.regions[-1].end - problem.regions[0].start
        self.gauges = np.array([self._place(gauge.at) for gauge in problem.gauges], dtype=float).reshape(-1, 2)
        self.interval = problem.output.gauge_interval or problem.stop_time / SAMPLES
        self.samples, self._rows, self._times = 0, [], []

    @property
    def time(self) -> float:
        """s."""
        raise NotImplementedError

    def column(self, region: int) -> Any:
        """The material of a region now: `mass` (cumulated) and at(fraction of it) -> (position, state)."""
        raise NotImplementedError

    def _share(self, k: int, x: float) -> float:
        """How much of a region's mass is on the left of a place at t = 0; volumes, where its density does not vary."""
        r, d = self.problem.regions[k], self.problem.dimension
        share = min((x**d - r.start**d) / (r.end**d - r.start**d), 1.0)
        if r.profile is None:
            return share
        if k not in self._masses:
            faces = np.linspace(r.start, r.end, SLICES * r.zones + 1)
            rho, _ = setup.start_states(r, self.problem.materials[r.material], 0.5 * (faces[1:] + faces[:-1]))
            mass = np.concatenate([[0.0], np.cumsum(rho * np.diff(faces**d))])
            self._masses[k] = (faces**d, mass / mass[-1])
        return float(np.interp(x**d, *self._masses[k]))

    # -- gauges ------------------------------------------------------------------------------------------------------
    def _place(self, at) -> tuple[float, float]:
        """(region, fraction of its mass on the left) of a gauge."""
        regions = self.problem.regions
        names = [region.name for region in regions]
        if not isinstance(at, str):
            k = max(k for k, region in enumerate(regions) if region.start <= at)
            return float(k), self._share(k, at)
        if at.startswith("free surface"):
            return (0.0, 0.0) if at.endswith("left") else (len(regions) - 1.0, 1.0)
        if ":" in at:
            name, side = (part.strip() for part in at.split(":", 1))
            return float(names.index(name)), 0.0 if side == "left" else 1.0
        return float(names.index(at.split("/", 1)[0].strip())), 1.0

    def _struck(self) -> bool:
        """Whether a gauge is on a face at which two bodies that touch have different velocities at t = 0: it has no one velocity then."""
        regions = self.problem.regions
        for k, share in ((int(k), float(share)) for k, share in self.gauges):
            left, right = (k, k + 1) if share == 1.0 else (k - 1, k)
            if share in (0.0, 1.0) and left >= 0 and right < len(regions) and regions[left].end == regions[right].start:
                face = np.array([regions[right].start])
                if velocities_at(regions[left], face)[0] != velocities_at(regions[right], face)[0]:
                    return True
        return False

    def _next_sample(self) -> float:
        return self.samples * self.interval if len(self.gauges) else math.inf

    def _sample(self) -> None:
        self.samples += 1
        row, columns = [], {}
        for region, fraction in self.gauges:
            k = int(region)
            if k not in columns:
                columns[k] = self.column(k)
            x, point, matter, burned = self._point(k, columns[k], fraction)
            found = [x, self._velocity(k, fraction, point), point.rho, point.e, point.pressure, point.s, _hoop(point, matter),
                     self._stress(k, fraction, point), point.compaction]
            row.append([*found, *_phases(point, matter, burned)] if self.burning else found)
        self._times.append(self.time)
        self._rows.append(row)

    def _velocity(self, region: int, fraction: float, point) -> float:
        """Velocity at a gauge, m/s."""
        return point.u

    def _stress(self, region: int, fraction: float, point) -> float:
        """Stress at a gauge, Pa; of states between exact fronts that of a surface is the one applied to it."""
        return point.sigma

    @property
    def gauge_zones(self) -> np.ndarray:
        """Index of the zone that each gauge lies in, (ngauge,)."""
        low, high = self.fractions
        inside = [np.flatnonzero((self.region_of == region) & (low <= at) & (at <= high))[-1] for region, at in self.gauges]
        return np.array(inside, dtype=np.int64)

    def take_gauges(self):
        """(times, {field: (n, ngauge)}) recorded since the last call."""
        times = np.array(self._times)
        first = len(GAUGE_FIELDS)
        block = np.array(self._rows, dtype=float).reshape(len(times), len(self.gauges), first + 5 * self.burning)
        self._times, self._rows = [], []
        found = {name: block[:, :, i] for i, name in enumerate(GAUGE_FIELDS) if name != "compaction" or self.remembers}
        if self.burning:
            phases = np.repeat(block[:, :, None, first:], 2, axis=2)
            found |= {"burn_fraction": block[:, :, first], "share": np.zeros(block.shape[:2]), "phases": phases}
        return times, found

    # -- what observers see ------------------------------------------------------------------------------------------
    def state(self) -> State:
        """The zones of the problem now: each follows its material; its fields are those at the middle of its mass."""
        low, high = self.fractions
        count = len(self.region_of)
        rows = np.zeros((count, len(ZONE_FIELDS) + 1))
        faces, speeds = np.zeros((2, count)), np.zeros((2, count))
        masses, middle = np.zeros(count), np.zeros(count)
        for k in range(len(self.problem.regions)):
            column = self.column(k)
            zones = np.flatnonzero(self.region_of == k)
            masses[zones] = (high[zones] - low[zones]) * column.mass[-1]
            ends = [column.at(f) for f in [*low[zones], high[zones[-1]]]]
            for j, z in enumerate(zones):
                faces[:, z], speeds[:, z] = (ends[j][0], ends[j + 1][0]), (ends[j][1].u, ends[j + 1][1].u)
                middle[z], point, matter, burned = self._point(k, column, 0.5 * (low[z] + high[z]))
                square = wave_speed_squared(point.rho, point.e, elastic(matter, point)) if self._answers(k, point) else 0.0
                rows[z] = (point.rho, point.e, point.pressure, point.s, _hoop(point, matter), point.sigma,
                           math.sqrt(max(square, 0.0)), point.compaction, burned)
        zones = {name: rows[:, i].copy() for i, name in enumerate(ZONE_FIELDS) if name != "compaction" or self.remembers}
        zones |= {"plastic_work": np.zeros(count), "viscous_work": np.zeros(count), "mass": masses}
        if self.burning:
            zones["burn_fraction"] = rows[:, -1].copy()
        return FrontState(self.time, self.cycle, zones, faces[0], faces[1], speeds[0], speeds[1], middle)

    def phases(self) -> np.ndarray | None:
        """Burn fraction, density and energy of reactants and of products in the middle of every zone, (5, nzone), where something burns."""
        if not self.burning:
            return None
        low, high = self.fractions
        columns = [self.column(k) for k in range(len(self.problem.regions))]
        rows = [_phases(*self._point(k, columns[k], 0.5 * (low[z] + high[z]))[1:]) for z, k in enumerate(self.region_of)]
        return np.array(rows).T

    def _point(self, region: int, column, fraction: float):
        """(position, state, what it is made of, burn fraction) of a material point."""
        return *column.at(fraction), self.matters[region], 0.0

    def _answers(self, region: int, point) -> bool:
        """Whether the law of a region answers for a state: not for nothing at all, nor for unburned explosive."""
        return point.rho > 0.0 and (self.problem.materials[self.problem.regions[region].material].burn is None or point.sigma != 0.0)

    def largest_velocity_jump(self) -> dict[str, float]:
        """Material -> largest change of velocity across a shock in it, m/s."""
        found: dict[str, float] = {}
        for k, region in enumerate(self.problem.regions):
            found[region.material] = max(found.get(region.material, 0.0), self.lives.jumps.get(k, 0.0))
        return found

    def peaks(self) -> dict[str, np.ndarray]:
        """Extremes of every zone, at the middle of its mass: stress and pressure in compression, tension positive, density."""
        found = self._extremes_so_far()
        zones = self.state().zones
        extremes.update(found, slice(None), zones["stress"], zones["pressure"], zones["density"])
        return extremes.named(found)

    def _extremes_so_far(self) -> np.ndarray:
        """Rows of `extremes.NAMES`, (4, nzone)."""
        raise NotImplementedError

    @property
    def middles(self) -> np.ndarray:
        """Share of its region's mass on the left of the middle of every zone, (nzone,)."""
        return 0.5 * (self.fractions[0] + self.fractions[1])

    @property
    def tensions(self) -> np.ndarray:
        """Largest tension (Pa) that every region met, (regions,)."""
        return np.array([self.lives.tensions.get(k, 0.0) for k in range(len(self.problem.regions))])

    def _log(self, kind: str, time: float, position: float, text: str) -> None:
        self._events.append(Event(kind, time, self.cycle, position, f"{text} at {position:.6g} m"))
        if "vacuum opens" in text:
            self.voids_opened += 1
        if "surface with surface" in text or text.startswith("2 x surface"):
            self.voids_closed += 1


def _phases(point, matter, burned: float) -> list[float]:
    """Burn fraction, rho_r, e_r, rho_p, e_p of a material point; of what is no mixture both phases are as the whole."""
    if isinstance(matter.par, Frozen):
        mixed = mixed_phases(point.rho, point.e, burned, matter.par.volume, matter.par.energy, matter.par.mixture)
        return [burned, mixed.rho_r, mixed.e_r, mixed.rho_p, mixed.e_p]
    return [burned, point.rho, point.e, point.rho, point.e]


def _hoop(point, matter) -> float:
    """Deviator along the hoop, Pa."""
    return -0.5 * point.s + matter.shear_modulus * matter.hoop


@dataclass(frozen=True)
class FrontState(State):
    """A state whose file holds what exact waves have: no work of viscosity, no sum of plastic work.

    middle   place of the middle of every zone's mass, where its fields are given, (nzone,) m
    """

    middle: np.ndarray

    @property
    def position_middle(self) -> np.ndarray:
        return self.middle

    def fields(self) -> dict[str, np.ndarray]:
        return {name: value for name, value in super().fields().items() if name not in ("plastic_work", "viscous_work")}

