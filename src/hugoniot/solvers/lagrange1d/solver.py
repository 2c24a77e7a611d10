"""The one-dimensional Lagrangian solver: owns the arrays, marches them, opens and closes voids, hands out states and budgets.

Knows a problem's numbers and laws; never files, decks or plots. `march` takes steps until something happens and says what.
"""

import os
import threading
from dataclasses import dataclass

import numpy as np

from hugoniot.core import team
from hugoniot.core.ops import NO_LIMIT
from hugoniot.errors import UnphysicalState
from hugoniot.laws.eos.contract import reference_state
from hugoniot.mesh.line import GEOMETRY
from hugoniot.problem.defaults import completed
from hugoniot.problem.model import Problem
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d import reactive
from hugoniot.solvers.lagrange1d.assemble import assemble, boundary_pulse, held_stresses, recipes_of, viscosity_of
from hugoniot.solvers.lagrange1d.bodies import alike_ranges, interface_table, join, run_table, set_node_masses, shares_of, split
from hugoniot.solvers.lagrange1d.layout import B, H, WorkRows, Z
from hugoniot.solvers.lagrange1d.post_mortem import crushed_zone, diagnose, ill_burned
from hugoniot.solvers.lagrange1d.probes import probe_tables
from hugoniot.solvers.lagrange1d.step import SCHEMES, Gauges, march, serve
from hugoniot.solvers.lagrange1d.tables import zone_table
from hugoniot.solvers.lagrange1d.watch import cavity_closed, mark_patch, touching_gap
from hugoniot.solvers.lagrange1d.work import Arrays, Steps, enter, steps_of
from hugoniot.state import State
from hugoniot.zones.closure import remembers
from hugoniot.zones.recipe import Recipe
from hugoniot.zones.soundness import FOUND_FLOATS

NAME = "lagrange1d"
ZONE_FIELDS = {"density": Z.rho, "energy": Z.e, "pressure": Z.p, "viscous_pressure": Z.q, "deviator_radial": Z.s1,
               "deviator_hoop": Z.s2, "stress": Z.sigma, "sound_speed": Z.c, "plastic_strain": Z.plastic_strain, "damage": Z.damage,
               "plastic_work": Z.plastic_work, "viscous_work": Z.viscous_work}
GAUGE_CAPACITY = 2048
WORTH_SHARING = 10_000
LARGEST_COLLAPSE = 1e-12     # smallest useful step as a fraction of the stop time


@dataclass(frozen=True)
class Event:
    """Something that happened between two steps: kind, place (m), and a sentence."""

    kind: str
    time: float
    cycle: int
    position: float
    text: str


