"""The one-dimensional Lagrangian solver: owns the arrays, advances them, and provides states, balances and checkpoints.

It uses the numbers and laws of a problem, never files, decks or plots. `march` takes steps until something happens and reports it. The
start of a run is in `start`, events between steps in `between_steps`, the diagnosis of failures in `post_mortem`, the balances in
`accounts`.
"""

import numpy as np

from hugoniot.core.compile_ahead import compile_all, job_of
from hugoniot.core.shares import serve
from hugoniot.core.team import at_work, team_of
from hugoniot.laws.fracture.contract import opens_voids
from hugoniot.mesh.line import GEOMETRY
from hugoniot.problem.defaults import with_defaults
from hugoniot.problem.model import Problem
from hugoniot.solvers.lagrange1d import accounts, reactive, start, transmitting
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.assemble import assemble, boundary_end, laws_of_regions, start_region
from hugoniot.solvers.lagrange1d.at_nodes import node_criteria
from hugoniot.solvers.lagrange1d.between_steps import events_of, part_at_start
from hugoniot.solvers.lagrange1d.bodies import alike_ranges, interface_table, left_nodes, run_table, set_node_masses, shares_of
from hugoniot.solvers.lagrange1d.field import NoField
from hugoniot.solvers.lagrange1d.layout import B, H, WorkRows, Z
from hugoniot.solvers.lagrange1d.plan import EMPTY, Planner
from hugoniot.solvers.lagrange1d.post_mortem import unphysical
from hugoniot.solvers.lagrange1d.probes import applied_stress, gauge_places, probe_tables
from hugoniot.solvers.lagrange1d.step import AT_NODES, SCHEMES, WATCH, Arrays, march
from hugoniot.solvers.lagrange1d.tables import zone_table
from hugoniot.solvers.lagrange1d.terms import NoTerms, terms_of
from hugoniot.solvers.lagrange1d.watch import pass_times
from hugoniot.solvers.protocol import Event, NothingToAdd
from hugoniot.state import State
from hugoniot.zones.closure import remembers

NAME = "lagrange1d"
ZONE_FIELDS = {"density": Z.rho, "energy": Z.e, "pressure": Z.p, "viscous_pressure": Z.q, "deviator_radial": Z.s1,
               "deviator_hoop": Z.s2, "stress": Z.sigma, "sound_speed": Z.c, "plastic_strain": Z.plastic_strain, "damage": Z.damage,
               "plastic_work": Z.plastic_work, "viscous_work": Z.viscous_work}
GAUGE_CAPACITY = 2048
WORTH_SHARING = 10_000      # zones; below, sharing costs more than it gives


