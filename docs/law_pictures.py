"""Pictures of docs/generated/laws: the Hugoniot of an equation of state, or the release of products; below it, pressure and density."""

from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")

from hugoniot.errors import HugoniotError
from hugoniot.laws.eos.contract import compacted, particle_velocity_limit, pressure, reference_state, remembered, unloading
from hugoniot.plotting.style import COLOURS, QUIET, RC, label_lines, new_panels
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import curve, shock
from hugoniot.theory.isentrope import isentrope


def hugoniot_points(law):
    """(up, p) from rest up to the sound speed, or over the densities of the law's box if it ends before; None if it gives neither."""
    rho0 = float(reference_state(law.example)[0])
    states = curve(law.example, up_to=1.3 * end_inside(law) if end_inside(law) else None)
    if states.pressure[-1] > 0.1 * rho0 * states.shock_velocity[0] ** 2:
        return states.particle_velocity, states.pressure
    for share in (0.5, 0.4, 0.3, 0.2, 0.1):
        try:
            states = shock(law.example, density=np.linspace(rho0, rho0 + share * (law.box["rho"][1] - rho0), 121)[1:])
        except HugoniotError:
            continue
        if np.isfinite(states.pressure).all() and states.pressure[-1] > 0.0:
            return states.particle_velocity, states.pressure
    return None


def end_inside(law) -> float | None:
    """Particle velocity at which the Hugoniot of the law inside ends, m/s, if that of the law itself does not."""
    inner = getattr(law.example, "base", None)
    end = np.inf if inner is None else particle_velocity_limit(inner)
    return float(end) if np.isfinite(end) and not np.isfinite(particle_velocity_limit(law.example)) else None


def shown_pressure(p) -> tuple[float, str]:
    return next(((f, u) for f, u in ((1e-9, "GPa"), (1e-6, "MPa"), (1e-3, "kPa")) if np.max(p) * f >= 1.0), (1.0, "Pa"))


def energies(law) -> list[float]:
    """Rest and two hotter ones of the box, in J/kg; of products the box."""
    low, high = law.box["e"]
    rest = float(reference_state(law.example)[1])
    return [low, (low * high) ** 0.5, high] if "gas" in law.flags else sorted({rest, rest + 0.4 * (high - rest), high})


def lines_of_energy(law, ax) -> None:
    """Pressure over density at constant energy in the box of the tests; of a law around another one that law, dashed."""
    inner = getattr(law.example, "base", None)
    rest = float(reference_state(law.example)[0])
    low, high = (0.85 * rest, 1.3 * rest) if inner is not None else law.box["rho"]
    if law.name == "grain_contact":
        low, high = 0.9 * law.example.contact_density, 1.06 * law.example.contact_density
    if law.name == "tillotson":
        low, high = 0.3 * rest, 1.6 * rest      # it is meant for vapour too
    gas = "gas" in law.flags
    rho = np.geomspace(low, high, 301) if gas else np.linspace(low, high, 301)
    lines = [np.array([pressure(r, e, law.example) for r in rho.tolist()]) for e in energies(law)]
    factor, unit = shown_pressure(np.abs(lines))
    for k, (e, p) in enumerate(zip(energies(law), lines)):
        ax.plot(rho * 1e-3, np.where(p > 0.0, p, np.nan) * factor if gas else p * factor, color=COLOURS[k])
        if inner is not None:
            ax.plot(rho * 1e-3, [pressure(r, e, inner) * factor for r in rho.tolist()], color=COLOURS[k], ls=(0, (3, 2)), lw=0.8)
    if gas:
        ax.set(xscale="log", yscale="log")
        for axis in (ax.xaxis, ax.yaxis):
            axis.set_major_formatter(lambda value, _: f"{value:g}")
            axis.set_minor_formatter(lambda value, _: "")
    ax.margins(x=0.0)
    names = [f"{e * 1e-6:.3g} MJ/kg" for e in energies(law)]
    if gas:
        for k, name in enumerate(names):
            ax.annotate(name, (0.03, 0.80 + 0.085 * k), xycoords="axes fraction", color=COLOURS[k], fontsize=8.5, va="top")
    else:
        label_lines(ax, names, [p[-1] * factor for p in lines], COLOURS)
    ax.set(xlabel="density (g/cm³)", ylabel=f"pressure ({unit})")
    ax.set_title("at constant energy" + ("; dashed: the base law" if inner is not None else ""), loc="left", color=QUIET, fontsize=8.5)


