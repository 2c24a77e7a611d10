"""Writes docs/generated/laws: a page per law from its file and its registration, with a picture for equations of state."""

import inspect
from pathlib import Path

import matplotlib
import numpy as np

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
from hugoniot.laws.eos.contract import EOS, reference_state
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials.tables import accepted
from hugoniot.plotting.style import COLOURS, QUIET, RC, new_axes
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import curve, shock
from hugoniot.theory.isentrope import isentrope

TARGET = Path(__file__).parent / "generated" / "laws"
HEADS = {
    "eos": (EOS, "Equations of state", "`[material.NAME.eos] law = ...`. State is density and specific internal energy."),
    "strength": (STRENGTH, "Strength", "`[material.NAME.strength] law = ...`: shear modulus and flow stress."),
    "fracture": (FRACTURE, "Fracture", "`[material.NAME.fracture] law = ...`: when a material parts, and what tension it bears."),
    "viscosity": (VISCOSITY, "Artificial viscosity", "`[solver.viscosity] law = ...`: $q = \\rho|\\Delta u|w$ in compression."),
    "burn": (BURN, "Burning", "Rates at which an explosive becomes products, by schedule or by state."),
    "mixture": (MIXTURE, "Mixtures", "How reactants and products share a zone; see [the theory](../../theory/mixtures.md)."),
    "transport": (TRANSPORT, "Physical viscosity", "Shear viscosity of a fluid in the structure of a shock."),
    "conduction": (CONDUCTION, "Heat conduction", "Heat conductivity of a fluid in the structure of a shock."),
}


def cell(value) -> str:
    return str(value).replace("|", "\\|").replace("\n", " ").replace("<", "&lt;").replace("_", "\\_").replace("*", "\\*")


def table(heads, rows) -> list[str]:
    return ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads), *("| " + " | ".join(row) + " |" for row in rows), ""]


def parameters(law) -> list[str]:
    """Parameters a deck gives, with units, defaults and meaning."""
    names, needed = accepted(law)
    rows = []
    for name in names:
        default = law.defaults.get(name)
        shown = "needed" if name in needed else "optional" if default is None or default != default else f"`{default}`"
        rows.append((f"`{name}`", cell(law.units.get(name, "1")) or "law", shown, cell(law.meaning.get(name, ""))))
    return table(["parameter", "unit", "default", "meaning"], rows) if rows else ["It has no parameters.", ""]


def validity(law) -> list[str]:
    """The box of states in which the example parameters are tested."""
    if not law.box:
        return []
    rows = [(f"`{name}`", f"{low:g}", f"{high:g}") for name, (low, high) in law.box.items()]
    return ["## Validity", "", "The contract tests hold the example inside this box (SI):", "", *table(["variable", "from", "to"], rows)]


def example(law) -> list[str]:
    """The registered example parameters."""
    fields = [(n, v) for n, v in zip(law.parameters._fields, law.example) if isinstance(v, (int, float))]
    if not fields:
        return []
    return ["## Example", "", ", ".join(f"`{n}` = {v:.6g}" for n, v in fields if v == v) + ".", ""]


def page(law, picture: str | None) -> str:
    """The page of one law."""
    text = inspect.cleandoc(law.module.__doc__ or "")
    first, _, rest = text.partition("\n")
    lines = [f"# {law.name}", "", f"**{first}**", "", rest.strip(), ""]
    if picture:
        lines += [f"![{law.name}]({picture})", ""]
    lines += ["## Parameters", "", *parameters(law), *example(law), *validity(law)]
    lines += ["## References", "", *(f"* {cell(r)}" for r in law.references), ""]
    return "\n".join(lines)


def hugoniot_points(law):
    """(up, p) from rest up to the sound speed, or over the densities of the law's box if it ends before; None if it gives neither."""
    rho0 = float(reference_state(law.example)[0])
    states = curve(law.example)
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


def shown_pressure(p) -> tuple[float, str]:
    return next(((f, u) for f, u in ((1e-9, "GPa"), (1e-6, "MPa"), (1e-3, "kPa")) if np.max(p) * f >= 1.0), (1.0, "Pa"))


def draw(law, target: Path) -> str | None:
    """P-up Hugoniot of the example from rest, or for products the isentrope from the CJ point; None where there is neither."""
    with matplotlib.rc_context({**RC, "savefig.dpi": 130}):
        ax = new_axes(4.6, 3.0)
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
                return None
            factor, unit = shown_pressure(found[1])
            fast = found[0][-1] >= 1000.0
            ax.plot(found[0] * (1e-3 if fast else 1.0), found[1] * factor, color=COLOURS[0])
            ax.set(xlabel=f"particle velocity ({'km/s' if fast else 'm/s'})", ylabel=f"pressure ({unit})", xlim=(0, None), ylim=(0, None))
            ax.set_title("Hugoniot of the example from rest", loc="left", color=QUIET, fontsize=8.5)
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
