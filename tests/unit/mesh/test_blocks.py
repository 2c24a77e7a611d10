"""Meshes of several blocks: one numbering, joints whatever way indices run, chains, and errors that say where."""

import math

import numpy as np
import pytest

from hugoniot.mesh.blocks import BlockShape, MeshError, build
from hugoniot.mesh.checks import corner_areas, subzone_areas
from hugoniot.mesh.shapes import Box, Curve, Edges, Sector


def box(name, x, y, zones, **more):
    return BlockShape(name, Box(x, y), zones, **more)


def line(*points, spacing="length"):
    return Curve("line" if len(points) == 2 else "polyline", points, spacing)


def areas(mesh):
    x, y = mesh.nodes[:, mesh.zone_nodes].transpose(0, 2, 1)
    return 0.5 * ((x[2] - x[0]) * (y[3] - y[1]) - (x[3] - x[1]) * (y[2] - y[0]))


def test_index_i_runs_along_the_first_coordinate_and_zones_are_counter_clockwise():
    mesh = build([box("a", (0.0, 3.0), (0.0, 1.0), (3, 2))])
    block = mesh.blocks[0]
    assert np.array_equal(block.x[:, 0], [0.0, 1.0, 2.0, 3.0]) and np.array_equal(block.y[0], [0.0, 0.5, 1.0])
    assert np.array_equal(mesh.zone_nodes[1], [block.nodes[0, 1], block.nodes[1, 1], block.nodes[1, 2], block.nodes[0, 2]])
    assert np.allclose(areas(mesh), 0.5)
    assert [len(chain.edges) for chain in mesh.chains.values()] == [2, 2, 3, 3]


def test_grading_along_both_directions():
    mesh = build([box("a", (0.0, 7.0), (0.0, 3.0), (3, 2), ratio=(2.0, 0.5))])
    assert np.allclose(np.diff(mesh.blocks[0].x[:, 0]), [1.0, 2.0, 4.0]) and np.allclose(np.diff(mesh.blocks[0].y[0]), [2.0, 1.0])


def _turned(name, corners, zones, turn):
    """A quadrilateral with its logical directions turned by `turn` quarter turns."""
    corners = corners[turn:] + corners[:turn]
    a, b, c, d = corners
    zones = zones if turn % 2 == 0 else zones[::-1]
    return BlockShape(name, Edges(line(a, d), line(b, c), line(a, b), line(d, c)), zones)


@pytest.mark.parametrize("turn", range(4))
@pytest.mark.parametrize("backwards", [False, True])
def test_a_joint_does_not_depend_on_the_way_indices_run(turn, backwards):
    second = _turned("b", [(1.0, 0.0), (3.0, 0.2), (3.0, 1.4), (1.0, 1.0)], (5, 4), turn)
    if backwards:   # curves may be drawn from either end
        shape = second.shape
        flipped = {s: Curve(c.kind, c.points[::-1]) for s in ("left", "right", "bottom", "top") for c in [getattr(shape, s)]}
        second = BlockShape("b", Edges(**flipped), second.zones)
    mesh = build([box("a", (0.0, 1.0), (0.0, 1.0), (3, 4)), second])
    assert mesh.nodes.shape[1] == 4 * 5 + 6 * 5 - 5
    assert list(mesh.joints) == ["a/b"] and len(mesh.joints["a/b"].edges) == 4
    assert (areas(mesh) > 0.0).all()
    assert sum(areas(mesh)) == pytest.approx(1.0 + 2.0 * 0.5 * (1.0 + 1.2), rel=1e-12)
    groups = np.split(mesh.shared, mesh.shared_start[1:-1])
    assert len(groups) == 5
    for members in groups:   # every group is one node, first block first
        assert [int(k) for k in members[:, 0]] == [0, 1]
        assert len({int(mesh.blocks[b].nodes[i, j]) for b, i, j in members}) == 1
        places = {(mesh.blocks[b].x[i, j], mesh.blocks[b].y[i, j]) for b, i, j in members}
        assert len(places) == 1   # bit for bit


def test_a_side_joined_in_part_keeps_the_rest_as_its_chain():
    mesh = build([box("plate", (0.0, 1.0), (0.0, 4.0), (2, 8)), box("rod", (1.0, 3.0), (1.0, 2.0), (3, 2))])
    chain = mesh.chains["plate.right"]
    assert chain.spans == ((0, 2), (4, 8)) and len(chain.edges) == 6
    assert "rod.left" not in mesh.chains and len(mesh.joints["plate/rod"].edges) == 2
    assert mesh.nodes[1, chain.nodes].tolist() == [0.0, 0.5, 1.0, 2.0, 2.5, 3.0, 3.5, 4.0]


def test_four_blocks_about_a_point_share_it_once():
    mesh = build([box(f"{i}{j}", (i, i + 1.0), (j, j + 1.0), (2, 2)) for i in (0, 1) for j in (0, 1)])
    assert mesh.nodes.shape[1] == 25
    sizes = np.diff(mesh.shared_start)
    assert sorted(sizes.tolist()) == [2] * 8 + [4]
    centre = mesh.shared[mesh.shared_start[sizes.argmax()] :][:4]
    assert centre.tolist() == [[0, 2, 2], [1, 2, 0], [2, 0, 2], [3, 0, 0]]


