"""Decks of the two-dimensional hydrocode: every key round trip, every mistake at once, with its line and a hint."""

import json
import re

import numpy as np
import pytest

from hugoniot.errors import DeckError
from hugoniot.mesh.shapes import Box, Edges, Sector
from hugoniot.problem.deck import read_deck, read_deck_text
from hugoniot.problem.editor_schema import json_schema
from hugoniot.problem.plane.model import Boundary2D, Gauge2D, VelocityField

BAR = """\
title = "Bar"
geometry = "axisymmetric"
stop_time = "80 us"

[[block]]
name = "bar"
material = "copper"
r = ["0 mm", "3.2 mm"]
z = ["0 mm", "32.4 mm"]
zones = [4, 30]
velocity = ["0 m/s", "-227 m/s"]

[[boundary]]
on = "bar.bottom"
kind = "wall"

[solver]
kind = "lagrange2d"
"""

EVERYTHING = """\
title = "Everything"
geometry = "plane"
stop_time = "5 us"
body_force = [0, "-9.81 m/s^2"]

[material.gas.eos]
law = "ideal_gas"
gamma = 1.4

[[block]]
name = "box"
material = "gas"
x = ["0 cm", "2 cm"]
y = [0.0, "1 cm"]
zones = [4, 3]
ratio = [1.1, 0.9]
density = 1.2
pressure = "1 bar"
velocity = {base = ["1 m/s", 0], centre = ["1 cm", 0], gradient = [["2 1/s", 0], [0, "-2 1/s"]], radial = "-3 m/s", radius = "1 cm", power = 2}

[[block]]
name = "quarter"
material = "gas"
shape = "edges"
zones = [5, 3]
ratio = [1.0, 0.9]
fill = "winslow"
density = 1.2
pressure = "1 bar"
velocity = {rotation = "20 rad/s"}
[block.left]
line = [["2 cm", "0 cm"], ["2 cm", "1 cm"]]
[block.bottom]
csv = "shore.csv"
unit = "cm"
[block.top]
polyline = [["2 cm", "1 cm"], ["3 cm", "1.2 cm"], ["4 cm", "1 cm"]]
[block.right]
arc = [["4 cm", "0 cm"], ["4.2 cm", "0.5 cm"], ["4 cm", "1 cm"]]

[[boundary]]
on = ["box.left", "box.bottom"]
kind = "wall"
slip = false

[[boundary]]
on = "quarter.right"
kind = "velocity"
velocity = {shape = "ramp", amplitude = "-10 m/s", duration = "1 us"}
direction = [3, 4]

[[boundary]]
on = "quarter.top"
kind = "pressure"
pressure = {times = [0, "1 us"], values = [0, "1 GPa"]}

[[boundary]]
on = "box.top"
kind = "transmitting"

[[gauge]]
name = "point"
at = ["1 cm", "5 mm"]
[[gauge]]
name = "face"
on = "box/quarter"
[[gauge]]
name = "streak"
on = "quarter.top"
through = ["3 cm", 0]
direction = [0, 2]

[solver]
kind = "lagrange2d"
cells = "quads"
courant = 0.3
[solver.hourglass]
subzonal_pressure = 0.5
[solver.viscosity]
kind = "tensor"
limited = false

[output]
snapshots = "1 us"
"""


@pytest.fixture
def everything(tmp_path):
    (tmp_path / "shore.csv").write_text("# survey\nx, y\n2, 0\n3, -0.2\n4, 0\n")
    (tmp_path / "deck.toml").write_text(EVERYTHING)
    return read_deck(tmp_path / "deck.toml")


