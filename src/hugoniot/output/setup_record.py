"""The set-up of a run as one JSON document: what was asked, every constant with its source, and the bibliography of what is used.

Plots and reports read this document from the run folder; they never see the problem itself.
"""

import dataclasses
import math
from typing import Any

from hugoniot.core.registry import Registry
from hugoniot.dossier.derived import wave_speeds
from hugoniot.errors import HugoniotError
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import EOS, pressure, reference_state
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials import burning
from hugoniot.materials.initial_state import initial_state
from hugoniot.materials.reach import reach
from hugoniot.problem.profiles import end_velocities
from hugoniot.problem.starting import part_freely

_FAMILIES = {"eos": EOS, "strength": STRENGTH, "fracture": FRACTURE, "viscosity": VISCOSITY}

INTEGRATORS = {
    "compatible": ("Compatible (virtual-work) Lagrangian differences: E. J. Caramana, D. E. Burton, M. J. Shashkov, P. P. Whalen, "
                   "J. Comput. Phys. 146 (1998) 227-262",
                   "Steps of drift, kick and drift: M. Tuckerman, B. J. Berne, G. J. Martyna, J. Chem. Phys. 97 (1992) 1990-2001"),
    "wilkins": ("Wilkins, appendix B (KO), eqs. B.2: leapfrog differences in one dimension, three symmetries, with voids (B.4)",),
}

VISCOUS_FLOW = (
    "Navier-Stokes flow resolved without artificial viscosity: Jordan 2011, chapters 2 and 6",
    "Faces: fifth-order WENO-Z, R. Borges, M. Carmona, B. Costa, W. S. Don, J. Comput. Phys. 227 (2008) 3191-3211",
    "Time: third-order Runge-Kutta, C.-W. Shu, S. Osher, J. Comput. Phys. 77 (1988) 439-471",
    "Dissipation that gives way to physical viscosity: D. B. Spalding, Int. J. Numer. Meth. Eng. 4 (1972) 551-559",
)


def plain(value: Any) -> Any:
    """Numbers, words, lists and dictionaries only: what JSON can hold."""
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return {f.name: plain(getattr(value, f.name)) for f in dataclasses.fields(value)}
    if hasattr(value, "_asdict"):
        return {key: plain(inner) for key, inner in value._asdict().items()}
    if hasattr(value, "items"):
        return {str(key): plain(inner) for key, inner in value.items()}
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, (list, tuple, set, frozenset)):
        return [plain(inner) for inner in value]
    return value if value is None or isinstance(value, (bool, int, float, str)) else str(value)


def _source_of(sources, family: str, name: str):
    for source in sources:
        if source.quantity in (f"{family}.{name}", name):
            return source
    return None


def law_record(family: Registry, par, sources=()) -> dict:
    """Name, first line, parameters (value, unit, meaning, source, status) and references of the law whose parameters `par` is."""
    law = family.of(par)
    constants, inner = [], []
    for name, value in zip(par._fields, par):
        if isinstance(value, tuple) and hasattr(value, "_fields"):
            inner.append(law_record(family, value, sources))
            continue
        source = _source_of(sources, family.family, name)
        constants.append({
            "name": name, "value": plain(value), "unit": law.units.get(name, ""), "meaning": law.meaning.get(name, ""),
            "source": (source.source + (f" (via {source.via})" if source.via else "")) if source else "",
            "status": source.status if source else "user", "note": source.note if source else "",
        })
    return {"family": family.family, "law": law.name, "summary": law.summary, "constants": constants, "inner": inner,
            "references": list(law.references)}


def material_record(material) -> dict:
    """Laws that the run uses, with every constant and its source, the sources that name no parameter, and warnings."""
    laws, sources = [], material.sources
    for family in ("eos", "strength", "fracture"):
        par = getattr(material, family)
        if par is not None:
            laws.append(law_record(_FAMILIES[family], par, material.sources))
    if material.burn is not None:
        laws.append(_burn_record(material.burn, material.sources))
        if not burning.has_reactants(material):     # a programmed burn goes from no pressure to the products
            sources = tuple(source for source in sources if not source.quantity.startswith("unreacted."))
        elif material.unreacted is not None:
            own = tuple(dataclasses.replace(source, quantity="eos." + source.quantity.removeprefix("unreacted."))
                        for source in material.sources if source.quantity.startswith("unreacted."))
            laws.append({**law_record(EOS, material.unreacted, own), "family": "unreacted"})
    named = {constant["name"] for law in laws for constant in law["constants"]}
    others = [plain(source) for source in sources if source.quantity.rpartition(".")[2] not in named]
    return {"name": material.name, "laws": laws, "other_sources": others, "warnings": list(material.warnings),
            "valid_up_to": material.valid_up_to, "reach": reach(material), "at_rest": _at_rest(material)}


