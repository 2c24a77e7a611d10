r"""A row of static compression as the table of a Mie-Grüneisen law: isothermal constants turned into those of the isentrope.

Tables of minerals and salts give the bulk modulus K_T at constant temperature; the laws `birch_murnaghan` and `vinet` take their curve as
the isentrope through the rest state. With the volume expansivity alpha and the specific heat c_v at the temperature T0 of rest

$$K_S = K_T(1 + \alpha\Gamma T_0), \qquad \alpha = \frac{\rho_0\Gamma c_v}{K_T}, \qquad c_p = c_v(1 + \alpha\Gamma T_0)$$

(identities of thermodynamics). A source states either Gamma and the Debye temperature, from which $c_v = 3nRD(\theta/T_0)/M$, or alpha and
c_p, from which Gamma follows. K' is taken over as it is: the isentropic one differs from it by some hundredths.
"""

import math
from dataclasses import replace

from hugoniot.materials.material import Source
from hugoniot.materials.schema import Row

REST = 298.15  # K, of the tables (some say 300 K: less than 0.02 % of the modulus)
GAS_CONSTANT = 8.31446261815324  # J/(mol K), exact in the SI of 2019


def card(row: Row) -> dict[str, Source | str]:
    """The law table of a row of `compression`: its form, density, isentropic bulk modulus, slope, Gamma and specific heat."""
    gamma, heat = _gamma_and_heat(row)
    found: dict[str, Source | str] = {"law": row["form"], "rho0": row.constant("rho0"), "bulk_modulus": _isentropic(row, gamma, heat),
                                      "bulk_modulus_slope": row.constant("bulk_modulus_slope"), "gamma0": gamma}
    if heat is not None:
        found["specific_heat"] = heat
    return found


def debye(x: float, intervals: int = 200) -> float:
    """Debye's function of the specific heat, 3/x^3 times the integral of y^4 e^y/(e^y - 1)^2 from 0 to x (Simpson); 1 at x = 0."""
    if x < 1e-6:
        return 1.0
    h = x / intervals
    total = 0.0
    for k in range(1, intervals + 1):
        weight = 1.0 if k == intervals else (4.0 if k % 2 else 2.0)
        y = k * h
        total += weight * y**4 * math.exp(-y) / math.expm1(-y) ** 2
    return h * total / x**3  # the h/3 of Simpson's rule and the 3 of Debye's cancel


def _gamma_and_heat(row: Row) -> tuple[Source, Source | None]:
    """Gamma and c_v, as far as the row determines them."""
    if "debye_temperature" in row:
        value = 3.0 * row["atoms"] * GAS_CONSTANT / row["molar_mass"] * debye(row["debye_temperature"] / REST)
        note = f"row {row.id}: computed from the Debye temperature, for {REST} K"
        return row.constant("gamma0"), _derived(row, "debye_temperature", "specific_heat", value, "J/kg/K", note)
    if "expansivity" in row:
        isobaric = row["expansivity"] * row["bulk_modulus"] / (row["rho0"] * row["heat_capacity"])  # Gamma c_v/c_p
        value = isobaric / (1.0 - isobaric * row["expansivity"] * REST)
        heat = row["heat_capacity"] / (1.0 + row["expansivity"] * value * REST)
        note = f"row {row.id}: computed from expansivity and c_p, with the bulk modulus and the density, for {REST} K"
        gamma = _derived(row, "expansivity", "gamma0", value, "1", note)
        return gamma, _derived(row, "heat_capacity", "specific_heat", heat, "J/kg/K", note)
    value = max(0.5 * (row["bulk_modulus_slope"] - 1.0), 0.1)
    note = f"row {row.id}: estimated as (K' - 1)/2 (Dugdale and MacDonald), because the row gives no Grüneisen parameter"
    gamma = _derived(row, "bulk_modulus_slope", "gamma0", value, "1", note)
    if "heat_capacity" not in row:
        return gamma, None
    cp = row["heat_capacity"]
    cv = 2.0 * cp / (1.0 + math.sqrt(1.0 + 4.0 * value * value * row["rho0"] * cp * REST / row["bulk_modulus"]))
    return gamma, _derived(row, "heat_capacity", "specific_heat", cv, "J/kg/K", f"row {row.id}: converted from c_p = {cp:g} J/kg/K")


def _isentropic(row: Row, gamma: Source, heat: Source | None) -> Source:
    """K_S = K_T + Gamma^2 rho0 c_v T0."""
    if heat is None:
        note = f"row {row.id}: isothermal, used for the isentrope, no specific heat being given"
        return replace(row.constant("bulk_modulus"), note=f"{note}; {row.note}" if row.note else note)
    value = row["bulk_modulus"] + gamma.value**2 * row["rho0"] * heat.value * REST
    note = f"row {row.id}: converted from the isothermal {row['bulk_modulus'] / 1e9:g} GPa"
    return _derived(row, "bulk_modulus", "bulk_modulus", value, "Pa", note)


def reach(row: Row) -> dict | None:
    r"""The particle velocity of a shock to the highest pressure the compression was measured to, as a sourced value; None if not stated.

    On $U_s = c_0 + su_p$ with $c_0^2 = K/\rho_0$ and $s = (K' + 1)/4$, the line both curves touch at rest.
    """
    if "p_max" not in row:
        return None
    speed, slope = math.sqrt(row["bulk_modulus"] / row["rho0"]), 0.25 * (row["bulk_modulus_slope"] + 1.0)
    up = (math.sqrt(speed * speed + 4.0 * slope * row["p_max"] / row["rho0"]) - speed) / (2.0 * slope)
    note = f"row {row.id}: particle velocity of a shock to {row['p_max'] / 1e9:g} GPa, the highest pressure of the static data"
    return {"value": round(up, 1), "source": row.source, "via": row.via, "status": "derived", "note": note}


def _derived(row: Row, column: str, quantity: str, value: float, unit: str, note: str) -> Source:
    note = f"{note}; {row.note}" if row.note else note
    return replace(row.constant(column, quantity), value=value, unit=unit, status="derived", note=note)
