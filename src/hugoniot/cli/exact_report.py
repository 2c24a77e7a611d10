"""The report of `hugoniot exact`: builds a solution from what was typed, and prints, writes and draws it."""

import inspect
import sys
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import typer

from hugoniot.cli.eos.output import plain, row_of, words, write_csv
from hugoniot.cli.exact_input import listed, needed, parameters_of, points_of
from hugoniot.cli.show import echo_json, echo_table, quantity
from hugoniot.cli.typed import refuse_idle
from hugoniot.errors import DeckError, OutOfRange
from hugoniot.materials.collect import nearest
from hugoniot.theory.exact import SOLUTIONS, Solution, describe
from hugoniot.theory.exact.kenamond import kenamond
from hugoniot.theory.states import UNITS
from hugoniot.units import format_si

WORDS = {"velocity": "particle_velocity", "energy": "specific_internal_energy"}
DOMAINS = {"sod": (0.0, 1.0), "leblanc": (0.0, 9.0), "two_rarefactions": (0.0, 1.0), "collision": (0.0, 1.0), "water_gas": (0.0, 1.0),
           "howell_ball": (0.04, 0.11), "verney": (0.02, 0.11)}


class Grid(NamedTuple):
    """Where and when the fields are asked, as typed."""

    times: list[str]
    at: str
    start: str | None
    end: str | None
    points: int


def listing() -> list[dict]:
    """Every solution in a line with its source."""
    return [{"solution": name, "what": describe(name), "source": _source(function)} for name, function in SOLUTIONS.items()]


def _source(function: Callable) -> str:
    """The paragraph `Source: ...` of the module that holds a solution, in one line."""
    text = (sys.modules[function.__module__].__doc__ or "").partition("Source:")[2].partition("\n\n")[0]
    return " ".join(text.split())


def report(name: str, settings: list[str], grid: Grid, as_json, as_csv, plot) -> None:
    """Describe a solution, or give its fields."""
    if name not in SOLUTIONS:
        raise DeckError.single("command line", None, "exact", f"no exact solution is called '{name[:40]}'", nearest(name, SOLUTIONS))
    if name == "kenamond":
        _burn_times(settings, grid, as_json, as_csv, plot)
        return
    if not settings and not (grid.times or as_csv or plot) and needed(SOLUTIONS[name]):
        _introduce(name, as_json)
        return
    made, given = parameters_of(SOLUTIONS[name], settings)
    solution = made()
    if not isinstance(solution, Solution):
        if grid.times or grid.at or as_csv or plot:
            raise DeckError.single("command line", None, name, "is a set of reference numbers and has no fields", "ask for --json")
        refuse_idle(f"on {name}, a set of reference numbers", "--from", "--to", "--points")
        _data(name, solution, as_json)
        return
    times = [quantity(t, "s", "--time") for t in grid.times]
    asked = bool(as_csv or plot or grid.at)
    if solution.steady and asked and not times:
        times = [0.0]
    if name == "plate_push" and not times:
        times = np.linspace(0.0, 20.0 * solution.numbers["arrival_time"], 81).tolist() if as_csv or plot else []
    if name == "plate_push":
        refuse_idle("on plate_push, which is given against time", "--at", "--from", "--to", "--points")
    elif not (times or asked):
        refuse_idle("without --time, as no fields are given" if not solution.steady else "without --at, --csv or --plot",
                    "--from", "--to", "--points")
    states = [_history(solution, times)] if name == "plate_push" and times else _states(name, solution, times, given, grid)
    if asked and not states:
        raise DeckError.single("command line", None, "--time", "a table or picture of the fields needs a time", 'give --time "1 us"')
    if as_csv:
        write_csv(as_csv, [("", _stacked(states))])
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.exact import fields, history

        save(history(solution, states[0]) if name == "plate_push" else fields(solution, states), plot)
    if as_json:
        echo_json({"solution": name, "title": solution.title, "geometry": solution.geometry, "parameters": given,
                   "numbers": dict(solution.numbers), "times": list(solution.times), "source": _source(SOLUTIONS[name]),
                   "states": [{k: v if k == "jumps" else plain(v) for k, v in state.items()} for state in states]})
        return
    _tell(name, solution, given, states)


def _introduce(name: str, as_json) -> None:
    """A solution that has no usual parameters: what it is and what it must be given."""
    missing = needed(SOLUTIONS[name])
    if as_json:
        echo_json({"solution": name, "what": describe(name), "needed": missing, "source": _source(SOLUTIONS[name]), "states": []})
        return
    asks = [f"needs {', '.join(f'{k}=VALUE' for k in missing)}"] if missing else _problems()
    typer.echo("\n".join([inspect.cleandoc(SOLUTIONS[name].__doc__ or ""), "", *asks, f"source: {_source(SOLUTIONS[name])}"]))


