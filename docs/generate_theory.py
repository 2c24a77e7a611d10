"""Writes docs/generated/tools: a page per tool of hugoniot.theory and per exact solution, from their files.

The equations are stated once, in the docstrings of the files that compute them. A paragraph there that begins with "Implementation:" is for
developers and is not shown; one that begins with "Source:" goes to the end of the page.
"""

import importlib
import inspect
import re
from pathlib import Path

from source_labels import explained

from hugoniot.theory.exact import SOLUTIONS, describe, parameter_unit
from hugoniot.theory.exact.kenamond import kenamond

TARGET = Path(__file__).parent / "generated" / "tools"
# page: (title, modules whose equations it shows, modules whose functions it lists, commands)
TOOLS = {
    "states": ("States", ("theory.states",), "theory.states", ("eos show", "eos table")),
    "hugoniots": ("Hugoniots", ("theory.jump", "theory.hugoniot"), "theory.hugoniot", ("eos hugoniot", "eos show --at")),
    "isentropes": ("Isentropes and release", ("theory.expansion", "theory.isentrope"), "theory.isentrope", ("eos isentrope",)),
    "riemann": ("Riemann problem of two materials", ("theory.riemann",), "theory.riemann", ("eos riemann",)),
    "impedance": ("Impedance matching", ("theory.impedance",), "theory.impedance", ("eos match", "eos match --ring-up")),
    "uncertainty": ("Error bars", ("theory.uncertainty",), "theory.uncertainty", ("eos match --error",)),
    "waves": ("Wave diagrams", ("theory.waves",), "theory.waves", ("eos match --thickness",)),
    "chapman_jouguet": ("Chapman-Jouguet state and detonation Hugoniot", ("theory.chapman_jouguet",), "theory.chapman_jouguet",
                        ("eos cj", "eos hugoniot --reaction")),
    "znd": ("Reaction zones", ("theory.reaction_zone", "theory.znd"), "theory.znd", ("eos znd",)),
    "mixtures": ("Mixtures of reactants and products", ("theory.mixture",), "theory.mixture", ("eos mixture",)),
    "characteristics": ("Characteristics with reaction", ("theory.characteristics",), "theory.characteristics", ()),
    "second_shock": ("Second shock", ("theory.second_shock",), "theory.second_shock", ("eos second-shock",)),
    "shock_lines": ("Rayleigh and Fanno lines", ("theory.shock_lines",), "theory.shock_lines", ("eos lines",)),
    "gurney": ("Metal driven by explosives", ("theory.exact.plate_push",), "theory.exact.plate_push", ("eos gurney",)),
    "fits": ("Fits", ("theory.fits",), "theory.fits", ("eos fit", "eos fit-jwl", "eos fit-gamma")),
    "stability": ("Stability of detonations", ("theory.stability", "theory.normal_modes"), "theory.stability theory.normal_modes",
                  ("eos stability",)),
    "sesame": ("SESAME tables", ("materials.sesame", "materials.table_repair"), "materials.sesame", ("eos sesame",)),
    "converters": ("Conversion to Herrmann's series", ("laws.eos.converters",), "laws.eos.converters", ("eos convert",)),
}
# what a tool is for, above its equations
PURPOSES = {
    "states": "All tools take and return states of a material. A `States` object holds density, pressure, energy and velocity at one "
              "point or along a curve, and computes the temperature, the sound speed and other properties from the equation of state.",
    "hugoniots": "The states that a single shock can reach from a given initial state, for any equation of state: one state from its "
                 "pressure, particle velocity, shock velocity or density, or the whole curve.",
    "isentropes": "The states along an isentrope, for any equation of state: release from a shocked state to a pressure, a density, a "
                  "particle velocity or vacuum.",
    "riemann": "Two uniform states of any two materials meet at a plane: the waves that run into both, and the pressure and velocity at "
               "the contact between them. Use it for impacts, for shocks at an interface and to test solvers.",
    "impedance": "The pressure and velocity behind every shock and release as the wave from a flyer plate crosses a stack of layers, from "
                 "interface to interface, or reverberates in one of them.",
    "uncertainty": "The standard deviation of a result, such as the pressure of an impedance match, from those of its inputs.",
    "waves": "The waves in a stack of layers of given thickness after the impact of a flyer plate, in position and time: when and where "
             "they meet, what they leave behind and when a gap opens. The problem is planar and the materials are fluids (no strength).",
    "chapman_jouguet": "The CJ state of an explosive from the equation of state of its products, and the detonation Hugoniot with the "
                       "weak and overdriven detonations.",
    "znd": "The structure of a plane steady detonation between the shock and the end of the reaction (the model of Zeldovich, von Neumann "
           "and Doering), for any equation of state, mixture and burn law.",
    "mixtures": "The state of a partly burned explosive from the equations of state of reactants and products, with the slopes of its "
                "pressure, its adiabats and its Hugoniots without reaction.",
    "characteristics": "The relations along the characteristics of a reacting flow, with which a computed flow can be checked. They are "
                       "available from Python only.",
    "second_shock": "How much the Hugoniot of a second shock deviates from the principal Hugoniot, for materials that follow Wilkins' "
                    "quadratic equation of state at moderate compression.",
    "shock_lines": "The Rayleigh line of a shock, on which mass and momentum are conserved, and its Fanno line, on which mass and energy "
                   "are. The lines help to interpret the states inside a viscous or conducting shock.",
    "gurney": "The velocity of a metal plate, cylinder or sphere driven by an explosive, from Gurney's formulas, and the motion of "
              "a plate at the end of a slab of explosive.",
    "fits": "Fits to data: a Us-up relation to shock velocities, a JWL equation of state to a CJ state and an expansion curve, and a "
            "Grüneisen parameter to a shock state.",
    "stability": "Whether a plane detonation is stable against small disturbances that vary in its direction of travel only: the "
                 "growth rates and frequencies of its modes.",
    "sesame": "Reading of SESAME files, with a check of the sums of partial tables and a repair of tables from which no temperature can "
              "be computed.",
    "converters": "Conversion of Hugoniot fits and elastic constants to the coefficients of Herrmann's series, the law `herrmann_series`, "
                  "and of a linear Us-up relation to the law `wilkins_cubic`.",
}
# public functions of the tools that serve other modules only, and those that have a page of their own
FOR_DEVELOPERS = {"states.has", "states.evaluate", "isentrope.expansion_to", "isentrope.grid", "isentrope.elastic", "fits.read_columns",
                  "znd.zone_of", "sesame.looks_like", "impedance.first_jump", "mixture.unburned_row", "stability.nearest",
                  "stability.growing", "plate_push.plate_push"}
