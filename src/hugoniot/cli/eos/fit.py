"""The reports of `hugoniot eos fit`, `fit-jwl` and `fit-gamma`."""

import re
from pathlib import Path

import numpy as np
import typer

from hugoniot.cli.eos.output import echo_columns, echo_notes, notes, write_csv
from hugoniot.cli.show import echo_json, echo_table
from hugoniot.errors import DeckError, OutOfRange
from hugoniot.theory.fits import adjusted_gamma, fit_jwl, read_expansion, read_points, shocked_state, truncated_pressure, us_up

CURVED = 5.0     # standard deviations of the quadratic term
WORDS = (("c0", "m/s"), ("s", ""), ("s2", "s/m"))


def _fitted(name: str, degree: int, least: float, highest: float):
    """(up, us, which of them are kept, their fit)."""
    up, us = _points(name)
    kept = (up >= least) & (up <= highest)
    try:
        return up, us, kept, us_up(up[kept], us[kept], degree)
    except OutOfRange as error:
        raise DeckError.single(name, None, "points", str(error), "measure more, or widen --from and --to") from None


def deck_table(name: str, degree: int, least: float, highest: float, density: float | None, gruneisen: float | None) -> None:
    """Print the fit as the tables of a material for a deck."""
    up, us, kept, fitted = _fitted(name, degree, least, highest)
    echo_notes(_doubts(up[kept], us[kept], fitted))
    if density is None:
        density = _density_at_rest(name)
    words = re.sub(r"[^A-Za-z0-9_]+", "_", Path(name).stem).strip("_") or "fitted"
    gamma, why = (gruneisen, "") if gruneisen is not None else (2.0 * fitted.coefficients[1] - 1.0, "   # estimated as 2 s - 1")
    names = (("c0", "s1", "s2") if degree == 2 else ("c0", "s"))
    typer.echo(f"# {name}: {kept.sum()} points, particle velocity {fitted.least:.6g} to {fitted.highest:.6g} m/s, standard deviation "
               f"{fitted.deviation:.4g} m/s")
    typer.echo(f"[material.{words}]\nvalid_up_to = \"{fitted.highest:.6g} m/s\"\n\n[material.{words}.eos]\n"
               f"law = \"{'mie_gruneisen_quadratic' if degree == 2 else 'mie_gruneisen'}\"\nrho0 = \"{density:.6g} kg/m^3\"")
    for key, (_, unit), value, sigma in zip(names, WORDS, fitted.coefficients, fitted.deviations):
        shown = f"\"{value:.6g} {unit}\"" if unit else f"{value:.6g}"
        typer.echo(f"{key} = {shown}   # standard deviation {sigma:.3g}")
    typer.echo(f"gamma0 = {gamma:.6g}{why}")


def solid_table(name: str, least: float, highest: float, density: float | None, gruneisen: float | None, as_json: bool) -> None:
    """Print the JWL alternative for solids fitted to points, as the table of a material."""
    from hugoniot.theory.solid_fits import fit_solid

    up, us = _points(name)
    kept = (up >= least) & (up <= highest)
    rest = _density_at_rest(name) if density is None else density
    try:
        gamma = 2.0 * us_up(up[kept], us[kept], 1).coefficients[1] - 1.0 if gruneisen is None else gruneisen
        found = fit_solid(rest, gamma, up[kept], us[kept])
    except OutOfRange as error:
        hint = "give a smaller --gruneisen" if "pole" in str(error) else "measure more, or widen --from and --to"
        raise DeckError.single(name, None, "points", str(error), hint) from None
    values = {n: float(getattr(found.par, n)) for n in ("a", "b", "r1", "r2", "gamma0", "rho0")}
    told = [*_slow(up[kept], us[kept]), *_at_bounds(found)]
    if as_json:
        echo_json({"source": name, "law": "jwl_proportional", **values, "deviation": found.deviation, "worst": found.worst,
                   "highest_particle_velocity": found.highest, "warnings": told})
        return
    echo_notes(told)
    words = re.sub(r"[^A-Za-z0-9_]+", "_", Path(name).stem).strip("_") or "fitted"
    typer.echo(f"# {name}: pressures fitted to {100.0 * found.deviation:.3g} % (root mean square), {100.0 * found.worst:.3g} % at worst\n"
               f"[material.{words}]\nvalid_up_to = \"{found.highest:.6g} m/s\"\n\n[material.{words}.eos]\nlaw = \"jwl_proportional\"\n"
               + "\n".join(f"{n} = {v:.8g}" for n, v in values.items()))