def _problems() -> list[str]:
    """Kenamond's problems with their parameters and usual values, and how burn times are asked."""
    lines = []
    for number, function in kenamond().items():
        usual = {k: p.default for k, p in inspect.signature(function).parameters.items() if k != "points"}
        lines.append(f"problem={number}  {inspect.cleandoc(function.__doc__ or '').splitlines()[0]}")
        lines.append("           " + ", ".join(f"{k}={v}" for k, v in usual.items()))
    return [*lines, '', 'burn times need points: give --at "0, 4 m; 3 m, 2 m", or draw them with --plot burn.png']


def _tell(name: str, solution: Solution, given: dict, states: list[dict]) -> None:
    typer.echo(f"{solution.title} ({solution.geometry})")
    if not states:
        typer.echo(inspect.cleandoc(SOLUTIONS[name].__doc__ or "") + "\n")
        if given:
            echo_table(["parameter", "value", "unit"],
                       [(k, f"{v:.8g}" if isinstance(v, float) else v, listed(k, given)) for k, v in given.items()])
            typer.echo("")
    if solution.numbers:
        echo_table(["number", "value"], [(k, f"{v:.10g}") for k, v in solution.numbers.items()])
    if not states:
        holds = ("steady; --at, --csv or --plot gives the fields" if solution.steady
                 else f"holds for times {solution.span}; --time gives the fields")
        typer.echo(f"\n{holds}\nsource: {_source(SOLUTIONS[name])}")
    for state in states:
        if "jumps" in state:
            where = ", ".join(format_si(x, "m", 8) for x in state["jumps"]) or "none"
            when = "steady" if solution.steady else f"at {format_si(state['time'], 's')}"
            typer.echo(f"\n{when}; jumps at: {where}")
        _echo_fields({k: v for k, v in state.items() if k != "jumps" and np.ndim(v) == 1})


def _echo_fields(columns: dict) -> None:
    """About 25 rows in SI: a solution has no scale of its own, so that no other unit would suit all."""
    count = len(next(iter(columns.values())))
    chosen = sorted({int(round(i)) for i in np.linspace(0, count - 1, min(count, 25))})
    heads = [words(k) + (f", {UNITS[k]}" if UNITS.get(k, "1") != "1" else "") for k in columns]
    echo_table(heads, [["-" if np.isnan(v[i]) else f"{v[i]:.7g}" for v in columns.values()] for i in chosen])
    if count > len(chosen):
        typer.echo(f"{len(chosen)} of {count} positions shown; --csv and --json give all")


def _states(name: str, solution: Solution, times: list[float], given: dict, grid: Grid) -> list[dict]:
    """The fields at every time, over one interval of positions that holds what moves at any of them."""
    spans = [] if grid.at else [_span(name, solution, t, solution.jumps(t), given, grid) for t in times]
    low, high = (min(s[0] for s in spans), max(s[1] for s in spans)) if spans else (0.0, 0.0)
    return [_state(name, solution, t, low, high, grid) for t in times]


def _state(name: str, solution: Solution, time: float, low: float, high: float, grid: Grid) -> dict[str, Any]:
    """Positions, fields under the field's words and jumps at one time."""
    jumps = solution.jumps(time)
    if grid.at:
        places = points_of(grid.at, "--at", 2 if name == "coggeshall" else 1)
        if solution.geometry in ("cylindrical", "spherical") and not (places > 0.0).all():
            raise DeckError.single("command line", None, "--at", f"{float(places.min()):g} m is not a radius", "give positive values")
    else:
        line = np.linspace(low, high, grid.points)
        gap = 1e-9 * max(high - low, 1e-300)
        sides = [x + side for x in jumps for side in (-gap, gap) if low < x < high]
        line = np.sort(np.concatenate([line, sides]))
        if name == "coggeshall":
            places = np.column_stack([np.zeros_like(line), line])
        else:
            places = line if solution.geometry == "planar" else line[line > 0.0]
    fields = solution(places, time)
    found: dict[str, Any] = {"time": time, "jumps": list(jumps)}
    if places.ndim == 2:
        found |= {"radius": places[:, 0], "axial_position": places[:, 1]}
        velocity = fields.pop("velocity")
        found |= {"radial_velocity": velocity[:, 0], "axial_velocity": velocity[:, 1]}
    else:
        found["position"] = places
    return found | {WORDS.get(k, k): v for k, v in fields.items()}


