"""Fits without decks, and records made by runs, for the tests of fits and posteriors."""

import numpy as np

from hugoniot.campaign.fit import Free, Problem
from hugoniot.campaign.memory_run import MemoryRun
from hugoniot.campaign.questions import Deck
from hugoniot.campaign.targets import Target
from hugoniot.campaign.variables import read_variable

TIMES = np.linspace(0.0, 1.0, 201)


class Straight:
    """A plan whose changes are the values themselves."""

    def changes_of(self, values):
        return {"values": [float(value) for value in values]}


def problem(model, data, sigma, ranges, shift=0.0, scale=0.0, loss="linear", points=3001, times=TIMES):
    """A fit of model(times, *values) to data at times without any deck; points of the record of each run, which the fit keeps."""
    wide = np.linspace(-1.0, 2.0, points)

    def ask(changes):
        return [{"numbers": {}, "records": {"g.u": (wide, model(wide, *change["values"]))}} for change in changes]

    target = Target("record", "g.u", "m/s", times, data, np.full(times.size, sigma), 0)
    free = tuple(Free(read_variable(text)) for text in ranges)
    return Problem(Straight(), free, (target,), 1, shift, scale, loss, ask)


def line(t, a, b):
    return a + b * t


def bump(t, height, width):
    return height * np.exp(-0.5 * ((t - 0.5) / width) ** 2)


TRUTH = {"region.flyer.velocity": "720 m/s", "material.al.fracture.strength": "0.9 GPa"}
FREE = ["region.flyer.velocity = 600..850 m/s", "material.al.fracture.strength = 0.5..1.5 GPa"]


def record(deck, changes=TRUTH, sigma=5.0, shift=8e-9, count=200):
    run = MemoryRun(Deck(deck.read_text(), deck.name).read(changes).problem)
    time, velocity = run.gauge("velocity", "free surface")
    at = np.linspace(0.4e-6, 1.4e-6, count)
    return at, np.interp(at - shift, time, velocity) + sigma * np.random.default_rng(11).standard_normal(count)


def written(path, at, values, head="time [us], velocity [m/s]"):
    path.write_text(head + "\n" + "".join(f"{t * 1e6!r}, {v!r}\n" for t, v in zip(at.tolist(), values.tolist())))
    return str(path)
