"""The arrivals that a run reports beside exact ones: precursor and plastic wave, layers without strength, a programmed detonation."""

import numpy as np
import pytest

import hugoniot
from hugoniot.laws.eos import snow_plough
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.mesh.shapes import Box
from hugoniot.output.run_numbers import gauge_rows, highest
from hugoniot.problem.catalogue import deck_text
from hugoniot.problem.deck import read_deck_text
from hugoniot.problem.model import Boundary, Gauge, Interface, OutputOptions, Problem, Region, SolverOptions
from hugoniot.problem.plane.contact_model import Contact2D
from hugoniot.problem.plane.model import Block2D, Boundary2D, Gauge2D, Problem2D, VelocityField
from hugoniot.theory.exact.elastic_plastic_piston import Solid, waves
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.impedance import match

THICK = 5e-3


def rows_of(tmp_path, regions, materials, gauges, stop):
    problem = Problem("arrivals", "planar", stop, regions, materials, gauges=gauges, output=OutputOptions(report=False))
    return {row["gauge"]: row for row in gauge_rows(hugoniot.run(problem, tmp_path / f"run{regions[0].zones}"))}


@pytest.mark.parametrize("speed", [400.0, 800.0])
def test_the_precursor_and_the_plastic_wave(tmp_path, speed):
    """Aluminium: elastic wave x / c_e and plastic wave from the jump conditions, inside and at the surface, which sees the precursor first.

    A captured precursor leaves the plastic front, some zones wide, ahead of its exact place: the arrival converges in first order.
    """
    law, strength = MieGruneisen(2785.0, 5328.0, 1.338, 2.0), PerfectlyPlastic(27.6e9, 0.3e9)
    elastic, plastic = waves(Solid(2785.0, 5328.0, 1.338, 2.0, 27.6e9, 0.3e9), speed / 2)
    in_material = (plastic.wave_speed - elastic.velocity) * elastic.density / law.rho0
    gauges = (Gauge("inside", 4e-3), Gauge("surface", THICK))
    early = []
    for zones in (100, 200):
        regions = (Region("flyer", "m", -THICK, 0.0, zones, velocity=speed), Region("target", "m", 0.0, THICK, zones))
        rows = rows_of(tmp_path, regions, {"m": Material("m", law, strength)}, gauges, 1.1e-6)
        zone = THICK / zones
        early.append([1.0 - rows[name]["arrival"] * elastic.wave_speed / x for name, x in (("inside", 4e-3), ("surface", THICK))])
        assert 0.0 < max(early[-1]) < 2.5 * zone / 4e-3
        if np.isfinite(rows["inside"]["second_arrival"]):     # the coarse mesh leaves too short a plateau to be sure
            assert rows["inside"]["second_arrival"] == pytest.approx(4e-3 / in_material, abs=zone / in_material)
        # at the surface the plastic wave runs its last way through material that the reflected precursor has unloaded
        assert THICK / in_material < rows["surface"]["second_arrival"] < THICK / in_material * 1.02
    assert np.isfinite(rows["inside"]["second_arrival"])
    assert max(early[1]) < 0.65 * max(early[0])


def test_layers_without_strength_have_the_sum_of_their_times(tmp_path):
    """Copper on copper on a light layer: thickness over shock velocity, layer by layer, and one wave each; half a zone at two meshes."""
    copper, light = MieGruneisen(8930.0, 3940.0, 1.489, 2.02), MieGruneisen(2640.0, 5150.0, 1.35, 1.6)
    velocity, depth = 800.0, 1.5e-3
    met = match([copper, copper, light], velocity)
    first = shock(copper, particle_velocity=velocity / 2).shock_velocity
    second = shock(light, particle_velocity=met[1].particle_velocity).shock_velocity
    expected = {"on copper": 3e-3 / first, "in the light layer": 3e-3 / first + depth / second}
    for zones in (60, 120):
        regions = (Region("flyer", "cu", -3e-3, 0.0, zones, velocity=velocity), Region("plate", "cu", 0.0, 3e-3, zones),
                   Region("layer", "light", 3e-3, 6e-3, zones))
        rows = rows_of(tmp_path, regions, {"cu": Material("cu", copper), "light": Material("light", light)},
                       (Gauge("on copper", 3e-3), Gauge("in the light layer", 3e-3 + depth)), 1.2e-6)
        for name, when in expected.items():
            assert rows[name]["arrival"] == pytest.approx(when, abs=0.6 * 3e-3 / zones / first)
            assert "second_arrival" not in rows[name]


