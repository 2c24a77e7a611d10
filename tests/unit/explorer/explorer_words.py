"""The token and the host with which the tests ask, and a deck that runs in a moment, or for long with another stop time."""

import json
import math

TOKEN, HOST = "a" * 32, "127.0.0.1:8123"
LONG = '"20 ms"'
TUBE = """title = "Tube / of \\"gas\\""
stop_time = "20 us"
[[region]]
name = "left"
material = "gas"
from = "0 mm"
to = "10 mm"
zones = 20
pressure = "2 bar"
density = "1 kg/m^3"
[[region]]
name = "right"
material = "gas"
from = "10 mm"
to = "20 mm"
zones = 20
pressure = "1 bar"
density = "1 kg/m^3"
[material.gas.eos]
law = "ideal_gas"
gamma = 1.4
[output]
report = false
checkpoint_cycles = 10
snapshots = "1 us"
"""
PLANE = """title = "<svg onload=alert(6)> plane"
geometry = "plane"
stop_time = "0.1 s"
[[block]]
name = "gas"
material = "gas"
x = [0.0, 1.0]
y = [0.0, 1.0]
zones = [8, 8]
density = 1.0
energy = 1e-3
velocity = {radial = "-1 m/s"}
[material.gas.eos]
law = "ideal_gas"
gamma = 1.6666666666666667
[[boundary]]
on = ["gas.left", "gas.bottom"]
kind = "wall"
[[boundary]]
on = ["gas.right", "gas.top"]
kind = "free"
[solver]
kind = "lagrange2d"
[output]
report = false
snapshots = "0.02 s"
"""


def write_fit(folder):
    """A folder as `hugoniot fit` writes it, with words that try to be HTML; gives the fit and the measured values."""
    times, sigma = [1e-8 * k for k in range(60)], 5.0
    model = [300.0 * (1.0 - math.exp(-t / 2e-7)) for t in times]
    data = [m + sigma * math.sin(7.0 * k) for k, m in enumerate(model)]
    names = ("material.ta.fracture.strength", "<img src=x onerror=alert(7)>")
    parameters = [{"name": names[0], "unit": "Pa", "value": 5.2e9, "sigma": 1.1e8, "low": 4.98e9, "high": 5.42e9, "profile_low": 4.97e9, "profile_high": 5.45e9},
                  {"name": names[1], "unit": "s", "value": 4e-9, "sigma": 1e-9, "low": 2e-9, "high": 6e-9, "profile_low": None, "profile_high": None}]
    fit = {"parameters": parameters, "correlation": [[1.0, 0.62], [0.62, 1.0]], "chi_square": 60.0, "degrees_of_freedom": 58, "reduced_chi_square": 1.03,
           "probability": 0.4, "matches": True, "others": [{"values": [3.1e9, 1e-9], "chi_square": 300.0}], "doubts": [], "notes": ["<b>note</b>"], "runs": 84,
           "targets": [{"label": "visar.csv: velocity", "name": "free surface.velocity", "points": 60}, {"label": "arrival", "name": "free surface.arrival", "unit": "s", "points": 1},
                       {"label": "wedge.csv", "name": "pop plot 1.distance", "unit": "m", "points": 2}]}
    rows = [("visar.csv: velocity", t, d, m, sigma, (m - d) / sigma) for t, d, m in zip(times, data, model)] + [("arrival", math.nan, 6.9e-7, 6.88e-7, 1e-8, -0.2)]
    rows += [("wedge.csv", p, x, 1.02 * x, 0.05 * x, 0.4) for p, x in ((8e9, 2e-3), (14e9, 9e-4))]
    folder.mkdir(parents=True)
    (folder / "fit.json").write_text(json.dumps(fit))
    (folder / "residuals.csv").write_text("target,time [s],data,model,sigma,residual\n" + "".join(f"{a},{','.join(repr(v) for v in rest)}\n" for a, *rest in rows))
    (folder / "fitted.toml").write_text(TUBE)
    return fit, data


STEEL = """title = "<b>my</b> steel"
[eos]
law = "mie_gruneisen"
rho0 = "7850 kg/m^3"
c0 = "4600 m/s"
s = 1.5
gamma0 = 2.0
specific_heat = "450 J/kg/K"
"""