def test_every_key_is_read(everything):
    problem = everything.problem
    box, quarter = problem.blocks
    assert box.shape == Box((0.0, 0.02), (0.0, 0.01)) and box.zones == (4, 3) and box.ratio == (1.1, 0.9)
    assert box.velocity == VelocityField((1.0, 0.0), (0.01, 0.0), ((2.0, 0.0), (0.0, -2.0)), -3.0, 0.01, 2.0)
    assert isinstance(quarter.shape, Edges) and quarter.shape.fill == "winslow"
    assert quarter.shape.bottom.points == ((0.02, 0.0), (0.03, -0.002), (0.04, 0.0))
    wall, piston, load, open_ = problem.boundaries
    assert wall == Boundary2D(("box.left", "box.bottom"), "wall", slip=False)
    assert piston.direction == (0.6, 0.8) and piston.pulse.shape == "ramp" and piston.pulse.amplitude == -10.0
    assert load.pulse.values == (0.0, 1e9) and open_.kind == "transmitting"
    assert problem.gauges[0] == Gauge2D("point", "point", (0.01, 0.005))
    assert problem.gauges[1] == Gauge2D("face", "edge", on="box/quarter")
    assert problem.gauges[2] == Gauge2D("streak", "slit", (0.03, 0.0), "quarter.top", (0.0, 1.0))
    solver = problem.solver
    assert (solver.cells, solver.courant) == ("quads", 0.3)
    assert (solver.subzonal_pressure, solver.viscosity.kind, solver.viscosity.limited) == (0.5, "tensor", False)
    assert problem.body_force == (0.0, -9.81)


def test_a_resolved_deck_reads_back_to_the_same_problem(everything):
    again = read_deck_text(everything.resolved)
    assert again.problem == everything.problem and again.resolved == everything.resolved
    bar = read_deck_text(BAR)
    assert read_deck_text(bar.resolved).problem == bar.problem
    assert "csv" not in everything.resolved      # the points stand in the deck: it needs no other file


def test_velocity_fields_are_the_sum_of_their_parts(everything):
    problem = everything.problem
    field, spin = (block.velocity for block in problem.blocks)
    first, second = problem.velocities()
    x, y = problem.mesh.blocks[0].x, problem.mesh.blocks[0].y
    d = np.hypot(x - 0.01, y)
    assert np.allclose(first[0], 1.0 + 2.0 * (x - 0.01) - 3.0 * (d / 0.01) ** 2 * (x - 0.01) / np.where(d > 0.0, d, 1.0))
    assert np.allclose(second, [-20.0 * problem.mesh.blocks[1].y, 20.0 * problem.mesh.blocks[1].x])
    assert field.power == 2.0 and spin.rotation == 20.0


def test_defaults_follow_the_mesh_and_the_geometry():
    bar = read_deck_text(BAR).problem
    assert bar.solver.scheme == "true_volume" and bar.solver.viscosity.kind == "tensor"
    assert bar.chain_boundaries()["bar.left"].kind == "axis" and bar.chain_boundaries()["bar.right"].kind == "free"
    sphere = BAR.replace('r = ["0 mm", "3.2 mm"]', 'shape = "sector"').replace('z = ["0 mm", "32.4 mm"]', 'radius = ["1 mm", "2 mm"]\n'
                         'angle = ["0 deg", "90 deg"]').replace('["0 m/s", "-227 m/s"]', '{radial = "-1 km/s"}')
    problem = read_deck_text(sphere).problem
    assert problem.solver.scheme == "area_weighted" and problem.solver.viscosity.kind == "tensor"
    assert isinstance(problem.blocks[0].shape, Sector) and problem.mesh.chains["bar.top"].on_axis


@pytest.mark.parametrize(("given", "fluid", "solid"), [
    ("", (0.3, 1.0), (0.3, 1.0)), ("linear = 0.3", (0.3, 0.3), (0.3, 1.0)), ("solid_linear = 0.1", (0.3, 1.0), (0.1, 0.1)),
    ("linear = 0.1, linear_condensed = 0.7", (0.1, 0.7), (0.3, 1.0)), ("solid_linear_condensed = 0.7", (0.3, 1.0), (0.3, 0.7))])
