"""hugoniot eos sesame: what a SESAME-format file holds, whether its parts add up, and their shares of an isotherm."""

from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from hugoniot.cli.eos.options import CSV
from hugoniot.cli.eos.output import echo_notes, write_csv
from hugoniot.cli.show import JSON, echo_json, echo_table, quantity
from hugoniot.errors import DeckError, FileTrouble
from hugoniot.files import read_text
from hugoniot.materials import sesame as files

_LARGEST = 64 * 1024 * 1024
_ADDS_UP = 1e-6       # single precision, as files are written


def sesame(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A SESAME-format ASCII file.")],
    material: Annotated[int | None, typer.Option("--material", help="Number of the material in the file (default: the first).")] = None,
    temperature: Annotated[str | None, typer.Option("--temperature", help='Print the isotherm of each partial table at the '
        'tabulated temperature nearest to this one, such as "3000 K".')] = None,
    as_json: JSON = False, as_csv: CSV = None,
) -> None:
    """Show the tables of a SESAME-format file.

    Prints the grids, how well the partial tables add up to the total, the cold curve, the critical point and the melting curve.

    Example: hugoniot eos sesame copper.ses --temperature "3000 K" --csv parts.csv
    """
    try:
        found = files.records(read_text(file, _LARGEST), str(file))
    except UnicodeDecodeError:
        raise DeckError.single(file, None, "table", "not a text file", "give a SESAME-format ASCII file") from None
    except OSError as error:
        raise FileTrouble(f"{file}: {error.strerror or error}") from None
    if not found:
        raise DeckError.single(file, None, "table", "no table in this file", "give a SESAME-format ASCII file")
    held = files.materials(found)
    chosen = material if material is not None else held[0] if held else None
    grids = {r.number: files.grid(found, r.number, chosen, str(file)) for r in found
             if r.number in files.PARTS and r.material in (None, chosen)}
    if not grids:
        files.grid(found, 301, chosen, str(file))      # says what the file has instead
    curves = {n: c for n in files.CURVES if (c := files.curve(found, n, chosen, str(file))) is not None}
    sums = files.sum_differences(found, chosen, str(file))
    isotherm = _isotherm(grids, quantity(temperature, "K", "--temperature")) if temperature else None
    if as_csv:
        written = isotherm if isotherm is not None else _cold(grids, file)
        units = {"pressure_": " (Pa)", "specific_internal_energy_": " (J/kg)"}
        write_csv(as_csv, [("", {k + units.get(k.rstrip("0123456789"), ""): v for k, v in written.items()})])
    told = _doubts(sums)
    if as_json:
        echo_json({"file": str(file), "material": chosen, "materials": held, "constants": files.constants(found, chosen),
                   "tables": {n: {"what": files.PARTS[n], **_extent(g), "free_energy": g.free_energy is not None}
                              for n, g in grids.items()},
                   "sums": {" + ".join(map(str, parts)): miss and dict(zip(("pressure", "energy", "density", "temperature"), miss))
                            for parts, miss in sums.items()},
                   "coexistence": {n: c._asdict() for n, c in curves.items()}, "isotherm": isotherm, "warnings": told})
        return
    _echo(file, chosen, held, found, grids, curves, sums)
    if isotherm is not None:
        _echo_isotherm(isotherm)
    echo_notes(told)


