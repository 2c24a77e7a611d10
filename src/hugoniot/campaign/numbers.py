"""The numbers of one run as one flat row: those that the terminal shows, each under a name such as `free surface.arrival`."""

from typing import Any

from hugoniot.output.columns import describe
from hugoniot.output.run_numbers import GAUGE_UNITS, SPALL, gauge_rows, is_lower_bound, spall_numbers

_SPALL_UNITS = {key: unit for key, _, unit in SPALL} | {
    "pull_back_lost": "m/s", "minimum_time": "s", "ringing_period": "s", "spall_strength_stepanov": "Pa", "spall_strength_at_least": "Pa"}
_SUMMARY = ("cycles", "end_time", "mass_error", "momentum_error", "energy_error", "voids_opened", "voids_closed", "interfaces_separated")
_OF_THE_CLOCK = ("wall_seconds", "kernel_seconds", "compile_seconds", "zone_updates", "run_log_bytes")


def numbers_of(run: Any) -> dict[str, float]:
    """Every number of a run (`Run` or `MemoryRun`), SI: per gauge `GAUGE.quantity`, `spall.quantity`, then errors, counts and results.

    A spall strength that is only a lower bound is called `spall.spall_strength_at_least`, so that no column mixes the two.
    """
    found: dict[str, float] = {}
    for row in gauge_rows(run):
        name = row.pop("gauge")
        found |= {f"{name}.{key}": float(value) for key, value in row.items()}
    spall = spall_numbers(run)
    found |= {"spall." + ("spall_strength_at_least" if is_lower_bound(key, spall) else key): float(value)
              for key, value in spall.items() if isinstance(value, (int, float))}
    summary = {"end_time" if key == "time" else key: value for key, value in run.summary.items()
               if isinstance(value, (int, float)) and not isinstance(value, bool)}
    wanted = [*_SUMMARY, *(key for key in summary if key not in _SUMMARY)]
    return found | {key: float(summary[key]) for key in wanted if key in summary and key not in _OF_THE_CLOCK}


def unit_of(name: str) -> str:
    """SI unit of a number of `numbers_of`; "1" for counts and ratios."""
    owner, dot, key = name.rpartition(".")
    if dot and owner == "spall":
        return _SPALL_UNITS.get(key, describe(key)[0] or "1")
    if dot and key in GAUGE_UNITS:
        return GAUGE_UNITS[key]
    if name == "end_time":
        return "s"
    return "1" if name in _SUMMARY else describe(key)[0] or "1"
