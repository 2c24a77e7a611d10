"""How deep nodes go into other bodies at any step of the examples in which bodies meet, found from the zones alone."""

from pathlib import Path

import numpy as np
import pytest
from contact_builders import N

from hugoniot.problem.deck import read_deck, read_deck_text
from hugoniot.problem.plane.contact import bodies
from hugoniot.solvers.lagrange2d.solver import Lagrange2D

pytestmark = pytest.mark.slow
EXAMPLES = Path(__file__).parents[2] / "examples"


class Outlines:
    """Outlines of the bodies of a run and the nodes on them, of the zones that are in the mesh."""

    def __init__(self, solver):
        self.solver, mesh = solver, solver.problem.mesh
        self.body, self.live, self.known = bodies(mesh)[mesh.block_of], np.zeros(0, dtype=bool), []

    def of_bodies(self):
        """(edges (n, 2), nodes) of every body."""
        mesh, live = self.solver.problem.mesh, self.solver.erosion.live
        live = np.ones(len(self.body), dtype=bool) if live is None else live
        if not np.array_equal(live, self.live):
            self.live, self.known = live.copy(), []
            for body in np.unique(self.body):
                zones = mesh.zone_nodes[live & (self.body == body)]
                edges = np.stack([zones, np.roll(zones, -1, axis=1)], axis=-1).reshape(-1, 2)
                _, where, times = np.unique(np.sort(edges, axis=1) @ [1 << 32, 1], return_index=True, return_counts=True)
                self.known.append((edges[where[times == 1]], np.unique(edges[where[times == 1]])))
        return self.known

    def depth(self):
        """Largest distance of a node inside another body from its outline, over the length of the edge there."""
        places, found = self.solver.nodes[[N.x, N.y]][:, self.solver.numbering.representative], 0.0
        for edges, own in self.of_bodies():
            a, along = places[:, edges[:, 0]], places[:, edges[:, 1]] - places[:, edges[:, 0]]
            for _, nodes in self.of_bodies():
                if nodes is own:
                    continue
                away = places[:, nodes][:, :, None] - a[:, None, :]
                left = along[0] * away[1] - along[1] * away[0]
                up, down = (away[1] >= 0.0) & (away[1] < along[1]), (away[1] < 0.0) & (away[1] >= along[1])
                inside = ((up & (left > 0.0)).sum(axis=1) - (down & (left < 0.0)).sum(axis=1)) != 0      # its winding number
                if inside.any():
                    away, length = away[:, inside], np.hypot(*along)
                    share = np.clip((away * along[:, None, :]).sum(axis=0) / length**2, 0.0, 1.0)
                    distance = np.hypot(*(away - share * along[:, None, :]))
                    nearest = distance.argmin(axis=1)
                    found = max(found, float((distance.min(axis=1) / length[nearest]).max()))
        return found


def deepest(solver, until):
    """The largest of these depths at any step."""
    outlines, found = Outlines(solver), 0.0
    while solver.time < until:
        solver.march(until, 1)
        found = max(found, outlines.depth())
    return found


@pytest.mark.parametrize("name", ["gap-disc", "flyer-disc", "rod"])
def test_no_node_is_deeper_than_a_thousandth_of_an_edge(name):
    """The solver reports no less than what is found, but for round-off."""
    given = read_deck(str(EXAMPLES / f"{name}.toml")).problem
    solver = Lagrange2D(given)
    found = deepest(solver, given.stop_time)
    assert found < 1e-3
    assert found <= solver.results()["contact_depth"] * (1.0 + 1e-6)


@pytest.mark.parametrize("mass, growth", [("kept", "1.1014"), ("kept", "1.1065"), ("dropped", "1.1065")])
def test_no_corner_passes_another_one_by_its_end(mass, growth):
    """Zones that leave the mesh make acute corners. When zones two thirds as large as those of the example leave beside the head of the
    rod, corners of the rod and of the target slide past each other's ends and back."""
    text = (EXAMPLES / "rod.toml").read_text().replace("plastic_strain = 1.5", f'plastic_strain = 1.5\nmass = "{mass}"')
    for old, new in (("[12, 64]", "[18, 96]"), ("[18, 64]", "[27, 96]"), ("[4, 48]", "[6, 72]"), ("[1.16,", f"[{growth},")):
        assert old in text
        text = text.replace(old, new)
    assert deepest(Lagrange2D(read_deck_text(text, "rod.toml").problem), 4.5e-6) < 1e-3
