"""Writes docs/generated/laws: a page per law from its file and its registration, with a picture for equations of state."""

import inspect
from pathlib import Path

import matplotlib
import numpy as np
from generate_theory import explained

matplotlib.use("Agg")

import hugoniot.laws.burn
import hugoniot.laws.eos
import hugoniot.laws.fracture
import hugoniot.laws.mixture
import hugoniot.laws.strength
import hugoniot.laws.transport
import hugoniot.laws.viscosity  # noqa: F401
from hugoniot.errors import HugoniotError
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import (
    EOS,
    compacted,
    density_limits,
    gives,
    has_temperature,
    particle_velocity_limit,
    pressure,
    reference_state,
    remembered,
    unloading,
)
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials.tables import accepted
from hugoniot.plotting.style import COLOURS, QUIET, RC, label_lines, new_panels
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import curve, shock
from hugoniot.theory.isentrope import isentrope
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


def hugoniot_points(law):
    """(up, p) from rest up to the sound speed, or over the densities of the law's box if it ends before; None if it gives neither."""
    rho0 = float(reference_state(law.example)[0])
    states = curve(law.example, up_to=1.3 * end_inside(law) if end_inside(law) else None)
    if states.pressure[-1] > 0.1 * rho0 * states.shock_velocity[0] ** 2:
        return states.particle_velocity, states.pressure
    for share in (0.5, 0.4, 0.3, 0.2, 0.1):
        try:
            states = shock(law.example, density=np.linspace(rho0, rho0 + share * (law.box["rho"][1] - rho0), 121)[1:])
        except HugoniotError:
            continue
        if np.isfinite(states.pressure).all() and states.pressure[-1] > 0.0:
            return states.particle_velocity, states.pressure
    return None


def end_inside(law) -> float | None:
    """Particle velocity at which the Hugoniot of the law inside ends, m/s, if that of the law itself does not."""
    inner = getattr(law.example, "base", None)
    end = np.inf if inner is None else particle_velocity_limit(inner)
    return float(end) if np.isfinite(end) and not np.isfinite(particle_velocity_limit(law.example)) else None


def shown_pressure(p) -> tuple[float, str]:
    return next(((f, u) for f, u in ((1e-9, "GPa"), (1e-6, "MPa"), (1e-3, "kPa")) if np.max(p) * f >= 1.0), (1.0, "Pa"))


def energies(law) -> list[float]:
    """Rest and two hotter ones of the box, in J/kg; of products the box."""
    low, high = law.box["e"]
    rest = float(reference_state(law.example)[1])
    return [low, (low * high) ** 0.5, high] if "gas" in law.flags else sorted({rest, rest + 0.4 * (high - rest), high})


def lines_of_energy(law, ax) -> None:
    """Pressure over density at constant energy in the box of the tests; of a law around another one that law, dashed."""
    inner = getattr(law.example, "base", None)
    rest = float(reference_state(law.example)[0])
    low, high = (0.85 * rest, 1.3 * rest) if inner is not None else law.box["rho"]
    if law.name == "grain_contact":
        low, high = 0.9 * law.example.contact_density, 1.06 * law.example.contact_density
    if law.name == "tillotson":
        low, high = 0.3 * rest, 1.6 * rest      # it is meant for vapour too
    gas = "gas" in law.flags
    rho = np.geomspace(low, high, 301) if gas else np.linspace(low, high, 301)
    lines = [np.array([pressure(r, e, law.example) for r in rho.tolist()]) for e in energies(law)]
    factor, unit = shown_pressure(np.abs(lines))
    for k, (e, p) in enumerate(zip(energies(law), lines)):
        ax.plot(rho * 1e-3, np.where(p > 0.0, p, np.nan) * factor if gas else p * factor, color=COLOURS[k])
        if inner is not None:
            ax.plot(rho * 1e-3, [pressure(r, e, inner) * factor for r in rho.tolist()], color=COLOURS[k], ls=(0, (3, 2)), lw=0.8)
    if gas:
        ax.set(xscale="log", yscale="log")
        for axis in (ax.xaxis, ax.yaxis):
            axis.set_major_formatter(lambda value, _: f"{value:g}")
            axis.set_minor_formatter(lambda value, _: "")
    ax.margins(x=0.0)
    names = [f"{e * 1e-6:.3g} MJ/kg" for e in energies(law)]
    if gas:
        for k, name in enumerate(names):
            ax.annotate(name, (0.03, 0.80 + 0.085 * k), xycoords="axes fraction", color=COLOURS[k], fontsize=8.5, va="top")
    else:
        label_lines(ax, names, [p[-1] * factor for p in lines], COLOURS)
    ax.set(xlabel="density (g/cm³)", ylabel=f"pressure ({unit})")
    ax.set_title("at constant energy" + ("; dashed: the base law" if inner is not None else ""), loc="left", color=QUIET, fontsize=8.5)


