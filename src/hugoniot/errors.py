"""The errors that the package raises: in a deck, in the physics, or with files."""

from dataclasses import dataclass, field


class HugoniotError(Exception):
    """Base class of the errors of this package; `exit_code` is the exit code of the command line."""

    exit_code = 1


@dataclass
class DeckProblem:
    """One mistake in a deck: its place, what is wrong, and a suggested fix."""

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

    problems   the mistakes
    more       number of further mistakes that are not listed
    at_least   reading stopped early, so that there may be others
    """

    exit_code = 2

    def __init__(self, problems: list[DeckProblem], more: int = 0, at_least: bool = False):
        self.problems, self.more, self.at_least = list(problems), more, at_least
        super().__init__("\n".join([*(str(p) for p in self.problems), *([self.count] if more else [])]))

    @property
    def count(self) -> str:
        """The number of mistakes, as text."""
        if self.more:
            least = "at least " if self.at_least else ""
            return f"{least}{len(self.problems) + self.more} problems; the first {len(self.problems)} are shown"
        return f"{len(self.problems)} problems" if len(self.problems) > 1 else "1 problem"

    @classmethod
    def single(cls, file, line, key, message, hint=""):
        return cls([DeckProblem(str(file), line, key, message, hint)])


@dataclass
class UnphysicalState(HugoniotError):
    """A state that is not physical, such as a negative density, found in the cycle in which it arose.

    `zone`, `position` (m) and `time` (s) say where and when. `cause` and `remedy` are sentences, and `values` holds the fields there.
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
        where = [] if self.zone is None else [f"zone {self.zone}" + (f" of region '{self.region}'" if self.region else "")]
        if self.position is not None:
            where.append(f"at {self.position:.6g} m")
        if self.time is not None:
            where.append(f"t = {self.time:.6g} s")
        if self.cycle is not None:
            where.append(f"cycle {self.cycle}")
        cause = self.cause.rstrip(".") + f". Remedy: {self.remedy}" if self.remedy else self.cause
        return ", ".join(where) + (": " if where else "") + cause


class OutOfRange(HugoniotError, ValueError):
    """A state outside the range in which a law or a tool is defined; the message states the limit."""

    exit_code = 3


class NoSolution(HugoniotError, ArithmeticError):
    """A search has no solution or did not find one; the message states the interval that was searched."""

    exit_code = 3


class FileTrouble(HugoniotError, OSError):
    """A file or folder cannot be read or written; existing data are not lost."""

    exit_code = 4
