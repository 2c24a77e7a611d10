"""What a fracture law must provide: how close a zone is to failure, how damage grows, and the tension it can support.

    failure(tension, p, v, damage, par)   ratio that reaches 1 at failure; tension = s1 - p, the longitudinal tensile stress
                                          (Pa, positive in tension), p pressure (Pa), v = rho0/rho relative volume
    damage_rate(tension, par)             d(damage)/dt, 1/s (0 for laws without memory)
    tension_cap(void_fraction, par)       largest tension a zone can support, Pa, for a volume fraction of voids grown in it
                                          (core.ops.NO_LIMIT: no limit; the solver evaluates it only for laws flagged "voids")
    at_node(tension, p, v, slope, par)    for laws flagged "nodes", which are evaluated at nodes instead: the ratio from the means of the
                                          two zones beside a node and the largest slope of the tension around it, Pa/m
"""

from hugoniot.core.registry import Registry

FRACTURE = Registry("fracture", contract=("failure", "damage_rate", "tension_cap"), optional=("at_node",))


def asked_at_nodes(par) -> bool:
    """Whether a law (None: none) is evaluated at nodes, from pairs of zones, and not in single zones."""
    return par is not None and "nodes" in FRACTURE.of(par).flags


def failure(tension, p, v, damage, par):
    """Ratio that reaches 1 at failure."""
    return FRACTURE.of(par).functions["failure"](tension, p, v, damage, par)


def damage_rate(tension, par):
    """Rate of damage, 1/s."""
    return FRACTURE.of(par).functions["damage_rate"](tension, par)


def tension_cap(void_fraction, par):
    """Largest tension a zone may carry, Pa."""
    return FRACTURE.of(par).functions["tension_cap"](void_fraction, par)


def at_node(tension, p, v, slope, par):
    """Ratio that reaches 1 at failure, at a node; of laws flagged "nodes"."""
    return FRACTURE.of(par).functions["at_node"](tension, p, v, slope, par)


GENERICS = {"failure": failure, "damage_rate": damage_rate, "tension_cap": tension_cap, "at_node": at_node}


def opens_voids(law) -> bool:
    """Whether voids open in zones of a material with a fracture law, or None."""
    return law is not None and "voids" in FRACTURE.of(law).flags
