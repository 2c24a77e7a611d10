"""What the audit of the sources names exists: laws, files, commands and entries of the list of source errors."""

import re
from pathlib import Path

import pytest
import typer

import hugoniot.laws.burn
import hugoniot.laws.eos
import hugoniot.laws.fracture
import hugoniot.laws.mixture
import hugoniot.laws.strength
import hugoniot.laws.transport
import hugoniot.laws.viscosity  # noqa: F401
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.problem.catalogue import problems

ROOT = Path(__file__).parents[2]
AUDIT = (ROOT / "docs" / "theory" / "audit.md").read_text(encoding="utf-8")
ERRORS = (ROOT / "docs" / "theory" / "source_errors.md").read_text(encoding="utf-8")
FAMILIES = {"eos": EOS, "strength": STRENGTH, "fracture": FRACTURE, "burn": BURN, "mixture": MIXTURE, "viscosity": VISCOSITY,
            "transport": TRANSPORT, "conduction": CONDUCTION}
MARKED = sorted(set(re.findall(r"`([^`]+)`", AUDIT)))
ROWS = [[cell.strip() for cell in line.strip("|").split("|")] for line in AUDIT.splitlines() if line.startswith("| ")]
ROWS = [row for row in ROWS if row[0] != "item"]


@pytest.mark.parametrize("name", [m for m in MARKED if m.split("/")[0] in ("tests", "src", "docs", "examples")])
def test_a_named_file_exists(name):
    assert (ROOT / name).is_file()


@pytest.mark.parametrize("name", [m for m in MARKED if re.fullmatch(r"[a-z]+:[a-z0-9_]+", m)])
def test_a_named_law_is_enrolled(name):
    family, law = name.split(":")
    assert law in FAMILIES[family].names()


@pytest.mark.parametrize("words", [m for m in MARKED if m.startswith("hugoniot ")])
def test_a_named_command_exists(words):
    from hugoniot.cli.eos.app import app as eos
    from hugoniot.cli.main import COMMANDS
    from hugoniot.cli.structure import app as structure

    _, first, *rest = words.split()
    groups = {"eos": eos, "structure": structure}
    if first in groups:
        assert rest[0] in typer.main.get_command(groups[first]).commands
    elif first == "init":
        assert rest[0] in [entry.name for entry in problems()]
    else:
        assert first in COMMANDS


def test_every_item_has_a_status_and_what_shows_it():
    for item, status, shown in ROWS:
        assert re.match(r"done|corrected|partly|not built", status), item
        assert shown.startswith("`") or status.startswith("not built"), item
    assert len(ROWS) > 70


def test_every_correction_that_is_named_is_in_the_list():
    named = set(re.findall(r"\b([WKHSJ]-E\d+)\b", AUDIT))
    assert len(named) > 40 and all(f"| {name} |" in ERRORS for name in named)