def test_a_detonation_arrives_at_distance_over_velocity(tmp_path):
    """Composition B, programmed at 7980 m/s from x = 0, at 3 cm: a zone late, the half-way point of the zones that burn."""
    for size in (0.4, 0.2):
        text = deck_text("detonation").replace('"0.1 mm"', f'"{size} mm"').replace('stop_time = "8 us"', 'stop_time = "4.2 us"')
        found = hugoniot.run(read_deck_text(text), tmp_path / f"run{size}", report=False)
        row = next(row for row in gauge_rows(found) if row["gauge"] == "3 cm")
        assert row["arrival"] == pytest.approx(3e-2 / 7980.0, abs=1.2 * size * 1e-3 / 7980.0)
        assert not np.isfinite(row.get("second_arrival", np.nan))


@pytest.mark.parametrize("end", ["left", "right"])
def test_an_elastic_and_a_plastic_release_are_no_precursor_and_main_wave(tmp_path, end):
    """A plate compressed to 0.5 GPa is let go at one end: 4 mm from it the elastic release comes after 4 mm / c_l, the plastic one later."""
    law, strength = MieGruneisen(2785.0, 5328.0, 1.338, 2.0), PerfectlyPlastic(27.6e9, 0.05e9)
    regions = (Region("plate", "m", 0.0, 1e-2, 200, velocity=20.0, pressure=0.5e9),)
    ends = {"left": Boundary("transmitting"), "right": Boundary("transmitting")} | {end: Boundary("free")}
    gauge = Gauge("inside", 4e-3 if end == "left" else 6e-3)
    problem = Problem("release", "planar", 1.1e-6, regions, {"m": Material("m", law, strength)}, gauges=(gauge,), output=OutputOptions(report=False), **ends)
    found = hugoniot.run(problem, tmp_path / "run")
    row = next(row for row in gauge_rows(found) if row["gauge"] == "inside")
    stress = found.gauge("stress", "inside")[1]
    assert row["arrival"] == pytest.approx(4e-3 / 6500.0, rel=0.05) and "second_arrival" not in row
    assert stress[0] == pytest.approx(0.5e9, rel=1e-3) and stress[-1] < 0.05e9


def test_the_precursor_at_a_surface_on_the_left_counts(tmp_path):
    """There the velocity falls as the waves arrive, and there is no stress: compression is outwards. A body that moves changes nothing."""
    law, strength = MieGruneisen(2785.0, 5328.0, 1.338, 2.0), PerfectlyPlastic(27.6e9, 0.3e9)
    plastic = waves(Solid(2785.0, 5328.0, 1.338, 2.0, 27.6e9, 0.3e9), 200.0)[1]
    for k, drift in enumerate((0.0, 100.0)):
        regions = (Region("target", "m", -THICK, 0.0, 100, velocity=drift), Region("flyer", "m", 0.0, THICK, 100 + k, velocity=drift - 400.0))
        row = rows_of(tmp_path / str(k), regions, {"m": Material("m", law, strength)}, (), 1.1e-6)["free surface left"]
        assert row["second_arrival"] == pytest.approx(THICK / plastic.wave_speed, rel=0.05)


