"""The step of `wilkins` and its linear viscosity, which acts on the nodes one step late: von Neumann analysis, and a weak pulse in a gas."""

import numpy as np
import pytest

from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, OutputOptions, Problem, Pulse, Region, SolverOptions
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d.layout import Z
from hugoniot.solvers.lagrange1d.leapfrog_passes import signal_squared


def growth(courant, viscous):
    """Largest amplification of a linear wave per step of the leapfrog with q a step late; courant = c dt/dr, viscous = w dt/dr.

    Its amplitudes are those of u at n-1/2, of the jump of u that made q, and of p at n; found from the step as it is done.
    """
    largest = 0.0
    for angle in np.linspace(0.02, np.pi, 120):
        slope = 2j * np.sin(0.5 * angle)
        speed = np.array([1.0 + viscous * slope**2, -courant * slope])      # u at n+1/2: pushed by q = -w slope u, and by p
        once = np.array([speed, [0.0, 1.0] - courant * slope * speed])       # p at n+1 by that velocity
        largest = max(largest, float(np.abs(np.linalg.eigvals(once)).max()))
    return largest


@pytest.mark.parametrize("ratio", [0.0, 0.2, 0.4, 0.5, 0.7, 1.0 / np.sqrt(1.4), 1.0, 3.0])
def test_no_wave_grows_at_the_step_of_the_linear_viscosity(ratio):
    """w = ratio c: stable at 2/3 over the signal speed, unstable 1 % beyond dr/(w + sqrt(w^2 + c^2)), which the step is close to."""
    step = (2.0 / 3.0) / np.sqrt(signal_squared(1.0, 0.0, ratio))
    limit = 1.0 / (ratio + np.sqrt(ratio**2 + 1.0))
    assert growth(step, ratio * step) < 1.0 + 1e-9
    assert growth(1.01 * limit, 1.01 * ratio * limit) > 1.005
    assert 0.66 < step / limit < 1.0 and (ratio > 0.34) == (step < 0.6666)


def test_the_printed_step_lets_waves_of_a_gas_grow():
    """W-7 without the limit: a step of 2/3 of the transit time, with w = sqrt(P/rho) of a gas of 1.4."""
    assert growth(2.0 / 3.0, 2.0 / 3.0 / np.sqrt(1.4)) > 1.5


def pulse(integrator, courant=None, linear=1.0):
    """Height of a half sine of 1 % of the pressure, 80 zones long, after 240 zones, over the height at which it was sent."""
    gas, c = Material("gas", IdealGas(1.4, 1000.0, 1.0)), np.sqrt(1.4)
    viscosity = ("wilkins", {"linear": linear}) if integrator == "wilkins" else None
    problem = Problem("pulse", "planar", 0.6 / c, (Region("gas", "gas", 0.0, 1.0, 400, density=1.0, pressure=1.0),), {"gas": gas},
                      Boundary("velocity", Pulse("half_sine", amplitude=0.01 / c, duration=0.2 / c)), Boundary("fixed"),
                      solver=SolverOptions(integrator=integrator, courant=courant, viscosity=viscosity), output=OutputOptions(report=False))
    solver = make_solver(problem)
    while solver.time < problem.stop_time:
        solver.march(problem.stop_time, 10**6)
    return (solver.zones[Z.p].max() - 1.0) / 0.01


def test_a_weak_pulse_is_damped_by_the_viscosity_and_not_by_the_step():
    """With the defaults it keeps 94.7 % of its height at any step, and the loss is the linear coefficient's: half of it with 0.5, none with 0."""
    assert pulse("wilkins") == pytest.approx(0.947, abs=2e-3)
    assert pulse("wilkins") == pytest.approx(pulse("wilkins", 0.3), abs=1e-3)
    assert pulse("wilkins", linear=0.5) == pytest.approx(0.974, abs=2e-3)
    assert pulse("wilkins", linear=0.0) == pytest.approx(1.0, abs=6e-3)
    assert pulse("compatible") == pytest.approx(1.0, abs=2e-3)


def test_the_first_kick_lasts_half_of_the_first_step():
    """A pressure on a plate for 1 ns in steps of 0.1 ns, where sound would allow 2 ns at first: the impulse is p t less half a step."""
    region = Region("gas", "gas", 0.0, 0.1, 4, density=1000.0)
    push = Boundary("pressure", Pulse("constant", 1e6))
    problem = Problem("kick", "planar", 1e-9, (region,), {"gas": Material("gas", MieGruneisen(1000.0, 1500.0, 1.5, 1.0))}, left=push,
                      solver=SolverOptions(integrator="wilkins", largest_step=1e-10), output=OutputOptions(report=False))
    solver = make_solver(problem)
    while solver.time < 1e-9:
        solver.march(1e-9, 100)
    assert solver.exchanges()["impulse_left"] == pytest.approx(1e6 * 0.95e-9, rel=1e-9)
