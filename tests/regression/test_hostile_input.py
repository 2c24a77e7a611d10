"""Input that is huge, endless or made to break: a few clear messages, after work that grows with the length of the input and no faster.

Work is counted in calls of functions, so that no test depends on the speed of a machine.
"""

import json
import os
import sys

import h5py
import numpy as np
import pace
import pytest
from test_broken_decks import SOUND

from hugoniot import units
from hugoniot.campaign import designs, pop_target
from hugoniot.cli.main import main
from hugoniot.errors import DeckError, FileTrouble
from hugoniot.explorer import places
from hugoniot.files import hdf5_texts_end
from hugoniot.materials import collect, tables_io
from hugoniot.materials.table_hdf5 import read_table, write_table
from hugoniot.materials.users import read_materials
from hugoniot.output import compare
from hugoniot.problem import checks, profiles
from hugoniot.problem import deck as deck_reading
from hugoniot.problem.deck import read_deck, read_deck_text
from hugoniot.problem.ko_yaml import read_yaml
from hugoniot.theory.fits import read_points

unix = pytest.mark.skipif(sys.platform == "win32", reason="pipes and devices are a Unix matter")


def calls(text):
    """(problems shown, problems in all, functions called) of reading a deck."""
    count = 0

    def note(frame, event, argument):
        nonlocal count
        count += event in ("call", "c_call")

    problems, more = [], 0
    sys.setprofile(note)
    try:
        read_deck_text(text, "deck.toml")
    except DeckError as error:
        problems, more = error.problems, error.more
    finally:
        sys.setprofile(None)
    return len(problems), len(problems) + more, count


MANY = {
    "unknown keys": lambda n: "".join(f"key{k} = {k}\n" for k in range(n)) + SOUND,
    "unknown parameters": lambda n: SOUND.replace('law = "mie_gruneisen"\n', 'law = "mie_gruneisen"\n' + "".join(f"key{k} = {k}\n" for k in range(n))),
    "bad gauges": lambda n: SOUND + "".join(f'[[gauge]]\nname = "g{k}"\nat = "nowhere {k}"\n' for k in range(n)),
    "bad regions": lambda n: SOUND + "".join(f'[[region]]\nname = "g{k}"\nmaterial = "no{k}"\nfrom = "{k} mm"\nto = "1 mm"\nzones = 1\n' for k in range(n)),
    "unknown materials": lambda n: "stop_time = 1e-6\n" + "".join(
        f'[[region]]\nname = "g{k}"\nmaterial = "coper{k}"\nfrom = {k}.0\nto = {k + 1}.0\nzones = 1\n' for k in range(n)),
    "many regions and bad gauges": lambda n: MANY["sound regions and gauges"](n) + "".join(f'[[gauge]]\nname = "y{k}"\nat = "no {k}"\n' for k in range(n)),
    "interfaces of strangers": lambda n: SOUND + "".join(f'[[interface]]\nbetween = ["a{k}", "b{k}"]\n' for k in range(n)),
    "unknown laws": lambda n: SOUND + "".join(f'[material.m{k}.eos]\nlaw = "x{k}"\n' for k in range(n)),
    "unknown tables": lambda n: SOUND + "".join(f"[t{k}]\nx = 1\n" for k in range(n)),
    "sound regions and gauges": lambda n: 'stop_time = 1e-6\n' + "".join(
        f'[[region]]\nname = "g{k}"\nmaterial = "copper"\nfrom = {k}.0\nto = {k + 1}.0\nzones = 1\n' for k in range(n)) + "".join(
        f'[[gauge]]\nname = "x{k}"\nat = "g{k}/g{k + 1}"\n' for k in range(n - 1)),
}


@pytest.mark.parametrize("name", MANY)
def test_the_work_grows_no_faster_than_the_deck_and_fifty_problems_are_shown(name):
    read_deck_text(SOUND)
    calls(MANY[name](60))      # what is imported for the first message is no work of the deck's
    shown, total, few = calls(MANY[name](250))
    if name == "sound regions and gauges":
        assert total == 0
    else:
        assert shown == 50 and total > 50
    _, _, many = calls(MANY[name](1000))
    assert many < 5.0 * few