def test_a_linear_viscosity_given_alone_holds_in_every_shock(given, fluid, solid):
    """As in one dimension; the resolved deck says which, that of Herrmann's viscosity has no key that it does not use."""
    read = read_deck_text(BAR + f"viscosity = {{{given}}}\n", "deck.toml")
    found = read.problem.solver.viscosity
    assert (found.linear, found.linear_condensed) == fluid and (found.solid_linear, found.solid_linear_condensed) == solid
    again = read_deck_text(read.resolved, "deck.toml")
    assert again.resolved == read.resolved and again.problem.solver.viscosity == found
    herrmann = read_deck_text(BAR + 'viscosity = {kind = "herrmann", limited = false}\n', "deck.toml").resolved
    assert "condensed" not in herrmann and read_deck_text(herrmann, "deck.toml").resolved == herrmann


def test_the_schema_names_every_key_of_the_resolved_deck(everything):
    schema = json_schema("lagrange2d")
    assert {"title", "geometry", "block", "boundary", "gauge", "lighting", "body_force", "solver"} <= set(schema["properties"])
    solver = schema["$defs"]["SolverTable"]["properties"]
    assert {"cells", "scheme", "viscosity", "hourglass", "courant", "threads"} <= set(solver)
    block = schema["$defs"]["BlockTable"]["properties"]
    assert block["velocity"]["anyOf"][1]["properties"]["radial"]["unit"] == "m/s" and block["zones"]["items"]["type"] == "integer"


