"""The response of a material in a step, in order, written into a list of passes.

A solver provides its rows under the names used here. The passes that a material needs are chosen here, once, from its laws. Nothing here
depends on the dimension: strains, the elastic trial and the return to the yield surface belong to the solver.
"""

from typing import Any

import numpy as np

from hugoniot.core.pass_lists import Operation, Place
from hugoniot.core.passes import numbers_of
from hugoniot.zones import burn, closure, fracture, mixture, rows, soundness, strength, viscosity
from hugoniot.zones.laws import Laws

NOTHING = np.zeros(1)


class MaterialSteps:
    """Writes the passes of one material into the list `operations`.

    at        the solver's rows, each a `Place`: z fields of zones, b further ones of burning zones, w scratch, found what passes find
              (`soundness`), whole and half the time step and half of it, and its own
    explicit  whether stresses in the middle of a step are found from the energy there
    intact    for zones in which no voids stand as the passes begin
    """

    def __init__(self, laws: Laws, at, explicit: bool, intact: bool = False):
        self.laws, self.at, self.intact = laws, at, intact
        self.operations: list[Operation] = []
        self.constants = np.array(laws.constants, dtype=float)
        self._numbers: dict[int, tuple[Any, np.ndarray]] = {}
        # c^2 is asked for before the state is known
        self.bulk_first = laws.needs_bulk_modulus or (explicit and laws.grows_voids)
        # of burning material: rho_r, e_r, rho_p, e_p at the start of the step, and those found in it
        self.phases, self.new_phases = ((rows.rho_r, rows.e_r, rows.rho_p, rows.e_p) for rows in (at.b, at.w))
        # density and pressure in the middle of a step: burning zones are asked for them at its end
        self.rho_half, self.p_half = (at.b.rho_half, at.b.p_half) if laws.burns else (at.w.rho, at.w.p)
        # deviator along the tension, and modulus: nobody writes those of a fluid
        self.t1, self.shear = (at.w.t1, at.w.shear) if laws.is_strong else (at.w.zero, at.w.zero)

    def do(self, of, given, step: Place | None = None, law=None, kind=None, numbers=None) -> None:
        """Add a pass over the rows `given`, in the order in which it names them.

        step      the time step it takes; the whole one if not given
        law       the law it is compiled for, and whose numbers it takes
        kind      what it is compiled for (a geometry) where it takes the numbers of the material
        numbers   other numbers than the material's constants
        """
        if law is not None:
            numbers = self._numbers.setdefault(id(law), (law, numbers_of(law)))[1]     # the law kept, so that its id stays its own
        self.operations.append(Operation(of, kind if law is None else law, given, self.constants if numbers is None else numbers,
                                         step or self.at.whole))

    # -- everywhere ----------------------------------------------------------------------------------------------------------
    def clear(self, *which: Place) -> None:
        """Zeros in rows."""
        for row in which:
            self.do(rows.fill_pass, (row,), numbers=NOTHING)

    def copy(self, row: Place, to: Place) -> None:
        """A row into another."""
        self.do(rows.copy_pass, (row, to))

    def add(self, more: Place, to: Place) -> None:
        """A row added to another."""
        self.do(rows.add_pass, (more, to))

    @property
    def seen(self) -> soundness.PeakRows:
        """Rows of what is looked over at the end of a step: peaks, and whether zones are sound."""
        z = self.at.z
        return soundness.PeakRows(z.rho, z.c, z.sigma, z.p, z.peak_stress, z.peak_tension, z.peak_pressure, z.peak_density, self.at.found)

    def look_over(self) -> None:
        """Peaks, and how many zones are not sound."""
        self.do(soundness.look_over, self.seen)

    def resisting(self, geometry) -> viscosity.Resisting:
        """What a pass of artificial viscosity is compiled for, in the geometry of the solver."""
        return viscosity.Resisting(self.laws.viscosity, geometry)

    def add_some(self, more: Place, to: Place) -> None:
        """A row that is mostly zero added to another."""
        self.do(rows.add_some_pass, (more, to))

    # -- closure -------------------------------------------------------------------------------------------------------------
    def pressure(self, solid, solid_v, e, p) -> None:
        """Pressure of inert material at a given energy in the middle of a step, and c^2 where it is needed."""
        if self.bulk_first and not self.laws.remembers:
            self.state(solid_v, e, p)
            return
        self.do(closure.pressure_pass, (solid_v, e, self.at.z.compaction, p), law=self.laws.eos)
        self.stiffness(solid, solid_v, e, p)

    def state(self, solid_v, e, p) -> None:
        """Pressure and c^2 of inert material at a given energy; the history is advanced."""
        self.do(closure.state_pass, (solid_v, e, self.at.z.compaction, p, self.at.w.c2), law=self.laws.eos)

    def settle(self, solid_v) -> None:
        """Pressure, energy and c^2 of inert material together, w.given the energy that others than the pressure gave."""
        z, w = self.at.z, self.at.w
        self.do(closure.settle_pass, (solid_v, w.dv, w.given, z.e, z.p, z.compaction, w.c2), law=self.laws.eos)

    def stiffness(self, solid, solid_v, e, p) -> None:
        """c^2 before the state is known, where it is needed: of inert material, or of the phases of the previous step."""
        b, w = self.at.b, self.at.w
        if self.bulk_first and not self.laws.burns:
            self.do(closure.stiffness_pass, (solid_v, e, p, self.at.z.compaction, w.c2), law=self.laws.eos)
        elif self.bulk_first:
            self.do(mixture.slopes_pass, (solid, e, b.lam, p, *self.phases, w.c2, w.p_e), law=self.laws.eos.mixture)

    # -- strength ------------------------------------------------------------------------------------------------------------
    def _temperature(self, solid, e) -> Place:
        """The row of temperatures, for laws that need one."""
        z, w = self.at.z, self.at.w
        if not self.laws.needs_temperature:
            return w.zero
        if self.laws.burns:
            self.do(mixture.mixture_temperature_pass, (self.at.b.lam, z.p, *self.phases, w.temperature), law=self.laws.eos.mixture)
        else:
            self.do(closure.temperature_pass, (solid, e, z.compaction, w.temperature), law=self.laws.eos)
        return w.temperature

    def asked(self, solid, e, p, lam) -> strength.Solid:
        """Rows of the state whose shear modulus and yield count; lam: of burning material only."""
        z, w = self.at.z, self.at.w
        return strength.Solid(solid, p, self._temperature(solid, e), w.c2, lam if self.laws.burns else w.zero, z.plastic_strain)

    def strong(self, geometry) -> strength.Strong:
        """What a pass of strength is compiled for, in the geometry of the solver's tensor."""
        return strength.Strong(self.laws.strength, strength.Burning() if self.laws.burns else strength.Inert(), geometry)

    def harden(self, v) -> None:
        """Plastic strain and work of the step, of volume v per mass."""
        z, w = self.at.z, self.at.w
        if self.laws.is_strong:
            self.do(strength.harden_pass, (w.limit, w.flow, v, z.plastic_work, z.plastic_strain))

    def add_plastic_heat(self, v, heat) -> None:
        """Plastic work of a strain, J/kg, added to a row."""
        w = self.at.w
        if self.laws.is_strong:
            self.do(strength.plastic_heat_pass, (w.limit, w.flow, v, heat))

    # -- fracture ------------------------------------------------------------------------------------------------------------
    def solid(self, rho) -> tuple[Place, Place]:
        """Rows of density and specific volume of the solid, of volume w.v and density `rho` with its voids."""
        w = self.at.w
        if self.intact or not self.laws.grows_voids:
            return rho, w.v
        self.do(fracture.solid_pass, (w.v, rho, self.at.z.voids, w.solid, w.solid_v))
        return w.solid, w.solid_v

    def relieve(self, solid) -> None:
        """Take off the pressure in the middle of a step what voids would take off now."""
        if self.laws.grows_voids:
            self.do(fracture.relief_pass, (self.t1, self.p_half, self.at.w.c2, solid, self.at.z.voids), law=self.laws.fracture)

    def tear(self, solid) -> None:
        """Damage, failure and voids at the end of a step, the pressure relieved."""
        z, w, laws = self.at.z, self.at.w, self.laws
        if not laws.breaks:
            return
        if laws.remembers:
            self.do(closure.rest_pass, (z.compaction, w.rest), law=laws.eos)
        else:
            self.do(rows.fill_pass, (w.rest,))     # the first of the material's constants
        self.do(fracture.fracture_pass, (self.t1, z.p, w.c2, solid, w.v, w.rest, w.flow, z.damage, z.voids, z.failure, w.relief, w.grown,
                                         self.at.found), law=laws.fracture)

    # -- burning -------------------------------------------------------------------------------------------------------------
    def burn(self, step, rho, end_rho, drive, q, new) -> None:
        """Burn fractions after a time step into the row `new`."""
        z, b = self.at.z, self.at.b
        self.do(burn.burn_pass, (b.lam, b.since, b.size, rho, end_rho, drive, q, z.p, *self.phases, new), step, law=self.laws.eos)

    def mix(self, solid, e, lam, heat, p, status) -> None:
        """Pressure into the row p and phases into the scratch rows, from those of the previous step after `heat`; slopes of the pure."""
        w = self.at.w
        self.do(mixture.solve_pass, (solid, e, lam, heat, self.at.z.p, *self.phases, p, *self.new_phases, status, w.c2, w.p_e),
                law=self.laws.eos.mixture)

    def slopes(self, solid, e, lam, p, by=mixture.mixed_slopes_pass) -> None:
        """c^2 and dp/de of the phases in the scratch rows: what `mix` has left, or by `mixture.slopes_pass` all of them."""
        self.do(by, (solid, e, lam, p, *self.new_phases, self.at.w.c2, self.at.w.p_e), law=self.laws.eos.mixture)

    def keep_phases(self) -> None:
        """The phases in the scratch rows become those of the step."""
        self.do(burn.keep_phases_pass, (*self.new_phases, self.at.w.status, *self.phases, self.at.b.status))

    def share_old_heat(self, heat) -> None:
        """What phases take of `heat`, as far as a shock was passing at the end of the previous step, into b.heat."""
        b, w = self.at.b, self.at.w
        self.do(burn.was_passing_pass, (b.reference, w.shocked))
        self.do(burn.share_heat_pass, (w.shocked, heat, b.heat))

    def share_heat(self, q, p, rho, heat) -> None:
        """The same, as far as a shock of viscous pressure q is passing now."""
        b, w = self.at.b, self.at.w
        self.do(burn.is_passing_pass, (q, p, rho, self.at.z.c, w.shocked))
        self.do(burn.share_heat_pass, (w.shocked, heat, b.heat))

    def lead_on(self, lam) -> None:
        """Burn fractions, clock and code of the reference state at the end of the step; w.shocked says where a shock is passing."""
        b = self.at.b
        self.do(burn.lead_on_pass, (lam, self.at.w.shocked, b.lam, b.since, b.reference))

    def pace(self, inverse_width) -> None:
        """What burning requires of the time step, at the end of a step."""
        z, b, w = self.at.z, self.at.b, self.at.w
        if self.laws.burns:
            self.do(burn.rates_pass, (b.lam, z.rho, z.p, z.q, *self.phases, w.pace), law=self.laws.eos)
            self.do(burn.pace_pass, (b.lam, z.rho, w.pace, inverse_width, b.status, b.resolution, z.c, self.at.found))

    # -- closures of burning material in the middle and at the end of a step ---------------------------------------------------------
    def close_half(self, solid) -> None:
        """Burn fraction and mixture in the middle of the step, by the pressure at its start; w.heat is the viscous heat so far."""
        b, w = self.at.b, self.at.w
        self.share_old_heat(w.heat)
        self.mix(solid, w.e, b.lam_half, b.heat, self.p_half, b.status)
        if self.bulk_first:
            self.slopes(solid, w.e, b.lam_half, self.p_half)

    def keep_half(self) -> None:
        """Keep twice the plastic heat of the first half of the step: that of the whole."""
        if self.laws.is_strong:
            heat = self.at.b.heat
            self.clear(heat)
            self.add_plastic_heat(self.at.w.v, heat)
            self.add_plastic_heat(self.at.w.v, heat)

    def close_end(self, solid) -> None:
        """Burn fraction and mixture at the end of the step, by the pressure in its middle; what burns at once, by that at its start."""
        z, b, w = self.at.z, self.at.b, self.at.w
        self.burn(self.at.whole, b.rho_half, b.rho_half, z.p if self.laws.burns_at_once else b.p_half, z.q, w.lam)
        if self.laws.is_strong:
            self.add(b.heat, w.heat)
        self.share_heat(z.q, b.p_half, b.rho_half, w.heat)
        self.lead_on(w.lam)
        self.mix(solid, z.e, b.lam, b.heat, w.p, w.status)
        self.keep_phases()
        self.copy(w.p, z.p)
        self.slopes(solid, z.e, b.lam, z.p)

