"""Periodic ends and initial states given as profiles: translation, conservation, order in smooth flow, what is refused."""

import numpy as np
import pytest

import hugoniot
from hugoniot.errors import DeckError
from hugoniot.problem.deck import read_deck, read_deck_text

DECK = """
stop_time = {stop}
[[region]]
name = "gas"
material = "gas"
from = 0.0
to = 1.0
zones = {zones}
{state}
[region.profile]
{profile}
[material.gas.eos]
law = "ideal_gas"
gamma = {gamma}
specific_heat = 717.5
[boundary]
left = "periodic"
right = "periodic"
[solver]
integrator = "{integrator}"
{solver}
[output]
snapshots = [0.0, {stop}]
{more}
"""
BOTH = pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
QUIET = 'initial_step = 1e-6\n[solver.viscosity]\nlaw = "wilkins"\nquadratic = 0.0\nlinear = 0.0\n[solver.options]\nheat_flux = 0.0'
SHOCKED = 'velocity = "0.4 m/s * tanh(10 * sin(2 * pi * (x / 1 m - {shift})))"\npressure = "1 Pa + 0.5 Pa * cos(2 * pi * (x / 1 m - {shift}))"'


def deck(profile, integrator, zones=64, stop=0.2, state="density = 1.0", gamma=1.4, solver="", more=""):
    return read_deck_text(DECK.format(profile=profile, integrator=integrator, zones=zones, stop=stop, state=state, gamma=gamma,
                                      solver=solver, more=more), "wave.toml")


def run(tmp_path, name, *given, **more):
    return hugoniot.run(deck(*given, **more).problem, out=tmp_path / name, report=False)


@BOTH
def test_waves_through_the_seam_are_those_inside(tmp_path, integrator):
    """Shocks, viscosity, limiter and heat flux: the flow that starts a quarter further on is the same flow, a quarter further on."""
    fields = {}
    for shift in (0.0, 0.25):
        made = run(tmp_path, f"{shift}.run", SHOCKED.format(shift=shift), integrator, stop=0.6)
        fields[shift] = made.snapshots.isel(time=-1)
        assert made.summary["mass_error"] < 1e-14
        if integrator == "compatible":
            assert made.summary["energy_error"] < 1e-12
        assert made.summary["momentum_error"] < 1e-12
    for name in ("pressure", "density", "velocity_left"):
        one, two = fields[0.0][name].values, fields[0.25][name].values
        assert np.max(np.abs(np.roll(one, 16) - two)) < 1e-9 * np.max(np.abs(one))


@BOTH
def test_a_smooth_wave_converges_at_second_order(tmp_path, integrator):
    """A simple wave of a gas with gamma = 3, in which u + c and u - c run unchanged: against the exact flow before it breaks."""
    speed, errors = 0.1, []
    # c = rho for p = rho^3/3, and u = c - 1; the leapfrog's velocities stand half a step before the start, hence a small first step
    for zones in (32, 64, 128):
        amplitude = f'"{speed} m/s * sin(2 * pi * x / 1 m)"'
        density = f'"1 kg/m^3 * (1 + {speed} * sin(2 * pi * x / 1 m))"'
        pressure = f'"1 Pa / 3 * (1 + {speed} * sin(2 * pi * x / 1 m)) ** 3"'
        made = run(tmp_path, f"{zones}.run", f"velocity = {amplitude}\ndensity = {density}\npressure = {pressure}", integrator, zones=zones,
                   stop=0.5, state="", gamma=3.0, solver=QUIET)
        last = made.snapshots.isel(time=-1)
        middles = 0.5 * (last.position_left.values + last.position_right.values)
        foot = middles.copy()      # of the characteristic through a point: x = foot + (u + c) t
        for _ in range(200):
            foot = middles - 0.5 * (1.0 + 2.0 * speed * np.sin(2.0 * np.pi * foot))
        exact = 1.0 + speed * np.sin(2.0 * np.pi * foot)
        errors.append(float(np.mean(np.abs(last.density.values - exact))))
    assert min(np.log2(np.array(errors[:-1]) / errors[1:])) > 1.9 and errors[-1] < 2e-4


