"""The interface of solvers to the time loop, the run, its report and checkpoints: `Solver`, extended by `LineSolver` and `PlaneSolver`.

A solver is made from a complete Problem (`problem.defaults`), owns its arrays and reads or writes no files. The time loop (`solvers.run`)
marches it from event to event; observers receive copies and change nothing. A solver must define every
name below: no member is optional, and a quantity that a solver does not have is empty, zero or None, as described here.
`NothingToAdd` provides these defaults for members that many solvers lack.

Everything is in SI. Extensive quantities are those of the problem's geometry: per m^2 (planar), per m and radian (cylindrical), per
steradian (spherical), per m (plane), per radian (axisymmetric).
"""

from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

import numpy as np

COUNTS = ("voids_opened", "voids_closed", "interfaces_separated", "tension_cap_acted")
NO_COUNTS = dict.fromkeys(COUNTS, 0)


@dataclass(frozen=True)
class Event:
    """Something that happened between two steps.

    kind       one word for programs: void_opened, void_closed, interface_separated, step_repeated
    time       s
    cycle      steps taken before it
    position   m, along the line or from the axis or the origin
    text       a sentence for the reader, with the position and the energy lost
    """

    kind: str
    time: float
    cycle: int
    position: float
    text: str


@runtime_checkable
class SolverState(Protocol):
    """The result of `state`: `hugoniot.state.State` in one dimension."""

    @property
    def time(self) -> float:
        """s."""
        ...

    @property
    def cycle(self) -> int:
        """Number of steps taken so far."""
        ...

    @property
    def zones(self) -> dict[str, np.ndarray]:
        """Fields of the zones (nzone,) by name."""
        ...

    def fields(self) -> dict[str, np.ndarray]:
        """Every field that a snapshot keeps, by the words of `core.fields`."""
        ...


@runtime_checkable
class Solver(Protocol):
    """A run in progress, in any dimension."""

    # -- the clock ---------------------------------------------------------------------------------------------------
    @property
    def problem(self) -> Any:
        """The problem that is solved, complete."""
        ...

    @property
    def time(self) -> float:
        """Time reached, s."""
        ...

    @property
    def cycle(self) -> int:
        """Steps taken."""
        ...

    @property
    def step(self) -> float:
        """The last time step, s."""
        ...

    @property
    def zone_updates(self) -> int:
        """Number of zones (or work equal to a zone) advanced, summed over the steps."""
        ...

    def march(self, until: float, cycles: int) -> list[Event]:
        """Take steps until the time `until` (hit exactly), `cycles` steps, a full gauge buffer or an event; returns the events.

        Raises `UnphysicalState` in the cycle it arises, the state left as it was found then.
        """
        ...

    def pass_through(self, times) -> bool:
        """Hit these times (sorted, s) exactly during a march without returning; False if the solver cannot.

        A run of which no snapshot is kept takes the same steps in this way; `seen_in_passing` gives the extremes at those times.
        """
        ...

    def limiting(self) -> tuple[int, str]:
        """(zone, name of its region) that limits the step."""
        ...

    # -- fields and gauges -------------------------------------------------------------------------------------------
    @property
    def region_of(self) -> np.ndarray:
        """Index of the region (block) of every zone, (nzone,); constant during the run."""
        ...

    def state(self) -> SolverState:
        """Copies of all fields now; `zones["mass"]` (nzone,), kg, and `zones["energy"]`, J/kg, are always among them."""
        ...

    def motion(self) -> SolverState:
        """A state whose `fields` has at least positions and velocities: cheaper than `state` where nothing else is needed."""
        ...

    def take_gauges(self) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        """(times (n,) s, {field: (n, ngauge)}) recorded since the last call; the buffer is then emptied. No fields without gauges."""
        ...

    def phases(self) -> np.ndarray | None:
        """Burn fraction, density (kg/m3) and energy (J/kg) of the reactants and of the products, (5, nzone); None where nothing burns."""
        ...

    def front_table(self) -> tuple[tuple[str, ...], list[str], np.ndarray] | None:
        """(columns, kind of each front, rows (nfront, ncolumn), SI) of every front there was; None where waves are not followed."""
        ...

    def peaks(self) -> dict[str, np.ndarray]:
        """Largest values of every zone so far, {"peak_...": (nzone,)}; tension positive. Empty where none are kept."""
        ...

    # -- accounts ----------------------------------------------------------------------------------------------------
    def errors(self) -> dict[str, float]:
        """Relative errors of conserved quantities, after accounting for what passed the ends: `energy_error` and others named `..._error`.

        NaN for what the scheme does not conserve.
        """
        ...

    def exchanges(self) -> dict[str, float]:
        """What passed the boundaries so far, J and kg m/s: work and impulse of each end, and heat released inside."""
        ...

    def counts(self) -> dict[str, int]:
        """How often each of those of `COUNTS` happened so far that the solver follows; `NO_COUNTS` where nothing opens."""
        ...

    def largest_velocity_jump(self) -> dict[str, float]:
        """Material -> largest change of velocity across a shock in it, m/s; a material that is not named is not judged."""
        ...

    def results(self) -> dict[str, float]:
        """Further numbers of the run's summary, SI; empty where there are none."""
        ...

    # -- words about the run -----------------------------------------------------------------------------------------
    def warnings(self) -> list[str]:
        """Sentences, after the run, on what limits its validity: what the mesh did not resolve, for instance."""
        ...

    def notes(self) -> list[tuple[str, str]]:
        """(kind of event, sentence), after the run, on how results were found; no cause for concern."""
        ...

    @property
    def viscosity(self) -> Any:
        """Parameter tuple of the artificial viscosity in use (family `VISCOSITY`), or None."""
        ...

    @property
    def transport(self) -> Any:
        """`Transport` tuple of the physical viscosity and heat conduction, or None."""
        ...

    # -- checkpoints -------------------------------------------------------------------------------------------------
    def payload(self) -> dict[str, Any]:
        """Everything a bitwise restart needs: arrays, numbers, words, lists and dictionaries of them, all copies."""
        ...

    def restore(self, payload: dict[str, Any]) -> None:
        """Continue from the payload of a solver of the same problem; the results are the same, bit for bit."""
        ...