@pytest.mark.parametrize("old, new, line, key, words", [
    ('"copper"', '"coper"', 7, "block.bar.material", "unknown material"),
    ('r = ["0 mm"', 'x = ["0 mm"', 8, "block.bar.x", "the coordinates are r and z"),
    ('"3.2 mm"', '"3.2 mmm"', 8, "block.bar.r", "unknown unit"),
    ('"3.2 mm"', '"-3.2 mm"', 8, "block.bar.r", "smaller value to the larger"),
    ('["0 mm", "3.2 mm"]', '["-1 mm", "3.2 mm"]', 5, "block.bar.shape", "beyond the axis"),
    ("zones = [4, 30]", "zones = [4, 0]", 10, "block.bar.zones", "from 1 to 20 000"),
    ("zones = [4, 30]", "zones = 4", 10, "block.bar.zones", "two whole numbers"),
    ("zones = [4, 30]", "zones = [4, 30]\nratio = [1.0, -1.0]", 11, "block.bar.ratio", "greater than 0"),
    ('["0 m/s", "-227 m/s"]', '["5 m/s", "-227 m/s"]', 11, "block.bar.velocity", "gives a radial velocity of"),
    ('["0 m/s", "-227 m/s"]', '{rotation = "1 rad/s"}', 11, "block.bar.velocity.rotation", "axisymmetric"),
    ('["0 m/s", "-227 m/s"]', '{radail = 3}', 11, "block.bar.velocity.radail", "did you mean 'radial'"),
    ('["0 m/s", "-227 m/s"]', '{radial = "-3 m/s", centre = ["1 mm", 0]}', 11, "block.bar.velocity", "gives a radial velocity of"),
    ('"bar.bottom"', '"bar.botom"', 14, "boundary[1].on", "did you mean 'bar.bottom'"),
    ('"bar.bottom"', '["bar.bottom", "bar.bottom"]', 14, "boundary[1].on", "twice"),
    ('"bar.bottom"', '"bar.left"', 15, "boundary[1].kind", "lies on the axis"),
    ('kind = "wall"', 'kind = "axis"', 15, "boundary[1].kind", "is not an axis"),
    ('kind = "wall"', 'kind = "pressure"', 13, "boundary[1].pressure", "missing"),
    ('kind = "wall"', 'kind = "wall"\npressure = "1 GPa"', 16, "boundary[1].pressure", "does not apply to a boundary of kind wall"),
    ('kind = "wall"', 'kind = "wall"\ndirection = [0, 1]', 16, "boundary[1].direction", "does not apply to a boundary of kind wall"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\ncells = "hexagons"', 19, "solver.cells", "expected 'quads' or 'triangles'"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\ndiagonal = "crossed"', 19, "solver.diagonal", "triangles only"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\naverage_pressure = false', 19, "solver.average_pressure", "triangles only"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\ncells = "triangles"\ndiagonal = "both"', 20, "solver.diagonal", "expected 'one_way'"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\ncells = "triangles"\nviscosity = {heat_flux = 0.5}', 20, "solver.viscosity.heat_flux",
     "between quadrilaterals only"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\ncells = "triangles"\nhourglass = {subzonal_pressure = 0.5}', 20, "solver.hourglass",
     "no hourglass modes"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\nviscosity = {kind = "edgy"}', 19, "solver.viscosity.kind", "expected 'tensor', 'edge' or 'herrmann'"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\nviscosity = {kind = "herrmann"}', 19, "solver.viscosity", "no limiter"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\nviscosity = {kind = "herrmann", limited = false, solid_linear = 0.1}', 19,
     "solver.viscosity.solid_linear", "does not apply to Herrmann's viscosity"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\nviscosity = {kind = "herrmann", limited = false, solid_linear_condensed = 1.0}', 19,
     "solver.viscosity.solid_linear_condensed", "one linear coefficient for weak and strong shocks"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\nviscosity = {kind = "herrmann", limited = false, linear_condensed = 1.0}', 19,
     "solver.viscosity.linear_condensed", "use linear"),
    ('geometry = "axisymmetric"', 'geometry = "axisymmetric"\nbody_force = [1, 0]', 3, "body_force", "not uniform about the axis"),
    ("[solver]", '[[gauge]]\nname = "g"\nat = ["9 mm", 0]\n[solver]', 19, "gauge.g.at", "no material at"),
    ("[solver]", '[[gauge]]\nname = "g"\non = "bar.left"\nat = [0, 0]\n[solver]', 17, "gauge.g", "got at and on"),
    ("[solver]", '[[gauge]]\nname = "g"\non = "bar.right"\nthrough = [0, 1]\ndirection = [1, 0]\n[solver]', 19, "gauge.g.on",
     "does not cross"),
    ("[solver]", '[[lighting]]\nat = [0, 0]\n[solver]', 18, "lighting[1].at", "no explosive with programmed burn"),
    ('kind = "wall"', 'kind = "walls"', 15, 'boundary[1].kind', "did you mean 'wall'"),
    ('kind = "wall"', 'kind = "velocity"', 13, 'boundary[1].velocity', 'for example velocity'),
    ('kind = "wall"', 'kind = "velocity"\nvelocity = "5 kg"', 16, 'boundary[1].velocity', 'expected a velocity, got a mass'),
    ('kind = "wall"', 'kind = "velocity"\nvelocity = "5 m/s"\ndirection = [0, 0]', 17, 'boundary[1].direction', 'such as [1, 0]'),
    ('kind = "wall"', 'kind = "pressure"\npressure = {times = [0, 1e-6], values = [1]}', 16, 'boundary[1].pressure', 'as many times as values'),
    ('zones = [4, 30]', 'zones = [4, 30]\nshape = "ring"', 11, 'block.bar.shape', "expected 'box', 'sector' or 'edges'"),
    ('zones = [4, 30]', 'zones = [4, 30, 2]', 10, 'block.bar.zones', 'for example [20, 200]'),
    ('zones = [4, 30]', 'zones = [20000, 20000]', 5, 'block', 'the limit is'),
    ('r = ["0 mm", "3.2 mm"]\n', '', 5, 'block.bar.r', 'the shape box has: r, z'),
    ('z = ["0 mm", "32.4 mm"]', 'z = ["32.4 mm", "0 mm"]', 9, 'block.bar.z', 'exchange them'),
    ('z = ["0 mm", "32.4 mm"]', 'z = ["0 mm", "0 mm"]', 9, 'block.bar.z', 'for example'),
    ('"32.4 mm"]', 'inf]', 9, 'block.bar.z', 'expected a finite number'),
    ('name = "bar"', 'name = "bar/foot"', 6, 'block.bar/foot.name', "no '/' or '.'"),
    ('"-227 m/s"]', '"-227 m/s"]\ndensity = "3 g/cm^3"\npressure = "1 GPa"\nenergy = 3', 14, 'block.bar.energy', 'at most two'),
    ('[solver]', '[[block]]\nname = "bar"\nmaterial = "copper"\nr = [0, "1 mm"]\nz = ["40 mm", "41 mm"]\nzones = [2, 2]\n[solver]', 18, 'block.bar.name', 'names must differ'),
    ('[solver]', '[[block]]\nname = "cap"\nmaterial = "copper"\nr = [0, "1 mm"]\nz = ["30 mm", "41 mm"]\nzones = [2, 2]\n[solver]', 17, 'block.cap.shape', "overlaps block 'bar'"),
    ('[solver]', '[[block]]\nname = "cap"\nmaterial = "copper"\nr = [0, "1 mm"]\nz = ["32.4 mm", "41 mm"]\nzones = [2, 2]\n[solver]', 22, 'block.cap.zones', '[[contact]]'),
    ('[solver]', '[[block]]\nname = "cap"\nmaterial = "copper"\nshape = "sector"\nradius = ["1 mm", "0.5 mm"]\nangle = ["0 deg", "90 deg"]\nzones = [3, 2]\n[solver]', 21, 'block.cap.radius', 'exchange them'),
    ('[solver]', '[[block]]\nname = "cap"\nmaterial = "copper"\nshape = "edges"\nzones = [3, 2]\n[block.left]\nline = [[0, 1], [0, 2]]\n[solver]', 17, 'block.cap.right', 'the shape edges has'),
    ('[solver]', '[[block]]\nname = "cap"\nmaterial = "copper"\nshape = "edges"\nzones = [3, 2]\nleft = {line = [[2, 1], [2, 2]]}\nright = {line = [[1, 1], [1, 2]]}\nbottom = {line = [[1, 1], [2, 1]]}\ntop = {line = [[1, 2], [2, 2]]}\n[solver]', 20, 'block.cap.shape', 'runs clockwise'),
    ('[solver]', '[[block]]\nname = "cap"\nmaterial = "copper"\nshape = "edges"\nzones = [3, 2]\nleft = {line = [[1, 1], [1, 2]]}\nright = {line = [[2, 1], [2, 2]]}\nbottom = {line = [[1, 1], [2, 1]]}\ntop = {line = [[1, 2], [2, 2.5]]}\n[solver]', 25, 'block.cap.top', 'does not meet'),
    ('[solver]', '[[block]]\nname = "cap"\nmaterial = "copper"\nshape = "edges"\nzones = [4, 4]\nleft = {polyline = [[1, 1], [3.8, 1.5], [1, 2]]}\nright = {line = [[2, 1], [2, 2]]}\nbottom = {line = [[1, 1], [2, 1]]}\ntop = {line = [[1, 2], [2, 2]]}\n[solver]', 20, 'block.cap.shape', 'folded corner'),
    ('[solver]', '[[gauge]]\nname = "g"\non = "bar.rigt"\n[solver]', 19, 'gauge.g.on', "did you mean 'bar.right'"),
    ('[solver]', '[[gauge]]\nname = "g"\n[solver]', 17, 'gauge.g', 'for example at'),
    ('[solver]', '[[rigid]]\nname = "floor"\npoints = [["0 mm", "1 mm"], ["5 mm", "1 mm"]]\n[solver]', 19, 'rigid[1].points', 'at the start bodies may touch, but not overlap'),
    ('[solver]', '[[rigid]]\nname = "bar.right"\npoints = [["0 mm", "-1 mm"], ["5 mm", "-1 mm"]]\n[solver]', 18, 'rigid[1].name', "named like a side of block 'bar'"),
    ('[solver]', '[[region]]\nname = "a"\n[solver]', 17, 'region', 'known: block'),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\nscheme = "aw"', 19, 'solver.scheme', "expected 'true_volume' or 'area_weighted'"),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\ncourant = 3', 19, 'solver.courant', 'the limit is 1'),
    ('kind = "lagrange2d"', 'kind = "lagrange2d"\nhourglass = {subzonal_pressure = -1}', 19, 'solver.hourglass.subzonal_pressure', 'must not be less than 0'),
    ('geometry = "axisymmetric"', 'geometry = "cylinder"', 2, 'geometry', "expected 'plane' or 'axisymmetric'"),
    ('stop_time = "80 us"', 'stop_time = "-80 us"', 3, 'stop_time', 'must be greater than 0'),
])
def test_a_mistake_is_answered_with_line_key_and_way_out(old, new, line, key, words):
    with pytest.raises(DeckError) as caught:
        read_deck_text(BAR.replace(old, new, 1))
    problem = next((p for p in caught.value.problems if p.key == key), None)
    assert problem is not None, [str(p) for p in caught.value.problems]
    assert problem.line == line and words in f"{problem.message}; {problem.hint}"
    assert problem.hint or re.search("expected|must|over-determine|as many", problem.message)       # what would be right
    if key == "geometry":
        assert len(caught.value.problems) == 1      # what follows from it is not counted


