"""What a finished run's free surface tells: the record an experimenter would have, and the spall strength read from it."""

import numpy as np

from hugoniot.diagnostics.velocimetry import kanel_correction, pull_back, ringing_period, spall_strength, spall_thickness
from hugoniot.output.compare import free_surface_gauges


def free_surface_record(run, name: str | None = None) -> tuple[np.ndarray, np.ndarray, str]:
    """(time s, velocity outwards m/s, what was measured) of a free surface: its gauge, else the right face of the snapshots.

    Empty where the right end is not free and no gauge rides on a free surface.
    """
    found = free_surface_gauges(run)
    name = name or (found[0] if found else None)
    if name is not None:
        time, velocity = run.gauge("velocity", name)
        return time, -velocity if _looks_left(run, name) else velocity, f"gauge '{name}'"
    rows = run.arrays("snapshots")
    if run.setup["boundaries"]["right"]["kind"] != "free" or "velocity_right" not in rows:
        return np.empty(0), np.empty(0), "nothing"
    return rows["time"], rows["velocity_right"][:, -1], "the snapshots only; a gauge at 'free surface right' would be finer"


def _looks_left(run, name: str) -> bool:
    """Whether a gauge rides on a surface whose outside is to the left."""
    return next((str(g["at"]) for g in run.setup["gauges"] if g["name"] == name), name).endswith("left")


def has_spalled(run) -> bool:
    """Whether a void opened inside a material: a dip of the velocity in a run that broke nothing is a reverberation, not a pull-back."""
    rows = run.arrays("events")
    return any(kind == "void_opened" for kind in rows["kind"])


def target_constants(run, name: str | None = None) -> dict[str, float]:
    """rho0 (kg/m3), c_bulk and c_long (m/s) of the outermost region on the side of the gauge `name` (default: the right), as far as its
    material states them."""
    outermost = 0 if name is not None and _looks_left(run, name) else -1
    material = run.setup["materials"][run.setup["regions"][outermost]["material"]]
    known = {c["name"]: c["value"] for law in reversed(material["laws"]) for c in law["constants"] if isinstance(c["value"], (int, float))}
    rho0, c0, modulus = known.get("rho0"), known.get("c0"), known.get("shear_modulus")
    result = {}
    if rho0 and c0:
        result = {"rho0": rho0, "c_bulk": c0, "c_long": float(np.sqrt(c0**2 + 4.0 * (modulus or 0.0) / (3.0 * rho0)))}
    return result


def spall_reading(run, name: str | None = None) -> dict[str, float]:
    """What the free-surface record tells: pull-back (m/s), spall strength (Pa: acoustic, Stepanov's, Kanel's), spall thickness (m).

    Empty if nothing broke or there is no pull-back; strengths and thickness only where the material states rho0 and c0.
    """
    time, velocity, _ = free_surface_record(run, name)
    found = pull_back(time, velocity) if has_spalled(run) else None
    return reading_of(time, velocity, found, target_constants(run, name)) if found else {}


def reading_of(time, velocity, found, constants) -> dict[str, float]:
    """The numbers of `spall_reading` from a record, its pull-back and the constants of `target_constants`."""
    result = {"peak_velocity": found.peak, "pull_back": found.drop, "minimum_time": found.minimum_time}
    period = ringing_period(time, velocity, found.minimum_time)
    if np.isfinite(period):
        result["ringing_period"] = period
    if not constants:
        return result
    rho0, c_bulk, c_long = constants["rho0"], constants["c_bulk"], constants["c_long"]
    result["spall_strength_acoustic"] = spall_strength(found.drop, rho0, c_bulk)
    if c_long > c_bulk:
        result["spall_strength_stepanov"] = spall_strength(found.drop, rho0, c_bulk, c_long)
    if np.isfinite(period):
        thickness = result["spall_thickness"] = spall_thickness(period, c_long)
        if c_long > c_bulk:
            lost = kanel_correction(time, velocity, found, thickness, c_bulk, c_long)
            result["spall_strength_kanel"] = spall_strength(found.drop + lost, rho0, c_bulk)
    return result
