"""Every script of the gallery is short, runs, draws, and prints the numbers it promises."""

import re
import runpy
import warnings
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
SCRIPTS = sorted(path.name for path in EXAMPLES.glob("plot_*.py"))
# compile what no other test of this folder needs, or make hundreds of runs
HEAVY = ["plot_06_noh.py", "plot_20_pulsating_detonation.py", "plot_22_spall_fit.py", "plot_23_sobol_flyer.py",
         "plot_24_taylor_bar.py", "plot_25_cylinder_test.py", "plot_26_penetration.py"]
# what a script prints, by a pattern with one number, and where that number must lie
PROMISED = {
    "plot_01_spalling_flyer.py": [(r"largest tension ([\d.]+) GPa", 0.99, 1.05), (r"voids (\d+)", 2, 2), (r"acoustic ([\d.]+) GPa: the acoustic strength is a lower bound", 0.35, 0.42)],
    "plot_02_gap_closing.py": [(r"energy error (\S+),", 0.0, 1e-12), (r"momentum (\S+)", 0.0, 1e-12)],
    "plot_03_sandwich.py": [(r"first +([\d.]+) GPa", 1.979, 1.999), (r"first +\S+ GPa ([\d.]+) m/s", 497.3, 502.3),
                            (r"reshock +([\d.]+) GPa", 4.177, 4.219), (r"end +([\d.]+) GPa", 10.73, 10.85)],
    "plot_04_precursor.py": [(r"elastic limit ([\d.]+)", 0.6327, 0.6391), (r"behind +([\d.]+)", 6.629, 6.643)],
    "plot_07_sedov.py": [(r"peak density ([\d.]+)", 5.5, 6.05), (r"at r = ([\d.]+)", 0.997, 1.003)],
    "plot_08_shell.py": [(r"inner radius ([\d.]+) cm", 4.95, 5.05)],
    "plot_11_aluminum_hugoniot.py": [(r"fit at 30 km/s: ([\d.]+)", 3830, 3832)],
    "plot_12_second_shock.py": [(r"0.15: second shock ([\d.]+)", 16.6001, 16.6003), (r"0.20: second shock ([\d.]+)", 24.8563, 24.8565),
                                (r"0.25: second shock ([\d.]+)", 34.7519, 34.7521)],
    "plot_13_match_with_error_bars.py": [(r"pressure: ([\d.]+)", 12.06, 12.08), (r"particle_velocity: ([\d.]+)", 692.70, 692.74)],
    "plot_15_mixture_adiabat.py": [(r"rule: (\S+) Q", 0.0, 1e-4)],
    "plot_16_cold_curve_orders.py": [(r"copper: order 3, strain 0.3: (\S+) %", -21.3, -21.0), (r"copper: order 6, strain 0.3: (\S+) %", -1.6, -1.4),
                                     (r"silica powder, 100 kg/m³: order 3, strain 0.3: (\S+) %", -11.5, -11.0)],
    "plot_17_open_sandwich.py": [(r"M/C 0.2 +(\d+) m/s", 3062, 3384), (r"M/C 1 +(\d+) m/s", 1423, 1573), (r"M/C 5 +(\d+) m/s", 401, 443)],
    "plot_18_overdriven.py": [(r"front +(\d+) m/s", 8458, 8508), (r"pressure ([\d.]+) GPa", 50.25, 50.75)],
    "plot_19_porous_loop.py": [(r"unloading, sqrt\(dp/drho\): (\d+) m/s", 5200, 5500), (r"compaction ([\d.]+)", 0.684, 0.692), (r"curve gives ([\d.]+)", 0.684, 0.692)],
    "plot_21_attenuation.py": [(r"1.2 km/s.*: (\S+) without", 0.80, 1.06), (r"1.2 km/s.* (\S+) with\n", 0.55, 0.90),
                               (r"1.2 km/s.* shock at (\S+) flyers", 14.6, 14.9), (r"1.2 km/s.* elastic one at (\S+)", 7.6, 8.0)],
    "plot_22_spall_fit.py": [(r"chi-square ([\d.]+)", 0.8, 1.25), (r"velocity: .* difference ([\d.]+) sigma", 0.0, 3.5),
                             (r"fracture.strength: .* difference ([\d.]+) sigma", 0.0, 3.5), (r"shift: .* difference ([\d.]+) sigma", 0.0, 3.5)],
    "plot_23_sobol_flyer.py": [(r"arrival at 2 mm: mostly material.al.eos.c0, total index ([\d.]+)", 0.6, 1.1),
                               (r"free-surface velocity: mostly region.flyer.velocity, total index ([\d.]+)", 0.6, 1.15)],
    "plot_24_taylor_bar.py": [(r"length ([\d.]+) mm", 21.42, 21.66), (r"foot ([\d.]+) mm", 6.97, 7.24), (r"energy error: (\S+)", 0.0, 1e-12)],
    "plot_25_cylinder_test.py": [(r"after 6 mm: \d+ m/s, ([+-][\d.]+) %", -2.0, 2.0), (r"after 19 mm: \d+ m/s, ([+-][\d.]+) %", -2.0, 2.0)],
    "plot_26_penetration.py": [(r"penetration (\d+) m/s", 1160, 1250), (r"energy included: (\S+)", 0.0, 1e-12)],
    "plot_20_pulsating_detonation.py": [(r"period ([\d.]+)", 7.3, 7.5), (r"peaks +([\d.]+)", 97.5, 99.7)],
}


