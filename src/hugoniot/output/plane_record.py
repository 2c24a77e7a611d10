"""What the run folder keeps of a two-dimensional run: the record of its set-up, and the recorder that hands it states."""

from typing import Any

from hugoniot.diagnostics.budgets2d import PlaneBudget
from hugoniot.diagnostics.gauges2d import NODAL, OF_SURFACES, blocks_of
from hugoniot.diagnostics.plane_fields import PlaneFields
from hugoniot.diagnostics.temperature import gauge_temperature, laws_with_temperature, zone_temperature
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.output.recorder import Recorder
from hugoniot.output.setup_record import material_record, plain, references_of
from hugoniot.problem.plane.contact_model import centre_of
from hugoniot.problem.plane.impacts import struck_gauges

METHODS = (
    "Compatible staggered Lagrangian differences: E. J. Caramana, D. E. Burton, M. J. Shashkov, P. P. Whalen, "
    "J. Comput. Phys. 146 (1998) 227-262",
    "Rotation of stress: Jaumann rate, W. Herrmann, WL-TR-64-107 (1964), eqs. B.23-B.29",
)
_VISCOSITY = {
    "edge": "Edge viscosity: E. J. Caramana, M. J. Shashkov, P. P. Whalen, J. Comput. Phys. 144 (1998) 70-97",
    "tensor": "Tensor viscosity: T. V. Kolev, R. N. Rieben, J. Comput. Phys. 228 (2009) 8336-8366",
}
_FILTERS = {
    "subzonal_pressure": "Subzonal pressure: E. J. Caramana, M. J. Shashkov, J. Comput. Phys. 142 (1998) 521-561",
    "flanagan_belytschko": "Hourglass viscosity: D. P. Flanagan, T. Belytschko, Int. J. Numer. Meth. Eng. 17 (1981) 679-706",
}


def plane_record(problem, meta: dict) -> dict:
    """The set-up document of a `Problem2D`, with the keys of `setup_record.setup_record` where they have a meaning."""
    record = {
        "title": problem.title, "geometry": problem.geometry, "axes": list(problem.axes), "stop_time": problem.stop_time,
        "solver": plain(problem.solver), "version": meta.get("version", ""),
        "regions": [plain(block) for block in problem.blocks],
        "boundaries": {name: plain(boundary) for name, boundary in problem.chain_boundaries().items()},
        "chains": {name: plain(problem.mesh.nodes[:, chain.edges].transpose(1, 2, 0)) for name, chain in problem.mesh.chains.items()},
        "contacts": [plain(contact) for contact in problem.contacts],
        "rigid": [plain(body) | {"centre": list(centre_of(body))} for body in problem.rigid],
        "interfaces": [], "joints": list(problem.mesh.joints), "body_force": list(problem.body_force),
        "gauges": [plain(gauge) for gauge in problem.gauges], "struck": struck_gauges(problem),
        "lighting": [plain(point) for point in problem.lighting],
        "materials": {name: material_record(problem.materials[name]) for name in sorted({b.material for b in problem.blocks})},
        "viscosity": None, "transport": None,
    }
    solver = problem.solver
    used = [*METHODS, _VISCOSITY.get(solver.viscosity.kind, ""), *(words for key, words in _FILTERS.items() if getattr(solver, key) > 0.0)]
    record["references"] = references_of(record, [text for text in (*used, *meta.get("references", ())) if text])
    return record


def plane_meta(problem, solver, version: str) -> dict[str, Any]:
    """What `RunFolder.start` is given of a two-dimensional run."""
    mesh = problem.mesh
    centres = mesh.nodes[:, mesh.zone_nodes].mean(axis=2)
    return {
        "solver": problem.solver.kind, "version": version, "region": [problem.blocks[k].name for k in mesh.block_of],
        "mass": solver.state().zones["mass"], "centre_x": centres[0], "centre_y": centres[1],
        "gauges": [gauge.name for gauge in problem.gauges],
        "mesh": {"zone_nodes": mesh.zone_nodes, "block_of": mesh.block_of, "node_count": mesh.nodes.shape[1],
                 "node_fields": (*NODAL, *OF_SURFACES)},
    }


class PlaneRecorder(Recorder):
    """Keeps the states of a two-dimensional run."""

    def __init__(self, folder, problem, solver, show=None, warned=()):
        super().__init__(folder, problem, solver, show, warned)
        self.kept = set(problem.output.fields)
        self.budget = PlaneBudget(problem)
        self.derived = PlaneFields(self.kept, problem, solver.state())
        self.laws = laws_with_temperature(problem)
        self.hot = any(law is not None for law in self.laws)
        laws = [None if k is None else self.laws[k] for k in blocks_of(problem)]
        self.gauge_laws = [None if law is None or MIXTURE.knows(law) else law for law in laws]

    def gauges(self, times, values):
        if len(times) and self.problem.gauges:
            if self.hot and "density" in values:
                # of gauges that read one material which does not burn; NaN elsewhere
                values = {**values, "temperature": gauge_temperature(values, self.gauge_laws)}
            self.folder.gauges(times, values)

    def snapshot(self, state):
        fields = state.fields()
        if self.hot:
            fields["temperature"] = zone_temperature(state, self.problem.mesh.block_of, self.laws, self.solver.phases())
        fields.pop("mass")
        fields |= self.derived(state, fields.get("temperature"))
        if self.kept:
            fields = {name: value for name, value in fields.items() if name in self.kept or name in NODAL or name == "eroded"}
        self.keep(state, fields, self.budget(state, self.solver.kinetic_energy(), self.solver.all_zones()))
