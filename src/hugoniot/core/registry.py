"""Registries, one for each family of laws, filled by one `add` line per law file.

A registered law is found by its name (decks, `hugoniot list`) or by the class of its parameter tuple (kernels, theory).
The law follows from the type of the parameters, so a caller needs only a parameter tuple.
"""

import difflib
import importlib
import math
import pkgutil
import sys
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from types import ModuleType
from typing import Any

_class_names: dict[str, list[type]] = {}     # of every law that was ever registered in this process


class UnknownName(KeyError):
    """A name that is not registered; the message offers the nearest one."""

    def __str__(self) -> str:
        return str(self.args[0])


@dataclass(frozen=True)
class Law:
    """One registered law.

    parameters   the NamedTuple class of its named parameters (floats; units in `units`)
    functions    the law's undecorated scalar functions by contract name
    example      a parameter tuple that contract tests and docs use
    units        parameter name -> SI unit as text ("kg/m^3", "1")
    meaning      parameter name -> one phrase
    box          contract variable -> (low, high): where the example is valid, in SI
    references   where the equation stands, with its number
    build        function from the deck's named values (SI) to the parameter tuple; default: the class itself
    flags        facts a solver may query, such as "linear_in_energy"
    above, least   parameter name -> what it must be greater than, or not less than
    line         what it is, where one file holds several laws; else the first line of the file says so
    """

    family: str
    name: str
    parameters: type
    functions: Mapping[str, Callable]
    example: Any
    units: Mapping[str, str]
    meaning: Mapping[str, str]
    box: Mapping[str, tuple[float, float]]
    references: tuple[str, ...]
    build: Callable
    flags: Collection[str] = frozenset()
    defaults: Mapping[str, float] = field(default_factory=dict)
    line: str = ""
    above: Mapping[str, float] = field(default_factory=dict)
    least: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self):
        """Copies, so that nobody changes a law by changing what it was made of."""
        for name in ("units", "meaning", "box", "defaults", "above", "least"):
            object.__setattr__(self, name, dict(getattr(self, name)))
        object.__setattr__(self, "flags", frozenset(self.flags))

    @property
    def module(self) -> ModuleType:
        return sys.modules[self.parameters.__module__]

    @property
    def summary(self) -> str:
        """What the law is, in one line."""
        return self.line or (self.module.__doc__ or "").strip().splitlines()[0]


class Registry:
    """The laws of one family.

    contract   names of functions every law must give
    optional   names of functions a law may give
    derived    functions every law has, made from its others unless it gives its own
    """

    def __init__(self, family: str, contract: tuple[str, ...], optional: tuple[str, ...] = (),
                 derived: Mapping[str, Callable] | None = None):
        self.family, self.contract, self.optional, self.derived = family, contract, optional, dict(derived or {})
        self._by_name: dict[str, Law] = {}
        self._by_class: dict[type, Law] = {}

    def add(self, name, parameters, *, functions, units, meaning, references, build=None, **others):
        """Register a law; every argument is a field of `Law`. Refuses a duplicate name and a law that does not satisfy the contract."""
        if name in self._by_name or parameters in self._by_class:
            raise ValueError(f"{self.family}: '{name}' is registered already")
        given = {f.__name__: f for f in functions} if not isinstance(functions, Mapping) else dict(functions)
        missing = [f for f in self.contract if f not in given]
        stray = [f for f in given if f not in self.promises]
        undocumented = [p for p in parameters._fields if p not in units or p not in meaning]
        complaints = ((missing, "lacks"), (stray, "gives functions outside the contract:"), (undocumented, "lacks unit or meaning of"))
        for problem, what in complaints:
            if problem:
                raise ValueError(f"{self.family}: '{name}' {what} {', '.join(problem)}")
        if not references:
            raise ValueError(f"{self.family}: '{name}' names no source")
        law = Law(self.family, name, parameters, {**self.derived, **given}, units=units, meaning=meaning, references=tuple(references),
                  build=build or parameters, **others)
        self._by_name[name] = law
        self._by_class[parameters] = law
        _name_apart(parameters)
        return law

    @property
    def promises(self) -> tuple[str, ...]:
        """Contract names of every function a law of the family may have."""
        return (*self.contract, *self.optional, *self.derived)

    def remove(self, name: str) -> None:
        """Take a law out again, for a notebook's cell that is run twice and for tests. Materials made of it keep their numbers only."""
        del self._by_class[self._by_name.pop(self.get(name).name).parameters]

    def get(self, name: str) -> Law:
        """The law of that name; `UnknownName` offers the nearest."""
        try:
            return self._by_name[name]
        except KeyError:
            near = difflib.get_close_matches(name, self._by_name, n=1)
            hint = f"; did you mean '{near[0]}'?" if near else f"; known: {', '.join(sorted(self._by_name))}"
            raise UnknownName(f"unknown {self.family} law '{name}'{hint}") from None

    def of(self, par) -> Law:
        """The law whose parameters `par` is."""
        return self.of_class(type(par))

    def of_class(self, cls: type) -> Law:
        return self._by_class[cls]

    def knows(self, par) -> bool:
        """Whether `par` is the parameter tuple of a law of this family."""
        return type(par) in self._by_class

    def names(self) -> list[str]:
        return sorted(self._by_name)

    def __iter__(self):
        return iter(self._by_name.values())

    def __len__(self) -> int:
        return len(self._by_name)


def _name_apart(parameters: type) -> None:
    """Number the later ones of several parameter classes of one name.

    Compiled code finds the version made for an argument by the name of its class: a law registered again after an edit, or another law
    with a class of the same name, would silently be answered by the first one's.
    """
    alike = _class_names.setdefault(parameters.__name__, [])
    if parameters not in alike:
        alike.append(parameters)
        if len(alike) > 1:
            parameters.__name__ = f"{parameters.__name__}_{len(alike)}"
            _name_apart(parameters)


def finite(par) -> bool:
    """Whether every number of a parameter tuple is finite."""
    return all(math.isfinite(v) for v in par if isinstance(v, (int, float)))


def enrol_folder(package: str, path) -> None:
    """Import every module of a package folder, so that each law file enrols itself."""
    for module in pkgutil.iter_modules(path):
        importlib.import_module(f"{package}.{module.name}")
