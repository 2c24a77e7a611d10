r"""Impedance matching: the states that a flyer produces in a stack of layers, interface by interface, with reshock and release.

When a shock reaches an interface, pressure and velocity behind the transmitted and the reflected wave are equal. The state is therefore the
intersection of the Hugoniot of the layer ahead, A, with the curve of the layer behind, B, for the reflected wave: a reshock if the layer
ahead is stiffer, a release isentrope if it is softer.

$$u_B - \phi_B(p) = u_A + \phi_A(p), \qquad \phi_k(p) = \begin{cases}\sqrt{(p - p_k)(v_k - v_H(p))} & p > p_k\\[2pt]
  \int_{p_k}^{p} dp/(\rho c) & p < p_k\end{cases}$$

* $u_k$, $p_k$, $v_k$: particle velocity, pressure and specific volume $1/\rho$ of layer k before the interaction
* $v_H$: specific volume on the Hugoniot from that state; the integral is along its isentrope

The curves are exact: the reflected Hugoniot is not approximated by the mirror image of the principal one.

Source: KB codes manual, section 2; Meyers, Dynamic Behavior of Materials, ch. 7, for the method.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from hugoniot.errors import OutOfRange
from hugoniot.theory.isentrope import reference, release
from hugoniot.theory.riemann import Riemann, riemann
from hugoniot.theory.states import States, law_of


@dataclass(frozen=True)
class Match:
    """What happens when a wave reaches an interface.

    interface               number of the interface; 0 is that of the flyer and the first layer
    left, right             `States` on its two sides afterwards; a state behind a shock has a shock_velocity
    wave_left, wave_right   the outgoing waves: "shock", "fan" or "none"
    separated               whether the two sides separate
    """

    interface: int
    left: States
    right: States
    wave_left: str
    wave_right: str
    separated: bool

    @property
    def pressure(self) -> float:
        """Pressure at the interface, Pa."""
        return self.right.pressure

    @property
    def particle_velocity(self) -> float:
        """Particle velocity at the interface, m/s."""
        return self.right.particle_velocity


def match(layers: Sequence, velocity: float, *, initial: Sequence[States] | None = None) -> list[Match]:
    """Solve the impedance match of an impact on a stack of layers.

    layers     materials or parameters of equations of state: the flyer first, then the layers that it hits, at least two in all
    velocity   of the flyer towards the layers, m/s
    initial    states before the impact (default: the reference states, with the flyer at `velocity`)

    Returns a list of `Match`, one for each interface, in the order in which the first shock reaches them. Raises `OutOfRange` if the flyer
    does not move towards the layers, or if a state is outside the range of a law.

    >>> match([copper, aluminium], 1000.0)[0].pressure     # Pa
    """
    if len(layers) < 2:
        raise OutOfRange("an impact needs a flyer and at least one target")
    start = list(initial) if initial else [reference(layers[0], velocity), *(reference(layer) for layer in layers[1:])]
    if not start[0].particle_velocity > start[1].particle_velocity:
        raise OutOfRange(f"a flyer at {start[0].particle_velocity:.6g} m/s does not strike a target at "
                         f"{start[1].particle_velocity:.6g} m/s: give a positive impact velocity")
    arriving, met = start[0], []
    for k in range(len(layers) - 1):
        met.append(_meet(k, layers[k], arriving, layers[k + 1], start[k + 1]))
        arriving = met[-1].right
    return met


def first_jump(layer: int, velocity: float, met: Sequence[Match]) -> float:
    """The change of the particle velocity, m/s, in the first shock through a layer of a stack.

    layer      number of the layer; 0 is the flyer
    velocity   velocity of the flyer, m/s
    met        result of `match`
    """
    return velocity - met[0].left.particle_velocity if layer == 0 else met[layer - 1].right.particle_velocity


def ring_up(layers: Sequence, velocity: float, *, layer: int = 1, bounces: int = 10) -> list[Match]:
    """The states of one layer as the wave reverberates between its neighbours, which are taken as semi-infinite.

    layers     as in `match`
    velocity   velocity of the flyer, m/s
    layer      number of the layer in the stack, with neighbours on both sides
    bounces    number of reflections after the first shock has reached the far side of the layer

    Returns a list of `Match`: the first passage, then the reflections at the far and the near interface of the layer in turn.
    """
    if not 1 <= layer <= len(layers) - 2:
        known = f"choose a layer from 1 to {len(layers) - 2}" if len(layers) > 2 else "a stack of three or more is needed"
        raise OutOfRange(f"layer {layer} does not have two neighbours in a stack of {len(layers)} layers (numbered from 0): {known}")
    met = match(layers[: layer + 2], velocity)
    near, far = met[layer - 1], met[layer]
    outer_left, inner, outer_right = near.left, far.left, far.right
    for k in range(bounces):
        if k % 2 == 0:
            meeting = _meet(layer - 1, layers[layer - 1], outer_left, layers[layer], inner)
            outer_left, inner = meeting.left, meeting.right
        else:
            meeting = _meet(layer, layers[layer], inner, layers[layer + 1], outer_right)
            inner, outer_right = meeting.left, meeting.right
        met.append(meeting)
    return met


def free_surface(material, state: States, *, to: float = 0.0) -> States:
    """The state at a free surface after a shock has reached it, by isentropic release.

    material   a `Material`, or the parameters of an equation of state
    state      the state behind the shock
    to         final pressure, Pa

    Returns `States`.
    """
    return release(law_of(material), state, to, direction=-1)


def _meet(k, left, left_state, right, right_state) -> Match:
    found: Riemann = riemann(left, left_state, right, right_state)
    return Match(k, found.left.behind, found.right.behind, found.left.kind, found.right.kind, found.vacuum)
