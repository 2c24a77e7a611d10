"""What a deck says of contact and rigid bodies: read, refused with its line, written back."""

import pytest

from hugoniot.errors import DeckError
from hugoniot.problem.deck import read_deck_text, write_deck
from hugoniot.problem.plane.contact_model import Contact2D, centre_of, inertia_of

BODIES = """
geometry = "plane"
stop_time = "1 us"
[[block]]
name = "target"
material = "al"
x = ["0 mm", "4 mm"]
y = ["0 mm", "4 mm"]
zones = [4, 4]
[[block]]
name = "flyer"
material = "al"
x = ["0 mm", "4 mm"]
y = ["{start} mm", "7 mm"]
zones = [{across}, 4]
velocity = ["0 m/s", "-100 m/s"]
[material.al.eos]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5200 m/s"
s = 1.5
gamma0 = 2.0
[solver]
kind = "lagrange2d"
"""


def read(extra="", start=5, across=4):
    return read_deck_text(BODIES.format(start=start, across=across) + extra, "deck.toml").problem


def test_bodies_apart_need_no_contact_named():
    problem = read()
    assert problem.contacts == ()
    assert len(problem.mesh.joints) == 0


@pytest.mark.parametrize("across", [4, 7])
def test_a_contact_keeps_blocks_that_touch_from_being_joined(across):
    problem = read('[[contact]]\nbetween = ["target", "flyer"]\nfriction = 0.3\n', start=4, across=across)
    assert problem.contacts == (Contact2D(("target", "flyer"), "sliding", 0.3),)
    assert not problem.mesh.joints
    assert read(start=4).mesh.joints


def test_what_is_written_reads_back():
    extra = """
[[contact]]
kind = "separable"
strength = "50 MPa"
[[contact]]
between = ["flyer", "wall"]
friction = 0.1
[[rigid]]
name = "wall"
points = [["-1 mm", "-1 mm"], ["5 mm", "-1 mm"]]
[[rigid]]
name = "punch"
points = [["1 mm", "9 mm"], ["1 mm", "8 mm"], ["3 mm", "8 mm"]]
closed = true
mass = 0.2
start = ["0 m/s", "-50 m/s"]
direction = [0, -2]
[[rigid]]
name = "wheel"
points = [["8 mm", "0 mm"], ["10 mm", "0 mm"], ["10 mm", "3 mm"], ["8 mm", "3 mm"]]
closed = true
mass = 0.2
turns = true
spin = "50 1/s"
[[rigid]]
name = "arm"
points = [["12 mm", "0 mm"], ["14 mm", "0 mm"]]
mass = 0.2
turns = true
inertia = "1 g cm^2"
centre = ["13 mm", "1 mm"]
"""
    problem = read(extra)
    wheel = problem.rigid[2]
    assert centre_of(wheel) == pytest.approx((9e-3, 1.5e-3))
    assert inertia_of(wheel) == pytest.approx(0.2 * (2e-3**2 + 3e-3**2) / 12.0)
    assert read_deck_text(write_deck(problem), "deck.toml").problem == problem


WRONG = {
    'between = ["target", "flier"]': ("contact.1.between", "did you mean 'flyer'|flyer"),
    'kind = "separable"': ("strength", "missing"),
    'strength = "1 MPa"': ("strength", "does not apply"),
    'kind = "bonded"\nfriction = 0.1': ("friction", "does not slide"),
}


@pytest.mark.parametrize("words", WRONG)
def test_a_wrong_contact_is_refused_with_its_line(words):
    with pytest.raises(DeckError) as caught:
        read(f"[[contact]]\n{words}\n")
    text = str(caught.value)
    line = int(text.split(":")[1])
    assert BODIES.count("\n") < line <= BODIES.count("\n") + 3
    assert any(part in text for part in WRONG[words][1].split("|"))


def test_a_contact_of_one_body_is_refused():
    with pytest.raises(DeckError, match="no other that it could touch"):
        read("[[contact]]\nfriction = 0.1\n", start=4)


