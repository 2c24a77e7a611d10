"""Results whose checksums are right and whose contents are not: each reader ends in one message that names the file and what is missing.

Every dataset and attribute of result.h5 is deleted, retyped, reshaped and linked elsewhere, every entry of the set-up and of the summary
deleted or exchanged, and all is signed again. A quick part of it runs with the ordinary tests.
"""

import random
import shutil

import pytest
from forging import altered, commands, forge, forgeries, other_setup, read_all, sign, told
from solver_decks import DECKS

from hugoniot import simulate
from hugoniot.errors import FileTrouble, HugoniotError
from hugoniot.files import Hdf5Texts, hdf5_texts_end
from hugoniot.output.run import load
from hugoniot.output.seal import sealed_json
from hugoniot.problem import catalogue

SOLVERS = {"line": catalogue.deck_text("sod").replace("zones = 100", "zones = 20"), "spalling line": DECKS["line"],
           "plane": DECKS["plane"].replace('stop_time = "0.6 us"', 'stop_time = "0.2 us"'), "fronts": DECKS["algebraic fronts"],
           "fronts in cells": DECKS["fronts in cells"]}
QUICK = ("line", "plane", "fronts")
slow = pytest.mark.slow


@pytest.fixture(scope="module")
def solved(tmp_path_factory):
    """Function from a name of SOLVERS to its finished run."""
    folder, done = tmp_path_factory.mktemp("solved"), {}

    def run(name):
        if name not in done:
            (folder / f"{name}.toml").write_text(SOLVERS[name])
            done[name] = folder / name
            simulate.run(folder / f"{name}.toml", done[name], report=False)
        return done[name]

    return run


def check(whole, folder, what, every):
    """No reader of a forged run fails otherwise than in words; the messages of those that refuse it."""
    plane, refused = "axes" in load(whole).setup, []
    for words in commands(whole, folder, plane, every):
        code, err = told(*words)
        assert code in (0, 2, 4) and "unexpected" not in err and "Traceback" not in err and "\x1b" not in err, (what, words, err)
        refused += [err] if code else []
    try:
        read_all(folder, every)
    except HugoniotError as error:
        refused.append(str(error))
    return refused


def check_results(whole, tmp_path, wanted, every):
    found = list(forgeries(whole))
    chosen = found if wanted is None else random.Random(wanted).sample(found, wanted)
    for what, where, change in chosen:
        if not forge(whole, tmp_path / "run", change):
            continue
        refused = check(whole, tmp_path / "run", (what, where), every)
        if what in ("without", "a group", "linked", "lies elsewhere", "never written"):
            assert refused and all("result.h5" in err and where.partition("/")[0] in err for err in refused if "--" not in err), (what, where, refused)


def check_documents(whole, tmp_path, wanted, every):
    run, folder = load(whole), tmp_path / "run"
    cases = [(True, *case) for case in altered(run.setup)] + [(False, *case) for case in altered(run.summary)]
    for setup, what, where, document in cases if wanted is None else random.Random(wanted).sample(cases, wanted):
        if setup:
            assert forge(whole, folder, other_setup(document))
        else:
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(whole, folder)
            (folder / "summary.json").write_text(sealed_json(document))
        check(whole, folder, (setup, what, where), every)


@pytest.mark.parametrize("name", QUICK)
def test_some_changes_of_a_result_are_refused_in_words(solved, tmp_path, name):
    check_results(solved(name), tmp_path, 8, False)


@pytest.mark.parametrize("name", QUICK)
def test_some_changes_of_set_up_and_summary_are_refused_in_words(solved, tmp_path, name):
    check_documents(solved(name), tmp_path, 4, False)


@slow
@pytest.mark.parametrize("name", SOLVERS)
def test_every_change_of_a_result_is_refused_in_words(solved, tmp_path, name):
    check_results(solved(name), tmp_path, None, False)


@slow
@pytest.mark.parametrize("name", SOLVERS)
def test_every_reader_refuses_a_hundred_changes_in_words(solved, tmp_path, name):
    check_results(solved(name), tmp_path, 100, True)
    check_documents(solved(name), tmp_path, 40, True)


@pytest.mark.parametrize("name", ["kind", "end_time", "strength"])
def test_a_list_of_fronts_without_a_column_is_refused_in_words(solved, tmp_path, name):
    folder = shutil.copytree(solved("fronts"), tmp_path / "run")
    head, *lines = (folder / "fronts.csv").read_text().splitlines()
    k = head.split(",").index(name)
    (folder / "fronts.csv").write_text("".join(",".join(cell for n, cell in enumerate(line.split(",")) if n != k) + "\n" for line in (head, *lines)))
    sign(folder, load(solved("fronts")).summary, "fronts.csv")
    code, err = told("plot", folder, "xt", "--out", tmp_path / "picture.png")
    assert code == 4 and f"fronts.csv: not written by hugoniot, or damaged (the column '{name}' is missing)" in err


def test_a_gauge_column_that_is_gone_is_named(solved, tmp_path):
    assert forge(solved("line"), tmp_path / "run", lambda file: file.__delitem__("gauges/velocity"))
    with pytest.raises(FileTrouble, match=r"result.h5: not written by hugoniot, or damaged \(gauges: the dataset 'velocity' is missing\)"):
        load(tmp_path / "run").gauge("velocity")
    for words in (("info", tmp_path / "run"), ("plot", tmp_path / "run", "gauge"), ("report", tmp_path / "run"), ("compare", tmp_path / "run", solved("line"))):
        code, err = told(*words)
        assert code == 4 and "gauges: the dataset 'velocity' is missing" in err


def test_texts_without_an_end_are_not_begun_with(solved, tmp_path):
    """HDF5 goes from an object of size 0 to itself for ever."""
    folder = shutil.copytree(solved("line"), tmp_path / "run")
    data = bytearray((folder / "result.h5").read_bytes())
    heap = data.find(b"GCOL\x01")
    data[heap + 16:heap + 18], data[heap + 24:heap + 32] = bytes(2), bytes(8)
    (folder / "result.h5").write_bytes(data)
    sign(folder, load(solved("line")).summary)
    code, err = told("info", folder)
    assert heap > 0 and code == 4 and "its strings are not terminated" in err


def test_a_file_is_looked_through_in_pieces(tmp_path):
    """Mapped as a whole, a result of 14 GB took as much memory."""
    texts, data = Hdf5Texts(), b"GCOL\x01".rjust(100, b"-") + (4096).to_bytes(11, "big") + bytes(5000)
    assert data.find(b"GCOL") == 95
    for piece in (data[:97], data[97:98], data[98:]):
        texts.feed(piece)
    (tmp_path / "file").write_bytes(data.replace((4096).to_bytes(11, "big"), bytes(3) + (4096).to_bytes(8, "little")))
    assert texts._places == [95] and not texts.end(tmp_path / "file") and not hdf5_texts_end(tmp_path / "file")
