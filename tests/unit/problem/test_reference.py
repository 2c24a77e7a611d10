"""The deck reference is made from the schema and the registries, and misses nothing."""

import subprocess
import sys
from pathlib import Path

from pace import PATIENCE

from hugoniot.core.fields import FIELDS
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT
from hugoniot.materials.tables import accepted, families
from hugoniot.problem.editor_schema import json_schema
from hugoniot.problem.solver_kinds import available_solvers

SCRIPT = Path(__file__).parents[3] / "docs" / "generate_deck_reference.py"


def test_every_key_law_parameter_and_field_is_in_the_reference(tmp_path):
    out = tmp_path / "deep" / "reference.md"
    subprocess.run([sys.executable, str(SCRIPT), "--out", str(out)], check=True, timeout=PATIENCE)
    text = out.read_text(encoding="utf-8")
    wanted = {f"`{name}`" for name in FIELDS}
    for kind in available_solvers():
        schema = json_schema(kind)
        wanted |= {f"`{key}`" for part in (schema, *schema["$defs"].values()) for key in part.get("properties", {})}
    for registry in (*families().values(), TRANSPORT, CONDUCTION):
        for law in registry:
            wanted |= {f'law = "{law.name}"', *(f"`{name}`" for name in accepted(law)[0])}
    assert not {w for w in wanted if w not in text}
