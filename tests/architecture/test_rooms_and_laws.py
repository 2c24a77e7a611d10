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


@pytest.mark.parametrize("path", SOURCES, ids=lambda p: str(p.relative_to(ROOT)))
def test_a_source_file_keeps_the_house_rules(path):
    text, tree = path.read_text(encoding="utf-8"), parsed(path)
    assert ast.get_docstring(tree) or not text.strip(), "a module says what it is for"
    place = path.relative_to(ROOT)
    longest = LONGEST_OF_SOLVERS if place.parts[0] in BY_THE_STEP else LONGEST
    assert len(text.splitlines()) <= longest
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef) and place.parts[0] in BY_THE_STEP:
            assert len(node.args.args) + len(node.args.kwonlyargs) <= MOST_ARGUMENTS, node.name
        if isinstance(node, ast.ImportFrom):
            assert all(name.name != "*" for name in node.names), "star import"
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            assert node.func.id not in ("print", "eval", "exec"), f"{node.func.id} at line {node.lineno}"
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else [node.module or ""]
            assert not any(name.split(".")[0] == "pickle" for name in names)


LAW_FILES = [p for family in ("eos", "strength", "fracture", "viscosity") for p in sorted((ROOT / "laws" / family).glob("*.py"))
             if p.name not in ("__init__.py", "contract.py", "table.py")]


@pytest.mark.parametrize("path", LAW_FILES, ids=lambda p: p.stem)
def test_a_law_uses_only_operations_that_kernels_can_pack(path):
    """No math.* or np.* arithmetic inside the scalar functions that a kernel inlines (`exp` of the library is a scalar call)."""
    for node in ast.walk(parsed(path)):
        if isinstance(node, ast.FunctionDef) and node.name in ("pressure", "pressure_derivatives", "shear_modulus", "flow_stress", "failure",
                                                               "damage_rate", "viscous_speed"):
            for call in ast.walk(node):
                if isinstance(call, ast.Attribute) and isinstance(call.value, ast.Name):
                    assert call.value.id not in ("math", "np", "numpy"), f"{path.name}:{call.lineno} {call.value.id}.{call.attr}"


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
