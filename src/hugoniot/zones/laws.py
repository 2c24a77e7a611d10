"""The laws of the zones of a material and what they need from a solver, determined once per material, not in every zone."""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind_family, bind_module
from hugoniot.errors import OutOfRange
from hugoniot.laws.arrays import float_parameters
from hugoniot.laws.burn import contract as burn_contract
from hugoniot.laws.burn import depletion
from hugoniot.laws.burn.contract import BURN, Reactive
from hugoniot.laws.eos import contract as eos_contract
from hugoniot.laws.eos.contract import reference_state
from hugoniot.laws.fracture import contract as fracture_contract
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.mixture import contract as mixture_contract
from hugoniot.laws.mixture.binding import bind_mixtures
from hugoniot.laws.strength import contract as strength_contract
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.laws.viscosity import contract as viscosity_contract
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.zones import closure, mixture
from hugoniot.zones.constants import Constants
from hugoniot.zones.fracture import grows_voids


def keeps_time(eos) -> bool:
    """Whether a `Reactive` pair burns by a schedule alone, with nothing before it burns; False for an equation of state."""
    return isinstance(eos, Reactive) and burn_contract.keeps_time(eos.rate, not mixture.bare(eos.mixture))


class Laws(NamedTuple):
    """Parameter tuples of a material's laws, and its constants; `eos` may be a `Reactive` pair of rate and mixture."""

    eos: Any
    strength: Any
    fracture: Any
    viscosity: Any
    constants: Constants

    @property
    def burns(self) -> bool:
        """Whether a mixture stands where inert material has an equation of state."""
        return isinstance(self.eos, Reactive)

    @property
    def burns_at_once(self) -> bool:
        """Whether it burns whole in the step in which it is lit."""
        return self.burns and "instantaneous" in BURN.of(self.eos.rate).flags

    @property
    def is_bare(self) -> bool:
        """Whether the explosive has no law before it burns."""
        return self.burns and mixture.bare(self.eos.mixture)

    @property
    def keeps_time(self) -> bool:
        """Whether it burns by a schedule alone, with nothing before it burns: viscosity may not push such a front."""
        return keeps_time(self.eos)

    @property
    def remembers(self) -> bool:
        """Whether its equation of state has a history variable."""
        return not self.burns and closure.remembers(self.eos)

    @property
    def is_strong(self) -> bool:
        """Whether it has stress deviators."""
        return "fluid" not in STRENGTH.of(self.strength).flags

    @property
    def needs_temperature(self) -> bool:
        """Whether its strength needs a temperature."""
        return "needs_temperature" in STRENGTH.of(self.strength).flags

    @property
    def needs_bulk_modulus(self) -> bool:
        """Whether its strength needs the bulk modulus."""
        return "needs_bulk_modulus" in STRENGTH.of(self.strength).flags

    @property
    def breaks(self) -> bool:
        """Whether it has a fracture law."""
        return "never" not in FRACTURE.of(self.fracture).flags

    @property
    def grows_voids(self) -> bool:
        """Whether voids grow in it at the tension its fracture law caps."""
        return grows_voids(self.fracture)


def laws_of(eos, strength, fracture, viscosity, **known: float) -> Laws:
    """The laws of a material, `eos` a parameter tuple or a `Reactive` pair; the numbers are fields of `Constants`."""
    burns = isinstance(eos, Reactive)
    if burns and fracture_contract.asked_at_nodes(fracture):
        raise OutOfRange(f'fracture law "{FRACTURE.of(fracture).name}" is evaluated at nodes, where the burn fraction of a zone is not '
                         'available; use "pressure_volume" or "spall_stress" for an explosive')
    if burns:
        bind_burning()
    rest = float(reference_state(eos.mixture.products if burns else eos)[0])
    constants = Constants(rest, isolates=float(burns and mixture.isolates(eos.mixture)), **known)
    return Laws(*map(float_parameters, (eos, strength, fracture, viscosity)), constants)


# -- laws in kernels ---------------------------------------------------------------------------------------------------
for _family, _contract in ((eos_contract.EOS, eos_contract), (STRENGTH, strength_contract), (FRACTURE, fracture_contract),
                           (VISCOSITY, viscosity_contract)):
    bind_family(_family, _contract.GENERICS)


def bind_burning() -> None:
    """Make burn laws and mixtures callable from passes, as the others are."""
    bind_mixtures()
    bind_family(BURN, burn_contract.GENERICS)
    for module in (depletion, burn_contract, mixture_contract):
        bind_module(module)