def _at_rest(material) -> dict[str, float]:
    """The reference state as of `_state`, as far as the laws give it; nothing for explosives."""
    if material.burn is not None or "reacted" in EOS.of(material.eos).flags:
        return {}
    try:
        return _state(material, *reference_state(material.eos))
    except (HugoniotError, ArithmeticError, ValueError):
        return {}


def _state(material, rho, e) -> dict[str, float]:
    """density (kg/m3) and pressure (Pa) of the state (rho, e), and the speeds of waves into it (`wave_speeds`)."""
    found = {"density": rho, "pressure": pressure(rho, e, material.eos), **wave_speeds(material, rho, e)}
    return {name: float(value) for name, value in found.items() if math.isfinite(value)}


def _region_record(region, material) -> dict:
    """A region with the velocities at its ends where they follow a profile, and the state in which it starts, where that is one and not
    its material's reference state."""
    record = plain(region)
    if region.profile is not None and "velocity" in dict(region.profile.fields):
        left, right = end_velocities(region)
        record["velocity"] = left if left == right else [left, right]
    given = [getattr(region, name) for name in ("density", "pressure", "temperature", "energy")]
    varies = region.profile is not None and any(name != "velocity" for name, _ in region.profile.fields)
    if material.burn is not None or varies or all(value is None for value in given):
        return record
    return {**record, "starts": _state(material, *initial_state(material.eos, *given))}


def _burn_record(par, sources) -> dict:
    return law_record(BURN, par, sources)


def transport_record(transport) -> dict:
    """{"laws": shear viscosity and conduction, "bulk_ratio", "bulk_viscosity" (Pa s)} of a `Transport` tuple."""
    return {"laws": [law_record(TRANSPORT, transport.shear), law_record(CONDUCTION, transport.conduction)],
            "bulk_ratio": transport.bulk_ratio, "bulk_viscosity": transport.bulk_viscosity}


def _with_transport(record: dict, table: Any) -> dict:
    """A material's record with the laws of its own physical viscosity and conduction (`problem.terms`), where it has any, and its bulk
    viscosity."""
    laws = [law_record(family, family.get(table[key]["law"]).build(**{k: v for k, v in table[key].items() if k != "law"}))
            for key, family in (("viscosity", TRANSPORT), ("conduction", CONDUCTION)) if table and key in table]
    bulk = {"bulk": {key: table[key] for key in ("bulk_ratio", "bulk_viscosity")}} if table and "viscosity" in table else {}
    return {**record, "laws": record["laws"] + laws, **bulk}


def _viscosity_record(problem, meta: dict) -> dict | None:
    par = meta.get("viscosity")
    if hasattr(par, "_fields"):
        return law_record(VISCOSITY, par)
    given = problem.solver.viscosity
    if not given:
        return None
    law = VISCOSITY.get(given[0])
    return law_record(VISCOSITY, law.build(**{**law.defaults, **dict(given[1])}))


def _references(record: dict, meta: dict) -> list[str]:
    hydrocode = record["solver"]["kind"] == "lagrange1d"
    found: list[str] = list(INTEGRATORS.get(record["solver"]["integrator"], ())) if hydrocode else []
    return references_of(record, [*found, *meta.get("references", ())])


def references_of(record: dict, methods: list[str]) -> list[str]:
    """The bibliography of a set-up record: of the methods, then of every law, constant and material in it, each once."""
    found = list(methods)
    laws = [law for material in record["materials"].values() for law in material["laws"]]
    laws += [record["viscosity"]] if record["viscosity"] else []
    if record["transport"]:
        found += VISCOUS_FLOW
        laws += record["transport"]["laws"]
    while laws:
        law = laws.pop(0)
        found += law["references"] + [c["source"] for c in law["constants"] if c["source"]]
        laws += law["inner"]
    for material in record["materials"].values():
        found += [source["source"] for source in material["other_sources"] if source["source"]]
    return list(dict.fromkeys(found))


def setup_record(problem, meta: dict) -> dict:
    """The whole document. `meta` may add `references` (list of text) and `viscosity` (parameter tuple in use)."""
    record = {
        "title": problem.title, "geometry": problem.geometry, "stop_time": problem.stop_time,
        "solver": {**plain(problem.solver), "kind": meta.get("solver", problem.solver.kind)},
        "version": meta.get("version", ""),
        "regions": [_region_record(region, problem.materials[region.material]) for region in problem.regions],
        "boundaries": {"left": plain(problem.left), "right": plain(problem.right)},
        "interfaces": [plain(interface) for interface in problem.interfaces],
        "parting": [f"{a.name}/{b.name}" for a, b in zip(problem.regions, problem.regions[1:]) if part_freely(problem, a, b)],
        "gauges": [plain(gauge) for gauge in problem.gauges],
        "materials": {name: _with_transport(material_record(problem.materials[name]), getattr(problem, "transport", {}).get(name))
                      for name in sorted({r.material for r in problem.regions})},
        "viscosity": _viscosity_record(problem, meta),
        "transport": transport_record(meta["transport"]) if meta.get("transport") else None,
    }
    record["references"] = _references(record, meta)
    return record
