"""Which program and which machine wrote a checkpoint, and whether this one continues its run to the same bits."""

import functools
import pathlib
from collections.abc import Mapping
from typing import Any

from hugoniot.errors import FileTrouble
from hugoniot.version import __version__


def stamped(payload: dict[str, Any]) -> dict[str, Any]:
    """A checkpoint's content with the program and the machine that made it."""
    from hugoniot.core.machine import machine

    return {**payload, "program": program(), "machine": machine()}


@functools.cache
def program() -> dict[str, str]:
    """What computes: version of the package, hash of the sources behind its kernels (and of the compiler's version)."""
    from hugoniot.core.sources import source_hash

    return {"version": __version__, "sources": source_hash()}


def check_program(folder, written: Mapping[str, str]) -> None:
    """Refuse a checkpoint whose run this program would not continue bit for bit."""
    if written != program():
        raise FileTrouble(f"{folder}: its checkpoint was written by another version of hugoniot ({written.get('version', 'early')}), "
                          f"Python or numba, so the continuation would not be bit-identical; resume with that version, or start again "
                          f"in a new folder: hugoniot run {pathlib.Path(folder) / 'deck.toml'} --out NEW")


def other_machine(written: Mapping[str, str]) -> str | None:
    """A sentence where a checkpoint comes from a machine that may round otherwise; None where it does not."""
    from hugoniot.core.machine import machine

    changed = [f"{name} {was} (here {machine()[name]})" for name, was in written.items() if name in machine() and machine()[name] != was]
    if not changed:
        return None
    return ("resumed on a different machine from the one it began on, so that the last digits may differ from those of an uninterrupted "
            f"run: {'; '.join(text if len(text) < 120 else text[:117] + '...' for text in changed)}")
