r"""Fits: shock velocity against particle velocity with error bars, JWL from a CJ state and an expansion curve, Jordan's adjusted Gamma.

**Us-up.** A least-squares fit of $U_s = \sum_k a_k u_p^k$, linear or quadratic, with the covariance of the coefficients $a_k$ and the
standard deviation of the points about the curve. Beyond the highest measured $u_p$ the fit extrapolates.

**JWL.** On the isentrope through the CJ point, with the relative volume $V = v/v_0$,

$$p = A e^{-R_1V} + B e^{-R_2V} + C V^{-1-\omega}$$

For any exponents $R_1$, $R_2$, $\omega$ the coefficients $A$, $B$, $C$ follow from three linear equations: the CJ pressure, the tangency
$-dp/dV = p/(1-V)$ and the energy $E(V_{CJ}) = E_0 + p(1-V)/2$ with the detonation energy $E_0$ per volume of explosive. Every trial thus
reproduces the CJ state exactly, and only the exponents are fitted to the logarithm of the pressures of the expansion curve.

**Adjusted Grüneisen parameter.** Jordan's truncated cubic equation of state satisfies the jump conditions of a shock state only with an
adjusted Grüneisen parameter (Jordan eq. 7.1.31, missing from our copy and derived for this project); see `adjusted_gamma`.

Source: KB codes manual, section 3, for Us-up; Lee, Hornig and Kury, UCRL-50422, for the form of the JWL; Jordan (2011), section 7.1.
"""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from hugoniot.errors import DeckError, FileTrouble, NoSolution, OutOfRange
from hugoniot.files import csv_rows, read_text
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.jwl_isentrope import JWLIsentrope, exponential, power
from hugoniot.units import UnitError, parse


@dataclass(frozen=True)
class UsUpFit:
    """A fitted Us-up relation.

    coefficients    a_k in SI, constant first
    covariance      covariance matrix of the coefficients
    deviation       standard deviation of the points about the curve, m/s
    least, highest  range of the measured particle velocities, m/s
    points          the fitted points (up, us)
    """

    coefficients: tuple[float, ...]
    covariance: np.ndarray
    deviation: float
    least: float
    highest: float
    points: np.ndarray

    @property
    def deviations(self) -> tuple[float, ...]:
        """One standard deviation of each coefficient."""
        return tuple(float(v) for v in np.sqrt(np.diag(self.covariance)))

    def __call__(self, up):
        """Us at particle velocities, m/s."""
        return np.polynomial.polynomial.polyval(up, self.coefficients)

    def band(self, up):
        """One standard deviation of the fitted curve at particle velocities, m/s."""
        x = np.vander(np.atleast_1d(np.asarray(up, float)), len(self.coefficients), increasing=True)
        sigma = np.sqrt(np.maximum(np.einsum("ij,jk,ik->i", x, self.covariance, x), 0.0))
        return sigma if np.ndim(up) else float(sigma[0])

    def table(self) -> dict:
        """SI numbers by name, for JSON."""
        names = ("c0", "s", "s2")[: len(self.coefficients)]
        return {**dict(zip(names, self.coefficients)), **{f"{n}_deviation": d for n, d in zip(names, self.deviations)},
                "standard_deviation": self.deviation, "least_particle_velocity": self.least, "highest_particle_velocity": self.highest,
                "points": len(self.points), "covariance": self.covariance.tolist()}


def us_up(up, us, degree: int = 1) -> UsUpFit:
    """Fit of Us(up), arrays in m/s, of degree 1 (linear) or 2 (quadratic). Raises OutOfRange for too few or unusable points."""
    up, us = np.asarray(up, float).ravel(), np.asarray(us, float).ravel()
    if degree not in (1, 2):
        raise OutOfRange(f"a Us-up fit is linear (1) or quadratic (2), not of degree {degree}")
    if up.size != us.size or not (np.isfinite(up).all() and np.isfinite(us).all()):
        raise OutOfRange("each point needs a finite particle velocity and a finite shock velocity")
    if np.unique(up).size < degree + 2:
        raise OutOfRange(f"a fit of degree {degree} with a standard deviation needs {degree + 2} different particle velocities, "
                         f"got {np.unique(up).size}")
    scale = np.max(np.abs(up))
    design = np.vander(up / scale, degree + 1, increasing=True)
    scaled, _, _, _ = np.linalg.lstsq(design, us, rcond=None)
    left = us - design @ scaled
    variance = float(left @ left) / (up.size - degree - 1)
    powers = scale ** -np.arange(degree + 1.0)
    covariance = variance * np.linalg.inv(design.T @ design) * np.outer(powers, powers)
    return UsUpFit(tuple((scaled * powers).tolist()), covariance, float(np.sqrt(variance)), float(up.min()), float(up.max()),
                   np.column_stack([up, us]))


