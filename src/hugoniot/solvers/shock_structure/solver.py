"""The viscous flow solver: owns the arrays, advances them, and provides states, budgets and checkpoints.

It uses the numbers and laws of a problem, never files, decks or plots. The grid is fixed (Eulerian cells of equal width).
"""

import math

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange, UnphysicalState
from hugoniot.laws.eos import contract as eos_laws
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.transport import contract as transport_laws
from hugoniot.laws.transport.contract import TRANSPORT
from hugoniot.problem.defaults import with_defaults
from hugoniot.problem.model import Problem
from hugoniot.solvers.protocol import NothingToAdd
from hugoniot.solvers.shock_structure import layout as L
from hugoniot.solvers.shock_structure.measure import thickness
from hugoniot.solvers.shock_structure.setup import FEWEST_CELLS, NAME, cells_of_regions, end_kind, eos_of, grid_of, transport_of
from hugoniot.state import State

NO_LIMIT = 1e300
STEEPEST = 1e3       # Grüneisen parameter beyond which a cell's pressure hangs on the rounding of its total energy
_SOLID = ("deviator_radial", "deviator_hoop", "plastic_work", "viscous_work")   # what a budget of solids asks for: zero here


class FlowState(State):
    """A state whose file holds only what a viscous fluid has."""

    def fields(self) -> dict[str, np.ndarray]:
        return {name: value for name, value in super().fields().items() if name not in _SOLID}


