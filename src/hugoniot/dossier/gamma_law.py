r"""Gamma-law gases (rho0, Q, gamma) with the Chapman-Jouguet states of the library's explosives.

A gas $p = (\gamma-1)\rho e$ that releases Q per mass of an explosive at rest detonates, without ambient pressure, at
$D^2 = 2(\gamma^2-1)Q$ and $p = \rho_0D^2/(\gamma+1)$. Solved for its two constants, with D and p of the explosive's own products:

$$\gamma = \frac{\rho_0D^2}{p} - 1, \qquad Q = \frac{D^2}{2(\gamma^2-1)}$$

Only the CJ state is that of the explosive: Q is not its heat of detonation, and the gas expands with one exponent.

Source: KB codes, equations 4.9 and 4.10 (with K-E4 corrected), whose table `explode.txt` has these columns.
"""

from typing import NamedTuple

from hugoniot.errors import DeckError, OutOfRange
from hugoniot.laws.eos.contract import EOS
from hugoniot.materials import library, schema
from hugoniot.theory.chapman_jouguet import cj


class GammaLaw(NamedTuple):
    """rho0 kg/m3, Q J/kg, gamma, derived from D m/s and p_CJ Pa of the products of the row named; marks: what is doubtful about it."""

    name: str
    title: str
    density: float
    heat: float
    gamma: float
    detonation_velocity: float
    cj_pressure: float
    row: str
    marks: tuple[str, ...]


def gamma_law(name: str) -> GammaLaw | None:
    """Of one explosive of the library; None where it has no products, or none that detonate. `DeckError` for other names."""
    entry = library.entry(name)
    products = entry.material.eos
    if "reacted" not in EOS.of(products).flags:
        return None
    try:
        point = cj(products)
    except OutOfRange:
        return None
    density, speed, pressure = point.initial.density, float(point.detonation_velocity), float(point.state.pressure)
    gamma = density * speed**2 / pressure - 1.0
    row = entry.rows[0]
    return GammaLaw(name, entry.title, density, speed**2 / (2.0 * (gamma**2 - 1.0)), gamma, speed, pressure, row, schema.row(row).marks)


def gamma_laws(everything: bool = False) -> list[GammaLaw]:
    """Of every curated explosive with a CJ state; `everything`: also of single rows."""
    found = []
    for hit in library.listings():
        if hit.category == "explosive" and (hit.curated or everything):
            try:
                found.append(gamma_law(hit.name))
            except DeckError:     # several rows, or none that is enough
                continue
    return [law for law in found if law is not None]