# column -> (SI unit, how a header may spell it; the last one is what a message proposes)
_US_UP = {"particle_velocity": ("m/s", ("particle_velocity", "particlevelocity", "up")),
          "shock_velocity": ("m/s", ("shock_velocity", "shockvelocity", "us"))}
_EXPANSION = {"volume": ("1", ("relative_volume", "v/v0", "v", "volume")), "pressure": ("Pa", ("p", "pressure"))}
_UNIT = re.compile(r"^(.*?)[\s_]*(?:[\(\[](.+)[\)\]]|(km_s|m_s|km/s|m/s|mm/us|GPa|MPa|kbar|Mbar))?$", re.IGNORECASE)


def read_points(path) -> tuple[np.ndarray, np.ndarray]:
    """Particle and shock velocities, m/s, from a CSV file with the columns particle_velocity (or up) and shock_velocity (or us).

    A unit may follow a name, as in up (km/s) or up_km_s; without one the numbers are in m/s. Lines that begin with # are skipped. Raises
    DeckError with the line and a remedy.
    """
    up, us = read_columns(path, _US_UP, "particle and shock velocities")
    return up, us


def read_expansion(path) -> tuple[np.ndarray, np.ndarray]:
    """Relative volumes V = v/v0 and pressures (Pa) of an expansion isentrope from a CSV file with the columns volume and pressure, in
    the format described under `read_points`; a pressure without a unit is in Pa."""
    volumes, pressures = read_columns(path, _EXPANSION, "relative volumes and pressures")
    return volumes, pressures


def read_columns(path, columns: dict, what: str) -> tuple[np.ndarray, ...]:
    """The named columns of a CSV file in SI, in the order of `columns`; DeckError with line and remedy, FileTrouble for no file."""
    path = Path(path)
    example = ", ".join(f"{words[-1]} ({_SAMPLE[unit]})" if unit != "1" else words[-1] for unit, words in columns.values())
    try:
        lines = read_text(path).splitlines()
    except OSError as error:
        raise FileTrouble(f"cannot read {path}: {error.strerror or error}; give a CSV file of {what}") from None
    except UnicodeDecodeError:
        raise DeckError.single(path, None, "points", "not a UTF-8 text file", f"give a CSV file of {what}") from None
    numbered = [(n, line) for n, line in enumerate(lines, 1) if line.strip() and not line.lstrip().startswith("#")]
    if not numbered:
        raise DeckError.single(path, None, "points", "the file is empty", f"the first line names the columns, such as {example}")
    head_line, head = numbered[0][0], csv_rows(numbered[0][1], path, numbered[0][0])[0][1]
    where = {name: _column(path, head_line, head, name, *columns[name]) for name in columns}
    rows = []
    for n, line in numbered[1:]:
        cells = csv_rows(line, path, n)[0][1]
        rows.append([_number(path, n, name, cells, *where[name]) for name in columns])
    if not rows:
        raise DeckError.single(path, head_line, "points", "there are no points below the header", f"give {what}, one point per line")
    return tuple(np.array(rows).T)


_SAMPLE = {"m/s": "km/s", "Pa": "GPa"}
_KIND = {"m/s": "velocity", "Pa": "pressure", "1": "relative volume"}


def _column(path, line, head, name, unit, words):
    """(index, factor to SI, unit) of a column."""
    for i, text in enumerate(head):
        match = _UNIT.match(text.strip())
        written = match.group(2) or (match.group(3) or unit).replace("_", "/")
        if match.group(1).strip().lower().replace(" ", "_") in words:
            try:
                return i, _factor(written, unit), unit
            except UnitError as error:
                raise DeckError.single(path, line, name, error.message, error.hint) from None
    sample = f"'{words[-1]} [{_SAMPLE[unit]}]'" if unit in _SAMPLE else f"'{words[-1]}'"
    shown = ", ".join(head)
    raise DeckError.single(path, line, name, f"there is no such column; the columns are {shown[:200]}{'...' if len(shown) > 200 else ''}",
                           f"give the column the header {sample}")


