"""The laws and the searches of the theory as JavaScript: the page computes impacts from the same source as the command.

They are followed from a few roots to whatever they call (`transcriber`); a call such as `pressure(rho, e, par)` is resolved by the law
that `par` carries, as everywhere.
"""

import json
import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from hugoniot.explorer.transcriber import HELPERS, Transcriber
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.materials import initial_state
from hugoniot.theory import expansion, jump, states, upstream

ROOTS = {"first_guess": jump.first_guess, "shocked": jump.shocked, "to_pressure": expansion.to_pressure,
         "energy_at_temperature": initial_state.energy_at_temperature, "sound_speed_squared": contract.sound_speed_squared,
         "gruneisen": contract.gruneisen, "density_range": states.density_range,
         "interval": upstream.interval, "sound_speed_ahead": upstream.sound_speed_ahead, "crushed": upstream.crushed,
         "distended": upstream.distended, "fastest": upstream.fastest,
         **{name: contract.GENERICS[name] for name in ("pressure", "pressure_derivatives", "temperature", "entropy", "reference_state",
                                                       "remembered", "unloading", "compacted")}}
_OF_PARAMETERS = ("density_limits", "particle_velocity_limit")
_HEAD = """"use strict";
// Transcribed from the laws and the theory of hugoniot; not written by hand.
H.theory = (() => {
"""


@cache
def theory() -> bytes:
    """The script: `H.theory` holds the functions of `ROOTS`, and `laws` with the functions and flags of every registered law."""
    reader = Transcriber()
    laws = []
    for law in EOS:       # the limits of energies, which no search asks for, are arithmetic of arrays
        functions = ", ".join(f"{key}: {f'par => par.{key}' if _shipped(key, function) else reader.name_of(function)}"
                              for key, function in law.functions.items() if key != "energy_limits")
        laws.append(f"laws.{law.name} = {{name: {json.dumps(law.name)}, flags: {json.dumps(sorted(law.flags))}, {functions}}};\n")
    roots = ", ".join(f"{name}: {reader.name_of(function)}" for name, function in ROOTS.items())
    reader.follow()
    tail = f"return {{laws, NoState, number, {roots}}};\n}})();\n"
    return "".join([_HEAD, HELPERS, "const laws = {};\n", *reader.written, *laws, tail]).encode()


def parameters(par) -> dict[str, Any]:
    """The parameters of a law for the page: its name under "$", numbers, lists for tables, dictionaries for laws inside it."""
    functions = EOS.of(par).functions
    shipped = {name: _plain(functions[name](par)) for name in _OF_PARAMETERS if name in functions and _shipped(name, functions[name])}
    return {"$": EOS.of(par).name} | {name: _plain(value) for name, value in zip(par._fields, par)} | shipped


@cache
def _shipped(name: str, function: Callable) -> bool:
    """Whether what a law says of its parameters alone goes with them as a number, as its source is more than scalar code (roots)."""
    if name not in _OF_PARAMETERS:
        return False
    reader = Transcriber()
    reader.name_of(function)
    try:
        reader.follow()
    except NotImplementedError:
        return True
    return False


def _plain(value) -> Any:
    if EOS.knows(value):
        return parameters(value)
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, tuple):
        return [_plain(inner) for inner in value]
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value