MEMBERS_FOR_DEVELOPERS = {"table", "mixed", "perturbation"}
MATERIALS = (' As material the functions accept one from the library, such as `hugoniot.materials.library.find("copper")`, or the '
             'parameters of an equation of state.')
INITIAL = " The class `Initial`, for the state ahead of a shock, is in `hugoniot.theory.upstream`."
# module of exact solutions: title of its page
TITLES = {
    "blake": "Blake's cavity", "coggeshall": "Coggeshall's compression in two dimensions",
    "coggeshall_flows": "Coggeshall's flows without shocks", "coggeshall_shocks": "Coggeshall's flows with a shock",
    "double_burgers": "Standing wave in a gamma = 3 gas", "dsd": "Detonation shock dynamics", "dsd_start": "Rate stick from a plane front",
    "ehep": "Escape of detonation products", "elastic_plastic_piston": "Elastic-plastic piston",
    "fickett_rivard": "Steady reaction zone", "guderley": "Guderley's converging shock", "kenamond": "Burn times",
    "kidder": "Kidder's shell", "mader": "Taylor wave", "meeting_streams": "Two supersonic streams", "noh": "Noh's implosion",
    "noh_material": "Noh's implosion of any material", "plate_push": "Plate driven by an explosive",
    "riemann_ideal": "Riemann problem of ideal and stiffened gases", "saltzman": "Piston against a wall", "sedov": "Point explosion",
    "shell_stopping": "Stopping shell", "simple_wave": "Simple waves", "uniform_collapse": "Uniform collapse",
    "woodward_colella": "Interacting blast waves",
}
EQUATIONS_ELSEWHERE = {"mixtures": "The equations are given under [mixtures](../../theory/mixtures.md)."}
FUNCTIONS_ELSEWHERE = {"gurney": "The motion of the end-on plate is the [exact solution `plate_push`](exact/plate_push.md)."}
CALLS = """On the command line a parameter is written `name=value`, with a unit where it has one. The command prints the numbers named
above and, with `--time T`, also the fields at the time `T` of a solution that depends on time.
[Exact solutions](../../../theory/exact_solutions.md) describes the options.

In Python, `SOLUTIONS["{}"]` of `hugoniot.theory.exact` takes the same parameters and returns an object. Called with positions and a time,
this object returns the fields as arrays. Its attribute `numbers` is a dictionary of the numbers. Its method `jumps(time)` returns the
positions of shocks, contacts and surfaces, if the solution has any.

Positions are in m, times in s, densities in kg/m³, velocities in m/s, pressures and stresses in Pa and specific internal energies
(`energy`) in J/kg, or all quantities in another consistent set of units.
"""
_ROW = re.compile(r"^(\S.{0,70}?) {2,}(\S.*)$")


