"""Steady Riemann problem in two dimensions: two supersonic streams that meet, with any two equations of state.

It tests a two-dimensional solver in oblique shocks, fans and slip lines, and gives the deflection of streams of real materials.

One stream flows along x below the origin, the other above it at an angle to x. They meet at the origin, from which a shock or a centred
fan runs into each stream. A slip line lies between the two waves, with the same pressure and flow direction on both sides. The pressure is
found where the shock polars, continued by the fans, intersect. The state depends on the angle about the origin alone; it is given along
the line x = `station`.

Source: Courant and Friedrichs, Supersonic Flow and Shock Waves, sec. 124; Loh and Hui, J. Comput. Phys. 89 (1990) 207.
"""

import math
from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline

from hugoniot.theory.exact.solution import Solution
from hugoniot.theory.exact.substance import law_named
from hugoniot.theory.isentrope import isentrope, state
from hugoniot.theory.shock_polar import Meeting, Stream, meeting


class Inflow(NamedTuple):
    """A stream: material (a name of the library), Mach number, pressure (Pa), density (kg/m^3; 0: the reference density)."""

    material: str = "air"
    mach: float = 3.0
    pressure: float = 101325.0
    density: float = 0.0


BELOW, ABOVE = Inflow(), Inflow("air", 4.0, 50e3)


def meeting_streams(below: Inflow = BELOW, above: Inflow = ABOVE, angle_degrees: float = 0.0,
                    station: float = 1.0) -> Solution:
    """Steady Riemann problem: two supersonic streams that meet, each through a shock or a fan, with a slip line between them.

    below.material, above.material   name of the library material of the stream
    below.mach, above.mach           Mach number of the stream, above 1
    below.pressure, above.pressure   pressure of the stream
    below.density, above.density     density of the stream, from which with the pressure its energy follows; 0: the reference density of
                                     the material
    angle_degrees                    direction of the upper stream from x; negative: towards the lower stream
    station                          x of the line along which the fields are given

    Positions are y along that line. The solution does not depend on time. Of two possible shocks the weak one is taken.

    Fields: density, pressure, energy, axial_velocity (along x), transverse_velocity (along y).
    Numbers: slip_pressure and slip_angle, and for each stream (prefixes below_ and above_) head and tail, where its wave begins and ends
    (equal for a shock), and deflection, by which the wave turns the stream. All angles are in degrees, positive anticlockwise. The
    deflection is measured from the direction of the undisturbed stream, the others from x.
    """
    angle = math.radians(angle_degrees)
    found = meeting(_stream(below), _stream(above), angle)
    waves = (_wave(found, found.below, 0.0, -1), _wave(found, found.above, angle, 1))

    def rays():
        edges = [w["angles"][0] for w in waves] + [w["angles"][-1] for w in waves] + [found.direction]
        return tuple(sorted({station * math.tan(a) for a in edges}))

    def profile(y, time):
        phi = np.arctan2(y, station)
        names = ("density", "pressure", "energy", "axial_velocity", "transverse_velocity")
        rows = {name: np.zeros(y.shape) for name in names}
        for wave, side in zip(waves, (phi < found.direction, phi >= found.direction)):
            for name, values in zip(names, _sample(wave, phi[side])):
                rows[name][side] = values
        return rows

    numbers = {"slip_pressure": found.pressure, "slip_angle": math.degrees(found.direction)}
    for word, wave in zip(("below", "above"), waves):
        numbers |= {f"{word}_head": math.degrees(wave["angles"][0]), f"{word}_tail": math.degrees(wave["angles"][-1]),
                    f"{word}_deflection": math.degrees(wave["turned"])}
    reach = 1.3 * max(abs(y) for y in rays())
    return Solution("two supersonic streams", "planar", profile, lambda time: rays(), numbers,
                    domain=lambda time: (-reach, reach), steady=True)


def _stream(inflow: Inflow) -> Stream:
    par = law_named(inflow.material)
    ahead = state(par, pressure=inflow.pressure, **({"density": inflow.density} if inflow.density else {}))
    return Stream(par, ahead, inflow.mach * float(ahead.sound_speed))


def _wave(found: Meeting, stream: Stream, direction: float, side: int) -> dict:
    """The wave of one stream; angles from the undisturbed stream inwards, `side` +1 above the slip line."""
    theta = stream.deflection(found.pressure)
    wave = {"stream": stream, "direction": direction, "side": side, "turned": side * theta, "pressure": found.pressure}
    if theta >= 0.0:
        beta = stream.shock_angle(found.pressure) if theta > 0.0 else math.asin(1.0 / stream.mach)
        return wave | {"angles": [direction + side * beta]}
    p, turned, mach_angle = stream.fan(found.pressure)
    angles = direction + side * (turned + mach_angle)
    return wave | {"angles": angles.tolist(), "spline": CubicSpline(side * angles[::-side], np.log(p)[::-side]) if side > 0 else
                   CubicSpline(angles, np.log(p))}


def _sample(wave: dict, phi: np.ndarray):
    """(density, pressure, energy, axial and transverse velocity) at angles on one side of the slip line."""
    stream, side, angles = wave["stream"], wave["side"], wave["angles"]
    outside = side * phi > side * angles[0]
    p = np.where(outside, stream.ahead.pressure, wave["pressure"])
    if "spline" in wave:
        inside = ~outside & (side * phi > side * angles[-1])
        p[inside] = np.exp(wave["spline"](phi[inside]))
    rho, e, speed, direction = (np.empty(phi.shape) for _ in range(4))
    for value in np.unique(p):
        here = p == value
        if value == stream.ahead.pressure:
            end, turned = stream.ahead, 0.0
        else:
            end, turned = (stream.behind(value) if value > stream.ahead.pressure else isentrope(stream.par, stream.ahead, pressure=value),
                           stream.deflection(value))
        rho[here], e[here] = float(end.density), float(end.specific_internal_energy)
        speed[here] = stream.speed_behind(value) if value != stream.ahead.pressure else stream.speed
        direction[here] = wave["direction"] + side * turned
    return rho, p, e, speed * np.cos(direction), speed * np.sin(direction)
