r"""What a velocity interferometer sees of an interface through a window.

The light runs through the vacuum before the window's far surface, through the window, and through the gap behind it where one has opened.
Where the index is linear in the density, $n = a + b\rho$, the optical path in a plane window of length L and mass M per area is
$aL + bM$, whatever waves run in it, and the apparent velocity towards the instrument is

$$u_a = u_r + (a - 1)(u_n - u_f)$$

with the velocities of the reflecting surface and of the near and the far face of the window; $a u$ for a window that touches and whose far
face is at rest (D. Hayes, J. Appl. Phys. 89 (2001) 6484). A transmitting end stands for more of the window at rest: $u_f = 0$, as for a
fixed one.
"""

from collections.abc import Mapping

import numpy as np

from hugoniot.problem.model import Problem

APPARENT = "apparent_velocity"


def with_apparent_velocity(problem: Problem, values: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Gauge records (n, ngauge) with `apparent_velocity` (m/s; NaN for gauges without a window), if any gauge has a window."""
    found = dict(values)
    if not any(getattr(gauge, "window", "") for gauge in problem.gauges):
        return found
    seen = np.full_like(values["velocity"], np.nan)
    velocity = {gauge.at: values["velocity"][:, k] for k, gauge in enumerate(problem.gauges)}
    for k, gauge in enumerate(problem.gauges):
        if not gauge.window:
            continue
        first, last = (part.strip() for part in str(gauge.at).split("/", 1))
        faces = [velocity[f"{first}:right"], velocity[f"{last}:left"]]
        near = faces.pop(0 if gauge.window == first else 1)
        side = "left" if gauge.window == problem.regions[0].name else "right"
        far = next((velocity[at] for at in (f"free surface {side}", f"{gauge.window}:{side}") if at in velocity), 0.0)
        far = far if getattr(problem, side).kind == "free" else 0.0
        factor = np.nan if gauge.window_factor is None else gauge.window_factor
        seen[:, k] = faces[0] + (factor - 1.0) * (near - far)
    return found | {APPARENT: seen}