def _factor(written: str, unit: str) -> float:
    """SI value of one unit as a header writes it, capitals or not."""
    if written == "1":
        return 1.0
    try:
        return parse(f"1 {written}", unit)
    except UnitError:
        if written.lower() == written:
            raise
    try:
        return parse(f"1 {written.lower()}", unit)
    except UnitError:
        return parse(f"1 {written}", unit)  # the message about what was written


def _number(path, line, name, cells, index, factor, unit):
    if index >= len(cells):
        raise DeckError.single(path, line, name, f"the line has only {len(cells)} value{'' if len(cells) == 1 else 's'}, but this is "
                                                 f"column {index + 1}", "add the missing values")
    try:
        value = float(cells[index]) * factor
    except ValueError:
        value = np.nan
    if not np.isfinite(value) or value < 0.0:
        raise DeckError.single(path, line, name, f"'{cells[index].strip()[:40]}' is not a {_KIND[unit]}", "give a positive number or zero")
    return value


# -- JWL ---------------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class JwlFit:
    """A fitted JWL equation of state.

    par         its parameters
    c           coefficient C of its principal isentrope, Pa
    deviation   root mean square deviation of ln p from the curve
    count       number of fitted points
    at_bounds   exponents that ended at a bound of the search
    """

    par: JWL
    c: float
    deviation: float
    count: int
    at_bounds: tuple[str, ...] = ()

    @property
    def isentrope(self) -> JWLIsentrope:
        """The principal isentrope of the fit; its method `pressure(V)` gives the pressure, Pa, at relative volumes."""
        return JWLIsentrope.of(self.par, self.c)


def jwl_coefficients(rho0, velocity, pressure, energy, r1, r2, omega) -> tuple[float, float, float]:
    """A, B, C (Pa) of a JWL isentrope that reproduces a CJ state with given exponents.

    rho0            reference density of the explosive, kg/m3
    velocity        detonation velocity, m/s
    pressure        CJ pressure, Pa
    energy          detonation energy E0, J per m3 of explosive
    r1, r2, omega   exponents
    """
    v = 1.0 - pressure / (rho0 * velocity**2)
    matrix = np.column_stack([exponential(v, r1), exponential(v, r2), power(v, omega)])
    sides = np.array([pressure, rho0 * velocity**2, energy + 0.5 * pressure * (1.0 - v)])
    a, b, c = np.linalg.solve(matrix, sides)
    return float(a), float(b), float(c)


def fit_jwl(rho0: float, velocity: float, pressure: float, energy: float, volumes, pressures, *, omega: float | None = None,
            start=(4.5, 1.2, 0.35)) -> JwlFit:
    """JWL from a CJ state and points of the expansion isentrope below it.

    rho0, velocity, pressure, energy   as in `jwl_coefficients`
    volumes, pressures                 relative volumes above the CJ volume, and the pressures there (Pa)
    omega                              fixed value; None: omega is fitted too
    start                              R1, R2, omega at which the search begins

    Raises NoSolution if no exponents with positive A and C describe the points.
    """
    from scipy.optimize import least_squares

    volumes, target = np.asarray(volumes, float), np.log(np.asarray(pressures, float))
    free = 2 if omega is not None else 3
    if volumes.size < free + 1:
        raise OutOfRange(f"fitting {free} exponents needs at least {free + 1} points of the expansion, there are {volumes.size}")

    def parts(x):
        r1, r2 = np.exp(x[0]) + np.exp(x[1]), np.exp(x[1])
        w = omega if omega is not None else np.exp(x[2])
        return (r1, r2, w, *jwl_coefficients(rho0, velocity, pressure, energy, r1, r2, w))

    def misfit(x):
        r1, r2, w, a, b, c = parts(x)
        p = JWLIsentrope(((a, r1), (b, r2)), c, w).pressure(volumes)
        return np.where(p > 0.0, np.log(np.maximum(p, 1e-300)) - target, 50.0)

    bounds, best = np.log([[0.05, 0.05, 0.02], [20.0, 8.0, 2.0]]), None  # of R1 - R2, R2, omega
    for factor in (1.0, 0.9, 1.15):
        x0 = np.log([start[0] * factor - start[1], start[1], *([] if omega is not None else [start[2]])])
        found = least_squares(misfit, x0, bounds=(bounds[0, : len(x0)], bounds[1, : len(x0)]), xtol=1e-15, ftol=1e-15, gtol=1e-15,
                              x_scale=0.1, max_nfev=500)
        best = found if best is None or found.cost < best.cost else best
    r1, r2, w, a, b, c = parts(best.x)
    deviation = float(np.sqrt(np.mean(best.fun**2)))
    if not (a > 0.0 and c > 0.0 and deviation < 1.0):
        raise NoSolution(f"no JWL isentrope through this CJ state follows the points (best: A = {a:.4g} Pa, C = {c:.4g} Pa, "
                         f"{deviation:.3g} rms in ln p): check units and that the energy fits the CJ state")
    ended = tuple(word for word, active in zip(("R1 - R2", "R2", "omega"), _on_bounds(best.x, bounds[:, : len(best.x)])) if active)
    return JwlFit(JWL(a, b, float(r1), float(r2), float(w), rho0, energy), c, deviation, volumes.size, ended)


