"""What every deck model is made of: quantities, strict tables, errors in plain words.

A deck's shape is a pydantic model, from which the editor's JSON Schema and the deck reference come. Each solver has its own
model, named in `problem.solver_kinds`; a new solver plugs in with one line there.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, ValidationError
from pydantic_core import PydanticCustomError, core_schema

from hugoniot.laws import mixture, viscosity  # noqa: F401  (enrols the laws)
from hugoniot.materials.collect import Collector, nearest, printable
from hugoniot.units import UnitError, parse

# tables that a deck may repeat
_ARRAYS = ("region", "block", "boundary", "gauge", "interface", "lighting", "heat_source", "contact", "rigid")

# what needs no quotes, by the kind of error that quotes cause
_UNQUOTED = {"int_type": re.compile(r"[+-]?\d+"), "float_type": re.compile(r"[+-]?\d+\.?\d*([eE][+-]?\d+)?"),
             "bool_type": re.compile("true|false")}


class Table(BaseModel):
    """A table of a deck: unknown keys and values of another type are errors."""

    model_config = ConfigDict(extra="forbid", strict=True, populate_by_name=True, frozen=True)


@dataclass(frozen=True)
class Quantity:
    """Mark of a number in a model, `Annotated[float, Quantity("m")]`: a number (SI) or text with unit.

    above, least   bounds of the value; `limit` of its magnitude
    """

    unit: str
    above: float | None = None
    least: float | None = None
    limit: float = 1e30

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(self.read)

    def __get_pydantic_json_schema__(self, source: Any, handler: Any) -> dict:
        text = {"type": "string", "pattern": r"^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*\S.*$"}
        return {"anyOf": [{"type": "number"}, text], "unit": self.unit}

    def read(self, value: Any) -> float:
        """The SI value, or the error pydantic collects."""
        try:
            number = parse(value, self.unit)
        except UnitError as error:
            raise trouble(error.message, error.hint) from None
        if self.above is not None and not number > self.above:
            raise trouble(f"must be greater than {self.above:g}, got {_as_written(value)}")
        if self.least is not None and not number >= self.least:
            unit = "" if self.unit == "1" or not self.least else f" {self.unit}"
            raise trouble(f"must not be less than {self.least:g}{unit}, got {_as_written(value)}")
        if abs(number) > self.limit:
            unit = "" if self.unit == "1" else f" {self.unit}"
            given = f"{number:g}{unit}" + (f" ({_as_written(value)})" if isinstance(value, str) and self.unit != "1" else "")
            raise trouble(f"unreasonably large: {given}", f"the limit is {self.limit:g}{unit}")
        return number


def _as_written(value: Any) -> str:
    return repr(printable(value)) if isinstance(value, str) else printable(value)


def quantity(unit: str, **bounds: float) -> Any:
    """The type `Annotated[float, Quantity(unit, ...)]`, for models made while running."""
    return Annotated[float, Quantity(unit, **bounds)]


Length = Annotated[float, Quantity("m", limit=1e15)]
Time = Annotated[float, Quantity("s", limit=1e15)]
Pressure = Annotated[float, Quantity("Pa")]


def trouble(message: str, hint: str = "") -> PydanticCustomError:
    """The error a validator raises; the braces of a user's text must not be taken for a format."""
    return PydanticCustomError("deck", "{message}", {"message": message, "hint": hint})


def validate(model: type[BaseModel], raw: Any, collector: Collector, path: tuple = (), skip: tuple[str, ...] = ()) -> Any:
    """The model made from a raw table, or None after reporting everything wrong with it."""
    try:
        return model.model_validate(raw)
    except ValidationError as error:
        found = [item for item in error.errors(include_url=False) if tuple(item["loc"])[:1] not in [(s,) for s in skip]]
        for k, item in enumerate(found):
            if collector.full:
                collector.count(len(found) - k)     # they need no words
                break
            collector.add((*path, *item["loc"]), *_in_words(item, model))
        return None


