"""A material: laws with their numbers, and where the numbers come from."""

from dataclasses import dataclass, field
from typing import Any

from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.strength.contract import STRENGTH


@dataclass(frozen=True)
class Source:
    """Where one constant comes from.

    quantity      the constant, such as "eos.c0"
    value, unit   as in the source
    source        the publication
    via           the file or collection through which it was obtained, or ""
    status        "verified" (read in a public file), "corrected" (as verified, with an error of the file corrected), "derived" (computed
                  by hugoniot), "recalled" (from no file, not checked against the printed source) or "user" (of your own material)
    note          remarks, or ""
    """

    quantity: str
    value: float | str
    unit: str
    source: str
    via: str = ""
    status: str = "user"
    note: str = ""


PORES_REOPEN = ("the porous law of the unreacted explosive keeps no memory of crushing: on release before it burns, its pores reopen along "
                "the curve on which they closed; rely on the shocks that start the burning, not on the release behind them")

NOT_AT_REST = ("the unreacted explosive starts at {:.4g} MPa, not at zero pressure: weak shocks and long runs will be wrong; use the law "
               "jwl_unreacted, whose reference energy follows from zero pressure, or correct e0")

GRAINS_OVER_SERIES = ("the base of grain_contact is a truncated cold curve, which is too soft in the first shock: the powder is compacted "
                      "to its grains where the exact curve would not be; use mie_gruneisen_cold as its base")


@dataclass(frozen=True)
class Material:
    """The laws of one material, with their constants in SI.

    eos                 parameters of the equation of state; of an explosive, that of its products
    strength, fracture, burn   parameters of these laws, or None
    valid_up_to         highest particle velocity of the data behind the equation of state, m/s; None: not known
    sources             a `Source` for each constant
    warnings            strings to print when the material is used
    unreacted           parameters of the equation of state of an explosive before it burns, or None
    mixture             how reactants and products share a zone; None: chosen by the burn law
    detonation_energy   chemical energy per mass, J/kg; None: from the two equations of state
    reference_state     "rolling" or "frozen", see the deck reference; None: rolling
    library             name of the library's material that this one is or starts from, "" if none: what the library knows of the substance
                        besides its constants (spall strength, optical data of windows, Pop plots) is looked up by it
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
    library: str = ""

    def laws(self) -> dict[str, str]:
        """Names of the laws: {family: name}, with the families eos, strength, fracture, burn and unreacted that the material has."""
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
