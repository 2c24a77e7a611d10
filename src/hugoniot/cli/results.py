"""The numbers that matter of a finished run, for the terminal."""

from collections.abc import Sequence

import numpy as np
import typer

from hugoniot.cli.show import echo_table
from hugoniot.output.run import Run
from hugoniot.units import format_si

NOISE = 1e-6   # of the largest speed of a run: what a gauge sees of a wave that has not come yet is less


def gauge_rows(run: Run) -> list[dict]:
    """Per gauge, SI: first arrival (half of the peak velocity change; NaN where nothing came), peak stress, peak and last velocity."""
    from hugoniot.diagnostics.arrival import first_crossing

    rows = []
    table = run.arrays("gauges") if run.gauge_names() else {}
    noise = NOISE * _largest_velocity(run)
    for k, name in enumerate(run.gauge_names()):
        time, velocity = table["time"], table["velocity"][:, k]
        row: dict = {"gauge": name}
        change = velocity - velocity[0]
        peak = change[np.argmax(np.abs(change))]
        row["arrival"] = first_crossing(time, velocity, velocity[0] + 0.5 * peak) if abs(peak) > noise else float("nan")
        if "stress" in table:
            top = int(np.argmax(table["stress"][:, k]))
            row |= {"peak_stress": float(table["stress"][top, k]), "lowest_stress": float(table["stress"][:, k].min())}
        row |= {"peak_velocity": float(velocity[np.argmax(np.abs(velocity))]), "last_velocity": float(velocity[-1])}
        rows.append(row)
    return rows


def _largest_velocity(run: Run) -> float:
    """The largest speed in the gauges and snapshots of a run, m/s."""
    known = [values for group in ("gauges", "snapshots") for name, values in run.arrays(group).items() if name.startswith("velocity")]
    return max((float(np.max(np.abs(values))) for values in known if values.size), default=0.0)


def echo_results(run: Run, shown: Sequence[str] = ()) -> None:
    """Print the summary, the gauges and the warnings but those `shown` already."""
    s = run.summary
    compiling = s.get("compile_seconds", 0.0)
    typer.echo(f"{s['title']}: {s['status']} at {format_si(s['time'], 's')}, {s['cycles']} cycles, "
               f"{s.get('zone_updates', 0):.3g} zone updates in {s['wall_seconds']:.2f} s"
               + (f", {compiling:.2f} s of them for compiling, once" if compiling >= 0.01 else ""))
    errors = [f"{word} {s[key]:.1e}" for word, key in (("mass", "mass_error"), ("momentum", "momentum_error"), ("energy", "energy_error"))
              if isinstance(s.get(key), (int, float))]
    if s.get("solver") == "shock_structure":
        typer.echo(f"relative errors: {', '.join(errors)}")
        _echo_structure(run)
    else:
        typer.echo(f"relative errors: {', '.join(errors)}; voids opened {s.get('voids_opened', 0)}, "
                   f"closed {s.get('voids_closed', 0)}, interfaces parted {s.get('interfaces_parted', 0)}")
    rows = gauge_rows(run)
    if rows:
        typer.echo("")
        units = {"arrival": "s", "peak_stress": "Pa", "lowest_stress": "Pa", "peak_velocity": "m/s", "last_velocity": "m/s"}
        heads = [key for key in rows[0] if key != "gauge"]
        echo_table(["gauge", *[h.replace("_", " ") for h in heads]],
                   [[r["gauge"], *["none" if np.isnan(r[h]) else format_si(r[h], units[h], 5) for h in heads]] for r in rows])
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
        typer.echo(f"steady wave, Mach {s['mach']:.5g}: {format_si(steady, 'm', 5)} (the run {away:+.2g} %), "
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
    """What the free surface tells of a spall, if there was one."""
    from hugoniot.output.compare import free_surface_gauges

    if not run.summary.get("voids_opened") or not free_surface_gauges(run):
        return
    from hugoniot.output.spall_reading import spall_reading

    reading = spall_reading(run)
    if reading:
        words = [("pull-back", "pull_back", "m/s"), ("spall strength", "spall_strength_acoustic", "Pa"),
                 ("with Kanel's correction", "spall_strength_kanel", "Pa"), ("spalled layer", "spall_thickness", "m")]
        told = [f"{word} {format_si(reading[key], unit, 4)}" for word, key, unit in words if key in reading]
        typer.echo(f"free surface: peak {format_si(reading['peak_velocity'], 'm/s', 5)}, {', '.join(told)}")


def warnings_of(run: Run) -> list[str]:
    """Texts of the warnings among a run's events."""
    events = run.arrays("events")
    return [str(text) for kind, text in zip(events.get("kind", ()), events.get("text", ())) if kind == "warning"]
