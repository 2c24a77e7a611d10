"""How the package is built: every law documented and cited, no stray output, no star imports, files of readable length."""

import ast
import pathlib
import re

import pytest

import hugoniot
from hugoniot.core.fields import FIELDS
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.mesh.line import GEOMETRY
from hugoniot.solvers.lagrange1d import layout

ROOT = pathlib.Path(hugoniot.__file__).parent
SOURCES = sorted(ROOT.rglob("*.py"))
FAMILIES = (EOS, STRENGTH, FRACTURE, VISCOSITY, BURN)
LAWS = [law for family in FAMILIES for law in family]
LONGEST, LONGEST_OF_SOLVERS = 400, 300
BY_THE_STEP = {"solvers", "zones", "core"}     # the rooms whose code runs in every step
MOST_ARGUMENTS = 12            # of a function in these rooms
RULES = {"threshold"}     # a rule (pressure above a limit), no equation


def parsed(path):
    return ast.parse(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_every_law_says_what_it_is_and_where_it_comes_from(law):
    text = law.module.__doc__ or ""
    assert len(text.split()) > 10 and law.references and all(len(r) > 5 for r in law.references)
    assert "$" in text or law.name in RULES, "the equation is missing"
    assert set(law.units) == set(law.meaning) and all(law.meaning.values())


def test_parameter_classes_have_names_of_their_own():
    """Compiled code tells arguments apart by the names of their classes; a second one of a name is numbered when it is registered."""
    names = [law.parameters.__name__ for law in LAWS]
    assert len(set(names)) == len(names) and not any(re.search(r"_\d+$", name) for name in names)


def test_every_family_is_populated():
    assert all(len(list(family)) >= 3 for family in FAMILIES) and len(list(GEOMETRY)) == 3


def broken_rules(path) -> list[str]:
    """The house rules that a source file does not keep, with the lines."""
    text, tree = path.read_text(encoding="utf-8"), parsed(path)
    place, found = path.relative_to(ROOT), []
    if text.strip() and not ast.get_docstring(tree):
        found.append(f"{place}: does not say what it is for")
    if len(text.splitlines()) > (LONGEST_OF_SOLVERS if place.parts[0] in BY_THE_STEP else LONGEST):
        found.append(f"{place}: too long")
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef) and place.parts[0] in BY_THE_STEP and len(node.args.args) + len(node.args.kwonlyargs) > MOST_ARGUMENTS:
            found.append(f"{place}:{node.lineno}: {node.name} has too many arguments")
        if isinstance(node, ast.ImportFrom) and any(name.name == "*" for name in node.names):
            found.append(f"{place}:{node.lineno}: star import")
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("print", "eval", "exec"):
            found.append(f"{place}:{node.lineno}: {node.func.id}")
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else [node.module or ""]
            if any(name.split(".")[0] == "pickle" for name in names):
                found.append(f"{place}:{node.lineno}: pickle")
    return found


def test_source_files_keep_the_house_rules():
    assert len(SOURCES) > 250 and not [words for path in SOURCES for words in broken_rules(path)]


def test_a_broken_rule_would_be_found(tmp_path, monkeypatch):
    monkeypatch.setitem(globals(), "ROOT", tmp_path)
    (tmp_path / "core").mkdir()
    path = tmp_path / "core" / "bad.py"
    many = ", ".join(f"a{k}" for k in range(MOST_ARGUMENTS + 1))
    path.write_text(f"from os import *\nimport pickle\ndef f({many}):\n    print(1)\n" + "\n" * LONGEST_OF_SOLVERS)
    assert [words.partition(": ")[2] for words in sorted(broken_rules(path))] == [
        "does not say what it is for", "too long", "star import", "pickle", "f has too many arguments", "print"]


LAW_FILES = [p for family in ("eos", "strength", "fracture", "viscosity") for p in sorted((ROOT / "laws" / family).glob("*.py"))
             if p.name not in ("__init__.py", "contract.py", "table.py")]


def test_laws_use_only_operations_that_kernels_can_pack():
    """No math.* or np.* arithmetic inside the scalar functions that a kernel inlines (`exp` of the library is a scalar call)."""
    inlined = ("pressure", "pressure_derivatives", "shear_modulus", "flow_stress", "failure", "damage_rate", "viscous_speed")
    seen, found = 0, []
    for path in LAW_FILES:
        for node in (node for node in ast.walk(parsed(path)) if isinstance(node, ast.FunctionDef) and node.name in inlined):
            seen += 1
            found += [f"{path.name}:{call.lineno} {call.value.id}.{call.attr}" for call in ast.walk(node)
                      if isinstance(call, ast.Attribute) and isinstance(call.value, ast.Name) and call.value.id in ("math", "np", "numpy")]
    assert seen > 60 and not found


def test_solvers_know_no_files_and_no_plots():
    """Also enforced by the import contracts; here against imports hidden in functions."""
    for path in (ROOT / "solvers").rglob("*.py"):
        for node in ast.walk(parsed(path)):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            for name in names:
                assert not re.match(r"(h5py|matplotlib|xarray|hugoniot\.(output|plotting|report|cli|campaign|simulate))", name), (path, name)


def test_the_tables_have_room_for_their_rows():
    """A row added to the layout without its count would silently be another row."""
    assert tuple(layout.Z) == tuple(range(len(layout.ZoneRows._fields))) and len(layout.GAUGE_FIELDS) == len(layout.GAUGE_ROWS_OF_ZONES) + 2
    assert set(layout.GAUGE_FIELDS) <= set(FIELDS)
