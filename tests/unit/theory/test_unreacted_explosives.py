"""Sets of unreacted explosives drive no detonation, though their form is that of products."""

import pytest

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.jwl import JWL
from hugoniot.materials.library import find
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import Initial, shock


def test_a_library_row_of_an_unreacted_set_is_an_inert_solid():
    material = find("J046")
    assert EOS.of(material.eos).name == "jwl_unreacted"
    with pytest.raises(OutOfRange, match="no energy is released"):
        cj(material)
    state = shock(material, pressure=5e9)
    assert 2000.0 < float(state.shock_velocity) < 6000.0


def test_products_without_pressure_at_constant_volume_are_refused():
    """The numbers of row J039, as a deck may have them: the tangency alone would find 2325 m/s and 31 MPa."""
    par = JWL(953220e9, -5.944e9, 14.1, 1.41, 0.8867, 1835.0, -0.14973e9)
    with pytest.raises(OutOfRange, match="unreacted explosive"):
        cj(par)
    assert cj(par, Initial(1835.0, 0.0, par.e0 / par.rho0, heat=5e6)).detonation_velocity > 6000.0
    assert cj(find("tnt")).detonation_velocity == pytest.approx(6930.0, rel=1e-3)
