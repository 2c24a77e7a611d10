"""What a deck says of contact: laws between bodies, and rigid bodies; checked against the blocks, and written back."""

from collections.abc import Sequence
from functools import partial

import numpy as np

from hugoniot.materials.collect import Collector, nearest, printable
from hugoniot.mesh.blocks import Blocks
from hugoniot.mesh.checks import TOUCHING
from hugoniot.mesh.joining import distance_to_edges, inside
from hugoniot.problem.boundaries import pulse_value, read_pulse
from hugoniot.problem.plane.contact_model import Contact2D, Rigid2D, polygon_moments
from hugoniot.problem.plane.edges import unit_vector

CHORDS = 0.1     # of an edge: how deep an open line may run in material, as the chords of one curve do that is divided twice


def read_contacts(rows: Sequence, blocks: Sequence[str], rigid: Sequence[str], collector: Collector) -> tuple[Contact2D, ...]:
    """Laws of contact between blocks and rigid bodies that exist, each pair once."""
    known, seen, found = [*blocks, *rigid], {}, []
    for i, row in enumerate(rows):
        if row is None:
            continue
        path, before = ("contact", i), collector.findings
        if (row.strength is not None) != (row.kind == "separable"):
            if row.kind == "separable":
                collector.add((*path, "strength"), "missing", 'for example strength = "50 MPa"')
            else:
                hint = 'write kind = "separable", or leave it out'
                collector.add((*path, "strength"), f"does not apply to contact of kind {row.kind}", hint)
        if row.kind == "bonded" and row.friction > 0.0:
            collector.add((*path, "friction"), "does not apply to bonded contact, which does not slide", "leave it out")
        for name in row.between or ():
            if name not in known:
                collector.add((*path, "between"), f"no block or rigid body '{printable(name)}'", partial(nearest, name, known))
        if row.between and all(name in rigid for name in row.between):
            collector.add((*path, "between"), "contact between two rigid bodies is not computed", "name a block")
        key = None if row.between is None else tuple(sorted(row.between))
        if key in seen:
            collector.add((*path, "between") if key else path, f"is already given by contact {seen[key] + 1}", "each pair has one law")
        seen.setdefault(key, i)
        if collector.findings == before:
            found.append(Contact2D(row.between, row.kind, row.friction, row.strength))
    return tuple(found)


def check_bodies(contacts: Sequence[Contact2D], rows: Sequence, mesh: Blocks | None, rigid: Sequence, collector: Collector) -> None:
    """Report a law of contact in a deck whose blocks are one body: there is nothing to meet."""
    if mesh is None or len(contacts) != len(rows):
        return
    for i, contact in enumerate(contacts):
        if contact.between is None and not rigid and bodies(mesh).max() == 0 and len(contacts) == 1:
            collector.add(("contact", i), "all blocks are joined into one body, and there is no other that it could touch",
                          'name two blocks with between = ["A", "B"], or leave it out')


def bodies(mesh: Blocks) -> np.ndarray:
    """Number of the body of every block: blocks that share nodes are one body."""
    group = np.arange(len(mesh.blocks))
    for joint in mesh.joints.values():
        low, high = sorted(group[list(joint.blocks)])
        group[group == high] = low
    return np.unique(group, return_inverse=True)[1]


def may_meet(problem) -> bool:
    """Whether anything in a problem may meet: several bodies, a rigid one, blocks that a contact keeps apart, or zones that lose others."""
    lets_go = any(boundary.separable for boundary in problem.boundaries)
    return bool(problem.contacts or problem.rigid or lets_go or problem.solver.erosion) or int(bodies(problem.mesh).max()) > 0


def trouble_on_the_axis(problem) -> str:
    """Why bodies of a problem cannot meet on the axis; empty where they can.

    With `area_weighted` a node on the axis has no mass per radian of its own, so that an impulse shared with it has no bound.
    """
    if problem.geometry == "plane" or problem.solver.scheme != "area_weighted" or not may_meet(problem):
        return ""
    if not any(chain.on_axis for chain in problem.mesh.chains.values()):
        return ""
    return ('bodies cannot meet on the axis with "area_weighted", where a node has no mass per radian, '
            "so that its share of an impulse is unbounded")


def read_rigid(rows: Sequence, axes, blocks: Sequence[str], collector: Collector) -> tuple[Rigid2D, ...]:
    """Rigid bodies, each at rest, driven, or free with a mass."""
    found, names = [], set(blocks)
    for i, row in enumerate(rows):
        if row is None:
            continue
        path, before = ("rigid", i), collector.findings
        if row.name in names or row.name != row.name.strip() or not row.name.isprintable():
            message = f"'{printable(row.name)}' is taken or is not a valid name"
            collector.add((*path, "name"), message, "names of blocks and rigid bodies must differ")
        block, dot, _ = row.name.partition(".")
        if dot and block in blocks:     # "bar.right" is a side of it, whose forces and work would be added to those of the body
            collector.add((*path, "name"), f"'{printable(row.name)}' is named like a side of block '{printable(block)}'",
                          "choose a name without a full stop")
        names.add(row.name)
        if len(set(row.points)) < len(row.points):
            collector.add((*path, "points"), "lists a point twice", "leave the last point out: closed = true joins it to the first")
        elif row.closed and len(row.points) < 3:
            collector.add((*path, "points"), "a closed body needs at least three points")
        if axes[0] == "r" and min(x for x, _ in row.points) < 0.0:
            collector.add((*path, "points"), "has a negative radius", "radii are not negative; the axis is r = 0")
        _check_motion(row, axes, collector, path)
        direction = None if row.direction is None else unit_vector(row.direction, collector, (*path, "direction"))
        pulse = None if row.velocity is None else read_pulse(row.velocity, "m/s", collector, (*path, "velocity"))
        if collector.findings == before:
            if row.mass is not None and axes[0] == "r":
                direction = (0.0, 1.0)
            found.append(Rigid2D(row.name, row.points, row.closed, pulse, row.mass, row.start or (0.0, 0.0), direction, row.turns,
                                 row.inertia, row.centre, row.spin or 0.0))
    return tuple(found)


