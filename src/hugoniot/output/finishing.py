"""A finished run of which a file is missing, or in whose folder the means of an unfinished one still lie, is made whole."""

from hugoniot.output.atomic import write_whole
from hugoniot.output.result_file import write_gauges
from hugoniot.output.run import Run, load
from hugoniot.output.run_folder import RunFolder
from hugoniot.output.series import Table


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
