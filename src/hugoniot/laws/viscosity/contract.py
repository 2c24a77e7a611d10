"""What an artificial viscosity owes: the viscous pressure of a zone in compression.

    viscous_pressure(rho, c, p, du, psi, par)    q >= 0, Pa

rho kg/m3; c the true longitudinal sound speed m/s; p Pa; du = u_right - u_left of the zone, m/s, negative here (the solver calls the
law for compressing zones only and sets q = 0 elsewhere); psi in [0, 1] the smoothness of the velocity field (1: linear flow,
0: a shock or an extremum), which laws flagged "limited" use and others ignore.
"""

from hugoniot.core.registry import Registry

VISCOSITY = Registry("viscosity", contract=("viscous_pressure",))


def viscous_pressure(rho, c, p, du, psi, par):
    """Viscous pressure, Pa."""
    return VISCOSITY.of(par).functions["viscous_pressure"](rho, c, p, du, psi, par)


GENERICS = {"viscous_pressure": viscous_pressure}
