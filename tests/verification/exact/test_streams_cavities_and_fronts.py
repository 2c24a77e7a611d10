"""Blake's cavity, Noh's problem for any law, uniform collapse, Coggeshall's flows, meeting streams, detonation shock dynamics.

Every solution is held against its own equations, differentiated numerically, and against an answer found another way.
"""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos.contract import pressure
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.polynomial import Polynomial
from hugoniot.materials import library
from hugoniot.theory.exact import SOLUTIONS
from hugoniot.theory.exact.meeting_streams import Inflow
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.isentrope import isentrope, state
from hugoniot.theory.shock_polar import Stream, meeting

DIMENSION = {"planar": 1, "cylindrical": 2, "spherical": 3}


# -- Blake -------------------------------------------------------------------------------------------------------
def test_blake_satisfies_the_wall_the_front_and_momentum():
    made = SOLUTIONS["blake"](pressure=2e6, radius=0.2, density=2700.0, bulk_modulus=70e9, shear_modulus=20e9)
    c = made.numbers["sound_speed"]
    for t in (1e-9, 7e-6, 4e-5, 3e-4):
        assert made([0.2], t)["stress"][0] == pytest.approx(2e6, rel=1e-12)
        front = 0.2 + c * t
        assert made([front * (1.0 - 1e-9)], t)["stress"][0] == pytest.approx(2e6 * 0.2 / front, rel=1e-5)
        assert made([front * (1.0 + 1e-9)], t)["stress"][0] == 0.0
    r, t, h, k = 0.31, 6.1e-5, 1e-5, 2e-9
    near, far = made([r - h, r + h], t), made([r], t)
    stress, hoop = far["stress"][0], far["hoop_stress"][0]
    force = -(near["stress"][1] - near["stress"][0]) / (2 * h) - 2.0 * (stress - hoop) / r
    before, after = made([r], t - k), made([r], t + k)
    assert 2700.0 * (after["velocity"][0] - before["velocity"][0]) / (2 * k) == pytest.approx(force, rel=1e-6)
    assert (after["displacement"][0] - before["displacement"][0]) / (2 * k) == pytest.approx(far["velocity"][0], rel=1e-6)


def test_blake_comes_to_rest_and_overshoots():
    made = SOLUTIONS["blake"]()
    late = 60.0 * made.numbers["decay_time"]
    assert made([0.1, 0.3], late)["displacement"] == pytest.approx(1e6 * 0.1**3 / (4 * 25e9) / np.array([0.1, 0.3]) ** 2, rel=1e-12)
    assert made([0.1], late)["pressure"][0] == pytest.approx(0.0, abs=1e-6)
    times = np.linspace(0.0, made.numbers["period"], 3001)
    assert max(made([0.1], t)["displacement"][0] for t in times) == pytest.approx(made.numbers["largest_displacement"], rel=1e-6)
    with pytest.raises(OutOfRange, match="cavity"):
        made([0.05], 1e-6)


# -- Noh of any law ----------------------------------------------------------------------------------------------
@pytest.mark.parametrize("geometry", ["cylindrical", "spherical"])
def test_noh_of_the_ideal_gas_is_the_closed_form(geometry):
    mine = SOLUTIONS["noh_material"](IdealGas(1.3, 1.0), geometry, 2.0, 0.7)
    closed = SOLUTIONS["noh"](geometry, 1.3, 0.7, 2.0)
    for name, value in closed.numbers.items():
        assert mine.numbers[name] == pytest.approx(value, rel=1e-12), name
    r = np.linspace(0.05, 3.0, 40)
    for name in ("density", "velocity", "pressure", "energy"):
        assert mine(r, 0.9)[name] == pytest.approx(closed(r, 0.9)[name], rel=1e-12)


