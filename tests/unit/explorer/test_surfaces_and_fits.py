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
from hugoniot.errors import DeckError, FileTrouble, OutOfRange
from hugoniot.explorer import fits, subjects, surfaces
from hugoniot.explorer.places import places_of
from hugoniot.laws.eos import contract
from hugoniot.materials import library
from hugoniot.page import one_run, run_data
from hugoniot.theory.isentrope import at_temperature


def test_a_surface_is_the_table_of_the_command():
    mine = surfaces.surface("copper", (8000.0, 11000.0), (0.0, 2000.0), 5)
    words = ["eos", "table", "copper", "--densities", "8000 kg/m^3, 11000 kg/m^3", "--temperatures", "0 K, 2000 K", "--points", "5", "--json"]
    theirs = json.loads(CliRunner().invoke(build_app("eos"), words).output)
    for key in ("density", "temperature", "pressure", "specific_internal_energy"):
        assert np.array_equal(np.array(mine[key], float), np.array(theirs[key], float)), key


@pytest.mark.parametrize("name", ["copper", "water", "iron", "air", "pmma"])
def test_states_of_a_surface_have_their_temperature_and_the_cold_curve_has_none(name):
    """The other way round: the law's own temperature and pressure at the energy that was found."""
    par = library.find(name).eos
    found = surfaces.surface(name, points=7)
    scale = float(np.max(np.abs(found["specific_internal_energy"])))
    for i, rho in enumerate(found["density"]):
        for j, t in enumerate(found["temperature"]):
            e = found["specific_internal_energy"][i][j]
            assert contract.temperature(rho, e, par) == pytest.approx(t, rel=1e-9, abs=1e-12 * scale)
            assert contract.pressure(rho, e, par) == found["pressure"][i][j]
    cold = surfaces.surface(name, points=7, isotherms=True)
    assert cold["temperature"][0] == 0.0 and np.array_equal([row[0] for row in cold["pressure"]], [row[0] for row in found["pressure"]])


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


def test_surfaces_that_a_law_has_not_are_refused():
    for wrong in ({"densities": (1.0,)}, {"densities": (2e4, 1e4)}, {"temperatures": (300.0, 200.0)}, {"points": 1}, {"points": 500}, {"densities": (8000.0, 1e9)}):
        with pytest.raises(OutOfRange):
            surfaces.surface("copper", **wrong)
    with pytest.raises(OutOfRange, match="no temperature"):
        surfaces.surface("granite")


def test_a_material_of_a_file_is_a_material_of_the_page(tmp_path, client):
    (tmp_path / "my_steel.toml").write_text(STEEL)
    assert places_of([str(tmp_path / "my_steel.toml")]).materials == ["my_steel"]
    listed = client.get(f"/{TOKEN}/api/materials").json()["materials"]
    assert listed[0]["name"] == "my_steel" and listed[0]["density"] == 7850.0 and listed[0]["category"] == "of my_steel.toml"
    assert client.get(f"/{TOKEN}/api/start").json()["files"] == {"my_steel": "my_steel.toml"}
    found = client.get(f"/{TOKEN}/api/state?name=my_steel&by=particle_velocity&value=500").json()["state"]
    assert found["shock_velocity"] == pytest.approx(4600.0 + 1.5 * 500.0) and found["pressure"] == pytest.approx(7850.0 * 5350.0 * 500.0)
    (tmp_path / "copper.toml").write_text(STEEL)
    with pytest.raises(DeckError, match="the library has a material of that name"):
        places_of([str(tmp_path / "copper.toml")])
    assert "copper" not in subjects.own


def test_a_tabulated_material_has_the_surface_of_its_table(tmp_path):
    words = ["eos", "table", "copper", "--temperatures", "200 K, 3000 K", "--points", "21", "--csv", str(tmp_path / "copper.csv")]
    assert CliRunner().invoke(build_app("eos"), words).exit_code == 0
    (tmp_path / "tabulated.toml").write_text('[eos]\nlaw = "table"\nfile = "copper.csv"\nrho0 = "8930 kg/m^3"\n')
    places_of([str(tmp_path / "tabulated.toml")])
    table = subjects.entry_of("tabulated").material.eos
    found = surfaces.surface("tabulated", (float(table.density[0]), float(table.density[-1]) * (1 - 1e-12)), (200.0, 3000.0), 21)
    assert np.allclose(np.array(found["pressure"], float), table.pressure_table, rtol=1e-6, atol=1e4)
    assert surfaces.surface("tabulated", isotherms=True)["temperature"].tolist() == [300.0, 1000.0, 2000.0]


def test_a_fit_is_read_from_its_folder(tmp_path):
    fit, data = write_fit(tmp_path / "spall.fit")
    places = places_of([str(tmp_path / "spall.fit")])
    assert [f.name for f in places.fits] == ["spall.fit"] and not places.runs
    found = fits.fit(places.fit(0).path)
    assert found["fit"] == fit and [t["name"] for t in found["targets"]] == ["free surface.velocity", "free surface.arrival"]
    assert found["targets"][0]["data"] == data and found["targets"][0]["unit"] == "m/s" and found["targets"][1]["data"] == [6.9e-7]
    assert found["draws"] == []
    (tmp_path / "spall.fit" / "posterior.csv").write_text("a [Pa],b [s]\n" + "".join(f"{5e9 + k},{1e-9 * k}\n" for k in range(9)))
    assert fits.fit(places.fit(0).path)["draws"] == [[5e9 + k for k in range(9)], [1e-9 * k for k in range(9)]]
    (tmp_path / "spall.fit" / "residuals.csv").write_text("target,time [s],data,model,sigma,residual\na,1,2,3,4,5\n")
    with pytest.raises(FileTrouble, match="does not hold the number of points"):
        fits.fit(places.fit(0).path)
    (tmp_path / "spall.fit" / "fit.json").write_text("{")
    with pytest.raises(FileTrouble, match="cannot be read as a fit"):
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
