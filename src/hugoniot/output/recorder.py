"""Hands what the time loop sees to the run folder: what runs of any number of dimensions share."""

import numpy as np

from hugoniot.output.origin import stamped


class Recorder:
    """An observer of `solvers.run.march_to_end` that keeps everything; `gauges` and `snapshot` are its heirs'.

    folder    the `RunFolder`
    show      progress display with update(report), or None
    warned    texts of the warnings given before the run began
    """

    def __init__(self, folder, problem, solver, show=None, warned=()):
        self.folder, self.problem, self.solver, self.show, self.warned = folder, problem, solver, show, warned

    def keep(self, state, fields: dict[str, np.ndarray], parts: dict[str, np.ndarray]) -> None:
        """One record: the fields of a snapshot, and the energies and momenta of each region with those of the whole run."""
        self.folder.snapshots([state.time], [state.cycle], {name: value[None, :] for name, value in fields.items()})
        whole = {name: np.array([value]) for name, value in {**self.solver.errors(), **self.solver.exchanges()}.items()}
        self.folder.budget([state.time], {**{name: value[None, :] for name, value in parts.items()}, **whole,
                                          "step": np.array([self.solver.step])})

    def event(self, event):
        self.folder.event(event.time, event.cycle, event.kind, event.text, position=event.position)

    def progress(self, report):
        if self.show is not None:
            self.show.update(report)

    def checkpoint(self, payload):
        self.folder.checkpoint(stamped(payload))
