"""The digits of the page are those of the package: under the pointer, in its tables, and by the command and the Python it names."""

import csv
import json
import re
import shlex

import numpy as np
import pytest
from browsing import shown, until
from typer.testing import CliRunner

from hugoniot.cli.main import build_app
from hugoniot.errors import HugoniotError
from hugoniot.explorer.catalogue import listing
from hugoniot.explorer.impact import impact
from hugoniot.explorer.subjects import entry_of, inert, inert_or_none
from hugoniot.explorer.surfaces import range_of
from hugoniot.explorer.transcribed import parameters
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.materials import library
from hugoniot.problem.deck import read_deck_text
from hugoniot.theory.impedance import match
from hugoniot.theory.isentrope import at_temperature
from hugoniot.theory.states import density_range
from hugoniot.theory.upstream import Initial, fastest

pytestmark = pytest.mark.slow


def printed(command, *more):
    """What a command of the page prints as JSON."""
    words = shlex.split(command)
    result = CliRunner().invoke(build_app(words[1]), [*words[1:], *more])
    assert result.exit_code == 0, result.output
    return json.loads(result.output) if "--json" in more else result.output


def computed(page):
    """What the Python of the page prints, as objects."""
    page.click("#as-python")
    found = []
    exec(page.text_content("#command"), {"print": lambda *values: found.append(values if len(values) > 1 else values[0])})
    page.click("#as-shell")
    return found


def test_the_state_under_the_pointer_is_that_of_the_command(visit):
    here = visit()
    page = here.go("#/materials?sel=copper,aluminum&plane=p-up")
    box = page.locator(".chart svg").first.bounding_box()
    for across, up in ((0.3, 0.6), (0.45, 0.5), (0.5, 0.2)):
        page.mouse.move(box["x"] + across * box["width"], box["y"] + up * box["height"])
        said, name = here.readout(), page.text_content("[data-readout] strong")
        result = CliRunner().invoke(build_app("eos"), ["eos", "hugoniot", name, "--at", f"particle_velocity = {said['particle velocity']}", "--json"])
        theirs = json.loads(result.output)
        for word, key, factor, unit in (("pressure", "pressure", 1e-9, "GPa"), ("density", "density", 1, "kg/m³"), ("shock velocity", "shock_velocity", 1, "m/s"),
                                        ("temperature", "temperature", 1, "K"), ("internal energy", "specific_internal_energy", 1e-3, "kJ/kg"), ("entropy", "entropy", 1, "J/kg/K")):
            assert said[word] == f"{shown(theirs[key] * factor)} {unit}"


def test_a_pinned_state_stands_in_the_address_and_has_a_command_that_gives_it(visit):
    here = visit()
    page = here.go("#/materials?sel=copper&at=particle_velocity:1234.5", "[data-table='state on the Hugoniot']")
    number = page.text_content("tr[data-field=pressure] td.number")
    words = page.text_content("#command")
    state = re.fullmatch(r'hugoniot eos hugoniot copper --at "([^"]+)" --axes us-up --plot hugoniots.png', words).group(1)
    result = CliRunner().invoke(build_app("eos"), ["eos", "hugoniot", "copper", "--at", state, "--json"])
    assert number == shown(json.loads(result.output)["pressure"] * 1e-9)
    page.fill("input[aria-label='Value of the state']", "2000")
    page.get_by_role("button", name="Pin", exact=True).click()
    until(page, "location.hash.includes('particle_velocity:2000')")
    page.click("#as-python")
    assert "shock(m, particle_velocity=2000)" in page.text_content("#command")


