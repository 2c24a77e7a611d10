"""Quantities at the border: `"3.94 km/s"` becomes 3940.0. Inside the package every number is SI.

A quantity is a number, or the text `number unit`. The text must match one strict pattern before anything looks at it, and a
unit is read by a small grammar (names, powers, products, quotients) over a table of the units of the field; a single unknown
name, never an expression, is looked up in `pint`, which is imported only then (given whole texts pint evaluates them:
`9**9**9**9` hangs it). Conversion is done in decimal, so `"7 mm"` is exactly the float 0.007.
"""

import difflib
import functools
import math
import numbers
import re
from collections.abc import Iterable
from decimal import Decimal, DecimalException, localcontext
from typing import NamedTuple

LONGEST = 120  # characters of a quantity worth reading
_QUANTITY = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,4})?)\s*(.*)", re.ASCII)
_SLIP = 0.75  # a name this like a known unit is taken for a slip of the pen, and pint is not asked
_TOKEN = re.compile(r"\s*(?:([A-Za-zµμ°%Ω]+\d*)|(\*\*|[/*·^()])|(-?\d+))")


class UnitError(ValueError):
    """A text that is not a quantity, an unknown unit, or a unit of the wrong kind; `hint` is the way out."""

    def __init__(self, message: str, hint: str = ""):
        self.message, self.hint = message, hint
        super().__init__(message + (f"; {hint}" if hint else ""))


class UnknownUnit(UnitError):
    """A name that is no unit; `near` is the known name most like it, or ""."""

    def __init__(self, name: str, near: str):
        self.name, self.near = name, near
        super().__init__(f"unknown unit '{name}'", f"did you mean '{near}'?" if near else
                         "units are written like 'mm', 'us', 'km/s', 'GPa', 'g/cm^3'")


class Unit(NamedTuple):
    """A unit: factor to SI, and the powers of (m, kg, s, K, mol)."""

    factor: Decimal
    powers: tuple[int, int, int, int, int]


_NONE = (0, 0, 0, 0, 0)
_LENGTH, _MASS, _TIME, _KELVIN = (1, 0, 0, 0, 0), (0, 1, 0, 0, 0), (0, 0, 1, 0, 0), (0, 0, 0, 1, 0)
_PRESSURE, _ENERGY, _FORCE, _VOLUME = (-1, 1, -2, 0, 0), (2, 1, -2, 0, 0), (1, 1, -2, 0, 0), (3, 0, 0, 0, 0)
_PREFIXES = {"T": "1e12", "G": "1e9", "M": "1e6", "k": "1e3", "m": "1e-3", "u": "1e-6", "µ": "1e-6", "μ": "1e-6", "n": "1e-9",
             "p": "1e-12", "f": "1e-15"}
_PREFIXED = {"m": ("1", _LENGTH), "g": ("1e-3", _MASS), "s": ("1", _TIME), "K": ("1", _KELVIN), "mol": ("1", (0, 0, 0, 0, 1)),
             "Pa": ("1", _PRESSURE), "bar": ("1e5", _PRESSURE), "J": ("1", _ENERGY), "N": ("1", _FORCE),
             "W": ("1", (2, 1, -3, 0, 0)), "Hz": ("1", (0, 0, -1, 0, 0)), "eV": ("1.602176634e-19", _ENERGY)}
