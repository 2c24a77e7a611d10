"""Burning of a zone: the growth of its burn fraction in a step, and the rate, which limits the time step.

    burn     burn fractions at the end of a step, by schedule and by rate
    rates    rates of burning

Source: Starkenberg ARL-TR-2161 sections 3 to 5; Herrmann WL-TR-64-107 A.27 to A.30.
"""

from hugoniot.core.binder import only_if
from hugoniot.core.ops import fmax, fmin
from hugoniot.core.passes import flag_of, law_of, named, rows_apart, zone_pass
from hugoniot.laws.burn.contract import BURN, advance, rate, scheduled, short_advance
from hugoniot.laws.mixture.contract import mixture_temperature
from hugoniot.laws.mixture.reference_state import PASSING, found_state, is_passing, reactants_share
from hugoniot.zones.constants import Constants
from hugoniot.zones.mixture import BURNED, PARTLY, end_of_stretch, phases, whole
from hugoniot.zones.soundness import FOUND_RATE, FOUND_UNSOUND

STEP_SHARE = 0.1     # of the shortest burning time a step may be
NEARLY = 0.99        # burn fraction up to which the time step follows the rate
IGNITED = 0.05       # burn fraction from which the resolution of the rate is watched
SUBCYCLED = -1.0     # in place of a burn fraction that takes sub-steps
counts_viscosity = flag_of(BURN, "includes_viscosity")     # whether the pressure a burn law is meant to see is that with the viscosity
subcycles = flag_of(BURN, "subcycled")                     # whether its `advance` is a loop, which no packed loop over zones can hold


@only_if(lambda rate: "temperature_driven" in BURN.of_class(rate).flags, otherwise=0.0)
def burn_temperature(lam, mixed, mixture, rate):
    """Temperature for a burn law that needs one; 0 for the others, at no cost."""
    return mixture_temperature(lam, mixed, mixture)


def driving_pressure(z, j, rate):
    """The pressure a burn law is meant to see."""
    return z.drive[j] + z.q[j] if counts_viscosity(rate) else z.drive[j]


def fraction(z, j, dt, par):
    """Burn fraction after a step of dt."""
    lam = scheduled(z.lam[j], z.since[j] + dt, 0.0, z.width[j], z.end_rho[j], par.rate)
    heat = burn_temperature(z.lam[j], phases(z, j), par.mixture, par.rate)
    return advance(lam, dt, z.rho[j], driving_pressure(z, j, par.rate), heat, par.rate) if lam < 1.0 else lam


def short_fraction(z, j, dt, par):
    """The same of a zone that burns by a rate, where `short_advance` does; else SUBCYCLED."""
    heat = burn_temperature(z.lam[j], phases(z, j), par.mixture, par.rate)
    end, done = short_advance(z.lam[j], dt, z.rho[j], driving_pressure(z, j, par.rate), heat, par.rate)
    return end if done else SUBCYCLED


def pace(z, j, par):
    """Rate of a zone that burns, 1/s; 0 of one that has nearly ended."""
    lam, drive = z.lam[j], z.p[j] + z.q[j] if counts_viscosity(par.rate) else z.p[j]
    # a term that ends at a small burn fraction (ignition) is looked past: it cannot burn more than the share of a step
    found = rate(fmax(lam, STEP_SHARE), z.rho[j], drive, burn_temperature(lam, phases(z, j), par.mixture, par.rate), par.rate)
    return found if lam < NEARLY else 0.0


@zone_pass("lam since width rho end_rho drive q p rho_r e_r rho_p e_p new")
def burn_pass(count, z, dt, numbers, law):
    """lam, since (time from lighting to the start, s), width (m), rho, end_rho (what a schedule sees), drive (Pa), q, phases -> new."""
    rows_apart()
    par = law_of(law, numbers)
    if subcycles(par.rate):      # tried for many zones at a time; those that are still whole are mostly answered at once
        start = 0
        while start < count:
            known, stop = whole(z.lam[start]), end_of_stretch(z.lam, start, count)
            for j in range(start, stop):
                z.new[j] = BURNED if known == BURNED else SUBCYCLED
            if known == PARTLY:
                for j in range(start, stop):
                    z.new[j] = short_fraction(z, j, dt, par)
            if known != BURNED:
                for j in range(start, stop):
                    if z.new[j] < 0.0:
                        z.new[j] = fraction(z, j, dt, par)
            start = stop
    else:
        for j in range(count):
            z.new[j] = fraction(z, j, dt, par)


