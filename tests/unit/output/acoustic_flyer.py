"""An exact spalling flyer in linear acoustics, recorded like a solver's run: what the tests of output, plots and report feed on.

One step moves every Riemann invariant p +- Z u by exactly one zone, so waves, reflections and the spall are exact: where a
tension reaches the strength the plane is split into two free faces. The flyer starts with a triangular wave of peak Z U / 2
that runs to the right; the free surface jumps to U and slows down, and the pull-back after a spall of strength S is 2 S / Z,
to within the one zone by which the wave varies.
"""


import numpy as np

from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.materials.material import Material, Source
from hugoniot.output.run_folder import RunFolder
from hugoniot.problem.model import Gauge, Problem, Region

RHO, C, IMPACT, STRENGTH = 2700.0, 5200.0, 200.0, 0.5e9
DECK = 'title = "Acoustic flyer"\ngeometry = "planar"\n'


def problem(flyer=60, target=120, width=1e-5):
    edge = flyer * width
    material = Material("al", IdealGas(1.4), sources=(Source("eos.gamma", 1.4, "1", "A table of the tests", status="recalled"),),
                        warnings=("a stand-in material",))
    return Problem(
        title="Acoustic flyer", geometry="planar", stop_time=4 * target * width / C,
        regions=(Region("flyer", "al", 0.0, edge, flyer, velocity=IMPACT), Region("target", "al", edge, edge + target * width, target)),
        materials={"al": material},
        gauges=(Gauge("middle", edge + 0.5 * target * width), Gauge("free surface", "free surface right")),
    )


class AcousticFlyer:
    """The state and its step; `payload` and `restore` are its checkpoint."""

    def __init__(self, flyer=60, target=120, width=1e-5, strength=STRENGTH):
        self.problem = problem(flyer, target, width)
        n = self.n = flyer + target
        self.width, self.strength, self.dt = width, strength, width / C
        self.u = np.where(np.arange(n) < flyer, 0.5 * IMPACT * (np.arange(n) + 1) / flyer, 0.0)
        self.p = RHO * C * self.u
        self.energy = RHO * width * np.sum(self.u**2)
        self.left = np.arange(n) * width
        self.right = self.left + width
        self.split = np.zeros(n + 1)
        self.split[[0, n]] = 1.0
        self.time, self.cycle = 0.0, 0
        self.peak = np.zeros(n)

    def step(self, folder=None):
        impedance = RHO * C
        plus, minus = self.p + impedance * self.u, self.p - impedance * self.u
        right_going, left_going = np.append(0.0, plus), np.append(minus, 0.0)
        tension = -(right_going + left_going) / 2
        opening = (tension > self.strength * (1 + 1e-12)) & (self.split == 0)
        if opening.any():
            face = int(np.argmax(np.where(opening, tension, 0.0)))
            self.split[face] = 1.0
            if folder is not None:
                folder.event(self.time, self.cycle, "void_opened", f"spall plane at {self.left[face] * 1e3:.3f} mm", position=float(self.left[face]))
        # at a free face p = 0, so what arrives goes back with its sign changed
        into_right = np.where(self.split == 1, -left_going, right_going)
        into_left = np.where(self.split == 1, -right_going, left_going)
        plus, minus = into_right[:-1], into_left[1:]
        self.p, self.u = (plus + minus) / 2, (plus - minus) / (2 * impedance)
        self.face_left = (into_right[:-1] - left_going[:-1]) / (2 * impedance)
        self.face_right = (right_going[1:] - into_left[1:]) / (2 * impedance)
        self.left = self.left + self.dt * self.face_left
        self.right = self.right + self.dt * self.face_right
        self.peak = np.maximum(self.peak, self.p)
        self.cycle += 1
        self.time = self.cycle * self.dt

    def fields(self):
        rho = RHO * self.width / (self.right - self.left)
        return {"density": rho, "pressure": self.p, "stress": self.p, "velocity_left": self.face_left, "velocity_right": self.face_right,
                "position_left": self.left, "position_right": self.right}

    def gauge_row(self):
        k = self.n - (self.n * 2 // 3) // 2
        return {"velocity": np.array([[self.u[k], self.face_right[-1]]]), "stress": np.array([[self.p[k], 0.0]])}

    def budget_row(self):
        mass = RHO * self.width
        kinetic = 0.5 * mass * np.sum(self.u**2)
        internal = 0.5 * np.sum(self.p**2) / (RHO * C * C) * self.width
        return {"kinetic_energy": np.array([kinetic]), "internal_energy": np.array([internal]),
                "energy_error": np.array([(kinetic + internal) / self.energy - 1])}

    def payload(self):
        return {"arrays": {k: getattr(self, k) for k in ("u", "p", "left", "right", "split", "peak")}, "cycle": self.cycle, "time": self.time}

    def restore(self, payload):
        for name, value in payload["arrays"].items():
            setattr(self, name, value)
        self.cycle, self.time = payload["cycle"], payload["time"]

    def meta(self):
        x = (np.arange(self.n) + 0.5) * self.width
        names = [r.name for r in self.problem.regions for _ in range(r.zones)]
        return {"solver": "acoustic", "version": "0", "region": names, "mass": np.full(self.n, RHO * self.width), "centre": x,
                "gauges": ["middle", "free surface"], "references": ["d'Alembert 1747"]}


def run(folder, *, resume=False, overwrite=False, checkpoint_every=0, cycles=480, snapshot_every=8, after_step=None, **size):
    """Run the flyer into `folder`; `after_step(flyer)` may raise or kill. Gives the recorder."""
    with RunFolder(folder, resume=resume, overwrite=overwrite) as recorder:
        flyer = AcousticFlyer(**size)
        recorder.start(flyer.problem, DECK, flyer.meta())
        payload = recorder.latest_checkpoint() if resume else None
        if payload:
            flyer.restore(payload)
        while flyer.cycle < cycles:
            flyer.step(recorder)
            recorder.gauges([flyer.time], flyer.gauge_row())
            recorder.budget([flyer.time], flyer.budget_row())
            if flyer.cycle % snapshot_every == 0:
                recorder.snapshots([flyer.time], [flyer.cycle], {k: v[None] for k, v in flyer.fields().items()})
            if checkpoint_every and flyer.cycle % checkpoint_every == 0:
                recorder.checkpoint(flyer.payload())
            if after_step:
                after_step(flyer)
        recorder.finish({"cycles": flyer.cycle, "time": flyer.time, "zone_updates": flyer.cycle * flyer.n, "wall_seconds": 0.1,
                         "kernel_seconds": 0.05, "mass_error": 0.0, "momentum_error": 0.0, "energy_error": 1e-15, "voids_opened": 1,
                         "voids_closed": 0}, {"stress": flyer.peak})
    return recorder
