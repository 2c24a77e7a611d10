r"""P-alpha compaction of porous material: the distension alpha falls with pressure until the pores are closed.

Use it for porous metals, rocks and similar solids with a measured crush curve. The distension $\alpha$ is the density of the solid
divided by that of the porous material. The pressure is that of the solid by the base law, averaged over the volume:

$$p = \frac{1}{\alpha}\,p_{\text{solid}}(\alpha\rho, e), \qquad
  \alpha(p) = 1 + (\alpha_0 - 1)\left(\frac{p_s - p}{p_s - p_e}\right)^2 \quad (p_e < p < p_s)$$

$\alpha = 1$ above the compaction pressure $p_s$, and $\alpha = \alpha_0$ below the elastic limit $p_e$ and in tension. With the factor
$1/\alpha$ of Carroll and Holt the work on the porous material at constant $\alpha$ is the work on its solid. The density of the solid is
found from this implicit equation by Newton's method in a bracket.

Crushing is irreversible. Below the largest pressure reached, $\alpha$ keeps its value, and the material unloads and reloads elastically
with the sound speed of its solid, to the density $\rho_s/\alpha$ at zero pressure ($\rho_s$: reference density of the solid). A run
stores the compaction $k = (\alpha_0 - \alpha)/(\alpha_0 - 1)$ of every zone. Crushed material obeys the same law with $\alpha_0 - 1$
multiplied by $1 - k$ and $p_e$ raised to $p_s - (p_s - p_e)\sqrt{1 - k}$.

The temperature is that of the solid. There is no entropy: with $v = \alpha v_{\text{solid}}$ the solid gains the heat of crushing,
$T\,ds = -p_{\text{solid}}\,v_{\text{solid}}\,d\alpha/\alpha$, along $de + p\,dv = 0$, so entropy is not a function of density and energy.

Source: Herrmann, J. Appl. Phys. 40, 2490 (1969); Carroll and Holt, J. Appl. Phys. 43, 759 (1972).
"""

from typing import Any, NamedTuple

from hugoniot.core.ops import NO_LIMIT, fmax, vsqrt
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.contract import density_limits as base_density_limits
from hugoniot.laws.eos.contract import pressure as base_pressure
from hugoniot.laws.eos.contract import pressure_derivatives as base_derivatives
from hugoniot.laws.eos.contract import reference_state as base_reference_state
from hugoniot.laws.eos.contract import specific_heat as base_specific_heat
from hugoniot.laws.eos.contract import temperature as base_temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen


class PAlpha(NamedTuple):
    base: Any
    alpha0: float
    elastic_pressure: float
    compaction_pressure: float


def _alpha(p, par):
    """(alpha, dalpha/dp) at pressure p."""
    if p >= par.compaction_pressure:
        return 1.0, 0.0
    if p <= par.elastic_pressure:
        return par.alpha0, 0.0
    width = par.compaction_pressure - par.elastic_pressure
    y = (par.compaction_pressure - p) / width
    return 1.0 + (par.alpha0 - 1.0) * y * y, -2.0 * (par.alpha0 - 1.0) * y / width


def _residual(solid, rho, e, par):
    """(rho_s - rho alpha(p), its slope by rho_s)."""
    p = base_pressure(solid, e, par.base)
    alpha, slope = _alpha(p * rho / solid, par)
    p_solid = (base_derivatives(solid, e, par.base)[0] - p / solid) * rho / solid
    return solid - rho * alpha, 1.0 - rho * slope * p_solid


def _solid_density(rho, e, par):
    """alpha rho: the density of the solid inside the pores."""
    high = par.alpha0 * rho
    if base_pressure(high, e, par.base) / par.alpha0 <= par.elastic_pressure:
        return high
    if base_pressure(rho, e, par.base) >= par.compaction_pressure:
        return rho
    low, solid, steps = rho, high, 0
    last = high - low
    while steps < 100:
        f, slope = _residual(solid, rho, e, par)
        if f > 0.0:
            high = solid
        else:
            low = solid
        new = solid - f / slope
        step = new - solid if new > solid else solid - new
        small = step < 1e-8 * solid  # then the new density has 14 digits
        # a Newton step must halve the last one, else bisect: no cycles
        good = step < 0.5 * last
        last = step if good else 0.5 * (high - low)
        solid = new if good or small else 0.5 * (low + high)
        steps = 100 if small or high - low < 1e-15 * high else steps + 1
    # a free Newton step gives a dual number its exact slopes
    f, slope = _residual(solid, rho, e, par)
    return solid - f / slope


