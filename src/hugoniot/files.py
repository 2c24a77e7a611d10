"""Files that come from outside: only regular ones are read, and never more of them than a limit.

A device (`/dev/zero`) has no end, a pipe may never answer: neither is waited for.
"""

import ast
import csv
import os
import re
import stat
import tomllib
from typing import Any

from hugoniot.errors import DeckError, FileTrouble

DEEPEST = 100           # tables and arrays within each other, and parts of a key, of a file in TOML
LONG_KEY = re.compile(r"""(?<![\w-])(?:(?:[A-Za-z0-9_-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+)""" f"{{{DEEPEST}}}")
LARGEST = 256_000_000   # bytes; more than any deck, material file or table of measured data has
_RARE_ENDS = "\x0b\x0c\x1c\x1d\x1e\x85\u2028\u2029"     # of lines, as `str.splitlines` knows them
_COLLECTION = b"GCOL\x01"
_MOST_COLLECTIONS = 1_000_000    # of texts: more than any result or table has
_PIECE = 1 << 20        # bytes of a file read at a time: a whole one in memory would be too much
_KEY = "(a key without quotes has letters, digits, _ and - only)"
_PARSER_WORDS = (       # what the parser says, and what a user can act upon
    (r"Illegal character '\\[nr]'|Found invalid character '\\[nr]'|Unterminated string|Expected [\"']+ \(",
     "the quotation mark at the end of a string is missing"),
    (r"(?:Illegal|Found invalid) character '(.*)'", "the control character {0} is not allowed"),
    (r"Expected '=' after a key", f"a line must have the form key = value {_KEY}"),
    (r"Expected newline or end of document", "the line goes on after its value or heading, perhaps because a quotation mark is missing"),
    (r"Invalid value", "the value is missing or not valid: strings need quotation marks"),
    (r"Expected '\]' at the end of a table declaration", f"a heading must have the form [name] {_KEY}"),
    (r"Expected '\]\]' at the end of an array declaration", f"a heading must have the form [[name]] {_KEY}"),
    (r"Invalid initial character for a key", f"a key is missing or not valid {_KEY}"),
    (r"Invalid statement", "the line is neither key = value nor a heading such as [name]"),
    (r"Cannot declare (\(.*\)) twice", "the heading [{0}] is for a table that is already given"),
    (r"Cannot overwrite a value", "a key is given twice"),
    (r"Duplicate inline table key '(.*)'", "the key '{0}' is given twice in a table {{ }}"),
    (r"Cannot (?:mutate immutable|redefine) namespace (\(.*\))", "'{0}' is complete already: no keys can be added to it here"),
    (r"Unclosed array", "a comma in an array [ ], or the ] at its end, is missing"),
    (r"Unclosed inline table", "a comma in a table {{ }}, or the }} at its end, is missing"),
    (r"Unescaped", r"write a backslash in a string as \\, or enclose the string in '...'"),
    (r"Invalid hex value|Escaped character", r"a character written as \u or \U in a string is not valid"),
    (r"Invalid date or datetime", "a date or time is not valid"),
)
_WITHOUT_WAITING = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)


def open_regular(path, flags: int = _WITHOUT_WAITING) -> int:
    """Handle of a regular file, opened without waiting.

    `FileTrouble` for a device, a pipe, a folder or what is not a valid name; `OSError` as the system raises it.
    """
    try:
        handle = os.open(path, flags)
    except ValueError:      # a zero byte
        raise _refused(path, "not the name of a file") from None
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise _refused(path, f"not a regular file but {_kind(path)}")
    return handle


def _refused(path, why: str) -> FileTrouble:
    """The error for a file that is not read; its `strerror` is the reason alone, for a caller that names the file itself."""
    error = FileTrouble(f"{path}: {why}")
    error.strerror = why
    return error


def read_regular(path, limit: int = LARGEST) -> bytes:
    """The bytes of a regular file of at most `limit` bytes.

    `FileTrouble` for any other kind or a larger one; `OSError` as the system raises it.
    """
    with os.fdopen(open_regular(path), "rb") as file:
        data = file.read(limit + 1) if os.fstat(file.fileno()).st_size <= limit else None
    if data is None or len(data) > limit:
        raise _refused(path, f"larger than {limit / 1e6:g} MB; is this the right file?")
    return data


def read_text(path, limit: int = LARGEST) -> str:
    """The text (UTF-8, with or without a byte order mark) of a regular file; `UnicodeDecodeError` where it is none."""
    return read_regular(path, limit).decode("utf-8-sig")


def toml_tables(text: str) -> dict:
    """The tables of a TOML text. Raises `tomllib.TOMLDecodeError` for invalid TOML, `ValueError` for keys and nesting that no file needs.

    The time and memory that a key takes grow with the square of the number of its parts.
    """
    if LONG_KEY.search(text):
        raise ValueError(f"a key of more than {DEEPEST} parts")
    try:
        raw = tomllib.loads(text)
    except RecursionError:
        raise ValueError("arrays nested too deeply") from None
    waiting: list[tuple[Any, int]] = [(raw, 0)]
    while waiting:
        value, depth = waiting.pop()
        if isinstance(value, int) and not -2**63 <= value < 2**63:
            raise ValueError("an integer of more than 64 bits")
        if isinstance(value, (dict, list)):
            if depth > DEEPEST:
                raise ValueError("tables and arrays nested too deeply")
            waiting += [(inner, depth + 1) for inner in (value.values() if isinstance(value, dict) else value)]
    return raw


