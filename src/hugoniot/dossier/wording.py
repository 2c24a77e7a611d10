"""Plain words for what the pages of materials and `hugoniot material show` print: laws, derived quantities, places and rows."""

import math
import re

from hugoniot.laws.eos.contract import EOS
from hugoniot.materials.material import Material
from hugoniot.materials.reach import FAR_BRANCH
from hugoniot.materials.record import law_inside
from hugoniot.materials.schema import UNVERIFIED, Row
from hugoniot.materials.tables import families

# group of a constant's name -> heading
GROUPS = {"eos": "equation of state", "unreacted": "equation of state of the unreacted explosive", "strength": "strength",
          "fracture": "fracture", "burn": "burn", "rate": "rate constants for reactive flow", "detonation": "detonation data", "": "range"}
DERIVED = {
    "bulk_sound_speed": "bulk sound speed", "bulk_modulus": "isentropic bulk modulus K", "gruneisen": "Grüneisen parameter",
    "shear_modulus": "shear modulus G", "yield_stress": "yield stress Y", "longitudinal_sound_speed": "longitudinal sound speed",
    "poisson_ratio": "Poisson's ratio", "hugoniot_elastic_limit": "Hugoniot elastic limit (HEL)",
    "hel_particle_velocity": "particle velocity at the HEL", "cj_velocity": "CJ detonation velocity", "cj_pressure": "CJ pressure",
    "cj_particle_velocity": "particle velocity at the CJ state", "cj_density": "density at the CJ state",
    "cj_exponent": "adiabatic exponent at the CJ state", "unreacted_sound_speed": "bulk sound speed of the unreacted explosive",
}
_STATED = {
    "detonation.velocity": "stated detonation velocity", "detonation.pressure": "stated CJ pressure",
    "detonation.gurney_velocity": "Gurney velocity", "detonation.ignition_growth": "row with the constants of ignition and growth",
    "valid_up_to": "particle velocity at which the valid range ends",
}
_MODELS = {"SG": "Steinberg-Guinan", "JC": "Johnson-Cook"}
_FORMS = {"vinet": "Vinet", "birch_murnaghan": "Birch-Murnaghan"}
_TABLES = {"jwlb": "JWLB detonation products", "ignition_growth": "ignition and growth", "ptw": "Preston-Tonks-Wallace",
           "gurney": "Gurney velocity", "tillotson": "Tillotson", "pop_plot": "Pop plot"}
_PLACE = re.compile(r"([\w.-]+/[\w.-]+)@([0-9a-f]{7,40})(?: \(gh-pages\))?(?::(.*))?", re.DOTALL)
_ANOTHER = re.compile(r" \+ |; | and (?=[\w.-]+/[\w.-]+@)")


def where_read(via: str) -> str:
    """Where a number was taken from, or how it was made, as a phrase: what a source's `via` says."""
    if via.startswith("recalled"):
        return UNVERIFIED
    if via == "us_up_points.csv" or via.startswith("least squares"):
        return "the measured states are in the library's table us_up_points.csv"
    if via.startswith("computed by the package"):
        return via.replace("the package", "hugoniot")
    if via.startswith("hugoniot fit-rate"):
        return f"the command was `{via}`"
    if via.startswith("public copy"):
        what = "a public Python list of materials by S. Sakai" if "Sakai" in via else "a public file"
        return f"taken from {what} whose repository was not recorded"
    plain = re.sub(r" \(public copy \d+\)", "", via)
    found = [phrase for part in _ANOTHER.split(plain) if (phrase := _place(part))]
    return f"taken from {'; and from '.join(found)}" if found and "/" in plain else via


def _place(part: str) -> str:
    match = _PLACE.fullmatch(part.strip())
    if match:
        repository, commit, path = match.groups()
        return f"{path}, repository {repository}, commit {commit}" if path else f"repository {repository}, commit {commit}"
    repository, colon, path = part.strip().partition(":")
    return f"{path}, repository {repository}" if colon and "/" in repository else \
        re.sub(r"^(\S+/\S+)@([0-9a-f]+) \((.*)\)$", r"\3 of the repository \1, commit \2", part.strip())


def numbered(constants: list[dict]) -> tuple[list[str], list[tuple[str, str]]]:
    """(the number of each constant's source as "[1]", empty for a default value; the sources (citation, where read) in that order)."""
    sources: dict[tuple[str, str], int] = {}
    marks = []
    for c in constants:
        known = c["status"] != "default"
        marks.append(f"[{sources.setdefault((c['source'], c['via']), len(sources) + 1)}]" if known else "")
    return marks, list(sources)


def grouped(constants: list[dict]) -> dict[str, list[int]]:
    """Group of constants ("eos", "strength", ...) -> the positions of its members, in the order of the list."""
    found: dict[str, list[int]] = {}
    for k, c in enumerate(constants):
        group, dot, _ = c["quantity"].partition(".")
        found.setdefault(group if dot and group in GROUPS else "", []).append(k)
    return found


def meanings(material: Material, rate=None) -> dict[str, str]:
    """Name of a constant such as "eos.c0" -> what it is, in the words of its law; `rate` has those of reactive flow."""
    found = dict(_STATED)
    for group in ("eos", "strength", "fracture", "burn", "unreacted"):
        par = getattr(material, group)
        if par is not None:
            registry = families()["eos" if group == "unreacted" else group]
            found |= {f"{group}.{name}": text for name, text in _meanings(registry, par).items()}
    if rate is not None:
        found |= {f"rate.{name}": text for name, text in _meanings(families()["burn"], rate).items()}
    return found