class ShockStructure(NothingToAdd):
    """A run in progress: a `protocol.LineSolver`.

    problem   planar, regions of one material that touch and have cells of equal width; `solver.options["transport"]` a `Transport`
    start     (cells (3, n) of density, momentum, total energy; ends (2, 3) of the far fields), or None: from the regions' states
    """


    def __init__(self, problem: Problem, start=None):
        self.problem = problem = with_defaults(problem)
        self.eos, self.transport = eos_of(problem), transport_of(problem)
        self.faces, self.region_of = grid_of(problem)
        self.h = float(self.faces[-1] - self.faces[0]) / len(self.region_of)
        cells, ends = start if start is not None else cells_of_regions(problem, self.eos, self.region_of)
        n = len(self.region_of)
        self.U = np.zeros((3, n + 2 * L.GHOSTS))
        self.U[:, L.GHOSTS:-L.GHOSTS] = cells
        self.ends = np.ascontiguousarray(ends, dtype=float)
        self.kinds = np.array([end_kind(problem.left, "left"), end_kind(problem.right, "right")], dtype=np.int64)
        self.rest, self.passed, self.passed_rest = np.zeros((3, n)), np.zeros((2, 3)), np.zeros((2, 3))
        self.control, self.counters = np.zeros(L.CONTROL_FLOATS), np.zeros(L.CONTROL_INTS, dtype=np.int64)
        self.control[L.COURANT] = problem.solver.courant
        self.control[L.DT_LARGEST] = problem.solver.largest_step or NO_LIMIT
        self._require_states()
        self._require_a_finite_slope()
        self.start_totals = self.totals()
        self._peaks = np.array(list(self._fields().values()))
        self._work = [np.zeros_like(self.U), np.zeros((3, n + 1)), np.zeros((3, n + 1))]

    def _require_states(self):
        rho, _, e = self._primitive()
        for zone, (a, b) in enumerate(zip(rho.tolist(), e.tolist())):
            if not (a > 0.0 and eos_laws.sound_speed_squared(a, b, self.eos) > 0.0):
                self.counters[L.CULPRIT] = zone
                raise self._unphysical()

    def _require_a_finite_slope(self):
        for rho, j, total in self.ends.tolist():
            steepness = eos_laws.pressure_derivatives(rho, total / rho - 0.5 * (j / rho) ** 2, self.eos)[1] / rho
            if steepness > STEEPEST:
                raise OutOfRange(f"solver {NAME} cannot treat law '{EOS.of(self.eos).name}': in the reference state the slope of its "
                                 "pressure against "
                                 f"the energy has no bound (Grüneisen parameter {steepness:.3g}), and "
                                 f"a cell's energy is the small difference of "
                                 "total and kinetic energy; use mie_gruneisen, or the steady wave (hugoniot structure profile)")

    @property
    def cells(self) -> np.ndarray:
        """Conserved averages (3, n): density kg/m3, momentum density kg/(m2 s), total energy density J/m3."""
        return self.U[:, L.GHOSTS:-L.GHOSTS]

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
        return self.cycle * len(self.region_of)

    @property
    def fallbacks(self) -> int:
        """How often a face fell back to first order because a reconstructed state was none."""
        return int(self.counters[L.FALLBACKS])

    @property
    def initial_nodes(self):
        return self.faces[:-1], self.faces[1:]

    def limiting(self) -> tuple[int, str]:
        """(cell, region name) with the largest signal speed."""
        zone = int(self.counters[L.LIMITING])
        return zone, self.problem.regions[self.region_of[zone]].name

    def march(self, until: float, cycles: int) -> list:
        """Step until the time `until` (hit exactly) or `cycles` steps; no events. Raises `UnphysicalState`."""
        from hugoniot.solvers.shock_structure.step import Cells, Flow, march

        self.control[L.EVENT_TIME] = until
        cells = Cells(self.U, *self._work, self.rest, self._peaks, self.passed, self.passed_rest, self.h, self.kinds, self.ends)
        code = march(cycles, cells, self.control, self.counters,
                     Flow(self.eos, self.transport, transport_laws.conducts(self.transport)))
        if code == L.BAD_STATE:
            raise self._unphysical()
        return []

    def advance(self, cycles: int, until: float = NO_LIMIT) -> None:
        """`march` for callers without a time loop."""
        self.march(until, cycles)

    def take_gauges(self):
        """No Lagrangian gauges in a fixed grid."""
        return np.empty(0), {}

    def _unphysical(self):
        zone = int(self.counters[L.CULPRIT])
        rho, j, total = (float(v) for v in self.cells[:, zone])
        values = {"density": rho, "velocity": j / rho if rho else math.nan, "total_energy": total}
        return UnphysicalState(
            f"density {rho:.4g} kg/m3 and total energy {total:.4g} J/m3 are not a valid state of law '{EOS.of(self.eos).name}'",
            "refine the cells (at least four in a shock's thickness), lower solver.courant, or start from the steady profile",
            zone, self.problem.regions[self.region_of[zone]].name, 0.5 * float(self.faces[zone] + self.faces[zone + 1]), self.time,
            self.cycle, values)

    # -- what observers see ----------------------------------------------------------------------------------
    def _primitive(self):
        rho, j, total = self.cells
        return rho, j / rho, total / rho - 0.5 * (j / rho) ** 2

    def _fields(self) -> dict[str, np.ndarray]:
        rho, _, e = self._primitive()
        pairs = list(zip(rho.tolist(), e.tolist()))
        p = np.array([eos_laws.pressure(a, b, self.eos) for a, b in pairs])
        return {"pressure": p, "density": rho.copy()}

    def state(self) -> State:
        """Copies of all fields now; `viscous_pressure` is -tau of the physical viscosity, `stress` = p - tau."""
        rho, u, e = self._primitive()
        pairs = list(zip(rho.tolist(), e.tolist()))
        p = np.array([eos_laws.pressure(a, b, self.eos) for a, b in pairs])
        with np.errstate(invalid="ignore"):
            c = np.sqrt(np.array([eos_laws.sound_speed_squared(a, b, self.eos) for a, b in pairs]))
        thermal = eos_laws.has_temperature(self.eos)
        T = np.array([eos_laws.temperature(a, b, self.eos) for a, b in pairs]) if thermal else np.full_like(rho, math.nan)
        viscosity = TRANSPORT.of(self.transport.shear).functions["viscosity"]
        mu = np.array([transport_laws.longitudinal_viscosity(viscosity(a, t, self.transport.shear), self.transport)
                       for a, t in zip(rho.tolist(), T.tolist())])
        q = -mu * np.gradient(u, self.h)
        zones = {"density": rho.copy(), "energy": e, "pressure": p, "viscous_pressure": q, "stress": p + q, "sound_speed": c}
        if thermal:
            zones["temperature"] = T
        nothing = np.zeros_like(rho)
        zones |= {**{name: nothing.copy() for name in _SOLID}, "mass": rho * self.h}
        left = np.concatenate([[u[0]], 0.5 * (u[1:] + u[:-1])])
        right = np.concatenate([0.5 * (u[1:] + u[:-1]), [u[-1]]])
        return FlowState(self.time, self.cycle, zones, self.faces[:-1].copy(), self.faces[1:].copy(), left, right)

    def totals(self) -> np.ndarray:
        """Mass, momentum, total energy of the domain per m^2, what rounding set aside included."""
        return np.array([math.fsum(row) for row in np.hstack([self.cells, self.rest])]) * self.h

    def budget(self) -> dict[str, float]:
        """Mass, momentum, energy now and what passed the ends, SI per m^2."""
        names = ("mass", "momentum", "energy")
        now, net = self.totals(), self.passed[0] - self.passed[1]
        return {**dict(zip(names, now.tolist())), **{f"{name}_through_ends": float(v) for name, v in zip(names, net)}}

    def errors(self) -> dict[str, float]:
        """Relative mass, momentum and energy errors against what passed the ends."""
        missing = self.totals() - self.start_totals - (self.passed[0] - self.passed[1])
        size = np.abs(self.cells).sum(axis=1) * self.h
        size = np.maximum(size, np.abs(self.passed).max(axis=0))
        return {f"{name}_error": float(abs(m) / max(s, 1e-300)) for name, m, s in zip(("mass", "momentum", "energy"), missing, size)}

    def exchanges(self) -> dict[str, float]:
        """Energy (J/m2) and momentum (kg/(m s)) that entered through the two ends."""
        left, right = self.passed
        return {"work_left": float(left[2]), "work_right": float(-right[2]),
                "impulse_left": float(left[1]), "impulse_right": float(-right[1])}

    def largest_velocity_jump(self) -> dict[str, float]:
        """Material -> spread of its velocities now, m/s."""
        u = self._primitive()[1]
        return {self.problem.regions[0].material: float(u.max() - u.min())}

    def peaks(self) -> dict[str, np.ndarray]:
        """Largest pressure and density of every cell after any step."""
        return {f"peak_{name}": value.copy() for name, value in zip(("pressure", "density"), self._peaks)}

    @property
    def gauge_zones(self) -> np.ndarray:
        """No gauges."""
        return np.empty(0, dtype=np.int64)

    def thickness(self) -> tuple[float, float]:
        """(density thickness, position), m, of the shock between the two far fields; `NoSolution` where they are equal."""
        low, high = self.ends[:, 0]
        if low == high:
            raise NoSolution("the two ends have the same density: there is no shock between them to measure")
        return thickness(self.faces, self.cells[0], low, high, self._primitive()[1])

    def results(self) -> dict[str, float]:
        """What a run's summary tells beside the budgets: of the one shock of `[solver.shock]`, its thickness and place, m.

        Between other far fields there may be several waves, and their difference is the jump of none.
        """
        found = {"low_order_faces": float(self.fallbacks)}
        if self.problem.solver.options.get("shock"):
            length, place = self.thickness()
            found |= {"density_thickness": length, "shock_position": place, "cells_per_thickness": length / self.h}
        return found

    def warnings(self) -> list[str]:
        """Warnings, after the run: a shock thinner than eight cells has the thickness of its grid."""
        found = self.results()
        if not found.get("cells_per_thickness", math.inf) < FEWEST_CELLS:
            return []
        return [f"the shock has {found['cells_per_thickness']:.2g} cells in its thickness: below {FEWEST_CELLS} the thickness is the "
                f"grid's rather than the shock's; use cells of at most 1/{FEWEST_CELLS} of the thickness of the "
                "steady shock (hugoniot structure profile)"]

    # -- checkpoints -----------------------------------------------------------------------------------------
    _KEPT = ("U", "rest", "passed", "passed_rest", "control", "counters", "start_totals", "ends")

    def payload(self) -> dict:
        """Everything a bitwise restart needs."""
        return {**{name: getattr(self, name).copy() for name in self._KEPT}, **self.peaks()}

    def restore(self, payload: dict) -> None:
        """Continue from a payload of the same problem."""
        for name in self._KEPT:
            setattr(self, name, np.ascontiguousarray(payload[name]).copy())
        self._peaks = np.array([payload["peak_pressure"], payload["peak_density"]])