class Lagrange1D(NothingToAdd):
    """A run in progress: a `protocol.LineSolver`."""

    def __init__(self, problem: Problem):
        self.problem = problem = with_defaults(problem)
        self.geometry = GEOMETRY.get(problem.geometry).example
        self.scheme = SCHEMES[problem.solver.integrator]
        self.staggered = self.scheme.staggered
        self.team = team_of(problem.solver.threads, sum(region.zones for region in problem.regions), WORTH_SHARING)
        starts = [start_region(problem, region) for region in problem.regions]
        laws, self.laws_of_region = laws_of_regions(problem, starts)
        self.table, self.charge_table, self.nodes, self.gradient, self.segments, self.region_ranges = assemble(problem, starts)
        self.zones = self.table[:, :self.region_ranges[-1][1]]
        self.burning = any(reactive.burns(problem, region) for region in problem.regions)
        self.charge = self.charge_table[:, :self.region_ranges[-1][1] if self.burning else 0]
        self.node_table = zone_table(len(H), 2 * self.zones.shape[1])         # room for every zone on its own
        self.gradient_table = np.zeros(3 * self.zones.shape[1])
        self.work = zone_table(len(WorkRows._fields), self.team.threads * L.PIECE)
        self.left_nodes = left_nodes(self.segments)
        self.terms = terms_of(problem, self.zones, self.faces(H.r), self.region_ranges)
        self.planner = Planner((self.table, self.charge_table, self.node_table, self.gradient_table, self.work), laws, self.terms,
                               self.geometry, self.staggered, problem.solver.options["heat_flux"], self.team)
        self.criteria = node_criteria(laws, self.laws_of_region, self.region_ranges)
        remembering = any(remembers(problem.materials[region.material].eos) for region in problem.regions)
        self.zone_fields = ZONE_FIELDS | ({"compaction": Z.compaction} if remembering else {})
        voids = any(opens_voids(problem.materials[region.material].fracture) for region in problem.regions)
        self.not_recorded = {*(() if remembering else ("compaction",)), *(() if voids else ("void_fraction",))}
        set_node_masses(self.zones, self.nodes, self.segments)
        ends = problem.left, problem.right
        field = NoField() if isinstance(self.terms.marching, NoTerms) else self.terms.force.field
        self.boundaries = tuple(boundary_end(problem, end, field) for end in ends)
        self.pushed = any(end.kind == "pressure" for end in ends)
        self.control = np.zeros(L.CONTROL_FLOATS)
        self.counters = np.zeros(L.CONTROL_INTS, dtype=np.int64)
        self.passed = np.zeros((0, L.PASS_FLOATS))
        self.opened = np.zeros(0, dtype=np.int64)      # the zone on the right of every void that has opened
        self.voids_closed = self.interfaces_separated = 0
        self.fresh = True      # nothing has happened yet
        self.region_of = np.repeat(np.arange(len(problem.regions)), [b - a for a, b in self.region_ranges])
        self.initial_nodes = self.faces(H.r)
        self.gauge_places = gauge_places(self)
        self.alike = alike_ranges(problem.regions, self.region_ranges, [reactive.burns(problem, region) for region in problem.regions])
        start.prepare(self)
        self._new_buffer()
        self._renew_tables()
        self.watching, self.asking = 0, 0
        watched, at_nodes = (self._arrays(), self.geometry, EMPTY.dts), [AT_NODES] if len(self.criteria) else []
        compile_all([job_of(march, self._march_arguments(1, EMPTY)), *self.planner.jobs(), *(e.job(*watched) for e in (*at_nodes, WATCH))])
        self.watching = WATCH.address(*watched)
        self.asking = AT_NODES.address(*watched) if at_nodes else 0
        self._renew_plan()
        self.start_energy, self.start_mass, self.start_momentum = self.total_energy(), self.zones[Z.mass].sum(), self.momentum()

    # -- setting up ------------------------------------------------------------------------------------------
    def _new_buffer(self):
        columns = L.BURNING_GAUGE_COLUMNS if self.burning else len(L.GAUGE_FIELDS)
        self.gauge_times = np.empty(GAUGE_CAPACITY)
        self.gauge_buffer = np.empty((GAUGE_CAPACITY, len(self.problem.gauges), columns))
        self.counters[L.GAUGE_ROWS] = 0

    def renew_topology(self) -> None:
        """Everything that depends on which zones are joined."""
        self._renew_tables()
        self._renew_plan()

    def _renew_plan(self):
        runs = run_table(self.segments, self.region_ranges, self.laws_of_region)
        self.plan = self.planner.plan(*shares_of(runs, self.segments, self.alike))

    def _renew_tables(self):
        self.node_table[:, :self.nodes.shape[1]], self.gradient_table[:len(self.gradient)] = self.nodes, self.gradient
        self.nodes, self.gradient = self.node_table[:, :self.nodes.shape[1]], self.gradient_table[:len(self.gradient)]
        self.left_nodes = left_nodes(self.segments)
        self.interfaces = interface_table(self.segments, self.nodes)
        self.gauges, self.weights = probe_tables(self)
        self.control[L.LAST_NODE] = self.nodes.shape[1] - 1
        transmitting.reach(self.control, self.segments, self.region_ranges)

    def faces(self, row):
        """A node row at the left and at the right face of every zone, (nzone,) each."""
        return self.nodes[row, self.left_nodes], self.nodes[row, self.left_nodes + 1]

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
    def voids_opened(self) -> int:
        return len(self.opened)

    @property
    def zone_updates(self) -> int:
        return int(self.counters[L.ZONE_STEPS])

    def limiting(self) -> tuple[int, str]:
        """(zone, region name) with the shortest transit time."""
        left, right = self.faces(H.r)
        zone = int(np.argmin((right - left) / np.maximum(self.zones[Z.c], 1e-30)))
        return zone, self.problem.regions[self.region_of[zone]].name

    def march(self, until: float, cycles: int) -> list[Event]:
        """Step until the time `until` (hit exactly), `cycles` steps, a full gauge buffer or an event; the events that happened."""
        if until <= self.time:
            return []
        if self.fresh and (parted := part_at_start(self)):
            return parted
        self.control[L.UNTIL] = until
        with at_work(self.team, serve, self.plan):
            code = march(*self._march_arguments(cycles, self.plan))
        if code in (L.BAD_STATE, L.STEP_COLLAPSED):
            raise unphysical(self, code)
        return events_of(self, code)

    def pass_through(self, times) -> bool:
        """March through these times (sorted, s) without coming back; they are hit exactly."""
        self.passed = np.zeros((len(times), L.PASS_FLOATS))
        self.passed[:, L.PASS_TIME] = times
        self.counters[L.PASSED_TIMES] = 0
        return True

    def seen_in_passing(self) -> dict[str, np.ndarray]:
        """At the times of `pass_through` that are reached: `time` (n,) s, largest size of `velocity` (m/s) and `stress` (Pa),
        `velocity_right` of the right end."""
        pass_times.py_func(self.zones, self.nodes, self.control, self.counters, self.segments, self.passed)
        return dict(zip(("time", "velocity", "stress", "velocity_right"), self.passed[:int(self.counters[L.PASSED_TIMES])].T.copy()))

    def _march_arguments(self, cycles, plan):
        return cycles, self._arrays(), plan, self.scheme, self.geometry, self.boundaries, self.terms.marching

    def _arrays(self):
        return Arrays(self.table, self.charge_table, self.node_table, self.gradient_table, self.control, self.counters, self.segments,
                      self.interfaces, self.passed, self.criteria, self.gauges, self.weights, self.gauge_times, self.gauge_buffer,
                      self.asking, self.watching)

    def take_gauges(self):
        """(times, {field: (n, ngauge)}) recorded since the last call; with what `reactive.gauge_columns` adds where something burns."""
        n = int(self.counters[L.GAUGE_ROWS])
        times, block = self.gauge_times[:n], self.gauge_buffer[:n]
        if 2 * n < GAUGE_CAPACITY:
            times, block = times.copy(), block.copy()
            self.counters[L.GAUGE_ROWS] = 0
        else:       # handed over whole
            self._new_buffer()
        block[:, :, L.GAUGE_STRESS] += applied_stress(self, times) if self.pushed else 0.0
        found = {name: block[:, :, i] for i, name in enumerate(L.GAUGE_FIELDS) if name not in self.not_recorded}
        if "void_fraction" in found:
            found["void_fraction"] = found["void_fraction"] * found["density"]      # the zones have the volume of voids per mass
        return times, found | reactive.gauge_columns(self.problem, block) if self.burning else found

    # -- what observers see ----------------------------------------------------------------------------------
    def state(self) -> State:
        """Copies of all fields now."""
        zones = {name: self.zones[row].copy() for name, row in self.zone_fields.items()}
        zones["mass"] = self.zones[Z.mass].copy()
        if "void_fraction" not in self.not_recorded:
            zones["void_fraction"] = self.zones[Z.voids] * self.zones[Z.rho]
        if self.burning:
            zones |= reactive.state_fields(self.problem, self.charge)
        left, right = self.faces(H.r)
        ul, ur = self.faces(H.u)
        return State(self.time, self.cycle, zones, left, right, ul, ur)

    def motion(self) -> State:
        """Positions and velocities alone: a sixth of the work of `state`."""
        return State(self.time, self.cycle, {}, *self.faces(H.r), *self.faces(H.u))

    @property
    def gauge_zones(self) -> np.ndarray:
        """Index of the zone that each gauge lies in, (ngauge,)."""
        return self.gauges[:, 0]

    def phases(self) -> np.ndarray | None:
        """Burn fraction, density and energy of the reactants and of the products, (5, nzone); None where nothing burns."""
        return self.charge[list(L.PHASE_ROWS)] if self.burning else None

    # -- accounts --------------------------------------------------------------------------------------------
    total_energy, momentum, errors = accounts.total_energy, accounts.momentum, accounts.errors
    exchanges, peaks = accounts.exchanges, accounts.peaks

    def counts(self) -> dict[str, int]:
        """Voids opened and closed, separated interfaces, and how often the tension of a failing zone was held at its spall strength."""
        return {"voids_opened": self.voids_opened, "voids_closed": self.voids_closed, "interfaces_separated": self.interfaces_separated,
                "tension_cap_acted": int(self.counters[L.CAP_COUNT])}

    def largest_velocity_jump(self) -> dict[str, float]:
        """Material -> largest particle velocity of a shock in it, from its peak pressure on the Rayleigh line, m/s."""
        return accounts.largest_velocity_jump(self.problem, self.zones[Z.peak_pressure], self.zones[Z.peak_density], self.region_ranges)

    def warnings(self) -> list[str]:
        """Sentences about rates of burning that the mesh did not resolve, and about explosives in tension beyond what they can support."""
        if not self.burning:
            return []
        return reactive.doubts(self.problem, self.charge[B.resolution], -self.zones[Z.peak_tension], self.region_ranges)

    def notes(self) -> list[tuple[str, str]]:
        """How the reference state of reactants in thermal isolation was found, by region."""
        found = reactive.references(self.problem, self.charge[B.reference], self.region_ranges) if self.burning else []
        return [("reference_state", text) for text in found]

    # -- checkpoints -----------------------------------------------------------------------------------------
    def payload(self) -> dict:
        """Everything a bitwise restart needs."""
        names = ("zones", "charge", "nodes", "gradient", "segments", "control", "counters", "opened")
        numbers = ("voids_closed", "interfaces_separated", "start_energy", "start_momentum")
        return {name: getattr(self, name).copy() for name in names} | {name: getattr(self, name) for name in numbers}

    def restore(self, payload: dict) -> None:
        """Continue from a payload of the same problem."""
        self.zones[:], self.charge[:] = payload["zones"], payload["charge"]
        for name in ("nodes", "gradient", "segments", "control", "counters", "opened"):
            setattr(self, name, np.ascontiguousarray(payload[name]).copy())
        for name in ("voids_closed", "interfaces_separated"):
            setattr(self, name, int(payload[name]))
        self.start_energy, self.start_momentum = float(payload["start_energy"]), float(payload["start_momentum"])
        self.fresh = self.time == 0.0 and self.interfaces_separated == 0
        self.renew_topology()
        self.counters[L.GAUGE_ROWS] = 0