_PLAIN = {"1": ("1", _NONE), "%": ("0.01", _NONE), "rad": ("1", _NONE),
          "deg": ("0.017453292519943295769236907685", _NONE), "cm": ("1e-2", _LENGTH), "dm": ("1e-1", _LENGTH),
          "in": ("0.0254", _LENGTH), "inch": ("0.0254", _LENGTH), "ft": ("0.3048", _LENGTH), "mil": ("2.54e-5", _LENGTH),
          "min": ("60", _TIME), "cc": ("1e-6", _VOLUME), "l": ("1e-3", _VOLUME), "L": ("1e-3", _VOLUME),
          "atm": ("101325", _PRESSURE), "psi": ("6894.757293168361", _PRESSURE), "ksi": ("6894757.293168361", _PRESSURE),
          "hPa": ("100", _PRESSURE), "kb": ("1e8", _PRESSURE), "erg": ("1e-7", _ENERGY), "cal": ("4.184", _ENERGY),
          "kcal": ("4184", _ENERGY), "torr": ("133.32236842105263", _PRESSURE), "h": ("3600", _TIME), "hour": ("3600", _TIME),
          "dyn": ("1e-5", _FORCE), "lb": ("0.45359237", _MASS)}
_OFFSET = {"degC": Decimal("273.15"), "°C": Decimal("273.15"), "celsius": Decimal("273.15")}


def _table() -> dict[str, Unit]:
    table = {name: Unit(Decimal(factor), powers) for name, (factor, powers) in (_PREFIXED | _PLAIN).items()}
    for name, (factor, powers) in _PREFIXED.items():
        for prefix, scale in _PREFIXES.items():
            table.setdefault(prefix + name, Unit(Decimal(factor) * Decimal(scale), powers))
    for word, name in (("meter", "m"), ("metre", "m"), ("gram", "g"), ("second", "s"), ("kelvin", "K"), ("pascal", "Pa"), ("joule", "J"),
                       ("newton", "N"), ("watt", "W"), ("micron", "um"), ("dyne", "dyn"), ("minute", "min"), ("hour", "h")):
        table.setdefault(word, table[name])
        table.setdefault(word + "s", table[name])
    return table | {"feet": table["ft"], "inches": table["in"]}


_UNITS = _table()
# what a quantity is called in a message, with a unit to write; the keys are SI units as the laws and the schema name them
_KINDS = {"m": ("a length", "mm"), "s": ("a time", "us"), "kg": ("a mass", "g"), "K": ("a temperature", "K"), "m/s": ("a velocity", "km/s"),
          "Pa": ("a pressure or stress", "GPa"), "kg/m^3": ("a density", "g/cm^3"), "J/kg": ("a specific energy", "kJ/kg"),
          "J/kg/K": ("a specific heat or entropy", "J/kg/K"), "1/s": ("a rate", "1/s"), "1/K": ("an expansion coefficient", "1/K"),
          "Pa s": ("a viscosity", "Pa s"), "W/m/K": ("a thermal conductivity", "W/m/K"), "J": ("an energy", "kJ"), "N": ("a force", "kN"),
          "m^2": ("an area", "mm^2"), "m^3": ("a volume", "cm^3"), "m/s^2": ("an acceleration", "m/s^2"), "1": ("a plain number", "")}
# compound units as people write them, to know them again without their signs
_WRITTEN = ("km/s", "m/s", "mm/us", "cm/us", "g/cm^3", "kg/m^3", "g/cc", "kJ/kg", "MJ/kg", "J/kg", "J/g", "kJ/g", "J/kg/K", "J/g/K", "Pa s",
            "mPa s", "1/s", "1/us", "W/m/K", "m/s^2", "mm^2", "cm^2", "m^2", "mm^3", "cm^3", "m^3")
_DISPLAY = {"m": ("um", "mm", "m"), "s": ("ns", "us", "ms", "s"), "Pa": ("Pa", "kPa", "MPa", "GPa", "TPa"),
            "J/kg": ("J/kg", "kJ/kg", "MJ/kg")}


def parse(value, unit: str) -> float:
    """The SI value of a quantity.

    value   a number (taken as SI) or a text such as "3.94 km/s"
    unit    the SI unit that tells what kind of quantity is wanted, such as "m/s"; "1" for a plain number
    Raises `UnitError` with a hint: not a quantity, unknown unit, wrong kind, or not a finite number.
    """
    if isinstance(value, bool) or not isinstance(value, (numbers.Real, str)):
        raise UnitError(f"expected {_wanted(unit)}, got {_shown(value)}", _example(unit))
    if not isinstance(value, str):
        return _finite_number(value)
    return _parsed(value, unit)


