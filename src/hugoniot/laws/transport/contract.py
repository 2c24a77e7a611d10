r"""What transport laws must provide, and how a fluid's viscosity and heat conduction are combined.

    viscosity(rho, T, par)                shear viscosity mu, Pa s                        (family `transport`)
    conductivity(rho, T, mu, cp, par)     thermal conductivity k, W/(m K)                    (family `conduction`)

rho kg/m3, T K, cp the isobaric specific heat J/(kg K). A fluid carries one of each in a `Transport` tuple, with a bulk viscosity

$$\zeta = r_b\,\mu + \zeta_0, \qquad \tau_{xx} = \left(\tfrac43\mu + \zeta\right)u_x, \qquad q = -k\,T_x .$$

The 4/3 is the longitudinal factor of the shear viscosity, not a ratio of bulk to shear viscosity (J-E13).
Laws flagged "needs_temperature" use T; the others work with equations of state that have none.
"""

from typing import Any, NamedTuple

from hugoniot.core.registry import Registry
from hugoniot.errors import OutOfRange

TRANSPORT = Registry("transport", contract=("viscosity",))
CONDUCTION = Registry("conduction", contract=("conductivity",))


class Transport(NamedTuple):
    """Transport of one fluid: `shear` a law of TRANSPORT, `conduction` a law of CONDUCTION, zeta = bulk_ratio mu + bulk_viscosity."""

    shear: Any
    conduction: Any
    bulk_ratio: float = 0.0
    bulk_viscosity: float = 0.0


def viscosity(rho, T, par):
    """Shear viscosity, Pa s."""
    return TRANSPORT.of(par).functions["viscosity"](rho, T, par)


def conductivity(rho, T, mu, cp, par):
    """Thermal conductivity, W/(m K)."""
    return CONDUCTION.of(par).functions["conductivity"](rho, T, mu, cp, par)


GENERICS = {"viscosity": viscosity}
CONDUCTION_GENERICS = {"conductivity": conductivity}


def longitudinal_viscosity(mu, transport):
    """4/3 mu + zeta, Pa s, from the shear viscosity mu."""
    return (4.0 / 3.0 + transport.bulk_ratio) * mu + transport.bulk_viscosity


def isobaric_heat(rho, c2, p_rho, p_e, T_v, T_e):
    r"""c_p, J/(kg K), from a law's own pressure and temperature, whether or not they follow from one potential.

    $$c_p = \left(\frac{\partial h}{\partial T}\right)_p = \frac{\rho^2 c^2}{\rho^2 p_\rho\,T_e + p_e\,T_v}, \qquad
      T_v = \left(\frac{\partial T}{\partial v}\right)_e, \quad T_e = \left(\frac{\partial T}{\partial e}\right)_v,$$

    with c2 the squared sound speed. Where $T_e = 1/c_v$ and $T_v = p T_e - T p_e$, as in every law with an entropy, it is the textbook's
    $c_v c^2/(c^2 - \Gamma^2 c_v T)$ (Landau and Lifshitz, Statistical Physics, section 16); porous and tabulated laws need the longer form.
    """
    return rho * rho * c2 / (rho * rho * p_rho * T_e + p_e * T_v)


# -- at the surface ----------------------------------------------------------------------------------------------
def conducts(transport) -> bool:
    """Whether heat conduction acts at all."""
    return CONDUCTION.of(transport.conduction).name != "none"


def needs_temperature(transport) -> bool:
    """Whether the equation of state must give a temperature."""
    return conducts(transport) or "needs_temperature" in TRANSPORT.of(transport.shear).flags


def make(shear, conduction=None, bulk_ratio: float = 0.0, bulk_viscosity: float = 0.0) -> Transport:
    """A checked `Transport`.

    shear, conduction   parameter tuples, or tables {"law": name, parameter: value (SI)}; conduction None: no heat conduction
    Raises `OutOfRange` for a fluid without viscosity or with a negative or vanishing number where none can be.
    """
    shear = _law(TRANSPORT, shear)
    conduction = _law(CONDUCTION, {"law": "none"} if conduction is None else conduction)
    if bulk_ratio < 0.0 or bulk_viscosity < 0.0:
        raise OutOfRange("transport: the bulk viscosity must not be negative; omit it for a fluid that has none")
    return Transport(shear, conduction, float(bulk_ratio), float(bulk_viscosity))


def _law(family: Registry, given):
    if not isinstance(given, dict):
        par = given
        law = family.of(par)
    else:
        table = dict(given)
        law = family.get(table.pop("law"))
        unknown = [name for name in table if name not in law.units]
        missing = [name for name in law.units if name not in table and name not in law.defaults]
        if unknown or missing:
            what = f"has no parameter {', '.join(unknown)}" if unknown else f"needs {', '.join(missing)}"
            raise OutOfRange(f"{family.family} law '{law.name}' {what}; its parameters are {', '.join(law.units) or 'none'}")
        par = law.build(**{**law.defaults, **{name: float(value) for name, value in table.items()}})
    for name, value in zip(par._fields, par):
        if name not in ("exponent", "sutherland_temperature") and not 0.0 < value < float("inf"):
            unit = law.units[name]
            raise OutOfRange(f"{family.family} law '{law.name}': {name} must be a positive number, got {value:g}"
                             + (f" {unit}; " if unit != "1" else "; ")
                             + ("leave conduction out (law 'none') for a fluid that does not conduct" if family is CONDUCTION
                                else "a shock without viscosity has no structure"))
    return par
