"""Materials as the explorer takes them: by name or row of the library; an explosive has an unreacted self and products."""

from dataclasses import replace
from functools import lru_cache

from hugoniot.errors import DeckError
from hugoniot.laws.eos.contract import EOS
from hugoniot.materials import library
from hugoniot.materials.entry import Entry
from hugoniot.materials.material import Material

MOST = 80     # characters of a name


@lru_cache(maxsize=512)
def entry_of(name: str) -> Entry:
    """Everything the library knows about a name; `DeckError` for an unknown one."""
    if len(name) > MOST:
        raise DeckError.single("explorer", None, "material", "no material has a name as long as that")
    return library.entry(name)


def reacted(entry: Entry) -> bool:
    """Whether the equation of state is that of detonation products."""
    return "reacted" in EOS.of(entry.material.eos).flags


def inert(entry: Entry) -> Material:
    """The material that a shock without reaction meets; `DeckError` where the library has products only."""
    if not reacted(entry):
        return entry.material
    if entry.unreacted is None:
        raise DeckError.single("explorer", None, entry.name, "the library gives detonation products only, no unreacted explosive",
                               "take a material with an inert equation of state")
    return replace(entry.material, eos=entry.unreacted)


def inert_or_none(entry: Entry) -> Material | None:
    """As `inert`; None where there is no such material."""
    return None if reacted(entry) and entry.unreacted is None else inert(entry)