def _span(name, solution: Solution, time, jumps, given: dict, grid: Grid) -> tuple[float, float]:
    """(first, last) position: as asked, the usual interval of a named problem, or around what moves."""
    low, high = solution.domain(time) if solution.domain else DOMAINS.get(name, (None, None))
    numbers = solution.numbers
    if "left_head" in numbers and low is None:
        x0 = float(given.get("x0", 0.0))
        low, high = x0 + 1.3 * min(numbers["left_head"], 0.0) * time, x0 + 1.3 * max(numbers["right_head"], 0.0) * time
    elif high is None:
        reach = [*jumps, *(float(given[k]) for k in ("length", "outer") if k in given)]
        ahead = [numbers[k] * time for k in ("head",) if k in numbers]
        if "escape_time" in numbers:
            ahead = [float(given["detonation_velocity"]) * time]
        if name == "piston_pulse":
            ahead = [1.2 * time * float(np.sqrt(given["gamma"] * given["pressure"] / given["density"]))]
        low, high = min(0.0, *(x for x in jumps)) if jumps else 0.0, max([1.4 * x for x in (*jumps, *ahead)] + reach, default=0.0)
        if name == "centred_rarefaction":
            low = -min(float(given["speed"]), numbers["escape_speed"]) * time
    low = quantity(grid.start, "m", "--from") if grid.start else low
    high = quantity(grid.end, "m", "--to") if grid.end else high
    if low is None or high is None or not high > low:
        why = "not both are given" if low is None or high is None else f"{high:.6g} m is not beyond {low:.6g} m"
        raise DeckError.single("command line", None, "--from, --to", f"positions are drawn from --from to --to, but {why}",
                               'give both, such as --from "0 m" --to "1 m", or --at')
    return low, high


def _history(solution: Solution, times: list[float]) -> dict[str, Any]:
    """Position, velocity and pressure of a driven plate against time."""
    rows = [solution(0.0, t) for t in times]
    return {"time": np.array(times), **{WORDS.get(k, k): np.array([float(r[k]) for r in rows]) for k in rows[0]}}


def _stacked(states: list[dict]) -> dict:
    """All times below each other as columns of one table."""
    if np.ndim(states[0]["time"]):
        return states[0]
    keys = [k for k in states[0] if k != "jumps"]
    sizes = [len(next(v for v in s.values() if isinstance(v, np.ndarray))) for s in states]
    return {k: np.concatenate([np.full(n, s[k]) if np.ndim(s[k]) == 0 else s[k] for s, n in zip(states, sizes)]) for k in keys}


def _data(name: str, reference, as_json) -> None:
    """A solution that is a set of reference numbers."""
    if as_json:
        echo_json({"solution": name, "source": _source(SOLUTIONS[name]), "numbers": reference._asdict()})
        return
    typer.echo(describe(name))
    echo_table(["", ""], [(k.replace("_", " "), v) for k, v in reference._asdict().items()])


def _burn_times(settings: list[str], grid: Grid, as_json, as_csv, plot) -> None:
    """Burn times of Kenamond's problems: the number of the problem is one of the parameters."""
    if grid.times:
        raise DeckError.single("command line", None, "--time", "does not apply to burn times, which are themselves the times of the "
                                                               "front", "omit --time")
    refuse_idle("on burn times, which are drawn in a square up to --to", "--from")
    if not plot:
        refuse_idle("on burn times without --plot", "--to", "--points")
    problems = kenamond()
    rest = [s for s in settings if not s.replace(" ", "").startswith("problem=")]
    chosen = next((s.partition("=")[2].strip() for s in settings if s.replace(" ", "").startswith("problem=")), "1")
    if chosen not in problems:
        raise DeckError.single("command line", None, "problem", f"Kenamond's problems are {', '.join(problems)}, not '{chosen[:20]}'",
                               "write problem=2")
    function: Any = problems[chosen]
    made, given = parameters_of(function, rest, skip=("points",))
    width = max(2, len(np.atleast_2d(np.asarray(given.get("detonators", given.get("detonator", (0.0, 0.0)))))[0]))
    if grid.at:
        places = points_of(grid.at, "--at", None)
    elif plot:
        reach = quantity(grid.end, "m", "--to") if grid.end else 6.0
        side = np.linspace(-reach, reach, min(grid.points, 401))
        places = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
    elif settings or as_csv:
        raise DeckError.single("command line", None, "--at", "burn times need points", 'give --at "0, 4 m; 3 m, 2 m", or --plot')
    else:
        _introduce("kenamond", as_json)
        return
    if places.shape[1] > width:
        raise OutOfRange(f"the points have {places.shape[1]} coordinates, the detonators {width}: give the same number for both")
    times = made(places)
    table = {**dict(zip(("x", "y", "z"), places.T)), "burn_time": times}
    if as_csv:
        write_csv(as_csv, [("", table)])
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.exact import burn_times

        save(burn_times(places, times, given), plot)
    if as_json:
        echo_json({"solution": "kenamond", "problem": chosen, "parameters": given, "source": _source(kenamond), "states": [row_of(table)]})
        return
    typer.echo(f"Kenamond's problem {chosen}: {inspect.cleandoc(function.__doc__ or '').splitlines()[0]}")
    if not plot:
        _echo_fields(table)
