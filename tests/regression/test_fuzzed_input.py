"""Mutated decks and tables: each is read or refused in words, with bounded work and memory, and a deck that is read stays what it is.

A deck's text is cut, doubled and spiced, which mostly makes it no TOML; and its tables are changed value by value, so that what is wrong
is the matter and not the writing. Work is measured in turns of a plain loop (`pace`), memory as the growth of a fork. The quick parts
look at some hundreds, the slow ones at a hundred thousand decks and ten thousand tables.
"""

import copy
import datetime
import math
import os
import random
import resource
import sys
import time
import tomllib
import traceback

import numpy as np
import pytest
from pace import loop
from test_broken_decks import BROKEN, SOUND

from hugoniot.errors import HugoniotError
from hugoniot.materials import tables_io
from hugoniot.materials.table_hdf5 import write_table
from hugoniot.problem import catalogue
from hugoniot.problem.cost import estimate
from hugoniot.problem.deck import read_deck_text, read_tables

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="forks are a Unix matter")
slow = pytest.mark.slow
LOOPS = 100.0           # a second of the processor this was written on
MEGABYTES = 200.0


# -- how each is judged ---------------------------------------------------------------------------------------------
def seconds_of_a_loop():
    begun = time.thread_time()
    for _ in range(10):
        loop()
    return (time.thread_time() - begun) / 10.0


def in_a_fork(work):
    """Run `work()` in a fork, which may neither fail nor be killed, nor grow by more than MEGABYTES."""
    child = os.fork()
    if child == 0:
        status = 1
        try:
            resource.setrlimit(resource.RLIMIT_CPU, (600, 600))     # only for what never ends
            before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            work()
            grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024.0
            assert grown < MEGABYTES, f"grown by {grown:.0f} MB"
            status = 0
        except BaseException:
            traceback.print_exc()
        finally:
            sys.stderr.flush()
            os._exit(status)
    assert os.waitpid(child, 0)[1] == 0, "see the traceback on the standard error"


def judged(call, what, limit, codes):
    """What `call` gives, or None where it refuses in words; neither takes longer than the limit (s of the processor)."""
    begun, found = time.thread_time(), None
    try:
        found = call()
    except HugoniotError as error:
        shown = str(error)
        assert error.exit_code in codes and shown.replace("\n", "").isprintable() and len(shown) < 40_000, (what, shown[:2000])
    except Exception as error:
        error.add_note(repr(what))
        raise
    assert time.thread_time() - begun < limit, what
    return found


# -- decks ------------------------------------------------------------------------------------------------------------
SPICE = ["[", "]", "{", "}", "=", '"', "'", ".", "\\", "\n", "\x00", "\x1b", "é", "1e999", "nan", "-inf", "0x" + "f" * 40, "9" * 30, "true", "[[", '"""', "#",
         "m/s", "1 GPa", "free", "region", "material", "law", "zones = 3", "a.b.c"]
VALUES = ["", " ", "0 mm", "-1 mm", "1e308 m", "1e-320 s", "nan m", "1e400 Pa", "1 m/s/s/s", "3 kg", "free", "fixed", "copper", "al", "x" * 300, "\x1b[31m", "é\u202e",
          "region", "flyer", "0", 0, -1, 1, 2, 3, 10**6, 2**62, 0.0, -0.0, -1.0, 0.5, 1e308, -1e308, 5e-324, 1e-300, 1e-9, 1e9, math.inf, math.nan, True, False,
          [], {}, [0.0], [1.0, 0.0], [[1.0]], [True, "a"], [{}], {"law": "x"}, {"a": {"b": 1}}, ["free", 1], datetime.date(2000, 1, 1),
          datetime.datetime(2000, 1, 1, tzinfo=datetime.UTC), datetime.time(1, 2)]


def mutated(text, chance):
    """The text with some pieces cut out, doubled, exchanged or spiced."""
    for _ in range(chance.randint(1, 4)):
        a, b = sorted(chance.randrange(len(text) + 1) for _ in range(2))
        b = min(b, a + chance.choice((1, 3, 20, 200)))
        how = chance.randrange(5)
        piece = chance.choice(SPICE)
        text = (text[:a] + text[b:] if how == 0 else text[:b] + text[a:] if how == 1 else text[:a] + piece + text[b:] if how == 2 else
                text[:a] + piece + text[a:] if how == 3 else text[:a] + chr(chance.randrange(1, 0x250)) + text[a + 1:])
        text = text or " "
    return text


def places(value):
    """(container, key) of everything within tables and arrays."""
    pairs = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in pairs:
        yield value, key
        yield from places(inner)


def scaled(value, chance):
    """A number, or the number of a quantity, by a power of ten up or down or with its sign changed."""
    factor = chance.choice((-1.0, 0.0, 10.0 ** chance.randint(-12, 12), 1.0 + 1e-15, 0.9, 1.1))
    if isinstance(value, str):
        number, _, unit = value.partition(" ")
        try:
            return f"{float(number) * factor!r} {unit}"
        except ValueError:
            return value + chance.choice(("s", " ", "/m", ""))
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return value
    return int(value * factor) if isinstance(value, int) else value * factor