def check_overlap(rigid: Sequence[Rigid2D], mesh: Blocks | None, collector: Collector) -> None:
    """Report closed rigid bodies with material inside them, and rigid bodies inside of material."""
    for i, body in enumerate(rigid if mesh is not None else ()):
        line = np.array(body.points).T
        for block in mesh.blocks:
            around = np.concatenate([a[:-1] for a in (block.nodes[:, 0], block.nodes[-1], block.nodes[::-1, -1], block.nodes[0, ::-1])])
            own = mesh.nodes[:, around]
            for points, polygon in (((own, line), (line, own)) if body.closed else ((_between_crossings(line, own), own),)):
                away, _ = distance_to_edges(points, polygon, np.roll(polygon, -1, axis=1))
                covered = inside(points, polygon) & (away > (TOUCHING if body.closed else CHORDS))
                if covered.any():
                    x, y = points[:, covered][:, 0]
                    collector.add(("rigid", i, "points"), f"overlaps block '{block.name}' near ({x:.6g}, {y:.6g}) m",
                                  "at the start bodies may touch, but not overlap")
                    break


def _between_crossings(line: np.ndarray, polygon: np.ndarray) -> np.ndarray:
    """A point of every piece (2, n) into which the edges of a polygon cut a polyline: inside, outside or on them as the whole piece is."""
    start, along = polygon, np.roll(polygon, -1, axis=1) - polygon
    found = []
    for a, b in zip(line.T, line.T[1:]):
        way, off = (b - a)[:, None], start - a[:, None]
        across = way[0] * along[1] - way[1] * along[0]
        with np.errstate(divide="ignore", invalid="ignore"):
            t, s = ((off[0] * v[1] - off[1] * v[0]) / across for v in (along, way))
        cuts = np.sort(np.concatenate(([0.0], t[(t > 0.0) & (t < 1.0) & (s >= 0.0) & (s <= 1.0)], [1.0])))
        found.append(a[:, None] + way * 0.5 * (cuts[1:] + cuts[:-1]))
    return np.concatenate(found, axis=1)


def _check_motion(row, axes, collector: Collector, path: tuple) -> None:
    if row.velocity is not None and row.mass is not None:
        collector.add((*path, "mass"), "does not apply to a driven body", "leave out velocity or mass")
    if row.start is not None and row.mass is None:
        collector.add((*path, "start"), "applies only to a body with a mass", "give it a mass, or drive it with velocity")
    if row.velocity is not None and row.direction is None:
        collector.add((*path, "direction"), "missing", "for example direction = [0, -1]")
    if row.direction is not None and row.velocity is None and row.mass is None:
        collector.add((*path, "direction"), "does not apply to a body at rest", "give velocity or mass, or leave it out")
    _check_turning(row, axes, collector, path)
    moving = [v for v in (row.direction, row.start) if v is not None]
    if axes[0] == "r" and any(v[0] != 0.0 for v in moving):
        collector.add((*path, "direction" if row.direction is not None else "start"), "a rigid ring moves along the axis only",
                      "leave the first number 0")


def _check_turning(row, axes, collector: Collector, path: tuple) -> None:
    if not row.turns:
        for key in ("inertia", "centre", "spin"):
            if getattr(row, key) is not None:
                collector.add((*path, key), "applies only to a body that turns", "write turns = true, or leave it out")
        return
    if axes[0] == "r":
        collector.add((*path, "turns"), "a rigid ring moves along the axis only", "leave it out, or use geometry = \"plane\"")
    elif row.mass is None:
        collector.add((*path, "turns"), "applies only to a body with a mass", "give it a mass, or leave it out")
    elif row.direction is not None:
        collector.add((*path, "turns"), "does not apply to a body that is guided along a direction", "leave out turns or direction")
    elif not row.closed and (row.inertia is None or row.centre is None):
        missing = "inertia" if row.inertia is None else "centre"
        collector.add((*path, missing), "missing: it cannot be computed for an open line, which encloses no area",
                      "give both inertia and centre")
    elif row.closed and (row.inertia is None or row.centre is None) and polygon_moments(row.points)[0] == 0.0:
        message = "encloses no area, so the centre and the moment of inertia cannot be computed"
        collector.add((*path, "points"), message, "give both inertia and centre")


def contact_tables(contacts: Sequence[Contact2D]) -> list[dict]:
    """Tables [[contact]] of a deck."""
    rows = [{"between": None if c.between is None else list(c.between), "kind": c.kind, "friction": c.friction, "strength": c.strength}
            for c in contacts]
    return [{key: value for key, value in row.items() if value is not None and (key, row["kind"]) != ("friction", "bonded")}
            for row in rows]


def rigid_tables(rigid: Sequence[Rigid2D]) -> list[dict]:
    """Tables [[rigid]] of a deck."""
    found = []
    for body in rigid:
        row = {"name": body.name, "points": [list(p) for p in body.points], "closed": body.closed}
        if body.pulse is not None:
            row["velocity"] = pulse_value(body.pulse)
        if body.mass is not None:
            row |= {"mass": body.mass, "start": list(body.start)}
        if body.direction is not None:
            row["direction"] = list(body.direction)
        if body.turns:
            row |= {"turns": True, "spin": body.spin}
            row |= {} if body.inertia is None else {"inertia": body.inertia}
            row |= {} if body.centre is None else {"centre": list(body.centre)}
        found.append(row)
    return found