@functools.lru_cache(maxsize=1024)      # of thousands of decks of a sweep all but a few quantities are the same
def _parsed(value: str, unit: str) -> float:
    number, name = _split(value, unit)
    if not name:
        if _powers(unit) == _NONE:
            return _to_float(number, Decimal(1), Decimal(0), value)
        hint = f"add one such as {_sample(unit)}, or omit the quotes for SI ({unit})"
        raise UnitError(f"{_shown(value)} has no unit", hint)
    return _to_float(number, *_of_kind(name, unit, value), value)


def parse_all(values: Iterable[float], name: str, unit: str) -> list[float]:
    """As `parse` of many numbers that have one unit, `name`; without one they are SI. Raises `UnitError`."""
    finite = [_finite_number(value) for value in values]
    if not name:
        return finite
    example = f"{finite[0] if finite else 1.0!r} {name}"
    factor, offset = _of_kind(_split(example, unit)[1], unit, example)
    with localcontext(prec=60):
        found = [float(Decimal(repr(value)) * factor + offset) for value in finite]
    for value, result in zip(finite, found):
        if result == 0.0 or not math.isfinite(result):
            _to_float(repr(value), factor, offset, f"{value!r} {name}")     # says what is wrong with it, if anything is
    return found


def _of_kind(name: str, unit: str, text: str) -> tuple[Decimal, Decimal]:
    """(factor, offset) from a unit to the SI unit `unit`; `UnitError` where it is one of another kind, as `text` was written with it."""
    if name in _OFFSET:
        found, offset = Unit(Decimal(1), _KELVIN), _OFFSET[name]
    else:
        try:
            found, offset = _read_unit(name), Decimal(0)
        except UnknownUnit as error:
            raise UnitError(error.message, _meant(name, unit, error)) from None
    if found.powers != _powers(unit):
        kind = _kind_of(found.powers)
        raise UnitError(f"expected {_wanted(unit)}, got {kind or 'something else'} ({_shown(text)})", _example(unit))
    return found.factor, offset


def powers_of(text: str) -> tuple[float, tuple[int, ...]]:
    """(SI value, powers of m, kg, s, K and mol) of a text such as "3.94 km/s", whatever its kind. Raises `UnitError`."""
    number, name = _split(text, "1")
    if name in _OFFSET:
        return _to_float(number, Decimal(1), _OFFSET[name], text), _KELVIN
    found = _read_unit(name) if name else _UNITS["1"]
    return _to_float(number, found.factor, Decimal(0), text), found.powers


@functools.lru_cache(maxsize=512)
def si_name(unit: str) -> str:
    """The SI unit of the kind of a unit: "Pa" for "GPa", "kg/m^3" for "g/cm^3". Raises `UnitError`."""
    powers = _KELVIN if unit in _OFFSET else _read_unit(unit).powers if unit else _NONE
    named = next((si for si in _KINDS if _powers(si) == powers), None)
    if named is not None:
        return named
    parts = [name if power == 1 else f"{name}^{power}" for name, power in zip(("m", "kg", "s", "K", "mol"), powers) if power]
    return " ".join(parts)


def convert(value: float, source: str, target: str) -> float:
    """A value in unit `source` expressed in unit `target`; both must be of one kind."""
    a, b = _read_unit(source), _read_unit(target)
    if a.powers != b.powers:
        raise UnitError(f"'{source}' and '{target}' are not units of one kind")
    return float(value) * float(a.factor / b.factor)


