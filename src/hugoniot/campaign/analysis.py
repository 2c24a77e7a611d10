"""What a sampled sweep says about its parameters, as tables on the disk: sensitivity.csv, spread.csv and bands.csv beside cases.csv."""

import csv
import io
import pathlib
from dataclasses import astuple, dataclass, fields

import numpy as np

from hugoniot.campaign.designs import Design
from hugoniot.campaign.sensitivity import QUANTILES, Effect, Index, Quantiles, bands, effects, indices, quantiles
from hugoniot.output.atomic import write_whole
from hugoniot.output.sweep_file import SweepTable

FILES = ("sensitivity.csv", "spread.csv", "bands.csv")
CONSTANTS = "constants.csv"


@dataclass(frozen=True)
class Analysis:
    """sensitivity: Sobol' indices or Morris' effects, by result; spread: of every result; bands: of every record (see `bands`)."""

    kind: str
    sensitivity: dict[str, list[Index] | list[Effect]]
    spread: dict[str, Quantiles]
    bands: dict[str, np.ndarray]


def analysis_of(design: Design, table: SweepTable) -> Analysis | None:
    """What a sampled design says; None for a grid or a table of cases."""
    if design.shares is None:
        return None
    names = [variable.name for variable in design.variables]
    found: dict[str, list] = {}
    for result in table.results:
        rows: list = []
        if design.kind == "saltelli":
            rows = indices(table, result, len(design) // (len(names) + 2), names, design.seed)
        elif design.kind == "morris":
            rows = effects(table, result, design.shares, names)
        if rows:
            found[result.name] = rows
    cases = 2 * len(design) // (len(names) + 2) if design.kind == "saltelli" else len(design)
    spread = {} if design.kind == "morris" else {result.name: quantiles(result, cases) for result in table.results}
    return Analysis(design.kind, found, spread, {} if design.kind == "morris" else bands(table, cases))


def write_analysis(folder, found: Analysis | None, table: SweepTable) -> None:
    """Write what there is, and remove what an earlier sweep of the folder has left."""
    folder = pathlib.Path(folder)
    units = {column.name: column.unit for column in (*table.results, *table.records)}
    texts = dict.fromkeys(FILES, "")
    if found is not None and found.sensitivity:
        first = next(iter(found.sensitivity.values()))[0]
        rows = [astuple(row) for each in found.sensitivity.values() for row in each]
        texts["sensitivity.csv"] = _csv([f.name for f in fields(first)], rows)
    if found is not None and found.spread:
        heads = ["result", "unit", "mean", "standard deviation", *(f"{q:g} quantile" for q in QUANTILES), "cases"]
        rows = [(s.result, units[s.result], s.mean, s.deviation, *s.quantiles, s.count) for s in found.spread.values()]
        texts["spread.csv"] = _csv(heads, rows)
    if found is not None and found.bands and table.times is not None:
        heads = ["time [s]", *(f"{name} {q:g} quantile [{units[name]}]" for name in found.bands for q in QUANTILES)]
        rows = np.column_stack([table.times, *(band.T for band in found.bands.values())]).tolist()
        texts["bands.csv"] = _csv(heads, rows)
    for name, text in texts.items():
        if text:
            write_whole(folder / name, text)
        else:
            (folder / name).unlink(missing_ok=True)


def write_constants(folder, rows: list[list[str]]) -> None:
    """Write the standard deviations of the library's constants that a sweep used, or remove those of an earlier one."""
    path = pathlib.Path(folder) / CONSTANTS
    if rows:
        write_whole(path, _csv(["material", "constant", "value", "unit", "standard deviation", "sources, or why it is held"], rows))
    else:
        path.unlink(missing_ok=True)


def _csv(heads, rows) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(heads)
    for row in rows:
        writer.writerow(["" if isinstance(v, float) and v != v else repr(float(v)) if isinstance(v, float) else v for v in row])
    return out.getvalue()