@pytest.mark.parametrize("axes", ["us-up", "p-up", "p-v", "t-p"])
def test_command_and_python_of_a_hugoniot_give_the_table(visit, axes, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    page = visit().go(f"#/materials?sel=copper,aluminum&plane={axes}&at=pressure:2e10", "[data-table='state on the Hugoniot']")
    cells = {field: page.locator(f"tr[data-field={field}] td.number").all_text_contents() for field in ("particle_velocity", "density", "temperature")}
    theirs, mine = printed(page.text_content("#command"), "--json")["materials"], computed(page)
    for field, found in cells.items():
        assert found == [shown(float(m[field])) for m in theirs] == [shown(float(m[field])) for m in mine]
    assert (tmp_path / "hugoniots.png").stat().st_size > 5000


def test_command_and_python_of_isentropes_surfaces_and_cold_curves(visit, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    here = visit()
    page = here.go("#/materials?sel=copper&plane=isentropes&at=particle_velocity:1500", "[data-table='state on the Hugoniot']")
    drawn = page.evaluate("document.querySelector('.chart').chart.spec.series.filter(s => s.id === 'release').at(-1).table")
    theirs, mine = printed(page.text_content("#command"), "--json"), computed(page)[0]
    for key in ("particle_velocity", "density", "temperature"):
        assert drawn[key][0] == pytest.approx(theirs[key][0], rel=1e-11) and drawn[key][-1] == pytest.approx(theirs[key][-1], rel=1e-9)
        assert drawn[key] == pytest.approx(list(mine[key]), rel=1e-11)
    page = here.go("#/materials?sel=copper&plane=surface&walk=0")
    here.point(0.5, 0.4)
    said = here.readout()
    printed(page.text_content("#command"))
    rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader((tmp_path / "surface.csv").open())]
    found = [r for r in rows if shown(r["density"]) == said["density"].split()[0] and shown(r["temperature"]) == said["temperature"].split()[0]]
    assert len(found) == 1 and len(rows) == 61 * 61
    assert said["pressure"] == f"{shown(found[0]['pressure'] * 1e-9)} GPa" and said["internal energy"] == f"{shown(found[0]['energy'] * 1e-3)} kJ/kg"
    p, e = computed(page)[0]
    drawn = page.evaluate("H.surface({name: 'copper'}, false)")      # kept from the drawing
    assert np.array(drawn["pressure"]) == pytest.approx(p, rel=1e-9, abs=1.0) and np.array(drawn["specific_internal_energy"]) == pytest.approx(e, rel=1e-9, abs=1e-3)
    assert p.ravel().tolist() == [r["pressure"] for r in rows] and e.ravel().tolist() == [r["energy"] for r in rows]
    page = here.go("#/materials?sel=copper&plane=isotherms")
    cold = page.evaluate("document.querySelector('.chart').chart.spec.series.find(s => s.id === 'cold curve').table")
    printed(page.text_content("#command"))
    rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader((tmp_path / "isotherms.csv").open())]
    theirs = [r["pressure"] for r in rows if r["temperature"] == 0.0]
    assert cold["pressure"] == pytest.approx(theirs, rel=1e-9, abs=1.0) and len(cold["pressure"]) == 61
    assert np.array_equal(computed(page)[0][0][:, 0], theirs)