def crushing(law, ax) -> None:
    """First loading at the rest energy up to closed pores, and elastic ways down from two points of it."""
    par = law.example
    start, e = (float(v) for v in reference_state(par))
    solid = float(reference_state(par.base)[0])
    rho = np.linspace(start, 1.03 * solid, 401)
    p = np.array([pressure(r, e, par) for r in rho.tolist()])
    ax.plot(rho * 1e-3, p * 1e-9, color=COLOURS[0])
    for share in (0.35, 0.7):
        k = int(np.argmin(np.abs(rho - (start + share * (solid - start)))))
        kept = unloading(remembered(compacted(0.0, rho[k], e, p[k], par), par))
        down = np.linspace(float(reference_state(kept)[0]), rho[k], 30)
        ax.plot(down * 1e-3, [pressure(r, e, kept) * 1e-9 for r in down.tolist()], color=COLOURS[1], lw=1.1)
    beyond = np.linspace(solid, rho[-1], 50)
    ax.plot(beyond * 1e-3, [pressure(r, e, par.base) * 1e-9 for r in beyond.tolist()], color=QUIET, lw=0.9, ls=(0, (3, 2)))
    ax.set(xlabel="density (g/cm³)", ylabel="pressure (GPa)", ylim=(0.0, 1.6e-9 * float(np.interp(solid, rho, p))))
    words = (("first loading", COLOURS[0]), ("unloading and reloading", COLOURS[1]), ("dashed: the solid", QUIET))
    for k, (text, colour) in enumerate(words):
        ax.annotate(text, (0.03, 0.97 - 0.085 * k), xycoords="axes fraction", va="top", color=colour, fontsize=8.5)
    ax.set_title("at the reference energy", loc="left", color=QUIET, fontsize=8.5)


def draw(law, target: Path) -> str:
    """P-up Hugoniot of the example from rest, or for products the isentrope from the CJ point, above the pressure against the density."""
    with matplotlib.rc_context({**RC, "savefig.dpi": 180}):
        ax, below = new_panels(2, 1, 4.6, 5.6)[:, 0]
        (crushing if "remembers" in law.flags else lines_of_energy)(law, below)
        if "reacted" in law.flags:
            point = cj(law.example)
            rho0 = float(reference_state(law.example)[0])
            volume = np.geomspace(rho0 / point.state.density, 8.0, 120)
            p = isentrope(law.example, point.state, density=rho0 / volume).pressure
            ax.loglog(volume, p * 1e-9, color=COLOURS[0])
            ax.plot(volume[0], p[0] * 1e-9, "o", color=COLOURS[0], ms=4.5)
            ax.set(xlabel="relative volume", ylabel="pressure (GPa)")
            ax.set_xticks([1, 2, 4, 8], ["1", "2", "4", "8"])
            ax.minorticks_off()
            ax.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
            words = f"release from the CJ point, D = {point.detonation_velocity * 1e-3:.3f} km/s"
            ax.set_title(words, loc="left", color=QUIET, fontsize=8.5)
        else:
            found = hugoniot_points(law)
            if found is None:
                raise ValueError(f"{law.name}: the example has no Hugoniot to draw")
            factor, unit = shown_pressure(found[1])
            fast = found[0][-1] >= 1000.0
            ax.plot(found[0] * (1e-3 if fast else 1.0), found[1] * factor, color=COLOURS[0])
            ax.set(xlabel=f"particle velocity ({'km/s' if fast else 'm/s'})", ylabel=f"pressure ({unit})", xlim=(0, None), ylim=(0, None))
            words = "Hugoniot of the example"
            if end_inside(law):
                inner = curve(law.example.base, up_to=0.999 * end_inside(law))
                up = inner.particle_velocity * (1e-3 if fast else 1.0)
                ax.plot(up, inner.pressure * factor, color=COLOURS[0], ls=(0, (3, 2)), lw=0.8)
                words = "Hugoniot of the example; dashed: the base law, to its limit"
            ax.set_title(words, loc="left", color=QUIET, fontsize=8.5)
        ax.get_figure().savefig(target / f"{law.name}.png")
    return f"{law.name}.png"