def format_si(value: float, unit: str, digits: int = 6) -> str:
    """An SI value for people: `format_si(5.51e9, "Pa") == "5.51 GPa"`, `format_si(0.002, "m") == "2 mm"`."""
    if unit in ("", "1"):
        return f"{value:.{digits}g}"
    shown, scale = unit, Decimal(1)
    if value and math.isfinite(value):
        for name in _DISPLAY.get(unit, ()):
            if name == _DISPLAY[unit][0] or abs(value) >= float(_read_unit(name).factor) * (1 - 1e-12):
                shown, scale = name, _read_unit(name).factor
    return f"{value / float(scale):.{digits}g} {shown}"


def _split(text: str, unit: str) -> tuple[str, str]:
    if len(text) > LONGEST:
        raise UnitError(f"a quantity of {len(text)} characters is too long: {_shown(text)}", _example(unit))
    match = _QUANTITY.fullmatch(text.strip())
    if match is None:
        raise UnitError(f"{_shown(text)} is not a quantity", _example(unit))
    return match[1], match[2].strip()


def _finite_number(value) -> float:
    try:
        number = float(value)
    except OverflowError:
        raise UnitError("number too large") from None
    if not math.isfinite(number):
        raise UnitError(f"expected a finite number, got {number}")
    return number


def _to_float(number: str, factor: Decimal, offset: Decimal, text: str) -> float:
    with localcontext(prec=60):
        try:
            exact = Decimal(number) * factor + offset
        except DecimalException:
            raise UnitError(f"{_shown(text)} is not a finite number") from None
    result = float(exact)
    if not math.isfinite(result):
        raise UnitError(f"{_shown(text)} is too large to represent")
    if result == 0.0 and exact != 0:
        raise UnitError(f"{_shown(text)} is too small to represent")
    return result


@functools.lru_cache(maxsize=512)      # a deck names the same units over and over, and a sweep reads it thousands of times
def _read_unit(text: str) -> Unit:
    """A unit expression: names with powers, joined by `*`, `·`, a space or `/`, with brackets."""
    tokens, position = [], 0
    while position < len(text):
        match = _TOKEN.match(text, position)
        if match is None:
            raise UnitError(f"'{_shown(text, quote=False)}' is not a unit")
        tokens.append(match[1] or match[2] or match[3])
        position = match.end()
    reader = _Reader(tokens, text)
    with localcontext(prec=60):
        try:
            unit = reader.product()
        except (DecimalException, RecursionError):
            raise reader.broken() from None
    if reader.rest:
        raise reader.broken()
    return unit


class _Reader:
    """Recursive descent over the tokens of one unit expression; `rest` is what is still unread, reversed."""

    def __init__(self, tokens: list[str], text: str):
        self.rest, self.text = tokens[::-1], text

    def broken(self) -> UnitError:
        return UnitError(f"'{_shown(self.text, quote=False)}' is not a unit", "write units like 'km/s', 'g/cm^3', 'J/kg/K'")

    def product(self) -> Unit:
        unit = self.power()
        while self.rest and self.rest[-1] != ")":
            sign = 1
            if self.rest[-1] in ("*", "·", "/"):
                sign = -1 if self.rest.pop() == "/" else 1
            factor, powers = self.power()
            unit = Unit(unit.factor * factor**sign, _added(unit.powers, powers, sign))
        return unit

    def power(self) -> Unit:
        unit = self.atom()
        if self.rest and self.rest[-1] in ("^", "**"):
            self.rest.pop()
            exponent = self.rest.pop() if self.rest else ""
            if not re.fullmatch(r"-?\d", exponent):
                raise self.broken()
            unit = Unit(unit.factor ** int(exponent), _added(_NONE, unit.powers, int(exponent)))
        return unit

    def atom(self) -> Unit:
        token = self.rest.pop() if self.rest else ""
        if token == "(":
            unit = self.product()
            if not self.rest or self.rest.pop() != ")":
                raise self.broken()
            return unit
        if token == "1":
            return _UNITS["1"]
        match = re.fullmatch(r"([A-Za-zµμ°%Ω]+)(\d?)", token)
        if match is None:
            raise self.broken()
        unit = _UNITS.get(match[1]) or _from_pint(match[1])
        exponent = int(match[2] or 1)  # "m2" as in tables
        return Unit(unit.factor**exponent, _added(_NONE, unit.powers, exponent))


