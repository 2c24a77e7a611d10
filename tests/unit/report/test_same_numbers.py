"""Every number that the terminal and the report's results show stands in --json, to the digits shown, and the other way round."""

import html
import json
import math
import re

import pytest

import hugoniot
from hugoniot.cli.main import main
from hugoniot.output.run_numbers import GAUGE_UNITS, SPALL
from hugoniot.problem.catalogue import deck_text
from hugoniot.problem.deck import read_deck_text
from hugoniot.report.page import page

SMALL = {
    "plates that spall": ("flyer", {"region.flyer.zones": 40, "region.target.zones": 80}),
    "a tube": ("sod", {}),
    "discs in contact": ("gap-disc", {"block.target.zones": [10, 10], "block.flyer.zones": [12, 6], "stop_time": "2 us"}),
    "a mesh in two dimensions": ("noh-plane", {"stop_time": 0.05}),
    "tracked fronts": ("sod", {"solver.kind": "fronts"}),
}
STRUCTURE = """stop_time = "1 ns"
[[region]]
name = "argon"
material = "argon"
from = "-1 um"
to = "1 um"
zones = 60
[material.argon.eos]
law = "ideal_gas"
gamma = 1.6666666666666667
specific_heat = 312.2
rho0 = 1.6
[solver]
kind = "shock_structure"
[solver.transport.viscosity]
law = "power_law"
shear_viscosity = "2.2e-5 Pa s"
exponent = 0.81
reference_temperature = "300 K"
[solver.transport.conduction]
law = "prandtl"
prandtl = 0.6666666666666667
[solver.shock]
mach = 1.5
at = 0.0
start = "steady"
[output]
report = false
"""
UNITS = {"GPa": 1e9, "MPa": 1e6, "kPa": 1e3, "Pa": 1.0, "km/s": 1e3, "m/s": 1.0, "mm/s": 1e-3, "us": 1e-6, "ns": 1e-9, "ps": 1e-12, "ms": 1e-3, "s": 1.0, "m": 1.0, "cm": 1e-2,
         "mm": 1e-3, "um": 1e-6, "nm": 1e-9, "J": 1.0, "kJ": 1e3, "MJ": 1e6, "mJ": 1e-3, "J/m": 1.0}
NUMBER = r"(?<![\w.'-])([+-]?\d+(?:\.\d+)?(?:e[+-]?\d+)?)"
QUANTITY = re.compile(NUMBER + r"(?: ([µu]?[A-Za-z]+(?:/[a-z]+)?)(?![\w/]))?")


@pytest.fixture(scope="module", params=[*SMALL, "a resolved shock"])
def shown(request, tmp_path_factory):
    """What the terminal prints, the words of the report without its pictures, and the JSON of one run."""
    folder = tmp_path_factory.mktemp("same") / "run"
    name, changes = SMALL.get(request.param, ("", {}))
    deck = read_deck_text(deck_text(name) if name else STRUCTURE, overrides=changes)
    run = hugoniot.run(deck, folder, report=False)
    with pytest.MonkeyPatch.context() as patch:
        lines: list[str] = []
        patch.setattr("typer.echo", lambda text="", **options: lines.append(str(text)))
        patch.setenv("COLUMNS", "400")
        for option in ((), ("--json",)):
            with pytest.raises(SystemExit) as ended:
                main(["info", str(folder), *option])
            assert ended.value.code == 0
            lines.append("=====")
    terminal, as_json = "\n".join(lines).split("=====")[:2]
    return terminal, page(run, lambda tasks: {}), json.loads(as_json)


