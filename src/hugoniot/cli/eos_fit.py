"""The report of `hugoniot eos fit`, and the measured points that the library keeps."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import typer

from hugoniot.cli.eos_output import write_csv
from hugoniot.cli.show import echo_json, echo_table
from hugoniot.errors import DeckError
from hugoniot.theory.fits import read_points, us_up

WORDS = (("c0", "m/s"), ("s", ""), ("s2", "s/m"))


def library_points(names: Sequence[str]) -> np.ndarray | None:
    """Measured (up, us) in m/s of a material of the library that is fully dense, or None."""
    from hugoniot.materials.schema import points
    from hugoniot.materials.search import spelling

    wanted = {spelling(n) for n in names}
    found = [(p["up"], p["us"]) for p in points()
             if spelling(p.material) in wanted and p["use_for_fit"] == 1.0 and p.get("porosity", 1.0) < 1.01]
    return np.array(found, float) if found else None


def report(name: str, degree: int, least: float, highest: float, as_json: bool, as_csv, plot) -> None:
    """Fit the points of a file or of the library; print, and draw where asked."""
    up, us = _points(name)
    kept = (up >= least) & (up <= highest)
    fitted = us_up(up[kept], us[kept], degree)
    if plot:
        from hugoniot.plotting.eos import save, us_up_fit

        save(us_up_fit([(Path(name).stem, fitted)]), plot)
    if as_csv:
        write_csv(as_csv, [("", {"particle_velocity": up[kept], "shock_velocity": us[kept], "fitted_shock_velocity": fitted(up[kept]),
                                 "deviation": us[kept] - fitted(up[kept])})])
    if as_json:
        echo_json({"source": name, "degree": degree, **fitted.table()})
        return
    typer.echo(f"{name}: {kept.sum()} points, particle velocity {fitted.least:.6g} to {fitted.highest:.6g} m/s")
    echo_table(["", "value", "standard deviation", ""], [
        (word, f"{value:.6g}", f"{sigma:.3g}", unit)
        for (word, unit), value, sigma in zip(WORDS, fitted.coefficients, fitted.deviations)])
    typer.echo(f"standard deviation of the points about the curve: {fitted.deviation:.4g} m/s; "
               f"beyond {fitted.highest:.6g} m/s it extrapolates")


def _points(name: str):
    if Path(name).suffix.lower() in (".csv", ".txt", ".dat") or Path(name).exists():
        return read_points(name)
    from hugoniot.materials.library import entry

    found = entry(name)
    points = library_points((found.material.name, found.title, *found.aliases))
    if points is None:
        raise DeckError.single("library", None, name, "no measured points are kept for this material",
                               "give a CSV file with columns up and us")
    return points.T
