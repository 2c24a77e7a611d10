"""Materials as the explorer takes them: by name or row of the library, or of a file named on the command line.

An explosive has an unreacted self and products.
"""

from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from hugoniot.errors import DeckError
from hugoniot.laws.eos.contract import EOS
from hugoniot.materials import library, schema
from hugoniot.materials.entry import Entry
from hugoniot.materials.material import Material
from hugoniot.materials.users import read_materials

MOST = 80     # characters of a name
own: dict[str, Entry] = {}      # materials of files that the command line named, for the life of the process


def admit(path: Path) -> list[str]:
    """The names of the materials of a file, which `entry_of` answers for from now on; `DeckError` where one is the library's, or another
    file's."""
    found = read_materials(path)
    for name, entry in found.items():
        if library.curated_name(name) is not None or schema.is_row(name.strip().upper()):
            raise DeckError.single(path, None, name, "the library has a material of that name", "rename the one in the file")
        other = own.get(name)
        if other is not None and Path(other.file).resolve() != path.resolve():
            raise DeckError.single(path, None, name, f"{other.file} has a material of that name too", "rename one of them")
        own[name] = entry
    return list(found)


def entry_of(name: str) -> Entry:
    """Everything known about a name; `DeckError` for an unknown one."""
    if len(name) > MOST:
        raise DeckError.single("explorer", None, "material", "this name is too long for a material")
    return own[name] if name in own else _of_library(name)


@lru_cache(maxsize=512)
def _of_library(name: str) -> Entry:
    return library.entry(name)


def reacted(entry: Entry) -> bool:
    """Whether the equation of state is that of detonation products."""
    return "reacted" in EOS.of(entry.material.eos).flags


def inert(entry: Entry) -> Material:
    """The material that a shock without reaction meets; `DeckError` where the library has products only."""
    if not reacted(entry):
        return entry.material
    if entry.unreacted is None:
        raise DeckError.single("explorer", None, entry.name, "the library has only the detonation products, not the unreacted explosive",
                               "choose a material with an inert equation of state")
    return replace(entry.material, eos=entry.unreacted, name=f"{entry.material.name} (unreacted)")


def inert_or_none(entry: Entry) -> Material | None:
    """As `inert`; None where there is no such material."""
    return None if reacted(entry) and entry.unreacted is None else inert(entry)
