"""Broken decks: each is answered with file, line, key and a way out, all errors at once, exit code 2, as quickly as a sound deck is read."""

import re

import pytest
from aluminium_decks import EOS, FRACTURE, STRENGTH, gauge, region
from pace import PATIENCE, in_starts

from hugoniot.cli.main import main
from hugoniot.errors import DeckError
from hugoniot.problem.deck import read_deck, read_deck_text

SOUND = "\n".join(("""\
title = "Aluminium on aluminium"
geometry = "planar"
stop_time = "2.5 us"
""", region("flyer", "0 mm", "2 mm", 200, "700 m/s"), region("target", "2 mm", "6 mm", 400), EOS + STRENGTH + FRACTURE, """\
[boundary]
left = "free"
right = "free"
""", gauge("mid", "4 mm"), """\
[solver]
integrator = "compatible"

[output]
snapshots = "0.05 us"
"""))


def change(*pairs: tuple[str, str], then: str = "") -> str:
    """The sound deck with texts replaced, each exactly once, and something added at its end."""
    text = SOUND
    for old, new in pairs:
        assert text.count(old) >= 1, old
        text = text.replace(old, new, 1)
    return text + then


# name -> (deck, [(line or None, key, part of the message or hint), ...])
BROKEN: dict[str, tuple[str, list[tuple[int | None, str, str]]]] = {
    "unknown unit": (change(('"2 mm"\nzones', '"2 mmm"\nzones')), [(9, "region.flyer.to", "unknown unit 'mmm'; did you mean 'mm'?")]),
    "unit of the wrong kind": (change(('"2.5 us"', '"2.5 mm"')), [(3, "stop_time", "expected a time, got a length")]),
    "quantity without a unit": (change(('"700 m/s"', '"700"')), [(11, "region.flyer.velocity", "has no unit")]),
    "wrong key": (change(("zones = 200", "zoness = 200")), [(10, "region.flyer.zoness", "did you mean 'zones'?")]),
    "no zones": (change(("zones = 200\n", "")), [(5, "region.flyer.zones", "zones or zone_size")]),
    "wrong key at the top": (change(("stop_time", "stoptime")), [(3, "stoptime", "did you mean 'stop_time'?"), (None, "stop_time", "missing")]),
    "wrong type": (change(("zones = 200", 'zones = "200"')), [(10, "region.flyer.zones", "expected a whole number, got '200'")]),
    "wrong type of a table": (change(("[boundary]\nleft = \"free\"\nright = \"free\"", "boundary = \"free\"")), [(None, "boundary", "")]),
    "region as a plain table": ('stop_time = "1 us"\n[region]\nname = "a"\n', [(2, "region", "[[region]]")]),
    "half a zone": (change(("zones = 200", "zones = 200.5")), [(10, "region.flyer.zones", "whole number")]),
    "overlap": (change(('from = "2 mm"', 'from = "1.5 mm"')), [(16, "region.target.from", "overlaps region 'flyer'")]),
    "negative size": (change(('to = "6 mm"', 'to = "1 mm"'), ('from = "2 mm"', 'from = "4 mm"')),
                      [(17, "region.target.to", "must be greater than from = 4 mm")]),
    "negative zones": (change(("zones = 400", "zones = -400")), [(18, "region.target.zones", "at least 1")]),
    "zero zone size": (change(("zones = 400", 'zone_size = "0 um"')), [(18, "region.target.zone_size", "greater than 0")]),
    "negative density": (change(('"2700 kg/m^3"', '"-2700 kg/m^3"')), [(22, "material.al.eos.rho0", "must be greater than 0, got -2700 kg/m^3")]),
    "missing material": (change(('material = "al"', 'material = "all"')), [(7, "region.flyer.material", "did you mean 'al'?")]),
    "two faults in one region": (change(('material = "al"', 'material = "all"'), ("zones = 200", "zones = 0")),
                                 [(7, "region.flyer.material", "did you mean 'al'?"), (10, "region.flyer.zones", "at least 1")]),
    "no such library material": (change(('material = "al"', 'material = "unobtainium"')), [(7, "region.flyer.material", "unknown material")]),
    "unknown law": (change(("mie_gruneisen", "mie_grunisen")), [(21, "material.al.eos.law", "did you mean 'mie_gruneisen'?")]),
    "missing parameter": (change(('c0 = "5200 m/s"\n', "")), [(20, "material.al.eos.c0", "missing")]),
    "unknown parameter": (change(("yield_stress", "yeild_stress")), [(29, "material.al.strength.yeild_stress", "did you mean 'yield_stress'?"),
                                                                  (26, "material.al.strength.yield_stress", "missing")]),
    "no eos": (change(("[material.al.eos]\nlaw = \"mie_gruneisen\"\nrho0 = \"2700 kg/m^3\"\nc0 = \"5200 m/s\"\ns = 1.5\ngamma0 = 2.0\n", "")),
               [(20, "material.al", "no equation of state")]),
    "huge number of zones": (change(("zones = 200", "zones = 1000000000000")), [(10, "region.flyer.zones", "at most 10 000 000")]),
    "huge number of zones by size": (change(("zones = 200", 'zone_size = "1e-12 m"')), [(10, "region.flyer.zone_size", "zones are too many")]),
    "number beyond all bounds": (change(('"2.5 us"', '"1e400 s"')), [(3, "stop_time", "too large to represent")]),
    "integer beyond all bounds": (change(("zones = 200", "zones = " + "9" * 5000)), [(None, "deck", "not a deck")]),
    "infinite": (change(('"700 m/s"', "inf")), [(11, "region.flyer.velocity", "finite")]),
    "not a number": (change(('"700 m/s"', "nan")), [(11, "region.flyer.velocity", "finite")]),
    "faster than light": (change(('"700 m/s"', '"1e9 m/s"')), [(11, "region.flyer.velocity", "faster than light")]),
    "power tower": (change(('"700 m/s"', '"9**9**9**9 m/s"')), [(11, "region.flyer.velocity", "not a unit")]),
    "code in a quantity": (change(('"700 m/s"', "\"__import__('os').system('true')\"")), [(11, "region.flyer.velocity", "not a quantity")]),
    "control characters": (change(('name = "flyer"', 'name = "fly\\u001b[31mer\\u0007"')), [(6, "name", "is not a valid name")]),
    "very long text": (change(('name = "flyer"', f'name = "{"x" * 100_000}"')), [(6, "name", "at most 60 characters")]),
    "unicode": (change(('"700 m/s"', '"７００ m/s"')), [(11, "region.flyer.velocity", "not a quantity")]),
    "nested arrays": (change(('"700 m/s"', "[" * 50 + "1" + "]" * 50)), [(11, "region.flyer.velocity", "expected")]),
    "arrays nested without end": ("x = " + "[" * 100_000, [(None, "deck", "nested too deeply")]),
    "not TOML": ("*** KO input\n  2 regions\n 700. 2.7 5.2\n", [(1, "deck", "not valid TOML")]),
    "YAML": ("mats: [al]\ntstop: 2.5e-6\n", [(1, "deck", "not valid TOML")]),
    "text not closed": ('title = "no end\nstop_time = 1\n', [(1, "deck", "not valid TOML")]),
    "key twice": (change(("zones = 200", "zones = 200\nzones = 300")), [(11, "deck", "not valid TOML")]),
    "empty": ("", [(None, "stop_time", "missing"), (None, "region", "missing")]),
    "duplicate names": (change(('name = "target"', 'name = "flyer"')), [(14, "region.flyer.name", "names must differ")]),
    "gauge in the void": (change(('at = "4 mm"', 'at = "8 mm"')), [(40, "gauge.mid.at", "no material at 8 mm")]),
    "gauge at no interface": (change(('at = "4 mm"', 'at = "target/flyer"')), [(40, "gauge.mid.at", "'flyer/target'")]),
    "state over-determined": (change(("zones = 200", "zones = 200\npressure = 0.0\ndensity = 2700.0\nenergy = 0.0")),
                              [(None, "region.flyer", "over-determine")]),
    "temperature without a law for it": (change(("zones = 200", 'zones = 200\ntemperature = "400 K"')),
                                         [(11, "region.flyer.temperature", "specific_heat")]),
    "density beyond the law": (change(("zones = 200", 'zones = 200\ndensity = "9 g/cc"')), [(11, "region.flyer.density", "outside")]),
    "no law for the equation of state": (change(("[material.al.strength]", "[material.cu]\neos = \"none\"\n[material.al.strength]")),
                                         [(27, "material.cu.eos", "the eos law must be a table")]),
    "no law for the viscosity": (change(then="[solver]\nviscosity = \"none\"\n").replace('[solver]\nintegrator = "compatible"\n', "", 1),
                                 [(46, "solver.viscosity", "the viscosity law must be a table")]),
    "negative viscosity": (change(then="[solver.viscosity]\nlaw = \"landshoff\"\nlinear = -0.3\n"), [(49, "solver.viscosity.linear", "must not be less than 0")]),
    "gas that cools when squeezed": (change(("[material.al.strength]", "[material.air]\neos = {law = \"ideal_gas\", gamma = -1.4}\n[material.al.strength]")),
                                     [(27, "material.air.eos.gamma", "must be greater than 1, got -1.4 (gamma: ratio of specific heats")]),
    "below absolute zero": (change(("gamma0 = 2.0", "gamma0 = 2.0\nreference_temperature = -20")),
                            [(26, "material.al.eos.reference_temperature", "must not be less than 0, got -20 K")]),
    "damage at rest": (change(('law = "spall_stress"\nstrength = "1.0 GPa"', 'law = "tuler_butcher"\nthreshold = "-1 GPa"\nexponent = 2\n'
                               'reference_stress = "1 GPa"\ncritical_time = "1 us"')), [(32, "material.al.fracture.threshold", "must not be less than 0")]),
    "title that ends a text": (change(('"Aluminium on aluminium"', '"Alu\\u0000minium"')), [(1, "title", "control characters")]),
    "warning that rings the bell": (change(("[material.al.eos]", "[material.al]\nwarnings = [\"\\u0007\"]\n[material.al.eos]")),
                                    [(21, "material.al.warnings", "control characters")]),
    "unknown boundary": (change(('left = "free"', 'left = "fre"')), [(35, "boundary.left", "did you mean 'free'?")]),
    "pulse without duration": (change(('left = "free"', 'left = {pressure = {shape = "square", amplitude = "1 GPa"}}')),
                               [(35, "boundary.left.pressure.duration", "missing")]),
    "table going back in time": (change(('left = "free"', 'left = {velocity = {times = [0.0, 2e-6, 1e-6], values = [0.0, 1.0, 2.0]}}')),
                                 [(35, "boundary.left.velocity.times[3]", "times must increase")]),
    "unknown solver": (change(("[solver]\n", '[solver]\nkind = "lagrange7d"\n')), [(43, "solver.kind", "unknown solver 'lagrange7d'")]),
    "unknown integrator": (change(('"compatible"', '"compatable"')), [(43, "solver.integrator", "did you mean 'compatible'?")]),
    "unknown viscosity": (change(then="[solver.viscosity]\nlaw = \"limitd\"\n"), [(48, "solver.viscosity.law", "did you mean 'limited'?")]),
    "unknown option": (change(then="[solver.options]\nheatflux = 0.1\n"), [(48, "solver.options.heatflux", "did you mean 'heat_flux'?")]),
    "courant beyond one": (change(("[solver]\n", "[solver]\ncourant = 3\n")), [(43, "solver.courant", "limit is 1")]),
    "unknown field": (change(then="fields = [\"presure\"]\n"), [(47, "output.fields", "did you mean 'pressure'?")]),
    "too many snapshots": (change(('"0.05 us"', '"1 fs"')), [(46, "output.snapshots", "too many")]),
    "interface of strangers": (change(then="[[interface]]\nbetween = [\"flyer\", \"targt\"]\n"), [(48, "interface[1].between", "did you mean 'target'?")]),
    "bond without strength": (change(then="[[interface]]\nbetween = [\"flyer\", \"target\"]\nkind = \"bond\"\n"),
                              [(47, "interface[1].strength", "missing")]),
    "negative radius": (change(('"planar"', '"spherical"'), ('from = "0 mm"', 'from = "-1 mm"')), [(8, "region.flyer.from", "radii")]),
    "driven axis": (change(('"planar"', '"cylindrical"'), ('left = "free"', 'left = {velocity = 1.0}')), [(35, "boundary.left", "r = 0")]),
    "grading beyond reason": (change(("zones = 200", "zones = 200\nratio = 2.0")), [(11, "region.flyer.ratio", "widths would differ")]),
}


