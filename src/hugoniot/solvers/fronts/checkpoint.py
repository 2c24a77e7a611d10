"""Checkpoints of tracked fronts: the line of pieces and fronts, and the record of their lives, as numbers and words and back."""

import numpy as np

from hugoniot.laws.riemann.branch import State as Point
from hugoniot.laws.riemann.branch import elastic, loading
from hugoniot.laws.riemann.curve import Wave
from hugoniot.laws.riemann.fan import Fan
from hugoniot.laws.riemann.spreading import Spreading
from hugoniot.solvers.fronts.line import Front, Piece
from hugoniot.solvers.fronts.record import COLUMNS


def payload(solver) -> dict:
    """Everything a bitwise restart needs."""
    lives = solver.lives
    pieces = [{"kind": p.kind, "region": p.region, "state": list(p.state), "x0": p.x0, "t0": p.t0, "broken": p.broken,
               "wave": _wave_row(p.wave)} for p in solver.line.pieces]
    fronts = [{"kind": f.kind, "numbers": [f.x0, f.t0, f.speed, f.direction, f.strength, f.sliced], "born": lives.born[id(f)][1]}
              for f in solver.line.fronts]
    reach = [[k, *solver.extremes.reach[id(p)][1:]] for k, p in enumerate(solver.line.pieces) if id(p) in solver.extremes.reach]
    return {"extremes": solver.extremes.found.copy(), "reach": reach,
            "pieces": pieces, "fronts": fronts, "time": solver.time, "cycle": solver.cycle, "step": solver.step, "samples": solver.samples,
            "meetings": solver.line.meetings, "cuts": solver.line.cuts, "dropped": solver.bench.dropped,
            "work": solver.line.work.copy(), "impulse": solver.line.impulse.copy(),
            "start_totals": solver.start_totals.copy(), "start_size": solver.start_size.copy(),
            "walls": [[s, v] for s, v in solver.bench.walls.items()], "pressures": [[s, v] for s, v in solver.bench.pressures.items()],
            "changed": [[s, k] for s, k in solver._changed.items()], "voids": [solver.voids_opened, solver.voids_closed],
            "life_kinds": list(lives.kinds), "life_rows": np.array(lives.rows, dtype=float).reshape(-1, len(COLUMNS)),
            "jumps": [[k, v] for k, v in lives.jumps.items()], "tensions": [[k, v] for k, v in lives.tensions.items()]}


def restore(solver, payload: dict) -> None:
    """Continue from a payload of the same problem."""
    solver.line.pieces = [_piece(solver.bench, row) for row in payload["pieces"]]
    solver.line.fronts = [Front(row["kind"], *row["numbers"][:3], int(row["numbers"][3]), row["numbers"][4],
                               bool(row["numbers"][5])) for row in payload["fronts"]]
    solver.lives.born = {id(f): (f, list(row["born"])) for f, row in zip(solver.line.fronts, payload["fronts"])}
    solver.lives.kinds, solver.lives.rows = list(payload["life_kinds"]), [list(row) for row in payload["life_rows"].tolist()]
    solver.lives.jumps, solver.lives.tensions = ({int(k): float(v) for k, v in payload[name]} for name in ("jumps", "tensions"))
    solver.line.time, solver.cycle, solver.step = float(payload["time"]), int(payload["cycle"]), float(payload["step"])
    solver.samples, solver.line.meetings, solver.line.cuts = (int(payload[name]) for name in ("samples", "meetings", "cuts"))
    solver.bench.dropped = int(payload["dropped"])
    solver.line.work, solver.line.impulse = payload["work"].copy(), payload["impulse"].copy()
    solver.start_totals, solver.start_size = payload["start_totals"].copy(), payload["start_size"].copy()
    solver.extremes.found = payload["extremes"].copy()
    solver.extremes.reach = {id(solver.line.pieces[int(k)]): (solver.line.pieces[int(k)], float(low), float(high))
                             for k, low, high in payload["reach"]}
    solver.bench.walls = {int(s): float(v) for s, v in payload["walls"]}
    solver.bench.pressures = {int(s): float(v) for s, v in payload["pressures"]}
    solver._changed = {int(s): int(k) for s, k in payload["changed"]}
    solver.voids_opened, solver.voids_closed = (int(n) for n in payload["voids"])
    solver._times, solver._rows = [], []


def _piece(bench, row: dict) -> Piece:
    wave = None
    if row["wave"] is not None:
        n, matter = row["wave"]["numbers"], bench.matters[int(row["region"])]
        ahead = Point(*row["wave"]["ahead"])
        branch = elastic(matter, ahead)._replace(a=n[3], b=n[4])
        path = Fan(ahead, branch) if not row["wave"]["end"] else Spreading(ahead, loading(matter, ahead), matter.par).until(
            tuple(row["wave"]["end"]))
        wave = Wave("fan", bool(row["wave"]["elastic"]), int(n[0]), ahead, Point(*row["wave"]["behind"]), n[1], n[2], path, n[5])
    return Piece(row["kind"], int(row["region"]), Point(*row["state"]), wave, row["x0"], row["t0"], bool(row["broken"]))


def _wave_row(wave: Wave | None) -> dict | None:
    if wave is None:
        return None
    branch = wave.path.branch
    end = list(wave.path.nodes[-1]) if isinstance(wave.path, Spreading) else []
    return {"elastic": wave.elastic, "ahead": list(wave.ahead), "behind": list(wave.behind), "end": end,
            "numbers": [float(wave.direction), wave.head, wave.tail, branch.a, branch.b, wave.stiffness]}
