"""Writes docs/generated/laws: a page per law from its file and its registration, with a picture (law_pictures) for equations of state."""

import inspect
from pathlib import Path

import numpy as np
from generate_theory import explained
from law_pictures import draw

import hugoniot.laws.burn
import hugoniot.laws.eos
import hugoniot.laws.fracture
import hugoniot.laws.mixture
import hugoniot.laws.strength
import hugoniot.laws.transport
import hugoniot.laws.viscosity  # noqa: F401
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import EOS, density_limits, gives, has_temperature, particle_velocity_limit
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials.tables import accepted
from hugoniot.units import format_si, parse

TARGET = Path(__file__).parent / "generated" / "laws"
HEADS = {
    "eos": (EOS, "Equations of state", "`[material.NAME.eos] law = ...`. State is density and specific internal energy."),
    "strength": (STRENGTH, "Strength", "`[material.NAME.strength] law = ...`: shear modulus and flow stress."),
    "fracture": (FRACTURE, "Fracture", "`[material.NAME.fracture] law = ...`: failure in tension, and the tension a material supports."),
    "viscosity": (VISCOSITY, "Artificial viscosity", "`[solver.viscosity] law = ...`: $q = \\rho|\\Delta u|w$ in compression."),
    "burn": (BURN, "Burning", "How an explosive burns to products: by a schedule, or at a rate that depends on the state."),
    "mixture": (MIXTURE, "Mixtures", "The state of reactants and products in one zone; see [the theory](../../theory/mixtures.md)."),
    "transport": (TRANSPORT, "Physical viscosity", "Shear viscosity of a fluid, for the structure of a shock and for `lagrange1d`."),
    "conduction": (CONDUCTION, "Heat conduction", "Heat conductivity of a material, for the structure of a shock and for `lagrange1d`."),
}


DECK = {"eos": "material.x.eos", "strength": "material.x.strength", "fracture": "material.x.fracture", "burn": "material.x.burn",
        "viscosity": "solver.viscosity"}
UNITS = {"rho": "kg/m^3", "e": "J/kg", "p": "Pa", "temperature": "K", "T": "K", "bulk_modulus": "Pa", "plastic_strain": "1", "du": "m/s",
         "strain_rate": "1/s", "tension": "Pa", "v": "1", "damage": "1", "c": "m/s", "psi": "1", "burn_fraction": "1"}


def cell(value) -> str:
    return str(value).replace("|", "\\|").replace("\n", " ").replace("<", "&lt;").replace("_", "\\_").replace("*", "\\*")


def table(heads, rows) -> list[str]:
    return ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads), *("| " + " | ".join(row) + " |" for row in rows), ""]


def parameters(law) -> list[str]:
    """Parameters in a deck, with units, defaults and meaning."""
    names, needed = accepted(law)
    rows = []
    for name in names:
        default = law.defaults.get(name)
        shown = "required" if name in needed else "optional" if default is None or default != default else f"`{default}`"
        rows.append((f"`{name}`", cell(law.units.get(name, "1")) or "law", shown, cell(law.meaning.get(name, ""))))
    return table(["parameter", "unit", "default", "meaning"], rows) if rows else ["It has no parameters.", ""]


def validity(law) -> list[str]:
    """The box of states in which the example parameters are tested, and the limits an equation of state states in its errors."""
    if not law.box:
        return []
    rows = [(f"`{name}`", cell(UNITS[name]), f"{low:g}", f"{high:g}") for name, (low, high) in law.box.items()]
    lines = ["## Validity", "", "The contract tests check the example within this range:", ""]
    lines += table(["variable", "unit", "from", "to"], rows)
    return [*lines, *limits(law)] if law.family == "eos" else lines