@pytest.mark.parametrize("material, speed", [("copper", 1500.0), ("water", 800.0), ("granite", 1200.0), ("air", 700.0), ("tungsten", 90.0)])
def test_planar_noh_is_the_hugoniot(material, speed):
    """In the frame of the inflow the wall is a piston of velocity U: the state behind it is the law's Hugoniot at u_p = U."""
    mine = SOLUTIONS["noh_material"](material, "planar", speed).numbers
    hugoniot = shock(library.find(material), particle_velocity=speed)
    assert mine["plateau_density"] == pytest.approx(hugoniot.density, rel=1e-11)
    assert mine["plateau_pressure"] == pytest.approx(hugoniot.pressure, rel=1e-10)
    assert mine["shock_speed"] == pytest.approx(hugoniot.shock_velocity - speed, rel=1e-10)


def test_spherical_noh_of_another_law_conserves_at_the_shock():
    par = Polynomial(1.2, 0.0, 0.0, 0.0, 0.55)  # p = 0.55 rho e: another family of the registry
    made = SOLUTIONS["noh_material"](par, "spherical", 900.0, 1.2)
    rho2, p2, e2, d = (made.numbers[n] for n in ("plateau_density", "plateau_pressure", "plateau_energy", "shock_speed"))
    rho1 = 1.2 * (1.0 + 900.0 / d) ** 2
    assert rho2 * d == pytest.approx(rho1 * (d + 900.0), rel=1e-12)
    assert p2 == pytest.approx(rho1 * (d + 900.0) * 900.0, rel=1e-12)
    assert p2 == pytest.approx(float(pressure(rho2, e2, par)), rel=1e-12)
    assert rho2 == pytest.approx(1.2 * (2.55 / 0.55) ** 3, rel=1e-11)


def test_converging_noh_of_a_solid_is_refused():
    with pytest.raises(OutOfRange, match="non-zero pressure"):
        SOLUTIONS["noh_material"]("copper", "spherical")


# -- uniform collapse and Coggeshall -----------------------------------------------------------------------------
def euler_residuals(made, geometry, r, t, gamma=None):
    """Relative residuals of continuity, momentum and energy (isentropic: de = p/rho^2 drho) by central differences."""
    d, h, k = DIMENSION[geometry], 1e-5 * r, 1e-5 * t
    here = {n: v[0] for n, v in made(np.array([r]), t).items()}

    def slope_r(name):
        low, high = made(np.array([r - h]), t)[name][0], made(np.array([r + h]), t)[name][0]
        return (high - low) / (2 * h)

    def slope_t(name):
        return (made(np.array([r]), t + k)[name][0] - made(np.array([r]), t - k)[name][0]) / (2 * k)

    rho, u, p = here["density"], here["velocity"], here["pressure"]
    divergence = slope_r("velocity") + (d - 1) * u / r
    continuity = (slope_t("density") + u * slope_r("density")) / rho + divergence
    momentum = slope_t("velocity") + u * slope_r("velocity") + slope_r("pressure") / rho
    energy = slope_t("energy") + u * slope_r("energy") + p / rho * divergence
    return abs(continuity / divergence), abs(momentum * r / u**2), abs(energy / (p / rho * divergence))


@pytest.mark.parametrize("geometry", DIMENSION)
@pytest.mark.parametrize("name, given", [("coggeshall_coasting", {"gamma": 1.4, "slope": -0.7}),
                                         ("coggeshall_driven", {"gamma": 1.2, "slope": 0.6}), ("coggeshall_driven", {"gamma": 3.0, "slope": -1.5}), ("uniform_collapse", {"gamma": 1.25}),
                                         ("coggeshall_collapse", {"slope": -1.1, "collapse_time": 2.0}),
                                         ("coggeshall_shell", {"slope": 1.2, "outer": 1.5, "density": 3.0, "collapse_time": 2.0}),
                                         ("coggeshall_shell", {"slope": -2.5, "outer": 1.5, "collapse_time": 2.0}),
                                         ("uniform_collapse", {"material": "copper", "collapse_time": 40.0})])
def test_smooth_flows_satisfy_the_equations(geometry, name, given):
    made = SOLUTIONS[name](geometry=geometry, **given)
    time = 1.3 if name.startswith("cogg") else 0.4
    assert max(euler_residuals(made, geometry, 0.8, time)) < 3e-6


