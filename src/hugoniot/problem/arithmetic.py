r"""Arithmetic in decks, between their keys, `region.flyer.to + 2 * 1.5 mm`, or of a position: with units, and without running any code.

An expression has numbers, quantities (a number and a unit), keys of the deck, the names of what is varied, + - * / and **, brackets, and
the functions of `FUNCTIONS`. Python's own parser makes a tree of it; only the nodes named here are worked out, each by this module. Units
are carried along: lengths are added to lengths, a bare number is SI. A key with a blank or a hyphen in it stands in quotes:
"region.back plate.to".
"""

import ast
import math
import re
from collections.abc import Callable
from typing import NamedTuple

from hugoniot.errors import DeckError
from hugoniot.materials.collect import printable
from hugoniot.units import UnitError, powers_of, si_name

LONGEST = 400          # characters of an expression
LARGEST_POWER = 9      # of a unit, as `units` reads them
_BASE = ("m", "kg", "s", "K", "mol")
_PLAIN = (0, 0, 0, 0, 0)
_NUMBER = r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_UNIT = r"[A-Za-zµμ°%Ω]+\d*(?:(?:\^-?\d|/(?=[A-Za-z])[A-Za-zµμ°]+\d*))*"
_PIECE = re.compile(rf"""(?P<quoted>"[^"]*"|'[^']*')|(?P<quantity>{_NUMBER}\s+{_UNIT})|(?P<key>[A-Za-z_]\w*(?:\.\w+)+)""")


class Number(NamedTuple):
    """A value in SI and its powers of (m, kg, s, K, mol); None for a bare number, which fits any unit."""

    value: float
    powers: tuple[int, ...] | None = None

    def text(self) -> float | int | str:
        """What a deck says for it: a bare number, or a text with base units."""
        if self.powers is not None and self.powers != _PLAIN:
            return f"{self.value!r} {self._base()}"
        return int(self.value) if self.value.is_integer() and abs(self.value) < 1e15 else self.value     # counts of zones are whole

    def unit(self) -> str:
        """Name of its SI unit; "1" for a bare number."""
        return "1" if self.powers is None or self.powers == _PLAIN else si_name(self._base())

    def _base(self) -> str:
        powers = self.powers or _PLAIN
        above = [f"{name}^{power}" if power > 1 else name for name, power in zip(_BASE, powers) if power > 0]
        below = [f"/{name}^{-power}" if power < -1 else f"/{name}" for name, power in zip(_BASE, powers) if power < 0]
        return f"{' '.join(above) or '1'}{''.join(below)}"


class Trouble(ValueError):
    """What is wrong with an expression, in words, and the way out."""

    def __init__(self, message: str, hint: str = ""):
        self.message, self.hint = message, hint
        super().__init__(message + (f"; {hint}" if hint else ""))


def quantity(value) -> Number:
    """A value of a deck as a number with powers: a bare number, or a text such as "2 mm". Raises `Trouble` for anything else."""
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        raise Trouble("not a number", "only keys with one number can be used in an expression")
    if not isinstance(value, str):
        return Number(float(value))
    try:
        return Number(*powers_of(value))
    except UnitError as error:
        raise Trouble(error.message, error.hint) from None


class Expression:
    """An expression ready to be worked out: `keys` are the names it asks for; `value(lookup)` is its number.

    Raises `Trouble` if it is not one.
    """

    def __init__(self, text: str):
        self.text, self.pieces = text.strip(), {}
        if len(self.text) > LONGEST:
            raise Trouble(f"an expression of more than {LONGEST} characters")
        plain = _PIECE.sub(self._named, self.text).strip()
        try:
            self.tree = ast.parse(plain, mode="eval").body
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            raise Trouble(f"'{printable(self.text, 60)}' is not an expression", EXAMPLE) from None
        self.keys = tuple(dict.fromkeys([piece for piece in self.pieces.values() if isinstance(piece, str)]
                                        + [node.id for node in ast.walk(self.tree) if isinstance(node, ast.Name)
                                           and node.id not in self.pieces and node.id not in FUNCTIONS]))

    def _named(self, match: re.Match) -> str:
        """A quantity or a key of the deck under a name that the parser takes."""
        text = match.group(0)
        inner = text[1:-1] if match.lastgroup == "quoted" else text
        is_key = match.lastgroup == "key" or match.lastgroup == "quoted" and not re.match(r"\s*[+-]?\.?\d", inner)
        name = f"_{len(self.pieces)}_"
        self.pieces[name] = inner if is_key else quantity(inner)
        return f" {name} "

    def value(self, lookup: Callable[[str], Number]) -> Number:
        """The number it gives where `lookup` gives the number of a key. Raises `Trouble`."""
        try:
            found = self._work_out(self.tree, lookup)
        except Trouble:
            raise
        except (ArithmeticError, ValueError):       # ValueError: outside the domain of a function of `math`
            raise Trouble(f"'{printable(self.text, 60)}' does not give a finite number") from None
        except RecursionError:
            raise Trouble(f"'{printable(self.text, 60)}' is nested too deeply") from None
        if not math.isfinite(found.value):
            raise Trouble(f"'{printable(self.text, 60)}' does not give a finite number")
        return found

    def _work_out(self, node: ast.AST, lookup) -> Number:
        match node:
            case ast.Constant(value=int() | float() as number) if not isinstance(number, bool):
                return Number(float(number))
            case ast.Name(id=name):
                piece = self.pieces.get(name, name)
                return piece if isinstance(piece, Number) else lookup(piece)
            case ast.UnaryOp(op=ast.USub(), operand=inner):
                found = self._work_out(inner, lookup)
                return Number(-found.value, found.powers)
            case ast.UnaryOp(op=ast.UAdd(), operand=inner):
                return self._work_out(inner, lookup)
            case ast.BinOp(left=left, op=op, right=right):
                return _combined(op, self._work_out(left, lookup), self._work_out(right, lookup))
            case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]) if name in FUNCTIONS:
                return _call(name, [self._work_out(each, lookup) for each in arguments])
        raise Trouble(f"'{printable(self.text, 60)}' contains something that is not allowed in an expression", EXAMPLE)