def crushing(law, ax) -> None:
    """First loading at the rest energy up to closed pores, and elastic ways down from two points of it."""
    par = law.example
    start, e = (float(v) for v in reference_state(par))
    solid = float(reference_state(par.base)[0])
    rho = np.linspace(start, 1.03 * solid, 401)
    p = np.array([pressure(r, e, par) for r in rho.tolist()])
    ax.plot(rho * 1e-3, p * 1e-9, color=COLOURS[0])
    for share in (0.35, 0.7):
        k = int(np.argmin(np.abs(rho - (start + share * (solid - start)))))
        kept = unloading(remembered(compacted(0.0, rho[k], e, p[k], par), par))
        down = np.linspace(float(reference_state(kept)[0]), rho[k], 30)
        ax.plot(down * 1e-3, [pressure(r, e, kept) * 1e-9 for r in down.tolist()], color=COLOURS[1], lw=1.1)
    beyond = np.linspace(solid, rho[-1], 50)
    ax.plot(beyond * 1e-3, [pressure(r, e, par.base) * 1e-9 for r in beyond.tolist()], color=QUIET, lw=0.9, ls=(0, (3, 2)))
    ax.set(xlabel="density (g/cm³)", ylabel="pressure (GPa)", ylim=(0.0, 1.6e-9 * float(np.interp(solid, rho, p))))
    words = (("first loading", COLOURS[0]), ("unloading and reloading", COLOURS[1]), ("dashed: the solid", QUIET))
    for k, (text, colour) in enumerate(words):
        ax.annotate(text, (0.03, 0.97 - 0.085 * k), xycoords="axes fraction", va="top", color=colour, fontsize=8.5)
    ax.set_title("at the reference energy", loc="left", color=QUIET, fontsize=8.5)


def draw(law, target: Path) -> str:
    """P-up Hugoniot of the example from rest, or for products the isentrope from the CJ point, beside the pressure over density."""
    with matplotlib.rc_context({**RC, "savefig.dpi": 130}):
        ax, beside = new_panels(1, 2, 7.6, 3.0)[0]
        (crushing if "remembers" in law.flags else lines_of_energy)(law, beside)
        if "reacted" in law.flags:
            point = cj(law.example)
            rho0 = float(reference_state(law.example)[0])
            volume = np.geomspace(rho0 / point.state.density, 8.0, 120)
            p = isentrope(law.example, point.state, density=rho0 / volume).pressure
            ax.loglog(volume, p * 1e-9, color=COLOURS[0])
            ax.plot(volume[0], p[0] * 1e-9, "o", color=COLOURS[0], ms=4.5)
            ax.set(xlabel="relative volume", ylabel="pressure (GPa)")
            ax.set_xticks([1, 2, 4, 8], ["1", "2", "4", "8"])
            ax.minorticks_off()
            ax.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
            words = f"release from the CJ point, D = {point.detonation_velocity * 1e-3:.3f} km/s"
            ax.set_title(words, loc="left", color=QUIET, fontsize=8.5)
        else:
            found = hugoniot_points(law)
            if found is None:
                raise ValueError(f"{law.name}: the example has no Hugoniot to draw")
            factor, unit = shown_pressure(found[1])
            fast = found[0][-1] >= 1000.0
            ax.plot(found[0] * (1e-3 if fast else 1.0), found[1] * factor, color=COLOURS[0])
            ax.set(xlabel=f"particle velocity ({'km/s' if fast else 'm/s'})", ylabel=f"pressure ({unit})", xlim=(0, None), ylim=(0, None))
            words = "Hugoniot of the example from rest"
            if end_inside(law):
                inner = curve(law.example.base, up_to=0.999 * end_inside(law))
                up = inner.particle_velocity * (1e-3 if fast else 1.0)
                ax.plot(up, inner.pressure * factor, color=COLOURS[0], ls=(0, (3, 2)), lw=0.8)
                words = "Hugoniot from rest; dashed: the base law, to its limit"
            ax.set_title(words, loc="left", color=QUIET, fontsize=8.5)
        ax.get_figure().savefig(target / f"{law.name}.png")
    return f"{law.name}.png"


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
