"""What the commands of `hugoniot eos` are given: materials by name or file, states as "pressure = 10 GPa", error bars."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from hugoniot.cli.show import number_or_text, quantity
from hugoniot.errors import DeckError, DeckProblem, FileTrouble
from hugoniot.laws.eos.contract import EOS
from hugoniot.materials.material import Material

UNITS = {"pressure": "Pa", "density": "kg/m^3", "particle_velocity": "m/s", "shock_velocity": "m/s", "velocity": "m/s", "temperature": "K",
         "energy": "J/kg"}


@dataclass(frozen=True)
class Subject:
    """A material and, from the library, its unreacted explosive, its title, the names under which points are kept
    and its rows."""

    material: Material
    title: str = ""
    unreacted: Any = None
    names: tuple[str, ...] = ()
    rows: tuple[str, ...] = ()

    @property
    def reacted(self) -> bool:
        """Whether its equation of state is that of detonation products: by its law, or because the chemical energy is stated."""
        return "reacted" in EOS.of(self.material.eos).flags or self.material.detonation_energy is not None


def find_material(text: str) -> Subject:
    """A material of the library by name, alias or row, or of a TOML file: `steel.toml`, or `deck.toml:flyer_metal` for one of several."""
    path, _, inside = text.rpartition(":") if ".toml:" in text else (text, "", "")
    if path.endswith(".toml"):
        made = _from_file(Path(path), inside)
        return Subject(made.material, made.title, made.unreacted)
    if Path(text).suffix.lower() in (".csv", ".h5", ".hdf5", ".ses", ".301") and Path(text).exists():
        raise DeckError.single("command line", None, text, "is a table, not a material",
                               f'write a TOML file with [eos], law = "table", file = "{Path(text).name}", and name that')
    from hugoniot.materials.library import entry

    found = entry(text)
    return Subject(found.material, found.title, found.unreacted, (found.material.name, found.title, *found.aliases), tuple(found.rows))


def find_inert(text: str) -> Subject:
    """As `find_material`, for a question about shocks: an explosive stands for its unreacted self."""
    subject = find_material(text)
    if not subject.reacted:
        return subject
    if subject.unreacted is None:
        raise DeckError.single("command line", None, text, "only detonation products are given, no unreacted explosive",
                               "hugoniot eos cj is for the products; name a material with an inert equation of state")
    material = replace(subject.material, eos=subject.unreacted, name=f"{subject.material.name} (unreacted)")
    return replace(subject, material=material, title=subject.title and f"{subject.title} (unreacted)")


def find_reactive(text: str, rate: str | None = None) -> tuple[Subject, list[str]]:
    """An explosive with a rate, and what must be said about it.

    A `rate` given on the command line goes before the material's burn law; where the library gives an explosive no rate, its
    calibration with a rate (the material "LX-17 reactive") is taken.
    """
    from hugoniot.laws.burn.contract import BURN

    subject = find_material(text)
    if rate:
        return replace(subject, material=replace(subject.material, burn=read_rate(rate))), []
    burn = subject.material.burn
    if burn is not None and not {"programmed", "instantaneous"} & BURN.of(burn).flags:
        return subject, []
    try:
        return find_material(f"{text} reactive"), [f"'{text} reactive' is used: products, unreacted explosive and rate of one calibration"]
    except DeckError as error:
        what = ("has no burn law" if burn is None else "has a programmed burn only" if "programmed" in BURN.of(burn).flags else
                "has a burn law without a rate")
        hint = error.problems[0].hint if "rate constants" in error.problems[0].message else ""
        raise DeckError.single("command line", None, text, f"{what}, and the library has no rate for it",
                               f"{hint + '; ' if hint else ''}give --rate, or a TOML file with [burn]") from None


def read_rate(text: str) -> Any:
    """Parameters of a burn law from "pressure_power: rate_constant = 2e6 1/s, pressure_exponent = 0"."""
    from hugoniot.laws.burn.contract import BURN
    from hugoniot.materials.collect import Collector
    from hugoniot.materials.law_reader import read_law

    name, _, rest = text.partition(":")
    table: dict[str, Any] = {"law": name.strip()}
    for part in filter(str.strip, rest.split(",")):
        key, equals, value = (piece.strip() for piece in part.partition("="))
        if not equals:
            raise DeckError.single("command line", None, "--rate", f"'{part.strip()[:60]}' gives no parameter",
                                   'write "LAW: name = value, name = value"')
        table[key] = number_or_text(value)
    problems: list[DeckProblem] = []
    found = read_law(BURN, table, Collector(problems, "command line", lambda path: None), ("--rate",))
    if found is None:
        raise DeckError(problems)
    return found


def _from_file(path: Path, inside: str):
    from hugoniot.materials.users import read_materials

    if not path.exists():
        raise FileTrouble(f"cannot read {path}: there is no such file; give a name of the library (hugoniot material list) or a TOML file")
    found = read_materials(path)
    name = inside or (next(iter(found)) if len(found) == 1 else "")
    if name not in found:
        raise DeckError.single(path, None, "material", f"the file holds several materials: {', '.join(found)}",
                               f"name one, such as {path}:{next(iter(found))}")
    return found[name]


def one_state(text: str, where: str = "--at") -> dict[str, float]:
    """{"pressure": 1e10} from "pressure = 10 GPa"; one of pressure, density, particle_velocity, shock_velocity."""
    found = several_states(text, where, ("pressure", "density", "particle_velocity", "shock_velocity"))
    if len(found) != 1:
        raise DeckError.single("command line", None, where, f"names {len(found)} values", 'give one, such as "pressure = 10 GPa"')
    return found


def several_states(text: str, where: str, known=("density", "pressure", "energy", "temperature", "velocity")) -> dict[str, float]:
    """{"density": 1000.0, "velocity": 0.0} from "density = 1 g/cm^3, velocity = 0"."""
    found: dict[str, float] = {}
    for part in text.split(","):
        name, equals, value = (piece.strip() for piece in part.partition("="))
        name = name.replace(" ", "_").replace("-", "_")
        if not equals or name not in known:
            near = _near(name, known)
            raise DeckError.single("command line", None, where, f"'{part.strip()[:60]}' does not name a state",
                                   f'{near}write "{known[0]} = {_EXAMPLE[known[0]]}"')
        found[name] = quantity(value, UNITS[name], f"{where} {name}")
    return found


def error_bars(texts: list[str] | None) -> dict[str, str]:
    """{"copper.c0": "20 m/s"} from options such as "copper.c0 = 20 m/s" or "velocity = 5 m/s"; the caller knows the units."""
    found: dict[str, str] = {}
    for text in texts or ():
        name, equals, value = (piece.strip() for piece in text.partition("="))
        if not equals:
            raise DeckError.single("command line", None, "--error", f"'{text[:60]}' is not an error bar",
                                   'write "velocity = 5 m/s" or "copper.c0 = 20 m/s"')
        found[name] = value
    return found


_EXAMPLE = {"pressure": "10 GPa", "density": "2700 kg/m^3"}


def _near(name, known):
    import difflib

    near = difflib.get_close_matches(name, known, n=1)
    return f"did you mean '{near[0]}'? " if near else ""
