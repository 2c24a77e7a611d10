r"""Forest fire: a rate made from a Pop plot, run back to a Pop plot.

On the curve of build-up the shock of pressure p grows as the Pop plot says, $dp/dt = U_s\,|b|\,p/x^*(p)$. With no pressure gradient behind it
(Mader's square wave) momentum and the equation of state just behind an unreacted shock give

$$\dot\lambda = \frac{dp}{dt}\,\frac{1 + \rho c^2\,(du/dp)/(U_s - u)}{p_\lambda}.$$

Source: C. L. Mader, Numerical Modeling of Detonation (1979), chapter 4.
"""

import dataclasses

import numpy as np
import pytest

from hugoniot.campaign.pop_plot import pop_plot
from hugoniot.diagnostics.detonation import PopLine
from hugoniot.laws.burn.forest_fire import rate_table
from hugoniot.laws.mixture import contract
from hugoniot.materials import burning, library
from hugoniot.theory.hugoniot import Initial, shock

LX17 = dataclasses.replace(library.find("LX-17 reactive"), mixture="weighted_pressures")
LINE = PopLine(1.39, -0.31, 0.0, 0.0, 0.0)      # PBX-9502, R004


def rates(pressures):
    """Rates (1/s) before depletion at shock pressures (Pa)."""
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
        found.append(growth * (1.0 + rho * float(here.sound_speed) ** 2 * steepness / (us - u)) / driven_by)
    return np.array(found)


@pytest.mark.slow
def test_a_rate_made_from_a_pop_plot_gives_its_slope_back():
    """A straight line again, its slope within 0.03 of the one that went in; detonation comes after 0.65 to 0.8 of the run distance, since
    behind a growing shock the pressure is not level, as the square wave has it, but rises towards what burned before."""
    pressures = np.geomspace(5e9, 30e9, 16)
    material = dataclasses.replace(LX17, burn=rate_table(pressures, rates(pressures)))
    found = pop_plot(material, (10e9, 12e9, 14e9, 16e9), 4e-5)
    assert found.line.deviation < 0.005 and found.line.b == pytest.approx(LINE.b, abs=0.03)
    for point in found.points:
        assert 0.65 < point.distance / float(LINE.distance(point.pressure)) < 0.8
