"""Writes docs/verification_numbers.md from what `hugoniot verify` prints:

    hugoniot verify --json > verify.json
    hugoniot verify --solver fronts --json > fronts.json
    python docs/generate_verification.py verify.json fronts.json

The page is kept in the repository, unlike other generated pages: the runs take minutes, and the numbers are a record.
"""

import json
import sys
from pathlib import Path

from hugoniot.campaign.plane import PlaneProblem
from hugoniot.campaign.tracked_problems import TrackedProblem
from hugoniot.campaign.verify import PROBLEMS

TARGET = Path(__file__).parent / "verification_numbers.md"
WORDS = {"density_l1": "L1 of density", "energy_l1": "L1 of energy", "velocity_l1": "L1 of velocity",
         "density_self_l1": "L1 of density, against 3200 zones",
         "plateau_density": "mean density of the plateau, relative error", "wall_density": "density at the wall / exact",
         "shock_position": "position of the shock, error", "peak_density": "peak density", "outer_radius": "outer radius, relative error",
         "plateau_pressure": "plateau pressure, relative error", "plateau_velocity": "plateau velocity, relative error",
         "elastic_limit": "elastic limit, relative error", "plastic_stress": "stress behind, relative error",
         "stop_radius": "radius at stop, relative error", "energy_minimum": "least energy", 
         "reference_density": "density at reference points, largest relative difference",
         "fronts": "places and times of fronts, largest relative difference", "states": "states between them, largest relative difference",
         "speeds": "speeds of fronts, largest relative difference", "contacts": "places of both contacts, error",
         "front_position": "place of the front, relative error", "pressure_l1": "mean error of the pressure / spike",
         "exponent": "exponent of the converging shock, relative error", "arrival": "arrival of the reflected shock, relative error",
         "inner_radius": "inner radius, relative error", "asymmetry": "difference of radii on one ring",
         "densest_zone": "density of the densest zone", "peak_scatter": "scatter of the peak between sectors, relative",
         "front_rms": "unevenness of the shock, root mean square", "velocity_across": "largest velocity across the motion",
         "interface_length": "length of the interface, relative difference from the finer mesh",
         "density": "density of a zone, largest relative error", "viscous_work": "work of the viscosity / internal energy",
         "peak_speed": "loss of the peak speed", "speed_l2": "L2 of speed", "velocity_l2": "L2 of velocity",
         "length": "length, relative difference from the reference", "foot": "radius of the foot, relative difference from the reference",
         "plastic_strain": "largest plastic strain, relative difference from the reference",
         "filter_work": "work of the filter / internal energy", "lighting_time": "burn time, largest error / latest burn time",
         "speed_6mm": "speed of the wall after 6 mm, relative error", "speed_19mm": "speed of the wall after 19 mm, relative error",
         "stress_drift": "size of the stress, relative change", "angle_error": "angle of the stress, error in rad",
         "axis_pressure": "pressure on the axis, largest error / plateau", "release_arrival": "arrival of the release, relative error",
         "pressure": "pressure behind the shock, relative error", "shock_angle": "angle of the shock, error in degrees",
         "contact_depth": "deepest node behind a surface / edge", "length_beside_quads": "length, relative difference from quadrilaterals",
         "foot_beside_quads": "radius of the foot, relative difference from quadrilaterals",
         "plastic_strain_beside_quads": "largest plastic strain, relative difference from quadrilaterals"}


def against(value, beaten: bool | None) -> str:
    return "" if value is None else f"{value:.3g} " + ("✓" if beaten else "✗")


def beats(row: dict, key: str) -> bool | None:
    if row[key] is None:
        return None
    return row["value"] <= row[key] if row["sense"] == "below" else row["value"] >= row[key]


def section(found: dict, more: str = "") -> list[str]:
    """Heading and table of one problem; `more` follows its name."""
    problem = PROBLEMS[found["problem"]]
    momentum = found["momentum_error"]      # none in curved geometry, where walls and pressures take it up
    closed = f"Energy closed to {found['energy_error']:.0e}" + (f", momentum to {momentum:.0e}." if momentum is not None else ".")
    words = problem.description[0].upper() + problem.description[1:]
    lines = [f"### {problem.name}{more}", "", f"{words}. {closed}", ""]
    limits = {"peer": "open codes", "goal": "goal"} if isinstance(problem, PlaneProblem) else {"ko": "KO", "g2": "G2", "goal": "goal"}
    lines += ["| measure | zones | value | " + " | ".join(limits.values()) + " | order |", "|---" * (len(limits) + 4) + "|"]
    last = None
    keys = list(dict.fromkeys(row["measure"] for row in found["measures"]))
    for row in sorted(found["measures"], key=lambda m: keys.index(m["measure"])):
        order = found["orders"].get(row["measure"])
        shown = f"{order:.2f}" if order is not None and row["measure"] != last and row["sense"] == "below" else ""
        words = WORDS.get(row["measure"], row["measure"].replace("_", " ")) if row["measure"] != last else ""
        marks = " | ".join(against(row[key], beats(row, key)) for key in limits)
        lines.append(f"| {words} | {row['zones']} | {row['value']:.4g} | {marks} | {shown} |")
        last = row["measure"]
    return [*lines, ""]


def table(found: list[dict], more: str = "") -> list[str]:
    """The limits that are met, and the tables of all problems."""
    rows = [row for problem in found for row in problem["measures"]]
    lines = []
    for key, words in (("ko", "KO"), ("g2", "second-order Godunov"), ("peer", "open codes"), ("goal", "goals")):
        marks = [beats(row, key) for row in rows if row[key] is not None]
        lines += [f"{sum(marks)} of {len(marks)} {words}"] if marks else []
    seconds = sum(p["seconds"] for p in found)
    text = ["**Limits met: " + ", ".join(lines) + f"** ({seconds:.0f} s for all problems, compiling included).", ""]
    for problem in found:
        text += section(problem, more)
    return text


def main(path: str, fronts: str | None = None) -> None:
    found = json.loads(Path(path).read_text())
    if fronts:      # problems of tracked fronts alone stand in the second part
        found = [problem for problem in found if not isinstance(PROBLEMS[problem["problem"]], TrackedProblem)]
    text = table(found)
    if fronts:
        text += ["## With tracked fronts", "",
                 "The one-dimensional problems with `hugoniot verify --solver fronts`, on the same grids and held to the same limits.", "",
                 *table(json.loads(Path(fronts).read_text()), ", tracked fronts")]
    TARGET.write_text("\n".join(text), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
