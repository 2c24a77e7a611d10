r"""How much of a strong wave a transmitting end sends back.

The end answers the material with its own acoustic impedance, $\sigma = Z u$ with $Z = \rho c$ of the zone there. A shock
$(\sigma_1, u_1)$ lies below that line, so that a second shock runs back into the material until

$$\sigma_2 = \rho_2 c_2 u_2, \qquad \sigma = p + \tfrac23 Y,$$

with the state 2 on the Hugoniot of the second shock. The echo $\sigma_2 - \sigma_1$ is nothing for sound and for elastic waves; it grows
with the strength of the shock, and is larger where the shock was plastic, since c is the elastic speed.
"""

import math
from typing import NamedTuple

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.laws.eos.contract import has_temperature, reference_state, sound_speed_squared
from hugoniot.laws.eos.contract import pressure as pressure_of
from hugoniot.laws.eos.contract import temperature as temperature_of
from hugoniot.laws.strength.contract import flow_stress, shear_modulus
from hugoniot.materials.material import Material
from hugoniot.problem.model import Problem
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.impedance import match

LEAST = 0.01       # echo over incident wave from which a user is warned
OVERSHOOT = 5      # zones
SMALLEST = 1e-4    # of rho c^2: waves below are sound


class Echo(NamedTuple):
    """Stress of the incident wave and what comes back, Pa; shock velocity (m/s) of the incident wave."""

    incident: float
    reflected: float
    shock_velocity: float

    @property
    def part(self) -> float:
        return self.reflected / self.incident


def echo(material: Material, pressure: float) -> Echo:
    """What a transmitting end reflects of a shock from rest to `pressure` (Pa, of the equation of state)."""
    first = shock(material.eos, pressure=pressure)
    speed, still = float(first.particle_velocity), _pressure_at_rest(material)
    ahead = Initial(float(first.density), pressure, float(first.specific_internal_energy))

    def state(p):
        """(stress over rest, what the end would answer) behind a second shock to p."""
        second = shock(material.eos, ahead, pressure=p)
        left = speed - float(second.particle_velocity)
        impedance, yielding = _impedance(material, float(second.density), float(second.specific_internal_energy), p)
        return p + yielding - still, impedance * left

    incident, answer = state(pressure)
    low, high = pressure, pressure + max(answer - incident, 0.0)
    for _ in range(50):
        middle = 0.5 * (low + high)
        stress, answer = state(middle)
        low, high = (middle, high) if answer > stress else (low, middle)
    return Echo(incident, low - pressure, float(first.shock_velocity))


def _impedance(material: Material, rho: float, e: float, pressure: float) -> tuple[float, float]:
    """(rho c with the elastic speed kg/m2/s, two thirds of the flow stress Pa) of a state."""
    modulus, stress = rho * sound_speed_squared(rho, e, material.eos), 0.0
    if material.strength is not None:
        warm = float(temperature_of(rho, e, material.eos)) if has_temperature(material.eos) else 298.15
        stress = 2.0 / 3.0 * flow_stress(rho, pressure, warm, 0.0, 1.0, material.strength)
        modulus += 4.0 / 3.0 * shear_modulus(rho, pressure, warm, modulus, material.strength)
    return math.sqrt(rho * modulus), stress


def _pressure_at_rest(material: Material) -> float:
    return float(pressure_of(*reference_state(material.eos), material.eos))


def echo_at_end(material: Material, peak: float) -> Echo:
    """As `echo`, from the peak stress (Pa) that the zones near the end met, echo included."""
    low, high = 0.0, peak
    found = echo(material, high)
    for _ in range(40):     # incident + reflected grows with the incident wave
        middle = 0.5 * (low + high)
        found = echo(material, middle)
        low, high = (middle, high) if found.incident + found.reflected < peak else (low, middle)
    return found


def expected(problem: Problem) -> list[str]:
    """Warnings of a plane problem's transmitting ends, from the first shock that reaches them by impedance matching."""
    found = []
    for side in ("left", "right"):
        if getattr(problem, side).kind == "transmitting" and problem.geometry == "planar":
            try:
                coming = _first_shock(problem, side)
            except (HugoniotError, ArithmeticError, ValueError):
                continue
            if coming is not None and coming.part > LEAST:
                found.append(_words(side, coming, "the first shock,"))
    return found


def _words(side: str, wave: Echo, what: str) -> str:
    return (f"the transmitting {side} end reflects strong waves in part: of {what} {wave.incident * 1e-9:.3g} GPa, about "
            f"{wave.reflected * 1e-9:.2g} GPa ({wave.part:.0%}) comes back; put the end so far away that its echo reaches no gauge before "
            "the run ends")


def _first_shock(problem: Problem, side: str) -> Echo | None:
    """The echo of the first shock of an impact that travels to an end in time; None where there is no impact, or what burns."""
    regions = problem.regions if side == "right" else problem.regions[::-1]
    sign = 1.0 if side == "right" else -1.0
    speeds = [sign * float(np.mean(region.velocity)) for region in regions]
    start = next((k for k in range(len(regions) - 2, -1, -1) if speeds[k] > speeds[k + 1]), None)
    if start is None or any(problem.materials[region.material].burn is not None for region in regions):
        return None
    layers = [problem.materials[region.material] for region in regions[start:]]
    met = match([layer.eos for layer in layers], speeds[start] - speeds[start + 1])
    behind = [m.right for m in met]
    if any(state.shock_velocity is None for state in behind):
        return None
    time = sum((r.end - r.start) / float(s.shock_velocity) for r, s in zip(regions[start + 1:], behind))
    return echo(layers[-1], float(behind[-1].pressure)) if time < problem.stop_time else None


def measured(problem: Problem, peak_stress: np.ndarray) -> list[str]:
    """Warnings of a finished run: the echo in the largest stress (Pa, (nzone,)) near a transmitting end."""
    found = []
    for side, region in (("left", problem.regions[0]), ("right", problem.regions[-1])):
        # a few zones inside, where the shock does not overshoot as it does at its end
        near = (peak_stress if side == "left" else peak_stress[::-1])[: region.zones]
        peak = float(np.median(near[OVERSHOOT:4 * OVERSHOOT] if len(near) > OVERSHOOT else near))
        material, started = problem.materials[region.material], (region.density, region.pressure)
        if getattr(problem, side).kind != "transmitting" or material.burn is not None or started != (None, None):
            continue
        rho, e = reference_state(material.eos)
        peak -= _pressure_at_rest(material)
        if not peak > SMALLEST * rho * sound_speed_squared(rho, e, material.eos):
            continue
        try:
            wave = echo_at_end(material, peak)
        except (HugoniotError, ArithmeticError, ValueError):
            continue
        if wave.part > LEAST:
            found.append(_words(side, wave, "the largest wave,"))
    return found
