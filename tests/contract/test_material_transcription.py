"""Slips of transcription in the library, caught by data that were entered from somewhere else."""

import math
import re

import pytest

from hugoniot.materials import counts, library, schema, static_compression
from hugoniot.materials.search import spelling

# Standard atomic weights, CIAAW 2021 (abridged), g/mol.
WEIGHTS = {
    "H": 1.008, "Li": 6.94, "Be": 9.0122, "B": 10.81, "C": 12.011, "N": 14.007, "O": 15.999, "F": 18.998, "Na": 22.990, "Mg": 24.305,
    "Al": 26.982, "Si": 28.085, "P": 30.974, "S": 32.06, "Cl": 35.45, "K": 39.098, "Ca": 40.078, "Sc": 44.956, "Ti": 47.867, "V": 50.942,
    "Cr": 51.996, "Mn": 54.938, "Fe": 55.845, "Co": 58.933, "Ni": 58.693, "Cu": 63.546, "Zn": 65.38, "Ge": 72.630, "Br": 79.904,
    "Rb": 85.468, "Sr": 87.62, "Y": 88.906, "Zr": 91.224, "Nb": 92.906, "Mo": 95.95, "Ru": 101.07, "Rh": 102.91, "Pd": 106.42, "Ag": 107.87,
    "Cd": 112.41, "In": 114.82, "Sn": 118.71, "I": 126.90, "Cs": 132.91, "Ba": 137.33, "Ce": 140.12, "Nd": 144.24, "Hf": 178.49,
    "Ta": 180.95, "W": 183.84, "Re": 186.21, "Os": 190.23, "Ir": 192.22, "Pt": 195.08, "Au": 196.97, "Tl": 204.38, "Pb": 207.2, "Bi": 208.98,
}
# Atomic volumes of the crystals at 0 K, A^3: Lejaeghere, Van Speybroeck, Van Oost and Cottenier, Crit. Rev. Solid State Mater. Sci. 39
# (2014) 1, measured values without zero-point motion. The names are those of the library's rows.
ATOMIC_VOLUMES = {
    "Li": 20.412, "Na": 37.175, "Mg": 22.647, "Al": 16.269, "K": 72.199, "Ca": 42.945, "Ti": 17.497, "V": 13.810, "Cr": 11.822, "Fe": 11.639,
    "Co": 10.956, "Ni": 10.808, "Cu": 11.647, "Zn": 14.859, "Rb": 89.156, "Zr": 23.178, "Nb": 17.973, "Mo": 15.508, "Rh": 13.571,
    "Pd": 14.565, "Ag": 16.850, "Cd": 21.007, "In": 25.703, "Cs": 110.324, "Hf": 22.298, "Ta": 17.933, "W": 15.796, "Re": 14.619, "Ir": 14.064,
    "Pt": 15.022, "Au": 16.822, "Tl": 27.994, "Pb": 29.863, "Bi": 35.126,
}
ELEMENTS = {
    "Li": "lithium", "Na": "sodium", "Mg": "magnesium", "Al": "aluminum", "K": "potassium", "Ca": "calcium", "Ti": "titanium", "V": "vanadium",
    "Cr": "chromium", "Fe": "iron", "Co": "cobalt", "Ni": "nickel", "Cu": "copper", "Zn": "zinc", "Rb": "rubidium", "Zr": "zirconium",
    "Nb": "niobium", "Mo": "molybdenum", "Rh": "rhodium", "Pd": "palladium", "Ag": "silver", "Cd": "cadmium", "In": "indium", "Cs": "cesium",
    "Hf": "hafnium", "Ta": "tantalum", "W": "tungsten", "Re": "rhenium", "Ir": "iridium", "Pt": "platinum", "Au": "gold", "Tl": "thallium",
    "Pb": "lead", "Bi": "bismuth",
}
AVOGADRO = 6.02214076e23


def molar_mass(formula: str) -> float:
    """kg/mol of a formula like NaAlSi3O8."""
    return 1e-3 * sum(WEIGHTS[e] * float(n or 1) for e, n in re.findall(r"([A-Z][a-z]?)([0-9.]*)", formula))


def compression_rows():
    return [r for r in schema.table("compression").values()]


def test_formula_and_molar_mass_agree():
    """A name, a formula and a molar mass entered apart: an element lost or a count misread is a per cent or more."""
    checked = 0
    for row in compression_rows():
        if "-" in row["formula"]:
            continue  # alloys by weight
        assert row["molar_mass"] == pytest.approx(molar_mass(row["formula"]), rel=1.5e-3), (row.id, row.material)
        atoms = sum(float(n or 1) for _, n in re.findall(r"([A-Z][a-z]?)([0-9.]*)", row["formula"]))
        assert row["atoms"] == pytest.approx(atoms), row.id
        checked += 1
    assert checked > 230


def test_densities_of_elements_against_their_lattices():
    """Us-up rows of pure metals: density at most 1 % above the crystal at 0 K and 3.5 % (alkalis 9 %) below."""
    checked = 0
    for row in schema.table("us_up").values():
        symbol = next((s for s, word in ELEMENTS.items() if row.material == s or row.material.lower() == word), None)
        if symbol is None or "rho0" not in row:
            continue
        cold = 1e-3 * WEIGHTS[symbol] / (AVOGADRO * ATOMIC_VOLUMES[symbol] * 1e-30)
        loosest = 0.91 if symbol in ("Li", "Na", "K", "Rb", "Cs") else 0.965  # expansion of the alkalis; hafnium holds zirconium
        assert loosest < row["rho0"] / cold < 1.01, (row.id, row.material, row["rho0"], cold)
        checked += 1
    assert checked >= 60