@pytest.mark.parametrize("geometry", DIMENSION)
def test_coggeshalls_shell_of_uniform_entropy_is_kidders_without_inner_pressure(geometry):
    shell = SOLUTIONS["coggeshall_shell"](geometry, inner=0.8, outer=1.1, slope=0.0, density=0.05, collapse_time=0.3)
    kidder = SOLUTIONS["kidder"](geometry, 0.8, 1.1, 1e-60, shell.numbers["first_outer_pressure"], 0.05)
    assert kidder.numbers["tau"] == pytest.approx(0.3, rel=1e-9)
    r = 0.8 * np.linspace(0.85, 1.0999, 5)
    one, two = shell(r, 0.18), kidder(r, 0.18)
    assert all(one[k] == pytest.approx(two[k], rel=1e-8) for k in ("density", "velocity", "pressure", "energy"))
    assert np.isnan(shell([0.6, 0.9], 0.18)["density"]).all()


@pytest.mark.parametrize("geometry", DIMENSION)
@pytest.mark.parametrize("name, given", [("coggeshall_noh", {"rate": 0.4, "speed": 2.3}), ("coggeshall_noh", {"rate": -0.5, "speed": 1.7}),
                                         ("coggeshall_stopping", {"gamma": 5.0, "collapse_time": 2.0}), ("coggeshall_stopping", {"gamma": 1.4, "radius": 0.3})])
def test_coggeshalls_shocks_conserve_and_compress_between_flows_that_obey_the_equations(geometry, name, given):
    """Fluxes of mass, momentum and energy in the frame of the shock, whose speed is differenced; the gas enters on the thin side."""
    made, time = SOLUTIONS[name](geometry=geometry, **given), 0.7
    (place,), step = made.jumps(time), 1e-6
    speed = (made.jumps(time + step)[0] - made.jumps(time - step)[0]) / (2 * step)
    behind, ahead = ({k: float(v[0]) for k, v in made([place * (1 + side)], time).items()} for side in (-1e-9, 1e-9))
    fluxes = []
    for f in (behind, ahead):
        w = f["velocity"] - speed
        fluxes.append((f["density"] * w, f["pressure"] + f["density"] * w**2,
                       f["density"] * w * (f["energy"] + 0.5 * w**2) + f["pressure"] * w))
    assert fluxes[0] == pytest.approx(fluxes[1], rel=1e-7)
    assert fluxes[0][0] < 0.0 and behind["density"] > ahead["density"] and behind["pressure"] > 0.0 == ahead["pressure"]
    for r in (0.6 * place, 1.7 * place):
        d, h, k = DIMENSION[geometry], 1e-5 * r, 1e-5

        def slopes(field, r=r, h=h, k=k):
            at = [float(made([x], t)[field][0]) for x, t in ((r - h, time), (r + h, time), (r, time - k), (r, time + k))]
            return (at[1] - at[0]) / (2 * h), (at[3] - at[2]) / (2 * k)

        here = {n: float(v[0]) for n, v in made([r], time).items()}
        rho, u, p = here["density"], here["velocity"], here["pressure"]
        (rho_r, rho_t), (u_r, u_t), (p_r, _), (e_r, e_t) = (slopes(n) for n in ("density", "velocity", "pressure", "energy"))
        w, divergence = abs(u) + math.sqrt(p / rho), u_r + (d - 1) * u / r
        assert abs(rho_t + u * rho_r + rho * divergence) * r < 1e-7 * rho * w
        assert abs(rho * (u_t + u * u_r) + p_r) * r < 1e-7 * rho * w**2
        assert abs(rho * (e_t + u * e_r) + p * divergence) * r < 1e-7 * rho * w**3


def test_coggeshalls_shocks_in_the_cases_he_prints():
    still, noh = SOLUTIONS["coggeshall_noh"](rate=1e-9), SOLUTIONS["noh"]()
    for key, value in noh([0.05, 0.3], 0.4).items():
        assert key == "sound_speed" or still([0.05, 0.3], 0.4)[key] == pytest.approx(value, rel=1e-8, abs=1e-10)
    flow = SOLUTIONS["coggeshall_stopping"](radius=0.2, density=3.0)
    assert flow.jumps(0.5) == pytest.approx([0.8])
    assert flow([0.4], 0.5)["density"] / flow([1.6], 0.5)["density"] == pytest.approx(1.5 * 4.0**3)
    with pytest.raises(OutOfRange):
        SOLUTIONS["coggeshall_noh"](rate=-0.5)([0.1], 2.0)
    with pytest.raises(OutOfRange, match="slope"):
        SOLUTIONS["coggeshall_shell"]("cylindrical", slope=4.0)


