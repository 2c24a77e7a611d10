"""Thickness against Mach number: the reciprocal-thickness curve of the literature, the thinnest shock, and Jordan's tables beside ours."""

from scipy.optimize import minimize_scalar

from hugoniot.theory.structure import jordan
from hugoniot.theory.structure.analytic import BeckerShock
from hugoniot.theory.structure.profile import Profile, steady

MEASURES = {"density_thickness": "m", "velocity_thickness": "m", "density_width_10_90": "m", "entropy_jump": "J/kg/K",
            "entropy_viscous": "J/kg/K", "entropy_conductive": "J/kg/K"}


def measures(profile: Profile) -> dict[str, float]:
    """The numbers of one profile by name, SI (`MEASURES`, the strength and both end states)."""
    ends = profile.ends
    found = {"mach": ends.mach, "shock_velocity": ends.shock_velocity, "particle_velocity": ends.particle_velocity}
    for name in ("density", "pressure", "temperature", "velocity"):
        found[f"{name}_ahead"], found[f"{name}_behind"] = getattr(ends.upstream, name), getattr(ends.downstream, name)
    return found | {
        "density_thickness": profile.thickness("density"), "velocity_thickness": profile.thickness("velocity"),
        "density_width_10_90": profile.width("density"), "velocity_width_10_90": profile.width("velocity"),
        "entropy_jump": ends.entropy_jump, "entropy_viscous": profile.entropy_viscous, "entropy_conductive": profile.entropy_conductive,
    }


def sweep(material, transport, machs, upstream=None, rtol: float = 1e-8) -> list[Profile]:
    """The steady profiles at several Mach numbers."""
    return [steady(material, transport, upstream, mach=float(mach), rtol=rtol) for mach in machs]


def thinnest(material, transport, upstream=None, low: float = 1.5, high: float = 10.0) -> tuple[float, float]:
    """(Mach number, density thickness in m) of the thinnest shock between two Mach numbers."""
    found = minimize_scalar(lambda mach: steady(material, transport, upstream, mach=mach).thickness(), bounds=(low, high), method="bounded",
                            options={"xatol": 1e-5})
    return float(found.x), float(found.fun)


def argon_rows() -> list[dict]:
    """Jordan's tables 6.2.1.1, 6.2.1.2 and 7.2.2 for argon: what it prints and what the equations give."""
    law, ahead = jordan.argon()
    rows = []
    profiles = {(v, m): steady(law, jordan.argon_transport(v), ahead, mach=m)
                for v in ("constant", "power_law") for m in jordan.ARGON_MACHS}
    for block, (viscosity, unit) in jordan.ARGON_BLOCKS.items():
        for mach, printed, entropy in zip(jordan.ARGON_MACHS, *jordan.TABLE_6_2_1_1[block]):
            profile = profiles[viscosity, mach]
            rows.append({"table": "6.2.1.1", "block": block, "mach": mach, "quantity": f"density thickness / lambda_{unit}",
                         "printed": printed, "ours": profile.thickness() / profile.mean_free_path(unit)})
            rows.append({"table": "6.2.1.1", "block": block, "mach": mach, "quantity": "entropy, J/(kg K)", "printed": entropy,
                         "ours": profile.entropy_produced})
    for mach, printed, entropy in zip(jordan.ARGON_MACHS, *jordan.TABLE_6_2_1_2.values()):
        closed = BeckerShock(mach)
        rows += [{"table": "6.2.1.2", "block": "analytic", "mach": mach, "quantity": "velocity thickness / lambda_bsl", "printed": printed,
                  "ours": closed.velocity_thickness},
                 {"table": "6.2.1.2", "block": "analytic", "mach": mach, "quantity": "density thickness / lambda_bsl", "printed": None,
                  "ours": closed.density_thickness},
                 {"table": "6.2.1.2", "block": "analytic", "mach": mach, "quantity": "entropy, J/(kg K)", "printed": entropy,
                  "ours": closed.entropy_jump(jordan.GAS_CONSTANT)}]
    for mach, printed in zip(jordan.ARGON_MACHS, jordan.TABLE_7_2_2_ARGON):
        rows.append({"table": "7.2.2", "block": "argon", "mach": mach, "quantity": "density thickness, nm", "printed": printed * 1e9,
                     "ours": profiles["power_law", mach].thickness() * 1e9})
    return rows


def condensed_rows() -> list[dict]:
    """Jordan's water and silica of table 7.2.2, nm: printed (low end), with its bent Grüneisen parameter and with the literature's."""
    rows = []
    for case in jordan.CONDENSED.values():
        bent, plain = (steady(case.eos(g), case.transport(), particle_velocity=case.particle_velocity)
                       for g in (case.bent, case.literature))
        rows.append({"table": "7.2.2", "block": case.name, "mach": plain.ends.mach, "quantity": "density thickness, nm",
                     "printed": case.printed[0] * 1e9, "ours_bent": bent.thickness() * 1e9, "ours": plain.thickness() * 1e9,
                     "spacing": case.spacing * 1e9})
    return rows
