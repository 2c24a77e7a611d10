"""Further terms of a run (body force, heat sources, transport): their arrays, and those used by the lists of a material."""

from typing import NamedTuple

import numpy as np

from hugoniot.core.pass_lists import place, places
from hugoniot.errors import OutOfRange
from hugoniot.laws.transport.contract import Transport
from hugoniot.problem.model import Problem
from hugoniot.problem.terms import defects, transport_of
from hugoniot.solvers.lagrange1d.conduction import Conduction
from hugoniot.solvers.lagrange1d.sources import Force, Supply, force_of, supply_of
from hugoniot.solvers.lagrange1d.tables import zone_table
from hugoniot.zones.transport import TransportRows, zone_transport


class Marching(NamedTuple):
    """What compiled code takes."""

    force: Force
    supply: Supply
    conduction: Conduction


class NoTerms(NamedTuple):
    """What compiled code takes of a run that has none: nothing is compiled for it."""

    none: int = 0


class Terms(NamedTuple):
    """The terms of a run; `transports` and `heated` (indices of heat sources) by material."""

    force: Force
    supply: Supply
    conduction: Conduction
    transports: tuple[Transport | None, ...]
    heated: tuple[tuple[int, ...], ...]
    forced: bool

    @property
    def marching(self) -> Marching | NoTerms:
        """Its compiled part."""
        any_of_them = self.forced or self.supply.sums.size or self.conduction.scratch.size
        return Marching(self.force, self.supply, self.conduction) if any_of_them else NoTerms()

    def rows(self, at, k: int, origin: int):
        """Rows `at` of material k (a `plan.LineRows`) with those of its terms, which the given origin moves."""
        supplied = tuple((place(self.supply.weights[i], origin), self.supply.amounts[i]) for i in self.heated[k])
        own = self.transports[k]
        if own is None:
            return at._replace(supplied=supplied)
        bulk = np.array([own.bulk_ratio, own.bulk_viscosity])
        return at._replace(t=places(TransportRows, self.conduction.rows, origin), transport=own, bulk=bulk, supplied=supplied)


def terms_of(problem: Problem, zones, faces, ranges) -> Terms:
    """The terms of a problem whose zones have the faces (left, right); raises `OutOfRange` for what it cannot have."""
    for _, message, hint in defects(problem):
        raise OutOfRange(f"{message}; {hint}")
    names = list(dict.fromkeys(region.material for region in problem.regions))
    transports = tuple(zone_transport(transport_of(problem.transport[name])) if name in problem.transport else None for name in names)
    of_region = {region.name: region.material for region in problem.regions}
    heated = tuple(tuple(i for i, source in enumerate(problem.heat_sources) if of_region[source.region] == name) for name in names)
    table = zone_table(len(TransportRows._fields), zones.shape[1] if any(transports) else 0)
    conducts = any(own is not None and own.conduction is not None for own in transports)
    rows, forced = table[:, :zones.shape[1]], problem.body_force is not None
    conduction = Conduction(rows, np.zeros((5, rows.shape[1] if conducts else 0)))
    return Terms(force_of(problem), supply_of(problem, zones, faces, ranges), conduction, transports, heated, forced)