def draw(name, capsys, monkeypatch):
    """Run a script in its folder without a screen; its output."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.close("all")
    monkeypatch.chdir(EXAMPLES)
    with matplotlib.rc_context(), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "FigureCanvasAgg is non-interactive")
        runpy.run_path(str(EXAMPLES / name), run_name="__main__")
    figures = [plt.figure(number) for number in plt.get_fignums()]
    assert figures and all(figure.axes for figure in figures)
    for figure in figures:
        figure.canvas.draw()
    plt.close("all")
    return capsys.readouterr().out


def check(name, printed):
    for pattern, low, high in PROMISED.get(name, []):
        found = re.search(pattern, printed)
        assert found, f"{name} prints no {pattern}"
        assert low <= float(found[1]) <= high, f"{name}: {found[0]}"


@pytest.mark.parametrize("name", SCRIPTS)
def test_a_script_is_short_and_says_what_it_shows(name):
    text = (EXAMPLES / name).read_text()
    assert len(text.splitlines()) < 80
    assert re.match(r'"""\n.+\n=+\n\n\S', text)


@pytest.mark.parametrize("name", SCRIPTS)
def test_a_figure_is_finished_in_the_block_that_begins_it(name):
    """The documentation takes the picture at the end of each block: a panel drawn in a later one would stay empty there."""
    axes: set[str] = set()
    for block in re.split(r"^# %%", (EXAMPLES / name).read_text(), flags=re.MULTILINE):
        code = "\n".join(line for line in block.splitlines() if not line.startswith("#"))
        bound = {word for left in re.findall(r"^([\w, ()]+?) = ", code, flags=re.MULTILINE) for word in re.findall(r"\w+", left)}
        late = [axis for axis in axes - bound if re.search(rf"\b{axis}\b", code)]
        assert not late, f"{name} draws on {', '.join(late)} after the picture was taken"
        axes |= {word for left in re.findall(r"^(.+?) = .*\bsubplots\(", code, flags=re.MULTILINE) for word in re.findall(r"\w+", left)}


@pytest.mark.parametrize("name", [pytest.param(name, marks=pytest.mark.slow) if name in HEAVY else name for name in SCRIPTS])
def test_a_script_runs_draws_and_keeps_its_promises(name, capsys, monkeypatch):
    check(name, draw(name, capsys, monkeypatch))


def test_the_promises_are_of_scripts():
    assert set(PROMISED) <= set(SCRIPTS)
