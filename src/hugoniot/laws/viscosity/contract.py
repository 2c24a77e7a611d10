"""What an artificial viscosity must provide: the viscous signal speed of a zone in compression.

    viscous_speed(v, c, p, du, psi, par)    w >= 0, m/s: the viscous pressure is q = rho |du| w

v specific volume m3/kg; c the true longitudinal sound speed m/s; p Pa; du = u_right - u_left of the zone, m/s, never positive (the
solver sets q = 0 in expansion) except for laws flagged "two_sided", whose q = -rho du w is a tension there; psi in [0, 1] the smoothness of
the velocity field (1: linear flow, 0: a shock or an extremum), which laws flagged "limited" use and others ignore. The speed, not q, is the
contract, because the time step needs it too.
"""

from hugoniot.core.registry import Registry

VISCOSITY = Registry("viscosity", contract=("viscous_speed",))


def viscous_speed(v, c, p, du, psi, par):
    """Viscous signal speed w, m/s; q = rho |du| w."""
    return VISCOSITY.of(par).functions["viscous_speed"](v, c, p, du, psi, par)


GENERICS = {"viscous_speed": viscous_speed}
