r"""Forces against hourglass motion, which does not affect the mean gradient; their work is part of the energy that a zone gains.

* `subzonal` (fluids): the mass of the quarter of a zone at a corner is constant, so its density follows its area
  $A_k = A/8 + T_k/4$ ($T_k$ the corner's triangle); $\delta p_k = m\,\rho c^2 (\varphi_{k0}/\varphi_k - 1)$, $\varphi_k = A_k/A$, acts on
  the quarter's surface. Zero in every linear motion. Caramana & Shashkov, J. Comput. Phys. 142 (1998) 521.
* `viscous` (solids): $f_k = -\kappa\,\tfrac14\rho c\sqrt A\,\gamma_k (\gamma\cdot u)$, with $\gamma$ the hourglass vector made
  orthogonal to every linear motion. Flanagan & Belytschko, Int. J. Numer. Methods Eng. 17 (1981) 679.
"""

from hugoniot.core.binder import bind
from hugoniot.core.ops import vsqrt


def subzonal(q, t0, t1, stiffness):
    """Planar forces (x, y of corners 0 to 3) of the subzonal pressures.

    t0, t1      triangles at corners 0 and 1 over the area, at t = 0
    stiffness   merit factor times rho c^2, Pa
    """
    inverse = 1.0 / q.area
    a, b, a0, b0 = 0.25 * q.t0 * inverse, 0.25 * q.t1 * inverse, 0.25 * t0, 0.25 * t1
    eighth = 0.125 * stiffness
    # a quarter of half the pressures: what a corner's triangle feels
    e0, e1 = eighth * (a0 - a) / (0.125 + a), eighth * (b0 - b) / (0.125 + b)
    e2, e3 = eighth * (a - a0) / (0.375 - a), eighth * (b - b0) / (0.375 - b)
    mean = e0 + e1 + e2 + e3      # the part that moves the whole zone
    ax, ay, bx, by = mean * q.ax, mean * q.ay, mean * q.bx, mean * q.by
    # edges from corner to corner, turned: the force of a unit pressure on them
    p0x, p0y, p1x, p1y = q.y1 - q.y0, q.x0 - q.x1, q.y2 - q.y1, q.x1 - q.x2
    p2x, p2y, p3x, p3y = q.y3 - q.y2, q.x2 - q.x3, q.y0 - q.y3, q.x3 - q.x0
    x0 = ax + e0 * (p0x + p3x) - e1 * p1x - e3 * p2x
    y0 = ay + e0 * (p0y + p3y) - e1 * p1y - e3 * p2y
    x1 = bx + e1 * (p1x + p0x) - e2 * p2x - e0 * p3x
    y1 = by + e1 * (p1y + p0y) - e2 * p2y - e0 * p3y
    x2 = -ax + e2 * (p2x + p1x) - e3 * p3x - e1 * p0x
    y2 = -ay + e2 * (p2y + p1y) - e3 * p3y - e1 * p0y
    x3 = -bx + e3 * (p3x + p2x) - e0 * p0x - e2 * p1x
    y3 = -by + e3 * (p3y + p2y) - e0 * p0y - e2 * p1y
    return x0, y0, x1, y1, x2, y2, x3, y3


def viscous(q, low, high, j, impedance):
    """(planar forces (x, y of corners 0 to 3), power taken from the motion); impedance: coefficient times rho c."""
    inverse = 1.0 / q.area
    gx, gy = (q.x0 - q.x1 + q.x2 - q.x3) * inverse, (q.y0 - q.y1 + q.y2 - q.y3) * inverse
    # gamma_k = (+-1) - sum(+-x) a_kx / A - sum(+-y) a_ky / A, a_0 = -a_2, a_1 = -a_3
    a, b = gx * q.ax + gy * q.ay, gx * q.bx + gy * q.by
    g0, g1, g2, g3 = 1.0 - a, -1.0 - b, 1.0 + a, -1.0 + b
    u = g0 * low.u[j] + g1 * high.u[j] + g2 * high.u[j + 1] + g3 * low.u[j + 1]
    v = g0 * low.v[j] + g1 * high.v[j] + g2 * high.v[j + 1] + g3 * low.v[j + 1]
    size = -0.25 * impedance * vsqrt(q.area)
    power = -size * (u * u + v * v)
    u, v = u * size, v * size
    return g0 * u, g0 * v, g1 * u, g1 * v, g2 * u, g2 * v, g3 * u, g3 * v, power


bind(subzonal)
bind(viscous)
