r"""Forces against hourglass motion, which no mean gradient sees; their work is part of the energy a zone gains.

* `subzonal` (fluids): the mass of a zone's quarter at a corner stays, so its density follows its area
  $A_k = A/8 + T_k/4$ ($T_k$ the corner's triangle); $\delta p_k = m\,\rho c^2 (\varphi_{k0}/\varphi_k - 1)$, $\varphi_k = A_k/A$, acts on
  the quarter's surface. Zero in every linear motion. Caramana & Shashkov, J. Comput. Phys. 142 (1998) 521.
* `viscous` (solids): $f_k = -\kappa\,\tfrac14\rho c\sqrt A\,\gamma_k (\gamma\cdot u)$, with $\gamma$ the hourglass vector made
  orthogonal to every linear motion. Flanagan & Belytschko, Int. J. Numer. Methods Eng. 17 (1981) 679.
"""

from typing import Any, NamedTuple

from hugoniot.core.ops import vsqrt
from hugoniot.core.passes import rows_apart
from hugoniot.solvers.lagrange2d.layout import Corners, Points, Shape
from hugoniot.solvers.lagrange2d.row_pass import row_pass


class SubzonalOf(NamedTuple):
    """Shape, corner triangles over the area at t = 0, rho c^2 -> half the subzonal pressure of the four corners, Pa."""

    s: Shape
    t0: Any
    t1: Any
    stiffness: Any
    e0: Any
    e1: Any
    e2: Any
    e3: Any


class SubzonalMeanOf(NamedTuple):
    """Two rows of nodes, shape and half the subzonal pressures: added to corner forces."""

    low: Points
    high: Points
    s: Shape
    e0: Any
    e1: Any
    e2: Any
    e3: Any
    f: Corners


class ViscousOf(NamedTuple):
    """Two rows of nodes, shape and rho c: added to corner forces; power of the filter, W/kg."""

    low: Points
    high: Points
    s: Shape
    impedance: Any
    inverse_mass: Any
    f: Corners
    power: Any



@row_pass(SubzonalOf)
def subzonal(count, given, dt, numbers, law):
    """Half the subzonal pressure of the four corners, Pa; numbers[0] is the merit factor."""
    rows_apart()
    s, t0, t1, stiffness, e0, e1, e2, e3 = given
    merit = numbers[0]
    for j in range(count):
        inverse = 1.0 / s.area[j]
        a, b = 0.25 * s.t0[j] * inverse, 0.25 * s.t1[j] * inverse
        a0, b0 = 0.25 * t0[j], 0.25 * t1[j]
        half = 0.5 * merit * stiffness[j]
        e0[j] = half * (a0 - a) / (0.125 + a)
        e1[j] = half * (b0 - b) / (0.125 + b)
        e2[j] = half * (a - a0) / (0.375 - a)
        e3[j] = half * (b - b0) / (0.375 - b)


@row_pass(SubzonalMeanOf)
def subzonal_mean(count, given, dt, numbers, law):
    """The part of the subzonal pressures' force that moves the whole zone: sum(dp_k) / 8 on its surface (given are dp/2)."""
    rows_apart()
    low, high, s, e0, e1, e2, e3, f = given
    for j in range(count):
        p = 0.25 * (e0[j] + e1[j] + e2[j] + e3[j])
        ax, ay = 0.5 * p * (high.y[j] - low.y[j + 1]), 0.5 * p * (low.x[j + 1] - high.x[j])
        bx, by = 0.5 * p * (high.y[j + 1] - low.y[j]), 0.5 * p * (low.x[j] - high.x[j + 1])
        f.f0x[j] += ax * s.w0[j]
        f.f0y[j] += ay * s.w0[j]
        f.f1x[j] += bx * s.w1[j]
        f.f1y[j] += by * s.w1[j]
        f.f2x[j] -= ax * s.w2[j]
        f.f2y[j] -= ay * s.w2[j]
        f.f3x[j] -= bx * s.w3[j]
        f.f3y[j] -= by * s.w3[j]


@row_pass(ViscousOf)
def viscous(count, given, dt, numbers, law):
    """Add the viscous filter's forces; numbers[1] is its coefficient."""
    rows_apart()
    low, high, s, impedance, inverse_mass, f, power = given
    coefficient = numbers[1]
    for j in range(count):
        x0, y0, x1, y1 = low.x[j], low.y[j], high.x[j], high.y[j]
        x2, y2, x3, y3 = high.x[j + 1], high.y[j + 1], low.x[j + 1], low.y[j + 1]
        inverse = 1.0 / s.area[j]
        gx, gy = (x0 - x1 + x2 - x3) * inverse, (y0 - y1 + y2 - y3) * inverse
        # gamma_k = (+-1) - sum(+-x) a_kx / A - sum(+-y) a_ky / A, a_0 = -a_2, a_1 = -a_3
        a = 0.5 * (gx * (y1 - y3) + gy * (x3 - x1))
        b = 0.5 * (gx * (y2 - y0) + gy * (x0 - x2))
        g0, g1, g2, g3 = 1.0 - a, -1.0 - b, 1.0 + a, -1.0 + b
        u = g0 * low.u[j] + g1 * high.u[j] + g2 * high.u[j + 1] + g3 * low.u[j + 1]
        v = g0 * low.v[j] + g1 * high.v[j] + g2 * high.v[j + 1] + g3 * low.v[j + 1]
        size = -0.25 * coefficient * impedance[j] * vsqrt(s.area[j])
        # with the velocities predicted for the middle of the step
        weight = 0.25 * (s.w0[j] + s.w1[j] + s.w2[j] + s.w3[j])
        power[j] = -size * weight * (u * u + v * v) * inverse_mass[j]
        u, v = u * size, v * size
        f.f0x[j] += g0 * u * s.w0[j]
        f.f0y[j] += g0 * v * s.w0[j]
        f.f1x[j] += g1 * u * s.w1[j]
        f.f1y[j] += g1 * v * s.w1[j]
        f.f2x[j] += g2 * u * s.w2[j]
        f.f2y[j] += g2 * v * s.w2[j]
        f.f3x[j] += g3 * u * s.w3[j]
        f.f3y[j] += g3 * v * s.w3[j]