def _slow(up, us) -> list[str]:
    """Warnings about points whose shock velocity is not above the particle velocity."""
    slow = (us <= up) & (up > 0.0)
    return [f"{slow.sum()} of {up.size} points have a shock velocity not above the particle velocity, which no shock can have (the first: "
            f"up = {up[slow][0]:.6g}, us = {us[slow][0]:.6g} m/s): are the columns swapped, or is a free-surface velocity taken "
            "for the particle velocity?"] if slow.any() else []


def _doubts(up, us, fitted) -> list[str]:
    """The same, and about a curve without a sound speed at rest, not above the particle velocity, or falling with it."""
    found, (rest, slope) = _slow(up, us), fitted.coefficients[:2]
    if not rest > 0.0:
        found.append(f"at up = 0 the curve gives us = {rest:.6g} m/s, which is not a possible sound speed: the curve cannot be used as "
                     "a law")
    elif not fitted(fitted.highest) > fitted.highest:
        found.append(f"the curve's shock velocity is not above the particle velocity at up = {fitted.highest:.6g} m/s, which no "
                     "shock can have")
    if len(fitted.coefficients) == 2 and not slope > 0.0:
        found.append(f"the shock velocity falls with the particle velocity (s = {slope:.4g}): such shocks are not stable")
    return [*found, *_curved(up, us, fitted)]


def _curved(up, us, fitted) -> list[str]:
    """A warning where a parabola follows the points so much better than the line that this is no chance."""
    if len(fitted.coefficients) > 2 or np.unique(up).size < 5:
        return []
    better = us_up(up, us, 2)
    away = better.coefficients[2] / better.deviations[2] if better.deviations[2] > 0.0 else 0.0
    return [f"the points are not on a straight line: a parabola has a quadratic term of {abs(away):.0f} standard deviations; those "
            "of c0 and s do not include this misfit; use --quadratic, or a smaller range (--from, --to)"] if abs(away) > CURVED else []


def _at_bounds(found) -> list[str]:
    """A warning about a fit with exponents at the bounds of the search."""
    return [f"{' and '.join(found.at_bounds)} ended at the bound of the search: the points do not determine the fit; measure over a wider "
            "range, or fix what is known"] if found.at_bounds else []


def _density_at_rest(name: str) -> float:
    """Of a material of the library, kg/m3."""
    if Path(name).suffix.lower() in (".csv", ".txt", ".dat") or Path(name).exists():
        raise DeckError.single("command line", None, "--density", "the points do not give the reference density",
                               'add --density "8.93 g/cm^3"')
    from hugoniot.laws.eos.contract import reference_state
    from hugoniot.materials.library import find

    return float(reference_state(find(name).eos)[0])


def report(name: str, degree: int, least: float, highest: float, as_json: bool, as_csv, plot) -> None:
    """Fit the points of a file or of the library; print, and draw where asked."""
    up, us, kept, fitted = _fitted(name, degree, least, highest)
    if plot:
        from hugoniot.plotting.eos import save, us_up_fit

        save(us_up_fit([(Path(name).stem, fitted)]), plot)
    if as_csv:
        write_csv(as_csv, [("", {"particle_velocity": up[kept], "shock_velocity": us[kept], "fitted_shock_velocity": fitted(up[kept]),
                                 "deviation": us[kept] - fitted(up[kept])})])
    told = _doubts(up[kept], us[kept], fitted)
    if as_json:
        echo_json({"source": name, "degree": degree, **fitted.table(), "warnings": told})
        return
    typer.echo(f"{name}: {kept.sum()} points, particle velocity {fitted.least:.6g} to {fitted.highest:.6g} m/s")
    echo_table(["", "value", "standard deviation", ""], [
        (word, f"{value:.6g}", f"{sigma:.3g}", unit)
        for (word, unit), value, sigma in zip(WORDS, fitted.coefficients, fitted.deviations)])
    echo_notes(told)
    if fitted.highest < 100.0:
        echo_notes([f"no particle velocity is above {fitted.highest:.3g} m/s: if they are in km/s, name the columns up (km/s), "
                    "us (km/s)"])
    typer.echo(f"standard deviation of the points about the curve: {fitted.deviation:.4g} m/s; "
               f"below {fitted.least:.6g} and above {fitted.highest:.6g} m/s it extrapolates")