def test_the_deck_the_others_are_made_from_is_sound():
    assert read_deck_text(SOUND).warnings == ()


def test_there_are_at_least_thirty():
    assert len(BROKEN) >= 30


@pytest.mark.parametrize("name", BROKEN)
def test_each_error_is_told_with_line_key_and_way_out(name, tmp_path):
    text, expected = BROKEN[name]
    path = tmp_path / "deck.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(DeckError) as caught:
        read_deck(path)
    told = caught.value.problems
    for line, key, part in expected:
        near = [p for p in told if key in p.key and part in f"{p.message}; {p.hint}"]
        assert near, f"no message about {key}: {part} in\n{caught.value}"
        assert near[0].file == "deck.toml"
        if line is not None:
            assert near[0].line == line, near[0]
    assert len(told) <= len(expected) + 2, f"one mistake, a flood of messages:\n{caught.value}"
    for problem in told:
        assert str(problem).isprintable(), "control characters reach the terminal"
        assert len(str(problem)) < 600
        assert "Error" not in problem.message and "Traceback" not in problem.message and "<class" not in problem.message


def test_all_errors_come_at_once(tmp_path):
    names = ["unknown unit", "unit of the wrong kind", "negative zones", "unknown law", "unknown boundary", "unknown integrator", "unknown parameter"]
    text = change(('"2 mm"\nzones', '"2 mmm"\nzones'), ('"2.5 us"', '"2.5 mm"'), ("zones = 400", "zones = -400"), ("mie_gruneisen", "mie_grunisen"),
                  ('left = "free"', 'left = "fre"'), ('"compatible"', '"compatable"'), ("yield_stress", "yeild_stress"))
    with pytest.raises(DeckError) as caught:
        read_deck_text(text, "deck.toml")
    for name in names:
        for _, key, part in BROKEN[name][1]:
            assert any(key == p.key and part in f"{p.message}; {p.hint}" for p in caught.value.problems), (name, str(caught.value))
    lines = [p.line for p in caught.value.problems if p.line]
    assert lines == sorted(lines)


