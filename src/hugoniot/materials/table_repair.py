"""Repair of tables p(rho, T), e(rho, T) whose energy falls, or stays constant, as the temperature rises.

**Repair.** In tables assembled from several phases the energy may fall, or stay constant, as the temperature rises. Two temperatures then
have the same energy, and the temperature cannot be computed from density and energy. At such a density some pressures and energies are
replaced by linear interpolation in temperature between the entries that are kept. These are chosen so that the energy rises from each to
the next and the sum of the changes of the energy is least.
"""

import math

import numpy as np


def risen(rho, t, p, e):
    """(p, e, notes): pressure and energy (n, m) with the energy rising along every row; notes say where and by how much.

    rho (n,) kg/m3, t (m,) K, p (n, m) Pa, e (n, m) J/kg. A row that cannot be repaired, since it does not rise from its first to its last
    entry, or holds numbers that are not finite, is left to the checks of the law.
    """
    falls = np.argwhere(np.diff(e, axis=1) <= 0.0)
    new_p, new_e = p.copy(), e.copy()
    for i in np.unique(falls[:, 0]):
        if np.isfinite(e[i]).all() and e[i, -1] > e[i, 0]:
            kept = _kept(t, e[i])
            new_p[i], new_e[i] = np.interp(t, t[kept], p[i, kept]), np.interp(t, t[kept], e[i, kept])
    changed = np.argwhere((new_p != p) | (new_e != e))
    if not changed.size:
        return p, e, []
    (low, first), (high, last) = changed.min(axis=0), changed.max(axis=0)
    worst = np.unravel_index(np.argmax(np.abs(new_e - e)), e.shape)
    hardest = np.unravel_index(np.argmax(np.abs(new_p - p)), p.shape)
    return new_p, new_e, [
        f"the energy of the table does not rise with temperature everywhere (such places: {len(falls)}); entries interpolated between "
        f"their neighbours: {len(changed)} of {e.size}, at densities from {rho[low]:.4g} to {rho[high]:.4g} kg/m3 and temperatures from "
        f"{t[first]:.4g} to {t[last]:.4g} K; the energy changes by up to {abs(new_e[worst] - e[worst]) * 1e-3:.4g} kJ/kg (at "
        f"{rho[worst[0]]:.4g} kg/m3, {t[worst[1]]:.4g} K), the pressure by up to {abs(new_p[hardest] - p[hardest]) * 1e-9:.4g} GPa (at "
        f"{rho[hardest[0]]:.4g} kg/m3, {t[hardest[1]]:.4g} K)"]


def _kept(t, row) -> list[int]:
    """The entries of a row that are kept, the first and the last among them: the cheapest path on which the energy rises.

    A step of the path from i to j costs the sum over the entries between of what the straight line changes. Rises below 1e-12 of the
    row's range are round-off. Steps are short, of up to 8 entries, unless no such path exists.
    """
    least, longest = 1e-12 * float(np.ptp(row)), 8
    while True:
        cost, come = np.full(row.size, math.inf), np.zeros(row.size, dtype=int)
        cost[0] = 0.0
        for j in range(1, row.size):
            for i in range(max(j - longest, 0), j):
                if cost[i] < cost[j] and row[j] - row[i] > least:
                    line = row[i] + (t[i:j + 1] - t[i]) * ((row[j] - row[i]) / (t[j] - t[i]))
                    through = cost[i] + float(np.abs(line - row[i:j + 1]).sum())
                    if through < cost[j]:
                        cost[j], come[j] = through, i
        if math.isfinite(cost[-1]) or longest >= row.size:
            break
        longest *= 2
    path = [row.size - 1]
    while path[-1] > 0:
        path.append(int(come[path[-1]]))
    return path[::-1]
