"""What `hugoniot check` says of materials of a deck: how far their data may reach, and what lies beyond or is no constant of a material."""

import json
import math

import pytest

from hugoniot.cli.main import main
from hugoniot.materials import library, validity
from hugoniot.output.setup_record import setup_record
from hugoniot.output.spall_records import hit_regions
from hugoniot.problem.deck import read_deck_text
from hugoniot.theory.impedance import match

FAST = """stop_time = "1 us"
[[region]]
name = "a"
material = "own"
from = 0.0
to = 1e-3
zones = 10
velocity = {velocity}
[[region]]
name = "b"
material = "own"
from = 1e-3
to = 2e-3
zones = 10
[material.own.eos]
"""
SOLID = 'law = "mie_gruneisen"\nrho0 = 2700.0\nc0 = 5200.0\ns = 1.5\ngamma0 = 2.0\n'
GAS = 'law = "ideal_gas"\ngamma = 1.4\nrho0 = 1.2\n'

@pytest.mark.parametrize("law, velocity, words", [
    (SOLID, 50e3, "312 MJ/kg): its atoms are ionised there"), (GAS, 1e8, "its atoms are ionised there"),
    (SOLID.replace("2700.0", "8.19").replace("5200.0", "4.6"), 300.0, 'c0 = 4.6 m/s for a solid or liquid? A bare number is SI; write "4.6 km/s"'),
    (SOLID.replace("2700.0", "8.19"), 300.0, 'rho0 = 8.19 kg/m^3 for a solid or liquid? A bare number is SI; write "8.19 g/cm^3"'),
    (SOLID.replace("s = 1.5", "s = 0.9").replace("5200.0", "2500.0"), 14e3, "that is beyond 5769 m/s, at which the law gives a density of 4 rho0"),
    (SOLID.replace("s = 1.5", "s = 148.9"), 300.0, "s = 148.9 for a solid or liquid? No known material comes near this: is the value right?"),
    (SOLID.replace("2700.0", "7850.0").replace("5200.0", "4570.0").replace("s = 1.5", "s = 1.49e11"), 2500.0, "s = 1.49e+11 for a solid"),      # hung
    (SOLID + '[material.own.strength]\nlaw = "perfectly_plastic"\nshear_modulus = 26.5\nyield_stress = "0.3 GPa"\n', 300.0, 'write "26.5 GPa"'),
    (SOLID, 300.0, "")])
@pytest.mark.parametrize("solver", ["lagrange1d", "fronts"])
def test_check_warns_of_nonsense(tmp_path, capsys, law, velocity, words, solver):
    """rho0 = 8.19 and c0 = 4.6 are copper in other units."""
    (tmp_path / "deck.toml").write_text(f'solver.kind = "{solver}"\n' + FAST.format(velocity=velocity) + law)
    for more in ((), ("--json",)):
        with pytest.raises(SystemExit) as ended:
            main(["check", str(tmp_path / "deck.toml"), *more])
        told = capsys.readouterr().out
        assert not ended.value.code
        warnings = json.loads(told)["warnings"] if more else [line for line in told.splitlines() if line.startswith("warning: ")]
        assert any(words in text for text in warnings) if words else not warnings


def test_velocities_of_a_profile_count_as_those_of_the_region_do():
    """A constant velocity may be written either way: the same warnings, and in the set-up of the run the same impact."""
    plain, profile = "velocity = 40e3", '[region.profile]\nvelocity = "40 km/s + 0 m/s * x / 1 m"'
    decks = [read_deck_text(FAST.format(velocity="40e3").replace(plain, words) + SOLID, "deck.toml") for words in (plain, profile)]
    assert any("ionised" in text for text in decks[0].warnings) and decks[0].warnings == decks[1].warnings
    flying, struck = setup_record(decks[1].problem, {})["regions"]
    assert flying["velocity"] == 40e3 and hit_regions({"regions": [flying, struck]}) == ["b"]


@pytest.mark.parametrize("law, end, words", [(SOLID, 15e3, "15000 m/s, an estimate for all materials: above roughly this velocity atoms are ionised"),
                                             (SOLID.replace("s = 1.5", "s = 0.9").replace("5200.0", "2500.0"), 2500.0 / (4.0 / 3.0 - 0.9), "5769 m/s, at which the law"),
                                             (SOLID.replace("2700.0", "22000.0").replace("5200.0", "9000.0"), None, "m/s, at which the pressure of a shock is 10 TPa")])
def test_check_shows_the_estimated_range_of_a_decks_own_material(tmp_path, capsys, law, end, words):
    """Fourfold compression on Us = c0 + s up is at up = c0 / (4/3 - s); 10 TPa at rho0 Us up."""
    (tmp_path / "deck.toml").write_text(FAST.format(velocity=300.0) + law)
    with pytest.raises(SystemExit):
        main(["check", str(tmp_path / "deck.toml")])
    assert f"range of the data of own: not stated; a run warns only above a particle velocity of {words if end else ''}" in (shown := capsys.readouterr().out)
    assert words in shown
    with pytest.raises(SystemExit):
        main(["check", str(tmp_path / "deck.toml"), "--json"])
    told = json.loads(capsys.readouterr().out)["ranges"]["own"]
    end = end or (math.sqrt(9000.0**2 + 4.0 * 1.5 * 10e12 / 22000.0) - 9000.0) / 3.0
    assert told["up_to"] is None and told["estimated_up_to"] == pytest.approx(end, rel=1e-6)


@pytest.mark.parametrize("names, velocity", [(("gold", "aluminum_2024"), 30e3), (("aluminum_2024", "copper"), 6e3), (("copper", "pmma"), 5e3), (("air", "copper"), 2e3)])
def test_the_particle_velocities_of_an_impact_are_those_of_the_exact_match(names, velocity):
    left, right = map(library.find, names)
    met = match([left, right], velocity)[0]
    found = validity.impact(left, right, velocity)
    assert found[1] == pytest.approx(met.particle_velocity, rel=1e-6) and found[0] == pytest.approx(velocity - met.particle_velocity, rel=1e-6)


def test_an_impact_that_drives_only_the_lighter_body_beyond_its_data_names_it():
    """Half of 6 km/s is within the data of aluminium, but copper drives it to more."""
    copper, aluminium = library.find("copper"), library.find("aluminum_2024")
    deck = FAST.format(velocity=6000.0).replace('"own"', '"copper"', 1).replace('"own"', '"aluminum_2024"').replace("[material.own.eos]\n", "")
    told = [words for words in read_deck_text(deck).warnings if "hits" in words]
    up = validity.impact(copper, aluminium, 6000.0)
    assert up[0] < copper.valid_up_to and 3000.0 < aluminium.valid_up_to < up[1]
    assert len(told) == 1 and "'a' hits 'b' at 6000 m/s, which drives 'aluminum_2024'" in told[0]


@pytest.mark.parametrize("duration, short", [("19 ns", True), ("20 ns", False)])
@pytest.mark.parametrize("side", ["left", "right"])
def test_a_pulse_that_its_zone_cannot_show_is_warned_of(side, duration, short):
    """Sound of 5200 m/s crosses 0.1 mm in 19.23 ns."""
    pulse = f'{{pressure = {{shape = "square", amplitude = "1 GPa", duration = "{duration}"}}}}'
    warned = [text for text in read_deck_text(FAST.format(velocity=0) + SOLID + f"[boundary]\n{side} = {pulse}\n").warnings if "is driven for" in text]
    assert len(warned) == short and all(f"the {side} boundary" in text and "takes 19.2 ns" in text for text in warned)