# row of slow compression -> rows of shock data of the same metal, from other sources
PAIRS = {"M232": "U008 U090 U164", "M233": "U020 U075 U167", "M234": "U007 U058 U144 U194 U202", "M235": "U027 U067 U145 U174 U193",
         "M236": "U003 U108 U197", "M237": "U034 U070 U146", "M238": "U116", "M239": "U022 U089", "M240": "U015 U069", "M241": "U016 U099",
         "M242": "U041 U104", "M243": "U005 U059", "M244": "U071", "M045": "U125 U159", "M176": "U107"}


@pytest.mark.parametrize("identity", PAIRS)
def test_shock_and_slow_compression_agree_at_rest(identity):
    """c0 against sqrt(K/rho0) and s against (K' + 1)/4: two kinds of experiment, two chains of copying.

    The static moduli of the metals are isothermal, 1 to 5 % below the isentropic ones, hence up to 2.5 % in c0; K' of a fit to 100 GPa and
    more is an average, hence the width in s.
    """
    row, law = schema.row(identity), library.entry(identity).material.eos
    for other in PAIRS[identity].split():
        shock = schema.row(other)
        assert row["rho0"] == pytest.approx(shock["rho0"], rel=0.008), other
        assert math.sqrt(law.bulk_modulus / law.rho0) == pytest.approx(shock["c0"], rel=0.06), other
        assert 0.25 * (law.bulk_modulus_slope + 1.0) == pytest.approx(shock["s"], rel=0.21), other


# rows that share their constants although their names differ: the same substance, or a copy that says so
SAME = [{"pumice", "basalt", "Basalt"}, {"nylon", "glass", "lucite"}, {"granite", "andesite", "Granite"}, {"Microcline", "Sanidine"},
        {"Stainless Steel (304)", "Steel (gauge/casing)"}, {"gabbroic anorthosite 1pp melosh89", "anorthosite 1pp"},
        {"gabbroic anorthosite hpp melosh89", "anorthosite hpp"}, {"aluminum", "aluminum melosh89", "Aluminum"},
        {"iron 130pt", "iron melosh89", "Iron"}]


@pytest.mark.parametrize("table, columns", [("us_up", ("rho0", "c0", "s")), ("tillotson", ("bulk_a", "bulk_b", "e0", "a")),
                                            ("jwl", ("a", "b", "r1")), ("compression", ("rho0", "bulk_modulus", "bulk_modulus_slope"))])
def test_no_set_of_constants_stands_under_two_names(table, columns):
    """Constants copied to the wrong line are the commonest slip of a table typed by hand."""
    groups: dict = {}
    for row in schema.table(table).values():
        groups.setdefault(tuple(row.get(c) for c in columns), []).append(row)
    for rows in groups.values():
        names = {library.curated_name(r.material) or spelling(r.material) for r in rows}
        if len(names) > 1:
            assert any({r.material for r in rows} <= same for same in SAME), [(r.id, r.material) for r in rows]


def test_thermal_identities_of_a_static_row():
    """K_S/K_T = c_p/c_v = 1 + alpha Gamma T0, and Debye's function against its limits and a table of Debye's own (x = 1: 0.9517)."""
    assert static_compression.debye(1.0) == pytest.approx(0.95173, rel=1e-4)
    assert static_compression.debye(0.0) == 1.0
    assert static_compression.debye(30.0) == pytest.approx(0.8 * math.pi**4 / 30.0**3, rel=1e-3)
    for row in compression_rows():
        law = library.entry(row.id).material.eos
        if "expansivity" in row:
            ratio = 1.0 + row["expansivity"] * law.gamma0 * static_compression.REST
            assert law.bulk_modulus / row["bulk_modulus"] == pytest.approx(ratio, rel=1e-9), row.id
            assert row["heat_capacity"] / law.specific_heat == pytest.approx(ratio, rel=1e-9), row.id


def test_counts_by_kind_and_source():
    kinds = counts.by_kind()
    assert sum(k["curated"] for k in kinds.values()) == len(library.index())
    total = sum(k["curated"] + k["rows_only"] for k in kinds.values())
    assert total == len(list(library.listings())) >= 420
    assert sum(counts.by_source().values()) == sum(1 for _ in schema.all_rows())
    for k in kinds.values():
        assert k["rows_only"] == k["shock"] + k["compression"]


def test_windows_of_a_gauge():
    """Indices at rest against the values optics tables print; the recalled relation carries its mark."""
    found = {(r.material, round(r["wavelength"] * 1e9)): r["index"] for r in schema.table("windows").values() if "index" in r}
    for key, index in {("Lithium fluoride", 532): 1.393, ("Fused silica", 532): 1.461, ("Quartz", 532): 1.547, ("Sapphire", 532): 1.772,
                       ("PMMA", 532): 1.494, ("Fused silica", 1550): 1.444}.items():
        assert found[key] == pytest.approx(index, abs=1.2e-3)
    lif = library.windows("LiF")
    assert {r.status for r in lif} == {"derived", "recalled"} and any(r.marks for r in lif)
    assert library.windows("copper") == ()
