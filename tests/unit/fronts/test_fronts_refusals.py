"""Every refusal of tracked fronts gives its reason and what to do instead."""

import dataclasses
import re
from types import MappingProxyType

import pytest

from hugoniot.errors import DeckError
from hugoniot.laws.burn.arrhenius import Arrhenius
from hugoniot.problem import fronts
from hugoniot.problem.deck import read_deck_text

PLATE = """
stop_time = "1 us"
[[region]]
name = "plate"
material = "al"
from = "0 mm"
to = "2 mm"
zones = 4
[material.al.eos]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5200 m/s"
s = 1.5
gamma0 = 2.0
[solver]
kind = "fronts"
[solver.options]
mode = "MODE"
"""
STRENGTH = '[material.al.strength]\nlaw = "LAW"\nshear_modulus = "24.8 GPa"\nyield_stress = "0.30 GPa"\n'
HARDENING = STRENGTH.replace("LAW", "linear_hardening") + 'hardening_modulus = "1 GPa"\n'
FRACTURE = '[material.al.fracture]\nlaw = "spall_stress"\nstrength = "1 GPa"\n'
PULL = '[boundary]\nleft = {pressure = "-1 GPa"}\n'
RAMP = '[boundary]\nleft = {velocity = {shape = "ramp", amplitude = 10, duration = 1e-6}}\n'


@pytest.mark.parametrize("mode, more, reason, remedy", [
    ("algebraic", HARDENING, "no constant yield stress", "lagrange1d"),
    ("cells", FRACTURE, "cannot open a new surface", "lagrange1d"),
    ("cells", PULL, "open in tension", "give zero or more"),
    ("algebraic", RAMP, "a fan of its own", 'mode = "cells"'),
])
def test_a_refusal_has_its_reason_and_its_remedy(mode, more, reason, remedy):
    with pytest.raises(DeckError) as caught:
        read_deck_text(PLATE.replace("MODE", mode) + more)
    words = " ".join(str(caught.value).split())
    assert reason in words and remedy in words


def test_what_a_mode_cannot_describe_has_a_remedy():
    """Also of what no deck can say together with a run of this solver: the problem of another solver, asked of fronts."""
    problem = read_deck_text(PLATE.replace("MODE", "cells")).problem
    region = dataclasses.replace(problem.regions[0], velocity=(0.0, 1.0))
    curved = dataclasses.replace(problem, geometry="spherical", regions=(region,), solver=dataclasses.replace(
        problem.solver, courant=0.3, options=MappingProxyType({"mode": "algebraic"})))
    found = [message for _, message in fronts.defects(curved)]
    assert len(found) == 3 and all(re.search(r'mode = "cells"|leave courant out', message) for message in found)


def test_strength_is_followed_in_every_geometry():
    problem = read_deck_text(PLATE.replace("MODE", "cells") + STRENGTH.replace("LAW", "perfectly_plastic")).problem
    assert all(fronts.defects(dataclasses.replace(problem, geometry=name)) == [] for name in ("planar", "cylindrical", "spherical"))


def test_a_solid_that_burns_is_refused_in_cells():
    problem = read_deck_text(PLATE.replace("MODE", "cells") + STRENGTH.replace("LAW", "perfectly_plastic")).problem
    material = dataclasses.replace(problem.materials["al"], burn=Arrhenius(1e6, 1e3))
    found = [message for _, message in fronts.defects(dataclasses.replace(problem, materials={"al": material}))]
    assert any("burns and has strength" in message and "leave one of the two out" in message for message in found)
