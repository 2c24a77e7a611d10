"""The JSON Schema editors get says what the reader accepts."""

import json

import pytest

from hugoniot.materials.tables import families
from hugoniot.problem.editor_schema import json_schema
from hugoniot.problem.solver_kinds import SOLVERS, available_solvers


def test_it_is_json_and_holds_every_law_with_its_parameters():
    schema = json.loads(json.dumps(json_schema()))
    for family, registry in families().items():
        titles = {alternative.get("title") for alternative in schema["$defs"][f"{family}_law"]["anyOf"]}
        assert titles >= {law.name for law in registry}
    flyer = next(a for a in schema["$defs"]["eos_law"]["anyOf"] if a.get("title") == "mie_gruneisen")
    assert set(flyer["required"]) == {"law", "rho0", "c0", "s", "gamma0"}
    assert flyer["properties"]["c0"]["unit"] == "m/s"


def test_every_key_is_described():
    schema = json_schema()
    tables = [schema, *(d for d in schema["$defs"].values() if "properties" in d and "title" in d)]
    for table in tables:
        for key, entry in table["properties"].items():
            assert entry.get("description"), f"{table['title']}.{key} has no description"


@pytest.mark.parametrize("kind", available_solvers())
def test_every_solver_has_a_model(kind):
    assert kind in SOLVERS
    assert json_schema(kind)["properties"]
