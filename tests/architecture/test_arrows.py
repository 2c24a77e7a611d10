"""Which file imports which: only downward, in no circle, and always by the plain statement that the layers' contract reads.

Imports inside functions count as those at the head of a file do.
"""

import ast
import functools
import pathlib
import tomllib
from typing import NamedTuple

import pytest

import hugoniot

ROOT = pathlib.Path(hugoniot.__file__).parent
CONTRACTS = tomllib.loads((pathlib.Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]["contracts"]
LAYERS = next(contract["layers"] for contract in CONTRACTS if contract["type"] == "layers")
RANK = {room.strip(" ()").removeprefix("hugoniot."): k for k, layer in enumerate(reversed(LAYERS)) for room in layer.split("|")}
BY_NAME = {"core/registry.py"}            # enrols every file of the folder it is given: the law files of a family


def module_name(path: pathlib.Path) -> str:
    parts = ("hugoniot", *path.relative_to(ROOT).with_suffix("").parts)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


FILES = {module_name(path): path for path in sorted(ROOT.rglob("*.py"))}

class Found(NamedTuple):
    """What a file says about other files: its arrows, the lines that import by a text, and the arguments it enrols laws with."""

    arrows: set[str]
    by_text: list[int]
    enrolled: list[list[str]]


@functools.cache
def sources() -> dict[str, Found]:
    """What every file of the package says. Each is parsed once, and its tree forgotten: all of them together take 160 MB."""
    return {name: looked_through(name, ast.parse(path.read_text(encoding="utf-8"))) for name, path in FILES.items()}


def looked_through(name: str, tree: ast.AST) -> Found:
    arrows = {target for node in ast.walk(tree) for target in targets(name, node)} - {name}
    enrolled = [[ast.unparse(argument) for argument in node.args] for node in ast.walk(tree)
                if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "enrol_folder"]
    return Found(arrows, string_imports(tree), enrolled)


def all_arrows() -> dict[str, set[str]]:
    return {name: found.arrows for name, found in sources().items()}


def targets(name: str, node: ast.AST) -> list[str]:
    """The modules of the package that an import statement names; of `from a import b` it is a.b where that is a file, else a."""
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names if alias.name.split(".")[0] == "hugoniot"]
    if not isinstance(node, ast.ImportFrom):
        return []
    base = node.module or ""
    if node.level:
        package = name.split(".") if FILES[name].name == "__init__.py" else name.split(".")[:-1]
        base = ".".join([*package[: len(package) - node.level + 1], *([base] if base else [])])
    if base.split(".")[0] != "hugoniot":
        return []
    return [f"{base}.{alias.name}" if f"{base}.{alias.name}" in FILES else base for alias in node.names]


def room(name: str) -> str:
    return name.split(".")[1] if "." in name else ""


def circle(arrows: dict[str, set[str]]) -> list[str]:
    """A circle of arrows, or nothing: nodes without arrows into what is left are taken away until none is."""
    left = {name: set(to) & set(arrows) for name, to in arrows.items()}
    while left:
        ends = [name for name, to in left.items() if not to]
        if not ends:
            path = [next(iter(left))]
            while path[-1] not in path[:-1]:
                path.append(sorted(left[path[-1]])[0])
            return path[path.index(path[-1]):]
        for name in ends:
            del left[name]
        for to in left.values():
            to.difference_update(ends)
    return []


def test_every_room_has_its_layer():
    rooms = {room(name) for name in FILES} - {""}
    assert rooms <= set(RANK), rooms - set(RANK)


def test_arrows_between_rooms_run_downward():
    """Rooms side by side do not know each other, and nothing but the command line imports the package's face."""
    upward = [f"{name} -> {target}" for name, found in all_arrows().items() for target in found
              if room(name) not in ("", room(target)) and (room(target) == "" or RANK[room(target)] >= RANK[room(name)])]
    assert not upward


def test_no_file_imports_itself_by_way_of_others():
    assert not circle(all_arrows())


def test_a_circle_would_be_found():
    assert circle({"a": {"b"}, "b": {"c"}, "c": {"d", "b"}, "d": set()}) in (["b", "c", "b"], ["c", "b", "c"])
    assert not circle({"a": {"b", "c"}, "b": {"c"}, "c": set()})


def string_imports(tree: ast.AST) -> list[int]:
    """Lines that import by a text: importlib.import_module and its like, __import__, sys.modules asked by a name of the package."""
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import) and any(alias.name == "importlib" or alias.name.startswith(("importlib.util", "importlib.machinery"))
                                                for alias in node.names):
            found.append(node.lineno)
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] in ("importlib", "pkgutil", "runpy"):
            found += [node.lineno] * (node.module != "importlib.resources" and node.module != "importlib.metadata")
        if isinstance(node, ast.Name) and node.id == "__import__":
            found.append(node.lineno)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value in FILES and "." in node.value:
            found.append(node.lineno)
    return found


def test_imports_are_statements():
    """A module loaded by its name as text is an arrow that no contract sees."""
    lines = {name: found.by_text for name, found in sources().items() if FILES[name].relative_to(ROOT).as_posix() not in BY_NAME}
    assert len(lines) > 250 and not {name: numbers for name, numbers in lines.items() if numbers}


@pytest.mark.parametrize("text", ["import importlib", "from importlib import import_module", "import importlib.util as u", "__import__('x')",
                                  "import sys\nsys.modules['hugoniot.output.run']", "PLACE = 'hugoniot.laws.burn.contract'"])
def test_an_import_by_text_would_be_found(text):
    assert string_imports(ast.parse(text))


def test_laws_enrolled_by_folder_are_of_their_own_room():
    """The one loader by name is given a package's own name and path, so that it cannot reach another room."""
    calls = {name: arguments for name, found in sources().items() for arguments in found.enrolled}
    assert calls and all(arguments == ["__name__", "__path__"] for arguments in calls.values()), calls
