"""Physical viscosity and heat conduction of the zones of a material: its shear viscosity, temperature, specific heats and conductivity."""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind_family
from hugoniot.core.passes import law_of, rows_apart, zone_pass
from hugoniot.laws.arrays import float_parameters
from hugoniot.laws.eos.contract import pressure, pressure_derivatives, remembered, temperature
from hugoniot.laws.transport import contract
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT, Transport, conductivity, conducts, isobaric_heat, viscosity
from hugoniot.zones import closure

PROBE = 1e-4     # relative step of the temperature's slopes: their error is the square


class TransportRows(NamedTuple):
    """Rows of zones that runs with transport have."""

    temperature: Any       # K
    viscosity: Any         # Pa s
    isochoric: Any         # specific heat at constant volume, J/kg/K; of no meaning where nothing conducts
    isobaric: Any
    conductivity: Any      # W/m/K; 0 where nothing conducts
    radial: Any            # viscous stress along the motion and around it, tension positive, Pa
    around: Any


def zone_transport(made: Transport) -> Transport:
    """The same laws as passes take them; `shear` and `conduction` are None where a material has none."""
    bind_family(TRANSPORT, contract.GENERICS)
    bind_family(CONDUCTION, contract.CONDUCTION_GENERICS)
    return made._replace(shear=None if made.shear is None else float_parameters(made.shear),
                         conduction=float_parameters(made.conduction) if conducts(made) else None)


@zone_pass("rho temperature viscosity")
def viscosity_pass(count, z, dt, numbers, law):
    rows_apart()
    shear = law_of(law, numbers)
    for j in range(count):
        z.viscosity[j] = viscosity(z.rho[j], z.temperature[j], shear)


@zone_pass("rho e compaction temperature isochoric isobaric")
def heat_pass(count, z, dt, numbers, law):
    """Temperature and specific heats; the slopes of the temperature by differences, as any law has it."""
    rows_apart()
    eos = law_of(law, numbers)
    for j in range(count):
        rho, e, own = z.rho[j], z.e[j], remembered(z.compaction[j], eos)
        p = pressure(rho, e, own)
        p_rho, p_e = pressure_derivatives(rho, e, own)
        c2 = p_rho + p * p_e / (rho * rho)
        wider, closer, more = rho / (1.0 + PROBE), rho / (1.0 - PROBE), PROBE * c2
        T_v = (temperature(wider, e, own) - temperature(closer, e, own)) * rho / (2.0 * PROBE)
        T_e = (temperature(rho, e + more, own) - temperature(rho, e - more, own)) / (2.0 * more)
        z.temperature[j] = temperature(rho, e, own)
        z.isochoric[j] = 1.0 / T_e
        z.isobaric[j] = isobaric_heat(rho, c2, p_rho, p_e, T_v, T_e)


@zone_pass("rho temperature viscosity isobaric conductivity")
def conductivity_pass(count, z, dt, numbers, law):
    rows_apart()
    conduction = law_of(law, numbers)
    for j in range(count):
        z.conductivity[j] = conductivity(z.rho[j], z.temperature[j], z.viscosity[j], z.isobaric[j], conduction)


def find_viscosity(s, rho, e) -> None:
    """Write the viscosity of a state of density and energy `rho`, `e`; s: `zones.steps.MaterialSteps` with rows t and `transport`."""
    t, laws = s.at.t, s.at.transport
    if "needs_temperature" in TRANSPORT.of(laws.shear).flags:
        s.do(closure.temperature_pass, (rho, e, s.at.z.compaction, t.temperature), law=s.laws.eos)
    s.do(viscosity_pass, (rho, t.temperature, t.viscosity), law=laws.shear)


def find_conductivity(s, rho) -> None:
    """Write temperature, specific heat and conductivity at the end of a step, where something conducts; `rho` is the solid's density."""
    if s.at.transport is None or s.at.transport.conduction is None:
        return
    t, z = s.at.t, s.at.z
    s.do(heat_pass, (rho, z.e, z.compaction, t.temperature, t.isochoric, t.isobaric), law=s.laws.eos)
    if s.at.transport.shear is not None:
        s.do(viscosity_pass, (rho, t.temperature, t.viscosity), law=s.at.transport.shear)
    s.do(conductivity_pass, (rho, t.temperature, t.viscosity, t.isobaric, t.conductivity), law=s.at.transport.conduction)
