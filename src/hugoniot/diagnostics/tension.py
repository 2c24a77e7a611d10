"""Tension that no solid carries: a material without a fracture law is pulled as far as its equation of state lets it."""

import numpy as np

from hugoniot.materials import schema
from hugoniot.materials.library import curated_name, find, spall_row
from hugoniot.problem.model import Problem
from hugoniot.problem.plane.model import Problem2D
from hugoniot.problem.write import toml_key
from hugoniot.units import format_si

MULTIPLE = 3.0     # of a spall strength: measured ones grow that much from slow to fast loading


def spall_scale(name: str) -> tuple[float, str]:
    """(spall strength in Pa, whose): that of a material of the library, else, and without a name, the largest in the library."""
    known = curated_name(name) if name else None
    row = spall_row(known) if known else None
    own = schema.row(row)["spall_strength"] if row else getattr(find(name).fracture, "strength", None) if name else None
    if own:
        return float(own), f"its spall strength in the library, {format_si(float(own), 'Pa', 3)}"
    rows = [row for row in schema.table("strength").values() if row.get("spall_strength")]
    largest = max(rows, key=lambda row: row["spall_strength"])
    strength = float(largest["spall_strength"])
    return strength, f"the largest spall strength in the library, {format_si(strength, 'Pa', 3)} ({largest.material})"


def overstretched(problem: Problem | Problem2D, region_of: np.ndarray, peak_tension: np.ndarray) -> list[str]:
    """A warning for every region without a fracture law that met more tension (Pa, (nzone,)) than MULTIPLE times a spall strength."""
    found = []
    for k, region in enumerate(problem.regions):
        material = problem.materials[region.material]
        tension = float(np.max(peak_tension[region_of == k], initial=0.0))
        if material.fracture is not None or material.burn is not None or not tension > 0.0:
            continue
        strength, whose = spall_scale(material.library)
        if tension > MULTIPLE * strength:
            name = region.material
            law = f"add [material.{toml_key(name)}.fracture]"
            if problem.solver.kind == "fronts":
                law = f"run it with lagrange1d and [material.{toml_key(name)}.fracture]"
            found.append(f"'{region.name}' was under a tension of {format_si(tension, 'Pa', 3)}, more than {MULTIPLE:g} times {whose}, "
                         f"but material '{name}' has no fracture law; {law}, or do not rely on the run "
                         "after that tension")
    return found
