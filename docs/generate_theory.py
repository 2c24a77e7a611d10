"""Writes docs/generated/tools: a page per tool of hugoniot.theory and per exact solution, from their files.

The equations are stated once, in the files that compute them; the pages add the functions and the parameters of exact solutions.
"""

import importlib
import inspect
import re
from pathlib import Path

from hugoniot.theory.exact import SOLUTIONS, describe, parameter_unit

TARGET = Path(__file__).parent / "generated" / "tools"
# page: (title, modules whose equations it shows, module whose functions it lists, commands)
TOOLS = {
    "states": ("States", ("theory.states",), "theory.states", ("eos show", "eos table")),
    "hugoniots": ("Hugoniots", ("theory.jump", "theory.hugoniot"), "theory.hugoniot", ("eos hugoniot", "eos show --at")),
    "isentropes": ("Isentropes and release", ("theory.expansion", "theory.isentrope"), "theory.isentrope", ("eos isentrope",)),
    "riemann": ("Riemann problem of two laws", ("theory.riemann",), "theory.riemann", ("eos riemann",)),
    "impedance": ("Impedance matching", ("theory.impedance",), "theory.impedance", ("eos match", "eos match --ring-up")),
    "uncertainty": ("Error bars", ("theory.uncertainty",), "theory.uncertainty", ("eos match --error",)),
    "waves": ("Waves in time and space", ("theory.waves",), "theory.waves", ("eos match --thickness",)),
    "chapman_jouguet": ("Chapman-Jouguet state and detonation Hugoniot", ("theory.chapman_jouguet",), "theory.chapman_jouguet",
                        ("eos cj", "eos hugoniot --reaction")),
    "znd": ("Reaction zones", ("theory.reaction_zone", "theory.znd"), "theory.znd", ("eos znd",)),
    "mixtures": ("Mixtures of reactants and products", ("theory.mixture",), "theory.mixture", ("eos mixture",)),
    "characteristics": ("Characteristics with reaction", ("theory.characteristics",), "theory.characteristics", ()),
    "second_shock": ("Second shock", ("theory.second_shock",), "theory.second_shock", ("eos second-shock",)),
    "shock_lines": ("Rayleigh and Fanno lines", ("theory.shock_lines",), "theory.shock_lines", ("eos lines",)),
    "gurney": ("Metal driven by explosives", ("theory.exact.plate_push",), "theory.exact.plate_push", ("eos gurney",)),
    "fits": ("Fits", ("theory.fits",), "theory.fits", ("eos fit", "eos fit-jwl", "eos fit-gamma")),
    "stability": ("Stability of detonations", ("theory.stability", "theory.normal_modes"), "theory.stability", ("eos stability",)),
    "sesame": ("SESAME files by their tables", ("materials.sesame", "materials.table_repair"), "materials.sesame", ("eos sesame",)),
    "converters": ("From other data to Herrmann's series", ("laws.eos.converters",), "laws.eos.converters", ("eos convert",)),
}
TOLD = {"sesame": "From Python: `from hugoniot.materials import sesame, tables_io`.",
        "converters": "From Python: `from hugoniot.laws.eos import converters`.",
        "mixtures": "The equations are given under [mixtures](../../theory/mixtures.md).",
        "characteristics": "Called from Python: `from hugoniot.theory import characteristics`."}
_ROW = re.compile(r"^(\S.{0,70}?) {2,}(\S.*)$")


def words(docstring: str | None) -> str:
    """A docstring as Markdown: lines `name   meaning`, with what is indented below them, become a list."""
    out: list[str] = []
    listed = False
    for line in inspect.cleandoc(docstring or "").splitlines():
        row = _ROW.match(line) if "$" not in line.split("  ")[0] and not line.startswith(("*", "|", "$")) else None
        if row:
            out += [] if listed else [""]
            out.append(f"* `{row[1]}`: {row[2]}")
            listed = True
        elif listed and line.startswith(" "):
            out.append(f"  {line.strip()}")
        else:
            out += [""] if listed and line else []
            out.append(line)
            listed = False
    return "\n".join(out).strip()


def explained(lines: list[str], errors: str) -> list[str]:
    """A page with a line that says where its labels of source errors, such as K-E4, are listed; `errors` is that page."""
    found = re.search(r"\b[WKHSJ]-E\d+\b", "\n".join(lines))
    return [*lines, f"Labels such as {found[0]} refer to [the list of source errors]({errors}).", ""] if found else lines


