r"""The isentropes of the JWL form, with any number of exponentials (two in JWL, four in JWLB).

$$p_S(V) = \sum_i A_i e^{-R_iV} + C\,V^{-(1+\omega)}, \qquad
  E_S(V) = \int_V^\infty p_S\,dV = \sum_i \frac{A_i}{R_i} e^{-R_iV} + \frac{C}{\omega} V^{-\omega}, \qquad V = v/v_0$$

Numbers or arrays of V; pressures in Pa, energies per volume of unreacted explosive, J/m3. Source: Lee, Hornig and Kury, UCRL-50422.
"""

from typing import NamedTuple

from hugoniot.core.ops import vexp


def exponential(v, r):
    """(p, -dp/dV, E) of the term exp(-R V) with coefficient 1."""
    p = vexp(-r * v)
    return p, r * p, p / r


def power(v, omega):
    """(p, -dp/dV, E) of the term V^-(1+omega) with coefficient 1."""
    return v ** (-1.0 - omega), (1.0 + omega) * v ** (-2.0 - omega), v ** -omega / omega


class JWLIsentrope(NamedTuple):
    """terms: (A_i, R_i) of each exponential, Pa and 1; c in Pa; omega."""

    terms: tuple[tuple[float, float], ...]
    c: float
    omega: float

    @classmethod
    def of(cls, par, c: float) -> "JWLIsentrope":
        """The isentrope with the last coefficient `c` (Pa) of a law with two exponentials, such as `jwl`."""
        return cls(((par.a, par.r1), (par.b, par.r2)), c, par.omega)

    def parts(self, v):
        """The pressure of each term, the exponentials in order and the power last."""
        return [a * exponential(v, r)[0] for a, r in self.terms] + [self.c * power(v, self.omega)[0]]

    def pressure(self, v):
        """Pa."""
        return sum(self.parts(v))

    def steepness(self, v):
        """-dp/dV, Pa."""
        return sum(a * exponential(v, r)[1] for a, r in self.terms) + self.c * power(v, self.omega)[1]

    def energy(self, v):
        """J/m3, zero where the gas has expanded without limit."""
        return sum(a * exponential(v, r)[2] for a, r in self.terms) + self.c * power(v, self.omega)[2]
