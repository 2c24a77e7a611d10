"""The two-dimensional Lagrangian solver: owns the arrays, advances them, and provides states and budgets.

It uses the numbers and laws of a problem, never files, decks or plots. The terms are those of `solvers.lagrange1d.solver`.
"""

import numpy as np

from hugoniot.core.compile_ahead import compile_all, job_of
from hugoniot.core.ops import NO_LIMIT
from hugoniot.core.shares import serve
from hugoniot.core.team import at_work, team_of
from hugoniot.laws.fracture.contract import opens_voids
from hugoniot.problem.plane.contact import may_meet
from hugoniot.problem.plane.model import Problem2D
from hugoniot.problem.plane.walls import with_walls
from hugoniot.solvers.lagrange1d.tables import zone_table
from hugoniot.solvers.lagrange2d import accounts, post_mortem, transmitting
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d import quads as G
from hugoniot.solvers.lagrange2d.accounts import B
from hugoniot.solvers.lagrange2d.assemble import N, Numbering, Z, axis_tables, kind_of, materials_of, node_tables, unburned, zone_tables
from hugoniot.solvers.lagrange2d.bands import in_rows
from hugoniot.solvers.lagrange2d.boundaries import boundary_tables
from hugoniot.solvers.lagrange2d.commands import EMPTY
from hugoniot.solvers.lagrange2d.contact.results import contact_of
from hugoniot.solvers.lagrange2d.contact.surfaces import Surfaces, with_rigid
from hugoniot.solvers.lagrange2d.erosion import Erosion, NoErosion
from hugoniot.solvers.lagrange2d.march import Options, Run, hold_at_start, march
from hugoniot.solvers.lagrange2d.plan import Planner
from hugoniot.solvers.lagrange2d.rewind import Rewind
from hugoniot.solvers.lagrange2d.rings import Rings
from hugoniot.solvers.lagrange2d.rows_of_blocks import alike, cells, ghost_tables, gradient_rows, node_rows, zone_rows
from hugoniot.solvers.lagrange2d.shown import Shown
from hugoniot.solvers.lagrange2d.zone_shapes import diagonal_table, inverse_altitudes, widths
from hugoniot.solvers.protocol import Event, NothingToAdd
from hugoniot.state import State2D

NAME = "lagrange2d"
KEPT = ("zones", "nodes", "charge", "control", "counters", "chains", "ends")      # in checkpoints
WORTH_SHARING = 4_000        # zones
ON_THE_WAY = (L.PAUSED, L.GAUGE_DUE, L.NO_ROOM, L.LED_ON)      # why a march comes back before it is done
LARGEST_COLLAPSE = 1e-12     # smallest useful step as a fraction of the stop time