def test_a_ring_closes_on_itself():
    mesh = build([BlockShape("ring", Sector((0.5, -1.0), (1.0, 2.0), (0.0, 2.0 * math.pi)), (3, 16))])
    assert mesh.nodes.shape[1] == 4 * 16 and list(mesh.chains) == ["ring.left", "ring.right"]
    assert sum(areas(mesh)) == pytest.approx(0.5 * 16 * math.sin(2.0 * math.pi / 16) * (4.0 - 1.0), rel=1e-12)


def test_a_sector_reaches_the_axis_exactly_and_its_chain_knows():
    mesh = build([BlockShape("shell", Sector((0.0, 0.0), (0.08, 0.1), (-0.5 * math.pi, 0.5 * math.pi)), (4, 10))], axisymmetric=True)
    assert mesh.chains["shell.bottom"].on_axis and mesh.chains["shell.top"].on_axis and not mesh.chains["shell.left"].on_axis
    assert (mesh.nodes[0, mesh.chains["shell.top"].nodes] == 0.0).all()
    assert np.array_equal(mesh.straight_normal(mesh.chains["shell.top"]), [-1.0, 0.0])
    assert mesh.straight_normal(mesh.chains["shell.right"]) is None


def test_outward_normals_leave_the_block():
    mesh = build([BlockShape("s", Sector((0.0, 0.0), (1.0, 2.0), (0.2, 1.1)), (3, 40))])
    for chain in mesh.chains.values():
        middle = mesh.nodes[:, chain.edges].mean(axis=2)
        zone = mesh.nodes[:, mesh.zone_nodes[chain.zones]].mean(axis=2)
        assert ((mesh.outward_normals(chain) * (middle - zone)).sum(axis=0) > 0.0).all()
    tilted = mesh.straight_normal(mesh.chains["s.bottom"])
    assert np.allclose(tilted, [math.sin(0.2), -math.cos(0.2)], atol=1e-14)


def test_an_arc_through_three_points_lies_on_its_circle():
    arc = Curve("arc", ((1.0, 0.0), (math.cos(0.3), math.sin(0.3)), (math.cos(2.5), math.sin(2.5))))
    a, b = arc.points[0], arc.points[-1]
    outer = Curve("arc", tuple((3.0 * x, 3.0 * y) for x, y in arc.points))
    shape = Edges(left=arc, right=outer, bottom=line(a, (3.0, 0.0)), top=line(b, outer.points[-1]))
    mesh = build([BlockShape("part", shape, (4, 12))])
    radius = np.hypot(*mesh.nodes[:, mesh.chains["part.left"].nodes])
    assert np.abs(radius - 1.0).max() < 1e-14
    steps = np.hypot(*np.diff(mesh.nodes[:, mesh.chains["part.left"].nodes], axis=1))
    assert np.ptp(steps) < 1e-13


def test_points_of_a_polyline_may_be_the_nodes_themselves():
    n = 100   # Saltzman's mesh: x = i/100 + (10 - j)/100 sin(pi i/100), y = j/100
    i, j = np.meshgrid(np.arange(n + 1), np.arange(11), indexing="ij")
    x = 0.01 * i + (10 - j) * 0.01 * np.sin(np.pi * i / n)
    bottom = Curve("polyline", tuple((float(a), 0.0) for a in x[:, 0]), "points")
    shape = Edges(line((0.0, 0.0), (0.0, 0.1)), line((1.0, 0.0), (1.0, 0.1)), bottom, line((0.0, 0.1), (1.0, 0.1)))
    block = build([BlockShape("gas", shape, (n, 10))]).blocks[0]
    assert np.allclose(block.x, x, atol=1e-14) and np.allclose(block.y, 0.01 * j, atol=1e-14)


# -- equipotential zoning ------------------------------------------------------------------------------------------
def _bump(fill, sign=1.0):
    """A square with a high, narrow bump in its bottom edge, which transfinite interpolation folds over; `sign` mirrors it."""
    x = np.linspace(0.0, 1.0, 201)
    height = 0.8 * np.exp(-(((x - 0.7) / 0.12) ** 2))
    height[0] = height[-1] = 0.0
    sides = line((0.0, 0.0), (0.0, 1.0)), line((sign, 0.0), (sign, 1.0))
    bottom = Curve("polyline", tuple(zip((sign * x).tolist(), height.tolist())))
    edges = Edges(*(sides if sign > 0.0 else sides[::-1]), bottom, line((0.0, 1.0), (sign, 1.0)), fill)
    return BlockShape("bump", edges, (16, 16))


def test_winslow_leaves_a_rectangle_and_an_annulus_as_potential_theory_does():
    sides = line((0.0, 0.0), (0.0, 1.0)), line((2.0, 0.0), (2.0, 1.0)), line((0.0, 0.0), (2.0, 0.0)), line((0.0, 1.0), (2.0, 1.0))
    block = build([BlockShape("box", Edges(*sides, "winslow"), (8, 6), (1.2, 0.9))]).blocks[0]
    plain = build([box("box", (0.0, 2.0), (0.0, 1.0), (8, 6), ratio=(1.2, 0.9))]).blocks[0]
    assert np.abs(block.x - plain.x).max() < 1e-9 and np.abs(block.y - plain.y).max() < 1e-9