def limits(law) -> list[str]:
    """What the example refuses, and which of temperature and entropy it has."""
    par = law.example
    low, high = density_limits(par)
    ends = "at any density" if high == np.inf and low == 0.0 else f"for densities between {low:g} and {high:.6g} kg/m³"
    fastest = particle_velocity_limit(par)
    words = [f"The example is valid {ends}"]
    if np.isfinite(fastest):
        words.append(f", for shocks from rest up to a particle velocity of {fastest:.5g} m/s")
    if "energy_limits" in law.functions:
        words.append(", and for the energies in its table")
    words.append(", where the sound speed is real ($c^2 > 0$); a state outside is refused with an error that states the limit. ")
    if has_temperature(par):
        words.append("It has a temperature and an entropy." if gives(par, "entropy") else "It has a temperature, but no entropy.")
    else:
        words.append("It has neither temperature nor entropy.")
    return ["".join(words), ""]


def quantity(value: float, unit: str) -> str:
    """A value with its unit, in a larger common unit where no digits are lost."""
    shown = format_si(value, unit, 8)
    return shown if "kg/m3" not in shown and parse(shown, unit) == value else f"{value:.10g} {unit}"


def deck_lines(law, par, where: str) -> list[str] | None:
    """The tables of a deck that give `par`; None where a deck's values are not kept in the parameters."""
    names, needed = accepted(law)
    given = dict(zip(par._fields, par))
    if any(n not in given or isinstance(given[n], (np.ndarray, tuple)) and law.units.get(n) != "law" for n in needed):
        return None
    lines, inner = [f"[{where}]", f'law = "{law.name}"'], []
    for name in names:
        value = given.get(name)
        if value is None or EOS.knows(value):
            inner += deck_lines(EOS.of(value), value, f"{where}.{name}") or [] if value is not None else []
        elif isinstance(value, (int, float)) and value == value and \
                (name in needed or value != law.defaults.get(name)) and (name, value) != ("gamma_slope", 0.0):
            unit = law.units.get(name, "1")
            bare = unit in ("1", "text") or "Pa^" in unit
            lines.append(f"{name} = {value:.10g}" if bare else f'{name} = "{quantity(value, unit)}"')
    return lines + inner


def example(law) -> list[str]:
    """The registered example: as a deck writes it, or its numbers."""
    lines = deck_lines(law, law.example, DECK[law.family]) if law.family in DECK else None
    if lines:
        return ["## Example", "", "```toml", *lines, "```", ""]
    fields = [(n, v) for n, v in zip(law.parameters._fields, law.example) if isinstance(v, (int, float))]
    if not fields:
        return []
    shown = [f"`{n}` = {v:.6g}{'' if law.units[n] == '1' else ' ' + law.units[n]}" for n, v in fields if v == v]
    return ["## Example", "", ", ".join(shown) + ".", ""]


def page(law, picture: str | None) -> str:
    """The page of one law."""
    text = inspect.cleandoc(law.module.__doc__ or "")
    first, _, rest = text.partition("\n")
    lines = [f"# {law.name}", "", f"**{law.summary}**", "", *([first, ""] if law.summary != first else []), rest.strip(), ""]
    if picture:
        lines += [f"![{law.name}]({picture})", ""]
    lines += ["## Parameters", "", *parameters(law), *example(law), *validity(law)]
    lines += ["## References", "", *(f"* {cell(r)}" for r in law.references), ""]
    return "\n".join(explained(lines, "../../../theory/source_errors.md"))


def main() -> None:
    for family, (registry, title, words) in HEADS.items():
        folder = TARGET / family
        folder.mkdir(parents=True, exist_ok=True)
        laws = sorted(registry, key=lambda law: law.name)
        rows = [(f"[{law.name}]({family}/{law.name}.md)", cell(law.summary)) for law in laws]
        lines = [f"# {title}", "", words, "", *table(["law", "what it is"], rows)]
        lines += ["```{toctree}", ":hidden:", "", *(f"{family}/{law.name}" for law in laws), "```", ""]
        (TARGET / f"{family}.md").write_text("\n".join(lines), encoding="utf-8")
        for law in laws:
            picture = draw(law, folder) if family == "eos" else None
            (folder / f"{law.name}.md").write_text(page(law, picture), encoding="utf-8")


if __name__ == "__main__":
    main()
