"""Checkpoints of the cells mode: mesh, fronts and their record as numbers and words, and back."""

import numpy as np

from hugoniot.solvers.fronts.cells import fans, tables
from hugoniot.solvers.fronts.cells.mesh import Front, Mesh
from hugoniot.solvers.fronts.record import COLUMNS

_COUNTS = ("meetings", "captured", "untracked", "formed", "joined")


def payload(solver) -> dict:
    """Everything a bitwise restart needs."""
    mesh, trace = solver.mesh, solver.trace
    fronts = [{"kind": f.kind, "numbers": [f.speed, float(f.direction), f.strength, float(f.least), f.since, f.start],
               "sides": np.array(f.sides, dtype=float), "fan": [] if f.fan is None else fans.numbers_of(f.fan)} for f in mesh.fronts]
    return {"x": mesh.x.copy(), "q": mesh.q.copy(), "region": mesh.region.copy(), "marked": mesh.marked.copy(), "given": mesh.given.copy(),
            "push": mesh.push.copy(), "level": mesh.level.copy(), "fronts": fronts, "samples": solver.samples,
            "zones": solver.flow.work.zones.copy(), "numbers": solver.flow.work.numbers.copy(),
            "dropped": solver.flow.bench.dropped, "crushing": solver.flow.bench.crushing,
            "strengths": [[k, *v] for k, v in solver.flow.bench.strongest.items()], "strongest": solver.changes.strongest,
            "weakest": solver.flow.bench.weakest,
            "changes": [getattr(solver.changes, name) for name in _COUNTS], "passed": solver.flow.work.passed.copy(),
            "start_totals": solver.start_totals.copy(), "start_size": solver.start_size.copy(),
            "refining": solver.refining.numbers(),
            "voids": [solver.voids_opened, solver.voids_closed], "life_kinds": list(trace.lines()[0]),
            "life_rows": np.array(trace.lines()[1], dtype=float).reshape(-1, len(COLUMNS)),
            "jumps": [[k, v] for k, v in trace.jumps.items()], "tensions": [[k, v] for k, v in trace.tensions.items()]}


def restore(solver, payload: dict) -> None:
    """Continue from a payload of the same problem."""
    fronts = []
    for row in payload["fronts"]:
        speed, direction, strength, least, since, start = row["numbers"]
        fan = fans.fan_of(row["fan"], solver.flow.bench) if row["fan"] else None
        sides = tuple(tuple(side) for side in row["sides"].tolist())
        fronts.append(Front(row["kind"], speed, int(direction), strength, int(least), since, start, sides, fan))
    solver.mesh = Mesh(payload["x"].copy(), payload["q"].copy(), payload["region"].copy(), payload["marked"].astype(bool), fronts,
                       solver.problem.dimension, payload["given"].copy(), payload["push"].copy(),
                       payload["level"].astype(np.int64))
    work = solver.flow.work
    work.numbers[:], work.passed[:], work.zones[:] = payload["numbers"], payload["passed"], payload["zones"]
    solver.cycle, solver.step = int(work.numbers[tables.CYCLE]), float(work.numbers[tables.STEP])
    solver.samples = int(payload["samples"])
    solver.flow.bench.dropped, solver.flow.bench.crushing = int(payload["dropped"]), int(payload["crushing"])
    solver.flow.bench.strongest = {int(k): (float(a), float(b)) for k, a, b in payload["strengths"]}
    solver.changes.strongest = float(payload["strongest"])
    solver.flow.follow(float(payload["weakest"]))
    for name, value in zip(_COUNTS, payload["changes"]):
        setattr(solver.changes, name, int(value))
    solver.start_totals, solver.start_size = payload["start_totals"].copy(), payload["start_size"].copy()
    solver.voids_opened, solver.voids_closed = (int(n) for n in payload["voids"])
    solver.refining.set_numbers(payload["refining"])
    trace = solver.trace
    trace.replace(list(payload["life_kinds"]), [list(row) for row in payload["life_rows"].tolist()])
    trace.jumps, trace.tensions = ({int(k): float(v) for k, v in payload[name]} for name in ("jumps", "tensions"))
    solver._times, solver._rows, solver._read_at = [], [], (-1, 0)