def test_the_two_ends_stay_one_node_under_gravity(tmp_path):
    """A uniform force accelerates everything alike; the ends keep their distance."""
    made = run(tmp_path, "fall.run", 'velocity = "0.1 m/s * sin(2 * pi * x / 1 m)"', "compatible", state="density = 1.0\npressure = 1.0",
               more="[body_force]\nacceleration = 2.0")
    last = made.snapshots.isel(time=-1)
    assert float(last.position_right[-1] - last.position_left[0]) == pytest.approx(1.0, rel=1e-14)
    assert float(last.velocity_left[0]) == float(last.velocity_right[-1])
    mass_speed = np.sum(0.5 * (last.velocity_left + last.velocity_right) * last.density * (last.position_right - last.position_left))
    assert float(mass_speed) == pytest.approx(0.4, rel=1e-10) and made.summary["energy_error"] < 1e-12


def test_a_body_that_spalls_between_periodic_ends_keeps_its_momentum(tmp_path):
    text = """
stop_time = "2 us"
[[region]]
name = "ring"
material = "al"
from = "0 mm"
to = "10 mm"
zones = 100
[region.profile]
velocity = "200 m/s * sin(2 * pi * x / 10 mm)"
[material.al.eos]
law = "mie_gruneisen"
rho0 = 2700.0
c0 = 5200.0
s = 1.5
gamma0 = 2.0
[material.al.fracture]
law = "spall_stress"
strength = "1 GPa"
[boundary]
left = "periodic"
right = "periodic"
"""
    made = hugoniot.run(read_deck_text(text, "ring.toml").problem, out=tmp_path / "ring.run", report=False)
    assert made.summary["voids_opened"] > 0 and made.summary["momentum_error"] < 1e-12 and made.summary["energy_error"] < 1e-12


def test_a_table_a_file_and_an_expression_give_one_start(tmp_path):
    places = np.linspace(0.0, 1.0, 65)
    values = (0.1 * places).tolist()
    (tmp_path / "start.csv").write_text("# made here\nposition [mm], velocity [km/s]\n"
                                        + "".join(f"{1e3 * x!r}, {1e-3 * u!r}\n" for x, u in zip(places.tolist(), values)))
    starts = []
    for k, profile in enumerate(('velocity = "0.1 m/s * x / 1 m"', f"positions = {places.tolist()}\nvelocity = {values}",
                                 'file = "start.csv"')):
        (tmp_path / "deck.toml").write_text(DECK.format(profile=profile, integrator="compatible", zones=64, stop=0.01, gamma=1.4, more="",
                                                        state="density = 1.0\npressure = 1.0", solver=""))
        made = read_deck(tmp_path / "deck.toml")
        again = read_deck_text(made.resolved, "again.toml")        # on its own, without the file
        assert again.problem.regions == made.problem.regions and again.resolved == made.resolved
        first = hugoniot.run(again.problem, out=tmp_path / f"{k}.run", report=False).snapshots.isel(time=0)
        starts.append(first.velocity_left.values)
    assert starts[1] == pytest.approx(starts[0], abs=1e-12) and starts[2] == pytest.approx(starts[0], abs=1e-12)


def test_the_state_of_a_profile_is_that_of_its_material(tmp_path):
    """Pressure and density of a gas over position, at the middles of graded zones; the rest from its law."""
    made = run(tmp_path, "state.run", 'pressure = "1 Pa + 0.5 Pa * x / 1 m"', "compatible", state="density = 2.0\nratio = 1.01", stop=1e-6)
    first = made.snapshots.isel(time=0)
    middles = 0.5 * (first.position_left.values + first.position_right.values)
    assert first.pressure.values == pytest.approx(1.0 + 0.5 * middles, rel=1e-12)
    assert first.energy.values == pytest.approx((1.0 + 0.5 * middles) / (0.4 * 2.0), rel=1e-12)