def _added(a, b, times: int):
    return tuple(x + times * y for x, y in zip(a, b))


_pint_registry = []


def _from_pint(name: str) -> Unit:
    """One unit name that the table lacks, such as `furlong`, looked up in pint."""
    near = _nearest(name)
    if len(name) > 30:
        raise UnitError(f"unknown unit '{_shown(name, quote=False)}'")
    if near.lower() != name.lower() and difflib.SequenceMatcher(None, near, name).ratio() < _SLIP:
        try:
            import pint
        except ImportError:
            pint = None
        if pint is not None:
            if not _pint_registry:
                _pint_registry.append(pint.UnitRegistry(cache_folder=None))
            try:
                quantity = _pint_registry[0].Quantity(1.0, _pint_registry[0].Unit(name)).to_base_units()
                size, powers = float(quantity.magnitude), {str(k): v for k, v in quantity.unit_items()}
            except Exception:  # pint raises many kinds for names it cannot use
                size, powers = 0.0, {"?": 1}
            order = ("meter", "kilogram", "second", "kelvin", "mole")
            if set(powers) <= {*order, "radian"} and all(v == int(v) for v in powers.values()) and "deg" not in name:
                return Unit(Decimal(repr(size)), tuple(int(powers.get(k, 0)) for k in order))
    raise UnknownUnit(name, near)


def _meant(name: str, unit: str, error: UnknownUnit) -> str:
    """The hint for a unit with an unknown name where one of the kind of `unit` is wanted: km/s for `kms` and a velocity, not ms."""
    bare = re.sub("[^A-Za-z0-9]", "", name).lower()
    for written in _WRITTEN:
        if re.sub("[^A-Za-z0-9]", "", written).lower() == bare and _powers(written) == _powers(unit):
            return f"did you mean '{written}'?"
    if error.near:
        try:
            right = _read_unit(name.replace(error.name, error.near, 1)).powers == _powers(unit)
        except UnitError:
            right = False
        return error.hint if right else _example(unit)
    return error.hint


@functools.lru_cache(maxsize=256)      # a slip of a unit is often made in every line
def _nearest(name: str) -> str:
    same = [known for known in _UNITS if known.lower() == name.lower()]
    usual = [u for u in ("GPa", "km", "mm", "us", "kg", "kJ", "MJ", "MPa", "Mbar", "kbar") if u in same]
    found = usual or same or difflib.get_close_matches(name, [u for u in _UNITS if u != "1"], n=1, cutoff=0.6)
    return found[0] if found else ""


def _powers(unit: str):
    return _read_unit(unit).powers if unit else _NONE


def _kind_of(powers) -> str:
    return next((words for si, (words, _) in _KINDS.items() if _powers(si) == powers), "")


def _wanted(unit: str) -> str:
    return _kind_of(_powers(unit)) or f"a quantity in {unit}"


def _sample(unit: str) -> str:
    return next((sample for si, (_, sample) in _KINDS.items() if _powers(si) == _powers(unit)), unit)


def _example(unit: str) -> str:
    return f"write it like \"1.5 {_sample(unit)}\"" if _powers(unit) != _NONE else "write it like 1.5"


def _shown(value, quote: bool = True) -> str:
    """A value as it appears in a message: short, one line, control characters escaped."""
    if isinstance(value, str):
        text = value if len(value) <= 40 else value[:37] + "..."
        text = "".join(c if c.isprintable() else f"\\x{ord(c):02x}" for c in text)
        return f"'{text}'" if quote else text
    kinds = {bool: "true" if value is True else "false", dict: "a table", list: "an array", tuple: "an array", type(None): "nothing"}
    return kinds.get(type(value), f"a {type(value).__name__}")
