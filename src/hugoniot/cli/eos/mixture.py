"""The report of `hugoniot eos mixture`: states, adiabats and frozen Hugoniots of reactants and products in one zone."""

from typing import Any, NamedTuple

import numpy as np
import typer

from hugoniot.cli.eos.burning import closure_of, mixture_of, whose_temperature
from hugoniot.cli.eos.input import Subject, find_material, one_state, several_states
from hugoniot.cli.eos.output import cell, deliver, echo_columns, echo_notes, notes, plain, write_csv
from hugoniot.cli.show import echo_json, echo_table, quantity
from hugoniot.cli.typed import refuse_idle
from hugoniot.errors import DeckError, HugoniotError, NoSolution, OutOfRange
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.theory import mixture as tool
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.mixture_shocks import chemical_potential, reacting_hugoniot

EQUILIBRIA = ("thermal_isolation", "thermal_equilibrium")
SHOWN = ("burn_fraction", "pressure", "density", "particle_velocity", "shock_velocity", "specific_internal_energy", "temperature",
         "sound_speed", "gruneisen", "adiabatic_exponent", "specific_heat", "volume_fraction")


class Question(NamedTuple):
    """What was asked, as typed."""

    at: str
    shocked: str
    fractions: str
    closures: list[str]
    adiabat: str | None
    burn_to: float | None
    hugoniot: str | None
    series: bool
    heat: str | None
    points: int
    reacted: float = 0.0


class Case(NamedTuple):
    """One closure: parameters, (density, energy) of the zone with Q at each burn fraction, a point of the reactants' isentrope, and the
    energy of the unreacted explosive at rest, with Q."""

    kind: str
    par: Any
    state: tuple[float, Any]
    reference: tuple[float, float]
    rest: float


def report(name: str, asked: Question, as_json, as_csv, plot) -> None:
    """Solve for every closure; print, write and draw what is asked."""
    if asked.reacted and asked.hugoniot is None:
        raise DeckError.single("command line", None, "--reacted", "applies to --hugoniot only", 'add --hugoniot "40 GPa"')
    if sum((asked.adiabat is not None, asked.hugoniot is not None, asked.series)) > 1:
        raise DeckError.single("command line", None, "mixture", "--adiabat, --hugoniot and --series cannot be combined", "give one of them")
    subject = find_material(name)
    fractions = [_fraction(part) for part in asked.fractions.split(",")]
    if len(fractions) > 1 and (asked.adiabat is not None or asked.hugoniot is not None):
        refuse_idle("beyond its first value, from which --adiabat and --hugoniot start", "--burn-fraction")
    kinds = [closure_of(kind) for kind in asked.closures] or ["thermal_isolation"] * asked.series or list(EQUILIBRIA)
    told = notes(subject)
    cases, answers, failed = [], [], []
    for kind in kinds:
        try:
            case = _case(subject, kind, asked, fractions)
            answer = None if asked.series else _answer(case, fractions, asked)
        except (NoSolution, OutOfRange) as error:
            if asked.closures:
                raise
            told.append(f"{kind}: {error}")
            failed.append(error)
            continue
        cases.append(case)
        answers.append(answer)
    if not cases:
        raise failed[0]
    if asked.series:
        _series(subject, cases[0], asked, as_json, as_csv, plot)
        return
    if plot:
        _draw(subject, cases, answers, asked, plot)
    told += [note for c, a in zip(cases, answers) for note in whose_temperature(c.par, a.table().get("temperature"))]
    tables = [(f"{subject.material.name}, {c.kind}", {**a.table(), **_potential(a)}) for c, a in zip(cases, answers)]
    if not deliver(tables, as_json=as_json, as_csv=as_csv, told=[told] * len(tables),
                   more=[{"closure": c.kind, "detonation_energy": c.par.detonation_energy, "energy_at_rest": c.rest} for c in cases]):
        return
    for case, (title, table) in zip(cases, tables):
        energy = cell("specific_internal_energy", case.par.detonation_energy)
        rest = cell("specific_internal_energy", case.rest)
        typer.echo(f"{title}, chemical energy {energy}, included in the internal energy (reference state of the unreacted explosive: "
                   f"{rest})")
        echo_columns({k: np.atleast_1d(table[k]) for k in SHOWN if table.get(k) is not None})
        typer.echo("")
    typer.echo("--json and --csv also give the states of both phases" + ("" if asked.hugoniot else " and the slopes of the pressure"))
    echo_notes(told)


def _potential(answer) -> dict[str, Any]:
    """The chemical potential of mixture states in equilibrium, where both laws have an entropy."""
    try:
        equal = isinstance(answer, tool.MixtureState) and "no_equilibrium" not in MIXTURE.of(answer.par).flags
        return {"chemical_potential": chemical_potential(answer)} if equal else {}
    except OutOfRange:
        return {}


def _fraction(text: str) -> float:
    value = quantity(text.strip(), "1", "--burn-fraction")
    if not 0.0 <= value <= 1.0:
        raise DeckError.single("command line", None, "--burn-fraction", f"{value:g} is not a mass fraction", "write 0 to 1")
    return value