def rows_of(docstring: str | None) -> tuple[list[str], dict[str, str]]:
    """The lines of a docstring without its rows `name   meaning`, of which an empty line is left, and these as a dictionary."""
    kept: list[str] = []
    rows: dict[str, str] = {}
    last: tuple[str, ...] = ()
    for line in inspect.cleandoc(docstring or "").splitlines():
        row = _ROW.match(line) if "$" not in line.split("  ")[0] and not line.startswith(("*", "|", "$", " ")) else None
        if row:
            last = tuple(name.strip() for name in row[1].split(","))
            rows |= dict.fromkeys(last, row[2])
        elif last and line.startswith(" "):
            rows |= {name: f"{rows[name]} {line.strip()}" for name in last}
        else:
            last = ()
            kept.append(line)
    return kept, rows


def words(docstring: str | None) -> str:
    """A docstring as Markdown: lines `name   meaning`, with what is indented below them, become a list, and examples code."""
    out: list[str] = []
    listed = coded = False
    for line in inspect.cleandoc(docstring or "").splitlines() + [""]:
        if coded != line.startswith(">>> "):
            coded = not coded
            out.append("```pycon" if coded else "```")
        if coded:
            out.append(line)
            continue
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


def module(name: str):
    return importlib.import_module(f"hugoniot.{name}")


def divided(docstring: str | None) -> tuple[str, str, list[str]]:
    """(first line, text, sources) of a docstring, without its paragraphs for developers."""
    first, _, rest = inspect.cleandoc(docstring or "").partition("\n")
    paragraphs = [p for p in rest.strip().split("\n\n") if not p.startswith("Implementation:")]
    sources = [p.removeprefix("Source:").strip() for p in paragraphs if p.startswith("Source:")]
    return first, "\n\n".join(p for p in paragraphs if not p.startswith("Source:")), sources


def equations(names) -> tuple[list[str], list[str]]:
    """(equations, sources) in the docstrings of modules, without their first lines."""
    lines, sources = [], []
    for name in names:
        _, text, found = divided(module(name).__doc__)
        lines += [text, ""] if text else []
        sources += found
    return lines, sources


def cited(sources: list[str]) -> list[str]:
    lines = [" ".join(source.split()) for source in sources]
    lines = [f"{'* ' if len(lines) > 1 else ''}{line[:1].upper()}{line[1:]}" for line in lines]
    return ["## Source", "", *lines, ""] if lines else []