def test_the_count_of_all_problems_is_printed(tmp_path, capsys):
    path = tmp_path / "deck.toml"
    path.write_text(MANY["unknown keys"](400))
    with pytest.raises(SystemExit) as ended:
        main(["check", str(path)])
    told = capsys.readouterr().err
    assert ended.value.code == 2 and len(told.splitlines()) == 51
    assert told.splitlines()[-1] == "400 problems; the first 50 are shown"


def test_the_count_is_the_number_that_would_be_listed(monkeypatch):
    """2 000 bad gauges were "at least 51 problems"."""
    assert calls(MANY["bad gauges"](2000))[1] == calls(MANY["unknown parameters"](2000))[1] == 2000
    counts = {name: calls(make(75))[1] for name, make in MANY.items()}
    monkeypatch.setattr(collect, "MOST", 10**9)
    assert {name: calls(make(75))[0] for name, make in MANY.items()} == counts


def test_the_reading_of_a_hopeless_deck_ends_and_says_so(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(collect, "COUNTED", 1000)
    (tmp_path / "deck.toml").write_text(MANY["bad gauges"](2000))
    with pytest.raises(SystemExit):
        main(["check", str(tmp_path / "deck.toml")])
    assert capsys.readouterr().err.splitlines()[-1] == "at least 1000 problems; the first 50 are shown"
    with pytest.raises(SystemExit):
        main(["check", str(tmp_path / "deck.toml"), "--json"])
    told = json.loads(capsys.readouterr().out)
    assert (told["count"], told["at_least"], len(told["problems"])) == (1000, True, 50)


STRANGE = {
    "a key of ten thousand parts": SOUND + "a" + ".a" * 10_000 + " = 1\n",
    "a key of quoted parts": SOUND + '"a"' + ' . "b"' * 10_000 + " = 1\n",
    "a header of ten thousand parts": SOUND + "[a" + ".a" * 10_000 + "]\n",
    "an inline table of long keys": SOUND + "x = {a" + ".a" * 10_000 + " = 1}\n",
    "tables within tables": SOUND + "x = " + "{a=" * 150 + "1" + "}" * 150 + "\n",
    "a hexadecimal number of 3 600 digits": SOUND.replace("zones = 200", "zones = 0x" + "f" * 3600),
    "the same as a title": SOUND.replace('title = "Aluminium on aluminium"', "title = 0x" + "f" * 3600),
    "the same as a velocity": SOUND.replace('"700 m/s"', "0x" + "f" * 3600),
    "the same in an array": SOUND.replace('left = "free"', "left = {velocity = {times = [0, 0x" + "f" * 3600 + "], values = [0, 1]}}"),
    "a material of 300 letters": SOUND.replace('material = "al"', 'material = "' + "A" * 300 + '"'),
}


@pytest.mark.parametrize("name", STRANGE)
def test_strange_decks_are_refused_in_words(tmp_path, name):
    path = tmp_path / "deck.toml"
    path.write_text(STRANGE[name])
    with pytest.raises(DeckError) as caught:
        read_deck(path)
    assert 0 < len(caught.value.problems) < 5 and len(str(caught.value)) < 1000 and str(caught.value).replace("\n", "").isprintable()


@pytest.mark.parametrize("setting", ["a" + ".a" * 5_000 + "=1", "region" + ".flyer" * 5_000 + "=1", "stop_time=0x" + "f" * 3600,
                                     "stop_time=" + "[" * 5_000, "x={" + "a." * 5_000 + "a=1}"])
def test_strange_settings_are_refused_in_words(tmp_path, capsys, setting):
    (tmp_path / "deck.toml").write_text(SOUND)
    with pytest.raises(SystemExit) as ended:
        main(["check", str(tmp_path / "deck.toml"), "--set", setting])
    told = capsys.readouterr().err
    assert ended.value.code == 2 and "unexpected" not in told and len(told) < 1000


def test_what_two_blocks_of_one_name_lack_is_missed_in_both():
    """The second finding has the words of the first, is not listed twice, and counts all the same."""
    block = '[[block]]\nname = "a"\nmaterial = "copper"\nx = ["0 mm", "1 mm"]\nzones = [3, 3]\n'
    with pytest.raises(DeckError, match=r"block\.a\.y: missing"):
        read_deck_text('stop_time = "1 us"\n' + block + block + '[solver]\nkind = "lagrange2d"\n')


def test_a_direction_of_length_one_is_not_divided_by_its_length_again():
    """0.7071067811865475 twice has the length 0.9999999999999998, and divided by that it would be another number each time it is read."""
    deck = ('stop_time = "1 us"\n[[block]]\nname = "a"\nmaterial = "copper"\nx = ["0 mm", "1 mm"]\ny = ["0 mm", "1 mm"]\nzones = [3, 3]\n'
            '[[boundary]]\non = "a.left"\nkind = "velocity"\nvelocity = "1 m/s"\ndirection = [1.0, 1.0]\n[solver]\nkind = "lagrange2d"\n')
    first = read_deck_text(deck).resolved
    assert read_deck_text(first).resolved == first and "direction" in first


def test_hints_hold_no_escape_characters():
    names = SOUND.replace("[material.al.", '[material."a\\u001b[31ml".').replace('material = "al"', 'material = "a[31ml"')
    with pytest.raises(DeckError) as caught:
        read_deck_text(names)
    assert "\x1b" not in str(caught.value)


# -- files that are none ----------------------------------------------------------------------------------------------
@unix
@pytest.mark.parametrize("kind", ["device", "pipe", "folder"])
@pytest.mark.parametrize("read", [read_deck, read_materials, tables_io.load, read_points, read_table])
def test_only_regular_files_are_read(tmp_path, kind, read):
    path = tmp_path / "input.h5"
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    else:
        path.symlink_to("/dev/zero")
    with pytest.raises(FileTrouble, match="not a regular file but a|Is a directory"):
        read(path)


@unix
def test_a_pipe_beside_the_deck_is_no_material(tmp_path):
    os.mkfifo(tmp_path / "al2.toml")
    (tmp_path / "deck.toml").write_text(SOUND.replace('material = "al"', 'material = "al2"'))
    with pytest.raises(DeckError, match="unknown material 'al2'"):
        read_deck(tmp_path / "deck.toml")


@pytest.mark.parametrize("head", ["nan 2.0", "2.0 nan", "inf 2.0", "1.0E+300 2.0", "2.5 2.0", "-2.0 3.0", "1.0 1.0"])
def test_a_sesame_table_with_a_nonsensical_head_is_refused(head):
    text = f" 0 3720 301 22 r 82803 22704 1\n {head} 1.0 2.0 3.0 4.0 1.0 1.0 1.0 1.0\n"
    with pytest.raises(DeckError, match="numbers of densities and temperatures|need .* words"):
        tables_io.read_301(text)


def test_a_sesame_head_with_a_number_of_many_digits_is_no_head():
    with pytest.raises(DeckError, match="no 301 table"):
        tables_io.read_301(f" 0 {'9' * 5000} 301 22 r\n 2.0 2.0\n")


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    path = tmp_path_factory.mktemp("table") / "gas.h5"
    rho, t = np.array([1.0, 2.0, 4.0]), np.array([300.0, 600.0, 1200.0])
    write_table(path, rho, t, rho[:, None] * t * 287.0, np.ones(3)[:, None] * t * 717.5, "a gas")
    return path


def test_a_changed_number_in_a_table_is_noticed(table, tmp_path):
    data = bytearray(table.read_bytes())
    place = data.find(np.float64(600.0).tobytes())
    data[place + 4] ^= 1
    (tmp_path / "gas.h5").write_bytes(data)
    with pytest.raises(DeckError, match="damaged"):
        read_table(tmp_path / "gas.h5")


@unix
@pytest.mark.parametrize("size", [0, 2**64 - 16, 2**40])
def test_texts_without_an_end_are_not_begun_with(table, tmp_path, size):
    """With a size that wraps round to 0 the library went from an object to itself for ever; met by chance among ten thousand mutated tables."""
    data = bytearray(table.read_bytes())
    heap = data.find(b"GCOL\x01")
    assert heap > 0 and hdf5_texts_end(table)
    data[heap + 24:heap + 32] = size.to_bytes(8, "little")
    data[heap + 16:heap + 18] = (0 if size == 0 else 1).to_bytes(2, "little")
    (tmp_path / "gas.h5").write_bytes(data)
    assert not hdf5_texts_end(tmp_path / "gas.h5")
    with pytest.raises(DeckError, match="damaged"):
        read_table(tmp_path / "gas.h5")


def test_a_table_that_claims_to_be_huge_is_refused(tmp_path):
    with h5py.File(tmp_path / "huge.h5", "w") as file:
        for name in ("density", "temperature"):
            file[name] = np.array([1.0, 2.0])
        for name in ("pressure", "energy"):
            file.create_dataset(name, (10**7, 10**7), "f8", chunks=(100, 100))
    with pytest.raises(DeckError, match="values in . dimensions"):
        read_table(tmp_path / "huge.h5")


def test_names_in_a_foreign_table_reach_no_terminal_raw(tmp_path):
    with h5py.File(tmp_path / "bad.h5", "w") as file:
        file["\x1b[31mdensity"] = np.array([1.0])
    with pytest.raises(DeckError) as caught:
        read_table(tmp_path / "bad.h5")
    assert "\x1b" not in str(caught.value)


# -- decks and cards of other programs --------------------------------------------------------------------------------
BUSY = {
    "a whole number to base 60": "tstop: 1" + ":1" * 90_000 + "\n",
    "a long list": "tstop: [" + "1," * 90_000 + "]\n",
    "a long text": "name: " + "x" * 150_000 + "\n",
    "many keys": "".join(f"key{k}: {k}\n" for k in range(12_000)),
    "lists within lists": "tstop: " + "[" * 100_000,
    "tables within tables": "tstop: " + "{a: " * 40_000,
    "a text of a megabyte": "#" + "x" * 1_000_000,
    "aliases of aliases": "a0: &a0 [x,x,x,x,x,x,x,x,x]\n" + "".join(f"a{k}: &a{k} [{','.join([f'*a{k - 1}'] * 9)}]\n" for k in range(1, 12)),
}


@pytest.mark.parametrize("name", BUSY)
def test_a_deck_in_yaml_that_would_keep_its_reader_busy_is_refused(name):
    """A whole number of 980 kB to base 60 took 222 s, a list as long 40 s and 350 MB."""
    with pytest.raises(DeckError, match="too many|nested too deeply|a value has more than|cannot have more than") as caught:
        read_yaml(BUSY[name], "impact.yml")
    assert len(str(caught.value)) < 300


@unix
@pytest.mark.parametrize("kind", ["device", "pipe"])
@pytest.mark.parametrize("name", ["impact.yml", "deck.in", "steel.k"])
def test_only_regular_files_are_imported(tmp_path, capsys, kind, name):
    if kind == "pipe":
        os.mkfifo(tmp_path / name)
    else:
        (tmp_path / name).symlink_to("/dev/zero")
    with pytest.raises(SystemExit) as ended:
        main(["import", str(tmp_path / name), "--units", "g cm us"])
    assert ended.value.code == 4 and "not a regular file" in capsys.readouterr().err


# -- files beside a deck ----------------------------------------------------------------------------------------------
BLOCK = """stop_time = "1 us"
[[block]]
name = "a"
material = "copper"
shape = "edges"
zones = [3, 3]
bottom = {csv = "NAME"}
top = {line = [["0 mm", "1 mm"], ["1 mm", "1 mm"]]}
left = {line = [["0 mm", "0 mm"], ["0 mm", "1 mm"]]}
right = {line = [["1 mm", "0 mm"], ["1 mm", "1 mm"]]}
[solver]
kind = "lagrange2d"
"""


def profiled(profile):
    return SOUND.replace('velocity = "700 m/s"\n', f"[region.profile]\n{profile}\n", 1)


@unix
@pytest.mark.parametrize("deck", [BLOCK, profiled('file = "NAME"')])
@pytest.mark.parametrize("kind", ["device", "pipe", "folder", "open quote", "no name"])
def test_what_lies_beside_a_deck_is_a_bounded_table_or_refused(tmp_path, deck, kind):
    path = tmp_path / "points.csv"
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    elif kind == "device":
        path.symlink_to("/dev/zero")
    else:
        path.write_text('position [mm],velocity [m/s]\n0,1\n"' + "1" * 200_000)
    (tmp_path / "deck.toml").write_text(deck.replace("NAME", "points\\u0000.csv" if kind == "no name" else "points.csv"))
    with pytest.raises(DeckError, match="not a regular file|not the name of a file|a cell of more than") as caught:
        read_deck(tmp_path / "deck.toml")
    assert str(caught.value).replace("\n", "").isprintable()


@pytest.mark.parametrize("deck", [BLOCK, profiled('file = "NAME"')])
@pytest.mark.parametrize("end", ["\n", "\r", "\u2028"])
def test_a_file_of_too_many_lines_is_refused_before_it_is_read(tmp_path, deck, end):
    """900 000 lines of a profile took 16 s, and made a deck of the run that was too long to be read by `resume`."""
    (tmp_path / "points.csv").write_text(f"position [mm],velocity [m/s]{end}" + f"0,1{end}" * 900_000)
    (tmp_path / "deck.toml").write_text(deck.replace("NAME", "points.csv"))
    found = []

    def read():
        with pytest.raises(DeckError, match="more than [12][05]0 000 lines, which is the limit") as caught:
            read_deck(tmp_path / "deck.toml")
        found.append(str(caught.value))

    read()
    assert pace.calls(read) < 50_000 and len(found[0]) < 300


def test_the_deck_of_a_run_with_the_longest_profiles_can_be_read(tmp_path, monkeypatch):
    assert profiles.MOST * len(", -1.2345678901234567e-100") < deck_reading.LARGEST
    monkeypatch.setattr(checks, "MOST", 1000)
    (tmp_path / "points.csv").write_text("position [mm],velocity [m/s]\n" + "".join(f"{k / 100},{k}\n" for k in range(501)))
    (tmp_path / "deck.toml").write_text(profiled('file = "points.csv"'))
    with pytest.raises(DeckError, match="region.flyer.profile: more than 1000 values"):
        read_deck(tmp_path / "deck.toml")


def test_a_profile_of_a_file_resolves_to_arrays_that_resolve_to_themselves(tmp_path):
    (tmp_path / "points.csv").write_text("position [mm],pressure [MPa],density [g/cm^3],velocity [m/s]\n0,1,2.701,3\n2,1,2.702,4\n")
    (tmp_path / "deck.toml").write_text(profiled('file = "points.csv"'))
    deck = read_deck(tmp_path / "deck.toml")
    assert read_deck_text(deck.resolved).resolved == deck.resolved and "positions = [0.0, 0.002]" in deck.resolved


def test_the_numbers_of_a_column_are_read_as_those_of_a_deck():
    values = [0.1, 1e-7, 3.0, 123456.789e-3, 7e22, *np.random.default_rng(1).uniform(0.0, 10.0, 200)]
    for name, unit in (("mm", "m"), ("g/cm^3", "kg/m^3"), ("GPa", "Pa"), ("inch", "m"), ("degC", "K"), ("", "m")):
        assert units.parse_all(values, name, unit) == [units.parse(f"{float(v)!r} {name}" if name else float(v), unit) for v in values]
    for wrong in ((["nan"], "mm"), ([1e300], "1e300 m"), ([1.0], "kg"), ([1.0], "m" * 200)):
        with pytest.raises(units.UnitError):
            units.parse_all(map(float, wrong[0]), wrong[1], "m")


@pytest.mark.parametrize("read", [read_points, compare.read_table, tables_io.load, designs._table, pop_target._lines])
def test_a_quotation_mark_left_open_is_told(tmp_path, read):
    (tmp_path / "data.csv").write_text('density,temperature,pressure,energy\n1,2,3,4\n"' + "1" * 200_000 + "\n")
    with pytest.raises(DeckError, match="3: row: a cell of more than|column"):
        read(tmp_path / "data.csv")


@pytest.mark.parametrize("expression", ["0 ** -1", "sin(1e308 * 10)", "cos(-1e308 * 10)", "round(1e308 * 10)", "(-8) ** (1 / 3)", "9 ** 9 ** 9"])
def test_an_expression_without_a_value_is_refused(expression):
    with pytest.raises(DeckError, match="does not give a finite number"):
        read_deck_text(profiled(f'velocity = "10 m/s * ({expression})"'))


# -- names of files ---------------------------------------------------------------------------------------------------
@unix
@pytest.mark.parametrize("name", ["a\nb\x1b[31m.toml", os.fsdecode(b"\xff.toml"), "\u202eb.toml"])
def test_a_file_name_of_control_characters_is_a_plain_title(tmp_path, name):
    """The deck that a run keeps could not be read again, so that the run could not be resumed."""
    (tmp_path / name).write_text(SOUND.replace('title = "Aluminium on aluminium"\n', ""))
    deck = read_deck(tmp_path / name)
    assert deck.problem.title.isprintable() and read_deck_text(deck.resolved).resolved == deck.resolved


@unix
def test_names_of_files_reach_no_terminal_raw(tmp_path, capsys):
    (tmp_path / "b\x1b[31m.toml").write_text("")
    for words in (["check", tmp_path / "no\x1b[31m.toml"], ["info", tmp_path / "no\x1b[31m.run"]):
        with pytest.raises(SystemExit) as ended:
            main([str(word) for word in words])
        assert ended.value.code == 4 and "\x1b" not in capsys.readouterr().err


# -- files of materials, sweeps and tables ------------------------------------------------------------------------------
@pytest.mark.parametrize("name", [name for name in STRANGE if "of 300" not in name and "zones" not in name])
@pytest.mark.parametrize("command", ["material", "deck beside", "sweep", "explore"])
def test_strange_text_is_refused_wherever_toml_is_read(tmp_path, capsys, name, command):
    """A key of 20 000 parts in a file of materials took 16 s and 1.6 GB, and arrays in each other ended in a traceback."""
    strange = STRANGE[name].replace(SOUND, "")
    (tmp_path / "m.toml").write_text(strange + '\n[eos]\nlaw = "ideal_gas"\n')
    (tmp_path / "deck.toml").write_text(SOUND.replace('material = "al"', 'material = "m"') if command == "deck beside" else STRANGE[name])
    words = {"material": ["material", "show", "m", "-m", tmp_path / "m.toml"], "deck beside": ["check", tmp_path / "deck.toml"],
             "sweep": ["sweep", tmp_path / "deck.toml", "--vary", "stop_time = 1, 2 us", "--out", tmp_path / "s"]}
    if command == "explore":
        assert not places._only_materials(tmp_path / "m.toml")
        return
    with pytest.raises(SystemExit) as ended:
        main([str(word) for word in words[command]])
    told = capsys.readouterr().err
    assert ended.value.code == 2 and "unexpected" not in told and len(told) < 2000


def test_the_work_on_a_file_of_many_wrong_materials_is_bounded(tmp_path):
    """5 000 took more than a minute."""
    path = tmp_path / "m.toml"
    path.write_text("".join(f'[material.m{k}.eos]\nlaw = "x"\n' for k in range(2000)))
    with pytest.raises(DeckError) as caught:
        read_materials(path)
    assert len(caught.value.problems) == 50 and caught.value.more == 1950

    def work(count):
        path.write_text("".join(f'[material.m{k}.eos]\nlaw = "ideal_gas"\ngamma = 1.4\nrho0 = 1.0\n' for k in range(count)))
        return lambda: read_materials(path)

    work(10)()
    assert pace.calls(work(200)) < 5.0 * pace.calls(work(50))


@pytest.mark.parametrize("how", [{"external": [("/etc/passwd", 0, 24)]}, "virtual"])
def test_a_table_whose_numbers_lie_in_another_file_is_refused(table, tmp_path, how):
    (tmp_path / "gas.h5").write_bytes(table.read_bytes())
    with h5py.File(tmp_path / "gas.h5", "a") as file:
        del file["density"]
        if how == "virtual":
            layout = h5py.VirtualLayout((3,), "f8")
            layout[:] = h5py.VirtualSource(str(table), "density", (3,))
            file.create_virtual_dataset("density", layout)
        else:
            file.create_dataset("density", (3,), "f8", **how)
    with pytest.raises(DeckError, match="density: its numbers are stored in another file"):
        read_table(tmp_path / "gas.h5")
