"""What of a folder belongs to a run: only that is ever replaced or removed, and a deck that somebody changed is neither run nor lost."""

import contextlib
import difflib
import hashlib
import pathlib
import re

from hugoniot.errors import FileTrouble
from hugoniot.files import read_regular
from hugoniot.output.atomic import explained, legible
from hugoniot.output.checkpoint import Checkpoints
from hugoniot.output.seal import read_sealed

# in the order in which they are removed: a run without its summary is an unfinished one, and its log says that it is a run
PRODUCTS = ("summary.json", "result.h5", "gauges.csv", "fronts.csv", "result.vtkhdf", "report.html", "post_mortem.h5", "post_mortem.txt",
            "run.log")
_FIRST_LINE = re.compile(r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d  \w+: .*")
_SHOWN = 12             # lines of a difference


def refuse_foreign(folder: pathlib.Path, overwrite: bool, checkpoints: Checkpoints) -> None:
    """Raise `FileTrouble` unless a run may be written here: nothing stands in the folder, or a run that may be overwritten."""
    with explained(folder):
        standing = [name for name in (*PRODUCTS, "deck.toml", "checkpoint", "pieces") if _stands(folder / name)]
    if not standing:
        return
    if not overwrite:
        raise FileTrouble(f"{folder}: holds {standing[0]} already; choose another folder (--out; out= in Python), or replace the run "
                          f"(--overwrite; overwrite=True)")
    if not _is_log(folder / "run.log"):
        raise FileTrouble(f"{folder}: contains {standing[0]}, but no run.log written by hugoniot, so it is not recognised as a run folder; "
                          "choose another with --out")
    _refuse_foreign_deck(folder, checkpoints)


def _stands(path: pathlib.Path) -> bool:
    return path.exists() or path.is_symlink()


def _is_log(path: pathlib.Path) -> bool:
    try:
        first = read_regular(path).partition(b"\n")[0]
    except OSError:
        return False
    return not path.is_symlink() and _FIRST_LINE.fullmatch(first.decode("utf-8", "replace")) is not None


def _refuse_foreign_deck(folder: pathlib.Path, checkpoints: Checkpoints) -> None:
    """A deck.toml that is not the run's own is somebody's work."""
    path = folder / "deck.toml"
    if not _stands(path):
        return
    with legible(path):
        data = read_regular(path)
    known = _known_deck(folder, checkpoints)
    if path.is_symlink() or (known is not None and hashlib.sha256(data).hexdigest() not in known) or (
            known is None and not data.startswith(b"# Written by hugoniot")):
        raise FileTrouble(f"{path}: not the deck of the run in this folder (changed since, or put there by hand), and it would be lost; "
                          f"move it elsewhere, or choose another folder with --out")


def _known_deck(folder: pathlib.Path, checkpoints: Checkpoints) -> set[str] | None:
    """SHA-256 of the decks the run of a folder has written, as its summary or its checkpoints remember; None if nothing does."""
    found = set()
    with contextlib.suppress(OSError):
        path = folder / "summary.json"
        found.add(str(read_sealed(path, read_regular(path)).get("deck_sha256")))
    kept = checkpoints.deck()
    if kept is not None:
        found.add(hashlib.sha256(kept.encode()).hexdigest())
    return found or None


def remove_products(folder: pathlib.Path) -> None:
    """Remove the files of the run that stands in a folder, but its deck and log, which are replaced."""
    with explained(folder):
        for name in PRODUCTS[:-1]:
            (folder / name).unlink(missing_ok=True)
    remove_unfinished(folder)


def remove_unfinished(folder: pathlib.Path) -> list[str]:
    """Remove the temporary files a killed run has left in its folder; their names."""
    left = []
    with explained(folder):
        for name in (*PRODUCTS, "deck.toml"):
            path = folder / f".{name}.part"
            if _stands(path):
                path.unlink()
                left.append(path.name)
    return left


def same_deck(path: pathlib.Path, kept: str | None) -> str:
    """The text of a run's deck.toml, or `FileTrouble` with the difference if it is not the deck `kept` with the run's checkpoints."""
    try:
        with legible(path):
            text = read_regular(path).decode("utf-8-sig")
    except (FileTrouble, UnicodeDecodeError) as error:
        why = "not a UTF-8 text file" if isinstance(error, UnicodeDecodeError) else str(error)
        if kept is None:
            raise FileTrouble(f"{path}: cannot be read ({why})") from error
        again = f"hugoniot resume {path.parent} --restore-deck"
        raise FileTrouble(f"{path}: cannot be read ({why}); to restore the copy kept with the run: `{again}`") from error
    if kept is None or text == kept:
        return text
    lines = list(difflib.unified_diff(kept.splitlines(), text.splitlines(), n=0, lineterm=""))[2:]
    shown = "\n".join("  " + "".join(c if c.isprintable() else "?" for c in line)[:160] for line in lines[:_SHOWN])
    more = f"\n  ... and {len(lines) - _SHOWN} more lines" if len(lines) > _SHOWN else ""
    raise FileTrouble(f"{path}: not the deck this run was started with; it has been changed since (- then, + now):\n{shown}{more}\n"
                      f"To continue with the original deck: `hugoniot resume {path.parent} --restore-deck`; "
                      f"to run the changed one in a new folder: `hugoniot run {path} --out NEW`")