def _on_bounds(x, bounds):
    """Which parameters ended within a thousandth of their range of its ends."""
    low, high = bounds
    return (x - low < 1e-3 * (high - low)) | (high - x < 1e-3 * (high - low))


# -- the Gamma that makes a truncated law meet the jump ----------------------------------------------------------
def adjusted_gamma(rho0: float, c0: float, s: float, up: float, gamma: float, *, pressure: float = 101325.0) -> float:
    r"""Grüneisen parameter with which the truncated cubic equation of state of Jordan passes through a shock state.

    rho0       reference density, kg/m3
    c0, s      constants of the linear Us-up relation, c0 in m/s
    up         particle velocity of the shock state, m/s
    gamma      Grüneisen parameter from the literature
    pressure   pressure P0 ahead of the shock, Pa

    $$g = \frac{P_s - \rho_0c_0^2(x + 2sx^2 + 3s^2x^3)}{\rho_se_s - \rho_0c_0^2(x^2/2 + sx^3)}, \qquad x = u_p/U_s, \quad
      P_s = \rho_0U_su_p + P_0, \quad e_s = \frac{P_0}{\gamma\rho_0} + \frac{(P_s + P_0)x}{2\rho_0}$$

    where $g$ is the adjusted and $\gamma$ the given Grüneisen parameter; the subscript $s$ denotes the shocked state, and the factor $s$ is
    the slope of the Us-up relation. An equation of state whose reference curve is the exact Hugoniot needs no adjustment.
    """
    us, behind, density, energy = shocked_state(rho0, c0, s, up, gamma, pressure)
    x, modulus = up / us, rho0 * c0 * c0
    return (behind - modulus * (x + 2.0 * s * x**2 + 3.0 * s**2 * x**3)) / (density * energy - modulus * (0.5 * x**2 + s * x**3))


def shocked_state(rho0: float, c0: float, s: float, up: float, gamma: float, pressure: float) -> tuple[float, float, float, float]:
    """Shock velocity (m/s), pressure (Pa), density (kg/m3) and energy (J/kg) behind a shock in a linear Us-up material; arguments as in
    `adjusted_gamma`."""
    us = c0 + s * up
    x = up / us
    if not 0.0 < x < 1.0:
        end = f"; with s = {s:g} particle velocities end at c0/(1 - s) = {c0 / (1.0 - s):.6g} m/s" if up > 0.0 and s < 1.0 else ""
        raise OutOfRange(f"the particle velocity, {up:.6g} m/s, must lie between 0 and the shock velocity, {us:.6g} m/s{end}")
    behind = rho0 * us * up + pressure
    return us, behind, rho0 / (1.0 - x), pressure / (gamma * rho0) + 0.5 * (behind + pressure) * x / rho0


def truncated_pressure(rho0: float, c0: float, s: float, gamma: float, density: float, energy: float) -> float:
    """Pressure (Pa) of Jordan's truncated equation of state: the sum of the cubic cold curve and gamma rho e, at a density (kg/m3) and
    an energy (J/kg)."""
    x = 1.0 - rho0 / density
    return rho0 * c0 * c0 * (x + (2.0 * s - 0.5 * gamma) * x**2 + s * (3.0 * s - gamma) * x**3) + gamma * density * energy