@pytest.mark.parametrize("interval", [0.0, 3e-8])
def test_tracked_fronts_arrive_when_they_cross_the_gauge(tmp_path, interval):
    """Precursor and plastic wave step between two samples; the middle between them was printed, half of an interval away.

    In the second half of the target nothing is reflected yet: both waves run from the face, in the material, at constant speeds.
    """
    law, strength = MieGruneisen(2785.0, 5328.0, 1.338, 2.0), PerfectlyPlastic(27.6e9, 0.3e9)
    elastic, plastic = waves(Solid(2785.0, 5328.0, 1.338, 2.0, 27.6e9, 0.3e9), 200.0)
    in_material = (plastic.wave_speed - elastic.velocity) * elastic.density / law.rho0
    regions = (Region("flyer", "m", -THICK, 0.0, 5, velocity=400.0), Region("target", "m", 0.0, THICK, 5))
    problem = Problem("arrivals", "planar", 0.85e-6, regions, {"m": Material("m", law, strength)}, gauges=(Gauge("inside", 4e-3),), solver=SolverOptions("fronts"),
                      output=OutputOptions(report=False, gauge_interval=interval))
    rows = gauge_rows(hugoniot.run(problem, tmp_path / "run"))
    assert rows[0]["arrival"] == pytest.approx(4e-3 / elastic.wave_speed, rel=1e-8)
    assert rows[0]["second_arrival"] == pytest.approx(4e-3 / in_material, rel=1e-8)


@pytest.mark.parametrize("kind", ["lagrange1d", "fronts"])
@pytest.mark.parametrize("target", ["copper", "aluminium", "porous"])
def test_the_impact_arrives_at_its_face_at_once(tmp_path, target, kind):
    """The record begins at the velocity of the impact: of equal plates the release after 2 H / D was taken for the first wave, of a porous
    target none. The plateau is that of the impedance match."""
    laws = {"aluminium": MieGruneisen(2700.0, 5200.0, 1.5, 2.0), "copper": MieGruneisen(8930.0, 3940.0, 1.489, 2.02)}
    laws["porous"] = snow_plough.build(laws["aluminium"], 1800.0, 1e8)
    regions = (Region("flyer", "a", -2e-3, 0.0, 30, velocity=600.0), Region("target", "b", 0.0, 5e-3, 75))
    materials = {"a": Material("a", laws["aluminium"]), "b": Material("b", laws[target])}
    problem = Problem("face", "planar", 1.0e-6, regions, materials, gauges=(Gauge("face", "flyer/target"), Gauge("side", "flyer : right")),
                      solver=SolverOptions(kind), output=OutputOptions(report=False))
    rows = {row["gauge"]: row for row in gauge_rows(hugoniot.run(problem, tmp_path / "run"))}
    assert rows["face"]["arrival"] == rows["side"]["arrival"] == 0.0
    if target != "porous" or kind == "fronts":      # behind a captured crushing shock the stress rings
        met = match([laws["aluminium"], laws[target]], 600.0)[0]
        assert rows["face"]["plateau_stress"] == pytest.approx(met.pressure, rel=0.01)


