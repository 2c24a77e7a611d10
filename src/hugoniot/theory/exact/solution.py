"""What an exact solution is: a callable of positions and time that returns fields by their standard names."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np

from hugoniot.errors import OutOfRange


def _no_jumps(time: float) -> tuple[float, ...]:
    return ()


@dataclass(frozen=True)
class Solution:
    """One exact solution, in SI or any other consistent units.

    profile    function (positions, time) -> {field name: array}; use the object itself, which checks its arguments
    fronts     function time -> positions of the discontinuities
    numbers    the scalars that characterise the solution (star pressure, wave speeds, ...)
    times      (first, last) time at which the solution holds
    domain     function time -> (first, last) position of interest; None where the jumps determine it
    steady     whether the solution is the same at every time
    """

    title: str
    geometry: str
    profile: Callable[[np.ndarray, float], dict[str, np.ndarray]]
    fronts: Callable[[float], tuple[float, ...]] = _no_jumps
    numbers: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    times: tuple[float, float] = (0.0, float("inf"))
    domain: Callable[[float], tuple[float, float]] | None = None
    steady: bool = False

    def _checked(self, time: float) -> float:
        if not self.times[0] <= time <= self.times[1]:
            raise OutOfRange(f"{self.title}: the solution holds for times {self.span}, not at {time:.10g} s")
        return float(time)

    @property
    def span(self) -> str:
        """The times at which the solution holds, in words; one that ends in a singularity has a last time just below it."""
        first, last = self.times
        start = "above 0 s" if first == 1e-300 else f"from {first:g} s"
        if math.isinf(last):
            return start if first == 1e-300 else f"{start} on"
        return f"{start} to {'just below ' if float(f'{last:.10g}') > last else ''}{last:.10g} s"

    def __call__(self, positions, time: float) -> dict[str, np.ndarray]:
        """Fields (names of `core.fields`) at an array of positions at one time; each value has the shape of `positions`.

        Raises OutOfRange for a time at which the solution does not hold.
        """
        return self.profile(np.asarray(positions, float), self._checked(time))

    def jumps(self, time: float) -> tuple[float, ...]:
        """Positions of the discontinuities (shocks and contacts) at a time, in ascending order."""
        return tuple(sorted(float(x) for x in self.fronts(self._checked(time))))
