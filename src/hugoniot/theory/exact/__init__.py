"""Exact solutions: callables of positions and time that share no code with the solvers, each with its derivation and source.

`SOLUTIONS[name](**parameters)` gives a `Solution`; the first line of its docstring says what it is (`describe`), and its rows `name
meaning` describe the parameters. Problems with fixed parameters (Sod, LeBlanc, ...) are entries like the general solutions from which
they are made. Two entries give data instead: `woodward_colella` (reference values) and `kenamond` (functions that give burn times).
"""

from collections.abc import Callable
from typing import Any

from hugoniot.theory.exact.blake import blake
from hugoniot.theory.exact.coggeshall import coggeshall
from hugoniot.theory.exact.coggeshall_flows import coggeshall_coasting, coggeshall_collapse, coggeshall_driven, coggeshall_shell
from hugoniot.theory.exact.coggeshall_shocks import coggeshall_noh, coggeshall_stopping
from hugoniot.theory.exact.double_burgers import double_burgers
from hugoniot.theory.exact.dsd import dsd_arc, dsd_expansion, dsd_rate_stick
from hugoniot.theory.exact.dsd_start import dsd_rate_stick_start
from hugoniot.theory.exact.ehep import ehep
from hugoniot.theory.exact.elastic_plastic_piston import aluminium_piston, copper_piston, elastic_plastic_piston, udaykumar_piston
from hugoniot.theory.exact.fickett_rivard import fickett_rivard
from hugoniot.theory.exact.guderley import guderley
from hugoniot.theory.exact.kenamond import kenamond
from hugoniot.theory.exact.kidder import kidder
from hugoniot.theory.exact.mader import mader
from hugoniot.theory.exact.meeting_streams import meeting_streams
from hugoniot.theory.exact.noh import noh
from hugoniot.theory.exact.noh_material import noh_material
from hugoniot.theory.exact.plate_push import plate_push
from hugoniot.theory.exact.riemann_ideal import collision, leblanc, riemann_ideal, sod, two_rarefactions, water_gas
from hugoniot.theory.exact.saltzman import saltzman
from hugoniot.theory.exact.sedov import sedov
from hugoniot.theory.exact.shell_stopping import howell_ball, shell_stopping, verney
from hugoniot.theory.exact.simple_wave import centred_rarefaction, piston_pulse
from hugoniot.theory.exact.solution import Solution
from hugoniot.theory.exact.uniform_collapse import uniform_collapse
from hugoniot.theory.exact.woodward_colella import woodward_colella

# SI unit of a parameter by its name; what is not listed is a plain number or a word
PARAMETER_UNITS = {
    **dict.fromkeys(("density", "outer_density", "rho0"), "kg/m^3"),
    **dict.fromkeys(("pressure", "inner_pressure", "outer_pressure", "p_infinity", "yield_stress", "shear_modulus", "bulk_modulus"), "Pa"),
    **dict.fromkeys(("speed", "velocity", "piston", "detonation_velocity", "inner_velocity", "outer_velocity", "c0"), "m/s"),
    **dict.fromkeys(("length", "inner", "outer", "x0", "radius", "detonators", "detonator", "curvature_length",
                     "station"), "m"),
    "duration": "s", "times": "s", "collapse_time": "s", "rate": "1/s", "energy_per_mass": "J/kg",
}
# unit of the energy of a point explosion: per area of a plane, per length of an axis
_EXPLOSION = {"planar": "J/m^2", "cylindrical": "J/m", "spherical": "J"}

SOLUTIONS: dict[str, Callable[..., Any]] = {
    function.__name__: function
    for function in (
        aluminium_piston, blake, centred_rarefaction, coggeshall, coggeshall_coasting, coggeshall_collapse, coggeshall_driven,
        coggeshall_noh, coggeshall_shell, coggeshall_stopping, collision, copper_piston, double_burgers, dsd_arc, dsd_expansion,
        dsd_rate_stick, dsd_rate_stick_start, ehep, elastic_plastic_piston, fickett_rivard, guderley, howell_ball, kenamond, kidder,
        leblanc, mader,
        meeting_streams, noh, noh_material, piston_pulse, plate_push, riemann_ideal, saltzman, sedov, shell_stopping, sod,
        two_rarefactions, udaykumar_piston, uniform_collapse, verney, water_gas, woodward_colella,
    )
}


def describe(name: str) -> str:
    """One line on the solution of that name."""
    return (SOLUTIONS[name].__doc__ or "").strip().splitlines()[0]


def parameter_unit(parameter: str, geometry: str = "spherical") -> str:
    """SI unit of a parameter, "1" for a plain number; `geometry` matters for the energy of an explosion."""
    if parameter == "energy":
        return _EXPLOSION.get(geometry, "J")
    return PARAMETER_UNITS.get(parameter, "1")


__all__ = ["SOLUTIONS", "Solution", "describe", "parameter_unit"]