def test_uniform_collapse_follows_the_isentrope_of_any_law():
    copper = library.find("copper")
    made = SOLUTIONS["uniform_collapse"]("spherical", material="copper", collapse_time=10.0)
    fields = made([0.1, 0.5], 0.5)
    assert fields["density"][0] == pytest.approx(8930.0 / 0.95**3, rel=1e-12)
    assert fields["pressure"][1] == pytest.approx(isentrope(copper, density=8930.0 / 0.95**3).pressure, rel=1e-10)
    with pytest.raises(OutOfRange):
        made([0.1], 5.0)  # eight times the density is beyond the law


# -- meeting streams ---------------------------------------------------------------------------------------------
def theta_beta_mach(beta, mach, gamma):
    """Deflection by an oblique shock of an ideal gas."""
    sine = (mach * math.sin(beta)) ** 2
    return math.atan(2.0 / math.tan(beta) * (sine - 1.0) / (mach**2 * (gamma + math.cos(2 * beta)) + 2.0))


def prandtl_meyer(mach, gamma):
    a = math.sqrt((gamma + 1.0) / (gamma - 1.0))
    return a * math.atan(math.sqrt(mach**2 - 1.0) / a) - math.atan(math.sqrt(mach**2 - 1.0))


def air(mach, p=1e5, rho=1.2, gamma=1.4):
    par = IdealGas(gamma, 1.2)
    ahead = state(par, pressure=p, density=rho)
    return Stream(par, ahead, mach * math.sqrt(gamma * p / rho))


@pytest.mark.parametrize("mach, ratio", [(1.7, 1.4), (3.0, 5.0), (8.0, 40.0)])
def test_polar_of_the_ideal_gas(mach, ratio):
    stream = air(mach)
    beta = math.asin(math.sqrt((ratio * 2.4 + 0.4) / 2.8) / mach)  # p2/p1 = (2 gamma Mn^2 - (gamma - 1))/(gamma + 1)
    assert stream.shock_angle(ratio * 1e5) == pytest.approx(beta, rel=1e-11)
    assert stream.deflection(ratio * 1e5) == pytest.approx(theta_beta_mach(beta, mach, 1.4), rel=1e-10)
    assert stream.normal_shock == pytest.approx(1e5 * (2.8 * mach**2 - 0.4) / 2.4, rel=1e-11)
    betas = np.linspace(math.asin(1.0 / mach), 0.5 * math.pi, 200001)
    assert stream.detachment[1] == pytest.approx(max(theta_beta_mach(b, mach, 1.4) for b in betas), rel=1e-8)


@pytest.mark.parametrize("mach, after", [(1.2, 2.0), (3.0, 4.5)])
def test_fan_of_the_ideal_gas(mach, after):
    stream = air(mach)
    p = 1e5 * ((1.0 + 0.2 * mach**2) / (1.0 + 0.2 * after**2)) ** 3.5
    turned = prandtl_meyer(mach, 1.4) - prandtl_meyer(after, 1.4)
    assert stream.deflection(p) == pytest.approx(turned, rel=1e-9)
    pressures, deflection, angle = stream.fan(p)
    assert deflection[-1] == pytest.approx(turned, rel=1e-10) and angle[0] == pytest.approx(math.asin(1.0 / mach), rel=1e-12)
    assert angle[-1] == pytest.approx(math.asin(1.0 / after), rel=1e-10) and (np.diff(pressures) < 0.0).all()


