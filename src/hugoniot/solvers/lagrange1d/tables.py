"""The zone table in memory: rows that a sweep can read and write at full speed.

A sweep streams some twenty rows at once. Rows start on a cache line, so that no packed load straddles two lines. They are spaced so
that the same zone of two rows does not have the same offset in a memory page: a processor that compares only the offset would
delay a load until an unrelated earlier store is done. Pages are touched when the table is created, because a masked packed store
to a page that is not yet mapped is many times slower than any other store.
"""

import numpy as np

LINE = 8           # numbers in a cache line
PAGE = 512         # numbers in a page
SPACING = 96       # numbers by which a row starts further into a page than the row before


def zone_table(rows: int, zones: int) -> np.ndarray:
    """Zeros of shape (rows, columns), columns >= zones; the zones are the first columns."""
    columns = zones + (SPACING - zones) % PAGE
    buffer = np.full(rows * columns + LINE, 0.0)
    start = (-buffer.ctypes.data // buffer.itemsize) % LINE
    return buffer[start:start + rows * columns].reshape(rows, columns)
