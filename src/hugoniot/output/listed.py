"""Folders of many runs, sweeps and fits: a sealed JSON file says what was asked or found, and keeps the SHA-256 of the files beside it."""

import pathlib
from collections.abc import Iterable

from hugoniot.errors import FileTrouble
from hugoniot.files import read_regular
from hugoniot.output.atomic import digest, explained, legible, write_whole
from hugoniot.output.seal import read_sealed, sealed_json

LISTS = ("sweep.json", "fit.json")


def write_listed(path, document: dict, names: Iterable[str]) -> None:
    """Write the document, with the checksums of those of the named files that stand beside it. Raises `FileTrouble`."""
    path = pathlib.Path(path)
    with explained(path.parent):
        sums = {name: digest(path.with_name(name)).sha256 for name in names if path.with_name(name).is_file()}
    write_whole(path, sealed_json({**document, "sha256": sums}))


def read_listed(path) -> dict:
    """The document with its `sha256`, {} while it is being made or of an early version. Raises `FileTrouble` for a changed one."""
    with legible(path):
        document = read_sealed(path, read_regular(path), ("sha256",))
    sums = document.get("sha256")
    return {**document, "sha256": sums if isinstance(sums, dict) else {}}


def check_listed(path) -> None:
    """Raise `FileTrouble` where the list beside a file says that it was changed since; nothing where no list names it."""
    path = pathlib.Path(path)
    for name in LISTS:
        if not path.with_name(name).is_file():
            continue
        wanted = read_listed(path.with_name(name))["sha256"].get(path.name)
        with legible(path):
            if wanted is not None and digest(path).sha256 != wanted:
                raise FileTrouble(f"{path}: changed since it was written (its SHA-256 does not agree with {name}); "
                                  f"the command that made it writes it again")
