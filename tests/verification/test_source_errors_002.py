"""Errors of 002 (Herrmann) that no law shows: each formula as printed and as corrected, on one case; and 001's shock at 30 km/s."""

import numpy as np
import pytest

from hugoniot.materials.library import find
from hugoniot.theory.hugoniot import shock

SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])      # (x, z), the circuit whose area is positive


def circuit(psi, along):
    """Integral of psi along the sides of the square by their middles, by dx (0) or dz (1): exact for a linear psi."""
    ends = np.roll(SQUARE, -1, axis=0)
    return sum(psi(*(0.5 * (a + b))) * (b - a)[along] for a, b in zip(SQUARE, ends))


def test_h_e15_greens_second_line_has_a_minus():
    """5.8: with the circuit for which the first line, in dz, has a plus."""
    assert circuit(lambda x, z: x, 1) == pytest.approx(1.0)
    assert circuit(lambda x, z: z, 0) == pytest.approx(-1.0)


def gradient(psi, nodes, third):
    """B.3: d(psi)/dx from the values in meshes 1 to 4 about O, nodes A, B, C, D; `third` picks the node before z_C."""
    a, b, c, d = nodes
    weights = (d[1] - a[1], a[1] - b[1], third[1] - c[1], c[1] - d[1])
    area = 0.5 * abs((a[0] - c[0]) * (b[1] - d[1]) - (b[0] - d[0]) * (a[1] - c[1]))
    return sum(p * w for p, w in zip(psi, weights)) / area


def test_h_e16_a_constant_has_no_gradient():
    nodes = np.array([[-1.0, 0.1], [0.2, 1.1], [1.1, -0.2], [-0.1, -0.9]])     # clockwise
    assert gradient([3.0] * 4, nodes, nodes[1]) == pytest.approx(0.0, abs=1e-14)
    assert abs(gradient([3.0] * 4, nodes, nodes[3])) > 0.5
    sides = [0.5 * (nodes[i - 1] + nodes[i]) for i in range(4)]                # 1 between D and A, 2 between A and B, ...
    assert gradient([p[0] for p in sides], nodes, nodes[1]) == pytest.approx(1.0)
    assert gradient([p[0] for p in sides], nodes, nodes[3]) != pytest.approx(1.0, abs=0.1)


def test_h_e17_the_mean_of_a_mesh_takes_its_own_corners():
    """B.45 in a velocity field linear in position: corners B, F, C, O give the velocity in the middle of mesh 3, A, O, O, H do not."""
    place = {"A": (-1.0, 0.0), "O": (0.0, 0.0), "B": (0.0, 1.0), "C": (1.0, 0.0), "F": (1.0, 1.0), "H": (-1.0, -1.0)}
    u = {name: 2.0 * x + 3.0 * z for name, (x, z) in place.items()}
    assert np.mean([u[n] for n in "BFCO"]) == pytest.approx(2.0 * 0.5 + 3.0 * 0.5)
    assert np.mean([u[n] for n in "AOOH"]) != pytest.approx(2.5, abs=1.0)


def test_h_e18_corners_that_move_against_each_other_have_kinetic_energy():
    corners, mass = np.array([2.0, -2.0, 2.0, -2.0]), 3.0
    assert 0.5 * mass * np.mean(corners) ** 2 == 0.0
    assert 0.5 * mass * np.mean(corners**2) == pytest.approx(6.0)


@pytest.mark.parametrize("alpha", [2, 3])
def test_h_e19_mirrored_values_accelerate_a_fixed_surface(alpha):
    """A.6 with sigma, q, rho and phi outside as inside and mirrored x: the first term vanishes, the second does not."""
    sigma, phi, rho, x, h = 5.0e9, 1.0e8, 2700.0, 0.05, 1e-3
    radii = rho * (x + h + x) + rho * (x + x - h)
    a = -2.0 * ((sigma - sigma) / (2.0 * rho * h) - (alpha - 1) * (phi + phi) / radii)
    assert a == pytest.approx((alpha - 1) * phi / (rho * x), rel=1e-12) and a > 1e3


def test_h_e20_the_shear_term_on_the_axis_is_lost():
    """B.7 as B.8 fills it: t_xz = k x reflected with its sign changed, A/m = 1/(rho x) of each mesh; the limit on the axis is k/rho."""
    k, rho, x = 7.0e9, 2700.0, 1e-3
    inside = k * x / (rho * x)
    outside = -k * x / (rho * x)
    assert 0.25 * (2.0 * inside + 2.0 * outside) == 0.0
    assert inside == pytest.approx(k / rho)


def test_k_e12_aluminium_at_30_km_per_second():
    behind = shock(find("T008"), particle_velocity=3e4)
    assert float(behind.pressure) == pytest.approx(3.401e12, rel=0.01)
    assert float(behind.shock_velocity) == pytest.approx(41.99e3, rel=0.01)
