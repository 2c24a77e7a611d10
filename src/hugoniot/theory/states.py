r"""States of a material, the input and output of the tools: arrays or single numbers under the names of the fields.

The sound speed $c$, the Grüneisen parameter $\Gamma$, the isentropic bulk modulus $K_S$ and the adiabatic exponent $\gamma$ follow from the
equation of state $p(\rho, e)$ and its two derivatives, with the specific volume $v = 1/\rho$ and the entropy $s$:

$$c^2 = \left.\frac{\partial p}{\partial\rho}\right|_e + \frac{p}{\rho^2}\left.\frac{\partial p}{\partial e}\right|_\rho, \qquad
  \Gamma = \frac1\rho\left.\frac{\partial p}{\partial e}\right|_\rho, \qquad K_S = \rho c^2, \qquad
  \gamma = -\left.\frac{\partial\ln p}{\partial\ln v}\right|_s = \frac{\rho c^2}{p}$$

Temperature and entropy are available if the equation of state has them.
"""

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.materials import burning

UNITS = {"density": "kg/m^3", "pressure": "Pa", "specific_internal_energy": "J/kg", "particle_velocity": "m/s", "shock_velocity": "m/s",
         "temperature": "K", "sound_speed": "m/s", "entropy": "J/kg/K", "gruneisen": "1", "adiabatic_exponent": "1",
         "detonation_velocity": "m/s", "reaction": "1", "time": "s", "position": "m", "reaction_rate": "1/s", "thermicity": "1/s",
         "burn_fraction": "1", "volume_fraction": "1", "specific_heat": "J/kg/K", "reactant_density": "kg/m^3", "product_density": "kg/m^3",
         "reactant_energy": "J/kg", "product_energy": "J/kg", "pressure_by_volume": "Pa kg/m^3", "pressure_by_energy": "Pa kg/J",
         "pressure_by_burn_fraction": "Pa", "compression": "1", "fitted_shock_velocity": "m/s", "deviation": "m/s", "burn_time": "s",
         **dict.fromkeys(("reactant_volume", "product_volume"), "m^3/kg"),
         **dict.fromkeys(("fitted_pressure", "truncated_pressure", "adjusted_pressure"), "Pa"), "adjusted_gruneisen": "1",
         **dict.fromkeys(("principal_pressure", "principal_series", "second_pressure", "second_series", "difference"), "Pa"),
         **dict.fromkeys(("leading_difference", "stress", "deviator_radial"), "Pa"),
         **dict.fromkeys(("x", "y", "z", "radius", "axial_position"), "m"),
         **dict.fromkeys(("radial_velocity", "axial_velocity", "transverse_velocity"), "m/s"),
         **dict.fromkeys(("displacement", "lag", "front_position"), "m"), "hoop_stress": "Pa", "slope_angle": "degree"}


def law_of(material) -> Any:
    """The parameters of a material's equation of state, as a tuple; such a tuple is returned unchanged. TypeError for anything else."""
    par = getattr(material, "eos", material)
    if not isinstance(par, tuple):
        raise TypeError(f"{par!r} is neither a material nor the parameters of a law; hugoniot.materials.library.find(name) finds materials")
    return par


def rest_of(material) -> tuple[float, float]:
    """(density kg/m3, energy J/kg) of the reference state; of an explosive that states its chemical energy, with this instead of its law's.

    As in a run, the `detonation_energy` of a `Material` is what burning releases.
    """
    rho0, e0 = (float(v) for v in contract.reference_state(law_of(material)))
    stated = getattr(material, "detonation_energy", None)
    if stated is None:
        return rho0, e0
    return (rho0, float(stated)) if material.burn is None else burning.start_state(material)


def has(par, function: str) -> bool:
    """Whether an equation of state, and every one inside it, has an optional function: temperature, entropy, energy or specific_heat."""
    return contract.gives(par, function)


def evaluate(function, rho, e, par):
    """A scalar function (rho, e, par) of an equation of state, evaluated for numbers or arrays."""
    if np.ndim(rho) == 0 and np.ndim(e) == 0:
        return float(function(float(rho), float(e), par))
    rho, e = np.broadcast_arrays(np.asarray(rho, float), np.asarray(e, float))
    flat = [float(function(r, k, par)) for r, k in zip(rho.ravel().tolist(), e.ravel().tolist())]
    return np.array(flat).reshape(rho.shape)


