"""The field of a body force in space: uniform, or a power of the radius about the axis or the centre."""

from typing import NamedTuple

from hugoniot.core.binder import only_if
from hugoniot.core.ops import vpow

AMOUNT, PER_RADIUS, EXPONENT = range(3)     # of the row `field`: acceleration now (m/s2), 1/R, n


class NoField(NamedTuple):
    """The field of a run without any terms, for which nothing of one is compiled; with other terms only it is an acceleration of 0."""

    none: int = 0


@only_if(lambda field: field is not NoField, otherwise=0.0)
def field_at(r, field):
    """Acceleration at r, m/s2; 0 on the axis and in the centre, where it has no direction."""
    if field[EXPONENT] == 0.0:
        return field[AMOUNT]
    return field[AMOUNT] * vpow(r * field[PER_RADIUS], field[EXPONENT]) if r > 0.0 else 0.0
