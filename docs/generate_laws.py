"""Writes docs/generated/laws: a page per law from its file and its registration, with a picture (law_pictures) for equations of state."""

import dis
import inspect
import re
from pathlib import Path

import numpy as np
from law_pictures import draw
from law_words import CAPTIONS, FAMILIES, GROUPS, INSTEAD, KEYS_BESIDE, MATERIALS, OWN_SYMBOLS, QUANTITIES, SYMBOLS, WHERE_SET, WRITTEN
from source_labels import explained

import hugoniot.laws.burn
import hugoniot.laws.eos
import hugoniot.laws.fracture
import hugoniot.laws.mixture
import hugoniot.laws.strength
import hugoniot.laws.transport
import hugoniot.laws.viscosity  # noqa: F401
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import EOS, density_limits, particle_velocity_limit
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials.tables import accepted
from hugoniot.units import format_si, parse

TARGET = Path(__file__).parent / "generated" / "laws"
REGISTRIES = {"eos": EOS, "strength": STRENGTH, "fracture": FRACTURE, "viscosity": VISCOSITY, "burn": BURN, "mixture": MIXTURE,
              "transport": TRANSPORT, "conduction": CONDUCTION}
ERRORS = "../../../theory/source_errors.md"


def cell(value) -> str:
    parts = str(value).replace("|", "\\|").replace("\n", " ").split("`")      # every second part is code, which needs no escapes
    parts[::2] = (part.replace("<", "&lt;").replace("_", "\\_").replace("*", "\\*") for part in parts[::2])
    return "`".join(parts)


def table(heads, rows) -> list[str]:
    return ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads), *("| " + " | ".join(row) + " |" for row in rows), ""]


def marked(text: str) -> str:
    """A cell in which code in backticks keeps its underscores."""
    return "`".join(part if k % 2 else cell(part) for k, part in enumerate(text.split("`")))


def parameters(law) -> list[str]:
    """Parameters in a deck: symbols of the equations where they are known, units, defaults and meanings."""
    names, needed = accepted(law)
    if law.family == "mixture":
        rows = [[f"`{name}`", WHERE_SET[name], marked(law.meaning[name])] for name in law.parameters._fields]
        if law.name in KEYS_BESIDE:
            key, given, meaning, _ = KEYS_BESIDE[law.name]
            rows.append([f"`{key}`", given, meaning])
        return table(["parameter", "given by", "meaning"], rows)
    symbols = {**SYMBOLS, **OWN_SYMBOLS.get(law.name, {})} if law.family == "eos" else {}
    rows, order = [], law.parameters._fields
    key, meaning, after = INSTEAD.get(law.name, ("", "", ""))
    required = f"required without `{key}`" if key else "required"
    for name in sorted(names, key=lambda n: (n not in needed, order.index(n) if n in order else len(order))):
        default, unit = law.defaults.get(name), law.units.get(name, "1")
        shown = required if name in needed else "optional" if default is None or default != default \
            else f"`{default:.6g}`" if type(default) is float else f"`{default}`"
        symbol = f"${symbols[name]}$" if name in symbols else ""
        unit = {"1": "–", "text": "–", "law": "equation of state", "": "equation of state"}.get(unit, cell(unit))
        rows.append([f"`{name}`", *([symbol] if symbols else []), unit, shown, marked(law.meaning.get(name, ""))])
    if not rows:
        return ["The law has no parameters.", ""]
    if key:
        rows.insert(0, [f"`{key}`", *([""] if symbols else []), "–", "optional", meaning])
    lines = table(["parameter", *(["symbol"] if symbols else []), "unit", "default", "meaning"], rows)
    lines += [after, ""] if after else []
    if law.family == "eos" and "base" in names:
        lines += ["`base` is a table, as in the example, or the name of a material of the library.", ""]
    return lines


def plain(value: float) -> str:
    return re.sub(r"e\+?(-?)0*", r"e\1", f"{value:g}")


def validity(law) -> list[str]:
    """The limits of an equation of state, and the box of states in which any law is tested with its example."""
    box = [(*QUANTITIES.get(f"{law.family}.{key}", QUANTITIES.get(key)), *ends) for key, ends in law.box.items()]
    if law.family == "eos":
        (low, high), (cold, hot) = law.box["rho"], law.box["e"]
        ranges = f"densities from {plain(low)} to {plain(high)} kg/m³ and energies from {plain(cold * 1e-6)} to {plain(hot * 1e-6)} MJ/kg"
        shown = [] if "energy_limits" in law.functions else [f"The law is tested with the parameters of the example for {ranges}.", ""]
        return ["## Limits", "", *limits(law), *shown]
    if "scheduled" in law.functions:      # a burn law that depends on the lighting time: its states say nothing of a run
        return []
    used = arguments(law)
    rows = [(f"{name} ({unit})" if unit else name, plain(low * factor), plain(high * factor))
            for key, (name, unit, factor, low, high) in zip(law.box, box) if key in used]
    given = "the parameters of the example" if accepted(law)[1] else "its default parameters"
    lines = ["## Tested range", "", f"The law is tested with {given} for these states:", ""]
    return [*lines, *table(["quantity", "from", "to"], rows)] if rows and accepted(law)[0] else []