def test_streams_of_one_kind_meet_like_a_wedge():
    """Two equal streams at an angle: each is turned by half of it, as by a wedge; the slip line halves the angle."""
    for material, mach, degrees in (("air", 4.0, 24.0), ("water", 1.9, 10.0), ("copper", 1.5, 8.0)):
        made = SOLUTIONS["meeting_streams"](Inflow(material, mach, 101325.0 if material == "air" else 0.0),
                                            Inflow(material, mach, 101325.0 if material == "air" else 0.0), -degrees)
        assert made.numbers["slip_angle"] == pytest.approx(-0.5 * degrees, rel=1e-9)
        assert made.numbers["below_deflection"] == pytest.approx(-0.5 * degrees, rel=1e-9)
        assert made.numbers["above_deflection"] == pytest.approx(0.5 * degrees, rel=1e-9)


def test_streams_of_unlike_gases_balance():
    """Shock into one, fan into the other; pressure and direction agree with the relations of ideal gases for each."""
    below, above = air(2.4, 3e5), air(5.0, 0.4e5, 0.6, 1.2)
    found = meeting(below, above, math.radians(2.0))
    p = found.pressure
    assert 0.4e5 < p < 3e5
    machs = math.sqrt(((1.0 + 0.2 * 2.4**2) * (3e5 / p) ** (0.4 / 1.4) - 1.0) / 0.2)
    assert found.direction == pytest.approx(prandtl_meyer(machs, 1.4) - prandtl_meyer(2.4, 1.4), rel=1e-8)
    beta = math.asin(math.sqrt((p / 0.4e5 * 2.2 + 0.2) / 2.4) / 5.0)
    assert found.direction == pytest.approx(math.radians(2.0) + theta_beta_mach(beta, 5.0, 1.2), rel=1e-8)


def test_fields_of_meeting_streams_conserve_across_every_ray():
    """Mass, momentum normal and along each jump, and total enthalpy everywhere."""
    made = SOLUTIONS["meeting_streams"](Inflow("air", 2.5, 2e5), Inflow("air", 3.5, 0.5e5), 3.0)
    slip = math.tan(math.radians(made.numbers["slip_angle"]))
    y = np.sort(np.concatenate([np.linspace(-1.0, 1.0, 301), [v + s * 1e-9 for v in made.jumps(0.0) for s in (-1, 1)]]))
    f = made(y, 0.0)
    h = f["energy"] + f["pressure"] / f["density"] + 0.5 * (f["axial_velocity"]**2 + f["transverse_velocity"]**2)
    for side in (y < slip - 1e-8, y > slip + 1e-8):
        assert h[side] == pytest.approx(h[side][0], rel=1e-9)
    head = made.numbers["above_head"]
    ray = math.tan(math.radians(head))
    two = made([ray - 1e-9, ray + 1e-9], 0.0)
    normal = np.array([-math.sin(math.radians(head)), math.cos(math.radians(head))])
    u = two["axial_velocity"] * normal[0] + two["transverse_velocity"] * normal[1]
    flux = two["density"] * u
    assert flux[0] == pytest.approx(flux[1], rel=1e-9)
    assert two["pressure"][0] + flux[0] * u[0] == pytest.approx(two["pressure"][1] + flux[1] * u[1], rel=1e-9)
    across = made([slip - 1e-9, slip + 1e-9], 0.0)
    assert across["pressure"][0] == pytest.approx(across["pressure"][1], rel=1e-12)
    assert across["transverse_velocity"] / across["axial_velocity"] == pytest.approx([slip, slip], rel=1e-9)


def test_fan_of_meeting_streams_is_simple():
    """Along each ray of a fan the flow meets it at the Mach angle, and the Riemann invariant of Prandtl and Meyer is constant."""
    made = SOLUTIONS["meeting_streams"](Inflow("air", 2.5, 2e5), Inflow("air", 3.5, 0.5e5))
    head, tail = made.numbers["below_head"], made.numbers["below_tail"]
    phi = np.radians(np.linspace(head, tail, 13)[1:-1])
    f = made(np.tan(phi), 0.0)
    q = np.hypot(f["axial_velocity"], f["transverse_velocity"])
    direction = np.arctan2(f["transverse_velocity"], f["axial_velocity"])
    mach = q / np.sqrt(1.4 * f["pressure"] / f["density"])
    assert direction - np.arcsin(1.0 / mach) == pytest.approx(phi, abs=2e-7)
    assert direction - [prandtl_meyer(m, 1.4) for m in mach] == pytest.approx(-prandtl_meyer(2.5, 1.4), abs=1e-8)


