"""Closure of inert material: the equation of state applied to a zone whose density is known.

    pressure     p at a given energy (the middle of a step)
    state        p and c^2 at a given energy, pores compacted (its end)
    settle       energy and pressure together, e + (p + p_old) dv/2 = e_old + given (a leapfrog: Wilkins B.2 item 8)
    stiffness    c^2 alone, where it is needed before the state is known
    temperature  T, for strength laws that need it
    rest         density from which a fracture law measures volume strain

Passes take the specific volume v of the solid: laws that use only rho0/rho, such as those on a Hugoniot, then need no division.
The sound speed is elastic, on the unloading branch of a law with memory: a release outruns the crushing wave.
"""

from hugoniot.core.ops import late_over
from hugoniot.core.passes import flag_of, law_of, rows_apart, zone_pass
from hugoniot.laws.eos.contract import EOS, compacted, pressure, pressure_derivatives, reference_state, remembered, unloading
from hugoniot.laws.eos.contract import temperature as eos_temperature

NEWTON_STEPS = 4      # of `settle` for laws that are not linear in the energy
remembers = flag_of(EOS, "remembers")                      # whether an equation of state has a history variable
linear_in_energy = flag_of(EOS, "linear_in_energy")        # whether its pressure is linear in the energy: `settle` is one division then


@zone_pass("v e compaction p")
def pressure_pass(count, z, dt, numbers, law):
    """v (m3/kg), e (J/kg), compaction -> p (Pa)."""
    rows_apart()
    eos = law_of(law, numbers)
    for j in range(count):
        z.p[j] = pressure(1.0 / z.v[j], z.e[j], remembered(z.compaction[j], eos))


@zone_pass("v e compaction p c2")
def state_pass(count, z, dt, numbers, law):
    """v, e, compaction (advanced) -> p, c2 (m2/s2)."""
    rows_apart()
    eos = law_of(law, numbers)
    for j in range(count):
        v, e, compaction = z.v[j], z.e[j], z.compaction[j]
        rho = 1.0 / v
        p = pressure(rho, e, remembered(compaction, eos))
        if remembers(eos):
            compaction = compacted(compaction, rho, e, p, eos)
            z.compaction[j] = compaction
        p_rho, p_e = pressure_derivatives(rho, e, unloading(remembered(compaction, eos)))
        z.p[j] = p
        z.c2[j] = p_rho + p * p_e * (v * v)


@zone_pass("v dv given e p compaction c2")
def settle_pass(count, z, dt, numbers, law):
    """v, dv (change of the specific volume), given (energy that others than the pressure gave, J/kg); e, p, compaction advanced -> c2."""
    rows_apart()
    eos = law_of(law, numbers)
    for j in range(count):
        v, dv, compaction = z.v[j], z.dv[j], z.compaction[j]
        rho = 1.0 / v
        target = z.e[j] + z.given[j] - 0.5 * z.p[j] * dv
        crushed = remembered(compaction, eos)
        if linear_in_energy(eos):
            _, p_e = pressure_derivatives(rho, z.e[j], crushed)
            e = late_over(target - 0.5 * pressure(rho, 0.0, crushed) * dv, 1.0 + 0.5 * p_e * dv)
        else:
            e = target - 0.5 * z.p[j] * dv
            for _ in range(NEWTON_STEPS):
                _, slope = pressure_derivatives(rho, e, crushed)
                miss = e - target + 0.5 * pressure(rho, e, crushed) * dv
                e -= miss / (1.0 + 0.5 * slope * dv)
        p = pressure(rho, e, crushed)
        if remembers(eos):
            compaction = compacted(compaction, rho, e, p, eos)
            z.compaction[j] = compaction
        p_rho, p_e = pressure_derivatives(rho, e, unloading(remembered(compaction, eos)))
        z.e[j] = e
        z.p[j] = p
        z.c2[j] = p_rho + p * p_e * (v * v)


@zone_pass("v e p compaction c2")
def stiffness_pass(count, z, dt, numbers, law):
    """v, e, p, compaction -> c2."""
    rows_apart()
    eos = law_of(law, numbers)
    for j in range(count):
        v = z.v[j]
        p_rho, p_e = pressure_derivatives(1.0 / v, z.e[j], unloading(remembered(z.compaction[j], eos)))
        z.c2[j] = p_rho + z.p[j] * p_e * (v * v)


@zone_pass("rho e compaction temperature")
def temperature_pass(count, z, dt, numbers, law):
    """rho, e, compaction -> temperature (K)."""
    rows_apart()
    eos = law_of(law, numbers)
    for j in range(count):
        z.temperature[j] = eos_temperature(z.rho[j], z.e[j], remembered(z.compaction[j], eos))


@zone_pass("compaction rest")
def rest_pass(count, z, dt, numbers, law):
    """compaction -> density at rest of material as compacted as it is, kg/m3."""
    rows_apart()
    eos = law_of(law, numbers)
    for j in range(count):
        z.rest[j] = reference_state(remembered(z.compaction[j], eos))[0]