def test_surfaces_of_all_laws_are_those_of_the_package(visit):
    """Every law of the library that has a temperature: pressures and energies at five densities and five temperatures."""
    page = visit().go("#/materials?sel=copper")
    ranges = {}
    for entry in (entry_of(m["name"]) for m in listing()["materials"] if m["alone"]):
        for material in (inert_or_none(entry), entry.material):
            if material is not None and EOS.of(material.eos).name not in ranges and "refused" not in (found := range_of(material)):
                ranges[found["law"]["$"]] = entry.name, material.eos, found
    assert len(ranges) >= 7
    for name, par, drawn in ranges.values():
        limits = page.evaluate("""given => { const T = H.theory, par = H.impact.law(given, 'example'), [density, energy] = T.reference_state(par);
            return [...T.density_range(par), T.fastest(par, {density, energy, heat: 0})].map(x => Number.isFinite(x) ? x : String(x)); }""", drawn["law"])
        rho, e = contract.reference_state(par)
        theirs = [*density_range(par), fastest(par, Initial(rho, 0.0, e))]
        assert [float(x) for x in limits] == pytest.approx(theirs, rel=1e-12), name
    for name, par, drawn in ranges.values():
        rho, t = (np.linspace(*drawn[key], 5) for key in ("densities", "temperatures"))
        mine = page.evaluate("""([given, rho, t]) => { const T = H.theory, par = H.impact.law(given, 'example'); return rho.map(r => t.map(k => {
            try { const e = T.energy_at_temperature(r, k, par); return [T.pressure(r, e, par), e]; } catch { return null; } })); }""", [drawn["law"], rho.tolist(), t.tolist()])
        for i, density in enumerate(rho.tolist()):
            for j, hot in enumerate(t.tolist()):
                try:
                    theirs = at_temperature(par, density, hot)
                except HugoniotError:
                    assert mine[i][j] is None, (name, density, hot)
                    continue
                assert mine[i][j] == pytest.approx(theirs, rel=1e-8, abs=10.0), (name, density, hot)


def test_the_pointer_walks_the_curves_of_a_surface(visit):
    here = visit()
    page = here.go("#/materials?sel=copper&plane=surface")
    page.locator(".chart svg").first.focus()
    page.keyboard.press("ArrowRight")
    said = here.readout()
    theirs = printed(f'hugoniot eos hugoniot copper --at "density = {said["density"].replace("kg/m³", "kg/m^3")}"', "--json")
    assert page.text_content("[data-readout]").startswith("copper Hugoniot") and float(said["pressure"].split()[0]) == pytest.approx(theirs["pressure"] * 1e-9, rel=1e-4)
    page.keyboard.press("ArrowDown")
    assert "isentrope" in page.text_content("[data-readout]")