@runtime_checkable
class LineSolver(Solver, Protocol):
    """A run in one dimension: its zones form a row, and its `state` is a `hugoniot.state.State`."""

    @property
    def initial_nodes(self) -> tuple[np.ndarray, np.ndarray]:
        """Positions of the left and the right face of every zone at t = 0, (nzone,) each, m."""
        ...

    @property
    def gauge_zones(self) -> np.ndarray:
        """Index of the zone that each gauge of the records of `take_gauges` lies in now, (ngauge,)."""
        ...


@runtime_checkable
class PlaneSolver(Solver, Protocol):
    """A run in two dimensions: its `state` is a `hugoniot.state.State2D`."""

    def kinetic_energy(self) -> float | None:
        """Kinetic energy of the nodes with the masses that the scheme gives them, J; None where it is the sum over the zones."""
        ...


class NothingToAdd:
    """Defaults for quantities that a solver does not have: solvers inherit them and override what they do have."""

    viscosity: Any = None
    transport: Any = None

    def state(self) -> SolverState:
        """Left to the solver."""
        raise NotImplementedError

    def motion(self) -> SolverState:
        """The whole state."""
        return self.state()

    def pass_through(self, times) -> bool:
        """It comes back at every time."""
        return False

    def phases(self) -> np.ndarray | None:
        """Nothing burns."""
        return None

    def front_table(self) -> tuple[tuple[str, ...], list[str], np.ndarray] | None:
        """No waves are followed."""
        return None

    def counts(self) -> dict[str, int]:
        """Nothing opens."""
        return dict(NO_COUNTS)

    def largest_velocity_jump(self) -> dict[str, float]:
        """No material is judged."""
        return {}

    def results(self) -> dict[str, float]:
        """No numbers beyond the balances."""
        return {}

    def warnings(self) -> list[str]:
        """Nothing to warn of."""
        return []

    def notes(self) -> list[tuple[str, str]]:
        """Nothing to note."""
        return []