EXAMPLE = "write it like region.flyer.to + 2 * thickness, with + - * / ** and sqrt, exp, log, sin, cos, tanh, abs, round, min, max"


def _combined(op: ast.operator, a: Number, b: Number) -> Number:
    if isinstance(op, (ast.Add, ast.Sub)):
        return Number(a.value + b.value if isinstance(op, ast.Add) else a.value - b.value, _same(a, b))
    if isinstance(op, (ast.Mult, ast.Div)):
        sign = 1 if isinstance(op, ast.Mult) else -1
        value = a.value * b.value if sign > 0 else a.value / b.value
        if a.powers is None and b.powers is None:
            return Number(value)
        return Number(value, _checked(tuple(x + sign * y for x, y in zip(a.powers or _PLAIN, b.powers or _PLAIN))))
    if isinstance(op, ast.Pow):
        return _raised(a, b)
    raise Trouble("an expression cannot contain this operator", EXAMPLE)


def _same(a: Number, b: Number) -> tuple[int, ...] | None:
    if a.powers is not None and b.powers is not None and a.powers != b.powers:
        raise Trouble("quantities of different kinds are added, subtracted or compared", "give both in units of one kind")
    return a.powers if a.powers is not None else b.powers


def _checked(powers: tuple[int, ...]) -> tuple[int, ...]:
    if max(map(abs, powers)) > LARGEST_POWER:
        raise Trouble("a unit is raised to a power above 9")
    return powers


def _raised(a: Number, b: Number) -> Number:
    if b.powers not in (None, _PLAIN):
        raise Trouble("an exponent must not have a unit")
    value = math.pow(a.value, b.value) if a.value >= 0.0 or b.value.is_integer() else math.nan
    if a.powers in (None, _PLAIN):
        return Number(value, a.powers)
    powers = tuple(power * b.value for power in a.powers or _PLAIN)
    if not all(float(power).is_integer() for power in powers):
        raise Trouble("the power gives a fractional unit")
    return Number(value, _checked(tuple(int(power) for power in powers)))


def _plain(name: str, x: Number) -> float:
    if x.powers not in (None, _PLAIN):
        raise Trouble(f"{name} needs a number without a unit", "divide the quantity by another of its kind first")
    return x.value


def _call(name: str, given: list[Number]) -> Number:
    least, most = (1, 1) if name not in ("min", "max") else (2, 20)
    if not least <= len(given) <= most:
        raise Trouble(f"{name} takes {'one value' if most == 1 else f'two to {most} values'}")
    return FUNCTIONS[name](given)


def _extreme(pick: Callable) -> Callable:
    def chosen(given: list[Number]) -> Number:
        powers: tuple[int, ...] | None = None
        for each in given:
            powers = _same(Number(0.0, powers), each)
        return Number(pick(each.value for each in given), powers)

    return chosen


FUNCTIONS: dict[str, Callable[[list[Number]], Number]] = {
    "sqrt": lambda given: _raised(given[0], Number(0.5)),
    "abs": lambda given: Number(abs(given[0].value), given[0].powers),
    "exp": lambda given: Number(math.exp(_plain("exp", given[0]))),
    "log": lambda given: Number(math.log(_plain("log", given[0])) if _plain("log", given[0]) > 0.0 else math.nan),
    "sin": lambda given: Number(math.sin(_plain("sin", given[0]))), "cos": lambda given: Number(math.cos(_plain("cos", given[0]))),
    "tanh": lambda given: Number(math.tanh(_plain("tanh", given[0]))),
    "min": _extreme(min), "max": _extreme(max), "round": lambda given: Number(float(round(_plain("round", given[0])))),
}


def trouble_of(where: str, error: Trouble) -> DeckError:
    """The error a user sees for an expression or a value that stood at `where`."""
    return DeckError.single("sweep", None, where, error.message, error.hint)
