r"""A transmitting end: the material beyond it is assumed to continue unchanged, so that waves leave.

In a wave that runs to the right (shock or release, elastic or plastic) stress and velocity are related by $d\sigma = Z\,du$ with the
impedance of the path that the material follows,

$$Z^2 = -\frac{d\sigma}{dv}, \qquad \sigma = p + q - s_1,$$

which is $\rho c$ along an isentrope and $\rho_0 U_s$ along the Rayleigh line of a shock, where the artificial viscosity is part of the
stress. Waves in either direction have the same Z, so an error does not amplify itself. $d\sigma$ and $dv$ are differences from the lagged
means of the last zones. While a shock passes one of them the lag is many transit times of a zone, which gives the chord of the whole shock
before it reaches the end; otherwise it is one transit of the zones nearest to the end, which gives the slope of the curve. The stress
outside then follows the velocity of the end, $T \mathrel{+}= Z\,(u - u_n)$.

Zones have a finite width. In a wave that runs through them unchanged, the stress at the end is the mean of two zones, half a transit time
$\tau = m/Z$ before and after, and $Zu$ is the mean over the time between: $T = Zu + \tfrac{1}{12}Z\tau^2\ddot u$. With
$\tfrac12 m\dot u = \sigma - T$ for the end node the second term is a lead $X = \tfrac16\tau\,d(\sigma - T)/dt$, computed as a high-pass
filter of $\sigma - Zu$.

A wave that spreads from the axis or the origin also decays: for sound far from the centre
$\partial_t p = \rho c\,\partial_t u - \tfrac12(d-1)\,c\,(p-p_0)/r$ (Bayliss and Turkel, Comm. Pure Appl. Math. 33 (1980) 707). The stress
outside the right end follows the same equation. The waves that a spreading wave scatters back, and the stiffness of an elastic body around
a sphere, are not included.

An elastic release, of impedance Z, that leaves behind a plastic shock overtakes it beyond the end. There the part $(Z - Z_H)/(Z + Z_H)$
of it comes back as a compression, with $Z_H = d\sigma/du$ along the Hugoniot. No condition at the end can know that, but the end can count
what is missing. With $U_s = c + su$ and the impedance $Z_s$ of the shock, $Z_H = 2Z_s - \rho_0c$. What leaves a time t after the shock
comes back $2tZ_s/(Z - Z_s)$ later, and the shock loses $2Z_H/(Z + Z_H)$ of it, until nothing of it is left.
"""

import math

import numba as nb
import numpy as np

from hugoniot.core.target import BY_ADDRESS
from hugoniot.laws.eos.contract import sound_speed
from hugoniot.mesh.line import hoops
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import H, Z

NOISE = 1e-6          # strain below which a zone is at rest, and the impedance is that of sound
LONG, SHORT = 8.0, 1.0     # time constants of the lagged means, in transit times of the last zone
FADING = 0.3          # weight of a zone to that of its outer neighbour, along the curve
VISCOUS = 0.01        # part of the rise in stress from which viscosity makes it a shock
SOFTEST, STIFFEST = 0.1, 9.0    # of Z^2, in units of the acoustic one
SIXTH = 9.0           # rate of the high pass in transit times: 6, and half as much again for the stress's lag of half a step
BEHIND = 0.4          # rate, in transit times, at which the velocity gradient beyond the end follows that in the last zone


@nb.njit(**BY_ADDRESS)
def follow(memory, seen, which, first, inward, acoustic, mass, dt):
    """Impedance, lead and passed transit times of the step that begins, from the zones at its start.

    memory          of the end: columns OUTSIDE to MEMORY of `layout`
    seen, which     a table of zones, and its rows of stress, density and viscous pressure along the wave
    first, inward   column of the end's zone in it, and the way to the next one
    acoustic, mass  rho c (kg/m2/s) and mass over area (kg/m2) of the end's zone
    """
    stress, density, viscous = which
    passed = dt * acoustic / mass
    rest = (NOISE / seen[density, first]) ** 2
    far_top, far_bottom, near_top, near_bottom = rest * acoustic * acoustic, rest, rest * acoustic * acoustic, rest
    weight, shocked, swelling = 1.0, False, False
    for k in range(int(memory[L.ZONES])):
        z, at = first + inward * k, L.MEMORY + L.REMEMBERED * k
        sigma, v = seen[stress, z], 1.0 / seen[density, z]
        rise, swell = sigma - memory[at], v - memory[at + 1]
        far_top -= rise * swell
        far_bottom += swell * swell
        shocked = shocked or (seen[viscous, z] > VISCOUS * abs(rise) and abs(swell) > NOISE * v)
        rise, swell = sigma - memory[at + 2], v - memory[at + 3]
        near_top -= weight * rise * swell
        near_bottom += weight * swell * swell
        swelling = swelling or (k == 0 and swell > NOISE * v)
        weight *= FADING
        for j in range(2):
            share = min(passed / (LONG if j == 0 else SHORT), 1.0)
            memory[at + 2 * j] += share * (sigma - memory[at + 2 * j])
            memory[at + 2 * j + 1] += share * (v - memory[at + 2 * j + 1])
    slope = far_top / far_bottom if shocked and not swelling else near_top / near_bottom
    impedance = acoustic * math.sqrt(min(max(slope / (acoustic * acoustic), SOFTEST), STIFFEST))
    memory[L.IMPEDANCE], memory[L.PASSED] = impedance, dt * impedance / mass
    excess = seen[stress, first] - memory[L.OUTSIDE]
    memory[L.LEAD] = (memory[L.LEAD] + excess - memory[L.EXCESS]) / (1.0 + SIXTH * memory[L.PASSED])
    memory[L.EXCESS] = excess
    miss(memory, seen[stress, first], seen[viscous, first], dt)