def test_not_a_text(tmp_path):
    path = tmp_path / "deck.toml"
    path.write_bytes(b"title = 'x'\n\xff\xfe\x00\x01" + bytes(range(256)))
    with pytest.raises(DeckError, match=r"deck\.toml:2: deck: not a UTF-8 text file"):
        read_deck(path)


@pytest.mark.parametrize("name", BROKEN)
def test_the_command_ends_with_code_two(name, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "deck.toml").write_text(BROKEN[name][0], encoding="utf-8")
    with pytest.raises(SystemExit) as ended:
        main(["run", "deck.toml"])
    told = capsys.readouterr().err
    assert ended.value.code == 2
    assert re.match(r"deck\.toml(:\d+)?: [^:]+: ", told), told
    assert "Traceback" not in told
    assert not (tmp_path / "deck.run").exists()


@pytest.mark.parametrize("name", ["unknown unit", pytest.param("arrays nested without end", marks=pytest.mark.slow)])
def test_the_answer_takes_no_longer_than_reading_a_sound_deck(tmp_path, name):
    """Three times at the most: `run` gets ready to draw a report meanwhile. Seconds are measured by benchmarks/answers.py."""
    (tmp_path / "sound.toml").write_text(SOUND, encoding="utf-8")
    command = ["-c", "import sys; from hugoniot.cli.main import main; main(sys.argv[1:])"]
    (tmp_path / "broken.toml").write_text(BROKEN[name][0], encoding="utf-8")
    assert in_starts([[*command, "run", "broken.toml"]], [*command, "check", "sound.toml"], rounds=2, cwd=tmp_path, timeout=PATIENCE)[0] < 3.0