def module(name: str):
    return importlib.import_module(f"hugoniot.{name}")


def equations(names) -> list[str]:
    """The docstrings of modules: the first line bold, the derivation below."""
    lines = []
    for name in names:
        first, _, rest = inspect.cleandoc(module(name).__doc__ or "").partition("\n")
        lines += [f"**{first}**", "", rest.strip(), ""]
    return lines


def functions(name: str) -> list[str]:
    """Every public function and class of a module with its signature and docstring."""
    lines = ["## Functions", "", f"`hugoniot.{name}`:", ""]
    home = module(name)
    for key, value in vars(home).items():
        if key.startswith("_") or getattr(value, "__module__", "") != home.__name__ or not callable(value):
            continue
        kept = words(value.__doc__)
        if inspect.isclass(value):
            lines += [f"### {key}", "", kept, ""]
            continue
        call = re.sub(r"(hugoniot|collections|pathlib)\.[a-z_.]*", "", str(inspect.signature(value)))
        lines += [f"### {key}", "", "```python", key + call, "```", "", kept, ""]
    return lines


def tool(key: str) -> str:
    title, shown, home, commands = TOOLS[key]
    lines = [f"# {title}", "", *equations(shown)]
    if commands:
        lines += ["On the command line: " + ", ".join(f"`hugoniot {c}`" for c in commands) + "; what it prints is described under "
                  "[questions answered without a mesh](../../theory/eos_tools.md).", ""]
    if key in TOLD:
        lines += [TOLD[key], ""]
    return "\n".join(explained([*lines, *functions(home)], "../../theory/source_errors.md"))


def parameters(name: str) -> list[str]:
    """Parameters of an exact solution with units and defaults."""
    rows = []
    for word, parameter in inspect.signature(SOLUTIONS[name]).parameters.items():
        default = "required" if parameter.default is inspect.Parameter.empty else f"`{parameter.default}`".replace("|", "\\|")
        rows.append(f"| `{word}` | {parameter_unit(word)} | {default} |")
    return ["| parameter | unit | default |", "|---|---|---|", *rows, ""] if rows else ["It has no parameters.", ""]


def exact(home: str, names: list[str]) -> str:
    lines = [f"# {home.rpartition('.')[2]}", "", *equations([home])]
    for name in names:
        lines += [f"## hugoniot exact {name}", "", words(SOLUTIONS[name].__doc__), "", *parameters(name)]
    return "\n".join(explained(lines, "../../../theory/source_errors.md"))


def main() -> None:
    (TARGET / "exact").mkdir(parents=True, exist_ok=True)
    for key in TOOLS:
        (TARGET / f"{key}.md").write_text(tool(key) + "\n", encoding="utf-8")
    homes: dict[str, list[str]] = {}
    for name, function in SOLUTIONS.items():
        homes.setdefault(function.__module__.removeprefix("hugoniot."), []).append(name)
    for home, names in homes.items():
        (TARGET / "exact" / f"{home.rpartition('.')[2]}.md").write_text(exact(home, names) + "\n", encoding="utf-8")
    rows = [f"| [{title}](tools/{key}.md) | {', '.join(f'`{c}`' for c in commands) or 'Python only'} |"
            for key, (title, _, _, commands) in TOOLS.items()]
    lines = ["# Tools without a mesh, one by one", "", "Equations, functions and sources of each tool, from its source file.", "",
             "| tool | command |", "|---|---|", *rows, "", "```{toctree}", ":hidden:", "", *(f"tools/{key}" for key in TOOLS), "```", ""]
    (TARGET.parent / "tools.md").write_text("\n".join(lines), encoding="utf-8")
    rows = [f"| [{name}](tools/exact/{function.__module__.rpartition('.')[2]}.md) | {describe(name)} |"
            for name, function in SOLUTIONS.items()]
    pages = [f"tools/exact/{home.rpartition('.')[2]}" for home in sorted(homes)]
    lines = ["# Exact solutions, one by one", "", "See [exact solutions](../theory/exact_solutions.md) for how to call them.", "",
             "| solution | what it is |", "|---|---|", *rows, "", "```{toctree}", ":hidden:", "", *pages, "```", ""]
    (TARGET.parent / "exact.md").write_text("\n".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main()
