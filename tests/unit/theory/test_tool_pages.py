"""The pages of the tools: every command of `hugoniot eos` and every exact solution has one, with its equations and functions."""

import importlib.util
import re
from pathlib import Path

import pytest

from hugoniot.cli.eos.app import app

DOCS = Path(__file__).parents[3] / "docs"


@pytest.fixture(scope="module")
def pages():
    spec = importlib.util.spec_from_file_location("generate_theory", DOCS / "generate_theory.py")
    module = importlib.util.module_from_spec(spec)
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(DOCS)      # it imports a script beside it
        spec.loader.exec_module(module)
    return module


def test_every_command_has_a_page_and_a_row_in_the_overview(pages):
    named = {command.name or command.callback.__name__ for command in app.registered_commands}
    paged = {words.split()[1] for _, _, _, commands in pages.TOOLS.values() for words in commands}
    assert named == paged
    overview = (DOCS / "theory" / "eos_tools.md").read_text(encoding="utf-8")
    rows = "\n".join(line for line in overview.splitlines() if line.startswith("| `"))
    assert not {name for name in named if f"`{name}" not in rows}
    assert not {page for page in re.findall(r"generated/tools/(\w+)\.md", rows) if page not in pages.TOOLS}


def test_a_page_shows_equations_and_functions(pages):
    for key in pages.TOOLS:
        text = pages.tool(key)
        assert ("$" in text or "theory/mixtures.md" in text) and "## Functions" in text and text.count("### ") >= 1, key
        assert "hugoniot." not in "".join(re.findall(r"```python\n(.*?)```", text, flags=re.DOTALL)), key


def test_a_page_shows_the_members_of_its_classes(pages):
    stability = pages.tool("stability")
    assert "* `modes(highest=3.0, spacing=0.25)`: " in stability and "ModesOfZone(material, initial, rate, overdrive, panel=0.5)" in stability
    assert "* `detonation_velocity`: " in pages.tool("chapman_jouguet") and "* `band(up)`: " in pages.tool("fits")


def test_no_signature_shows_an_address(pages):
    assert "solve=match)" in pages.tool("uncertainty")
    assert " at 0x" not in "".join(map(pages.tool, pages.TOOLS))


def test_every_exact_solution_has_its_parameters_with_units(pages):
    text = pages.exact("theory.exact.noh", ["noh"])
    assert "## hugoniot exact noh" in text and "| `speed` | m/s | `1.0` |" in text and "$$" in text
    for name, function in pages.SOLUTIONS.items():
        shown = pages.exact(function.__module__.removeprefix("hugoniot."), [name])
        assert f"## hugoniot exact {name}" in shown and "## Source" in shown and "|  |\n" not in shown, name


def test_paragraphs_for_developers_are_not_shown(pages):
    assert "Implementation:" in (pages.module("theory.exact.sedov").__doc__ or "")
    assert "Implementation:" not in "".join([*map(pages.tool, pages.TOOLS), pages.exact("theory.exact.sedov", ["sedov"])])
