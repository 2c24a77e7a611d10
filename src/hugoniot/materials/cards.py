"""A row of the library as the table of a law: which column is which parameter, and what has to be derived on the way.

Every value keeps its provenance: a card is a dictionary parameter -> Source (or text), which `materials.entry` hands to the deck's own
reader `materials.law_reader`, so that library, decks and users' files share one schema and one set of checks.
"""

from dataclasses import replace

from hugoniot.materials import static_compression
from hugoniot.materials.material import Source
from hugoniot.materials.schema import Row

ROOM_TEMPERATURE = 298.15  # K, of the tables of specific heats
REST_TEMPERATURE = 298.0  # K, at which sets of unreacted explosives are taken to have zero pressure
UNIVERSAL_GAS_CONSTANT = 8.31446261815324  # J/(mol K), exact in the SI of 2019
Card = dict[str, Source | str]

_LAW_OF_FORM = {"linear": "mie_gruneisen", "quadratic": "mie_gruneisen_quadratic", "steinberg_cubic": "mie_gruneisen_cubic"}
_PARAMETERS = {
    "linear": {"rho0": "rho0", "c0": "c0", "s": "s"},
    "quadratic": {"rho0": "rho0", "c0": "c0", "s1": "s", "s2": "quadratic"},
    "steinberg_cubic": {"rho0": "rho0", "c0": "c0", "s1": "s", "s2": "s2", "s3": "s3"},
}


def card(row: Row, family: str = "") -> Card:
    """The law table of a row: `law` and its parameters; ValueError where no law of the package takes the row as it stands.

    family   what an ignition-and-growth row is asked for: "burn" its rate, "eos" its products, else its unreacted explosive
    """
    if row.table == "ignition_growth" and family in ("burn", "eos"):
        return _rate(row) if family == "burn" else _products_of_set(row)
    makers = {"us_up": _us_up, "strength": _strength, "jwl": _jwl, "tillotson": _tillotson, "gases": _gas, "ignition_growth": _reactant,
              "compression": static_compression.card}
    if row.table not in makers:
        raise ValueError(f"row {row.id}: no law of the package can use a row of the table {row.table} directly")
    return makers[row.table](row)


def _us_up(row: Row) -> Card:
    form = row["form"]
    if form not in _LAW_OF_FORM:
        name = f"'{form}'" + (" (universal liquid Hugoniot)" if form == "ulh" else "")
        raise ValueError(f"row {row.id}: the package has no equation of state for a Hugoniot of the form {name}")
    if "rho0" not in row:
        raise ValueError(f"row {row.id} gives no density: it can be used for comparison only")
    found: Card = {"law": _LAW_OF_FORM[form]}
    for name, column in _PARAMETERS[form].items():
        found[name] = row.constant(column, name)
    found["gamma0"] = row.constant("gamma0") if "gamma0" in row else estimated_gamma(row)
    found |= _gamma_form(row)
    if "heat_capacity" in row:
        found["specific_heat"] = specific_heat(row, found["gamma0"].value, found["c0"].value)
    return found


def _gamma_form(row: Row) -> Card:
    """How Gamma varies: the sources say rho Gamma constant, Gamma constant, or Steinberg's (gamma0 + b mu)/(1 + mu)."""
    if row.get("gamma_slope"):
        return {"gamma_form": "linear", "gamma_slope": row.constant("gamma_slope")}
    if row.get("gamma_exponent") == 0.0:
        return {"gamma_form": "constant"}
    return {"gamma_form": "rho_gamma_constant"}


def estimated_gamma(row: Row) -> Source:
    """gamma0 = 2 s - 1 where the source gives none.

    Follows from a Hugoniot linear in up and the Dugdale-MacDonald relation at zero pressure; the Hugoniot itself does not depend on it.
    """
    value = max(2.0 * row["s"] - 1.0, 0.1)
    return Source("gamma0", value, "1", "estimated as 2 s - 1 (Dugdale and MacDonald), not measured", "", "derived",
                  f"row {row.id}: estimated, because the row gives no Grüneisen parameter")