def pressure(rho, e, par):
    solid = _solid_density(rho, e, par)
    return base_pressure(solid, e, par.base) * rho / solid


def pressure_and_derivatives(rho, e, par):
    """One search serves the pressure and its slopes."""
    solid = _solid_density(rho, e, par)
    p = base_pressure(solid, e, par.base)
    p_rho, p_e = base_derivatives(solid, e, par.base)
    alpha, slope = _alpha(p * rho / solid, par)
    ratio = rho / solid
    p_solid = (p_rho - p / solid) * ratio
    bend = 1.0 - rho * slope * p_solid
    solid_rho = (alpha + rho * slope * p / solid) / bend
    solid_e = rho * slope * p_e * ratio / bend
    return p * ratio, p / solid + p_solid * solid_rho, p_e * ratio + p_solid * solid_e


def pressure_derivatives(rho, e, par):
    _, p_rho, p_e = pressure_and_derivatives(rho, e, par)
    return p_rho, p_e


def temperature(rho, e, par):
    return base_temperature(_solid_density(rho, e, par), e, par.base)


def specific_heat(rho, e, par):
    return base_specific_heat(_solid_density(rho, e, par), e, par.base)


def remembered(compaction, par):
    left = 1.0 - compaction
    limit = par.compaction_pressure - (par.compaction_pressure - par.elastic_pressure) * vsqrt(left)
    return PAlpha(par.base, 1.0 + (par.alpha0 - 1.0) * left, limit, par.compaction_pressure)


def unloading(par):
    return PAlpha(par.base, par.alpha0, NO_LIMIT, NO_LIMIT)


def compacted(compaction, rho, e, p, par):
    if p <= par.elastic_pressure:
        return compaction
    if p >= par.compaction_pressure:
        return 1.0
    y = (par.compaction_pressure - p) / (par.compaction_pressure - par.elastic_pressure)
    return fmax(compaction, 1.0 - y * y)


def elastic_limit(par):
    return par.elastic_pressure if par.alpha0 > 1.0 else NO_LIMIT


def reference_state(par):
    rho, e = base_reference_state(par.base)
    return rho / par.alpha0, e


def density_limits(par):
    low, high = base_density_limits(par.base)
    return low / par.alpha0, high


def build(base, alpha0, elastic_pressure, compaction_pressure):
    """Parameters from a deck."""
    if not alpha0 > 1.0:
        raise OutOfRange(f"p_alpha: alpha0, the density of the solid divided by that of the porous material, must exceed 1, got {alpha0}")
    if not 0.0 <= elastic_pressure < compaction_pressure:
        raise OutOfRange(f"p_alpha: needs 0 <= elastic_pressure < compaction_pressure, got {elastic_pressure:g} and "
                         f"{compaction_pressure:g} Pa")
    return PAlpha(base, alpha0, elastic_pressure, compaction_pressure)


EOS.add(
    "p_alpha", PAlpha,
    functions=[pressure, pressure_derivatives, pressure_and_derivatives, temperature, specific_heat, reference_state, density_limits,
               remembered, unloading, compacted, elastic_limit],
    example=PAlpha(MieGruneisen(2700.0, 5350.0, 1.34, 2.0, 863.0), 1.275, 0.08e9, 0.7e9),
    build=build,
    units={"base": "law", "alpha0": "1", "elastic_pressure": "Pa", "compaction_pressure": "Pa"},
    meaning={"base": "equation of state of the solid",
             "alpha0": "initial distension: density of the solid divided by that of the porous material",
             "elastic_pressure": "pressure at which the pores begin to close",
             "compaction_pressure": "pressure at which the pores have closed"},
    box={"rho": (2000.0, 4500.0), "e": (0.0, 5e6)},
    flags=("remembers",),
    references=("Herrmann, J. Appl. Phys. 40, 2490 (1969)", "Carroll and Holt, J. Appl. Phys. 43, 759 (1972)"),
)