def test_mistakes_of_several_blocks_come_at_once():
    second = BAR + '[[block]]\nname = "foot"\nmaterial = "coper"\nr = [0, "3.2 mm"]\nz = ["-1 mm", "0 mm"]\nzones = [3, 2]\n'
    with pytest.raises(DeckError) as caught:
        read_deck_text(second.replace('on = "bar.bottom"', 'on = "bar.bottom"\nslipp = true'))
    assert [p.key for p in caught.value.problems] == ["boundary[1].slipp", "block.foot.material"]
    with pytest.raises(DeckError, match="nodes do not coincide there"):
        read_deck_text(second.replace("coper", "copper"))


def test_a_missing_csv_and_a_bad_line_are_named(tmp_path):
    (tmp_path / "deck.toml").write_text(EVERYTHING)
    with pytest.raises(DeckError, match=r"deck.toml:\d+: block.quarter.bottom.csv: cannot read 'shore.csv'"):
        read_deck(tmp_path / "deck.toml")
    (tmp_path / "shore.csv").write_text("x,y\n2,0\n3,foot\n4,0\n")
    with pytest.raises(DeckError, match=r"shore.csv:3: expected two finite numbers"):
        read_deck(tmp_path / "deck.toml")


def test_init_writes_the_schema_of_a_solver(tmp_path, capsys):
    from hugoniot.cli.main import main

    with pytest.raises(SystemExit) as ended:
        main(["init", "--schema", "--solver", "lagrange2d", "--out", str(tmp_path / "s.json")])
    assert ended.value.code == 0 and json.loads((tmp_path / "s.json").read_text())["properties"]["block"]
    with pytest.raises(SystemExit) as ended:
        main(["init", "--schema", "--solver", "lagrange3d"])
    assert ended.value.code == 2 and "did you mean 'lagrange" in capsys.readouterr().err


