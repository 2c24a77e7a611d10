"""A small deck to vary, and an engine that answers in the process of the test."""

import pytest
from aluminium_decks import EOS, FRACTURE, STRENGTH, gauge, impact

DECK = f"""
title = "small flyer"
stop_time = "1.5 us"
{impact(8, 16)}{EOS}{STRENGTH}{FRACTURE}{gauge("free surface", "free surface right")}\
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