class Lagrange2D(Shown, NothingToAdd):
    """A run in progress. `sampler(state) -> {field: (ngauge,)}` reads the gauges; without one none are recorded."""

    def __init__(self, problem: Problem2D, sampler=None):
        self.problem = problem = with_walls(problem)
        self.sampler, self.kind, mesh = sampler, kind_of(problem), problem.mesh
        self.numbering = numbering = Numbering(mesh)
        zones = zone_tables(problem, self.kind)
        self.control, self.counters = np.zeros(L.CONTROL_FLOATS), np.zeros(L.CONTROL_INTS, dtype=np.int64)
        self.counters[L.ZONES] = count = len(mesh.zone_nodes)
        nodes, heat = node_tables(problem, numbering, self.kind, zones)
        self.boundaries = boundary_tables(problem, numbering)
        surfaces = Surfaces(problem, numbering, self.boundaries) if may_meet(problem) else None
        nodes = with_rigid(problem, surfaces, nodes)
        self._zones, self._nodes, self.forces = (zone_table(len(names), size) for names, size in (
            (Z, count), (N, nodes.shape[1]), (L.Forces._fields, count)))
        self.nodes = self._nodes[:, :nodes.shape[1]]
        self.zones[:], self.nodes[:] = zones, nodes
        self.zones[Z.e] += heat
        self.burning = any(problem.materials[block.material].burn is not None for block in problem.blocks)
        self.opens_voids = any(opens_voids(problem.materials[region.material].fracture) for region in problem.regions)
        self._charge = zone_table(len(B), count if self.burning else 1)
        self.charge = self._charge[:, :count if self.burning else 1]
        if self.burning:
            unburned(problem, self.charge, self.zones, widths(mesh))
        self.boundaries.chains.extend(f"rigid {body.name}" for body in problem.rigid)
        self.chains = np.zeros((len(self.boundaries.chains) + 1, 3))
        self.team = team_of(problem.solver.threads, count, WORTH_SHARING)
        self.options = Options(self.kind, G.AXIS_RADIUS * float(np.abs(self.nodes[N.x]).max()), *map(float, problem.body_force))
        self.run = self._run(mesh)
        self.contact = contact_of(self, surfaces)
        self.ends, self.region_of = self.run.ends, mesh.block_of
        self.plan, self.fronts = self._plan(mesh, accounts.largest_speed(problem, self.zones, self.nodes))
        self.erosion = Erosion(self, surfaces) if problem.solver.erosion else NoErosion()
        self.gauge_times, self.gauge_rows, self.rewind = [], [], Rewind()
        self.begin()
        self.initial_nodes = self.nodes[[N.x, N.y]][:, numbering.representative].copy()

    # -- setting up ------------------------------------------------------------------------------------------
    def _run(self, mesh) -> Run:
        edges, gradients = self.boundaries, zone_table(gradient_rows(self.problem), int(cells(mesh)[-1]))
        *ghosts, before = ghost_tables(mesh, self.numbering, edges.mirrors, alike(self.problem, self.zones))
        *axis, rows = in_rows(mesh, edges, *axis_tables(self.problem, self.numbering, self.nodes[:, :self.numbering.total], self.kind))
        return Run(self._zones, self._nodes, gradients, *ghosts, edges.loads, np.zeros((len(edges.loads), 4)), edges.gates,
                   *transmitting.tables(edges, ghosts[0], self.numbering), edges.held, edges.held_normals, edges.pulses, edges.tables,
                   *self.numbering.shared(), edges.special, *axis, np.vstack((rows, before)), self.chains, np.zeros_like(self.chains),
                   np.arange(self.nodes.shape[1]), 0, 0, np.zeros(3))

    def _plan(self, mesh, speed):
        """(plan of the march, largest speed of a programmed front)."""
        materials, self.material_of = materials_of(self.problem, speed, self.options.near)
        tables = self._zones, self.forces, self._charge, self._nodes, self.run.gradients, diagonal_table(mesh)
        self.planner = Planner(tables, materials, G.KINDS[self.kind], self.problem.solver.viscosity, self.problem.body_force,
                               self.team, Rings(mesh, self.numbering, self.run), len(self.run.gates) == 0)
        compile_all([job_of(march, self._march_arguments(1, EMPTY)), *self.contact.jobs(self.run), *self.planner.jobs()])
        self.run = self.contact.given_to(self.run)
        return self.plan_of(None), max(material[0].constants.front for material in materials)

    def plan_of(self, live):
        """The plan of a march whose zones are live, all of them if None."""
        mesh = self.problem.mesh
        return self.planner.plan(zone_rows(mesh, self.numbering, self.material_of, live), node_rows(mesh, self.numbering))

    def _march_arguments(self, cycles, plan):
        return cycles, self.run, plan, self.options, self.control, self.counters

    def _corners(self, row):
        """A node row at the corners of every zone, (4, nzone), or (3, nzone) of triangles."""
        return self.nodes[row, self.numbering.representative][self.problem.mesh.zone_nodes.T]

    def _inverse_altitudes(self):
        return inverse_altitudes(*map(self._corners, (N.x, N.y)))

    def begin(self) -> None:
        """Take the state as it stands, which a test may have written into the tables, for that at t = 0."""
        options, control = self.problem.solver, self.control
        control[L.COURANT], control[L.GROWTH] = options.courant, options.growth
        control[L.DT_LARGEST] = options.largest_step or NO_LIMIT
        control[L.DT_SMALLEST] = LARGEST_COLLAPSE * self.problem.stop_time
        control[L.GAUGE_INTERVAL] = self.problem.output.gauge_interval
        control[L.NEXT_GAUGE] = 0.0 if self.sampler else NO_LIMIT
        self.planner.set_bands(self.plan, False)
        hold_at_start(self.run)
        control[L.RATE] = accounts.signal_rate(self)
        first = options.initial_step or 0.1 * control[L.COURANT] / control[L.RATE]
        control[L.DT_NATURAL] = first / control[L.GROWTH]
        transmitting.begin(self.run, self.kind, self.options.near, self.problem)
        self.rewind.forget()
        self.start_energy, self.start_mass = accounts.total_energy(self.zones, self.nodes), self.zones[Z.mass].sum()
        self.start_momentum = accounts.momentum(self.nodes)

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

    def counts(self) -> dict[str, int]:
        """How often the tension of a failing zone was held; voids and separating surfaces are not counted."""
        return {"tension_cap_acted": self.capped}

    def limiting(self) -> tuple[int, str]:
        """(zone, block name) with the shortest transit time."""
        zone = int(np.argmax((self.zones[Z.c] + 2.0 * self.zones[Z.viscous_speed]) * self._inverse_altitudes()))
        return zone, self.problem.blocks[self.region_of[zone]].name

    def march(self, until: float, cycles: int) -> list[Event]:
        """Step until the time `until` (hit exactly) or `cycles` steps; gauges are read on the way.

        A step that would leave the range of a law is repeated with a smaller step; the events returned report this.
        """
        if until <= self.time:
            return []
        self.control[L.EVENT_TIME] = until
        self.rewind.begin(self, until)
        end, events, code = self.cycle + cycles, [], L.PAUSED
        while code in ON_THE_WAY and self.cycle < end:
            code = self._march_to(self.erosion.pause(end), events)
            if self.erosion.act(code):
                code = code if code == L.AT_EVENT else L.PAUSED
                self.rewind.begin(self, until, anew=True)
        if code in (L.STEP_COLLAPSED, L.TANGLED):
            raise post_mortem.diagnose(self, code)
        return events

    def _march_to(self, end: int, events: list) -> int:
        """March to the cycle `end` or the event time; steps that leave the range of a law are repeated and reported as events."""
        with at_work(self.team, serve, self.plan):
            while (code := self._carry_on(end, self._read_gauges)) == L.BAD_STATE:
                fault = post_mortem.diagnose(self, code)
                event = self.rewind.again(self, fault, lambda cycle: self._carry_on(cycle, self._next_gauge))
                if event is None:
                    raise fault
                events.append(event)
        return code

    def _carry_on(self, end: int, at_gauge) -> int:
        """March to the cycle `end` or the event time; the code of why it came back. at_gauge(): what is done where gauges are due."""
        code = L.PAUSED
        while code in ON_THE_WAY and self.cycle < end:
            code, self.stale = march(*self._march_arguments(self.rewind.pause(self, end) - self.cycle, self.plan)), True
            if code == L.LED_ON:
                self.rewind.finish(self, lambda cycle: self._carry_on(cycle, self._next_gauge))
            if code == L.NO_ROOM:
                self.run = self.contact.enlarged(self.run)
            if self.sampler is not None and code in (L.GAUGE_DUE, L.AT_EVENT):
                at_gauge()
        return code

    def _read_gauges(self):
        self.gauge_times.append(self.time)
        self.gauge_rows.append(self.sampler(self._glimpse()) if self.sampler is not None else ())
        self._next_gauge()

    def _next_gauge(self):
        interval = self.control[L.GAUGE_INTERVAL]
        while self.control[L.NEXT_GAUGE] <= self.time and interval > 0.0:
            self.control[L.NEXT_GAUGE] += interval

    def take_gauges(self):
        """(times, {field: (n, ngauge)}) recorded since the last call."""
        times, rows = np.array(self.gauge_times), self.gauge_rows
        self.gauge_times, self.gauge_rows = [], []
        return times, {name: np.array([row[name] for row in rows]) for name in (rows[0] if rows else {})}

    # -- what observers see ----------------------------------------------------------------------------------
    def state(self) -> State2D:
        """Copies of all fields now."""
        seen = self._glimpse()
        zones, nodes = ({name: values.copy() for name, values in fields.items()} for fields in (seen.zones, seen.nodes))
        return State2D(seen.time, seen.cycle, zones, nodes, seen.zone_nodes)

    def _glimpse(self) -> State2D:
        """The state now, most of it views that the next step changes: copies would make gauges cost nearly as much as a step."""
        zones = self.erosion.seen(accounts.zone_fields(self.zones) | accounts.fields_of_laws(self))
        rows = {"position_x": N.x, "position_y": N.y, "velocity_x": N.u, "velocity_y": N.v}
        numbers = self.numbering.representative
        places = slice(0, len(numbers)) if self.numbering.alone else numbers
        nodes = {name: self.nodes[row, places] for name, row in rows.items()}
        return State2D(self.time, self.cycle, zones, nodes | self.contact.fields(), self.problem.mesh.zone_nodes)

    def phases(self) -> np.ndarray | None:
        """Burn fraction, density and energy of the reactants and of the products, (5, nzone); None where nothing burns."""
        return self.charge[[B.lam, B.rho_r, B.e_r, B.rho_p, B.e_p]] if self.burning else None

    def all_zones(self) -> dict[str, np.ndarray]:
        """Fields of zones (views), also of those that have left the mesh, as they were then."""
        return accounts.zone_fields(self.zones)

    def kinetic_energy(self) -> float:
        """J per metre or per radian."""
        return accounts.kinetic_energy(self.nodes)

    def errors(self) -> dict[str, float]:
        """Relative mass, momentum and energy errors against the impulse and work of the boundaries (`accounts.errors`)."""
        return accounts.errors(self)

    def exchanges(self) -> dict[str, float]:
        """Work (J) and impulse (kg m/s) of every chain of boundary edges so far and, where something burns, the heat released (J)."""
        return accounts.exchanges(self)

    def largest_velocity_jump(self) -> dict[str, float]:
        """Material -> largest particle velocity of a shock in it, from its peak pressure on the Rayleigh line, m/s."""
        return accounts.largest_velocity_jump(self.problem, self.zones)

    def warnings(self) -> list[str]:
        """Sentences about rates of burning that the mesh did not resolve, and about explosives in tension beyond what they can support."""
        return accounts.doubts(self)

    def notes(self) -> list[tuple[str, str]]:
        """How the reference state of reactants in thermal isolation was found, by block."""
        return accounts.references(self)

    def results(self) -> dict[str, float]:
        """Further numbers for the summary."""
        repeated, filtered = int(self.counters[L.REPEATED] + self.counters[L.LEFT_RANGE]), float(self.control[L.FILTER_WORK])
        return {"steps_repeated": repeated, "filter_work": filtered} | self.contact.summary() | self.erosion.results()

    def peaks(self) -> dict[str, np.ndarray]:
        """Peak fields of every zone so far: stress and pressure in compression, tension positive."""
        return accounts.peaks(self.zones)

    # -- checkpoints -----------------------------------------------------------------------------------------
    def payload(self) -> dict:
        """Everything a bitwise restart needs."""
        start = {"start_energy": self.start_energy, "start_momentum": self.start_momentum}
        return {name: getattr(self, name).copy() for name in KEPT} | start | self.erosion.payload() | self.contact.payload()

    def restore(self, payload: dict) -> None:
        """Continue from a payload of the same problem."""
        for name in KEPT:
            getattr(self, name)[...] = payload[name]
        self.start_energy, self.start_momentum = float(payload["start_energy"]), np.array(payload["start_momentum"])
        self.erosion.restore(payload)
        self.run = self.contact.restored(self.run, payload)
        self.rewind.forget()
        if self.sampler is None:
            self.control[L.NEXT_GAUGE] = NO_LIMIT
