"""hugoniot eos convert: constants of another fit as the coefficients of Herrmann's series, and as the law of a deck."""

import inspect
import math
from collections.abc import Callable
from typing import Annotated, NamedTuple

import typer

from hugoniot.cli.show import JSON, echo_json, echo_table, quantity
from hugoniot.errors import DeckError
from hugoniot.laws.eos import converters
from hugoniot.materials.collect import nearest

UNITS = {**dict.fromkeys(("lame_lambda", "shear_modulus", "a", "b", "c"), "Pa"), "rho0": "kg/m^3", "c0": "m/s", "expansion": "1/K",
         "heat_at_pressure": "J/kg/K", "specific_heat": "J/kg/K", "k0": "Pa", "h0": "kg/m^3", "reference_temperature": "K"}


class Form(NamedTuple):
    """convert(**constants) -> series of the Hugoniot; what: the fit in words; equation of the source."""

    convert: Callable[..., converters.HugoniotSeries]
    what: str
    equation: str


FORMS = {
    "linear": Form(converters.from_linear, "Us = c0 + s up", "C.7"),
    "murnaghan": Form(converters.from_murnaghan, "p = A [(rho/rho0)^n - 1]", "C.9"),
    "finite_strain": Form(converters.from_finite_strain, "linear elastic solid in finite strain", "C.10, C.11 corrected"),
    "compression_cubic": Form(converters.from_compression_cubic, "p = A mu + B mu^2 + C mu^3, mu = rho/rho0 - 1",
                              "appendix C, Rice-McQueen-Walsh"),
}
_GAMMA = ("rho0", "gamma0", "gamma1", "gamma2", "gamma3", "expansion", "heat_at_pressure", "specific_heat")


def convert(
    form: Annotated[str, typer.Argument(help=f"Form of the fit: {', '.join(FORMS)}.")],
    constants: Annotated[list[str], typer.Argument(metavar="NAME=VALUE", help='Constants of the fit, such as "c0=5.35 km/s" '
        's=1.34 "rho0=2.7 g/cm^3".')],
    as_json: JSON = False,
) -> None:
    """Convert a fit to Herrmann's series.

    Prints the coefficients k0', k1' and k2' of the series of the pressure in the compression. With rho0 and gamma0 it also prints the law
    for a deck.

    Instead of gamma0, expansion (alpha) and heat_at_pressure (c_p) may be given: gamma0 = k0' alpha/(rho0 c_p). gamma1 to gamma3 are 0
    unless given.

    Example: hugoniot eos convert linear "rho0=2785 kg/m^3" "c0=5328 m/s" s=1.338 gamma0=2
    """
    if form not in FORMS:
        raise DeckError.single("command line", None, form[:40], "no such fit", nearest(form, FORMS))
    chosen = FORMS[form]
    names = tuple(inspect.signature(chosen.convert).parameters)
    given = _read(constants, (*names, *_GAMMA))
    missing = [n for n in names if n not in given]
    if missing:
        raise DeckError.single("command line", None, form, f"not given: {', '.join(missing)}", f"write {missing[0]}=VALUE")
    series = chosen.convert(**{n: given[n] for n in names})
    gamma0 = _gamma(given, series)
    law = None
    if idle := _idle(given, gamma0):
        raise DeckError.single("command line", None, idle, "has no effect", "give gamma0, or expansion and heat_at_pressure with rho0; "
                               "the others belong to the complete law")
    if gamma0 is not None and "rho0" in given:
        law = converters.series(given["rho0"], series, gamma0, tuple(given.get(f"gamma{i}", 0.0) for i in (1, 2, 3)),
                                given.get("specific_heat", math.nan))
    if as_json:
        echo_json({"form": form, "what": chosen.what, "source": f"Herrmann, WL-TR-64-107, {chosen.equation}", "hugoniot": series._asdict(),
                   "gamma0": gamma0, "law": None if law is None else {"law": "herrmann_series", **_finite(law)}})
        return
    typer.echo(f"{chosen.what} (Herrmann {chosen.equation}) as p_H = k0' eta (1 + k1' eta + k2' eta^2), eta = 1 - rho0/rho:")
    echo_table(["", "value", "unit"], [(f"{k}'", f"{v:.10g}", UNITS.get(k, "")) for k, v in series._asdict().items() if k != "k3"])
    if law is None:
        typer.echo("\nrho0 and gamma0 (or expansion and heat_at_pressure) as well would give the complete law")
        return
    lines = [f'{k} = "{v:.10g} {UNITS[k]}"' if k in UNITS else f"{k} = {v:.10g}" for k, v in _finite(law).items()]
    typer.echo("\n" + "\n".join(["[material.x.eos]", 'law = "herrmann_series"', *lines]))


def _gamma(given: dict[str, float], series: converters.HugoniotSeries) -> float | None:
    """gamma0 as given, or by C.14; None where neither is."""
    if "gamma0" in given:
        return given["gamma0"]
    if {"expansion", "heat_at_pressure", "rho0"} <= set(given):
        return converters.gruneisen_from_expansion(series.k0, given["expansion"], given["rho0"], given["heat_at_pressure"])
    return None


def _idle(given: dict[str, float], gamma0: float | None) -> str:
    """A constant that enters nothing: of a law that is not complete, or of the Grüneisen parameter where that is given; else ""."""
    needed = () if "gamma0" in given or gamma0 is None else ("expansion", "heat_at_pressure")
    of_law = ("gamma1", "gamma2", "gamma3", "specific_heat") if gamma0 is not None and "rho0" in given else ()
    idle = {"expansion", "heat_at_pressure", "gamma1", "gamma2", "gamma3", "specific_heat"} - {*needed, *of_law}
    return next((name for name in given if name in idle), "")


def _finite(law) -> dict[str, float]:
    """The parameters of the law that a deck must state."""
    return {k: v for k, v in law._asdict().items() if not math.isnan(v)}


def _read(texts: list[str], known: tuple[str, ...]) -> dict[str, float]:
    """name -> SI number of NAME=VALUE texts."""
    found: dict[str, float] = {}
    for text in texts:
        name, equals, value = (part.strip() for part in text.partition("="))
        if not equals:
            raise DeckError.single("command line", None, text[:40], "has no value", 'write NAME=VALUE, such as "c0=5.35 km/s"')
        if name not in known:
            raise DeckError.single("command line", None, name[:40], "unknown constant", nearest(name, known))
        found[name] = quantity(value, UNITS.get(name, "1"), name)
    return found
