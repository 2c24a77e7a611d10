"""Surfaces, isotherms and cold curves; materials of files; the folder of a fit; the run inside its report."""

import base64
import json
import zlib

import numpy as np
import pytest
from explorer_words import STEEL, TOKEN, write_fit
from typer.testing import CliRunner

import hugoniot
from hugoniot.cli.main import build_app
from hugoniot.errors import DeckError, FileTrouble
from hugoniot.explorer import fits, subjects
from hugoniot.explorer.curves import curves_of
from hugoniot.explorer.places import places_of
from hugoniot.laws.eos import contract
from hugoniot.materials import library
from hugoniot.page import one_run, run_data
from hugoniot.theory.isentrope import at_temperature


@pytest.mark.parametrize("name", ["copper", "water", "iron", "air", "pmma"])
def test_states_in_the_range_of_a_surface_have_their_temperature(name):
    """The other way round: the law's own temperature at the energy that was found, at the corners of what is drawn."""
    par, drawn = library.find(name).eos, curves_of(name)["surface_range"]
    for rho in drawn["densities"]:
        for t in drawn["temperatures"]:
            p, e = at_temperature(par, rho, t)
            assert contract.temperature(rho, e, par) == pytest.approx(t, rel=1e-9, abs=1e-12 * abs(e)) and contract.pressure(rho, e, par) == p


def test_an_isotherm_obeys_the_identity_of_energy():
    """de = (T dp/dT - p) dv along 300 K, by quadrature; dp/dT from the isotherms beside it."""
    par = library.find("copper").eos
    nodes, weights = np.polynomial.legendre.leggauss(16)
    rho = 8930.0 + 0.5 * (nodes + 1.0) * 1500.0
    start, end = (np.array(at_temperature(par, r, 300.0)) for r in (8930.0, 10430.0))
    slope = np.array([(at_temperature(par, r, 301.0)[0] - at_temperature(par, r, 299.0)[0]) / 2.0 for r in rho])
    p = np.array([at_temperature(par, r, 300.0)[0] for r in rho])
    work = 0.5 * 1500.0 * float(np.sum(weights * (p - 300.0 * slope) / rho**2))
    assert end[1] - start[1] == pytest.approx(work, rel=1e-11)


def test_a_law_without_temperature_has_no_surface():
    assert "no temperature" in curves_of("granite")["surface_range"]["refused"]


def test_a_material_of_a_file_is_a_material_of_the_page(tmp_path, client):
    (tmp_path / "my_steel.toml").write_text(STEEL)
    assert places_of([str(tmp_path / "my_steel.toml")]).materials == ["my_steel"]
    listed = client.get(f"/{TOKEN}/api/materials").json()["materials"]
    assert listed[0]["name"] == "my_steel" and listed[0]["density"] == 7850.0 and listed[0]["category"] == "of my_steel.toml"
    assert client.get(f"/{TOKEN}/api/start").json()["files"] == {"my_steel": (tmp_path / "my_steel.toml").as_posix()}     # as typed, for the commands
    found = client.get(f"/{TOKEN}/api/state?name=my_steel&by=particle_velocity&value=500").json()["state"]
    assert found["shock_velocity"] == pytest.approx(4600.0 + 1.5 * 500.0) and found["pressure"] == pytest.approx(7850.0 * 5350.0 * 500.0)
    (tmp_path / "copper.toml").write_text(STEEL)
    with pytest.raises(DeckError, match="the library has a material of that name"):
        places_of([str(tmp_path / "copper.toml")])
    assert "copper" not in subjects.own


def test_two_files_cannot_have_a_material_of_one_name(tmp_path):
    """The one named last would have given all numbers under the name."""
    for folder in ("one", "two"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "my_steel.toml").write_text(STEEL)
    places_of([str(tmp_path / "one" / "my_steel.toml")] * 2)
    with pytest.raises(DeckError, match="has a material of that name too"):
        places_of([str(tmp_path / "two" / "my_steel.toml")])


def test_a_tabulated_material_has_the_surface_of_its_table(tmp_path):
    words = ["eos", "table", "copper", "--temperatures", "200 K, 3000 K", "--points", "21", "--csv", str(tmp_path / "copper.csv")]
    assert CliRunner().invoke(build_app("eos"), words).exit_code == 0
    (tmp_path / "tabulated.toml").write_text('[eos]\nlaw = "table"\nfile = "copper.csv"\nrho0 = "8930 kg/m^3"\n')
    places_of([str(tmp_path / "tabulated.toml")])
    table = subjects.entry_of("tabulated").material.eos
    drawn = curves_of("tabulated")["surface_range"]
    assert drawn["grid"] == drawn["temperatures"] == [200.0, 3000.0] and drawn["law"]["$"] == "table"
    assert table.density[0] <= drawn["densities"][0] < drawn["densities"][1] < table.density[-1]


def test_a_fit_is_read_from_its_folder(tmp_path):
    fit, data = write_fit(tmp_path / "spall.fit")
    places = places_of([str(tmp_path / "spall.fit")])
    assert [f.name for f in places.fits] == ["spall.fit"] and not places.runs
    found = fits.fit(places.fit(0).path)
    assert found["fit"] == fit and [t["name"] for t in found["targets"]] == ["free surface.velocity", "free surface.arrival", "pop plot 1.distance"]
    assert [(t["unit"], t["pop_plot"]) for t in found["targets"]] == [("m/s", False), ("s", False), ("m", True)]
    assert found["targets"][0]["data"] == data and found["targets"][0]["unit"] == "m/s" and found["targets"][1]["data"] == [6.9e-7]
    assert found["draws"] == []
    (tmp_path / "spall.fit" / "posterior.csv").write_text("a [Pa],b [s]\n" + "".join(f"{5e9 + k},{1e-9 * k}\n" for k in range(9)))
    assert fits.fit(places.fit(0).path)["draws"] == [[5e9 + k for k in range(9)], [1e-9 * k for k in range(9)]]
    (tmp_path / "spall.fit" / "residuals.csv").write_text("target,time [s],data,model,sigma,residual\na,1,2,3,4,5\n")
    with pytest.raises(FileTrouble, match="does not contain the number of points"):
        fits.fit(places.fit(0).path)
    (tmp_path / "spall.fit" / "fit.json").write_text("{")
    with pytest.raises(FileTrouble, match="cannot be read as a fit|fit.json: changed"):
        fits.fit(places.fit(0).path)


def unpacked(value):
    places = np.frombuffer(zlib.decompress(base64.b64decode(value["deflated"])), np.uint8).reshape(8, -1).T
    return np.ascontiguousarray(places).view("<f8").reshape(value["shape"])


def test_the_arrays_in_a_report_are_those_of_the_run(tube, monkeypatch):
    whole = hugoniot.load(tube).arrays("snapshots")
    known = json.loads(one_run.json_text(one_run.answers(tube, "x")))
    assert np.array_equal(unpacked(known["array&group=snapshots&name=pressure&run=0"]), whole["pressure"])
    assert "<" not in one_run.json_text(one_run.answers(tube, "x")) and known["start"]["views"] == ["report", "runs"]
    monkeypatch.setattr(one_run, "BYTES", 8 * 40 * 6 * 5)
    known = one_run.answers(tube, "x")
    assert known["run&run=0"]["every"] == 5 and np.array_equal(known["array&group=snapshots&name=velocity&run=0"], run_data.column(tube, "snapshots", "velocity", {})[::5])
    assert np.array_equal(known["run&run=0"]["times"], whole["time"][::5])
