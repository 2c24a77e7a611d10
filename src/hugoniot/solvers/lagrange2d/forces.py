"""Corner forces of a zone by virtual work, into its rows."""

from hugoniot.core.binder import bind


def stress_forces(f, j, b, p, xx, yy, xy, qxx, qyy, qxy, qhoop):
    """Forces of the stress of zone j: pressure, deviators and mean viscous stress (compression positive)."""
    hoop = -(xx + yy) - p - qhoop
    xx, yy, xy = xx - p - qxx, yy - p - qyy, xy - qxy
    f.f0x[j] = -(b.b0x * xx + b.b0y * xy + b.h0 * hoop)
    f.f0y[j] = -(b.b0x * xy + b.b0y * yy)
    f.f1x[j] = -(b.b1x * xx + b.b1y * xy + b.h1 * hoop)
    f.f1y[j] = -(b.b1x * xy + b.b1y * yy)
    f.f2x[j] = -(b.b2x * xx + b.b2y * xy + b.h2 * hoop)
    f.f2y[j] = -(b.b2x * xy + b.b2y * yy)
    f.f3x[j] = -(b.b3x * xx + b.b3y * xy + b.h3 * hoop)
    f.f3y[j] = -(b.b3x * xy + b.b3y * yy)


def triangle_forces(f, j, b, p, xx, yy, xy, qxx, qyy, qxy, qhoop):
    """The same of a triangle."""
    hoop = -(xx + yy) - p - qhoop
    xx, yy, xy = xx - p - qxx, yy - p - qyy, xy - qxy
    f.f0x[j] = -(b.b0x * xx + b.b0y * xy + b.h0 * hoop)
    f.f0y[j] = -(b.b0x * xy + b.b0y * yy)
    f.f1x[j] = -(b.b1x * xx + b.b1y * xy + b.h1 * hoop)
    f.f1y[j] = -(b.b1x * xy + b.b1y * yy)
    f.f2x[j] = -(b.b2x * xx + b.b2y * xy + b.h2 * hoop)
    f.f2y[j] = -(b.b2x * xy + b.b2y * yy)


def add_forces(f, j, b, x0, y0, x1, y1, x2, y2, x3, y3):
    """Add planar forces with the weights of the geometry."""
    f.f0x[j] += b.w0 * x0
    f.f0y[j] += b.w0 * y0
    f.f1x[j] += b.w1 * x1
    f.f1y[j] += b.w1 * y1
    f.f2x[j] += b.w2 * x2
    f.f2y[j] += b.w2 * y2
    f.f3x[j] += b.w3 * x3
    f.f3y[j] += b.w3 * y3


bind(stress_forces)
bind(triangle_forces)
bind(add_forces)
