"""Whether the files of a run folder are as the run has left them: `hugoniot info --verify`."""

import contextlib
import hashlib
import pathlib
from typing import NamedTuple

from hugoniot.errors import FileTrouble
from hugoniot.files import read_regular
from hugoniot.output.atomic import digest, legible
from hugoniot.output.checkpoint import START, Checkpoints
from hugoniot.output.claim import same_deck
from hugoniot.output.listed import LISTS
from hugoniot.output.run import read_post_mortem
from hugoniot.output.salvage import readable
from hugoniot.output.seal import intact, read_sealed
from hugoniot.output.series import Series

SOUND, CHANGED, MISSING, UNKNOWN = "sound", "changed", "missing", "no checksum"


class Finding(NamedTuple):
    """What was found about one file: `state` is sound, changed, missing or no checksum; `detail` a few words."""

    file: str
    state: str
    detail: str = ""

    @property
    def bad(self) -> bool:
        """Whether the file is not what the run has written."""
        return self.state in (CHANGED, MISSING)


def verify(folder, survey: bool = True) -> list[Finding]:
    """A finding for every file of a finished, failed or unfinished run, a sweep or a fit. Raises `FileTrouble` if there is none of these.

    survey   look which columns of a changed result can still be read, in a process of its own
    """
    folder = pathlib.Path(folder)
    if not folder.is_dir():
        what = "this is a file, not a run folder" if folder.exists() else "there is no such run folder"
        raise FileTrouble(f"{folder}: {what}")
    if (folder / "summary.json").exists() or (folder / "result.h5").exists():
        return _finished(folder, "summary.json", survey)
    for name in LISTS:
        if (folder / name).exists():
            return _finished(folder, name, survey)
    found = _unfinished(folder) + _failed(folder)
    if not found:
        raise FileTrouble(f"{folder}: this is not a run folder (no result.h5)")
    return found


def _finished(folder: pathlib.Path, summing: str, survey: bool) -> list[Finding]:
    """Findings of the files whose checksums the file `summing` of the folder keeps."""
    path = folder / summing
    try:
        with legible(path):
            data = read_regular(path)
        summary = read_sealed(path, data, ("sha256", "run_log_bytes"))
    except FileTrouble as error:
        return [Finding(summing, CHANGED if path.exists() else MISSING, _why(error, path))]
    if "sha256" not in summary:
        what = "a run of an early version" if summing == "summary.json" else "unfinished, or of an early version"
        return [Finding(summing, UNKNOWN, f"{what}; its files have no checksums")]
    sums, length = summary["sha256"], summary.get("run_log_bytes", 0)
    if not isinstance(sums, dict) or not isinstance(length, int) or any(name != pathlib.Path(name).name for name in sums):
        return [Finding(summing, CHANGED, "its list of checksums names files outside the folder, or is not a list")]
    found = [Finding(summing, SOUND)]
    for name, wanted in sums.items():
        found.append(_file(folder / name, summing, wanted, length if name == "run.log" else None, survey))
    if (folder / "report.html").exists():
        found.append(_page(folder / "report.html"))
    return found


def _file(path: pathlib.Path, summing: str, wanted: str, length: int | None, survey: bool) -> Finding:
    try:
        if length is None:
            now = digest(path).sha256
        else:       # lines may have been added since
            now = hashlib.sha256(read_regular(path)[:length]).hexdigest()
    except OSError as error:
        return Finding(path.name, MISSING, error.strerror or str(error))
    if now == wanted:
        return Finding(path.name, SOUND)
    detail = f"its SHA-256 does not agree with {summing}"
    if path.name == "result.h5" and survey:
        detail += "; " + _what_is_left(path)
    return Finding(path.name, CHANGED, detail)


def _what_is_left(path: pathlib.Path) -> str:
    columns = readable(path)
    if not columns:
        return "nothing of it can be read"
    lost = [name for name, state in columns.items() if state]
    words = f"{len(columns) - len(lost)} of {len(columns)} columns can be read with hugoniot.load(folder, partial=True)"
    return words + (f", not {', '.join(lost[:6])}" + (" and others" if len(lost) > 6 else "") if lost else "")


def _page(path: pathlib.Path) -> Finding:
    try:
        text = read_regular(path).decode("utf-8", "surrogateescape")
    except OSError as error:
        return Finding(path.name, MISSING, str(error))
    return Finding(path.name, SOUND) if intact(text) else Finding(path.name, CHANGED, "its own SHA-256 does not agree; "
                                                                  "`hugoniot report` writes it again")


def _unfinished(folder: pathlib.Path) -> list[Finding]:
    checkpoints, found = Checkpoints(folder / "checkpoint"), []
    kept = checkpoints.deck()
    if kept is not None:
        try:
            same_deck(folder / "deck.toml", kept)
            found.append(Finding("deck.toml", SOUND))
        except FileTrouble:
            found.append(Finding("deck.toml", CHANGED, "not the deck of this run; `hugoniot resume` shows the difference"))
    if (folder / "checkpoint" / START).exists():
        found.append(_trying(f"checkpoint/{START}", lambda: checkpoints.manifest(START)))
    series = Series(folder / "pieces")
    pieces: dict[str, str] = {}
    for number in checkpoints.numbers():
        found.append(_trying(f"checkpoint/{number:06d}", lambda number=number: checkpoints.check(number)))
        with contextlib.suppress(FileTrouble):
            pieces |= {str(name): wanted for name, wanted in checkpoints.check(number)[0]["pieces"]}
    for name, wanted in pieces.items():
        whole = series.intact([(name, wanted)])
        found.append(Finding(f"pieces/{name}", SOUND if whole else CHANGED))
    return found


def _failed(folder: pathlib.Path) -> list[Finding]:
    if not (folder / "post_mortem.txt").exists():
        return []
    return [_trying("post_mortem.h5, post_mortem.txt", lambda: read_post_mortem(folder))]


def _trying(name: str, look) -> Finding:
    try:
        look()
    except FileTrouble as error:
        return Finding(name, CHANGED, str(error))
    return Finding(name, SOUND)


def _why(error: FileTrouble, path: pathlib.Path) -> str:
    return str(error).removeprefix(f"{path}: ")
