"""What must be seen wherever a row is used: its own doubts, and how far its constants miss what is stated beside them."""

import math
from functools import cache
from typing import NamedTuple

from hugoniot.dossier.derived import chapman_jouguet, energy_of_tangency
from hugoniot.errors import NoSolution
from hugoniot.laws.eos.jwl import JWL
from hugoniot.materials.schema import Row
from hugoniot.materials.schema import row as row_of

VELOCITY_LIMIT = 0.005  # relative misfit of the CJ velocity a JWL set may have without a mark
PRESSURE_LIMIT = 0.02  # and of the CJ pressure
REST_LIMIT = 5e6  # Pa: pressure of an unreacted explosive at rest, about 0.03 % of its bulk modulus
ENERGY_LIMIT = 0.005  # E0 stated against E0 from the tangency of the principal isentrope


class Closure(NamedTuple):
    """CJ state of a JWL set and its relative misfits (nan where the row states no velocity or pressure)."""

    velocity: float
    pressure: float
    velocity_misfit: float
    pressure_misfit: float

    @property
    def closes(self) -> bool:
        """Whether nothing stated is missed by more than the limits."""
        return not (abs(self.velocity_misfit) > VELOCITY_LIMIT or abs(self.pressure_misfit) > PRESSURE_LIMIT)

    def misfit(self) -> str:
        """The misfits in words."""
        parts = []
        if not math.isnan(self.velocity_misfit):
            parts.append(f"D from the constants is {self.velocity:.0f} m/s, {100 * self.velocity_misfit:+.1f} % from the stated")
        if not math.isnan(self.pressure_misfit):
            parts.append(f"p is {self.pressure / 1e9:.1f} GPa, {100 * self.pressure_misfit:+.1f} %")
        return "; ".join(parts)


@cache
def closure(identity: str) -> Closure | None:
    """CJ closure of a products row of the table jwl; None where the row gives no energy to close with."""
    row = row_of(identity)
    if "c" in row:
        _, velocity, p = energy_of_tangency([(row["a"], row["r1"]), (row["b"], row["r2"])], row["c"], row["omega"], row["rho0"])
    elif "e0" in row:
        state = chapman_jouguet(JWL(row["a"], row["b"], row["r1"], row["r2"], row["omega"], row["rho0"], row["e0"]))
        velocity, p = state.velocity, state.pressure
    else:
        return None
    return Closure(velocity, p, _misfit(velocity, row.get("detonation_velocity")), _misfit(p, row.get("cj_pressure")))


def _misfit(found: float, stated: float | None) -> float:
    return math.nan if stated is None else found / stated - 1.0


@cache
def unreacted_pressure(identity: str) -> float:
    """Pressure of an unreacted JWL row at V = 1 and 298 K, Pa."""
    row = row_of(identity)
    prefix, heat = ("unreacted_", "unreacted_heat_capacity") if row.table == "ignition_growth" else ("", "heat_capacity_volume")
    a, b, r1, r2, omega = (row[f"{prefix}{n}"] for n in ("a", "b", "r1", "r2", "omega"))
    return a * math.exp(-r1) + b * math.exp(-r2) + omega * row[heat] * 298.0


def marks(row: Row) -> tuple[str, ...]:
    """Sentences to show wherever the row is used; empty for a row without blemish."""
    found = list(row.marks)
    name = f"{row.id} ({row.material})"
    if row.table == "jwl" and row["role"] == "products":
        try:
            state = closure(row.id)
        except NoSolution as error:
            return (*found, f"{name}: {error}")
        if state is not None and not state.closes:
            found.append(f"{name}: DOES NOT CLOSE: {state.misfit()}")
    if (row.table == "jwl" and row["role"] == "unreacted") or (row.table == "ignition_growth" and "unreacted_a" in row):
        p = unreacted_pressure(row.id)
        if abs(p) > REST_LIMIT:
            found.append(f"{name}: NOT AT REST: {p / 1e6:.1f} MPa at V = 1 and 298 K")
    return tuple(found)