def arguments(law) -> set[str]:
    """The arguments that the law's functions read: the functions of a family all take the same ones, and few laws need them all."""
    read: set[str] = set()
    for function in law.functions.values():
        for step in dis.get_instructions(function):
            if step.opname.startswith("LOAD_FAST"):
                read |= set(step.argval) if isinstance(step.argval, tuple) else {step.argval}
    return read


def rounded(value: float) -> str:
    return f"{float(f'{value:.4g}'):g}"


def limits(law) -> list[str]:
    """Where the formulas of the example end, what happens beyond, and which of temperature and entropy the law gives."""
    low, high = density_limits(law.example)
    fastest = particle_velocity_limit(law.example)
    least, most = f"above {rounded(low)}" if low > 0.0 else "", f"below {rounded(high)}" if high < np.inf else ""
    ends = f"its density must be {' and '.join(filter(None, (least, most)))} kg/m³ (with the parameters of the example)" \
        if least or most else ""
    ends = "it must lie inside the table" if "energy_limits" in law.functions else ends
    real = "its squared sound speed must be positive ($c^2 > 0$)"
    lines = [f"A state must meet two conditions: {ends}, and {real}." if ends else
             "With the parameters of the example any density is allowed at which the squared sound speed is positive ($c^2 > 0$)."]
    if np.isfinite(fastest):
        lines.append(f"The principal Hugoniot ends at a particle velocity of {rounded(fastest)} m/s.")
    lines.append("This is the range of the formulas; the data behind the parameters usually cover less. The command-line tools refuse a "
                 "state outside it, with an error message that gives the limit.")
    return [" ".join(lines), "", temperature(law), ""]


def temperature(law) -> str:
    """Which of temperature and entropy the law gives, and what they need."""
    gives, names = law.functions, accepted(law)[0]
    both = "Temperature and entropy are" if "entropy" in gives else "The temperature is"
    without = "" if "entropy" in gives else " The law has no entropy."
    if "temperature" not in gives:
        return "The law gives neither temperature nor entropy."
    if "base" in names:
        return f"{both} available where the base law gives {'them' if 'entropy' in gives else 'one'}.{without}"
    unknown = [n for n in ("specific_heat", "reference_temperature") if n in names and law.defaults.get(n, 0.0) != law.defaults.get(n, 0.0)]
    needed = [f"`{n}`" for n in unknown]
    return f"{both} available{' if ' + ' and '.join(needed) + (' are' if needed[1:] else ' is') + ' given' if needed else ''}.{without}"


def quantity(value: float, unit: str) -> str:
    """A value with its unit, in a larger common unit where no digits are lost."""
    shown = format_si(value, unit, 8)
    return shown if "kg/m3" not in shown and not shown.startswith("0.00") and parse(shown, unit) == value else f"{value:.10g} {unit}"


def settings(law, par) -> tuple[list[str], list[tuple[str, object]]] | None:
    """(lines `key = value`, laws inside) of a deck that give `par`; None where a deck's values are not kept in the parameters."""
    names, needed = accepted(law)
    given = dict(zip(par._fields, par))
    if any(n not in given or isinstance(given[n], (np.ndarray, tuple)) and law.units.get(n) != "law" for n in needed):
        return None
    lines, inner = [f'law = "{law.name}"'], []
    for name in names:
        value = given.get(name)
        if EOS.knows(value):
            inner.append((name, value))
        elif isinstance(value, (int, float)) and value == value and \
                (name in needed or value != law.defaults.get(name)) and (name, value) != ("gamma_slope", 0.0):
            unit = law.units.get(name, "1")
            bare = unit in ("1", "text") or "Pa^" in unit
            lines.append(f"{name} = {value:.10g}" if bare else f'{name} = "{quantity(value, unit)}"')
    return lines, inner


def deck_lines(law, par, where: str) -> list[str] | None:
    """The tables of a deck that give `par`; None where a deck's values are not kept in the parameters."""
    if (found := settings(law, par)) is None:
        return None
    lines = [f"[{where}]", *found[0]]
    for name, value in found[1]:
        lines += ["", *(deck_lines(EOS.of(value), value, f"{where}.{name}") or [])]
    return lines


