"""Noh, Sedov, Kidder, Coggeshall, Saltzman: printed numbers (B5, B6, B8 to B10) and independent checks for any gamma and geometry."""

import numpy as np
import pytest
from flow_checks import jump_residual, residuals, total

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact import SOLUTIONS
from hugoniot.theory.exact.sedov import SURFACE, Profile

GEOMETRIES = ("planar", "cylindrical", "spherical")


def mass(f, x):
    return f["density"]


def energy(f, x):
    return f["density"] * (f["energy"] + 0.5 * f["velocity"] ** 2)


@pytest.mark.parametrize("geometry,plateau", list(zip(GEOMETRIES, (4.0, 16.0, 64.0))))
def test_noh_printed_values(geometry, plateau):
    solution = SOLUTIONS["noh"](geometry)
    assert solution.numbers["plateau_density"] == pytest.approx(plateau, rel=1e-14)
    assert solution.numbers["plateau_pressure"] == pytest.approx(plateau / 3.0, rel=1e-14)
    assert solution.jumps(0.6) == pytest.approx((0.2,), rel=1e-14)


@pytest.mark.parametrize("gamma", [1.2, 1.4, 5.0 / 3.0, 2.5])
@pytest.mark.parametrize("d,geometry", list(enumerate(GEOMETRIES, 1)))
def test_noh_for_any_gamma_conserves_and_jumps(d, geometry, gamma):
    solution = SOLUTIONS["noh"](geometry, gamma, 2.0, 3.0)
    assert jump_residual(solution, 0.7, 0) < 1e-6
    shock = solution.jumps(0.7)[0]
    outer = shock + 1.0
    came_from = outer + 3.0 * 0.7
    assert total(solution, 0.7, (0.0, shock, outer), mass) == pytest.approx(2.0 * came_from**d / d, rel=1e-12)
    assert total(solution, 0.7, (0.0, shock, outer), energy) == pytest.approx(0.5 * 9.0 * 2.0 * came_from**d / d, rel=1e-12)
    assert residuals(solution, np.linspace(1.1 * shock, 2.0 * shock, 20), 0.7, 1e-3) < 1e-9


@pytest.mark.parametrize("geometry,gamma,alpha", [
    ("planar", 1.4, 0.53874), ("cylindrical", 1.4, 0.98407442), ("spherical", 1.4, 0.85107218),
    ("planar", 5.0 / 3.0, 0.30147), ("cylindrical", 5.0 / 3.0, 0.56428359), ("spherical", 5.0 / 3.0, 0.49359027)])
def test_sedov_energy_integral_against_the_printed_table(geometry, gamma, alpha):
    # the table's last figures of the two-dimensional values are good to about 5e-7
    digits = 1e-5 if geometry == "planar" else 5e-7
    assert SOLUTIONS["sedov"](geometry, gamma).numbers["alpha"] == pytest.approx(alpha, rel=digits)


@pytest.mark.parametrize("geometry,energy_,radius", [("planar", 0.0673185, 0.5), ("cylindrical", 0.311357, 0.75), ("spherical", 0.851072, 1.0)])
def test_sedov_shock_radius_at_time_one(geometry, energy_, radius):
    # the energies are printed for radii good to about four, five and six figures
    digits = {"planar": 2e-4, "cylindrical": 1e-5, "spherical": 1e-7}[geometry]
    assert SOLUTIONS["sedov"](geometry, 1.4, energy_).jumps(1.0)[0] == pytest.approx(radius, rel=digits)


@pytest.mark.parametrize("gamma", [1.03, *(pytest.param(each, marks=pytest.mark.slow) for each in (1.1, 1.4, 5.0 / 3.0, 1.9995, 6.9, 7.5)),
                                   2.0, 2.002, 3.0, 7.0, 10.0])
@pytest.mark.parametrize("d,geometry", list(enumerate(GEOMETRIES, 1)))
def test_sedov_for_any_gamma_obeys_the_equations_and_conserves(d, geometry, gamma):
    solution = SOLUTIONS["sedov"](geometry, gamma, 2.0, 1.5)
    time = 0.8
    shock = solution.jumps(time)[0]
    assert jump_residual(solution, time, 0) < 1e-6
    start = 0.55 if Profile(gamma, d).case == "standard" else 0.9
    assert residuals(solution, np.linspace(start * shock, 0.98 * shock, 30), time, 5e-4) < 1e-7
    core = shock * np.exp(Profile(gamma, d).log_xi(60.0)) if Profile(gamma, d).case == "vacuum" else 0.0
    edges = np.unique(np.concatenate(([core], core + (shock - core) * np.array([1e-6, 1e-4, 1e-2, 0.1, 0.3, 0.6, 0.8, 1.0]))))
    assert total(solution, time, edges, mass) == pytest.approx(1.5 * shock**d / d, rel=3e-5)
    held = total(solution, time, edges, lambda f, x: f["pressure"] / (gamma - 1.0) + 0.5 * f["density"] * f["velocity"] ** 2)
    assert SURFACE[d] * held == pytest.approx(2.0, rel=2e-5)


