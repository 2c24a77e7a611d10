"""The numbers that matter of a finished run, for the terminal."""

from collections.abc import Sequence

import numpy as np
import typer

from hugoniot.cli.show import echo_table
from hugoniot.output.columns import PER_AREA
from hugoniot.output.run import Run
from hugoniot.output.run_numbers import (
    GAUGE_UNITS,
    IN_PLANE,
    SPALL,
    eroded_rows,
    gauge_rows,
    highest_rows,
    is_lower_bound,
    spall_numbers,
    warnings_of,
)
from hugoniot.output.spall_records import called
from hugoniot.units import format_si


def echo_results(run: Run, shown: Sequence[str] = ()) -> None:
    """Print the summary, the gauges and the warnings but those `shown` already."""
    s = run.summary
    compiling = s.get("compile_seconds", 0.0)
    typer.echo(f"{s['title']}: {s['status']} at {format_si(s['time'], 's')}, {s['cycles']} cycles, "
               f"{s.get('zone_updates', 0):.3g} zone updates" + ("" if s["wall_seconds"] is None else f" in {s['wall_seconds']:.2f} s")
               + (f", of which {compiling:.2f} s compiling, once for this machine" if compiling >= 0.01 else ""))
    errors = [f"{word} {s[key]:.1e}" for word, key in (("mass", "mass_error"), ("momentum", "momentum_error"), ("energy", "energy_error"))
              if isinstance(s.get(key), (int, float))]
    counted = s.get("solver") not in ("shock_structure", "lagrange2d")
    typer.echo(f"relative errors: {', '.join(errors)}" + (
        f"; voids opened {s.get('voids_opened', 0)}, closed {s.get('voids_closed', 0)}, interfaces separated "
        f"{s.get('interfaces_separated', 0)}" if counted else ""))
    if s.get("solver") == "shock_structure":
        _echo_structure(run)
    if "zones_eroded" in s:
        typer.echo("eroded: " + ", ".join(f"{name} {value}" for name, value in eroded_rows(run)))
    if "contact_heat" in s:
        unit = "J" + PER_AREA[run.setup["geometry"]]
        typer.echo(f"contact: heat {format_si(s['contact_heat'], unit)}, work of friction {format_si(s['friction_work'], unit)}, "
                   f"deepest penetration {s['contact_depth']:.1e} of an edge, bonds broken {s['bonds_broken']}")
    top = highest_rows(run)
    if top:
        typer.echo("highest: " + "; ".join(f"{name} {value}" + (f" ({place})" if place else "") for name, value, place in top))
    rows = gauge_rows(run)
    if rows:
        typer.echo("")
        heads = [key for key in rows[0] if key != "gauge"]
        echo_table(["gauge", *[h.replace("_", " ") for h in heads]],
                   [[r["gauge"], *["none" if np.isnan(r[h]) else format_si(r[h], GAUGE_UNITS[h], 5) for h in heads]] for r in rows])
        if "axes" in run.setup:
            typer.echo(IN_PLANE)
    _echo_spall(run)
    typer.echo("")
    for warning in warnings_of(run):
        if warning not in shown:
            typer.echo(f"warning: {warning}")


def echo_place(run: Run) -> None:
    """Print where the results and the report are."""
    report = run.folder / "report.html"
    typer.echo(f"results in {run.folder}" + (f", report: {report}" if report.is_file() else ""))


def _echo_structure(run: Run) -> None:
    """Thickness with its definition beside the steady wave's, entropy, transport laws and sources of a run that resolves a shock."""
    s = run.summary
    if "density_thickness" in s:
        typer.echo(f"density thickness |rho2 - rho1| / max|drho/dx|: {format_si(s['density_thickness'], 'm', 5)}, "
                   f"{s['cells_per_thickness']:.4g} cells")
    if "steady_density_thickness" in s:
        steady = s["steady_density_thickness"]
        away = 100.0 * (s["density_thickness"] / steady - 1.0)
        typer.echo(f"steady wave, Mach {s['mach']:.5g}: {format_si(steady, 'm', 5)} (the run differs by {away:+.2g} %), "
                   f"by velocity |u2 - u1| / max|du/dx| {format_si(s['steady_velocity_thickness'], 'm', 5)}, "
                   f"10 to 90 % of density {format_si(s['steady_density_width_10_90'], 'm', 5)}")
        made = s["entropy_viscous"] + s["entropy_conductive"]
        if made == made:
            typer.echo(f"entropy gained {made:.6g} J/(kg K): viscosity {s['entropy_viscous']:.6g}, "
                       f"conduction {s['entropy_conductive']:.6g}")
    if run.setup.get("transport"):
        echo_transport(run.setup["transport"])
    typer.echo("sources: " + "; ".join(run.setup["references"]))


def echo_transport(record: dict) -> None:
    """The laws of `transport_record` with their constants and units."""
    for word, law in zip(("shear viscosity", "heat conduction"), record["laws"]):
        constants = ", ".join(f"{c['name']} {format_si(c['value'], c['unit'])}" for c in law["constants"])
        typer.echo(f"{word}: {law['law']}" + (f" ({constants})" if constants else ""))
    typer.echo(f"bulk viscosity: {record['bulk_ratio']:g} of the shear viscosity + {format_si(record['bulk_viscosity'], 'Pa s')}")


def _echo_spall(run: Run) -> None:
    """The spall reading, or why there is none."""
    found = spall_numbers(run)
    if "region" in found:
        place = f"gauge '{found['gauge']}'" if found["gauge"] else "right face of the snapshots"
        behind = f", towards {called(run.setup, found['window'])}" if found["window"] else ""
        typer.echo(f"spall of '{found['region']}' ({place}{behind}):")
        for key, words, unit in SPALL:
            if key in found:
                typer.echo(f"  {words:38s} {'at least ' if is_lower_bound(key, found) else ''}{format_si(found[key], unit, 4)}")
    if "reason" in found:
        typer.echo(f"spall strength: not given: {found['reason']}")
    if "note" in found:
        typer.echo(f"  {found['note']}")