class Lagrange1D:
    """A run in progress."""

    def __init__(self, problem: Problem):
        self.problem = problem = completed(problem)
        self.geometry = GEOMETRY.get(problem.geometry).example
        self.scheme = SCHEMES[problem.solver.integrator]
        self.staggered = self.scheme.staggered
        self.team = self._team()
        self.book, self.recipe_of = recipes_of(problem)
        self.steps, self.flux = np.zeros((1, len(Steps._fields)), dtype=np.int64), np.zeros(2)
        self.viscosity = viscosity_of(problem)
        self.table, self.charge_table, self.nodes, self.gradient, self.segments, self.region_ranges = assemble(problem)
        self.zones = self.table[:, :self.region_ranges[-1][1]]
        self.burning = any(reactive.burns(problem, region) for region in problem.regions)
        self.charge = self.charge_table[:, :self.region_ranges[-1][1] if self.burning else 0]
        self.work = zone_table(len(WorkRows._fields), self.team.threads * L.PIECE)
        remembering = any(remembers(problem.materials[region.material].eos) for region in problem.regions)
        self.zone_fields = ZONE_FIELDS | ({"compaction": Z.compaction} if remembering else {})
        set_node_masses(self.zones, self.nodes, self.segments)
        self.boundaries = (boundary_pulse(problem.left), boundary_pulse(problem.right))
        self.control = np.zeros(L.CONTROL_FLOATS)
        self.counters = np.zeros(L.CONTROL_INTS, dtype=np.int64)
        self.voids_opened = self.voids_closed = self.interfaces_parted = 0
        self.region_of = np.repeat(np.arange(len(problem.regions)), [b - a for a, b in self.region_ranges])
        self.initial_nodes = self._faces(H.r)
        self._start()
        self._retopologise()
        self._new_buffer()
        passes = steps_of(self.staggered, self.geometry, [Recipe(*line) for line in self.book.recipes])
        self.steps[0] = enter(self._arrays(), passes, self.staggered)
        self.start_energy, self.start_mass, self.start_momentum = self.total_energy(), self.zones[Z.mass].sum(), self.momentum()

    # -- setting up ------------------------------------------------------------------------------------------
    def _start(self):
        options, control = self.problem.solver, self.control
        control[L.HEAT_FLUX] = options.options["heat_flux"]
        control[L.COURANT] = options.courant
        control[L.GROWTH] = options.growth
        control[L.DT_LARGEST] = options.largest_step or NO_LIMIT
        control[L.DT_SMALLEST] = LARGEST_COLLAPSE * self.problem.stop_time
        control[L.GAUGE_INTERVAL] = self.problem.output.gauge_interval
        control[L.REFERENCE_LEFT], control[L.REFERENCE_RIGHT] = held_stresses(self.zones, self.nodes)
        for side, node in ((self.problem.left, 0), (self.problem.right, -1)):
            if side.kind == "velocity":
                self.nodes[H.u, node] = _pulse_at_zero(side.pulse)
            if side.kind == "fixed":
                self.nodes[H.u, node] = 0.0
        self.plan_first_step()

    def plan_first_step(self) -> None:
        """The first step, and the velocity gradients that the viscosity's limiter looks back at, from the zones as they are."""
        options, control = self.problem.solver, self.control
        control[L.RATE] = self._signal_rate(np.arange(self.zones.shape[1]))
        first = options.initial_step or 0.1 * control[L.COURANT] / control[L.RATE]
        control[L.DT_NATURAL] = first / control[L.GROWTH]
        control[L.DT] = control[L.DT_OLD] = first if self.staggered else 0.0
        self.renew_gradients()

    def renew_gradients(self) -> None:
        """Velocity gradients from the nodes as they are."""
        left, right = self._faces(H.r)
        ul, ur = self._faces(H.u)
        self.gradient[self._gradient_index()] = (ur - ul) / (right - left)

    def _team(self):
        """The threads that share the work: alone below 10 000 zones, where sharing costs more than it gives."""
        zones = sum(region.zones for region in self.problem.regions)
        threads = min(self.problem.solver.threads, os.cpu_count() or 1)
        if threads < 2 or zones < WORTH_SHARING or not team.possible():
            return team.Alone()
        return team.Together(threads, team.board(threads))

    def _signal_rate(self, zones):
        """Largest (c + 2 w) / width, w the viscous speed of a jump as a shock sees it; guards the first step and every impact."""
        left, right = self._faces(H.r)
        ul, ur = self._faces(H.u)
        jump = np.maximum(ul - ur, 0.0)[zones]
        fronts = np.array([reactive.front_speed(self.problem, region) for region in self.problem.regions])
        speed = np.maximum(self.zones[Z.c, zones], fronts[self.region_of[zones]]) + (16.0 if self.staggered else 4.0) * jump
        rate = float(np.max(speed / (right - left)[zones]))
        return rate if rate > 0.0 else 1e3 / self.problem.stop_time

    def _new_buffer(self):
        self.gauge_times = np.zeros(GAUGE_CAPACITY)
        columns = L.BURNING_GAUGE_COLUMNS if self.burning else len(L.GAUGE_FIELDS)
        self.gauge_buffer = np.zeros((GAUGE_CAPACITY, len(self.problem.gauges), columns))
        self.counters[L.GAUGE_ROWS] = 0

    def _retopologise(self):
        """Everything that depends on which zones are joined."""
        regions, ranges = self.problem.regions, self.region_ranges
        alike = alike_ranges(regions, ranges, [reactive.burns(self.problem, region) for region in regions])
        self.runs, self.spans, self.flux_ranges = shares_of(run_table(self.segments, ranges, self.recipe_of), self.segments, alike)
        self.found, self.dts = np.zeros((len(self.runs) + 1, FOUND_FLOATS)), np.zeros(2)
        self.interfaces = interface_table(self.segments, self.nodes)
        self.gauges, self.weights = probe_tables(self)
        self.segment_of = np.repeat(np.arange(len(self.segments)), self.segments[:, 1] - self.segments[:, 0])

    def _left_nodes(self):
        return np.concatenate([np.arange(a, b) + k for k, (a, b, _, _) in enumerate(self.segments)])

    def _gradient_index(self):
        return np.concatenate([np.arange(a, b) + 2 * k + 1 for k, (a, b, _, _) in enumerate(self.segments)])

    def _faces(self, row):
        """A node row at the left and right face of every zone."""
        left = self._left_nodes()
        return self.nodes[row, left], self.nodes[row, left + 1]

    # -- marching --------------------------------------------------------------------------------------------
    @property
    def time(self) -> float:
        return float(self.control[L.TIME])

    @property
    def cycle(self) -> int:
        return int(self.counters[L.CYCLE])

    @property
    def step(self) -> float:
        """The last time step, s."""
        return float(self.control[L.DT])

    @property
    def zone_updates(self) -> int:
        return int(self.counters[L.ZONE_STEPS])

    @property
    def capped(self) -> int:
        """How often the tension of a failing zone was held at its spall strength."""
        return int(self.counters[L.CAP_COUNT])

    def limiting(self) -> tuple[int, str]:
        """(zone, region name) with the shortest transit time."""
        left, right = self._faces(H.r)
        zone = int(np.argmin((right - left) / np.maximum(self.zones[Z.c], 1e-30)))
        return zone, self.problem.regions[self.region_of[zone]].name

    def march(self, until: float, cycles: int) -> list[Event]:
        """Step until the time `until` (hit exactly), `cycles` steps, a full gauge buffer or an event; the events that happened."""
        if until <= self.time:
            return []
        self.control[L.EVENT_TIME] = until
        arrays = self._arrays()
        members = self._assemble_team(arrays)
        try:
            code = march(cycles, arrays, self.scheme, self.geometry, self.boundaries, self.team,
                         Gauges(self.gauges, self.weights, self.gauge_times, self.gauge_buffer))
        finally:
            if members:
                team.call(self.team.board, team.DISMISSED)
                for member in members:
                    member.join()
        if code in (L.BAD_STATE, L.STEP_COLLAPSED):
            raise self._unphysical(code)
        if code == L.VOID_OPENS:
            return [self._open(int(self.counters[L.CULPRIT]), "spall")]
        if code == L.INTERFACE_OPENS:
            return [self._open(int(self.interfaces[self.counters[L.CULPRIT], 0]), "interface")]
        if code == L.VOID_CLOSES:
            return self._close_gaps()
        return []

    def _arrays(self) -> Arrays:
        return Arrays(self.table, self.charge_table, self.nodes, self.gradient, self.work, self.steps, self.book.recipes,
                      self.book.constants, self.flux, self.runs, self.spans, self.flux_ranges, self.found, self.dts, self.control,
                      self.counters, self.segments, self.interfaces)

    def _assemble_team(self, arrays):
        """The other threads of this march, waiting at the board; none for a run of one thread."""
        if isinstance(self.team, team.Alone):
            return []
        phase = int(self.team.board[0])
        members = [threading.Thread(target=serve, args=(k, phase, arrays, self.scheme, self.team), daemon=True)
                   for k in range(1, self.team.threads)]
        for member in members:
            member.start()
        return members

    def take_gauges(self):
        """(times, {field: (n, ngauge)}) recorded since the last call; with what `reactive.gauge_columns` adds where something burns."""
        n = int(self.counters[L.GAUGE_ROWS])
        times, block = self.gauge_times[:n].copy(), self.gauge_buffer[:n].copy()
        self.counters[L.GAUGE_ROWS] = 0
        found = {name: block[:, :, i] for i, name in enumerate(L.GAUGE_FIELDS) if name != "compaction" or name in self.zone_fields}
        return times, found | reactive.gauge_columns(self.problem, block) if self.burning else found

    def _open(self, node, cause):
        k = next(k for k, (a, b, _, _) in enumerate(self.segments) if a + k < node < b + k)
        zone = node - k
        first, last = self.segments[k, :2]
        place = float(self.nodes[H.r, node])
        if cause == "spall":
            mark_patch(self.table, first, last, zone - 1)
            mark_patch(self.table, first, last, zone)
            self.counters[L.FRACTURING] = 1
        self.nodes, self.gradient, self.segments = split(self.zones, self.nodes, self.gradient, self.segments, node)
        if cause == "spall":
            self.voids_opened += 1
        else:
            self.interfaces_parted += 1
        self._retopologise()
        left, right = (self.problem.regions[self.region_of[z]].name for z in (zone - 1, zone))
        where = f"in '{left}'" if left == right else f"between '{left}' and '{right}'"
        kind, text = ("void_opened", "void opened") if cause == "spall" else ("interface_parted", "bodies parted")
        return Event(kind, self.time, self.cycle, place, f"{text} {where} at {place:.6g} m")

    def _close_gaps(self):
        events = self._close_cavity() if self.problem.dimension > 1 and cavity_closed(self.nodes, self.segments) else []
        while (k := touching_gap(self.table, self.nodes, self.segments)) >= 0:
            last = int(self.segments[k, 1])
            self.nodes, self.gradient, self.segments, heat = join(self.zones, self.nodes, self.gradient, self.segments, k)
            self.voids_closed += 1
            place = float(self.nodes[H.r, last + k])
            left, right = (self.problem.regions[self.region_of[z]].name for z in (last - 1, last))
            events.append(Event("void_closed", self.time, self.cycle, place,
                                f"gap between '{left}' and '{right}' closed at {place:.6g} m, {heat:.4g} J of kinetic energy became heat"))
            self._retopologise()
            self.control[L.RATE] = max(self.control[L.RATE], self._signal_rate(np.array([last - 1, last])))
        return events

    def _close_cavity(self):
        """The inner surface stops on the axis or the origin; its motion becomes heat, its momentum the impulse of the other side."""
        speed, mass = float(self.nodes[H.u, 0]), float(self.nodes[H.mass, 0])
        heat = 0.5 * mass * speed**2
        self.nodes[H.u, 0] = self.nodes[H.r, 0] = 0.0
        self.zones[Z.e, 0] += heat / self.zones[Z.mass, 0]
        self.control[L.IMPULSE_LEFT] -= mass * speed
        self.segments[0, L.SEG_LEFT] = L.FIXED
        self.control[L.RATE] = max(self.control[L.RATE], self._signal_rate(np.array([0])))
        self.voids_closed += 1
        return [Event("void_closed", self.time, self.cycle, 0.0, f"the cavity closed, {heat:.4g} J of kinetic energy became heat")]

    def _unphysical(self, code):
        culprit = int(self.counters[L.CULPRIT])
        left, right = self._faces(H.r)
        if code == L.STEP_COLLAPSED:
            culprit = int(np.argmin((right - left) / np.maximum(self.zones[Z.c], 1e-30)))
        crushed = crushed_zone(self.problem, self.zones, self.region_of, culprit)
        culprit = crushed[0] if crushed else culprit
        values = {name: float(self.zones[row, culprit]) for name, row in self.zone_fields.items()}
        if self.burning:
            rows = {"burn_fraction": B.lam, "mixture_status": B.status}
            values |= {name: float(self.charge[row, culprit]) for name, row in rows.items()}
        burned = ill_burned(self.problem, self.zones, self.charge, self.region_of, culprit) if self.burning else None
        breaks = self.problem.materials[self.problem.regions[self.region_of[culprit]].material].fracture is not None
        cause, remedy = crushed[1:] if crushed else burned or diagnose(code, values, float(left[culprit]), float(right[culprit]), breaks)
        with np.errstate(invalid="ignore"):
            centres = 0.5 * (left + right)
        near = np.flatnonzero(np.isfinite(centres))     # a zone that is nowhere is reported where its nearest sound neighbour is
        place = float(centres[near[np.argmin(np.abs(near - culprit))]]) if near.size else float("nan")
        region = self.problem.regions[self.region_of[culprit]].name
        return UnphysicalState(cause, remedy, culprit, region, place, self.time, self.cycle, values)

    # -- what observers see ----------------------------------------------------------------------------------
    def state(self) -> State:
        """Copies of all fields now."""
        zones = {name: self.zones[row].copy() for name, row in self.zone_fields.items()}
        zones["mass"] = self.zones[Z.mass].copy()
        if self.burning:
            zones |= reactive.state_fields(self.problem, self.charge)
        left, right = self._faces(H.r)
        ul, ur = self._faces(H.u)
        return State(self.time, self.cycle, zones, left, right, ul, ur)

    def phases(self) -> np.ndarray | None:
        """Burn fraction, density and energy of the reactants and of the products, (5, nzone); None where nothing burns."""
        return self.charge[list(L.PHASE_ROWS)] if self.burning else None

    def total_energy(self) -> float:
        """Kinetic and internal energy, J per m^2, per m and radian, or per steradian."""
        kinetic = 0.5 * np.sum(self.nodes[H.mass] * self.nodes[H.u] ** 2)
        return float(kinetic + np.sum(self.zones[Z.mass] * self.zones[Z.e]))

    def momentum(self) -> float:
        return float(np.sum(self.nodes[H.mass] * self.nodes[H.u]))

    def errors(self) -> dict[str, float]:
        """Relative mass, momentum and energy errors against the boundary's impulse and work; of momentum NaN for the curved leapfrog."""
        control = self.control
        work = control[L.WORK_LEFT] + control[L.WORK_RIGHT]
        kinetic = 0.5 * float(np.sum(self.nodes[H.mass] * self.nodes[H.u] ** 2))
        internal = float(np.sum(self.zones[Z.mass] * np.abs(self.zones[Z.e])))
        scale = max(abs(self.start_energy), abs(work), kinetic + internal, 1e-300)
        impulse = control[L.IMPULSE_LEFT] + control[L.IMPULSE_RIGHT] + control[L.RADIAL_IMPULSE]
        kept = not self.staggered or self.problem.dimension == 1     # else accelerations are no forces over the nodes' masses
        size = float(np.sum(self.nodes[H.mass] * np.abs(self.nodes[H.u])))
        size = max(size, abs(self.start_momentum), abs(control[L.IMPULSE_LEFT]), abs(control[L.IMPULSE_RIGHT]), 1e-300)
        return {
            "mass_error": float(abs(self.zones[Z.mass].sum() / self.start_mass - 1.0)),
            "momentum_error": abs(self.momentum() - self.start_momentum - impulse) / size if kept else float("nan"),
            "energy_error": abs(self.total_energy() - self.start_energy - work) / scale,
        }

    def exchanges(self) -> dict[str, float]:
        """What passed the two ends so far: work (J) and impulse (kg m/s) of the boundaries, per unit area or angle."""
        rows = {"work_left": L.WORK_LEFT, "work_right": L.WORK_RIGHT, "impulse_left": L.IMPULSE_LEFT, "impulse_right": L.IMPULSE_RIGHT}
        found = {name: float(self.control[row]) for name, row in rows.items()}
        return found | {"released_heat": reactive.released_heat(self.problem, self.zones, self.charge, self.region_ranges)} if self.burning else found

    def unresolved(self) -> list[str]:
        """Sentences about rates of burning that the mesh did not resolve, and about explosives pulled beyond what they bear."""
        return reactive.doubts(self.problem, self.zones, self.charge, self.region_ranges) if self.burning else []

    def references(self) -> list[str]:
        """Sentences about how the reference state of reactants in thermal isolation was found."""
        return reactive.references(self.problem, self.charge, self.region_ranges) if self.burning else []

    def largest_velocity_jump(self) -> dict[str, float]:
        """Material -> largest particle velocity of a shock it saw, from its peak pressure on the Rayleigh line, m/s."""
        found: dict[str, float] = {}
        for k, region in enumerate(self.problem.regions):
            first, last = self.region_ranges[k]
            material = self.problem.materials[region.material]
            rho0 = float(reference_state(material.eos)[0])
            peak = int(first + np.argmax(self.zones[Z.peak_pressure, first:last]))
            squeeze = 1.0 - rho0 / max(self.zones[Z.peak_density, peak], rho0)
            jump = float(np.sqrt(max(self.zones[Z.peak_pressure, peak], 0.0) * squeeze / rho0))
            found[region.material] = max(found.get(region.material, 0.0), jump)
        return found

    def peaks(self) -> dict[str, np.ndarray]:
        """Peak fields of every zone so far: stress and pressure in compression, tension positive."""
        return {"peak_stress": self.zones[Z.peak_stress].copy(), "peak_tension": -self.zones[Z.peak_tension],
                "peak_pressure": self.zones[Z.peak_pressure].copy(), "peak_density": self.zones[Z.peak_density].copy()}

    # -- checkpoints -----------------------------------------------------------------------------------------
    def payload(self) -> dict:
        """Everything a bitwise restart needs."""
        names = ("zones", "charge", "nodes", "gradient", "segments", "control", "counters")
        numbers = ("voids_opened", "voids_closed", "interfaces_parted", "start_energy", "start_momentum")
        return {name: getattr(self, name).copy() for name in names} | {name: getattr(self, name) for name in numbers}

    def restore(self, payload: dict) -> None:
        """Continue from a payload of the same problem."""
        self.zones[:], self.charge[:] = payload["zones"], payload["charge"]
        for name in ("nodes", "gradient", "segments", "control", "counters"):
            setattr(self, name, np.ascontiguousarray(payload[name]).copy())
        for name in ("voids_opened", "voids_closed", "interfaces_parted"):
            setattr(self, name, int(payload[name]))
        self.start_energy, self.start_momentum = float(payload["start_energy"]), float(payload["start_momentum"])
        self._retopologise()
        self.counters[L.GAUGE_ROWS] = 0


def _pulse_at_zero(pulse):
    if pulse.shape == "table":
        return float(np.interp(0.0, pulse.times, pulse.values))
    return pulse.amplitude if pulse.start <= 0.0 and pulse.shape in ("constant", "exponential", "square") else 0.0