def toml_trouble(error: tomllib.TOMLDecodeError, text: str) -> tuple[int | None, str, str]:
    """(line, message, hint) for a user who does not know the words of the parser."""
    said = str(error)
    match = re.search(r"\(at line (\d+), column", said)
    line = int(match[1]) if match else text.rstrip().count("\n") + 1 if "at end of document" in said else None
    if unclosed := re.match(r"Expected (?:\"('+)\"|'(\"+)') \(", said):      # the parser looked for the end to the last line of the text
        line = text.count("\n", 0, text.rfind(unclosed[1] or unclosed[2])) + 1
    elif said.startswith("Unterminated string") and '"""' in text:
        line = text.count("\n", 0, text.rfind('"""')) + 1
    message = said[:1].lower() + re.sub(r"\s*\(at [^)]*\)$", "", said)[1:]
    for pattern, words in _PARSER_WORDS:
        if found := re.match(pattern, said):
            message = words.format(*map(_dotted, found.groups()))
            break
    lines = text.splitlines()
    wrong = lines[line - 1].strip() if line and line <= len(lines) else ""
    hint = f"the line reads: {_escaped(wrong, 60)}" if wrong else "strings need quotes, tables are [name], keys are name = value"
    return line, f"not valid TOML: {_escaped(message, 240)}", hint


def _dotted(key: str) -> str:
    """`a.b` for the tuple of keys "('a', 'b')"; other texts as they are."""
    return ".".join(map(str, ast.literal_eval(key))) if key.startswith("(") else key


def _escaped(text: str, limit: int) -> str:
    text = text if len(text) <= limit else text[: limit - 3] + "..."
    return "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in text)


def csv_rows(text: str, name, first: int = 1, most: int | None = None) -> list[tuple[int, list[str]]]:
    """(line, cells) of comma-separated text, without empty lines and comments (#). Raises `DeckError`.

    name, first   what messages call the text, and the number of its first line
    most          the lines that the text may have; one that has more is not begun with
    """
    if most is not None and max(text.count("\n"), text.count("\r")) + sum(map(text.count, _RARE_ENDS)) > most:
        raise DeckError.single(name, most + 1, "row", f"more than {most:,}".replace(",", " ") + " lines, which is the limit",
                               "use fewer: values between them are interpolated")
    reader = csv.reader(text.splitlines())
    try:
        return [(reader.line_num + first - 1, row) for row in reader if row and not row[0].lstrip().startswith("#")]
    except csv.Error:
        raise DeckError.single(name, reader.line_num + first - 1, "row", f"a cell of more than {csv.field_size_limit()} characters",
                               "is a quotation mark left open?") from None


class Hdf5Texts:
    """Whether reading the texts of an HDF5 file comes to an end: `feed` takes the file piece by piece, and `end` gives the answer.

    Texts of variable length lie in collections, each object with its size before it. Where damage makes that size 0, or so large that the
    sum wraps round, the library goes from an object to itself for ever; here the collections are walked as it does.

    Source: HDF5 File Format Specification 3.0, section III.E (global heap).
    """

    def __init__(self):
        self._read, self._kept, self._places = 0, b"", []

    def feed(self, piece: bytes) -> None:
        """Look for collections in the next piece; one may begin in the piece before."""
        data, start = self._kept + piece, self._read - len(self._kept)
        at = data.find(_COLLECTION)
        while at >= 0 and len(self._places) <= _MOST_COLLECTIONS:
            self._places.append(start + at)
            at = data.find(_COLLECTION, at + 1)
        self._read += len(piece)
        self._kept = data[len(data) - len(_COLLECTION) + 1:]

    def end(self, path) -> bool:
        """Whether each collection ends; `FileTrouble` and `OSError` as `open_regular`."""
        if len(self._places) > _MOST_COLLECTIONS:
            return False
        with os.fdopen(open_regular(path), "rb") as file:
            return all(_walked(file, at, self._read) for at in self._places)


def hdf5_texts_end(path) -> bool:
    """Whether reading the texts of an HDF5 file comes to an end (`Hdf5Texts`); `FileTrouble` and `OSError` as `open_regular`."""
    texts = Hdf5Texts()
    with os.fdopen(open_regular(path), "rb") as file:
        while piece := file.read(_PIECE):
            texts.feed(piece)
    return texts.end(path)


def _walked(file, at: int, length: int) -> bool:
    def numbers(place: int, first: int) -> tuple[int, int]:
        """Two numbers, of which the first has `first` bytes and the second begins 8 bytes in."""
        file.seek(place)
        head = file.read(16)
        return int.from_bytes(head[:first], "little"), int.from_bytes(head[8:16], "little")

    size = numbers(at, 8)[1]
    place, end = at + 16, at + size
    if not 4096 <= size <= length - at:      # the library refuses it, or these bytes are no collection
        return True
    while place + 16 <= end:
        number, extent = numbers(place, 2)
        step = 16 + (extent + 7) // 8 * 8 if number else extent     # object 0 is what is free, its head included
        if not 16 <= step <= end - place:
            return False
        place += step
    return True


def _kind(path) -> str:
    mode = os.stat(path).st_mode
    for test, name in ((stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a pipe"), (stat.S_ISCHR, "a device"), (stat.S_ISBLK, "a device")):
        if test(mode):
            return name
    return "something else"