def test_large_meshes_keep_fewer_snapshots_unless_asked():
    small, large = (read_deck_text(BAR.replace("[4, 30]", zones)).problem.output for zones in ("[4, 30]", "[100, 101]"))
    assert small.snapshots == pytest.approx(0.8e-6) and large.snapshots == pytest.approx(4e-6)
    assert small.gauge_interval == pytest.approx(80e-6 / 2000)
    asked = read_deck_text(BAR.replace("[4, 30]", "[100, 101]") + '[output]\nsnapshots = "1 us"\ngauge_interval = 0\n').problem.output
    assert asked.snapshots == 1e-6 and asked.gauge_interval == 0.0


@pytest.mark.parametrize("more", ["", '\ndiagonal = "alternating"\naverage_pressure = false'])
def test_a_deck_of_triangles_is_written_out_and_reads_back(more):
    """Every default of triangles, and none of quadrilaterals."""
    deck = read_deck_text(BAR.replace('kind = "lagrange2d"', 'kind = "lagrange2d"\ncells = "triangles"' + more))
    again = read_deck_text(deck.resolved)
    assert again.problem == deck.problem and "hourglass" not in deck.resolved
    assert again.problem.mesh.zone_nodes.shape == (240, 3)
    assert again.problem.solver.average_pressure is not bool(more)
    plain = read_deck_text(BAR)
    assert not any(word in plain.resolved for word in ("diagonal", "average_pressure"))


