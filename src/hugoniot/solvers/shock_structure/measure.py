r"""Thickness of a shock from cell averages.

The cumulative mass $M(x) = \int\rho\,dx$ is known exactly at the faces. The slope of a quintic spline through it is the density, so the
steepest gradient is found between cells and to high order. (Jordan eq. 6.2.5 uses central differences at the cells: second order.)
"""

import numpy as np
from scipy.interpolate import make_interp_spline

from hugoniot.errors import NoSolution


def density_spline(faces, density):
    """Spline of the running mass; its derivative is the density. faces (n+1,) m, density (n,) kg/m3 averages."""
    mass = np.concatenate([[0.0], np.cumsum((density - density.mean()) * np.diff(faces))])
    return make_interp_spline(faces, mass, k=5)


def thickness(faces, density, low: float, high: float, velocity=None) -> tuple[float, float]:
    """(thickness, position of the steepest gradient), m, of a density profile between the end values `low` and `high`, kg/m3.

    velocity   averages (n,), m/s: looks where the flow is compressed most. A start from a step leaves a contact behind the shock, which
               without heat conduction stays as steep as the shock itself but has no velocity of its own.
    """
    steep = density_spline(faces, density).derivative(2)
    first, last = (1, len(faces) - 2) if velocity is None else _shock_faces(velocity)
    fine = np.linspace(faces[first], faces[last], 8 * (last - first))
    i = int(np.argmax(np.abs(steep(fine))))
    x = np.linspace(fine[max(i - 1, 0)], fine[min(i + 1, len(fine) - 1)], 201)
    slopes = np.abs(steep(x))
    k = int(np.argmax(slopes))
    if not slopes[k] > 0.0:
        raise NoSolution("there is no shock in this profile: its density does not change")
    return abs(high - low) / float(slopes[k]), float(x[k])


def _shock_faces(velocity):
    """(first, last) of the faces about the steepest velocity over which it changes at least a tenth as steeply, and two more."""
    jumps = np.abs(np.diff(velocity))          # at the inner faces 1 ... n - 1
    first = last = int(np.argmax(jumps))
    least = 0.1 * jumps[first]
    while first > 0 and jumps[first - 1] > least:
        first -= 1
    while last < len(jumps) - 1 and jumps[last + 1] > least:
        last += 1
    return max(first - 1, 1), min(last + 3, len(velocity) - 1)


def thickness_by_differences(spacing, density, low: float, high: float) -> float:
    """Jordan eq. 6.2.5 as it stands: |jump| over the largest central difference of neighbouring cells, m.

    Never below twice the spacing where the profile does not overshoot its ends.
    """
    return abs(high - low) / float(np.abs(density[2:] - density[:-2]).max() / (2.0 * spacing))
