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
WORDS = {"density_l1": "L1 error of the density", "energy_l1": "L1 error of the energy per mass", "velocity_l1": "L1 error of the velocity",
         "density_self_l1": "L1 difference of the density from a run on 3200 zones",
         "plateau_density": "mean density of the plateau behind the shock, relative error",
         "wall_density": "density at the wall, axis or centre / exact",
         "shock_position": "position of the shock, error", "peak_density": "largest density",
         "outer_radius": "outer radius, relative error", "plateau_pressure": "pressure of the plateau, relative error",
         "plateau_velocity": "velocity of the plateau, relative error",
         "elastic_limit": "stress behind the elastic precursor, relative error",
         "plastic_stress": "stress behind the plastic shock, relative error",
         "stop_radius": "inner radius at which the shell stops, relative error",
         "energy_minimum": "smallest energy per mass during the run",
         "reference_density": "density at four reference positions, largest relative difference",
         "fronts": "positions and times of fronts, largest relative error", "states": "states between fronts, largest relative error",
         "speeds": "speeds of fronts, largest relative error", "contacts": "positions of the two contacts, largest error",
         "front_position": "position of the detonation front, relative error",
         "pressure_l1": "mean error of the pressure / pressure of the spike",
         "exponent": "exponent of the converging shock, relative error",
         "arrival": "arrival time of the returning shock, relative error",
         "inner_radius": "inner radius, relative error", "asymmetry": "largest difference of radii on one ring of nodes",
         "densest_zone": "density of the densest zone",
         "peak_scatter": "standard deviation of the peak density between sectors / mean",
         "front_rms": "deviation of the shock from a straight line, root mean square",
         "velocity_across": "largest transverse velocity / velocity of the piston",
         "interface_length": "length of the interface, relative difference from a mesh twice as fine",
         "time_reached": "time reached",
         "density": "density of a zone, largest relative error",
         "viscous_work": "work of the artificial viscosity / internal energy",
         "peak_speed": "loss of the largest speed", "speed_l2": "root mean square error of the speed",
         "velocity_l2": "root mean square error of the velocity, weighted by mass",
         "length": "final length, relative difference from the reference",
         "foot": "radius of the foot, relative difference from the reference",
         "plastic_strain": "largest plastic strain, relative difference from the reference",
         "filter_work": "work of the hourglass filter / internal energy",
         "lighting_time": "burn time, largest error / latest burn time",
         "speed_6mm": "wall velocity after 6 mm of travel, relative difference from experiment",
         "speed_19mm": "wall velocity after 19 mm of travel, relative difference from experiment",
         "stress_drift": "magnitude of the stress, largest relative change", "angle_error": "rotation of the stress, largest error in rad",
         "axis_pressure": "pressure on the axis, largest error / pressure of the plateau",
         "release_arrival": "arrival time of the release, relative error",
         "pressure": "pressure behind the shock, relative error", "shock_angle": "angle of the shock, error in degrees",
         "contact_depth": "largest depth of a node behind a surface / edge length",
         "length_beside_quads": "final length, relative difference from quadrilaterals",
         "foot_beside_quads": "radius of the foot, relative difference from quadrilaterals",
         "plastic_strain_beside_quads": "largest plastic strain, relative difference from quadrilaterals"}
WORDS_OF_PLANE = {**WORDS, "peak_density": "largest density, mean over sectors"}


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
    closed = f"Energy conserved to {found['energy_error']:.0g}" + (f", momentum to {momentum:.0g}." if momentum is not None else ".")
    words = problem.description[0].upper() + problem.description[1:]
    lines = [f"### {problem.name}{more}", "", f"{words}. {closed}", ""]
    plane = isinstance(problem, PlaneProblem)
    names = WORDS_OF_PLANE if plane else WORDS
    limits = {"peer": "open codes", "goal": "goal"} if plane else {"ko": "KO", "g2": "G2", "goal": "goal"}
    limits = {key: head for key, head in limits.items() if any(row[key] is not None for row in found["measures"])}
    ordered = any(found["orders"].get(row["measure"]) is not None and row["sense"] == "below" for row in found["measures"])
    heads = ["measure", "zones", "value", *limits.values(), *(["order"] if ordered else [])]
    lines += ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    last = None
    keys = list(dict.fromkeys(row["measure"] for row in found["measures"]))
    for row in sorted(found["measures"], key=lambda m: keys.index(m["measure"])):
        order = found["orders"].get(row["measure"])
        shown = f"{round(order, 2) + 0.0:.2f}" if order is not None and row["measure"] != last and row["sense"] == "below" else ""
        sense = " (larger is better)" if row["sense"] == "above" else ""
        words = names.get(row["measure"], row["measure"].replace("_", " ")) + sense if row["measure"] != last else ""
        marks = [against(row[key], beats(row, key)) for key in limits]
        cells = [words, str(row["zones"]), f"{row['value']:.4g}", *marks, *([shown] if ordered else [])]
        lines.append("| " + " | ".join(cells) + " |")
        last = row["measure"]
    return [*lines, ""]


def table(found: list[dict], more: str = "") -> list[str]:
    """The limits that are met, and the tables of all problems."""
    rows = [row for problem in found for row in problem["measures"]]
    lines = []
    for key, words in (("ko", "KO"), ("g2", "G2"), ("peer", "open codes"), ("goal", "goals")):
        marks = [beats(row, key) for row in rows if row[key] is not None]
        lines += [f"{sum(marks)} of {len(marks)} {words}"] if marks else []
    seconds = sum(p["seconds"] for p in found)
    text = ["**Limits met: " + ", ".join(lines) + f"** (computing time {seconds:.0f} s, compilation included).", ""]
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
                 "`hugoniot verify --solver fronts`: the one-dimensional problems on the same grids and with the same limits, then "
                 "the problems for tracked fronts alone.", "",
                 *table(json.loads(Path(fronts).read_text()), ", tracked fronts")]
    TARGET.write_text("\n".join(text), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