def _case(subject: Subject, kind: str, asked: Question, fractions: list[float]) -> Case:
    par = mixture_of(subject, kind, quantity(asked.heat, "J/kg", "--heat") if asked.heat else None)
    if not hasattr(par, "reactants"):
        raise OutOfRange(f"a mixture of kind '{kind}' has no reactants: use thermal_isolation, thermal_equilibrium or weighted_pressures")
    ahead = Initial.at_rest(par.reactants)
    q = par.detonation_energy
    reference = (ahead.density, ahead.energy + q)
    if asked.shocked:
        behind = shock(par.reactants, ahead, **one_state(asked.shocked, "--shocked"))
        reference = (behind.density, behind.specific_internal_energy + q)
    if not asked.at:
        if not asked.shocked:
            start = "no state is given" if asked.hugoniot is None else "the state from which --hugoniot starts is not given"
            more = "" if asked.hugoniot is None else "; hugoniot eos hugoniot EXPLOSIVE --reaction gives the shocks from rest"
            raise DeckError.single("command line", None, "mixture", start,
                                   f'write --shocked "pressure = 20 GPa" or --at "density = 2.4 g/cm^3, energy = 3 MJ/kg"{more}')
        return Case(kind, par, reference, reference, ahead.energy + q)
    given = several_states(asked.at, "--at", ("density", "energy", "pressure", "temperature"))
    if len(given) != 2 or "density" not in given:
        raise DeckError.single("command line", None, "--at", "give the density of the mixture and its energy, pressure or "
                                                             "temperature",
                               'write "density = 2.4 g/cm^3, energy = 3 MJ/kg" or "density = 2.4 g/cm^3, pressure = 20 GPa"')
    rho = given.pop("density")
    if "energy" in given:
        return Case(kind, par, (rho, given["energy"] + ahead.energy + q), reference, ahead.energy + q)
    energies = np.array([tool.energy_with(rho, fraction, par, reference, **given) for fraction in fractions])
    return Case(kind, par, (rho, energies), reference, ahead.energy + q)


def _answer(case: Case, fractions: list[float], asked: Question):
    """A `MixtureState` of all burn fractions or along the adiabat, or a `FrozenHugoniot`."""
    if asked.adiabat is None and asked.hugoniot is None:
        return tool.solve(*case.state, np.array(fractions), case.par, case.reference)
    first = fractions[0]
    start = tool.solve(case.state[0], np.ravel(case.state[1])[0], first, case.par, case.reference)
    if asked.hugoniot is not None:
        top = quantity(asked.hugoniot, "Pa", "--hugoniot")
        if not top > float(start.pressure):
            raise DeckError.single("command line", None, "--hugoniot", f"the mixture is already at {cell('pressure', start.pressure)}",
                                   "give a higher pressure")
        pressures = np.linspace(float(start.pressure), top, asked.points)
        return _reacting(start, pressures[1:], asked.reacted) if asked.reacted else tool.frozen_hugoniot(start, pressures)
    v0, v1 = 1.0 / case.state[0], 1.0 / quantity(asked.adiabat or "", "kg/m^3", "--adiabat")
    if v1 == v0:
        raise DeckError.single("command line", None, "--adiabat", "the mixture already has that density", "give another one")
    last = first if asked.burn_to is None else asked.burn_to
    way = np.linspace(v0, v1, asked.points)
    return tool.adiabat(start, way, None if last == first else lambda v: min(1.0, max(0.0, first + (last - first) * (v - v0) / (v1 - v0))))


def _reacting(start, pressures, reacted: float):
    """The reacting Hugoniot from the least of the pressures on that a shock holds: below, the burning part would expand the explosive."""
    for k in range(len(pressures)):
        try:
            return reacting_hugoniot(start, pressures[k:], reacted)
        except NoSolution:
            if k == len(pressures) - 1:
                raise
    raise NoSolution("no pressure is given")


def _series(subject: Subject, case: Case, asked: Question, as_json, as_csv, plot) -> None:
    """The expansion about burn fraction 0, volumes and energies of both phases."""
    if plot or len(asked.closures) > 1 or case.kind != "thermal_isolation":
        raise DeckError.single("command line", None, "--series", "gives a table of coefficients, for thermal isolation only",
                               "omit --plot and the other closures")
    found = tool.vanishing_series(case.state[0], float(np.ravel(case.state[1])[0]), case.par)
    rows = {"reactant_volume": found.v_r, "reactant_energy": found.e_r, "product_volume": found.v_p, "product_energy": found.e_p}
    if as_csv:
        columns = {k: [*values, *[float("nan")] * (3 - len(values))] for k, values in rows.items()}
        write_csv(as_csv, [("", {"power": [0.0, 1.0, 2.0], **columns})])
    if as_json:
        echo_json({"material": subject.material.name, "closure": case.kind, "density": case.state[0],
                   "specific_internal_energy": case.state[1], **{k: [plain(float(v)) for v in values] for k, values in rows.items()},
                   "warnings": notes(subject)})
        return
    typer.echo(f"{subject.material.name}, {case.kind}: phases in powers of the burn fraction, m3/kg and J/kg")
    echo_table(["", "constant", "first power", "second power"],
               [[k.replace("_", " "), *(f"{v:.8g}" for v in values), *["-"] * (3 - len(values))] for k, values in rows.items()])


def _draw(subject: Subject, cases: list[Case], answers: list, asked: Question, path) -> None:
    from hugoniot.plotting.detonation import mixture_hugoniots, mixture_states
    from hugoniot.plotting.eos import save

    name = subject.material.name
    if asked.hugoniot is not None:
        save(mixture_hugoniots(name, [(c.kind, c.par.reactants, a) for c, a in zip(cases, answers)]), path)
    elif asked.adiabat is not None:
        save(mixture_states(name, [(c.kind, a) for c, a in zip(cases, answers)], "volume"), path)
    else:
        fine = np.linspace(0.0, 1.0, 61)
        curves = []
        for case in cases:
            try:
                curves.append((case.kind, tool.solve(*case.state, fine, case.par, case.reference)))
            except HugoniotError:  # only the asked fractions have states
                curves.append((case.kind, answers[len(curves)]))
        save(mixture_states(name, curves, "burn_fraction"), path)
