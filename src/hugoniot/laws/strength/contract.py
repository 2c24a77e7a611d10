"""What a strength law must provide: a shear modulus and a flow stress; the solver does the radial return, the same for all laws.

    shear_modulus(rho, p, temperature, bulk_modulus, par)                       G, Pa
    flow_stress(rho, p, temperature, plastic_strain, strain_rate, par)          Y, Pa (uniaxial stress at yield)

rho kg/m3, p Pa, temperature K (from the equation of state; only laws flagged "needs_temperature" receive one, others 0),
bulk_modulus Pa (isentropic, of the equation of state), plastic_strain the accumulated equivalent plastic strain,
strain_rate the equivalent total strain rate 1/s (only laws flagged "needs_rate"; others 0).
"""

from hugoniot.core.registry import Registry

STRENGTH = Registry("strength", contract=("shear_modulus", "flow_stress"))


def shear_modulus(rho, p, temperature, bulk_modulus, par):
    """Shear modulus, Pa."""
    return STRENGTH.of(par).functions["shear_modulus"](rho, p, temperature, bulk_modulus, par)


def flow_stress(rho, p, temperature, plastic_strain, strain_rate, par):
    """Flow stress in uniaxial stress, Pa."""
    return STRENGTH.of(par).functions["flow_stress"](rho, p, temperature, plastic_strain, strain_rate, par)


GENERICS = {"shear_modulus": shear_modulus, "flow_stress": flow_stress}