def salvage(model: type[BaseModel], raw: Any) -> Any:
    """The model if the raw table fits it, else None, silently: for checks that go on in spite of errors reported already."""
    try:
        return model.model_validate(raw)
    except ValidationError:
        return None


def _in_words(item: Mapping, model: type[BaseModel]) -> tuple[str, str]:
    """Message and hint of one pydantic error."""
    kind, location, context, given = item["type"], item["loc"], item.get("ctx", {}), item["input"]
    shown = printable(given if isinstance(given, str) else _brief(given), 40)
    if kind == "deck":
        return context["message"], context["hint"]
    if kind == "extra_forbidden" and location == ("sweep",) and "output" in keys_of(model):
        return "only hugoniot sweep runs a deck with this table", "leave the table out to make a single run"
    if kind == "extra_forbidden":
        return "unknown key", nearest(location[-1], keys_of(_model_at(model, location[:-1])))
    if kind == "missing":
        field = _field_at(model, location)
        return f"missing ({field.description})" if field is not None and field.description else "missing", ""
    if kind == "literal_error":
        found = f"'{shown}'" if isinstance(given, str) else shown
        return f"expected {context['expected']}, got {found}", nearest(shown, _literals(context["expected"]), " ").strip()
    words = {"int_type": "expected a whole number", "int_from_float": "expected a whole number", "string_type": "expected a string",
             "bool_type": "expected true or false", "float_type": "expected a number", "list_type": "expected an array",
             "dict_type": "expected a table", "model_type": "expected a table", "tuple_type": "expected an array"}
    if kind in words:
        name = location[-1] if location else ""
        hint = f"write [[{name}]] above its keys" if kind == "list_type" and name in _ARRAYS else ""
        if kind in _UNQUOTED and isinstance(given, str) and _UNQUOTED[kind].fullmatch(given):
            hint = "omit the quotes"
        quoted = f"'{shown}'" if isinstance(given, str) else shown
        return f"{words[kind]}, got {quoted}", hint
    bounds = {"greater_than": ("greater than", "gt"), "greater_than_equal": ("at least", "ge"), "less_than_equal": ("at most", "le"),
              "less_than": ("less than", "lt")}
    if kind in bounds:
        word, key = bounds[kind]
        return f"must be {word} {_grouped(context[key])}, got {shown}", ""
    if kind == "string_too_long":
        return f"must have at most {context['max_length']} characters, got {len(given)}", ""
    return printable(item["msg"][:1].lower() + item["msg"][1:], 200), ""


def _grouped(number: float) -> str:
    return f"{number:,}".replace(",", " ")


def _literals(expected: str) -> list[str]:
    return [word.strip(" '") for word in expected.replace(" or ", ", ").split(",")]


def _brief(value: Any) -> str:
    kinds = {dict: "a table", list: "an array", bool: str(value).lower()}
    return kinds.get(type(value), repr(value) if not isinstance(value, int) or abs(value) < 1e18 else "a number of many digits")


def keys_of(model: type[BaseModel] | None) -> list[str]:
    """The keys a table of that model may have, as a deck writes them."""
    return [] if model is None else [field.alias or name for name, field in model.model_fields.items()]


def _field_at(model: type[BaseModel], location: tuple):
    owner = _model_at(model, location[:-1])
    if owner is None:
        return None
    return next((f for n, f in owner.model_fields.items() if (f.alias or n) == location[-1]), None)


def _model_at(model: type[BaseModel] | None, location: tuple) -> type[BaseModel] | None:
    """The model of the table at a location of a deck."""
    for part in location:
        if isinstance(part, int) or model is None:
            continue
        field = next((f for n, f in model.model_fields.items() if (f.alias or n) == part), None)
        model = None if field is None else _model_in(field.annotation)
    return model


def _model_in(annotation: Any) -> type[BaseModel] | None:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation
    for inner in getattr(annotation, "__args__", ()):
        if (found := _model_in(inner)) is not None:
            return found
    return None
