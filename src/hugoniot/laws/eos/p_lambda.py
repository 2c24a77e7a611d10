r"""P-lambda compaction of porous material: a mixture of uncompacted and fully compacted material at one pressure.

Use it for powders and granular materials whose compaction is spread over a wide range of pressures, without a sharp end.

$$\frac1\rho = \lambda\,v_s(p, e) + (1 - \lambda)\,v_i(p), \qquad \lambda = 1 - e^{-(p/Y)^n}, \qquad v_i = \frac{1}{\rho_{00}(1 + p/K)}$$

$\lambda$ is the compacted fraction of the mass, $v_s$ the volume of the solid by the base law, and $v_i$ that of the porous matrix, which
has the initial density $\rho_{00}$ and the bulk modulus $K$. $Y$ is the crush strength and $n$ its sharpness. In tension, uncompacted
material has $p = K(1 - \rho_{00}/\rho)$. The density of the solid is found from this implicit equation by Newton's method in a bracket.
If the material is so hot that its solid alone would have a specific volume above $1/\rho$, the equation can have two roots; the one with
more compaction is used.

Compaction is irreversible. Below the largest pressure reached, $\lambda$ keeps its value, and the mixture unloads and reloads
elastically. A run stores $\lambda$ of every zone. The two parts exchange no energy in this model: the temperature is that of the solid at
the energy of the mixture. There is no entropy, because compaction dissipates energy along paths that density and energy do not determine.

Source: Grady, Winfree, Kerley, Wilson and Kuhns, J. Phys. IV France 10, Pr9-15 (2000); Grady and Winfree (2001).
"""

from typing import Any, NamedTuple

from hugoniot.core.ops import NO_LIMIT, fmax, fmin, vexp, vlog, vpow
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.contract import density_limits as base_density_limits
from hugoniot.laws.eos.contract import pressure as base_pressure
from hugoniot.laws.eos.contract import pressure_derivatives as base_derivatives
from hugoniot.laws.eos.contract import reference_state as base_reference_state
from hugoniot.laws.eos.contract import specific_heat as base_specific_heat
from hugoniot.laws.eos.contract import temperature as base_temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen


class PLambda(NamedTuple):
    """compaction is the share lambda that the history has left (0 in a deck)."""

    base: Any
    rho_porous: float
    matrix_modulus: float
    crush_strength: float
    exponent: float = 1.0
    compaction: float = 0.0


def _mixture(p, solid, par):
    """(volume, its slope by p at fixed rho_s, lambda)."""
    if p <= 0.0:
        return (1.0 - p / par.matrix_modulus) / par.rho_porous, -1.0 / (par.matrix_modulus * par.rho_porous), 0.0
    z = vpow(p / par.crush_strength, par.exponent)
    left = vexp(-z)
    soft = 1.0 + p / par.matrix_modulus
    v_i = 1.0 / (par.rho_porous * soft)
    v_s = 1.0 / solid
    slope = left * (par.exponent * z / p * (v_s - v_i) - v_i / (par.matrix_modulus * soft))
    return v_s + left * (v_i - v_s), slope, 1.0 - left


def _residual(solid, rho, e, par):
    """(mixture volume - 1/rho, its slope by rho_s)."""
    p = base_pressure(solid, e, par.base)
    v, slope, share = _mixture(p, solid, par)
    return v - 1.0 / rho, slope * base_derivatives(solid, e, par.base)[0] - share / (solid * solid)


def _next(solid, rho, e, par):
    """(mixture volume - 1/rho, Newton's next density of the solid) from a trial.

    At the root exp(-z) = w = (v - v_s)/(v_i - v_s) with z = (p/Y)^n. While crushing goes on, Newton's method works on z + ln w, nearly
    straight in the density; on the volume itself, which bends like exp(-z), once nothing is left to crush.
    """
    p = base_pressure(solid, e, par.base)
    p_rho = base_derivatives(solid, e, par.base)[0]
    v, slope, share = _mixture(p, solid, par)
    f = v - 1.0 / rho
    if p <= 0.0:
        # aim at a pressure no higher than without crushing
        return f, solid + (fmin(0.5 * par.crush_strength, par.matrix_modulus * (1.0 - par.rho_porous / rho)) - p) / p_rho
    soft = 1.0 + p / par.matrix_modulus
    v_i, v_s = 1.0 / (par.rho_porous * soft), 1.0 / solid
    room, width = 1.0 / rho - v_s, v_i - v_s
    # compiled with fast arithmetic, 1/rho - 1/rho need not vanish, and the logarithm of such a rest stops Newton's method on the spot
    if room <= 1e-6 * width or width <= room or (share > 0.99 and room < 0.05 * width):
        return f, solid - f / (slope * p_rho - share * v_s * v_s)
    z = vpow(p / par.crush_strength, par.exponent)
    bend = par.exponent * z / p * p_rho + v_s * v_s / room - (v_s * v_s - v_i * p_rho / (par.matrix_modulus * soft)) / width
    return f, solid - (z + vlog(room / width)) / bend