def specific_heat(row: Row, gamma0: float, c0: float) -> Source:
    r"""The specific heat at constant volume; where the source tabulates c_p, $c_v = c_p/(1 + \Gamma_0^2 c_p T_0/c_0^2)$.

    An identity of thermodynamics: c_p/c_v = 1 + alpha Gamma T with alpha = Gamma c_p / c0^2.
    """
    given = row.constant("heat_capacity", "specific_heat")
    if row.table == "us_up" and row.get("heat_type") != "cp":
        return given
    value = given.value / (1.0 + gamma0 * gamma0 * given.value * ROOM_TEMPERATURE / (c0 * c0))
    note = f"row {row.id}: converted from c_p = {given.value:g} J/kg/K, tabulated for {ROOM_TEMPERATURE} K"
    note += f"; {row.note}" if row.note else ""
    return replace(given, value=value, status="derived", note=note)


def _strength(row: Row) -> Card:
    model = row["model"]
    if model == "SG":
        found: Card = {"law": "steinberg_guinan"}
        for name in ("rho0", "shear_modulus", "yield_stress", "largest_yield_stress", "hardening_coefficient", "hardening_exponent",
                     "pressure_coefficient", "temperature_coefficient", "melt_temperature", "melt_gruneisen", "melt_a", "initial_strain"):
            if name in row:
                found[name] = row.constant(name)
        return found
    if model == "JC":
        return _johnson_cook(row)
    if "yield_stress" in row and "shear_modulus" in row:
        return {"law": "perfectly_plastic", "shear_modulus": row.constant("shear_modulus"), "yield_stress": row.constant("yield_stress")}
    raise ValueError(f"row {row.id}: no strength law of the package matches a '{model}' card")


def _johnson_cook(row: Row) -> Card:
    found: Card = {"law": "johnson_cook"}
    names = {"shear_modulus": "shear_modulus", "yield_stress": "johnson_cook_yield", "hardening_coefficient": "johnson_cook_hardening",
             "hardening_exponent": "johnson_cook_exponent", "rate_coefficient": "johnson_cook_rate",
             "thermal_exponent": "johnson_cook_thermal", "room_temperature": "room_temperature", "melt_temperature": "melt_temperature",
             "reference_rate": "reference_rate"}
    for parameter, column in names.items():
        if column in row:
            found[parameter] = row.constant(column, parameter)
    if "room_temperature" not in found:
        found["room_temperature"] = Source("room_temperature", ROOM_TEMPERATURE, "K", "room temperature, assumed by hugoniot",
                                           status="derived", note=f"row {row.id}: assumed, because the row states none")
    return found


def _jwl(row: Row) -> Card:
    if row["role"] == "unreacted":
        return _unreacted(row, "", "heat_capacity_volume")
    found: Card = {"law": "jwl"}
    for name in ("a", "b", "r1", "r2", "omega", "rho0"):
        found[name] = row.constant(name)
    heat = row.get("heat_capacity_volume")
    if heat is not None:
        found["specific_heat"] = replace(row.constant("heat_capacity_volume", "specific_heat"), value=heat / row["rho0"], unit="J/kg/K")
    if "e0" in row:
        found["e0"] = row.constant("e0")
    elif "e0_from_isentrope" in row:
        note = f"row {row.id}: computed from the isentrope; the row gives its constant C, and E0 follows from CJ tangency"
        found["e0"] = replace(row.constant("e0_from_isentrope", "e0"), status="derived", note=f"{note}; {row.note}" if row.note else note)
    else:
        raise ValueError(f"row {row.id} gives no detonation energy E0")
    return found


def _reactant(row: Row) -> Card:
    """The unreacted explosive of an ignition-and-growth set."""
    if "unreacted_a" not in row:
        raise ValueError(f"row {row.id} gives no unreacted equation of state")
    return _unreacted(row, "unreacted_", "unreacted_heat_capacity")


