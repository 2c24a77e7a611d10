#!/usr/bin/env python3
"""Sobol' indices of the reference flyer from a sweep's design, beside those of direct runs by two other estimators.

    python benchmarks/sobol_flyer.py                  # 6 x 1 024 runs beside 16 384 direct ones of 600 zones: ten minutes of two idle cores
    python benchmarks/sobol_flyer.py --base 64 --direct 1024 --zones 60 --out FOLDER

Of the direct runs, spread over the box by a Sobol' sequence, the first-order indices come from the variance between the means of BINS
slices of one parameter, which the scatter inside them raises by at most BINS / runs; first-order and total indices also from the squares of
the coefficients of a series of Legendre polynomials (B. Sudret, Reliab. Eng. Syst. Saf. 93 (2008) 964), whose residual bounds what it has
missed. A second run in the same FOLDER takes the answers of the first.
"""

import argparse
import csv
import itertools
import pathlib
import tempfile
import time

import numpy as np

import hugoniot
from hugoniot.units import parse, si_name

VARY = {"region.flyer.velocity": "693..707 m/s", "material.al.strength.yield_stress": "0.24..0.36 GPa",
        "material.al.eos.c0": "5.1..5.3 km/s", "material.al.eos.s": "1.4..1.6"}
RESULTS = ("2 mm into target.arrival", "2 mm into target.plateau_stress", "free surface.peak_velocity")
BINS = 32
DEGREE = 5


def sliced(x, y):
    """First-order index of one parameter, shares x of its range, from the variance between the means of slices."""
    slices = np.minimum((x * BINS).astype(int), BINS - 1)
    return np.var([y[slices == k].mean() for k in range(BINS)]) / y.var()


def by_series(x, y):
    """(first-order, total indices, part of the variance that the series misses); x (n, nparameter) shares."""
    count = x.shape[1]
    orders = [o for o in itertools.product(range(DEGREE + 1), repeat=count) if sum(o) <= DEGREE]
    one = [[np.sqrt(2 * k + 1) * np.polynomial.Legendre.basis(k)(2.0 * x[:, i] - 1.0) for k in range(DEGREE + 1)] for i in range(count)]
    terms = np.stack([np.prod([one[i][k] for i, k in enumerate(o)], axis=0) for o in orders], axis=1)
    found = np.linalg.lstsq(terms, y, rcond=None)[0]
    squares, active = found**2, np.array(orders) > 0
    variance = squares[active.any(axis=1)].sum()
    first = [squares[active[:, i] & (active.sum(axis=1) == 1)].sum() / variance for i in range(count)]
    total = [squares[active[:, i]].sum() / variance for i in range(count)]
    return first, total, np.var(y - terms @ found) / np.var(y)


def shares(table):
    """Shares of their ranges of the parameters of a sweep, (case, nparameter)."""
    columns = []
    for name, text in VARY.items():
        values = np.asarray(table[name], dtype=float)
        ends, *unit = text.split()
        low, high = (parse(f"{end} {unit[0]}", si_name(unit[0])) if unit else float(end) for end in ends.split(".."))
        columns.append((values - low) / (high - low))
    return np.stack(columns, axis=1)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--base", type=int, default=1024, help="base cases of the sweep's own design")
    parser.add_argument("--direct", type=int, default=16384, help="direct runs")
    parser.add_argument("--zones", type=int, default=600)
    parser.add_argument("--workers", type=int)
    parser.add_argument("--out", help="folder to keep")
    asked = parser.parse_args()
    folder = pathlib.Path(asked.out or tempfile.mkdtemp())
    text = (pathlib.Path(__file__).parents[1] / "examples" / "flyer.toml").read_text()
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "flyer.toml").write_text(text.replace("zones = 200", f"zones = {asked.zones // 3}")
                                           .replace("zones = 400", f"zones = {2 * asked.zones // 3}"))
    wishes = dict(output=list(RESULTS), workers=asked.workers, report=False)
    begun = time.perf_counter()
    hugoniot.sweep(folder / "flyer.toml", VARY, design="saltelli", samples=asked.base, out=folder / "saltelli", **wishes)
    rows = list(csv.DictReader((folder / "saltelli" / "sensitivity.csv").open()))
    middle = time.perf_counter()
    direct = hugoniot.sweep(folder / "flyer.toml", VARY, design="sobol", samples=asked.direct, out=folder / "direct", **wishes)
    print(f"{asked.base} x {len(VARY) + 2} runs in {middle - begun:.0f} s, {asked.direct} direct in {time.perf_counter() - middle:.0f} s")
    x, worst = shares(direct), 0.0
    for result in RESULTS:
        y = np.asarray(direct[result], dtype=float)
        sound = np.isfinite(y)
        first, total, missed = by_series(x[sound], y[sound])
        print(f"{result}: {np.mean(y[sound]):.6g}, standard deviation {np.std(y[sound]):.3g}; {int((~sound).sum())} failed; "
              f"the series misses {missed:.1e} of the variance")
        print(f"  {'':36s} {'first order':>24s} {'direct':>8s} {'series':>8s} {'total':>24s} {'series':>8s}")
        for i, row in enumerate(row for row in rows if row["result"] == result):
            of = {key: float(row[key]) for key in row if key not in ("result", "parameter")}
            print(f"  {row['parameter']:36s} {of['first']:8.4f} ({of['first_low']:6.3f}, {of['first_high']:6.3f})"
                  f" {sliced(x[sound, i], y[sound]):8.4f} {first[i]:8.4f}"
                  f" {of['total']:8.4f} ({of['total_low']:6.3f}, {of['total_high']:6.3f}) {total[i]:8.4f}")
            worst = max(worst, abs(of["first"] - first[i]), abs(of["total"] - total[i]))
    print(f"largest difference between the two routes: {worst:.4f}")


if __name__ == "__main__":
    main()
