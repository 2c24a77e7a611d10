#!/usr/bin/env python3
"""Speed of the equation-of-state bench, printed beside what was asked of it.

    python benchmarks/eos_speed.py            # all figures, about a minute
    python benchmarks/eos_speed.py --states 1000000

Every figure is the best of several repeats on one core, warm: the compilation stands before the clock. The clock is the processor time of
the thread, so that a busy machine spoils little; the command line's answer is wall time, process start included. Rates over arrays are
those of the public functions of `laws.arrays` (checks and the array of results included); Hugoniot curves are those of
`theory.hugoniot.curve`.
"""

import argparse
import functools
import pathlib
import subprocess
import sys
import time

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.laws import arrays
from hugoniot.laws.eos import table
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.theory.hugoniot import curve

REPEATS = 15
COPPER = MieGruneisen(8930.0, 3940.0, 1.489, 1.99, 390.0)
PRODUCTS = JWL(1.36177e12, 7.199e10, 6.2, 2.2, 0.5, 1895.0, 6.9e9, 1.0e6 / 1895.0)
UNREACTED = JWL(7.781e13, -5.031e9, 11.3, 1.13, 0.8938, 1895.0, 0.0, 2.487e6 / 1895.0)
SOLID = MieGruneisen(1895.0, 2900.0, 1.68, 1.1, 1100.0)


def best(call, repeats=REPEATS, clock=time.thread_time):
    """Shortest time of a call that was made once before, s."""
    call()
    walls = []
    for _ in range(repeats):
        begun = clock()
        call()
        walls.append(clock() - begun)
    return min(walls)


def say(what, found, unit, asked=None):
    """One line: what, the figure, what was asked."""
    sys.stdout.write(f"{what:64s} {found:12.4g} {unit:10s}" + (f" asked {asked:.3g}" if asked else "") + "\n")


def laws_over_arrays(count):
    """States per second of single laws."""
    rng = np.random.default_rng(1)
    rho, e = rng.uniform(8950.0, 12000.0, count), rng.uniform(0.0, 2e6, count)
    say(f"mie_gruneisen, pressure of {count} states", count / best(lambda: arrays.pressure_array(rho, e, COPPER)), "/s", 2e8)
    say("mie_gruneisen, both slopes", count / best(lambda: arrays.derivatives_array(rho, e, COPPER)), "/s")
    say("mie_gruneisen, temperature", count / best(lambda: arrays.temperature_array(rho, e, COPPER)), "/s")
    rho = rng.uniform(500.0, 2600.0, count)
    e = rng.uniform(1e6, 8e6, count)
    say(f"jwl, pressure of {count} states", count / best(lambda: arrays.pressure_array(rho, e, PRODUCTS)), "/s", 5e7)


def tables(count):
    """States per second of the inverse interpolation T(rho, e) in a table of 200 x 200, at random states."""
    made = table.from_law(COPPER, np.linspace(8500.0, 13000.0, 200), np.linspace(200.0, 6000.0, 200), rho0=8930.0)
    rng = np.random.default_rng(2)
    rho = rng.uniform(8930.0, 12500.0, count)
    share, row = rng.uniform(0.05, 0.95, count), np.searchsorted(made.density, rho) - 1
    low, high = np.maximum(made.energy_table[row, 0], made.energy_table[row + 1, 0]), made.energy_table[row, -1]
    e = low + share * (high - low)
    say("table 200 x 200, T(rho, e)", count / best(lambda: arrays.temperature_array(rho, e, made)), "/s", 1e7)
    say("table 200 x 200, pressure", count / best(lambda: arrays.pressure_array(rho, e, made)), "/s")


def mixtures(count):
    """Every closure over three pairs of laws: isentropes in closed form, isentropes that are integrals, laws of logarithms and powers."""
    for reactants, products, energy in ((UNREACTED, PRODUCTS, None), (SOLID, PRODUCTS, 4.0e6),
                                        (EOS.get("davis_reactants").example, EOS.get("davis_products").example, None)):
        for kind in ("thermal_isolation", "thermal_equilibrium", "weighted_pressures"):
            mixture_rates(count, kind, reactants, products, energy)


def mixture_rates(count, kind, reactants, products, energy):
    """Mixture states per second: from one reference state, and in steps of a run, each from the phases of the step before."""
    from hugoniot.laws import mixture_kernels
    from hugoniot.theory.hugoniot import shock
    from hugoniot.theory.mixture import mixture, solve

    par = mixture(kind, reactants, products, energy)
    ahead = shock(reactants, pressure=30e9)
    rho_k, e_k, q = ahead.density, ahead.specific_internal_energy, par.detonation_energy
    rng = np.random.default_rng(3)
    lam, rho = rng.uniform(0.05, 0.95, count), rho_k * rng.uniform(0.9, 1.0, count)
    e = e_k + q + rng.uniform(-0.05, 0.05, count) * q
    name = f"{kind}, {EOS.of(reactants).name}"
    say(f"{name}, cold, states and slopes", count / best(lambda: solve(rho, e, lam, par, (rho_k, e_k + q))), "/s", 2e6)
    phases = np.zeros((6, count))
    phases[1], phases[2] = rho_k, e_k + q
    mixture_kernels.solve_rows(rho, e, lam, phases, par)

    def step():
        mixture_kernels.solve_rows(rho * 0.9995, e, np.minimum(lam + 1e-3, 1.0), phases.copy(), par)

    say(f"{name}, step of a run", count / best(step), "/s", 2e6)


def curves():
    """Milliseconds of a Hugoniot of 1000 points to 2 km/s or 90 % of the law's end, for every inert law of the registry."""
    slow = []
    for law in EOS:
        if "reacted" in law.flags:
            continue
        try:
            wall = best(functools.partial(curve, law.example, points=1000), 5)
        except HugoniotError as error:  # named, not hidden
            sys.stdout.write(f"hugoniot curve of {law.name}: {type(error).__name__}: {error}\n")
            continue
        slow.append((wall, law.name))
    for wall, name in sorted(slow, reverse=True):
        say(f"hugoniot of 1000 points, {name}", 1e3 * wall, "ms", 10.0)


def match():
    """Seconds of the command line's impedance match, process start included."""
    command = [str(pathlib.Path(sys.executable).with_name("hugoniot")), "eos", "match", "copper", "aluminum", "--velocity", "1 km/s"]
    wall = best(lambda: subprocess.run(command, check=True, capture_output=True), 5, time.perf_counter)
    say("hugoniot eos match copper aluminum, whole process", wall, "s", 1.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--states", type=int, default=20_000, help="states per array (in cache by default)")
    given = parser.parse_args()
    laws_over_arrays(given.states)
    tables(given.states)
    mixtures(given.states)
    curves()
    match()


if __name__ == "__main__":
    main()