def test_command_and_python_of_explosives(visit, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    here = visit()
    page = here.go("#/materials?sel=comp_b&plane=detonation", "[data-table='CJ state']")
    cell = page.text_content("tr[data-field=pressure] td.number")
    theirs, (point, _) = printed(page.text_content("#command"), "--json"), computed(page)[0]
    assert cell == shown(theirs["chapman_jouguet"]["pressure"] * 1e-9) == shown(float(point["pressure"]) * 1e-9)
    page = here.go("#/materials?sel=comp_b&plane=us-up")
    page.wait_for_selector("text=Composition B, unreacted")
    page = here.go("#/materials?sel=comp_b&plane=expansion")
    drawn = page.evaluate("document.querySelector('.chart').chart.spec.series[0].table")
    printed(page.text_content("#command"))
    rows = list(csv.DictReader((tmp_path / "expansion.csv").open()))
    assert float(next(v for k, v in rows[0].items() if k.startswith("pressure"))) == pytest.approx(drawn["pressure"][0], rel=1e-11)
    assert computed(page)[0]["density"].tolist() == pytest.approx(drawn["density"], rel=1e-11)
    page = here.go("#/materials?sel=comp_b&plane=gurney")
    assert "2700" in printed(page.text_content("#command")) and computed(page)[0]["gurney_velocity"].value == 2700.0
    page = here.go("#/materials?sel=comp_b&plane=pop")
    row = page.evaluate("document.querySelector('.chart').chart.spec.series.find(s => s.kind === 'line').id").split()[-1]
    assert row in [r.id for r in computed(page)[0]] and row in printed(page.text_content("#command"))


def test_the_flyer_is_dragged_and_the_match_follows(visit):
    here = visit()
    page = here.go("#/match?layers=copper,aluminum&v=1000", "[data-table=match]")
    handle = page.locator("[data-handle=velocity]").bounding_box()
    page.mouse.move(handle["x"] + handle["width"] / 2, handle["y"] + handle["height"] / 2)
    page.mouse.down()
    for step in range(1, 16):
        page.mouse.move(handle["x"] + handle["width"] / 2 - 12 * step, handle["y"] + handle["height"] / 2)
    page.mouse.up()
    page.wait_for_timeout(400)
    here.settled()
    velocity = float(re.search(r"v=(\d+)", page.url).group(1))
    assert 300 < velocity < 900 and page.input_value("input[aria-label='Impact velocity in m/s']") == f"{velocity:g}"
    met = match([library.find("copper"), library.find("aluminum")], velocity)[0]
    assert page.text_content("[data-table=match] tr[data-field=pressure] td.number") == shown(met.pressure * 1e-9)
    assert page.text_content("[data-table=match] tr[data-field=particle_velocity] td.number") == shown(met.particle_velocity)
    assert f'--velocity "{velocity:g} m/s"' in page.text_content("#command")
    page.click("summary:has-text('The deck')")
    until(page, "document.querySelector('details pre')?.textContent.includes('[[region]]')")
    page.click("text=Open in the deck editor")
    page.wait_for_selector("text=The deck is valid")


def test_the_page_computes_the_impacts_of_the_theory(visit):
    """Of every law of the library, in stacks, reshocked and released, with temperatures and error bands: to round-off."""
    page = visit().go("#/match")
    stacks = [(["tungsten", "pmma"], 37.0), (["copper", "aluminum", "lif", "pmma", "tungsten", "water", "iron", "pmma"], 1234.5), (["U012", "T004", "M010", "basalt"], 2500.0),
              (["iron", "air", "copper"], 900.0), (["comp_b", "brass", "J043", "copper"], 1500.0), (["pbx_9502", "M200", "M120", "polystyrene"], 3000.0), (["iron", "water", "iron"], 800.0), (["copper", "basalt_porous", "aluminum_porous"], 700.0)]
    seen = set()
    for names, velocity in stacks:
        mine = page.evaluate(f"H.impact.impact({names!r}, {velocity}, {{sigma: 5, bands: true}})")
        theirs = impact(names, velocity, 5.0, True)
        seen |= {EOS.of(inert(entry_of(name)).eos).name for name in names}
        assert mine["warnings"] == theirs["warnings"] and mine["uncertain"] == theirs["uncertain"]
        for own, other, curves in zip(mine["states"], theirs["states"], mine["curves"], strict=True):
            assert (own["reflected"], own["transmitted"]) == (other["reflected"], other["transmitted"])
            for key in ("pressure", "particle_velocity", "shock_velocity", "density", "temperature", "specific_internal_energy", "sound_speed"):
                other[key] = None if other[key] is None or np.isnan(other[key]) else other[key]
                assert own[key] == (None if other[key] is None else pytest.approx(other[key], rel=1e-9)), (names, key)
            assert own["uncertainty"] == pytest.approx(other["uncertainty"], rel=1e-5)
            for side in curves.values():        # the drawn curves pass through the state
                order = np.argsort(side["pressure"])
                assert np.interp(own["pressure"], np.array(side["pressure"])[order], np.array(side["particle_velocity"])[order]) == pytest.approx(own["particle_velocity"], rel=1e-9)
                assert (np.diff(side["pressure"]) >= 0).all()
    assert seen >= {"mie_gruneisen", "mie_gruneisen_linear_gamma", "mie_gruneisen_quadratic", "mie_gruneisen_cubic", "birch_murnaghan", "vinet", "tillotson", "ideal_gas",
                    "jwl_unreacted"}


def test_the_page_transcribes_every_law(visit):
    """Pressures, slopes and temperatures where the law's example holds, and its impact on copper: pores, tables and laws inside laws too."""
    page = visit().go("#/match")
    copper = library.find("copper").eos
    for law in EOS:
        par, rho, e = law.example, *(0.5 * (low + high) for low, high in (law.box["rho"], law.box["e"]))
        p, (p_rho, p_e) = contract.pressure(rho, e, par), contract.pressure_derivatives(rho, e, par)
        mine = page.evaluate(f"""() => {{ const T = H.theory, par = H.impact.law({json.dumps(parameters(par))}, 'example'), at = [{float(rho)!r}, {float(e)!r}, par];
          return [T.pressure(...at), ...T.pressure_derivatives(...at), par.law.temperature ? T.temperature(...at) : null]; }}""")
        heat = float(contract.temperature(rho, e, par)) if "temperature" in law.functions else None
        assert mine[:3] == pytest.approx([float(p), float(p_rho), float(p_e)], rel=1e-9, abs=1e-12 * abs(float(p_rho))), law.name
        assert mine[3] == (None if heat is None or np.isnan(heat) else pytest.approx(heat, rel=1e-9)) or np.isnan(heat), law.name
        given, ahead = (json.dumps(parameters(each)) for each in (par, copper))
        try:
            met = match([copper, par, copper], 300.0)
        except HugoniotError:
            assert page.evaluate(f"() => {{ try {{ H.impact.match([H.impact.law({ahead}), H.impact.law({given}), H.impact.law({ahead})], 300); return false; }} catch (error) {{ return error instanceof H.Refused; }} }}"), law.name
            continue
        found = page.evaluate(f"H.impact.match([H.impact.law({ahead}), H.impact.law({given}), H.impact.law({ahead})], 300).map(m => m.ahead.pressure)")
        assert found == pytest.approx([m.pressure for m in met], rel=1e-7), law.name


def test_the_deck_of_an_impact_is_valid_and_explosives_are_refused(visit):
    page = visit().go("#/match")
    for names in (["copper", "aluminum"], ["Cu", "al", "pmma"], ["steel_4340", "copper", "lif", "pmma"]):
        deck = read_deck_text(page.evaluate(f"H.impact.deck({names!r}, 812.5)"))
        assert len(deck.problem.regions) == len(names) and deck.problem.regions[0].velocity == 812.5 and len(deck.problem.gauges) >= len(names)
    page = visit().go("#/match?layers=copper,pbx_9501&v=800&deck=1")
    page.wait_for_selector("text=which burns in a run; the match treats it as inert, so no deck is offered")


@pytest.mark.parametrize("asked", ["layers=tungsten,copper,pmma&v=800&sigma=5", "layers=iron,water,copper&v=800&sigma=5&bands=1", "layers=my_steel,copper&v=700&sigma=5"])
def test_command_and_python_of_a_match_give_its_table(visit, opened, monkeypatch, asked):
    monkeypatch.chdir(opened[0])
    page = visit().go(f"#/match?{asked}", "[data-table=match]")
    until(page, "document.querySelector('[data-table=match] tr[data-field=pressure] .quiet')")
    rows = {field: page.locator(f"[data-table=match] tr[data-field={field}] td.number").all_text_contents() for field in ("pressure", "particle_velocity")}
    states, mine = printed(page.text_content("#command"), "--json")["states"], computed(page)[0]
    for field, factor in (("pressure", 1e-9), ("particle_velocity", 1)):
        for cell, theirs, own in zip(rows[field], states, mine, strict=True):
            spread = theirs["uncertainty"][field]["sigma"]
            assert cell == f"{shown(theirs[field] * factor)} ± {shown(spread * factor, 2)}" == f"{shown(own[field] * factor)} ± {shown(own['uncertainty'][field] * factor, 2)}"


def test_the_deck_of_a_match_runs_with_one_click(visit):
    here = visit()
    page = here.go("#/match?layers=copper,aluminum&v=500", "[data-table=match]")
    page.click("summary:has-text('The deck')")
    until(page, "document.querySelector('details pre')?.textContent.includes('[[region]]')")
    page.click("details button:has-text('Run')")
    page.wait_for_selector("[data-state]")
    assert re.search(r"job=\d+", page.url) and "Aluminium" in page.input_value(".editor textarea")
    page.locator("button:has-text('Stop'), [data-state=done]").first.click()
    page.wait_for_selector("[data-state=stopped], [data-state=done]")
