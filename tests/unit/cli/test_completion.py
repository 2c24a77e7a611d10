"""Completion by the shell: commands, commands of a group, options of a command."""

import os
import subprocess
import sys

import pytest
from pace import PATIENCE


@pytest.mark.parametrize("typed, found", [("hugoniot ma", {"material"}), ("hugoniot material s", {"search", "show"}),
                                          ("hugoniot run --over", {"--overwrite"})])
def test_words_are_completed(typed, found):
    environment = {**os.environ, "_HUGONIOT_COMPLETE": "complete_bash", "COMP_WORDS": typed, "COMP_CWORD": str(len(typed.split()) - 1)}
    done = subprocess.run([sys.executable, "-m", "hugoniot.cli.main"], env=environment, capture_output=True, text=True, timeout=PATIENCE)
    assert set(done.stdout.split()) == found
