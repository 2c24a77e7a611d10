"""A finished run of which a file is missing, or in whose folder the means of an unfinished one still lie, is made whole."""

import contextlib
import os
import pathlib
import shutil

from hugoniot.output.atomic import legible, write_whole
from hugoniot.output.result_file import write_gauges
from hugoniot.output.run import Run, load
from hugoniot.output.run_folder import RunFolder
from hugoniot.output.series import Table


def copied(folder, room) -> pathlib.Path:
    """A folder inside `room` with what an unfinished run has set down, under the name of the run's own; files are linked where they can be.

    What the run takes away meanwhile is left out: a checkpoint is believed only if all its parts are there.
    """
    folder = pathlib.Path(folder)
    copy = pathlib.Path(room) / (folder.resolve().name or "run")
    with legible(folder):
        for path in (folder / "run.log", *folder.glob("checkpoint/*"), *folder.glob("pieces/*")):
            to = copy / path.relative_to(folder)
            to.parent.mkdir(parents=True, exist_ok=True)
            with contextlib.suppress(FileNotFoundError):
                _link(path, to)
    return copy


def _link(path: pathlib.Path, to: pathlib.Path) -> None:
    if path.name != "run.log":      # which a run goes on writing
        try:
            return os.link(path, to)
        except FileNotFoundError:
            raise
        except OSError:     # a file system without links
            pass
    shutil.copyfile(path, to)


def complete(place: RunFolder) -> Run:
    """The finished run of a folder, after gauges.csv and deck.toml were written again from result.h5 where they are missing.

    Raises `FileTrouble` if the result is damaged.
    """
    run, folder = load(place.folder), place.folder
    deck = run.deck     # reading it compares the SHA-256 of the result
    if not (folder / "deck.toml").exists():
        write_whole(folder / "deck.toml", deck)
    if not (folder / "gauges.csv").exists():
        columns = {name: values for name, values in run.arrays("gauges").items() if name != "gauge"}
        units = {name: run.unit("gauges", name) for name in columns}
        write_gauges(folder / "gauges.csv", Table.of(columns), run.gauge_names(), units)
    place.tidy()
    return run