def _solid_density(rho, e, par):
    """Density of the compacted part (rho > rho_porous)."""
    p = base_pressure(rho, e, par.base)
    if p > 0.0 and vpow(p / par.crush_strength, par.exponent) > 45.0:  # exp(-45) = 3e-20: nothing is left to crush
        return rho
    solid, low, high, steps = rho, 0.5 * rho, 0.0, 0
    while steps < 200:
        f, new = _next(solid, rho, e, par)
        if f > 0.0:
            low = solid
        else:
            high = solid
        step = new - solid if new > solid else solid - new
        small = step < 1e-8 * solid
        if not small:
            if high == 0.0:
                new = new if low < new < 1.2 * solid else 1.1 * solid
            elif not low < new < high:
                new = 0.5 * (low + high)
        solid = new
        steps = 200 if small or high - low < 1e-15 * high and high > 0.0 else steps + 1
    # a free Newton step gives a dual number its exact slopes
    f, slope = _residual(solid, rho, e, par)
    return solid - f / slope


def elastic_limit(par):
    """Pressure from which the share that is left is compacted further, Pa."""
    if par.compaction >= 1.0 or par.crush_strength >= NO_LIMIT:
        return NO_LIMIT
    closed = -vlog(1.0 - par.compaction) if par.compaction > 0.0 else 0.0
    return par.crush_strength * vpow(closed, 1.0 / par.exponent) if closed > 0.0 else 0.0


def _matrix(p, par):
    """(volume of the uncompacted matrix, its slope by p)."""
    if p <= 0.0:
        return (1.0 - p / par.matrix_modulus) / par.rho_porous, -1.0 / (par.matrix_modulus * par.rho_porous)
    soft = 1.0 + p / par.matrix_modulus
    return 1.0 / (par.rho_porous * soft), -1.0 / (par.rho_porous * par.matrix_modulus * soft * soft)


def _elastic_density(rho, e, par):
    """Density of the compacted part while the compaction stays; its Newton steps go uphill or downhill only, hence no bracket."""
    solid, share, steps = rho, par.compaction, 0
    while steps < 50:
        p_rho = base_derivatives(solid, e, par.base)[0]
        v_i, slope = _matrix(base_pressure(solid, e, par.base), par)
        f = share / solid + (1.0 - share) * v_i - 1.0 / rho
        step = f / (share / (solid * solid) - (1.0 - share) * slope * p_rho)
        step = fmin(fmax(step, -0.2 * solid), 0.2 * solid)
        steps = 50 if fmax(step, -step) < 1e-14 * solid else steps + 1
        solid += step
    return solid


def _elastic(rho, e, par):
    """(pressure, slopes by density and by energy) while the compaction stays."""
    share = par.compaction
    if share <= 0.0:
        ratio = par.rho_porous / rho
        if ratio >= 1.0:
            return par.matrix_modulus * (1.0 - ratio), par.matrix_modulus * ratio / rho, 0.0
        return par.matrix_modulus * (1.0 / ratio - 1.0), par.matrix_modulus / par.rho_porous, 0.0
    solid = _elastic_density(rho, e, par)
    p = base_pressure(solid, e, par.base)
    p_rho, p_e = base_derivatives(solid, e, par.base)
    slope = (1.0 - share) * _matrix(p, par)[1]
    bend = share / (solid * solid) - slope * p_rho
    return p, p_rho / (rho * rho * bend), p_e * (share / (solid * solid)) / bend


def _holds(p, rho, par):
    """Whether a state whose elastic pressure is p crushes nothing."""
    return p <= elastic_limit(par) if par.compaction > 0.0 else rho <= par.rho_porous or par.crush_strength >= NO_LIMIT