@zone_pass("lam rho p q rho_r e_r rho_p e_p pace")
def rates_pass(count, z, dt, numbers, law):
    """lam, rho, p, q, phases -> pace (1/s); 0 for what has not begun, has nearly ended, or burns by schedule."""
    rows_apart()
    par, start = law_of(law, numbers), 0
    while start < count:
        known, stop = whole(z.lam[start]), end_of_stretch(z.lam, start, count)
        for j in range(start, stop):
            z.pace[j] = 0.0
        if known == PARTLY:
            for j in range(start, stop):
                z.pace[j] = pace(z, j, par)
        start = stop


@zone_pass("lam rho pace inverse_width status resolution c found")
def pace_pass(count, z, dt, numbers, law):
    """Largest signal rate of burning; notes how well burning is resolved, and marks zones whose mixture was not found, or that were
    crushed before they burned: without a pressure until then, they would be pressed to nothing in ever shorter steps."""
    rows_apart()
    constants, quickest, bad = named(Constants, numbers), z.found[FOUND_RATE], 0
    for j in range(count):
        quickest = fmax(quickest, constants.per_rate * z.pace[j])
        if z.lam[j] > IGNITED and z.pace[j] > 0.0:
            z.resolution[j] = fmin(z.resolution[j], z.c[j] * z.inverse_width[j] / z.pace[j])
        sound = (z.status[j] == 0.0) & ((z.rho[j] < constants.crushed) | (z.lam[j] >= 1.0))
        z.c[j] = z.c[j] if sound else -1.0
        bad += 0 if sound else 1
    z.found[FOUND_RATE] = quickest
    z.found[FOUND_UNSOUND] += bad


@zone_pass("reference shocked")
def was_passing_pass(count, z, dt, numbers, law):
    """1 where a shock was passing at the end of the previous step."""
    rows_apart()
    for j in range(count):
        z.shocked[j] = 1.0 if z.reference[j] == PASSING else 0.0


@zone_pass("q p rho c shocked")
def is_passing_pass(count, z, dt, numbers, law):
    """1 where a shock is passing in this step."""
    rows_apart()
    for j in range(count):
        z.shocked[j] = 1.0 if is_passing(z.q[j], z.p[j], z.rho[j] * z.c[j] * z.c[j]) else 0.0


@zone_pass("shocked heat taken")
def share_heat_pass(count, z, dt, numbers, law):
    """What phases take of a step's dissipated heat: reactants of a frozen reference state only while a shock is passing."""
    rows_apart()
    constants = named(Constants, numbers)
    for j in range(count):
        z.taken[j] = reactants_share(z.heat[j], z.shocked[j] > 0.0, constants.freezes) if constants.isolates > 0.0 else z.heat[j]


@zone_pass("new shocked lam since reference")
def lead_on_pass(count, z, dt, numbers, law):
    """Burn fractions, the clock of lighting and the code of the reactants' reference state at the end of the step."""
    rows_apart()
    constants = named(Constants, numbers)
    for j in range(count):
        z.lam[j] = z.new[j]
        z.since[j] += dt
        if constants.isolates > 0.0:
            z.reference[j] = found_state(z.reference[j], z.shocked[j] > 0.0, z.new[j])


@zone_pass("new_rho_r new_e_r new_rho_p new_e_p new_status rho_r e_r rho_p e_p status")
def keep_phases_pass(count, z, dt, numbers, law):
    """The phases just found become those of the step; a fault of either search counts."""
    rows_apart()
    for j in range(count):
        z.rho_r[j] = z.new_rho_r[j]
        z.e_r[j] = z.new_e_r[j]
        z.rho_p[j] = z.new_rho_p[j]
        z.e_p[j] = z.new_e_p[j]
        z.status[j] += z.new_status[j]