def _echo(file, chosen, held, found, grids, curves, sums) -> None:
    others = [str(m) for m in held if m != chosen and m is not None]
    name = f"material {chosen}" if chosen is not None else "a material without a number"
    typer.echo(f"{file}: {name}" + (f" (others: {', '.join(others)})" if others else ""))
    units = {"density": "kg/m3", "atomic_mass": "g/mol"}
    given = files.constants(found, chosen)
    if given:
        typer.echo("201 " + ", ".join(f"{k.replace('_', ' ')} {v:.6g} {units.get(k, '')}".rstrip() for k, v in given.items()))
    rows = []
    for number, grid in grids.items():
        extent = _extent(grid)
        rows.append([str(number), files.PARTS[number], *(f"{extent[k][0]}: {extent[k][1]:.4g} to {extent[k][2]:.4g}" for k in extent)])
    echo_table(["", "table", "densities, kg/m3", "temperatures, K"], rows)
    for parts, miss in sums.items():
        name = " + ".join(map(str, parts))
        typer.echo(f"{name}: on different grids, not compared with 301" if miss is None else
                   f"{name} agrees with 301 to {miss[0]:.2g} in pressure and {miss[1]:.2g} in energy, relative to the sum of the parts' "
                   "magnitudes")
    if 306 in grids:
        cold = grids[306]
        rest = _zero(cold.density, cold.pressure[:, 0])
        typer.echo("306 cold curve: " + (f"zero pressure at {rest:.6g} kg/m3, " if rest else "the pressure is nowhere zero, ")
                   + f"lowest energy {cold.energy.min() * 1e-6:.6g} MJ/kg")
    if 401 in curves:
        top = int(np.argmax(curves[401].temperature))
        vapour = curves[401]
        typer.echo(f"401 vaporization to {vapour.temperature[top]:.6g} K, {vapour.pressure[top] * 1e-9:.4g} GPa, "
                   f"{vapour.density[0, top]:.4g} and {vapour.density[1, top]:.4g} kg/m3")
    for number in (411, 412):
        if number in curves:
            low, high = (int(k) for k in (np.argmin(curves[number].pressure), np.argmax(curves[number].pressure)))
            ends = (f"{curves[number].temperature[k]:.5g} K at {curves[number].pressure[k] * 1e-9:.4g} GPa" for k in (low, high))
            typer.echo(f"{number} {files.CURVES[number]}: {' to '.join(ends)}")


def _extent(grid) -> dict[str, tuple]:
    return {name: (values.size, float(values[0]), float(values[-1])) for name, values in
            (("density", grid.density), ("temperature", grid.temperature))}


def _zero(rho, p) -> float | None:
    """The highest density at which the pressure rises through zero."""
    up = np.flatnonzero((p[:-1] < 0.0) & (p[1:] >= 0.0))
    return float(rho[up[-1]] - p[up[-1]] * (rho[up[-1] + 1] - rho[up[-1]]) / (p[up[-1] + 1] - p[up[-1]])) if up.size else None


def _isotherm(grids: dict, temperature: float) -> dict[str, Any]:
    """Pressure and energy of every table at its temperature nearest to the one asked, over the densities of the largest."""
    first = max(grids.values(), key=lambda grid: grid.temperature.size)
    nearest = int(np.argmin(np.abs(first.temperature - temperature)))
    result: dict[str, Any] = {"temperature": np.full(first.density.size, first.temperature[nearest]), "density": first.density}
    for number, grid in grids.items():
        same = grid.temperature.size == 1 or np.array_equal(grid.temperature, first.temperature)
        if np.array_equal(grid.density, first.density) and same:
            column = 0 if grid.temperature.size == 1 else nearest
            result |= {f"pressure_{number}": grid.pressure[:, column], f"specific_internal_energy_{number}": grid.energy[:, column]}
    return result


def _cold(grids: dict, file) -> dict[str, Any]:
    if 306 not in grids:
        raise DeckError.single(file, None, "306", "no cold curve to write", "give --temperature for an isotherm")
    cold = grids[306]
    return {"density": cold.density, "pressure": cold.pressure[:, 0], "specific_internal_energy": cold.energy[:, 0]}


def _echo_isotherm(isotherm: dict[str, Any]) -> None:
    numbers = [k.removeprefix("pressure_") for k in isotherm if k.startswith("pressure_")]
    typer.echo(f"\nat {isotherm['temperature'][0]:.6g} K: pressure in GPa, energy in MJ/kg, by table")
    shown = np.unique(np.linspace(0, isotherm["density"].size - 1, 12).round().astype(int))
    rows = [[f"{isotherm['density'][i]:.5g}", *(f"{isotherm[f'pressure_{n}'][i] * 1e-9:.5g}" for n in numbers),
             *(f"{isotherm[f'specific_internal_energy_{n}'][i] * 1e-6:.5g}" for n in numbers)] for i in shown]
    echo_table(["kg/m3", *(f"p {n}" for n in numbers), *(f"e {n}" for n in numbers)], rows)


def _doubts(sums: dict) -> list[str]:
    """Sums that miss the total by more than files are rounded."""
    return [f"the sum of tables {' + '.join(map(str, parts))} differs from table 301 by up to {miss[0]:.2g} in pressure "
            f"(at {miss[2]:.4g} kg/m3, {miss[3]:.4g} K) "
            f"and {miss[1]:.2g} in energy, relative to the sum of the parts' magnitudes: the tables do not belong "
            "together, or the total was changed afterwards"
            for parts, miss in sums.items() if miss is not None and max(miss[:2]) > _ADDS_UP]
