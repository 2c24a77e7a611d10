"""Passes that only copy numbers between rows."""

from hugoniot.core.ops import fmax
from hugoniot.core.passes import rows_apart, zone_pass

STRETCH = 32      # zones


@zone_pass("row")
def fill_pass(count, z, dt, numbers, law):
    """The pass's first number in every zone."""
    rows_apart()
    for j in range(count):
        z.row[j] = numbers[0]


@zone_pass("row to")
def copy_pass(count, z, dt, numbers, law):
    """A row into another."""
    rows_apart()
    for j in range(count):
        z.to[j] = z.row[j]


@zone_pass("more to")
def add_pass(count, z, dt, numbers, law):
    """A row added to another."""
    rows_apart()
    for j in range(count):
        z.to[j] += z.more[j]


@zone_pass("more to")
def add_some_pass(count, z, dt, numbers, law):
    """A row that is mostly zero added to another: where it is zero for a stretch of zones the other one is not looked at."""
    rows_apart()
    first = 0
    while first < count:
        end, most = min(first + STRETCH, count), 0.0
        for j in range(first, end):
            most = fmax(most, fmax(z.more[j], -z.more[j]))
        if most > 0.0:
            for j in range(first, end):
                z.to[j] += z.more[j]
        first = end
