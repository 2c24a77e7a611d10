"""No Python code calls a kernel that was compiled without a wrapper for Python: that would end the process."""

import ast
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COMPILES = ("njit", "overload", "zone_pass", "intrinsic", "only_if")
HANDS_OVER = ("Entry", "bind", "bind_choice", "bind_flag")      # what these are given is compiled, or chosen for kernels


def is_decorated(function: ast.FunctionDef, *words: str) -> bool:
    return any(word in ast.unparse(decorator) for decorator in function.decorator_list for word in words)


def name_of(node) -> str:
    """A name, or one with its module; nothing for what is neither."""
    if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
        return f"{node.value.id}.{node.attr}"
    return node.id if isinstance(node, ast.Name) else ""


def kernels_of(tree) -> set[str]:
    """Kernels without wrappers at the top of a module."""
    return {node.name for node in tree.body if isinstance(node, ast.FunctionDef) and is_decorated(node, "BY_ADDRESS")}


def compiled_otherwise(tree) -> set[str]:
    """Functions that are handed to what compiles them, or that overloads give back."""
    given = [node for node in ast.walk(tree) if isinstance(node, ast.Call) and name_of(node.func) in HANDS_OVER]
    given += [last for node in ast.walk(tree) if isinstance(node, ast.FunctionDef) and is_decorated(node, "overload")
              for last in ast.walk(node) if isinstance(last, ast.Return)]
    return {name.id for node in given for name in ast.walk(node) if isinstance(name, ast.Name)}


def calls(tree, known: set[str]) -> list[str]:
    """Calls of these (names, or names with their module) outside of kernels."""
    compiled, found = compiled_otherwise(tree), []

    def look(node):
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.FunctionDef) and (is_decorated(child, *COMPILES) or child.name in compiled):
                continue
            if isinstance(child, ast.Call) and name_of(child.func) in known:
                found.append(f"line {child.lineno}: {name_of(child.func)}")
            look(child)

    look(tree)
    return found


def test_python_calls_no_kernel_without_a_wrapper():
    texts = {path: path.read_text(encoding="utf-8") for room in ("src", "tests", "benchmarks") for path in (ROOT / room).rglob("*.py")}
    files = {path: text for path, text in texts.items() if "hugoniot.solvers" in text or "hugoniot.core" in text}
    modules = {".".join(path.relative_to(ROOT / "src").with_suffix("").parts): text for path, text in files.items() if ROOT / "src" in path.parents}
    # trees are parsed one at a time, and again below: together they take a hundred megabytes
    kernels = {name: found for name, text in modules.items() if "BY_ADDRESS" in text and (found := kernels_of(ast.parse(text)))}
    assert sum(map(len, kernels.values())) > 50
    wrong = {}
    for path, text in files.items():
        tree = ast.parse(text)
        known = kernels_of(tree)
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom):
                for alias in node.names:
                    name = alias.asname or alias.name
                    known |= {name} & {name if alias.name in kernels.get(node.module, ()) else ""}
                    known |= {f"{name}.{kernel}" for kernel in kernels.get(f"{node.module}.{alias.name}", ())}
        if known and (found := calls(tree, known)):
            wrong[str(path.relative_to(ROOT))] = found
    assert not wrong, wrong