@pytest.mark.parametrize("joined", [True, False])
def test_the_impact_arrives_at_its_face_at_once_in_the_plane(tmp_path, joined):
    """The release after 2 H / D was taken for the first wave by points, sides, joints and lines of sight, and what it left for the plateau."""
    law = MieGruneisen(2700.0, 5200.0, 1.5, 2.0)
    blocks = (Block2D("flyer", "al", Box((-2e-3, 0.0), (0.0, 2e-4)), (20, 2), velocity=VelocityField((700.0, 0.0))),
              Block2D("target", "al", Box((0.0, 4e-3), (0.0, 2e-4)), (40, 2)))
    gauges = [Gauge2D("point", "point", (0.0, 1e-4)), Gauge2D("surface", "edge", on="target.right")]
    gauges += [Gauge2D("joint", "edge", on="flyer/target")] if joined else [
        Gauge2D("flyer side", "edge", on="flyer.right"), Gauge2D("target side", "edge", on="target.left"),
        Gauge2D("sight", "slit", (-5e-3, 1e-4), "target.left", (1.0, 0.0))]
    walls = tuple(Boundary2D((f"{name}.{side}",), "wall") for name in ("flyer", "target") for side in ("bottom", "top"))
    problem = Problem2D("face", "plane", 1.1e-6, blocks, {"al": Material("al", law)}, walls, tuple(gauges),
                        contacts=() if joined else (Contact2D(("flyer", "target")),), output=OutputOptions(report=False, gauge_interval=5e-9))
    rows = {row["gauge"]: row for row in gauge_rows(hugoniot.run(problem, tmp_path / "run"))}
    assert rows.pop("surface")["arrival"] == pytest.approx(4e-3 / shock(law, particle_velocity=350.0).shock_velocity, rel=0.02)
    for row in rows.values():
        assert row["arrival"] == 0.0
        assert abs(row["plateau_velocity"]) == pytest.approx(350.0, rel=0.01)
    assert rows["point"]["plateau_pressure"] == pytest.approx(shock(law, particle_velocity=350.0).pressure, rel=0.01)


@pytest.mark.parametrize(("kind", "arrives"), [("sliding", False), ("bonded", True)])
def test_bodies_of_the_plane_that_part_at_once_send_no_wave(tmp_path, kind, arrives):
    """From the face on which they touched, unless something holds them together there."""
    blocks = tuple(Block2D(name, "al", Box((x, x + 2e-3), (0.0, 1e-3)), (8, 2), velocity=VelocityField((u, 0.0)))
                   for name, x, u in (("a", -2e-3, -100.0), ("b", 0.0, 60.0)))
    gauges = (Gauge2D("a", "edge", on="a.right"), Gauge2D("b", "edge", on="b.left"))
    problem = Problem2D("part", "plane", 0.2e-6, blocks, {"al": Material("al", MieGruneisen(2700.0, 5200.0, 1.5, 2.0))}, gauges=gauges,
                        contacts=(Contact2D(("a", "b"), kind),), output=OutputOptions(report=False))
    for row in gauge_rows(hugoniot.run(problem, tmp_path / "run")):
        assert (row["arrival"] == 0.0) if arrives else np.isnan(row["arrival"])


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
@pytest.mark.parametrize(("pressure", "interfaces", "free"), [(0.0, (), True), (1e9, (), False), (0.0, (Interface("a", "b", "bonded"),), False)])
def test_bodies_of_a_line_that_part_at_once_send_no_wave(tmp_path, pressure, interfaces, free, integrator):
    """At -100 and 60 m/s they had one velocity on the face until it opened: 732 MPa of tension, and -112 m/s."""
    regions = (Region("a", "al", -2e-3, 0.0, 20, velocity=-100.0, pressure=pressure), Region("b", "al", 0.0, 4e-3, 40, velocity=60.0, pressure=pressure))
    problem = Problem("part", "planar", 0.5e-6, regions, {"al": Material("al", MieGruneisen(2700.0, 5200.0, 1.5, 2.0))}, interfaces=interfaces,
                      gauges=(Gauge("face", "a/b"),), solver=SolverOptions(integrator=integrator), output=OutputOptions(report=False))
    done = hugoniot.run(problem, tmp_path / "run")
    found = {row["gauge"]: row for row in gauge_rows(done)}
    assert np.isnan(found["face"]["arrival"]) if free else found["face"]["arrival"] == 0.0
    if free:
        assert "tension" not in highest(done) and highest(done)["stress"] == 0.0
        events = done.arrays("events")
        assert [(t, str(kind)) for t, kind in zip(events["time"], events["kind"]) if kind == "interface_separated"] == [(0.0, "interface_separated")]
        assert done.summary["interfaces_separated"] == 1
        assert [found[name]["last_velocity"] for name in ("face", "face right")] == pytest.approx([-100.0, 60.0], rel=1e-9)
