r"""What is derived from the four stress deviators of two dimensions: von Mises stress, principal direction, Lode angle.

$$\sigma_e = \sqrt{\tfrac32\left(s_{xx}^2 + s_{yy}^2 + s_{zz}^2 + 2 s_{xy}^2\right)},\qquad
  \tan 2\varphi = \frac{2 s_{xy}}{s_{xx} - s_{yy}},\qquad
  \tan\theta = \frac{2 s_2 - s_1 - s_3}{\sqrt3\,(s_1 - s_3)}$$

with the principal deviators $s_1 \ge s_2 \ge s_3$; theta is -30 degrees in uniaxial tension, 0 in pure shear, 30 degrees in uniaxial
compression. Source: Herrmann WL-TR-64-107 B.33 to B.35, whose printed angles are corrected (docs: source errors, H-E1 and H-E2);
his Lode angle is minus this one where the stress out of the plane is the middle one.
"""

import numpy as np

DERIVED = ("von_mises", "principal_angle", "lode_angle")


def von_mises(sxx, syy, sxy, szz):
    """Von Mises stress, Pa."""
    return np.sqrt(1.5 * (sxx**2 + syy**2 + szz**2 + 2.0 * sxy**2))


def principal_deviators(sxx, syy, sxy, szz):
    """(3, ...) principal deviators, largest first, Pa."""
    middle, radius = 0.5 * (sxx + syy), np.hypot(0.5 * (sxx - syy), sxy)
    return -np.sort(-np.stack(np.broadcast_arrays(middle + radius, middle - radius, szz)), axis=0)


def principal_angle(sxx, syy, sxy):
    """Direction of the larger principal stress in the plane, rad from x, in (-pi/2, pi/2]; 0 where there is none."""
    return 0.5 * np.arctan2(2.0 * sxy, sxx - syy)


def lode_angle(sxx, syy, sxy, szz):
    """Lode angle, rad, in [-pi/6, pi/6]; 0 without stress."""
    first, second, third = principal_deviators(sxx, syy, sxy, szz)
    return np.arctan2(2.0 * second - first - third, np.sqrt(3.0) * (first - third))


def derived_field(name: str, fields: dict) -> np.ndarray:
    """One of `DERIVED` from fields by name."""
    sxx, syy, sxy, szz = (fields[f"deviator_{part}"] for part in ("xx", "yy", "xy", "zz"))
    if name == "principal_angle":
        return principal_angle(sxx, syy, sxy)
    return (von_mises if name == "von_mises" else lode_angle)(sxx, syy, sxy, szz)