@nb.njit(**BY_ADDRESS)
def miss(memory, stress, viscous, dt):
    """Add to the echo that real material beyond the end would have sent back before the end of the run (see above)."""
    impedance, change = memory[L.IMPEDANCE], stress - memory[L.BEFORE]
    memory[L.BEFORE] = stress
    memory[L.REMAINING] -= dt
    memory[L.SINCE] += dt
    if viscous > memory[L.LARGEST]:
        memory[L.LARGEST], memory[L.SHOCK], memory[L.SINCE], memory[L.MISSING] = viscous, impedance, 0.0, 0.0
        memory[L.BEHIND] = 2.0 * impedance - memory[L.BULK]
        memory[L.REST] = stress - memory[L.MEMORY]
    elif impedance <= memory[L.BEHIND]:
        memory[L.REST] += max(change, 0.0)       # the rest of the shock
    shock, behind = memory[L.SHOCK], memory[L.BEHIND]
    if memory[L.BULK] > 0.0 and memory[L.REST] > 0.0 and impedance > behind > 0.0:
        away = 2.0 * memory[L.SINCE] * shock / (impedance - shock)
        if away < memory[L.REMAINING]:
            memory[L.MISSING] -= change * (impedance - behind) / (impedance + behind)
            memory[L.REST] += change * 2.0 * behind / (impedance + behind)


@nb.njit(**BY_ADDRESS)
def answer_of(memory, faster, spreading, dt):
    """Add to the stress outside what an end that grew faster by `faster` (m/s, outward) in a step meets; spreading: hoops c/(2 r), 1/s."""
    memory[L.OUTSIDE] += memory[L.IMPEDANCE] * faster - dt * spreading * (memory[L.OUTSIDE] - memory[L.AMBIENT])


@nb.njit(**BY_ADDRESS)
def settle(zones, nodes, control, ends, end, faster, dt, geometry):
    """Stress outside after a step in which the end's velocity grew by `faster`, m/s."""
    node, zone, _ = ends
    memory, spreading = control[end:end + L.END_FLOATS], 0.0
    if hoops(geometry) > 0.0 and end == L.END_RIGHT:
        spreading = 0.5 * hoops(geometry) * memory[L.IMPEDANCE] / (zones[Z.rho, zone] * nodes[H.r, node])
    answer_of(memory, -faster if end == L.END_LEFT else faster, spreading, dt)


@nb.njit(**BY_ADDRESS)
def ghosts(gradient, control, segments):
    """Velocity gradients beyond the ends, which the viscosity's limiter looks at.

    Beyond a wall or a free surface the field is continued from inside, so that it is no extremum; beyond a transmitting end it is what the
    last zone had before.
    """
    for k in range(segments.shape[0]):
        left, right = segments[k, L.SEG_FIRST] + 2 * k, segments[k, L.SEG_LAST] + 2 * k + 1
        kept = 1.0 - min(BEHIND * control[L.END_LEFT + L.PASSED], 1.0) if segments[k, L.SEG_LEFT] == L.TRANSMITTING else 0.0
        gradient[left] = gradient[left + 1] + kept * (gradient[left] - gradient[left + 1])
        kept = 1.0 - min(BEHIND * control[L.END_RIGHT + L.PASSED], 1.0) if segments[k, L.SEG_RIGHT] == L.TRANSMITTING else 0.0
        gradient[right] = gradient[right - 1] + kept * (gradient[right] - gradient[right - 1])


def reach(control, segments, region_ranges) -> None:
    """How many zones from an end on are of its material and body."""
    control[L.END_LEFT + L.ZONES] = min(region_ranges[0][1], segments[0, L.SEG_LAST], L.REACH)
    first, last = region_ranges[-1]
    control[L.END_RIGHT + L.ZONES] = min(last - max(first, segments[-1, L.SEG_FIRST]), L.REACH)


def remember(control, zones) -> None:
    """Let the memory of both ends begin with what their zones hold, and their leads with nothing."""
    count = min(L.REACH, zones.shape[1])
    for end, found in ((L.END_LEFT, zones[:, :count]), (L.END_RIGHT, zones[:, ::-1][:, :count])):
        begin_memory(control[end:end + L.END_FLOATS], found[Z.sigma], found[Z.rho])


def await_echoes(control, zones, problem) -> None:
    """What both ends need to count the echo that is missing: bulk impedances at t = 0, where there is strength, and the time of the run."""
    for end, region, zone in ((L.END_LEFT, problem.regions[0], 0), (L.END_RIGHT, problem.regions[-1], -1)):
        material, memory = problem.materials[region.material], control[end:end + L.END_FLOATS]
        await_echo(memory, material, zones[Z.rho, zone], zones[Z.e, zone], problem.stop_time)


def await_echo(memory, material, rho: float, e: float, stop_time: float) -> None:
    """The same of one end whose zone has this density, kg/m3, and energy, J/kg."""
    memory[L.REMAINING] = stop_time
    if material.strength is not None:
        memory[L.BULK] = rho * sound_speed(rho, e, material.eos)


def missing(control) -> tuple[float, float]:
    """Stress (Pa) of the echo that material beyond the left and the right end would have sent back so far."""
    return float(control[L.END_LEFT + L.MISSING]), float(control[L.END_RIGHT + L.MISSING])


def begin_memory(memory, stress, density) -> None:
    """The memory of an end whose zones, from it inward, hold these."""
    kept = memory[L.MEMORY:].reshape(L.REACH, L.REMEMBERED)
    kept[:len(stress)] = np.stack((stress, 1.0 / density) * 2, axis=1)
    memory[L.LEAD] = 0.0
    memory[L.EXCESS] = stress[0] - memory[L.OUTSIDE]
    memory[L.BEFORE] = stress[0]
