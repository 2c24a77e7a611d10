"""Decks of the Fortran KO codes (columns, Mbar - cm - us - g) as decks of this package: Mie-Grüneisen and ideal gases.

Two lines of headings, a line for each layer, a blank line, two lines of headings, two ends, a blank line, and the stop time and the
dimension, each after a line of text. Numbers stand between blanks, or in the columns of the Fortran format (2I7, 7E7, 3E9, 10E7).
Format: KO v11 of J. Borg, as in github.com/ImpactsWiki/pyko.
"""

from typing import Any

from hugoniot.errors import DeckError
from hugoniot.materials.collect import printable
from hugoniot.problem.ko_decks import GEOMETRIES, KoDeck, Layer, check_reference, fracture_table

CM, MBAR, US = 1e-2, 1e11, 1e-6
SPEED, DENSITY = CM / US, 1000.0
WIDTHS = (7, 7, *(7,) * 7, *(9,) * 3, *(7,) * 10)
LEAST = 17              # numbers of a layer, up to the specific heat


def read_columns(text: str, file: str) -> KoDeck:
    """The deck in a text of columns. Raises `DeckError`."""
    lines = text.splitlines()
    layers, at, left = [], 2, []
    while at < len(lines) and lines[at].strip():
        layers.append(_layer(_numbers(lines[at], WIDTHS, LEAST, file, at + 1), file, at + 1, len(layers) + 1, left))
        at += 1
    if not layers:
        raise DeckError.single(file, 3, "layers", "no layer is given", "layers follow two lines of headings")
    ends = [_end(_numbers(line, (7,) * 6, 2, file, at + 4 + k), file, at + 4 + k)
            for k, line in enumerate(_lines(lines, at + 3, 2, file))]
    stop, dimension = (_numbers(line, (20,), 1, file, at + 8 + 2 * k)[0] for k, line in enumerate(_lines(lines, at + 7, 3, file)[::2]))
    if dimension not in (1.0, 2.0, 3.0):
        raise DeckError.single(file, at + 10, "geometry", f"{dimension:g} is not 1, 2 or 3")
    return KoDeck("", GEOMETRIES[int(dimension)], stop * US, tuple(layers), (ends[0], ends[1]), left=left)


def _lines(lines: list[str], at: int, count: int, file: str) -> list[str]:
    if len(lines) < at + count:
        raise DeckError.single(file, len(lines), "deck", "ends too early", "ends, stop time and dimension follow the layers")
    return lines[at:at + count]


def _numbers(line: str, widths: tuple[int, ...], least: int, file: str, number: int) -> list[float]:
    """The numbers of a line: between blanks where that gives enough of them, else in their columns."""
    try:
        found = [float(word) for word in line.split()]
        if len(found) >= least:
            return found
    except ValueError:
        pass
    fields, at = [], 0
    for width in widths:
        fields.append(line[at:at + width].strip())
        at += width
    try:
        found = [float(word) for word in fields if word]
    except ValueError:
        found = []
    if len(found) < least:
        raise DeckError.single(file, number, "columns", f"expected {least} or more numbers, got '{printable(line.strip(), 40)}'")
    return found


def _layer(row: list[float], file: str, line: int, number: int, left: list[str]) -> Layer:
    kind, nodes, length, start, p, u, rho, e, reference, c0, s1, s2, gamma, flow, shear, limit, heat = row[:LEAST]
    eos: dict[str, Any]
    if kind == 1:
        if s2:
            raise DeckError.single(file, line, "s2", "a quadratic shock velocity is not supported", "set s2 to 0")
        check_reference(rho * DENSITY, reference * DENSITY, file, "Rho_00", line)
        eos = {"law": "wilkins_cubic", "rho0": reference * DENSITY, "c0": c0 * SPEED, "s": s1, "gamma0": gamma}
    elif kind == 2:
        eos = {"law": "ideal_gas", "gamma": gamma, "rho0": rho * DENSITY}
    else:
        raise DeckError.single(file, line, "iEOS", f"{kind:g} is not supported", "known: 1 (Mie-Grüneisen), 2 (ideal gas)")
    tables: dict[str, Any] = {"eos": eos}
    if heat > 0.0:
        eos["specific_heat"] = heat * MBAR / DENSITY / rho if kind == 2 else heat * MBAR / DENSITY
    if shear > 0.0:
        tables["strength"] = {"law": "perfectly_plastic", "shear_modulus": shear * MBAR, "yield_stress": flow * MBAR}
    if kind == 1 and (fracture := fracture_table(limit * MBAR, None)) is not None:
        tables["fracture"] = fracture
        left.append(f"layer {number}: fracture where the pressure falls below -pfrac; KO compares the longitudinal stress, and neither "
                    "its version v11e nor pyKO acts on pfrac in such a deck")
    if nodes % 2 or nodes < 2:
        raise DeckError.single(file, line, "Nodes", f"{nodes:g} is not an even number of nodes above 0",
                               "KO counts centres and edges: 2 per cell")
    own = p / (gamma - 1.0) if p else 0.0      # KO v11 overwrites E_0 by this, also where the law is not a gas
    if abs(own - e) > 1e-3 * max(abs(own), abs(e)):
        left.append(f"layer {number}: the initial energy is E_0 = {e:g} Mbar, as in pyKO; KO v11 ignores E_0 and takes "
                    f"P_0/(gamma - 1) = {own:g} Mbar")
    return Layer(f"layer {number}", start * CM, length * CM, int(nodes) // 2, u * SPEED, rho * DENSITY, e * MBAR / (rho * DENSITY),
                 p * MBAR, tables)


def _end(row: list[float], file: str, line: int) -> Any:
    if abs(row[0]) == 4:
        return "fixed"
    if abs(row[0]) == 1:
        return {"pressure": row[1] * MBAR} if row[1] else "free"
    raise DeckError.single(file, line, "iend", f"{row[0]:g} is not supported", "known: 1 (free), 4 (fixed)")