@pytest.mark.parametrize(("last", "doubted"), [(1.5, 0), (2.5, 1), (1000.0, 1)])
def test_a_profile_much_longer_than_its_region_is_doubted(tmp_path, last, doubted):
    """Positions in millimetres taken for metres give a part of a thousandth of the profile."""
    (tmp_path / "start.csv").write_text(f"position [m], velocity [m/s]\n0, 0\n{last}, 1\n")
    text = DECK.format(profile='file = "start.csv"', integrator="compatible", zones=64, stop=0.2, state="density = 1.0", gamma=1.4, solver="", more="")
    found = read_deck_text(text, "wave.toml", beside=tmp_path)
    assert [("in the right unit" in w) for w in found.warnings].count(True) == doubted


@pytest.mark.parametrize("old, new, words", [
    ('right = "periodic"', 'right = "free"', "one end is periodic"),
    ("stop_time", 'geometry = "spherical"\nstop_time', "periodic ends need planar geometry"),
    ('"0.1 m/s"', '"0.1 m"', "unit m"),
    ('"0.1 m/s"', '"0.1 m/s * y"', "unknown name 'y'"),
    ('"0.1 m/s"', '"__import__(1)"', "not allowed in an expression"),
    ('velocity = "0.1 m/s"', 'positions = [0.0, 0.5]\nvelocity = [0.0, 1.0]', "a profile must cover its region"),
    ('velocity = "0.1 m/s"', 'positions = [0.0, 0.5, 1.0]\nvelocity = [0.0, 1.0]', "values: 2, positions: 3"),
    ('velocity = "0.1 m/s"', 'density = "1 kg/m^3"', "is given both in the region and in its profile"),
    ('velocity = "0.1 m/s"', 'pressure = "0.5 Pa - 1 Pa * x / 1 m"', "at 500 mm the profile gives 'gas' a state that it cannot have"),
    ('velocity = "0.1 m/s"', 'file = "nowhere.csv"', "cannot read"),
    ('velocity = "0.1 m/s"', "", "profile: is empty"),
    ('integrator = "compatible"', 'kind = "fronts"', "fronts solver has no periodic ends"),
    ('integrator = "compatible"', 'kind = "fronts"', "starts from one state along a region"),
    ("[output]", '[transport.gas]\nconduction = {law = "constant", conductivity = 1.0}\n[output]', "conduction is not supported"),
])
def test_what_cannot_be_is_refused(old, new, words):
    text = DECK.format(profile='velocity = "0.1 m/s"', integrator="compatible", zones=64, stop=0.2, state="density = 1.0", gamma=1.4,
                       solver="", more="")
    with pytest.raises(DeckError, match=words):
        read_deck_text(text.replace(old, new, 1), "wave.toml")


@pytest.mark.parametrize(("given", "message"), [
    ('velocity = "1e-3 m^2/s / (x - 0.25 m)"', "does not give a finite number"),                   # a node of 64 zones, none of a coarser sample
    ('pressure = "1 Pa * 1 m / abs(x - 0.2578125 m)"', "does not give a finite number"),           # the middle of a zone
    ('velocity = "1e9 m/s"', "faster than light"),
    ('positions = []\nvelocity = []', "at least two positions"),
    ('positions = [0, 1]\nvelocity = [0, 1e12]', "faster than light"),
    ('file = "twice.csv"', "column 'velocity' appears twice"),
    ('file = "fast.csv"', "profile.file: unreasonably large")])
def test_a_profile_is_asked_where_the_run_asks_for_it(given, message, tmp_path):
    (tmp_path / "twice.csv").write_text("position [m], velocity [m/s], velocity [m/s]\n0, 1, 2\n1, 1, 2\n")
    (tmp_path / "fast.csv").write_text("position [m], velocity [m/s]\n0, 1\n\n1, 1e9\n")
    text = DECK.format(profile=given, integrator="compatible", zones=64, stop=0.2, state="density = 1.0", gamma=1.4, solver="", more="")
    with pytest.raises(DeckError, match=message):
        read_deck_text(text, "wave.toml", beside=tmp_path)


def test_a_periodic_end_is_no_free_surface():
    with pytest.raises(DeckError, match="gauge.end.at: a periodic end has no 'free surface right'"):
        deck('velocity = "1 m/s"', "compatible", more='[[gauge]]\nname = "end"\nat = "free surface right"')
