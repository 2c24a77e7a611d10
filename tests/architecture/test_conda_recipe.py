"""The conda recipe asks for what the wheel asks for."""

import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
RENAMED = {"matplotlib": "matplotlib-base"}     # without a window system


def test_the_recipe_has_the_dependencies_of_the_package():
    wanted = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    asked = {re.split(r"(?=[><=])", text, maxsplit=1)[0].strip(): text for text in wanted["dependencies"]}
    recipe = (ROOT / "conda" / "meta.yaml").read_text().split("  run:\n")[1].split("\ntest:")[0]
    lines = {line.strip("- ").replace(" ", "") for line in recipe.splitlines() if line.strip()}
    assert lines == {text.replace(name, RENAMED.get(name, name), 1) for name, text in asked.items()} | {f"python{wanted['requires-python']}"}
