"""Artificial viscosity of a zone: its signal speed, the velocity jump, and the smoothness that switches it off."""

from typing import Any, NamedTuple

from hugoniot.core.ops import fmax, fmin
from hugoniot.core.passes import flag_of
from hugoniot.laws.viscosity.contract import VISCOSITY, viscous_speed

SMALL = 1e-30
# mobility of a zone's jump over dt A / m: 1 for what its own q does in half a step, 2 for zones that close and open in turn. With 4 shocks
# overshoot least in steps of 0.7 of the Courant step (0.2 % in the flyer of the examples; 0.4 % with 2, 9 % without)
OWN = 4.0
WEAK = 5e-4           # |du| / c of a zone: below it a viscosity counts a sixth as much in the time step
two_sided = flag_of(VISCOSITY, "two_sided")     # whether a viscosity acts in expansion too


class Resisting(NamedTuple):
    """What a pass of artificial viscosity is compiled for: parameters of the law, geometry of the solver."""

    law: Any
    geometry: Any


def resisted(du, growth, law):
    """The velocity jump an artificial viscosity resists: 0 unless the zone narrows and shrinks (`growth` < 0), but for two-sided laws."""
    return du if two_sided(law) else fmin(du if growth < 0.0 else 0.0, 0.0)


def smoothness(left, own, right):
    """1 where the velocity gradient (1/s) is that of its neighbours, 0 at a shock or an extremum.

    Ratios of the neighbours' gradients to this one (Caramana, Shashkov and Whalen 1998, J. Comput. Phys. 144, 70).
    """
    steep, before, behind = -own, -left, -right
    smooth = fmax(0.0, fmin(fmin(0.5 * (before + behind), steep), 2.0 * fmin(before, behind)))
    return fmin(smooth / (fmax(steep, 0.0) + SMALL), 1.0)


def resisting_speed(v, c, p, squeeze, smooth, law):
    """Signal speed of the viscosity, m/s: q = rho |squeeze| times it; 0 where nothing is squeezed."""
    speed = viscous_speed(v, c, p, squeeze, smooth, law)
    return speed if squeeze != 0.0 else 0.0


def at_middle(du, q, mobility, resistance):
    """A velocity jump `du` extrapolated to the middle of a step, corrected for the change of its own viscous pressure, m/s.

    It was extrapolated with an acceleration one step old, the viscous pressure `q` of that step in it, and zones that close and open in
    turn would swing up in long steps. What the change of q since does to the jump, `mobility` (m/s per Pa), is taken from q in the middle,
    -resistance du. It only reduces the jump: where q falls, behind a front that burns, it would come too late.
    """
    own = (du - mobility * q) / (1.0 + mobility * resistance)
    return fmin(fmax(own, fmin(du, 0.0)), fmax(du, 0.0))


def signal_speed(c, w, q, rho):
    """Speed that sets the time step, m/s: c + 2 w in a shock, c + w/3 where the jump of the zone, q / (rho w), is below WEAK c.

    Shocks overshoot where a step does not follow what q changes in it. Weak jumps need less care: with the reduction of `at_middle` linear
    waves of all lengths are damped by any w in steps of 0.7 times the zone's width over this speed, as long as shear modulus and energy
    have no more than 0.7 of the stiffness: their stress in the middle of the step follows the velocities extrapolated to it.
    """
    return c + (2.0 * w if q > WEAK * rho * c * w else w * (1.0 / 3.0))
