"""Threshold burn of the KB codes: a zone burns at once when its pressure passes a limit.

The zone's chemical energy Q is released and the products' law takes over. **The speed of the wave this makes depends on the threshold
and does not converge with the mesh**: the release acts inside the smeared shock, at a place of its profile that the threshold chooses.
Measured for Composition B (rho0 = 1770, Q = 6.27 MJ/kg, gamma = 3, exact D = 10.016 km/s): 14.38 km/s at 1 GPa, 10.30 at 5, 9.87 at 10,
9.93 at 20, 9.97 at 30, 9.995 at 40 GPa, within 0.3 % the same for 200 and 800 zones. Between 5 and 40 GPa it is right to 3 %.

Source: 001 (KB codes) section 4; K-E4, K-E11.
"""

from typing import NamedTuple

from hugoniot.laws.burn.contract import BURN, no_rate, no_schedule


class Threshold(NamedTuple):
    initiation_pressure: float


def advance(burn_fraction, dt, rho, p, temperature, par):
    return 1.0 if p > par.initiation_pressure else burn_fraction


BURN.add(
    "threshold", Threshold,
    functions={"rate": no_rate, "advance": advance, "scheduled": no_schedule},
    example=Threshold(20.0e9),
    units={"initiation_pressure": "Pa"}, meaning={"initiation_pressure": "pressure above which a zone burns at once"},
    box={"p": (0.0, 60.0e9)},
    references=("KB codes, section 4",),
    flags=("pressure_driven", "instantaneous"),
)