def altered(tables, others, chance):
    """Tables of a deck with one to four values exchanged, scaled, removed, doubled, or taken from another place or deck."""
    tables = copy.deepcopy(tables)
    for _ in range(chance.choice((1, 1, 1, 2, 4))):
        known = list(places(tables))
        if not known:
            break
        where, key = chance.choice(known)
        how = chance.randrange(8)
        if how < 2:
            where[key] = scaled(where[key], chance)
        elif how < 4:
            where[key] = copy.deepcopy(chance.choice(VALUES))
        elif how == 4:
            del where[key]
        elif how == 5:
            other, place = chance.choice(list(places(chance.choice(others))))
            where[key] = copy.deepcopy(other[place])
        elif how == 6 and isinstance(where, dict):
            other, place = chance.choice(list(places(chance.choice(others))))
            where[place if isinstance(place, str) else "x"] = copy.deepcopy(other[place])
        elif isinstance(where, list):
            where.append(copy.deepcopy(where[key]))
        else:
            where[str(key)[:-1] + chance.choice("xs_ \x1b")] = where.pop(key)
    return tables


def stays_itself(deck):
    """A deck that is read can be estimated, and what it resolves to resolves to itself, byte for byte."""
    estimate(deck.problem)
    assert read_deck_text(deck.resolved, "deck.toml").resolved == deck.resolved, deck.resolved


def check_texts(count, seed):
    chance, limit, read = random.Random(seed), LOOPS * seconds_of_a_loop(), 0
    decks = [SOUND, *(text for text, _ in BROKEN.values() if len(text) < 5000), *(catalogue.deck_text(name) for name, _ in catalogue.problems())]

    def work():
        nonlocal read
        for k in range(count):
            text = mutated(decks[0] if k % 2 else chance.choice(decks), chance)
            read += judged(lambda: read_deck_text(text, "deck.toml"), text, limit, (2,)) is not None  # noqa: B023
        assert read > 0

    in_a_fork(work)


def check_values(count, seed):
    chance, limit, read = random.Random(seed), LOOPS * seconds_of_a_loop(), 0
    decks = [tomllib.loads(text) for text in (SOUND, *(catalogue.deck_text(name) for name, _ in catalogue.problems()))]

    def work():
        nonlocal read
        for k in range(count):
            tables = altered(decks[0] if k % 4 == 0 else chance.choice(decks), decks, chance)
            deck = judged(lambda: read_tables(copy.deepcopy(tables), "", "deck.toml"), tables, limit, (2,))  # noqa: B023
            if deck is not None:
                read += 1
                judged(lambda: stays_itself(deck), tables, limit, ())  # noqa: B023
        assert read > count // 20

    in_a_fork(work)


def test_mutated_decks_are_read_or_refused_in_words():
    check_texts(300, 1)


def test_decks_with_other_values_are_read_or_refused_in_words():
    check_values(60, 1)


@slow
@pytest.mark.parametrize("seed", range(10))
def test_a_hundred_thousand_mutated_decks_are_read_or_refused_in_words(seed):
    """Five thousand of each kind; in forks of a thousand, whose memory is looked at."""
    for part in range(5):
        check_texts(1000, 1000 + 10 * seed + part)
        check_values(1000, 2000 + 10 * seed + part)


# -- tables -----------------------------------------------------------------------------------------------------------
def tables(folder):
    rho, t = np.linspace(1.0, 4.0, 4), np.linspace(300.0, 1200.0, 4)
    p, e = rho[:, None] * t * 287.0, np.ones(4)[:, None] * t * 717.5
    rows = "".join(f"{rho[i]},{t[j]},{p[i, j]},{e[i, j]}\n" for i in range(4) for j in range(4))
    words = [4.0, 4.0, *(rho / 1e3), *t, *(p.T / 1e9).ravel(), *(e.T / 1e6).ravel()]
    lines = "".join(" ".join(f"{w:.8E}" for w in words[k:k + 5]) + "\n" for k in range(0, len(words), 5))
    (folder / "t.csv").write_text("density,temperature,pressure,energy\n" + rows)
    (folder / "t.ses").write_text(f" 0 3720 301 {len(words)} r 82803 22704 1\n" + lines)
    write_table(folder / "t.h5", rho, t, p, e)
    return [folder / name for name in ("t.csv", "t.ses", "t.h5")]


def damaged(data, chance):
    """The bytes with up to four of them changed, sometimes cut off."""
    data = bytearray(data)
    for _ in range(chance.randint(1, 4)):
        data[chance.randrange(len(data))] = chance.randrange(256)
    return bytes(data[: chance.randrange(len(data))] if chance.random() < 0.1 else data)


def check_tables(tmp_path, count, seed):
    """Those in HDF5 each in a fork of its own: the library's code is not ours, and damage may end the process that meets it."""
    chance, limit, files = random.Random(seed), LOOPS * seconds_of_a_loop(), tables(tmp_path)
    for path in files:
        tables_io.load(path, rho0=2.0)

    def look(path):
        judged(lambda: tables_io.load(path, rho0=2.0), path.read_bytes(), limit, (2, 3, 4))

    def look_at_texts():
        for k in range(count - count // 3):
            path = files[k % 2]
            changed = tmp_path / f"x{path.suffix}"
            changed.write_text(mutated(path.read_text(), chance), encoding="utf-8")
            look(changed)

    in_a_fork(look_at_texts)
    whole = files[2].read_bytes()
    for _ in range(count // 3):
        (tmp_path / "x.h5").write_bytes(damaged(whole, chance))
        in_a_fork(lambda: look(tmp_path / "x.h5"))


def test_mutated_tables_are_read_or_refused_in_words(tmp_path):
    check_tables(tmp_path, 90, 1)


@slow
@pytest.mark.parametrize("seed", range(4))
def test_ten_thousand_mutated_tables_are_read_or_refused_in_words(tmp_path, seed):
    check_tables(tmp_path, 2500, 100 + seed)