def _meanings(registry, par) -> dict[str, str]:
    law = law_inside(registry, par, [])
    found = dict(law.meaning)
    for name in getattr(par, "_fields", ()):
        inner = getattr(par, name)
        if registry.knows(inner):
            found |= {f"{name}.{key}": text for key, text in _meanings(registry, inner).items()}
    if "alpha0" in getattr(par, "_fields", ()) and "base.rho0" in found:
        found["base.rho0"] = "reference density of the solid"
    return found


def reference_name(about: dict) -> str:
    """What to call the state that derived quantities refer to: a porous material does not start at the reference density of its solid."""
    porous = "remembers" in EOS.get(about["laws"]["eos"]).flags
    return "initial state of the porous material" if porous else "reference state"


def differences(about: dict) -> str:
    """How derived quantities differ from the material's own at low pressure, or from the constants of its strength law; empty where not."""
    found = []
    if about["data_begin"] and "bulk_sound_speed" in about["derived"]:
        found.append(f"They describe the law, whose valid range begins at a particle velocity of {about['data_begin']:g} m/s; at low "
                     "pressure the sound speeds and elastic constants of the real material may differ.")
    if about["sound_speed_of_others"] and "bulk_sound_speed" in about["derived"]:
        begin, low, high = (f"{v:.4g}" for v in about["sound_speed_of_others"])
        span = low if low == high else f"{low} to {high}"
        found.append(f"The bulk sound speed is extrapolated from data that begin at a particle velocity of {begin} m/s; other rows of the "
                     f"library whose data begin below {FAR_BRANCH:g} m/s give {span} m/s.")
    if about["laws"].get("strength") == "steinberg_guinan" and "shear_modulus" in about["derived"]:
        stated = {c["quantity"]: c["value"] for c in about["constants"]}
        ratio = about["derived"]["shear_modulus"]["value"] / stated["strength.shear_modulus"]
        if about["reference"]["temperature"] and abs(ratio - 1.0) > 1e-6:
            found.append("The constants of the strength law are for 300 K, the derived shear modulus and yield stress for "
                         f"{about['reference']['temperature']:g} K.")
        if strain := stated.get("strength.initial_strain"):
            found.append(f"The yield stress includes the hardening by the initial strain of {strain:g}.")
    if about["laws"].get("strength") == "johnson_cook" and "yield_stress" in about["derived"]:
        room = next(c["value"] for c in about["constants"] if c["quantity"] == "strength.room_temperature")
        if about["reference"]["temperature"] > room:
            found.append(f"The strength law has no thermal softening up to {room:g} K; the derived yield stress is for "
                         f"{about['reference']['temperature']:g} K.")
    return " ".join(found)


def digits(value: float, count: int = 4) -> str:
    """A number to a few significant digits, without an exponent from 0.001 to a million."""
    if not math.isfinite(value) or value == 0.0 or not 1e-3 <= abs(value) < 1e6:
        return f"{value:.{count}g}"
    places = count - 1 - math.floor(math.log10(abs(value)))
    return f"{round(value, places):.{max(places, 0)}f}"


def row_summary(row: Row) -> str:
    """The constants of a row in a few words, with the range of a Hugoniot and its mark."""
    if row.table == "us_up":
        density = f"density {row['rho0']:.5g} kg/m3, " if "rho0" in row else ""
        ends = f"from {row['up_min']:g} to" if row.get("up_min") else "up to"
        what = ("for particle velocities" if row.status == "derived" or not row.range_from() else
                "compared with states at particle velocities" if "states" in row else "range inferred: particle velocities")
        reaches = f", {what} {ends} {row['up_max']:g} m/s" if "up_max" in row else ", range not stated"
        text = density + hugoniot_text(row) + reaches
    elif row.table == "compression":
        text = (f"density {row['rho0']:.5g} kg/m3, {_FORMS[row['form']]} isotherm, bulk modulus "
                f"{row['bulk_modulus'] / 1e9:.4g} GPa, pressure derivative {row['bulk_modulus_slope']:g}")
    elif row.table == "jwl":
        stated = f", detonation velocity {row['detonation_velocity']:g} m/s" if "detonation_velocity" in row else ""
        what = "detonation products" if row["role"] == "products" else "unreacted explosive"
        text = f"JWL of the {what}, density {row['rho0']:g} kg/m3{stated}"
    elif row.table == "strength":
        y = row.get("yield_stress") or row.get("johnson_cook_yield")
        what = "cohesion" if row["model"].startswith("Collins") else "yield stress"     # their strength rises with the pressure
        text = _MODELS.get(row["model"], row["model"]) + (f", {what} {y / 1e9:.3g} GPa" if y else "")
    elif row.table == "porous":
        text = f"crush curve: {row['model']}"
    else:
        text = _TABLES.get(row.table, row.table.replace("_", " "))
    return text + (" (not checked)" if row.status == "recalled" else " (doubtful)" if row.marks else "")


def hugoniot_text(row: Row) -> str:
    """Us(up) of a row as a formula, m/s; a fit of the library to four digits, a published one as it stands."""
    form = ".4g" if row.status == "derived" else "g"
    text = f"Us = {row['c0']:{form}} + {row['s']:{form}} up"
    if row["form"] == "quadratic":
        text += f" {_signed(row['quadratic'], '.3g')} up^2"
    elif row["form"] == "ulh":
        text += f" {_signed(row['exponential_amplitude'])} up exp(-{row['exponential_rate']:g} up)"
    elif row["form"] == "steinberg_cubic":
        text += "".join(f" {_signed(row[name])} {what}" for name, what in (("s2", "(up/Us) up"), ("s3", "(up/Us)^2 up")) if row[name])
    return f"{text} (m/s)"


def _signed(value: float, form: str = "g") -> str:
    return f"{'-' if value < 0.0 else '+'} {abs(value):{form}}"