def test_surfaces_that_overlap_at_the_start_are_refused():
    with pytest.raises(DeckError, match=r"deck.toml:\d+: .*overlaps block 'target'"):
        read('[[contact]]\nbetween = ["target", "flyer"]\n', start=3.5)
    with pytest.raises(DeckError, match=r"deck.toml:\d+: .*overlaps block 'target'"):
        read('[[rigid]]\nname = "p"\npoints = [["1 mm", "3 mm"], ["3 mm", "3 mm"], ["2 mm", "4.5 mm"]]\nclosed = true\n')


@pytest.mark.parametrize("motion, words", [
    ('velocity = "10 m/s"', "direction"), ('velocity = "10 m/s"\ndirection = [0, 1]\nmass = 1.0', "driven"),
    ("direction = [0, 1]", "at rest"), ("mass = 1.0\nspin = 2.0", "a body that turns"), ("turns = true", "a body with a mass"),
    ("mass = 1.0\nturns = true", "inertia"), ("mass = 1.0\nturns = true\ndirection = [0, 1]", "guided"), ('start = ["0 m/s", "1 m/s"]', "a body with a mass")])
def test_a_rigid_body_is_at_rest_driven_or_free(motion, words):
    with pytest.raises(DeckError, match=words):
        read(f'[[rigid]]\nname = "w"\npoints = [["0 mm", "9 mm"], ["4 mm", "9 mm"]]\n{motion}\n')


@pytest.mark.parametrize("points", ['[["1 mm", "2 mm"], ["3 mm", "2 mm"]]', '[["-1 mm", "1 mm"], ["5 mm", "3 mm"]]', '[["2 mm", "-1 mm"], ["2 mm", "8 mm"]]'])
def test_an_open_rigid_line_through_material_is_refused(points):
    with pytest.raises(DeckError, match="rigid.*points: overlaps block 'target'"):
        read(f'[[rigid]]\nname = "plate"\npoints = {points}\n')


@pytest.mark.parametrize("points", ['[["-1 mm", "0 mm"], ["5 mm", "0 mm"]]', '[["-1 mm", "4.5 mm"], ["5 mm", "4.5 mm"]]', '[["0 mm", "-1 mm"], ["0 mm", "8 mm"]]'])
def test_an_open_rigid_line_may_touch_material_and_lie_between_bodies(points):
    assert len(read(f'[[rigid]]\nname = "plate"\npoints = {points}\n').rigid) == 1


def test_a_rigid_body_that_is_wrong_is_no_second_mistake_in_its_contact():
    extra = '[[rigid]]\nname = "plate"\npoints = [["0 mm", "0 mm"], ["0 mm", "0 mm"]]\n[[contact]]\nbetween = ["target", "plate"]\n'
    with pytest.raises(DeckError) as caught:
        read(extra)
    assert len(caught.value.problems) == 1 and "lists a point twice" in str(caught.value)


def test_bodies_do_not_meet_on_the_axis_with_area_weighted():
    text = BODIES.replace('"plane"', '"axisymmetric"').replace("\nx = [", "\nr = [").replace("\ny = [", "\nz = [").format(start=5, across=4)
    with pytest.raises(DeckError, match="bodies cannot meet on the axis"):
        read_deck_text(text + 'scheme = "area_weighted"\n', "deck.toml")
    assert read_deck_text(text, "deck.toml").problem.solver.scheme == "true_volume"


@pytest.mark.parametrize("speed, material, contact, warned", [
    ("-700 m/s", "copper", False, True), ("700 m/s", "copper", False, True), ("0 m/s", "copper", False, False),
    ("-700 m/s", "air", False, False), ("-700 m/s", "copper", True, False)])
def test_bodies_that_collide_but_are_joined_are_warned_of(speed, material, contact, warned):
    """Joined they would carry any tension across the face at which they collide."""
    blocks = "".join(f'[[block]]\nname = "{name}"\nmaterial = "{material}"\nx = [0.0, 1.0]\ny = [{y}.0, {y + 1}.0]\nzones = [2, 2]\n{more}\n'
                     for name, y, more in (("target", 0, ""), ("flyer", 1, f'velocity = ["0 m/s", "{speed}"]')))
    law = '[[contact]]\nbetween = ["flyer", "target"]\n' if contact else ""
    text = f'geometry = "plane"\nstop_time = "1 us"\n{blocks}{law}[solver]\nkind = "lagrange2d"\n'
    assert any("'target' and 'flyer'" in words and "joined" in words for words in read_deck_text(text).warnings) == warned