def leaves(value):
    """Every number in nested lists and dictionaries."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        return [number for inner in value for number in leaves(inner)]
    return [float(value)] if isinstance(value, (int, float)) else []


def is_shown(token, unit, values):
    """Whether a number as it is printed is one of the values to its digits: 4 to 6 of them, one behind the point of an error, or all."""
    by = UNITS.get(unit.replace("µ", "u"), 1.0) if unit else 1.0
    return any(float(token) == float(format(v / by, digits)) for v in values for digits in (".4g", ".5g", ".6g", ".3g", ".1e", ".2f", ".0f"))


def results_of(report):
    """The text of the report's results: what stands before the set-up, its materials, settings, sources and deck."""
    parts = [re.search(r'<dl class="numbers">.*?</dl>', report, re.S)[0],
             *re.findall(r"<section><h2>(?:At the gauges|Shock structure)</h2>.*?</section>", report, re.S)]
    return html.unescape(re.sub(r"<[^>]+>", "\n", "\n".join(parts))).replace("\u202f", "").replace("µ", "u")


def test_every_number_of_the_terminal_and_of_the_report_stands_in_the_json(shown):
    terminal, report, told = shown
    values = leaves(told)
    values += [told["summary"][key] for key in ("voids_opened", "voids_closed") if key in told["summary"]]
    names = [told["summary"]["title"], str(told["folder"]), *(row["gauge"] for row in told["gauges"]), *told["warnings"],
             *(str(told["spall"].get(key, "")) for key in ("reason", "note", "region", "window", "gauge")), told["highest"].get("surface", ""),
             *(str(told["highest"].get(f"{key}_region", "")) for key in ("stress", "pressure", "tension"))]
    derived = r" at t = 0(?=\)|\s|$)|\(the run [^)]*\)|10 to 90 %|from 10 % to 90 %|\|rho2 - rho1\||\|u2 - u1\||4/3|sources: .*|rho[12]|u[12]"
    for text in (terminal, results_of(report)):
        for name in sorted(filter(None, names), key=len, reverse=True):
            text = text.replace(name, "")
        found = [(m[1], m[2] or "") for m in QUANTITY.finditer(re.sub(derived, "", text))]
        assert len(found) > 6
        wrong = [f for f in found if not is_shown(*f, values)]
        assert wrong == []


def number_of(words):
    """The SI value that printed words stand for; NaN for none."""
    match = re.fullmatch(NUMBER + r" (\S+)", words.strip())
    return float(match[1]) * UNITS[match[2].replace("µ", "u")] if match else math.nan


def test_the_gauge_tables_and_the_spall_reading_are_those_of_the_json_cell_by_cell(shown):
    terminal, report, told = shown
    rows = re.findall(r"<tr>(.*?)</tr>", next(iter(re.findall(r"At the gauges</h2>.*?</section>", report, re.S)), ""), re.S)[1:]
    cells = [[html.unescape(re.sub("<[^>]+>", "", c)) for c in re.findall(r"<td[^>]*>(.*?)</td>", row, re.S)] for row in rows]
    assert [c[0] for c in cells] == [row["gauge"] for row in told["gauges"]]
    for row, shown_cells in zip(told["gauges"], cells):
        line = next(text for text in terminal.splitlines() if text.startswith(f"{row['gauge']}  "))
        in_terminal = re.split(r"\s{2,}", line[len(row["gauge"]):].strip())
        keys = [key for key in row if key != "gauge"]
        assert len(in_terminal) == len(keys) == len(shown_cells) - 1
        for key, word, cell in zip(keys, in_terminal, shown_cells[1:]):
            value = math.nan if row[key] is None else row[key]
            assert key in GAUGE_UNITS
            for text in (word, cell):
                assert number_of(text) == pytest.approx(float(f"{value:.5g}"), rel=1e-9, nan_ok=True), (row["gauge"], key, text)
    words = results_of(report)
    for key, name, _ in SPALL:
        value = told["spall"].get(key)
        for text in (terminal, words):
            place = re.search(rf"(?m)^\s*{re.escape(name)}\s+({NUMBER} \S+)", text)
            assert (place is None) == (value is None), name
            if place:
                assert number_of(place[1]) == pytest.approx(float(f"{value:.4g}"), rel=1e-9) and value
    for name in ("mass", "momentum", "energy"):
        for text in (terminal, words):
            place = re.search(rf"\b{name}(?: error)?\s+{NUMBER}", text)
            error = told["summary"][f"{name}_error"]
            assert place is None if error is None else float(place[1]) == float(f"{error:.1e}"), name
