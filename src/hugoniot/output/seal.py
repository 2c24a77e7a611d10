"""Texts that carry the SHA-256 of themselves, so that one changed character is noticed.

The digits stand once, behind `sha256_of_this_text`; the hash is that of the whole text with 64 zeros in their place.
"""

import hashlib
import json
import re

from hugoniot.errors import FileTrouble

MARK = "sha256_of_this_text"
_ZEROS = "0" * 64
_FOUND = re.compile(MARK + r"\W{1,4}([0-9a-f]{64})")


def _hash(text: str) -> str:
    return hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()


def sealed(text: str, before: str = "", behind: str = "\n") -> str:
    """The text with a last line `sha256_of_this_text: <hash>`, between `before` and `behind`."""
    text = f"{text}{before}{MARK}: {_ZEROS}{behind}"
    return text[: -len(_ZEROS + behind)] + _hash(text) + behind


def sealed_json(document: dict) -> str:
    """The document as JSON text whose last key holds its hash."""
    text = json.dumps({**document, MARK: _ZEROS}, indent=2) + "\n"
    return text[: text.rindex(_ZEROS)] + _hash(text) + text[text.rindex(_ZEROS) + len(_ZEROS):]


def intact(text: str) -> bool | None:
    """Whether a sealed text is as it was written; None if it has no seal."""
    found = list(_FOUND.finditer(text))
    if not found:
        return False if MARK in text else None
    start, end = found[-1].span(1)
    return _hash(text[:start] + _ZEROS + text[end:]) == found[-1][1]


def read_sealed(path, data: bytes, wanted: tuple[str, ...] = ()) -> dict:
    """The document of a sealed JSON file, without its seal.

    One that has none is read as it is, unless it has one of the keys `wanted` that only sealed documents have: then the seal itself is
    what was damaged. Raises `FileTrouble`.
    """
    text = data.decode("utf-8", "surrogateescape")
    sound = intact(text)
    if sound is False:
        raise FileTrouble(f"{path}: changed since it was written (its own SHA-256 does not agree)")
    try:
        document = json.loads(text)
        if not isinstance(document, dict):
            raise ValueError("it is not a table")
        if sound is None and any(key in document for key in wanted):
            raise ValueError("its SHA-256 is missing")
    except json.JSONDecodeError as error:
        raise FileTrouble(f"{path}: changed since it was written (not JSON at line {error.lineno}, column {error.colno})") from error
    except (ValueError, RecursionError) as error:
        raise FileTrouble(f"{path}: changed since it was written ({error})") from error
    document.pop(MARK, None)
    return document
