"""Errors that the package raises. All are derived from `HugoniotError`."""

from dataclasses import dataclass, field
from math import isfinite


class HugoniotError(Exception):
    """Base class of all errors that the package raises on purpose; `exit_code` is the exit code of the command line."""

    exit_code = 1


@dataclass
class DeckProblem:
    """One mistake in a deck.

    file, line   where it is; line is None if it is not known
    key          the key, with dots, such as region.flyer.to
    message      what is wrong
    hint         how it can be corrected, or ""
    """

    file: str
    line: int | None
    key: str
    message: str
    hint: str = ""

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}" if self.line else self.file
        text = f"{place}: {self.key}: {self.message}" + (f"; {self.hint}" if self.hint else "")
        # what a user's file says may hold characters that a terminal would obey
        return text if text.isprintable() else "".join(c if c.isprintable() else f"\\x{ord(c):02x}" for c in text)


class DeckError(HugoniotError):
    """A deck, a material file or another input that cannot be used.

    problems   a list of `DeckProblem`
    more       number of further problems that are not listed
    at_least   whether there may be even more, because reading stopped
    """

    exit_code = 2

    def __init__(self, problems: list[DeckProblem], more: int = 0, at_least: bool = False):
        self.problems, self.more, self.at_least = list(problems), more, at_least
        super().__init__("\n".join([*(str(p) for p in self.problems), *([self.count] if more else [])]))

    @property
    def count(self) -> str:
        """Number of problems, as a string."""
        if self.more:
            least = "at least " if self.at_least else ""
            return f"{least}{len(self.problems) + self.more} problems; the first {len(self.problems)} are shown"
        return f"{len(self.problems)} problems" if len(self.problems) > 1 else "1 problem"

    @classmethod
    def single(cls, file, line, key, message, hint=""):
        return cls([DeckProblem(str(file), line, key, message, hint)])


@dataclass
class UnphysicalState(HugoniotError):
    """A run reached a state that no material can have.

    cause, remedy   what is wrong, and what to try; sentences, remedy may be ""
    zone, region    number of the zone, and name of its region
    position, time, cycle   position (m), time (s) and number of the time step
    values          fields of the zone, in SI
    """

    cause: str
    remedy: str = ""
    zone: int | None = None
    region: str = ""
    position: float | None = None
    time: float | None = None
    cycle: int | None = None
    values: dict = field(default_factory=dict)
    exit_code = 3

    def __str__(self) -> str:
        if self.zone is None:
            where = []
        elif "i" in self.values:        # of two dimensions, where the cause names the place in the block
            where = [f"block '{self.region}'"]
        else:
            where = [f"zone {self.zone}" + (f" of region '{self.region}'" if self.region else "")]
        if self.position is not None and isfinite(self.position):
            where.append(f"at {self.position:.6g} m")
        if self.time is not None:
            where.append(f"t = {self.time:.6g} s")
        if self.cycle is not None:
            where.append(f"cycle {self.cycle}")
        cause = self.cause.rstrip(".") + f". Remedy: {self.remedy}" if self.remedy else self.cause
        return ", ".join(where) + (": " if where else "") + cause


class OutOfRange(HugoniotError, ValueError):
    """A state outside the range in which a law or a function is defined; the message gives the limit."""

    exit_code = 3


class NoSolution(HugoniotError, ArithmeticError):
    """A search for a solution found none; the message gives the interval that was searched."""

    exit_code = 3


class FileTrouble(HugoniotError, OSError):
    """A file or folder that cannot be read or written; existing files are left as they were."""

    exit_code = 4