def test_streams_that_cannot_meet_are_refused():
    with pytest.raises(NoSolution, match="detach"):
        SOLUTIONS["meeting_streams"](Inflow("air", 2.0), Inflow("air", 2.0), -60.0)
    with pytest.raises(OutOfRange, match="supersonic"):
        SOLUTIONS["meeting_streams"](Inflow("air", 0.8), Inflow("air", 2.0))


# -- detonation shock dynamics -----------------------------------------------------------------------------------
@pytest.mark.parametrize("geometry, n", [("cylindrical", 1), ("spherical", 2)])
def test_expanding_front_obeys_its_law(geometry, n):
    made = SOLUTIONS["dsd_expansion"](geometry, 8000.0, 1e-4, 0.01)
    r, t = 0.023, made([0.023], 0.0)["burn_time"][0]
    assert made.jumps(t)[0] == pytest.approx(r, rel=1e-13)
    h = 1e-6
    late, early = made([r + h, r - h], 0.0)["burn_time"]
    assert 2 * h / (late - early) == pytest.approx(8000.0 * (1.0 - n * 1e-4 / r), rel=1e-8)
    assert t == pytest.approx(quad(lambda x: 1.0 / (8000.0 * (1.0 - n * 1e-4 / x)), 0.01, r)[0], rel=1e-12)


def test_slab_against_its_closed_integrals():
    for scale, degrees in ((3.0, 50.0), (20.0, 40.0), (300.0, 70.0)):
        made = SOLUTIONS["dsd_rate_stick"]("planar", 1.0, 1.0, scale, degrees)
        delta, edge = made.numbers["axial_velocity"], math.radians(degrees)
        peak = [math.sqrt(2.0 * (1.0 - delta))]
        width = quad(lambda f, d=delta: math.cos(f) / (1.0 - d * math.cos(f)), 0.0, edge, points=peak, epsrel=1e-12)[0]
        assert width == pytest.approx(scale, rel=1e-9)
        assert made.numbers["edge_lag"] == pytest.approx(math.log((1.0 - delta * math.cos(edge)) / (1.0 - delta)) / delta, rel=1e-9)
        assert made([scale], 0.0)["slope_angle"][0] == pytest.approx(degrees, rel=1e-8)


@pytest.mark.parametrize("geometry, curved", [("planar", 0.0), ("cylindrical", 1.0)])
def test_rate_stick_obeys_its_law_everywhere(geometry, curved):
    """Normal velocity D0 cos phi against D (1 - alpha kappa), with the curvature from the shape by differences."""
    alpha = 1e-3
    made = SOLUTIONS["dsd_rate_stick"](geometry, 8000.0, alpha, 0.02, 40.0)
    r, h = np.linspace(0.002, 0.019, 12), 1e-6
    z = [made(r + k * h, 0.0)["lag"] for k in (-1, 0, 1)]
    slope, bend = (z[2] - z[0]) / (2 * h), (z[2] - 2 * z[1] + z[0]) / h**2
    root = np.sqrt(1.0 + slope**2)
    curvature = bend / root**3 + curved * slope / (r * root)
    assert made(r, 0.0)["shock_velocity"] == pytest.approx(8000.0 * (1.0 - alpha * curvature), rel=2e-5)
    assert made.numbers["axial_velocity"] / root == pytest.approx(made(r, 0.0)["shock_velocity"], rel=1e-7)


