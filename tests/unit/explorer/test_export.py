"""The exported page: every answer it may need lies beside it as a script, and nothing else does."""

import base64
import json
import re

import numpy as np
import pytest
from explorer_words import STEEL

import hugoniot
from hugoniot.errors import FileTrouble
from hugoniot.explorer import subjects
from hugoniot.explorer.export import export, key_of
from hugoniot.page import files


def answers(folder):
    """Key -> what the scripts of an export hand to the page."""
    index = json.loads((folder / "data" / "data.js").read_text()[len("window.hugoniotFiles="):-2])
    found = {}
    for key, name in index.items():
        text = (folder / name).read_text()
        match = re.fullmatch(r"hugoniotData\((\"[^\n]*?\"),(.*)\);\n", text, re.S)
        assert match and json.loads(match[1]) == key and "<" not in text
        found[key] = json.loads(match[2])
    return found


def test_an_export_holds_page_materials_and_runs(places, tube, tmp_path):
    folder = tmp_path / "page"
    (tmp_path / "my_steel.toml").write_text(STEEL)
    subjects.admit(tmp_path / "my_steel.toml")
    count = export(places, folder)
    assert count == sum(1 for p in folder.rglob("*") if p.is_file())
    found = answers(folder)
    assert found["start"]["files"] == {"my_steel": "my_steel.toml"} and str(tmp_path) not in (folder / "data" / "0000.js").read_text()
    assert found["start"]["materials"] == ["copper"] and found[key_of("material", {"name": "copper"})]["hugoniot"]["pressure"][1] > 0
    stored = found[key_of("array", {"run": 0, "group": "snapshots", "name": "pressure"})]
    doubles = np.frombuffer(base64.b64decode(stored["doubles"]), "<f8").reshape(stored["shape"])
    assert np.array_equal(doubles, hugoniot.load(tube).arrays("snapshots")["pressure"])
    assert key_of("sweep", {"sweep": 0}) in found and key_of("deck", {"deck": 0}) in found
    index = (folder / "index.html").read_text()
    assert "Content-Security-Policy" in index and index.index("data/data.js") < index.index("main.js")
    assert all((folder / name).read_bytes() == data for name, data in files.files().items())


def test_an_export_replaces_its_own_folder_and_no_other(places, tmp_path):
    folder = tmp_path / "page"
    export(places, folder)
    export(places, folder)
    mine = tmp_path / "mine"
    mine.mkdir()
    (mine / "thesis.txt").write_text("years of work")
    with pytest.raises(FileTrouble, match="not empty"):
        export(places, mine)
    assert [p.name for p in mine.iterdir()] == ["thesis.txt"]


def test_the_files_of_the_page_are_small_and_all_named():
    assert {p.name for p in files.STATIC.iterdir()} == {*files.files(), "index.html"}
    assert sum(len(data) for data in files.files().values()) < 250_000