@pytest.mark.parametrize("n", [8, 16])
def test_equipotentials_of_a_ring_are_circles_spaced_as_the_logarithm(n):
    def arc(r):
        return Curve("arc", ((r, 0.0), (r * math.cos(0.4), r * math.sin(0.4)), (0.0, r)))
    shape = Edges(arc(1.0), arc(3.0), line((1.0, 0.0), (3.0, 0.0)), line((0.0, 1.0), (0.0, 3.0)), "winslow")
    # the straight edges are spaced by length, so only the middle ray is free to follow log r: compare there, order two
    geometric = 3.0 ** np.linspace(0.0, 1.0, n + 1)
    bottom = Curve("polyline", tuple((float(r), 0.0) for r in geometric), "points")
    top = Curve("polyline", tuple((0.0, float(r)) for r in geometric), "points")
    shape = Edges(shape.left, shape.right, bottom, top, "winslow")
    block = build([BlockShape("ring", shape, (n, n))]).blocks[0]
    radius = np.hypot(block.x, block.y)
    error = np.abs(radius / geometric[:, None] - 1.0).max()
    assert error < 0.32 / n**2


def test_where_transfinite_interpolation_folds_winslow_does_not():
    with pytest.raises(MeshError, match=r"zone \(\d+, \d+\) of block 'bump'"):
        build([_bump("transfinite")])
    block, mirrored = (build([_bump("winslow", sign)]).blocks[0] for sign in (1.0, -1.0))
    assert (subzone_areas(np.array([block.x, block.y])) > 0.0).all()
    assert np.abs(np.array([-mirrored.x[::-1], mirrored.y[::-1]]) - [block.x, block.y]).max() < 1e-8


# -- what is refused -----------------------------------------------------------------------------------------------
@pytest.mark.parametrize("shapes, block, words", [
    ([box("a", (0.0, 1.0), (0.0, 1.0), (3, 2)), box("b", (1.0, 2.0), (0.0, 1.0), (4, 3))], 0, "their nodes do not coincide"),
    ([box("a", (0.0, 1.0), (0.0, 1.0), (3, 2)), box("b", (0.9, 2.0), (0.1, 0.8), (4, 3))], 1, "overlaps block 'a'"),
    ([box("a", (0.0, 1.0), (0.0, 1.0), (3, 2)), box("b", (0.0, 1.0), (0.0, 1.0), (3, 2))], 1, "overlaps block 'a'"),
    ([box("a", (0.0, 1.0), (0.0, 1.0), (3, 2)), box("b", (0.5, 1.5), (0.0, 1.0), (3, 2))], 1, "overlaps block 'a'"),   # sides in line
    ([BlockShape("a", Sector((0.0, 0.0), (1.0, 2.0), (1.0, 0.0)), (3, 2))], 0, "runs clockwise"),
])
def test_blocks_that_make_no_mesh(shapes, block, words):
    with pytest.raises(MeshError, match=words) as caught:
        build(shapes)
    assert block in {defect.block for defect in caught.value.defects} and all(d.hint for d in caught.value.defects)


def test_blocks_apart_are_bodies_of_their_own():
    shapes = [box("a", (0.0, 1.0), (0.0, 1.0), (3, 2)), box("b", (1.1, 2.0), (0.0, 1.0), (3, 2))]
    assert not build(shapes).joints
    touching = [box("a", (0.0, 1.0), (0.0, 1.0), (3, 2)), box("b", (1.0, 2.0), (0.0, 1.0), (3, 5))]
    assert not build(touching, apart={(0, 1)}).joints
    with pytest.raises(MeshError, match="overlaps"):
        build([touching[0], box("b", (0.9, 2.0), (0.0, 1.0), (3, 5))], apart={(0, 1)})


def test_a_node_beyond_the_axis_is_refused():
    with pytest.raises(MeshError, match="beyond the axis"):
        build([box("a", (-1.0, 1.0), (0.0, 1.0), (4, 2))], axisymmetric=True)


def test_edges_that_do_not_meet_are_named():
    shape = Edges(line((0.0, 0.0), (0.0, 1.0)), line((1.0, 0.0), (1.0, 1.0)), line((0.0, 0.0), (1.0, 0.0)), line((0.0, 1.1), (1.0, 1.0)))
    with pytest.raises(MeshError, match="does not meet") as caught:
        build([BlockShape("a", shape, (2, 2))])
    assert caught.value.defects[0].key == "top"


def test_quarters_of_a_zone_make_it_up():
    nodes = np.array([[[0.0, 0.1], [1.0, 1.3]], [[0.0, 1.0], [-0.2, 0.9]]])
    corners, quarters = corner_areas(nodes)[:, 0, 0], subzone_areas(nodes)[:, 0, 0]
    assert quarters.sum() == pytest.approx(corners[0] + corners[2], rel=1e-14) and (quarters > 0.0).all()
