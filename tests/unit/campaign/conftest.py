"""A small deck to vary, and an engine that answers in the process of the test."""

import pytest

DECK = """
title = "small flyer"
stop_time = "1.5 us"
[[region]]
name = "flyer"
material = "al"
from = "0 mm"
to = "2 mm"
zones = 8
velocity = "700 m/s"
[[region]]
name = "target"
material = "al"
from = "2 mm"
to = "6 mm"
zones = 16
[material.al.eos]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5200 m/s"
s = 1.5
gamma0 = 2.0
[material.al.strength]
law = "perfectly_plastic"
shear_modulus = "24.8 GPa"
yield_stress = "0.30 GPa"
[material.al.fracture]
law = "spall_stress"
strength = "1.0 GPa"
[[gauge]]
name = "free surface"
at = "free surface right"
[output]
snapshots = "0.5 us"
"""


class Inline:
    """Answers cases one after the other in this process; counts those it had to work out."""

    worked_out = 0

    def __init__(self, question, known=()):
        from hugoniot.campaign.questions import question_of

        self.question, self.known = question_of(question), set(known)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def run(self, tasks):
        for case, changes in tasks:
            answer = self.question.answer(changes, self.known)
            Inline.worked_out += "numbers" in answer
            yield {"case": case, **answer}


@pytest.fixture
def inline():
    Inline.worked_out = 0
    return Inline


@pytest.fixture
def deck(tmp_path):
    path = tmp_path / "flyer.toml"
    path.write_text(DECK)
    return path
