r"""Fracture at a node where the mean pressure and volume of the two adjoining zones satisfy both limits of `pressure_volume`.

$$\tfrac12(P_{j+1/2} + P_{j-1/2}) < P_S \;\text{ and }\; \tfrac12(V_{j+1/2} + V_{j-1/2}) > V_S, \qquad P_S < 0$$

* $P_{j\pm1/2}$, $V_{j\pm1/2}$: pressure, and volume relative to that at the reference density, of the zones on either side of node $j$
* $P_S$, $V_S$: their limits, `pressure_limit` (negative) and `volume_limit`

This is the criterion as Wilkins writes it; `pressure_volume` applies the same limits to single zones. Nodes between two materials are
not tested, because each material has limits of its own. The law is for one-dimensional runs of inert materials.
"""

from typing import NamedTuple

from hugoniot.laws.fracture import pressure_volume
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.fracture.pressure_volume import damage_rate, failure, tension_cap


class PressureVolumeAtNodes(NamedTuple):
    pressure_limit: float
    volume_limit: float = 1.0


def at_node(tension, p, v, slope, par):
    return failure(0.0, p, v, 0.0, par)


def build(pressure_limit, volume_limit=1.0):
    """Parameters; the pressure limit is a tension, hence negative, and the volume limit positive."""
    return PressureVolumeAtNodes(*pressure_volume.build(pressure_limit, volume_limit))


_zones = FRACTURE.get("pressure_volume")
FRACTURE.add(
    "pressure_volume_at_nodes", PressureVolumeAtNodes,
    functions=[failure, damage_rate, tension_cap, at_node],
    example=PressureVolumeAtNodes(-1.0e9, 1.01),
    build=build,
    units=_zones.units, meaning=_zones.meaning, defaults=_zones.defaults, box=_zones.box,
    references=_zones.references,
    flags=("nodes",),
)
