"""The report of `hugoniot eos table`: p(rho, T) and e(rho, T) of any law with a temperature."""

import csv

import numpy as np
import typer

from hugoniot.cli.eos.input import Subject
from hugoniot.cli.eos.output import echo_notes
from hugoniot.cli.show import echo_json, echo_table, quantity
from hugoniot.errors import DeckError, FileTrouble, OutOfRange
from hugoniot.laws.eos.contract import EOS, flagged, reference_state, require_temperature
from hugoniot.theory.isentrope import grid
from hugoniot.theory.states import density_range

NO_MEMORY = ("the table holds the states of first loading: it does not keep crushed pores closed, so that releases from it follow the "
             "loading back; use the law itself for runs")


def report(subject: Subject, densities: str, temperatures: str, points: int, as_json: bool, as_csv,
           as_hdf5=None, plot=None) -> None:
    """Solve for the energy at every density and temperature; print a corner of it, or write all."""
    require_temperature(subject.material.eos)
    rho0 = reference_state(subject.material.eos)[0]
    low, high = _range(densities, "kg/m^3", "--densities") if densities else (0.9 * rho0, 1.5 * rho0)
    least, most = density_range(subject.material.eos)
    if not least <= low < high < most:
        raise OutOfRange(f"the law '{EOS.of(subject.material.eos).name}' is defined for densities from {max(least, 1e-6):.6g} to "
                         f"{most:.6g} kg/m3, but --densities is {low:.6g} to {high:.6g} kg/m3")
    rho, t = np.linspace(low, high, points), _temperatures(temperatures, points)
    p, e = grid(subject.material, rho, t)
    if as_csv:
        _write(as_csv, rho, t, p, e)
    if as_hdf5:
        from hugoniot.materials.table_hdf5 import write_table

        write_table(as_hdf5, rho, t, p, e, f"{subject.material.name}, law {EOS.of(subject.material.eos).name}")
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.waves import isotherms

        save(isotherms(subject.material.name, rho, t, p), plot)
    told = [NO_MEMORY] if flagged(subject.material.eos, "remembers") else []
    if as_json:
        echo_json({"material": subject.material.name, "density": rho, "temperature": t, "pressure": p, "specific_internal_energy": e,
                   "warnings": told})
        return
    typer.echo(f"{subject.title or subject.material.name}: pressure in GPa at density (down) and temperature (across)")
    down, across = (np.unique(np.linspace(0, n - 1, min(n, 7)).round().astype(int)) for n in (rho.size, t.size))
    rows = [[f"{rho[i]:.1f}", *[f"{p[i, j] * 1e-9:.4g}" for j in across]] for i in down]
    echo_table(["kg/m3", *[f"{t[j]:.6g} K" for j in across]], rows)
    echo_notes(told)
    if as_csv is None and as_hdf5 is None:
        typer.echo(f"{rho.size} x {t.size} values; --csv FILE or --hdf5 FILE writes them all, with energies, as the law 'table' reads them")


def _write(path, rho, t, p, e) -> None:
    """The file that the law `table` reads: density, temperature, pressure, energy in SI, one row per point."""
    try:
        with open(path, "w", newline="", encoding="utf-8") as file:
            out = csv.writer(file)
            out.writerow(["density", "temperature", "pressure", "energy"])
            out.writerows([repr(float(v)) for v in (rho[i], t[j], p[i, j], e[i, j])] for i in range(rho.size) for j in range(t.size))
    except OSError as error:
        raise FileTrouble(f"cannot write {path}: {error.strerror or error}") from None


def _temperatures(text: str, points: int) -> np.ndarray:
    """A range in as many values as of the density, or three and more values as they are; 0 K is the law's cold curve."""
    if text.count(",") < 2:
        return np.linspace(*_range(text, "K", "--temperatures", lowest=0.0), points)
    values = np.array([quantity(part.strip(), "K", "--temperatures") for part in text.split(",")])
    if values[0] < 0.0 or not (np.diff(values) > 0.0).all():
        raise DeckError.single("command line", None, "--temperatures", f"'{text[:60]}' is not a rising list of temperatures",
                               "write rising values, 0 K or more")
    return values


def _range(text: str, unit: str, option: str, lowest: float | None = None) -> tuple[float, float]:
    parts = text.split(",")
    if len(parts) != 2:
        raise DeckError.single("command line", None, option, f"'{text[:60]}' is not a range", 'write two values, such as "300 K, 3000 K"')
    low, high = (quantity(p.strip(), unit, option) for p in parts)
    if not low < high or low < 0.0 or low == 0.0 != lowest:
        raise DeckError.single("command line", None, option, f"'{text[:60]}' is not a rising range",
                               f"write the lower value first, {'above 0' if lowest is None else '0 or more'}")
    return low, high