def pressure(rho, e, par):
    p, _, _ = _elastic(rho, e, par)
    return p if _holds(p, rho, par) else base_pressure(_solid_density(rho, e, par), e, par.base)


def pressure_and_derivatives(rho, e, par):
    """One search serves the pressure and its slopes."""
    p, p_rho, p_e = _elastic(rho, e, par)
    if _holds(p, rho, par):
        return p, p_rho, p_e
    solid = _solid_density(rho, e, par)
    p = base_pressure(solid, e, par.base)
    p_rho, p_e = base_derivatives(solid, e, par.base)
    _, slope, share = _mixture(p, solid, par)
    bend = slope * p_rho - share / (solid * solid)
    return p, -p_rho / (rho * rho * bend), -p_e * share / (solid * solid * bend)


def pressure_derivatives(rho, e, par):
    _, p_rho, p_e = pressure_and_derivatives(rho, e, par)
    return p_rho, p_e


def _inner_density(rho, e, par):
    p, _, _ = _elastic(rho, e, par)
    if not _holds(p, rho, par):
        return _solid_density(rho, e, par)
    return _elastic_density(rho, e, par) if par.compaction > 0.0 else base_reference_state(par.base)[0]


def temperature(rho, e, par):
    return base_temperature(_inner_density(rho, e, par), e, par.base)


def specific_heat(rho, e, par):
    return base_specific_heat(_inner_density(rho, e, par), e, par.base)


def remembered(compaction, par):
    return PLambda(par.base, par.rho_porous, par.matrix_modulus, par.crush_strength, par.exponent, compaction)


def unloading(par):
    return PLambda(par.base, par.rho_porous, par.matrix_modulus, NO_LIMIT, par.exponent, par.compaction)


def compacted(compaction, rho, e, p, par):
    share = p / par.crush_strength
    return fmax(compaction, 1.0 - vexp(-vpow(share, par.exponent))) if share > 0.0 else compaction


def reference_state(par):
    rho, e = base_reference_state(par.base)
    return 1.0 / (par.compaction / rho + (1.0 - par.compaction) / par.rho_porous), e


def density_limits(par):
    return 0.0, base_density_limits(par.base)[1]


def build(base, rho_porous, matrix_modulus, crush_strength, exponent=1.0):
    """Parameters from a deck."""
    solid = base_reference_state(base)[0]
    if not 0.0 < rho_porous < solid:
        raise OutOfRange(f"p_lambda: rho_porous must lie between 0 and the solid's {solid:.6g} kg/m3, got {rho_porous:g} kg/m3")
    if not (matrix_modulus > 0.0 and crush_strength > 0.0 and exponent >= 1.0):
        raise OutOfRange(f"p_lambda: needs matrix_modulus > 0, crush_strength > 0 and exponent >= 1, got matrix_modulus = "
                         f"{matrix_modulus:g} Pa, crush_strength = {crush_strength:g} Pa, exponent = {exponent:g}")
    return PLambda(base, rho_porous, matrix_modulus, crush_strength, exponent)


EOS.add(
    "p_lambda", PLambda,
    functions=[pressure, pressure_derivatives, pressure_and_derivatives, temperature, specific_heat, reference_state, density_limits,
               remembered, unloading, compacted, elastic_limit],
    example=PLambda(MieGruneisen(2700.0, 5350.0, 1.34, 2.0, 863.0), 2100.0, 25e9, 0.4e9, 1.2),
    build=build,
    units={"base": "law", "rho_porous": "kg/m^3", "matrix_modulus": "Pa", "crush_strength": "Pa", "exponent": "1",
           "compaction": "1"},
    meaning={"base": "equation of state of the solid", "rho_porous": "initial density of the porous material",
             "matrix_modulus": "bulk modulus of the uncompacted material",
             "crush_strength": "crush strength, the pressure scale of the compaction",
             "exponent": "sharpness of the compaction, 1 or more", "compaction": "fraction of the mass already compacted, set by a run"},
    defaults={"exponent": 1.0},
    box={"rho": (2000.0, 4500.0), "e": (0.0, 5e6)},
    flags=("remembers",),
    above={"crush_strength": 0.0, "exponent": 0.0},
    least={"compaction": 0.0},
    references=("Grady, Winfree, Kerley, Wilson and Kuhns, J. Phys. IV France 10, Pr9-15 (2000)",),
)
