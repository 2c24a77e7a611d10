"""A material: laws with their numbers, and where the numbers come from."""

from dataclasses import dataclass, field
from typing import Any

from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.strength.contract import STRENGTH


@dataclass(frozen=True)
class Source:
    """Provenance of one constant: `status` is verified, corrected, derived, recalled (unverified against print) or user."""

    quantity: str
    value: float | str
    unit: str
    source: str
    via: str = ""
    status: str = "user"
    note: str = ""


PORES_REOPEN = ("the porous law of the unreacted explosive keeps no memory of crushing: on release before it burns, its pores reopen along "
                "the curve on which they closed; trust the shocks that start the burning, not the release behind them")

NOT_AT_REST = ("the unreacted explosive starts at {:.4g} MPa, not at zero pressure: weak shocks and long runs will be wrong; use the law "
               "jwl_unreacted, whose energy at rest follows from p = 0, or correct e0")

GRAINS_OVER_SERIES = ("grain_contact is based on a truncated cold curve, too soft for the first shock: the powder is compacted to its "
                      "grains where the exact curve would resist; use mie_gruneisen_cold as its base")


@dataclass(frozen=True)
class Material:
    """eos, strength, fracture, burn: parameter tuples of registered laws (all but `eos` may be None).

    valid_up_to   highest particle velocity (m/s) the equation of state's data reach; None where no source states it
    unreacted     of an explosive, whose `eos` are the products: equation of state before it burns (None: not known)
    mixture       name of the closure that joins both while it burns (None: the burn law's usual one, `materials.burning`)
    detonation_energy   chemical energy, J/kg (None: from the reference states of the two laws)
    reference_state     "rolling" or "frozen": where the isentrope of reactants in thermal isolation starts (None: it rolls)
    """

    name: str
    eos: Any
    strength: Any = None
    fracture: Any = None
    burn: Any = None
    valid_up_to: float | None = None
    sources: tuple[Source, ...] = field(default=())
    warnings: tuple[str, ...] = field(default=())
    unreacted: Any = None
    mixture: str | None = None
    detonation_energy: float | None = None
    reference_state: str | None = None

    def laws(self) -> dict[str, str]:
        """Family -> name of the law used; of an explosive "eos" are the products, "unreacted" is the law before burning."""
        found = {"eos": EOS.of(self.eos).name}
        if self.strength is not None:
            found["strength"] = STRENGTH.of(self.strength).name
        if self.fracture is not None:
            found["fracture"] = FRACTURE.of(self.fracture).name
        if self.burn is not None:
            found["burn"] = BURN.of(self.burn).name
        if self.unreacted is not None:
            found["unreacted"] = EOS.of(self.unreacted).name
        return found