def call(key: str, function) -> str:
    """Name and parameters of a function with their defaults; their types and units stand in its docstring."""
    bare = [p.replace(annotation=inspect.Parameter.empty) for p in inspect.signature(function).parameters.values() if p.name != "self"]
    return key + re.sub(r"<function (\w+) at \w+>", r"\1", str(inspect.Signature(bare)))


def members(cls: type) -> list[str]:
    """Properties and methods of a class that its docstring does not name, each with the first paragraph of its own docstring."""
    lines = []
    for key, value in vars(cls).items():
        read = getattr(value, "fget", None) or getattr(value, "func", None)      # property, cached_property
        called = inspect.isfunction(value) and (not key.startswith("_") or key == "__call__")
        named = re.search("Called" if key == "__call__" else rf"`{key}`|(?m:^ *[\w, ]*\b{key}\b[\w, ]*   )", cls.__doc__ or "")
        if not (called or (read and not key.startswith("_"))) or named or key in MEMBERS_FOR_DEVELOPERS:
            continue
        meaning = " ".join(inspect.cleandoc((read or value).__doc__ or "").partition("\n\n")[0].split())
        shown_as = key if read else call("" if key == "__call__" else key, value)
        lines.append(f"* {'called with ' if key == '__call__' else ''}`{shown_as}`: {meaning}")
    return ["Properties and methods:", "", *lines, ""] if lines else []


def functions(name: str) -> list[str]:
    """Every public function and class of a module with its signature and docstring."""
    home, short = module(name), name.rpartition(".")[2]
    mine = [value for value in vars(home).values() if inspect.isfunction(value) and value.__module__ == home.__name__]
    taken = {word for value in mine for word in inspect.signature(value).parameters}
    material = MATERIALS if name.startswith("theory.") and taken & {"material", "layers"} else ""
    initial = INITIAL if "initial" in taken and "layers" not in taken else ""
    lines = [f"From `hugoniot.{name}`.{material}{initial}", ""]
    for key, value in vars(home).items():
        own = callable(value) and getattr(value, "__module__", "") == home.__name__
        if not own or key.startswith("_") or f"{short}.{key}" in FOR_DEVELOPERS:
            continue
        kept = words(value.__doc__)
        if inspect.isclass(value):
            made = [] if hasattr(value, "__dataclass_fields__") or hasattr(value, "_fields") else ["```python", call(key, value), "```", ""]
            lines += [f"### {key}", "", *made, kept, "", *members(value)]
            continue
        lines += [f"### {key}", "", "```python", call(key, value), "```", "", kept, ""]
    return lines


def tool(key: str) -> str:
    title, shown, home, commands = TOOLS[key]
    lines = [f"# {title}", "", PURPOSES[key], ""]
    if commands:
        lines += ["On the command line: " + ", ".join(f"`hugoniot {c}`" for c in commands) + ". The options and the output are described "
                  "under [tools without a mesh](../../theory/eos_tools.md).", ""]
    found, sources = equations(shown)
    lines += ["## Equations", "", *([EQUATIONS_ELSEWHERE[key], ""] if key in EQUATIONS_ELSEWHERE else []), *found]
    listed = ["## Functions", "", *(line for name in home.split() for line in functions(name))]
    listed += [FUNCTIONS_ELSEWHERE[key], ""] if key in FUNCTIONS_ELSEWHERE else []
    page = "\n".join(explained([*lines, *listed, *cited(sources)], "../../theory/source_errors.md"))
    return re.sub(r"\n{3,}", "\n\n", page)


