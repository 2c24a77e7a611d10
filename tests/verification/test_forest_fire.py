r"""Forest fire: a rate made from a Pop plot, run back to a Pop plot.

On the curve of build-up the shock of pressure p grows as the Pop plot says, $dp/dt = U_s\,|b|\,p/x^*(p)$. What the flow behind it does has
to be assumed, since one curve does not tell. With no pressure gradient there (Mader's square wave) momentum and the equation of state just
behind an unreacted shock give the first rate; with the rule of Whitham and Chisnell, the relation of the characteristic that overtakes the
shock taken along the shock, the second one:

$$\dot\lambda = \frac{dp}{dt}\,\frac{1 + \rho c^2\,(du/dp)/(U_s - u)}{p_\lambda}, \qquad
\dot\lambda = \frac{dp}{dt}\,\frac{1 + \rho c\,du/dp}{p_\lambda}.$$

A run is over half-way to the detonation's speed, where the line has a distance $x^*(p_{half})$ left (its own detonation would need infinite
pressure): what a run has to be compared with is $x^*(p) - x^*(p_{half})$, and with $x^*(p)$ where the wedge's own reading is meant.

Source: C. L. Mader, Numerical Modeling of Detonations (1979), chapter 4; Menikoff and Shaw, Review of the Forest Fire Model, LA-UR-07-2272
(2007), for characteristics in place of the square wave.
"""

import dataclasses

import numpy as np
import pytest

from hugoniot.campaign.pop_plot import pop_plot
from hugoniot.diagnostics.detonation import PopLine
from hugoniot.laws.burn.forest_fire import rate_table
from hugoniot.laws.mixture import contract
from hugoniot.materials import burning, library
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import Initial, shock

LX17 = dataclasses.replace(library.find("LX-17 reactive"), mixture="weighted_pressures")
LINE = PopLine(1.39, -0.31, 0.0, 0.0, 0.0)      # PBX-9502, R004


def rates(pressures, level=True):
    """Rates (1/s) before depletion at shock pressures (Pa), behind a shock with level pressure or by the rule of Whitham and Chisnell."""
    par, rest = burning.reactive(LX17).mixture, Initial.at_rest(LX17.unreacted)
    found = []
    for p in pressures:
        here, next_ = (shock(LX17.unreacted, rest, pressure=q) for q in (p, 1.001 * p))
        rho, e, u, us = (float(getattr(here, name)) for name in ("density", "specific_internal_energy", "particle_velocity", "shock_velocity"))
        steepness = (float(next_.particle_velocity) - u) / (0.001 * p)
        e += par.detonation_energy
        mixed = contract.equilibrate(rho, e, 0.0, contract.at_rest(rho, e), par)
        driven_by = contract.slopes(rho, e, 0.0, mixed, par).by_burn_fraction
        growth = us * abs(LINE.b) * p / float(LINE.distance(p))
        c = float(here.sound_speed)
        found.append(growth * (1.0 + rho * c * steepness * (c / (us - u) if level else 1.0)) / driven_by)
    return np.array(found)


def left_half_way(pressure):
    """What the line has left, m, where a shock that entered at `pressure` is half-way to the speed of the detonation."""
    rest = Initial.at_rest(LX17.unreacted)
    grid = np.geomspace(5e9, 60e9, 200)
    speeds = [float(shock(LX17.unreacted, rest, pressure=p).shock_velocity) for p in grid]
    half = 0.5 * (np.interp(pressure, grid, speeds) + cj(LX17.eos).detonation_velocity)
    return float(LINE.distance(np.interp(half, speeds, grid)))


@pytest.mark.slow
@pytest.mark.parametrize(("level", "whole", "part"), [(True, (0.65, 0.8), (0.84, 0.94)), (False, (0.9, 1.1), (1.1, 1.3))],
                         ids=["square wave", "Whitham and Chisnell"])
def test_a_rate_made_from_a_pop_plot_gives_its_slope_back(level, whole, part):
    """A straight line again, its slope within 0.03 of the one that went in. Against the part of the line that a run covers the square wave
    burns too fast (behind a growing shock pressure rises towards what burned before), the rule of characteristics too slowly; against
    the whole of it the latter is within 10 %, and what both assume differs by a quarter."""
    pressures = np.geomspace(5e9, 30e9, 16)
    material = dataclasses.replace(LX17, burn=rate_table(pressures, rates(pressures, level)))
    found = pop_plot(material, (10e9, 12e9, 14e9, 16e9), 4e-5)
    assert found.line.deviation < 0.005 and found.line.b == pytest.approx(LINE.b, abs=0.03)
    for point in found.points:
        line = float(LINE.distance(point.pressure))
        assert whole[0] < point.distance / line < whole[1]
        assert part[0] < point.distance / (line - left_half_way(point.pressure)) < part[1]
