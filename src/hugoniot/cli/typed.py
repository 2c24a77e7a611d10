"""Which options were typed, so that a command can refuse one that would have no effect beside the others."""

from collections.abc import Iterable
from contextvars import ContextVar

from hugoniot.errors import DeckError

_TYPED: ContextVar[frozenset[str]] = ContextVar("typed", default=frozenset())


def remember(names: Iterable[str]) -> None:
    """Keep the names of the options and arguments of the command line; the command itself sees values only, defaults among them."""
    _TYPED.set(frozenset(names))


def refuse_idle(when: str, *options: str) -> None:
    """Raise `DeckError` if one of the options was typed: it has no effect `when` ("with --at")."""
    for option in options:
        if option in _TYPED.get():
            raise DeckError.single("command line", None, option, f"has no effect {when}", "omit it")
