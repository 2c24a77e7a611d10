"""Where a wave converges onto the axis or centre: its highest stress is limited by the mesh alone."""

import numpy as np

FOCUS = 4             # zones at the axis or centre, in which the stress of a converging wave is limited by the mesh alone
PEAKED = 1.2          # times the value that many zones farther out: what is less is a state that is nearly uniform there


def at_focus(setup, values: np.ndarray, zone: int) -> bool:
    """Whether a zone is beside the axis or centre, and the `values` of zones fall off from it as those of a converging wave do."""
    return any(_falls_off(values[row]) for row in _rows_outward(setup, zone, len(values)))


def _falls_off(row: np.ndarray) -> bool:
    """Whether the values of 2 FOCUS or fewer zones, from one beside the axis or centre outward, fall off as those of a converging wave:
    less steeply farther out, where those of a pressed face fall off towards its rim."""
    near, far = row[0] - row[FOCUS], row[FOCUS] - row[-1]
    return bool(row[0] > PEAKED * row[FOCUS] and near * (len(row) - 1 - FOCUS) > far * FOCUS)


def _rows_outward(setup, zone: int, count: int) -> list[np.ndarray]:
    """A zone and up to 2 FOCUS more outward from the axis or centre, if it is one of the first FOCUS there and more than FOCUS follow.

    In two dimensions they are of its block; count: zones of the run.
    """
    if setup["geometry"] in ("cylindrical", "spherical") and setup["regions"][0]["start"] == 0.0:
        rows = [np.arange(count)]
    elif setup["geometry"] == "axisymmetric":
        rows, cells = [], sum(int(np.prod(block["zones"])) for block in setup["regions"])
        per, first = count // cells, 0
        for block in setup["regions"]:
            ni, nj = block["zones"]
            numbers = first + np.arange(ni * per * nj).reshape(ni, per, nj)      # of triangles the lower ones of a column, then the upper
            first += numbers.size
            for side, at in (("left", numbers), ("right", numbers[::-1]), ("bottom", numbers.T), ("top", numbers[:, :, ::-1].T)):
                if setup["boundaries"].get(f"{block['name']}.{side}", {}).get("kind") == "axis":
                    rows += list(at.reshape(len(at), -1).T)
    else:
        return []
    found = ((row, np.flatnonzero(row[:FOCUS] == zone)) for row in rows)
    return [row[int(k[0]):int(k[0]) + 2 * FOCUS + 1] for row, k in found if len(k) and len(row) > int(k[0]) + FOCUS + 1]
