"""What a reader is told of how far the data behind a material reach."""

import json

import pytest

from hugoniot.cli import main as front
from hugoniot.materials import library, marks, schema
from hugoniot.materials.reach import far_begin, range_of, reach
from hugoniot.materials.search import substance

DECK = """geometry = "planar"
stop_time = "1 us"
[[region]]
name = "a"
material = "nickel"
from = "0 mm"
to = "1 mm"
zones = 10
[[region]]
name = "b"
material = "molybdenum"
from = "1 mm"
to = "2 mm"
zones = 10
"""


def test_a_range_names_what_stands_behind_it():
    assert reach(library.find("nickel")).startswith("particle velocity up to 2145 m/s (range of the 18 measured states with which the library compares row U016: particle velocities from 470 m/s to 2145 m/s;")
    assert "stated by the source of row U244" in reach(library.find("U244")) and "14 m/s" in reach(library.find("U244"))
    assert "standard in Marsh's impedance-matching experiments" in reach(library.find("aluminum_2024"))
    assert range_of(schema.row("U247")).startswith("2200 m/s to 4700 m/s")


def test_a_range_that_nobody_states_is_told_as_unknown():
    for name in ("gold", "molybdenum", "M001"):
        assert library.find(name).valid_up_to is None and reach(library.find(name)).startswith("not stated; a run warns only above a particle velocity of 15000 m/s, an estimate for all materials: above roughly this velocity atoms are ionised")
    assert range_of(schema.row("U008")) == "not known"
    assert "does not apply" in reach(library.find("air")) and "does not apply" in reach(library.find("tnt"))


def test_the_source_of_a_range_is_the_states_not_the_line():
    """Schwer drew the line 1484 + 1.979 up of water; its range is that of Marsh's states, which it misses."""
    water = library.find("U178")
    source = next(s for s in water.sources if s.quantity == "valid_up_to")
    assert source.status == "derived" and "measured states" in source.source and "Schwer" not in source.source
    assert any("misses the measured states" in w for w in water.warnings)
    assert not any("misses" in m for i in ("U016", "U031", "U205") for m in marks.marks(schema.row(i)))


def test_a_material_is_not_blamed_for_a_fit_that_it_does_not_use():
    """Iron takes only the Grüneisen parameter of U165 and the heat capacity of U094, water only a heat capacity from U110."""
    for name, fit in (("iron", "U094"), ("water", "U110")):
        assert any("misses" in w for w in library.find(fit).warnings) and not any("misses" in w for w in library.find(name).warnings)


def test_a_curated_material_has_the_range_of_its_row():
    for name in library.names():
        entry = library.entry(name)
        row = schema.row(entry.rows[0]) if entry.rows and entry.rows[0].startswith("U") else None
        another = "porous" in name or entry.reasons["eos"].startswith("No Hugoniot of")    # the row is of another material
        if row is not None and "up_max" in row and entry.reasons["eos"] and not another:
            assert entry.material.valid_up_to is not None, name


def test_rows_of_the_far_side_of_a_transition_say_where_they_begin():
    assert any("begin at a particle velocity of 2200 m/s" in w for w in library.find("U247").warnings)


def test_check_tells_both(tmp_path, capsys):
    (tmp_path / "deck.toml").write_text(DECK)

    def told(*options):
        with pytest.raises(SystemExit) as ended:
            front.main(["check", str(tmp_path / "deck.toml"), *options])
        assert not ended.value.code
        return capsys.readouterr().out

    out = told()
    assert "range of the data of nickel: particle velocity up to 2145 m/s" in out
    assert "range of the data of molybdenum: not stated" in out
    ranges = json.loads(told("--json"))["ranges"]
    assert ranges["nickel"]["up_to"] == 2145.0 and ranges["molybdenum"]["up_to"] is None


def test_data_that_begin_with_a_shock_slower_than_sound_lie_beyond_a_transition():
    """Bismuth: 1113 + 2.14 * 300 = 1755 m/s, below its bulk sound speed of about 1790 m/s (31 GPa, 9.8 g/cm3): a first wave runs ahead.

    No other row that begins below 1 km/s has such data.
    """
    rows = [row for row in schema.table("us_up").values() if 0.0 < row.get("up_min", 0.0) < 1000.0]
    assert [row.id for row in rows if far_begin(row)] == ["U242"] and len(rows) > 40
    assert any("begin at a particle velocity of 300 m/s; weaker shocks" in w for w in library.find("U242").warnings)
    assert {substance(name) for name in ("Bi", "Bismuth, compressed", "bismuth (cast)")} == {"bismuth"}


def test_a_doubt_of_single_constants_marks_these_alone():
    """Of uranium with 0.75 % titanium two of Steinberg's constants are in doubt, not the shear modulus that Johnson and Cook's set takes."""
    sources = library.find("uranium_ti").sources
    assert [s.quantity for s in sources if "DOUBT" in s.note] == ["strength.pressure_coefficient", "strength.melt_gruneisen"]
    assert any("S035" in w for w in library.find("uranium_ti").warnings) and not library.find("uranium_ti_johnson_cook").warnings
    assert all("DOUBT" in s.note for s in library.find("rdx").sources if s.quantity.startswith("eos."))
