r"""Threshold burn of the KB codes: a zone burns instantaneously when its pressure exceeds a limit.

$$\lambda = 1 \quad\text{once}\quad p > P_{init}$$

* $\lambda$: burned mass fraction; $p$: pressure of the zone; $P_{init}$: `initiation_pressure`

When a zone burns, its chemical energy is released and the equation of state of the products applies. **The speed of the resulting wave
depends on the threshold and does not converge to the CJ velocity as the mesh is refined**: the energy is released inside the smeared
shock, at a point of its profile set by the threshold, so everything that shapes this profile affects the speed, including the time step.

The table shows the speed of the wave ahead of a piston that moves at the CJ particle velocity. The explosive is Composition B with the
constants of the KB codes' manual (Field Precision, 2000): reference density 1770 kg/m³, chemical energy 6.27 MJ/kg, products with
gamma = 3. The CJ velocity of this model is 10.016 km/s; that of the real explosive is about 8 km/s.

| $P_{init}$, GPa | 1 | 5 | 10 | 20 | 30 | 40 |
|---|---|---|---|---|---|---|
| speed with the integrator of the KB codes, km/s | 14.39 | 10.26 | 9.85 | 9.92 | 9.95 | 9.99 |
| speed with the integrator `compatible`, km/s | 12.4 | 10.15 | 10.05 | 10.12 | 10.18 | 10.21 |

The first row uses the integrator of the KB codes, `shock_energy` for the unreacted explosive, `kb_two_sided` with coefficient 1 and a
Courant number of 0.25. These speeds agree to within 0.25 % between 200 and 800 zones, and change by up to 3 % (at 1 GPa by 9 %) with
Courant numbers of 0.2 or 0.3. The second row uses the integrator `compatible` with its default viscosity and Courant number, and a
Mie-Grüneisen equation of state for the unreacted explosive. Between 5 and 40 GPa both rows agree with the CJ velocity of the model to 3 %.
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
    return without_negatives(Threshold(*values, **named))


BURN.add(
    "threshold", Threshold,
    functions={"rate": no_rate, "advance": advance, "scheduled": no_schedule},
    example=Threshold(20.0e9),
    units={"initiation_pressure": "Pa"}, meaning={"initiation_pressure": "pressure above which a zone burns instantaneously"},
    box={"p": (0.0, 60.0e9)},
    references=("KB codes manual (Field Precision, 2000), section 4 (K-E4, K-E11)",),
    flags=("pressure_driven", "instantaneous"),
    build=build,
)
