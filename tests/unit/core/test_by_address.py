"""NamedTuples of arrays that compiled code reaches by one address."""

from typing import Any, NamedTuple

import numba as nb
import numpy as np
import pytest

from hugoniot.core.by_address import ByAddress
from hugoniot.core.passes import Entry, call_entry, row_at


class Tables(NamedTuple):
    places: Any
    numbers: Any
    scale: float
    count: int
    yes: bool


def change(tables, found, which):
    tables.places[tables.numbers[1, 0], 2] += which
    found[0], found[1] = tables.scale * tables.places[1, 2], tables.count if tables.yes else 0.0


CHANGE = Entry(change)


@nb.njit
def call(function, address, found, which):
    call_entry(function, row_at(address), found, which)


def test_tables_are_read_and_written_at_their_address():
    tables = Tables(np.arange(6.0).reshape(2, 3), np.array([[0, 2], [1, 1]], dtype=np.int32), 0.5, 7, True)
    given, found = ByAddress(tables), np.zeros(2)
    call(CHANGE.address(given, found, 1), given.address, found, 4)
    assert tables.places.tolist() == [[0.0, 1.0, 2.0], [3.0, 4.0, 9.0]]
    assert found.tolist() == [4.5, 7.0]


def test_arrays_in_another_order_are_refused():
    with pytest.raises(ValueError, match="C order"):
        ByAddress(Tables(np.zeros((2, 3)).T, np.zeros(2, dtype=np.int64), 1.0, 1, False))
