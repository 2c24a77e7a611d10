r"""Threshold burn of the KB codes: a zone burns instantaneously when its pressure exceeds a limit.

$$\lambda = 1 \quad\text{once}\quad p > P_{init}$$

The zone's chemical energy Q is released and the law of the products applies. **The speed of the resulting wave depends on the threshold
and does not converge with the mesh**: the energy is released inside the smeared shock, at a point of its profile set by the threshold, so
the speed depends on everything that shapes this profile, including the time step. For Composition B (rho0 = 1770 kg/m3, Q = 6.27 MJ/kg,
gamma = 3, exact D = 10.016 km/s) behind a piston at the CJ velocity, and P_init = 1, 5, 10, 20, 30, 40 GPa, the speed is

* as in the KB codes (leapfrog, `shock_energy` before burning, `kb_two_sided` with C = 1, courant 0.25): 14.39, 10.26, 9.85, 9.92,
  9.95, 9.99 km/s, the same on 200 and 800 zones within 0.25 %, and up to 3 % different with courant 0.2 or 0.3 (1 GPa: 9 %)
* with `compatible` and a Mie-Grüneisen explosive: 12.5, 10.14, 10.10, 10.13, 10.18, 10.22 km/s

Between 5 and 40 GPa the speed is correct to 3 %.

Source: KB codes section 4; K-E4, K-E11.
"""

from typing import NamedTuple

from hugoniot.laws.burn.contract import BURN, no_rate, no_schedule
from hugoniot.laws.burn.depletion import without_negatives


class Threshold(NamedTuple):
    initiation_pressure: float


def advance(burn_fraction, dt, rho, p, temperature, par):
    return 1.0 if p > par.initiation_pressure else burn_fraction


def build(*values, **named) -> Threshold:
    """Parameters; OutOfRange for a negative one."""
    return without_negatives("threshold burn", Threshold(*values, **named))


BURN.add(
    "threshold", Threshold,
    functions={"rate": no_rate, "advance": advance, "scheduled": no_schedule},
    example=Threshold(20.0e9),
    units={"initiation_pressure": "Pa"}, meaning={"initiation_pressure": "pressure above which a zone burns instantaneously"},
    box={"p": (0.0, 60.0e9)},
    references=("KB codes, section 4",),
    flags=("pressure_driven", "instantaneous"),
    build=build,
)
