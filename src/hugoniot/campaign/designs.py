"""Which cases a sweep has: every combination (grid), samples of the ranges (sobol, lhs), samples made for sensitivity indices (saltelli,
morris) or the rows of a table.

A design says what share of each variable's range a case has; seeds are kept, so the same design comes again. Source of the samples:
`scipy.stats.qmc` (I. M. Sobol', USSR Comput. Math. Math. Phys. 7 (1967) 86; M. D. McKay, R. J. Beckman, W. J. Conover,
Technometrics 21 (1979) 239).
"""

import math
import pathlib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from hugoniot.campaign.variables import Variable, of_column, refuse
from hugoniot.errors import DeckError, FileTrouble
from hugoniot.files import csv_rows, read_text

KINDS = ("grid", "sobol", "lhs", "saltelli", "morris")
MOST = 1_000_000     # cases of one sweep


@dataclass(frozen=True)
class Design:
    """The cases of a sweep.

    kind        "grid", "sobol", "lhs", "saltelli", "morris", "table" or "shares"
    variables   in the order of the columns
    shape       of a grid: how many values each variable has
    shares      (ncase, nvariable) of the others: where in its range each variable is
    """

    kind: str
    variables: tuple[Variable, ...]
    shape: tuple[int, ...] = ()
    shares: np.ndarray | None = None
    seed: int = 0

    def __len__(self) -> int:
        if self.kind == "grid":
            return math.prod(self.shape)
        return len(self.variables[0].values) if self.shares is None else len(self.shares)

    def values(self, case: int) -> list[Any]:
        """What each variable is in a case, as the deck is given it."""
        if self.kind == "morris":
            return [variable.across(float(share)) for variable, share in zip(self.variables, self.shares[case])]
        if self.shares is not None:
            return [variable.at(float(share)) for variable, share in zip(self.variables, self.shares[case])]
        if self.kind == "table":
            return [variable.values[case] for variable in self.variables]
        places = np.unravel_index(case, self.shape)
        return [variable.step(int(k)) for variable, k in zip(self.variables, places)]


def design_of(variables: Sequence[Variable], kind: str = "grid", samples: int | None = None, seed: int = 0) -> Design:
    """The design that is asked for.

    kind      one of KINDS, or the path of a table of cases (.csv), which has the variables as its columns
    samples   how many cases a sample has; n of the n (d + 2) cases of saltelli and the n (d + 1) of morris
    Raises `DeckError`, and `FileTrouble` for a table that cannot be read.
    """
    if kind.lower().endswith(".csv"):
        if variables:
            raise refuse("--vary", variables[0].name, "a table of cases already states what varies", "give either --vary or a table")
        if samples is not None or seed:
            raise refuse("--seed" if seed else "--samples", str(seed or samples), "a table of cases is taken as it is", "leave it out")
        return _table(kind)
    if kind not in KINDS:
        raise refuse("--design", kind, "unknown design", f"known: {', '.join(KINDS)}, or a table of cases such as cases.csv")
    if not variables:
        raise refuse("--vary", "", "nothing is varied", 'write --vary "region.flyer.velocity = 300..1200 m/s : 10"')
    twice = [v.name for k, v in enumerate(variables) if v.name in [w.name for w in variables[:k]]]
    if twice:
        raise refuse("--vary", twice[0], "varied twice", "name each key once")
    if kind == "grid" and seed:
        raise refuse("--seed", str(seed), "nothing in a grid is random", "leave it out, or take a sample with --design sobol")
    return _grid(variables, samples) if kind == "grid" else _sampled(variables, kind, samples, seed)


def _grid(variables: Sequence[Variable], samples: int | None) -> Design:
    if samples is not None:
        raise refuse("--samples", str(samples), "the number of cases of a grid follows from its values", "leave it out, or take a sample "
                                                                                                         "with --design sobol")
    for variable in variables:
        if variable.kind == "normal":
            raise refuse("--vary", variable.name, "a grid cannot contain a normal distribution", "take a sample with --design sobol or lhs")
        if variable.kind != "values" and variable.count is None:
            raise refuse("--vary", variable.name, "a grid needs the number of values in a range", "add it after the range, such as ': 10'")
    shape = tuple(len(v.values) if v.kind == "values" else v.count or 0 for v in variables)
    _few_enough(math.prod(shape), " x ".join(map(str, shape)) if len(shape) > 1 else "")
    return Design("grid", tuple(variables), shape)


def _few_enough(count: int, how: str = "") -> None:
    if count > MOST:
        counted = f"{count:,}".replace(",", " ")
        raise refuse("--vary", "", f"{counted} cases" + (f" ({how})" if how else "") + " are too many",
                     f"the limit is {MOST:,}".replace(",", " ") + "; use fewer values, or a sample (--design sobol --samples 1024)")


def _sampled(variables: Sequence[Variable], kind: str, samples: int | None, seed: int) -> Design:
    if samples is None:
        raise refuse("--samples", "", f"the design '{kind}' needs a number of {'base ' if kind in ('saltelli', 'morris') else ''}cases",
                     "write --samples 256")
    if samples < 1:
        raise refuse("--samples", str(samples), "not a valid number of cases", "give 1 or more")
    each = {"saltelli": len(variables) + 2, "morris": len(variables) + 1}.get(kind, 1)
    _few_enough(samples * each, f"{samples} x {each}" if each > 1 else "")
    from scipy.stats import qmc

    if kind in ("sobol", "saltelli") and samples & (samples - 1):
        raise refuse("--samples", str(samples), "a Sobol' sequence is balanced only if the number of points is a power of two",
                     f"use {1 << (samples.bit_length() - 1)} or {1 << samples.bit_length()}"
                     + (", or --design lhs" if kind == "sobol" else ""))
    if kind in ("saltelli", "morris"):
        from hugoniot.campaign.sensitivity import morris_shares, saltelli_shares

        make = saltelli_shares if kind == "saltelli" else morris_shares
        return Design(kind, tuple(variables), shares=make(len(variables), samples, seed), seed=seed)
    engine = qmc.Sobol(len(variables), seed=seed) if kind == "sobol" else qmc.LatinHypercube(len(variables), seed=seed)
    return Design(kind, tuple(variables), shares=np.asarray(engine.random(samples)), seed=seed)


def _table(path: str) -> Design:
    try:
        text = read_text(path)
    except FileTrouble:
        raise
    except OSError as error:
        raise FileTrouble(f"cannot read {path}: {error.strerror or error}") from None
    except UnicodeDecodeError:
        raise DeckError.single(path, None, "table", "not a UTF-8 text file", "a table of cases is comma-separated text") from None
    name = pathlib.Path(path).name
    rows = csv_rows(text, name)
    if len(rows) < 2:
        raise DeckError.single(name, 1, "table", "needs a line of column headers and a line for each case",
                               "write a header such as: region.flyer.velocity [m/s]")
    heads = rows[0][1]
    for n, row in rows[1:]:
        if len(row) != len(heads):
            raise DeckError.single(name, n, "row", f"values: {len(row)}, column headers: {len(heads)}",
                                   "give one value for each column")
    _few_enough(len(rows) - 1)
    columns = [[row[k] for _, row in rows[1:]] for k in range(len(heads))]
    return Design("table", tuple(of_column(head, cells, f"{name}: column") for head, cells in zip(heads, columns)))