def test_sedov_is_regular_at_the_origin():
    fields = SOLUTIONS["sedov"]()(np.array([0.0, 1e-6, 0.1]), 1.0)
    assert fields["density"][0] == 0.0 and fields["velocity"][0] == 0.0
    assert fields["pressure"][0] == pytest.approx(fields["pressure"][2], rel=1e-3)
    with pytest.raises(OutOfRange, match="gamma > 1"):
        SOLUTIONS["sedov"](gamma=1.0)


def test_kidder_printed_focussing_time():
    solution = SOLUTIONS["kidder"]()
    assert solution.numbers["tau"] == pytest.approx(7.26483157e-3, rel=1e-9)
    assert solution.numbers["gamma"] == 2.0


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_kidder_obeys_the_equations_in_every_geometry(geometry):
    solution = SOLUTIONS["kidder"](geometry, 0.8, 1.1, 0.2, 7.0, 0.05)
    time = 0.6 * solution.numbers["tau"]
    h = 0.8
    assert residuals(solution, h * np.linspace(0.82, 1.08, 30), time, 1e-3) < 1e-8
    faces = solution(h * np.array([0.8, 1.1]), time)
    assert faces["pressure"][1] / faces["pressure"][0] == pytest.approx(35.0, rel=1e-12)
    assert total(solution, time, (0.8 * h, 1.1 * h), mass) == pytest.approx(total(solution, 0.0, (0.8, 1.1), mass), rel=1e-12)


def test_coggeshall_printed_density():
    assert SOLUTIONS["coggeshall"]()(np.array([[0.5, 0.5]]), 0.8)["density"][0] == pytest.approx(37.384, abs=5e-4)
    assert SOLUTIONS["coggeshall"]()(np.array([[0.5, 0.8]]), 0.0)["energy"][0] == pytest.approx(0.09, rel=1e-14)


@pytest.mark.parametrize("gamma,axisymmetric", [(1.4, True), (5.0 / 3.0, True), (1.9, True), (1.4, False), (2.5, False)])
def test_coggeshall_obeys_the_equations(gamma, axisymmetric):
    solution = SOLUTIONS["coggeshall"](gamma, axisymmetric, 1.3)
    point, time, h = np.array([0.6, 0.7]), 0.3, 1e-5

    def at(r, z, t):
        f = solution(np.array([[r, z]]), t)
        return np.array([f["density"][0], f["velocity"][0, 0], f["velocity"][0, 1], f["energy"][0], f["pressure"][0]])

    r, z = point
    here = at(r, z, time)
    by_r, by_z = (at(r + h, z, time) - at(r - h, z, time)) / (2 * h), (at(r, z + h, time) - at(r, z - h, time)) / (2 * h)
    by_t = (at(r, z, time + h) - at(r, z, time - h)) / (2 * h)
    rate = by_t + here[1] * by_r + here[2] * by_z
    divergence = by_r[1] + by_z[2] + (here[1] / r if axisymmetric else 0.0)
    assert rate[0] == pytest.approx(-here[0] * divergence, rel=1e-8)
    assert here[0] * rate[1] == pytest.approx(-by_r[4], abs=1e-8)
    assert here[0] * rate[2] == pytest.approx(-by_z[4], rel=1e-8)
    assert here[0] * rate[3] == pytest.approx(-here[4] * divergence, rel=1e-8)


def test_saltzman_printed_sequence():
    numbers = SOLUTIONS["saltzman"]().numbers
    printed = dict(wall_time=0.75, piston_time=0.9, second_wall_time=0.95, density_1=4.0, density_2=10.0, density_3=20.0,
                   pressure_1=4.0 / 3.0, pressure_2=8.0, pressure_3=28.0)
    assert numbers == pytest.approx(printed, rel=1e-13)
    assert SOLUTIONS["saltzman"]().jumps(0.6) == pytest.approx((0.8,), rel=1e-14)
    assert SOLUTIONS["saltzman"]().jumps(0.9) == pytest.approx((0.9,), rel=1e-14)


@pytest.mark.parametrize("gamma", [1.2, 1.4, 5.0 / 3.0, 3.0])
def test_saltzman_work_of_the_piston_becomes_energy(gamma):
    solution = SOLUTIONS["saltzman"](gamma, 2.0, 3.0, 0.7)
    for time in (0.3 * solution.numbers["wall_time"], 0.999 * solution.numbers["piston_time"], 0.99 * solution.numbers["second_wall_time"]):
        assert jump_residual(solution, time, 0) < 1e-6
        edges = (2.0 * time, *solution.jumps(time), 3.0)
        assert total(solution, time, edges, mass) == pytest.approx(2.1, rel=1e-12)
    first, p1 = solution.numbers["piston_time"], solution.numbers["pressure_1"]
    assert total(solution, first, (2.0 * first, 3.0), energy) == pytest.approx(p1 * 2.0 * first, rel=1e-9)