def mixture_lines(law) -> list[str]:
    """The deck of a mixture law's example: the equations of state stand in tables of the material."""
    par, place = law.example, f"material.{MATERIALS['burn']}"
    lines = [f"[{place}]", f'mixture = "{law.name}"']
    if "detonation_energy" in par._fields:
        lines.append(f'detonation_energy = "{quantity(par.detonation_energy, "J/kg")}"')
    if law.name in KEYS_BESIDE:
        key, _, _, value = KEYS_BESIDE[law.name]
        lines.append(f'{key} = "{value}"')
    for name, key in (("reactants", "unreacted"), ("products", "eos")):
        if name in par._fields:
            inner = getattr(par, name)
            simple = " (ideal gas, for simplicity)" if EOS.of(inner).name == "ideal_gas" else ""
            lines += ["", f"# {name}{simple}", *(deck_lines(EOS.of(inner), inner, f"{place}.{key}") or [])]
    return lines


def example(law) -> list[str]:
    """The registered example, as a deck writes it."""
    family = law.family
    material = MATERIALS.get(law.name, MATERIALS.get(family))
    if family == "mixture":
        lines = mixture_lines(law)
    elif family in ("transport", "conduction"):
        found = settings(law, law.example)
        key = "viscosity" if family == "transport" else family
        lines = ["[transport.argon]", f"{key} = {{{', '.join(found[0])}}}"] if found else None
    else:
        where = "solver.viscosity" if family == "viscosity" else f"material.{material}.{family}"
        lines = WRITTEN[law.name] if law.name in WRITTEN else deck_lines(law, law.example, where)
    return ["## Example", "", "```toml", *lines, "```", ""] if lines else []


def text_and_source(law) -> tuple[str, str]:
    """(the description below the first line of the law's file, its source) from the docstring."""
    text = inspect.cleandoc(law.module.__doc__ or "")
    first, _, rest = text.partition("\n")
    rest, _, source = rest.partition("Source: ")
    source, _, after = source.partition("\n\n")
    body = f"{rest.strip()}\n\n{after.strip()}".strip()
    return (body if law.summary == first else f"{first}\n\n{body}"), source.strip()


def references(law, source: str) -> list[str]:
    """The source as the law's file states it, and the registered references it does not name."""
    others = [r for r in law.references if re.split(r"[ ,]", r)[0] not in source]
    begun = source if source.startswith("von ") else source[:1].upper() + source[1:]
    return ["## References", "", *([begun, ""] if begun else []), *(f"* {cell(r)}" for r in others), *([""] if others else [])]


def shared(law) -> list[str]:
    """A line that names the other laws whose equations stand on the same page."""
    others = [f"[`{other.name}`]({other.name}.md)" for other in REGISTRIES[law.family] if other.module is law.module and other is not law]
    if not others:
        return []
    names = " and ".join(filter(None, (", ".join(others[:-1]), others[-1])))
    return [f"The equations below are those of `{law.name}` and of {names}; the parameters are those of `{law.name}` alone.", ""]


def page(law, picture: str | None) -> str:
    """The page of one law."""
    text, source = text_and_source(law)
    if law.family == "eos":
        text = re.sub(r"`(\w+)`", lambda m: f"[{m[0]}]({m[1]}.md)" if m[1] in EOS.names() and m[1] != law.name else m[0], text)
    lines = [f"# {law.name}", "", f"**{law.summary}**", "", *shared(law), text, ""]
    if picture:
        lines += [f"```{{image}} {picture}", f":alt: {law.name}, the example", ":width: 480px", "```", ""]
        lines += [CAPTIONS[law.name], ""] if law.name in CAPTIONS else []
    lines += ["## Parameters", "", *parameters(law), *example(law), *validity(law), *references(law, source)]
    return "\n".join(explained(lines, ERRORS))


def listed(family: str, laws) -> list[str]:
    """The table of the laws of a family, with a heading for each group of the equations of state."""
    def rows(some):
        return table(["law", "description"], [(f"[{law.name}]({family}/{law.name}.md)", cell(law.summary)) for law in some])

    if family != "eos":
        return rows(laws)
    by_name, lines = {law.name: law for law in laws}, []
    for title, names in GROUPS.items():
        some = [by_name.pop(name) for name in names] if names else list(by_name.values())
        lines += [f"## {title}", "", *rows(some)] if some else []
    return lines


def main() -> None:
    for family, registry in REGISTRIES.items():
        title, words = FAMILIES[family]
        folder = TARGET / family
        folder.mkdir(parents=True, exist_ok=True)
        laws = sorted(registry, key=lambda law: law.name)
        lines = [f"# {title}", "", words, "", *listed(family, laws)]
        lines += ["```{toctree}", ":hidden:", "", *(f"{family}/{law.name}" for law in laws), "```", ""]
        (TARGET / f"{family}.md").write_text("\n".join(lines), encoding="utf-8")
        for law in laws:
            picture = draw(law, folder) if family == "eos" else None
            (folder / f"{law.name}.md").write_text(page(law, picture), encoding="utf-8")


if __name__ == "__main__":
    main()
