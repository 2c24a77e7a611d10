"""The echo of a transmitting end, foretold and reported, against the wave that a gauge inside sees come back."""

import re

import numpy as np
import pytest

from hugoniot import run
from hugoniot.diagnostics.transmitting import echo, expected, measured
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Gauge, OutputOptions, Problem, Pulse, Region

C, S, LENGTH, INSIDE = 5150.0, 1.35, 5e-3, 1.5e-3
FLUORIDE = MieGruneisen(2640.0, C, S, 1.6)
STRENGTH = PerfectlyPlastic(49e9, 0.36e9)
END = Boundary("transmitting")


def piston(speed, strength):
    """A shock of `speed` (m/s) driven into 5 mm, watched 1.5 mm before the end until its echo has come back there."""
    shock = C + S * speed
    drive = Boundary("velocity", Pulse("ramp", amplitude=speed, duration=0.05e-6))
    return Problem("piston", "planar", (LENGTH + 1.6 * INSIDE) / shock, (Region("body", "lif", 0.0, LENGTH, 250),),
                   {"lif": Material("lif", FLUORIDE, strength)}, drive, END, gauges=(Gauge("inside", LENGTH - INSIDE),),
                   output=OutputOptions(report=False))


@pytest.mark.parametrize("speed, strength", [(1000.0, None), (2000.0, None), (300.0, STRENGTH), (1000.0, STRENGTH)])
def test_the_echo_is_the_one_that_a_gauge_sees(tmp_path, speed, strength):
    done = run(piston(speed, strength), tmp_path / "run")
    time, stress = done.gauge("stress", "inside")
    shock, at = C + S * speed, LENGTH - INSIDE
    before = (time > 1.1 * at / shock) & (time < 1.03 * LENGTH / shock)
    after = (time > (LENGTH + 1.15 * INSIDE) / shock) & (time < (LENGTH + 1.6 * INSIDE) / shock)
    incident, both = np.median(stress[before]), np.median(stress[after])
    # the jump condition of the fluid; behind an elastic precursor the plastic shock is weaker by some 2 %
    found = echo(Material("lif", FLUORIDE, strength), 2640.0 * shock * speed)
    assert found.incident == pytest.approx(incident, rel=0.03)
    assert found.reflected == pytest.approx(both - incident, rel=0.1)
    warned = [str(text) for text in done.arrays("events")["text"] if "transmitting right end" in str(text)]
    assert len(warned) == 1
    told = re.search(r"\((\d+)%\)", warned[0])
    assert told and float(told[1]) == pytest.approx(100.0 * (both - incident) / incident, abs=2.0)


def test_sound_and_elastic_waves_pass():
    assert echo(Material("lif", FLUORIDE), 1e7).part < 1e-3
    weak = 2e6
    assert not measured(piston(300.0, STRENGTH), np.full(250, weak))


def test_check_foretells_the_echo_of_an_impact_that_arrives_in_time():
    lif = Material("lif", FLUORIDE, STRENGTH)
    regions = (Region("flyer", "lif", -2e-3, 0.0, 40, velocity=600.0), Region("target", "lif", 0.0, 5e-3, 100))

    def warnings(stop, right=END, **changed):
        return expected(Problem("impact", "planar", stop, regions, {"lif": lif}, right=right, **changed))

    assert len(warnings(3e-6)) == 1 and "of the first shock, 4.6" in warnings(3e-6)[0]
    assert not warnings(0.5e-6) and not warnings(3e-6, Boundary("free"))
    # the same from the other side
    mirrored = tuple(Region(r.name, r.material, -r.end, -r.start, r.zones, velocity=-r.velocity) for r in reversed(regions))
    found = expected(Problem("impact", "planar", 3e-6, mirrored, {"lif": lif}, left=END))
    assert len(found) == 1 and found[0].replace("left", "right") == warnings(3e-6)[0]
