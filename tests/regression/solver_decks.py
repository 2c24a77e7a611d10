"""Decks of runs that are killed and resumed: every solver, with spalling, contact, or fronts that meet."""

from aluminium_decks import EOS, FRACTURE, STRENGTH, gauge, impact


def flyer_deck(flyer=20, target=40, integrator="compatible", every=40):
    """A flyer whose target spalls, with its zones and the cycles between checkpoints."""
    return f"""title = "spalling flyer"
geometry = "planar"
stop_time = "2.2 us"
{impact(flyer, target, "2.01 mm", "6.01 mm")}{EOS}{STRENGTH}{FRACTURE}{gauge("middle", "4 mm")}{gauge("surface", "free surface right")}\
[solver]
integrator = "{integrator}"
[output]
snapshots = "0.1 us"
report = false
checkpoint_cycles = {every}
"""


PLATES = """\
title = "Two plates"
geometry = "axisymmetric"
stop_time = "1.2 us"

[[block]]
name = "flyer"
material = "al"
r = ["0 mm", "3 mm"]
z = ["0 mm", "1 mm"]
zones = [6, 4]
velocity = [0, "700 m/s"]

[[block]]
name = "target"
material = "al"
r = ["0 mm", "3 mm"]
z = ["1 mm", "3 mm"]
zones = [6, 8]

""" + EOS + STRENGTH + """
[[gauge]]
name = "inside"
at = ["1 mm", "2 mm"]

[solver]
kind = "lagrange2d"

[output]
snapshots = "0.1 us"
checkpoint_cycles = 5
"""
# the flyer tied to nothing, across another mesh, sliding with friction
SLIDING = PLATES.replace("zones = [6, 4]", "zones = [4, 4]").replace('[0, "700 m/s"]', '["10 m/s", "700 m/s"]').replace(
    'geometry = "axisymmetric"', 'geometry = "plane"').replace("r = ", "x = ").replace("z = ", "y = ") + """
[[contact]]
between = ["flyer", "target"]
friction = 0.2
"""
# mode of tracked fronts: (zones, options, steps or meetings between checkpoints)
MODES = {"algebraic": (20, ", fan_step = 0.05, weakest = 1e-6", 40), "cells": (60, "", 480)}


def fronts(mode, scale=1):
    """The deck of tracked fronts in a mode, with `scale` times the zones."""
    zones, more, every = MODES[mode]
    return f"""title = "plate on plate"
stop_time = "2.2 us"
{impact(scale * zones, scale * zones, "2.1 mm")}{EOS}{gauge("middle", "4 mm")}\
[solver]
kind = "fronts"
options = {{ mode = "{mode}"{more} }}
[output]
snapshots = "0.2 us"
checkpoint_cycles = {every}
"""


DECKS = {"line": flyer_deck().replace("report = false\n", ""),
         "plane": PLATES.replace("1.2 us", "0.6 us"), "contact": SLIDING.replace("1.2 us", "0.6 us"),
         "algebraic fronts": fronts("algebraic"), "fronts in cells": fronts("cells")}
