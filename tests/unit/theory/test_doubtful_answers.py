"""What is said beside an answer that may mean nothing: points that are no shocks, fits at a bound, laws without sound or without releases."""

import json

import numpy as np
import pytest
from typer.testing import CliRunner

from hugoniot.cli.main import build_app
from hugoniot.laws.eos.herrmann_series import HerrmannSeries
from hugoniot.laws.eos.jwl_proportional import JWLProportional
from hugoniot.materials.material import Material
from hugoniot.materials.plausible import unlikely
from hugoniot.theory.fits import fit_jwl
from hugoniot.theory.solid_fits import fit_solid


def ask(*words):
    found = CliRunner().invoke(build_app("eos"), ["eos", *map(str, words)])
    assert found.exit_code == 0, found.output
    return found


def points(folder, up, us):
    path = folder / "points.csv"
    path.write_text("up (m/s), us (m/s)\n" + "\n".join(f"{a}, {b}" for a, b in zip(up, us)) + "\n")
    return path


@pytest.mark.parametrize("us, words", [
    ([5100.0, 5300.0, 350.0, 5700.0, 5900.0], ["1 of 5 points have a shock velocity not above the particle velocity", "up = 400, us = 350"]),
    ([90.0, 190.0, 280.0, 370.0, 450.0], ["5 of 5 points", "velocity is not above the particle velocity at up"]), ([5900.0, 5700.0, 5500.0, 5300.0, 5100.0], ["falls with the particle"]),
    ([5100.0, 5300.0, 5500.0, 5700.0, 5900.0], [])])
def test_points_that_are_no_shocks_are_named(tmp_path, us, words):
    path = points(tmp_path, [100.0, 200.0, 400.0, 600.0, 800.0], us)
    shown, given = ask("fit", path), json.loads(ask("fit", path, "--json").stdout)["warnings"]
    assert all(any(word in text for text in given) and word in shown.output for word in words) and bool(given) == bool(words)


def test_a_fit_whose_exponent_ends_at_a_bound_says_so():
    """Points of a single exponential do not determine a second one; those of the law itself determine both."""
    law = JWLProportional(3e14, 1.2e9, 17.0, 1.4, 1.6, 2700.0)
    x = np.linspace(0.02, 0.3, 12)

    def curve(v):
        return sum(c * (1.0 - law.gamma0 / r) * np.exp(-r * v) for c, r in ((law.a, law.r1), (law.b, law.r2)))

    p = (curve(1.0 - x) - curve(1.0)) / (1.0 - 0.5 * law.gamma0 * x)
    us = np.sqrt(p / (law.rho0 * x))
    assert fit_solid(law.rho0, law.gamma0, x * us, us).at_bounds == ()
    short = np.linspace(0.76, 0.80, 6)
    found = fit_jwl(1630.0, 6930.0, 21e9, 7e9, short, 21e9 * (short / 0.7317) ** -2.6)
    assert found.at_bounds and set(found.at_bounds) <= {"R1 - R2", "R2", "omega"}


def test_a_law_that_softens_at_once_is_questioned_wherever_it_is_read(tmp_path):
    soft, sound = HerrmannSeries(2785.0, 79e9, -50.0, 0.0, 0.0, 5570.0), HerrmannSeries(2780.0, 76.4e9, 1.014, 2.36, 5.13, 5473.0)
    (text,) = unlikely("al", Material("al", soft))
    # d/deta of eta (1 - 50 eta) is negative from eta = 1/100 on, that is at rho0/0.99 and within the step of the search above it
    assert "no real sound speed" in text and 2785.0 / 0.99 < float(text.split("sound speed above ")[1].split(" kg")[0]) < 1.006 * 2785.0 / 0.99
    assert unlikely("al", Material("al", sound)) == []
    (tmp_path / "soft.toml").write_text('[eos]\nlaw = "herrmann_series"\n' + "".join(f"{k} = {v}\n" for k, v in soft._asdict().items() if v == v))
    assert "its pressure falls with compression there" in ask("show", tmp_path / "soft.toml").output


def test_the_law_of_shocks_alone_says_so_and_has_no_gruneisen_parameter(tmp_path):
    (tmp_path / "kb.toml").write_text('[eos]\nlaw = "shock_energy"\nrho0 = 8930.0\nc0 = 3940.0\ns = 1.489\n')
    shown = ask("show", tmp_path / "kb.toml").output
    assert "has no Grüneisen parameter" in shown and "Grüneisen parameter  " not in shown
    assert "computed with it are meaningless" in ask("isentrope", tmp_path / "kb.toml", "--at", "pressure = 20 GPa").output
    assert "mean nothing" not in ask("show", "copper").output


def test_a_mixture_hugoniot_without_a_state_names_the_command_that_starts_from_rest():
    found = CliRunner().invoke(build_app("eos"), ["eos", "mixture", "lx_17", "--hugoniot", "40 GPa"])
    assert found.exit_code != 0 and "from which --hugoniot starts" in str(found.exception) + found.output