def _unreacted(row: Row, prefix: str, heat_column: str) -> Card:
    """A calibration p(V, T) of an unreacted explosive, at rest where its pressure is zero.

    The published constants give up to 15 MPa at V = 1 and 298 K. The law takes the energy at rest from p = 0 and counts the temperature
    from there: a shift of the energy by |p|/(omega rho0), under 10 kJ/kg, and no change of the curves of pressure against volume.
    """
    found: Card = {"law": "jwl_unreacted", "rho0": row.constant("rho0")}
    for name in ("a", "b", "r1", "r2", "omega"):
        found[name] = row.constant(f"{prefix}{name}", name)
    heat = row.constant(heat_column, "specific_heat")
    found["specific_heat"] = replace(heat, value=heat.value / row["rho0"], unit="J/kg/K")
    found["reference_temperature"] = Source(
        "reference_temperature", REST_TEMPERATURE, "K", "assumed by hugoniot: the temperature at which an unreacted explosive "
        "has zero pressure at its reference density", "", "derived", f"row {row.id}: assumed, because the row states none")
    return found


def _products_of_set(row: Row) -> Card:
    """The products an ignition-and-growth set was calibrated with."""
    lacks = "equation of state" if "products_a" not in row else "" if "e0" in row else "detonation energy"
    if lacks:
        raise ValueError(f"row {row.id} gives no {lacks} of the products")
    found: Card = {"law": "jwl", "rho0": row.constant("rho0"), "e0": row.constant("e0")}
    for name in ("a", "b", "r1", "r2", "omega"):
        found[name] = row.constant(f"products_{name}", name)
    if "products_heat_capacity" in row:
        heat = row.constant("products_heat_capacity", "specific_heat")
        found["specific_heat"] = replace(heat, value=heat.value / row["rho0"], unit="J/kg/K")
    return found


def _rate(row: Row) -> Card:
    if "unreacted_a" not in row and "x" not in row:
        return {"law": "jwl_plus_plus", "g": row.constant("growth1", "g"), "b": row.constant("y", "b")}
    names = {"rho0": "rho0", "i": "ignition_rate", "b": "b", "a": "a", "x": "x", "g1": "growth1", "c": "c", "d": "d", "y": "y",
             "g2": "growth2", "e": "e", "g": "g", "z": "z", "ignition_limit": "ignition_limit", "growth_limit": "growth1_limit",
             "completion_limit": "growth2_limit"}
    given = {parameter: row.constant(column, parameter) for parameter, column in names.items() if column in row}
    return {"law": "ignition_growth", **given}


def _gas(row: Row) -> Card:
    """Ideal gas: R = R_u/M, c_v = R/(gamma - 1), density at the stated pressure and the temperature the law has at rest."""
    gas_constant = row["gas_constant"] if "gas_constant" in row else UNIVERSAL_GAS_CONSTANT / row["molar_mass"]
    given = "gas constant" if "gas_constant" in row else "molar mass"
    note = f"row {row.id}: computed from the {given}, for {row['pressure']:g} Pa and {ROOM_TEMPERATURE} K"
    derived = replace(row.constant("molar_mass"), status="derived", note=note)
    heat, rho0 = gas_constant / (row["gamma"] - 1.0), row["pressure"] / (gas_constant * ROOM_TEMPERATURE)
    return {"law": "ideal_gas", "gamma": row.constant("gamma"),
            "specific_heat": replace(derived, quantity="specific_heat", value=heat, unit="J/kg/K"),
            "rho0": replace(derived, quantity="rho0", value=rho0, unit="kg/m^3")}


def _tillotson(row: Row) -> Card:
    names = {"rho0": "rho0", "a": "a", "b": "b", "bulk_a": "bulk_a", "bulk_b": "bulk_b", "alpha": "alpha", "beta": "beta", "e0": "e0",
             "e_incipient": "e_incipient", "e_complete": "e_complete"}
    return {"law": "tillotson", **{parameter: row.constant(column, parameter) for parameter, column in names.items()}}


