"""A state as observers see it: named arrays at one instant, by the words of `core.fields`.

A solver hands out a `State` of views or copies; whoever looks at it needs no solver and changes nothing.
"""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class State:
    """time (s), cycle, zone fields (nzone,) and the faces of each zone (nzone,): faces of neighbours differ across a void."""

    time: float
    cycle: int
    zones: dict[str, np.ndarray]
    position_left: np.ndarray
    position_right: np.ndarray
    velocity_left: np.ndarray
    velocity_right: np.ndarray

    @property
    def position_middle(self) -> np.ndarray:
        """Where the fields of a zone are given, m: midway between its faces."""
        return 0.5 * (self.position_left + self.position_right)

    def fields(self) -> dict[str, np.ndarray]:
        """Every field by name, faces included, as one flat dictionary."""
        faces = ("position_left", "position_right", "velocity_left", "velocity_right")
        return {**self.zones, **{name: getattr(self, name) for name in faces}}


@dataclass(frozen=True)
class State2D:
    """A state of the two-dimensional hydrocode.

    time (s), cycle
    zones        fields (nzone,) by name, numbered as in `mesh.blocks`, or in `mesh.triangles`
    nodes        fields (nnode,) by name, one value per global node: position_x, position_y, velocity_x, velocity_y at least
                 (x and y are r and z in axisymmetric geometry)
    zone_nodes   (nzone, 4) nodes of each zone, counter-clockwise, or (nzone, 3) of triangles; the same array in every state of a run
    """

    time: float
    cycle: int
    zones: dict[str, np.ndarray]
    nodes: dict[str, np.ndarray]
    zone_nodes: np.ndarray

    def fields(self) -> dict[str, np.ndarray]:
        """Every field by name, zones and nodes, as one flat dictionary."""
        return {**self.zones, **self.nodes}
