"""What must be seen wherever a row is used: its own doubts, and how far its constants miss what is stated beside them."""

import math
from functools import cache
from typing import NamedTuple

from hugoniot.laws.eos.jwl_isentrope import JWLIsentrope
from hugoniot.materials.cards import REST_TEMPERATURE
from hugoniot.materials.schema import Row
from hugoniot.materials.schema import row as row_of

VELOCITY_LIMIT = 0.005  # relative misfit of the CJ velocity a JWL set may have without a mark
PRESSURE_LIMIT = 0.02  # and of the CJ pressure
REST_LIMIT = 5e6  # Pa at V = 1 and 298 K by the constants of an unreacted explosive, about 0.03 % of its bulk modulus
ENERGY_LIMIT = 0.005  # E0 stated against E0 from the tangency of the principal isentrope
SCATTER_LIMIT = 0.04  # root mean square of Us of the measured states about a row's line, of its value in the middle of their range


LINE = ("c0", "s", "s2", "s3")      # constants of a Us-up fit, to which the states measure it


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
            parts.append(f"a detonation velocity of {self.velocity:.0f} m/s, {_beside(self.velocity_misfit)}")
        if not math.isnan(self.pressure_misfit):
            parts.append(f"a CJ pressure of {self.pressure / 1e9:.1f} GPa, {_beside(self.pressure_misfit)}")
        return ", and ".join(parts)


def misfits(row: Row, velocity: float, pressure: float) -> Closure:
    """How far a CJ state (m/s, Pa) of a products row of the table jwl is from what the row states."""
    return Closure(velocity, pressure, _misfit(velocity, row.get("detonation_velocity")), _misfit(pressure, row.get("cj_pressure")))


def recorded_closure(row: Row) -> Closure | None:
    """The same of the CJ state recorded in the row; None where it gives no energy to close with. `dossier.checks` recomputes it."""
    return misfits(row, row["recorded_d"], row["recorded_p"]) if "recorded_d" in row else None


def _beside(misfit: float) -> str:
    return f"{abs(100 * misfit):.1f} % {'above' if misfit > 0.0 else 'below'} the stated value"


def _misfit(found: float, stated: float | None) -> float:
    return math.nan if stated is None else found / stated - 1.0


@cache
def unreacted_pressure(identity: str) -> float:
    """Pressure of an unreacted JWL row at V = 1 and 298 K, Pa: on the isentrope of the calibration's p(V, T) through that state."""
    row = row_of(identity)
    prefix, heat = ("unreacted_", "unreacted_heat_capacity") if row.table == "ignition_growth" else ("", "heat_capacity_volume")
    a, b, r1, r2, omega = (row[f"{prefix}{n}"] for n in ("a", "b", "r1", "r2", "omega"))
    return float(JWLIsentrope(((a, r1), (b, r2)), omega * row[heat] * REST_TEMPERATURE, omega).pressure(1.0))


def marks(row: Row, constant: str = "") -> tuple[str, ...]:
    """Sentences to show wherever the row is used, or one `constant` of it ("gamma0") alone; empty for a row without blemish."""
    found = list(row.marks_of(constant))
    of_line = constant in ("", *LINE) and "states" in row
    if of_line and row["us_deviation"] > SCATTER_LIMIT * (row["c0"] + row["s"] * 0.5 * (row["up_min"] + row["up_max"])):
        found.append(f"{row.title} misses the measured states: its shock velocities deviate by {row['us_deviation']:.0f} m/s "
                     f"(root mean square) from the {row['states']:g} states that the library compares it with (particle "
                     f"velocities from {row['up_min']:g} to {row['up_max']:g} m/s)")
    if row.table == "jwl" and row["role"] == "products":
        state = recorded_closure(row)
        if state is not None and not state.closes:
            found.append(f"{row.title} does not reproduce its stated CJ state: its constants give {state.misfit()}")
    if (row.table == "jwl" and row["role"] == "unreacted") or (row.table == "ignition_growth" and "unreacted_a" in row):
        p = unreacted_pressure(row.id)
        if abs(p) > REST_LIMIT:
            found.append(f"{row.title} does not give zero pressure at the reference density: its published constants give {p / 1e6:.1f} "
                         "MPa at V = 1 and 298 K; the law shifts the reference energy so that the pressure is zero")
    return tuple(found)