def parameters(function, skip: tuple[str, ...] = ()) -> list[str]:
    """Parameters of an exact solution with units, defaults and what its docstring says of them; those of a record under dotted names."""
    meaning = rows_of(function.__doc__)[1]
    rows = []
    for word, parameter in inspect.signature(function).parameters.items():
        if word in skip:
            continue
        empty = inspect.Parameter.empty
        given = {word: parameter.default}
        if fields := getattr(parameter.annotation, "_fields", ()):
            usual = parameter.annotation._field_defaults
            rows += [f"| `{word}` |  |  | {meaning[word]} |"] if word in meaning else []
            given = {f"{word}.{f}": usual.get(f, empty) if parameter.default is empty else getattr(parameter.default, f) for f in fields}
        for name, value in given.items():
            default = "required" if value is empty else f"`{shown(value)}`" if value != "" else "none"
            unit = "degree" if name.endswith("_degrees") else parameter_unit(name.rpartition(".")[2])
            unit = "" if isinstance(value, str | bool) else unit
            rows.append(f"| `{name}` | {unit} | {default} | {meaning.get(name, '')} |")
    return ["| parameter | unit | default | meaning |", "|---|---|---|---|", *rows, ""] if rows else ["It takes no parameters.", ""]


def shown(value) -> str:
    """A default without the digits of a fraction that has no end, and with a power of ten for large numbers."""
    if not isinstance(value, float) or (len(repr(value)) <= 12 and abs(value) < 1e5):
        return str(value)
    return re.sub(r"e([+-])0*", lambda m: "e" + m[1].strip("+"), f"{value:.6g}")


def solution(name: str, alone: bool) -> list[str]:
    """The section of one exact solution: its parameters, fields and numbers; `alone`: the page has introduced it."""
    function = SOLUTIONS[name]
    kept, _ = rows_of(function.__doc__)
    first, _, rest = "\n".join(kept).partition("\n")
    lines = [f"## hugoniot exact {name}", "", *([] if alone else [first, ""]), *(parameters(function) if name != "kenamond" else [])]
    if name == "kenamond":
        for number, problem in kenamond().items():
            text = "\n".join(rows_of(problem.__doc__)[0])
            lines += [f"### problem={number}", "", re.sub(r"\n{3,}", "\n\n", text), "", *parameters(problem, skip=("points",))]
    text = re.sub(r"\b[a-z]+(_[a-z0-9]+)+\b(?![`(])", r"`\g<0>`", rest.strip()) if name != "kenamond" else rest.strip()
    return [*lines, text, ""]


def exact(home: str, names: list[str]) -> str:
    first, text, sources = divided(module(home).__doc__)
    lines = [f"# {TITLES[home.rpartition('.')[2]]}", "", first, "", text, ""]
    names = sorted(names, key=lambda name: not inspect.signature(SOLUTIONS[name]).parameters)
    for name in names:
        lines += solution(name, len(names) == 1)
    called = [] if names == ["kenamond"] or names == ["woodward_colella"] else ["## How to call it", "", CALLS.format(names[0])]
    page = "\n".join(explained([*lines, *called, *cited(sources)], "../../../theory/source_errors.md"))
    return re.sub(r"\n{3,}", "\n\n", page)


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
    lines = ["# Tools without a mesh, one by one", "",
             "Each page gives the purpose of a tool, its equations, its Python functions and its sources. The commands are described under "
             "[tools without a mesh](../theory/eos_tools.md).", "", "| tool | command |", "|---|---|", *rows, "",
             "```{toctree}", ":hidden:", "", *(f"tools/{key}" for key in TOOLS), "```", ""]
    (TARGET.parent / "tools.md").write_text("\n".join(lines), encoding="utf-8")
    rows = [f"| [{name}](tools/exact/{function.__module__.rpartition('.')[2]}.md) | {describe(name)} |"
            for name, function in SOLUTIONS.items()]
    pages = [f"tools/exact/{home.rpartition('.')[2]}" for home in sorted(homes)]
    lines = ["# Exact solutions, one by one", "",
             "Each page gives the problem, its solution, the parameters of the command and the source. The options of the command are "
             "described under [exact solutions](../theory/exact_solutions.md).", "",
             "| solution | problem |", "|---|---|", *rows, "", "```{toctree}", ":hidden:", "", *pages, "```", ""]
    (TARGET.parent / "exact.md").write_text("\n".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main()