def test_blocks_without_a_solver_for_them_are_one_error():
    text = """title = "bar"
stop_time = "1 us"
[[block]]
name = "b"
"""
    with pytest.raises(DeckError) as caught:
        read_deck_text(text)
    (problem,) = caught.value.problems
    assert problem.line == 3 and "[[region]], not [[block]]" in problem.message and 'kind = "lagrange2d"' in problem.hint


SIDE = """stop_time = "1 us"
geometry = "plane"
[[block]]
name = "b"
material = "m"
x = ["0 mm", "4 mm"]
y = ["0 mm", "1 mm"]
zones = [{zones}, 2]
velocity = ["{u} m/s", "0 m/s"]
[[boundary]]
on = "b.left"
kind = "{kind}"
{more}
[solver]
kind = "lagrange2d"
[material.m.eos]
law = "mie_gruneisen"
rho0 = 2700.0
c0 = 5200.0
s = 1.5
gamma0 = 2.0
"""


@pytest.mark.parametrize(("values", "words"), [
    ({"kind": "velocity", "more": 'velocity = "50 km/s"'}, ["material 'm' is driven to a particle velocity of about 5e+04 m/s"]),
    ({"kind": "velocity", "more": 'velocity = "-50 km/s"'}, []),
    ({"kind": "velocity", "more": 'velocity = "-50 km/s"\ndirection = [-1, 0]'}, ["driven to a particle velocity of about 5e+04 m/s"]),
    ({"kind": "velocity", "more": 'velocity = "5000 km/s"'}, ["driven to a particle velocity", "the boundary 'b.left' moves at 5e+06 m/s"]),
    ({"kind": "wall", "u": "-50e3"}, ["driven to a particle velocity of about 5e+04 m/s"]), ({"kind": "wall", "u": "50e3"}, []),
    # sound takes 19.2 ns through 0.1 mm
    ({"kind": "pressure", "more": 'pressure = {shape = "square", amplitude = "1 GPa", duration = "19 ns"}'}, ["is driven for 19 ns, but sound takes 19.2 ns"]),
    ({"kind": "pressure", "more": 'pressure = {shape = "square", amplitude = "1 GPa", duration = "20 ns"}'}, []),
    ({"kind": "wall", "more": "[output]\nsnapshots = 20"}, ["snapshots = 20 s is the time between two of them, and longer than the run of 1 us"]),
])
@pytest.mark.parametrize("cells", ["quads", "triangles"])
def test_what_sides_do_is_warned_of_as_in_one_dimension(values, words, cells):
    """A wall and a driven side drive the material as an end does; a short pulse; and a number of snapshots is read as seconds."""
    text = SIDE.format(**{"zones": 40, "u": 0, "more": ""} | values).replace('"lagrange2d"', f'"lagrange2d"\ncells = "{cells}"')
    warnings = read_deck_text(text).warnings
    assert len(warnings) == len(words) and all(part in text for part, text in zip(words, warnings))


def test_erosion_by_plastic_strain_needs_a_material_with_strength():
    text = SIDE.format(zones=4, u=0, kind="wall", more="[solver.erosion]\nplastic_strain = 1.5")
    with pytest.raises(DeckError, match="solver.erosion.plastic_strain: has no effect"):
        read_deck_text(text)
    assert read_deck_text(text + '[material.m.strength]\nlaw = "perfectly_plastic"\nshear_modulus = "25 GPa"\nyield_stress = "0.3 GPa"\n')