def jwl(path: str, density: str, velocity: str, pressure: str, energy: str, omega: float | None, as_json: bool, as_csv, plot) -> None:
    """JWL of products from a CJ state and a file of the expansion below it."""
    from hugoniot.cli.show import quantity

    rho0, d = quantity(density, "kg/m^3", "--density"), quantity(velocity, "m/s", "--velocity")
    p_cj, e0 = quantity(pressure, "Pa", "--pressure"), quantity(energy, "J/m^3", "--energy")
    cj_volume = 1.0 - p_cj / (rho0 * d * d)
    if not cj_volume > 0.0:
        raise DeckError.single("command line", None, "--pressure", f"{p_cj * 1e-9:.4g} GPa is more than rho0 D^2 = "
                               f"{rho0 * d * d * 1e-9:.4g} GPa", "a CJ pressure is about a quarter of it")
    volumes, pressures = read_expansion(path)
    below = volumes > cj_volume
    if not (pressures[below] > 0.0).all():
        raise DeckError.single(path, None, "pressure", "a pressure of zero cannot be fitted, because the fit is to ln p", "omit that point")
    found = fit_jwl(rho0, d, p_cj, e0, volumes[below], pressures[below], omega=omega)
    par = found.par
    fitted = found.isentrope.pressure(volumes)
    if as_csv:
        write_csv(as_csv, [("", {"relative_volume": volumes, "pressure": pressures, "fitted_pressure": fitted})])
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.waves import expansion_fit

        save(expansion_fit(Path(path).stem, volumes, pressures, (cj_volume, p_cj), par, found.c), plot)
    values = {n: float(getattr(par, n)) for n in ("a", "b", "r1", "r2", "omega", "rho0", "e0")} | {"c": found.c}
    if as_json:
        echo_json({"source": path, "law": "jwl", **values, "standard_deviation": found.deviation, "points": found.count,
                   "warnings": _at_bounds(found)})
        return
    units = {"a": "Pa", "b": "Pa", "c": "Pa", "rho0": "kg/m3", "e0": "J/m3"}
    echo_table(["", "", ""], [(n, f"{v:.7g}", units.get(n, "")) for n, v in values.items()])
    typer.echo(f"{found.count} points beyond the CJ volume {cj_volume:.4f}; standard deviation of ln(p): {found.deviation:.3g}; "
               "the CJ state is kept exactly")
    echo_notes(_at_bounds(found))


def gamma(subject, at: str, ambient: float, as_json: bool) -> None:
    """The Gamma that makes the truncated cubic law of a linear Us-up material pass through a shock state."""
    from hugoniot.cli.eos.input import one_state
    from hugoniot.theory.hugoniot import shock

    par = subject.material.eos
    if not all(hasattr(par, n) for n in ("rho0", "c0", "s", "gamma0")):
        raise DeckError.single("command line", None, subject.material.name, "the adjustment applies to a linear Us-up law",
                               "name a material with rho0, c0, s and gamma0 (see hugoniot eos show)")
    state = shock(subject.material, **one_state(at))
    up = float(state.particle_velocity)
    adjusted = adjusted_gamma(par.rho0, par.c0, par.s, up, par.gamma0, pressure=ambient)
    us, behind, density, energy = shocked_state(par.rho0, par.c0, par.s, up, par.gamma0, ambient)
    table = {"gruneisen": par.gamma0, "adjusted_gruneisen": adjusted, "particle_velocity": up, "shock_velocity": us, "pressure": behind,
             "density": density, "specific_internal_energy": energy,
             "truncated_pressure": truncated_pressure(par.rho0, par.c0, par.s, par.gamma0, density, energy),
             "adjusted_pressure": truncated_pressure(par.rho0, par.c0, par.s, adjusted, density, energy)}
    if as_json:
        echo_json({"material": subject.material.name, **table, "warnings": notes(subject, up)})
        return
    typer.echo(f"{subject.title or subject.material.name}: Gamma with which the law truncated at third order passes through the shock "
               "state")
    echo_columns(table)
    echo_notes(notes(subject, up))


def _points(name: str):
    if Path(name).suffix.lower() in (".csv", ".txt", ".dat") or Path(name).exists():
        return read_points(name)
    from hugoniot.dossier.fits import library_points
    from hugoniot.materials.library import entry

    found = entry(name)
    points = library_points((found.material.name, found.title, *found.aliases))
    if points is None:
        raise DeckError.single("library", None, name, "the library has no measured points for this material",
                               "give a CSV file with columns up and us")
    return points.T