@pytest.mark.parametrize("geometry", ["planar", "cylindrical"])
def test_a_rate_stick_lit_as_a_plane_becomes_the_steady_one(geometry):
    """The steady front, by quadrature and shooting, is where this one, by collocation in time, ends; on the way its points move as it says."""
    made, steady = (SOLUTIONS[name](geometry, 8000.0, 1e-3, 0.02, 40.0) for name in ("dsd_rate_stick_start", "dsd_rate_stick"))
    r, late = np.linspace(0.0, 0.02, 9), 2.0 * made.numbers["relaxation_time"]
    assert made(r, late)["lag"] == pytest.approx(steady(r, 0.0)["lag"], abs=1e-10)
    assert made(r, late)["shock_velocity"] == pytest.approx(steady(r, 0.0)["shock_velocity"], rel=1e-6)
    early, h = 0.1 * made.numbers["relaxation_time"], 1e-3 * late
    before, now, after = (made(r, early + k * h) for k in (-1, 0, 1))
    moved = (after["front_position"] - before["front_position"]) / (2.0 * h)
    assert moved == pytest.approx(now["shock_velocity"] / np.cos(np.radians(now["slope_angle"])), rel=3e-5)
    assert now["slope_angle"][[0, -1]] == pytest.approx([0.0, 40.0], abs=1e-6) and made(r, 0.0)["lag"].max() == 0.0


def test_the_edge_of_a_rate_stick_falls_behind_like_a_wall_of_given_flux():
    """For a small angle the equation is that of heat: 2 tan(phi) sqrt(alpha D t/pi)."""
    made = SOLUTIONS["dsd_rate_stick_start"]("planar", 8000.0, 1e-3, 0.02, 0.1)
    t = 1e-3 * made.numbers["relaxation_time"]
    lag = made(np.array([0.02]), t)["lag"][0]
    assert lag == pytest.approx(2.0 * np.tan(np.radians(0.1)) * np.sqrt(1e-3 * 8000.0 * t / np.pi), rel=1e-3)


def test_large_sticks_lose_velocity_like_the_square_of_the_radius():
    """Deficit -> (pi^2/2)(alpha/R)^2 in a slab and 2 (2.4048 alpha/R)^2 in a stick, from the linear (small-slope) front."""
    slab = SOLUTIONS["dsd_rate_stick"]("planar", 1.0, 1.0, 3000.0, 60.0).numbers["velocity_deficit"]
    stick = SOLUTIONS["dsd_rate_stick"]("cylindrical", 1.0, 1.0, 3000.0, 60.0).numbers["velocity_deficit"]
    assert slab == pytest.approx(0.5 * math.pi**2 / 3000.0**2, rel=5e-3)
    assert stick == pytest.approx(2.0 * 2.404826**2 / 3000.0**2, rel=5e-3)


def test_too_thin_a_slab_fails():
    with pytest.raises(NoSolution, match="fails in slabs of a half-width below"):
        SOLUTIONS["dsd_rate_stick"]("planar", 8000.0, 1e-2, 0.005, 60.0)


def test_ring_obeys_its_law_and_becomes_a_slab():
    alpha = 1e-3
    made = SOLUTIONS["dsd_arc"](8000.0, alpha, 0.04, 0.06, 5.0, 30.0)
    assert made([0.04, 0.06], 0.0)["slope_angle"] == pytest.approx([-5.0, 30.0], rel=1e-8)
    omega, h = made.numbers["angular_velocity"], 1e-6
    for r in np.linspace(0.042, 0.059, 7):  # the front as a curve in polar coordinates: theta(r) = -lag/r
        theta = [-made([r + k * h], 0.0)["lag"][0] / (r + k * h) for k in (-1, 0, 1)]
        first, second = (theta[2] - theta[0]) / (2 * h), (theta[2] - 2 * theta[1] + theta[0]) / h**2
        curvature = -(r * second + 2 * first + r**2 * first**3) / (1.0 + (r * first) ** 2) ** 1.5
        normal = omega * r / math.sqrt(1.0 + (r * first) ** 2)
        assert normal == pytest.approx(8000.0 * (1.0 - alpha * curvature), rel=3e-5)
    wide = SOLUTIONS["dsd_arc"](1.0, 1.0, 1e6, 1e6 + 20.0, 0.0, 40.0).numbers["inner_velocity"]
    assert wide == pytest.approx(SOLUTIONS["dsd_rate_stick"]("planar", 1.0, 1.0, 20.0, 40.0).numbers["axial_velocity"], rel=2e-5)