@dataclass(frozen=True)
class States:
    """States of one material, single or along a curve: every field is a number, or an array of one shape.

    density                    kg/m3
    pressure                   Pa
    specific_internal_energy   J/kg
    particle_velocity          m/s
    shock_velocity             m/s; None where no shock produced the state
    temperature                K; None if the equation of state has no temperature
    entropy                    J/(kg K), up to a constant; None if the equation of state has no entropy in closed form
    sound_speed                bulk sound speed, m/s; not a number (NaN) where the state is unstable
    gruneisen                  Grüneisen parameter
    adiabatic_exponent         rho c^2/p
    par                        parameters of the equation of state

    The properties from temperature to adiabatic_exponent are computed when they are used.
    """

    par: Any
    density: Any
    pressure: Any
    specific_internal_energy: Any
    particle_velocity: Any
    shock_velocity: Any = None
    extra: dict = field(default_factory=dict)

    def _derived(self, name):
        if not has(self.par, name):
            return None
        return evaluate(getattr(contract, name), self.density, self.specific_internal_energy, self.par)

    @property
    def temperature(self):
        """Temperature, K; None if the law gives no temperature."""
        return self._derived("temperature")

    @property
    def entropy(self):
        """Specific entropy up to an additive constant, J/(kg K); None if the law has no entropy in closed form."""
        return self._derived("entropy")

    @property
    def sound_speed(self):
        """Bulk sound speed, m/s; NaN where the state is unstable (c^2 < 0)."""
        def speed(rho, e, par):
            square = contract.sound_speed_squared(rho, e, par)
            return math.sqrt(square) if square >= 0.0 else math.nan
        return evaluate(speed, self.density, self.specific_internal_energy, self.par)

    @property
    def gruneisen(self):
        """Grüneisen parameter."""
        return evaluate(contract.gruneisen, self.density, self.specific_internal_energy, self.par)

    @property
    def adiabatic_exponent(self) -> Any:
        """Adiabatic exponent rho c^2 / p."""
        square = np.square(self.sound_speed)
        with np.errstate(divide="ignore", invalid="ignore"):
            value = np.asarray(self.density) * square / np.asarray(self.pressure)
        return value if value.ndim else float(value)

    def table(self, *more: str) -> dict:
        """The main quantities in SI, {name: number or array}, as the command line writes them to CSV and JSON; `more` names others."""
        names = ["pressure", "density", "particle_velocity", "shock_velocity", "specific_internal_energy", "temperature", "sound_speed"]
        found = {name: getattr(self, name) for name in [*names, *more]}
        return {**found, **self.extra}

    def __len__(self) -> int:
        return int(np.size(self.density))

    def __getitem__(self, index) -> "States":
        def part(value):
            return None if value is None else (value[index] if np.ndim(value[index]) else float(value[index]))
        return States(self.par, part(self.density), part(self.pressure), part(self.specific_internal_energy),
                      part(self.particle_velocity), part(self.shock_velocity), {k: part(v) for k, v in self.extra.items()})


def density_range(par) -> tuple[float, float]:
    """Lowest and highest density for which an equation of state is defined, kg/m3; zero is replaced by the smallest positive number."""
    low, high = contract.density_limits(par)
    return max(float(low), 1e-300), float(high)


def density_at(par, pressure: float, energy: float, near: float | None = None) -> float:
    """Density, kg/m3, at a pressure (Pa) and a specific internal energy (J/kg).

    near   density at which the search begins, kg/m3; default: the reference density
    """
    low, high = density_range(par)
    rho = float(contract.reference_state(par)[0]) if near is None else near
    for _ in range(200):
        miss = pressure - contract.pressure(rho, energy, par)
        slope = contract.pressure_derivatives(rho, energy, par)[0]
        if not (slope > 0.0 and math.isfinite(miss)):
            break
        step = miss / slope
        new = rho + step
        if not low < new < high:
            new = 0.5 * (rho + (low if new <= low else high)) if math.isfinite(high) else 0.5 * (rho + low)
        if abs(new - rho) <= 4e-16 * rho:
            return float(new)
        rho = new
    if math.isfinite(miss) and abs(miss) <= 1e-12 * max(abs(slope) * rho, abs(pressure)):
        return float(rho)
    raise OutOfRange(f"law '{EOS.of(par).name}' has no stable state at {pressure:.6g} Pa and {energy:.6g} J/kg with a density "
                     f"between {low:.6g} and {high:.6g} kg/m3")
