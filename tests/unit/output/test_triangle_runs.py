"""Runs on triangles in the run folder and in pictures: three corners everywhere, gauges exact in linear motion."""

import h5py
import matplotlib
import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from plane_runs import DECK, GROWTH, STRETCH, TILT, record

from hugoniot.page import one_run, run_data

matplotlib.use("Agg")
TIMES = np.array([0.0, 2e-6, 4e-6, 10e-6])
TRIANGLES = DECK.replace('kind = "lagrange2d"', 'kind = "lagrange2d"\ncells = "triangles"\ndiagonal = "crossed"')


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return record(tmp_path_factory.mktemp("triangles") / "rod.run", TRIANGLES)


def test_zones_have_three_corners_and_gauges_read_the_motion(run):
    mesh, rows = run.arrays("mesh"), run.arrays("gauges")
    assert mesh["zone_nodes"].shape == (180, 3) and np.array_equal(np.bincount(mesh["block_of"].astype(int)), [80, 100])
    assert np.allclose(rows["position_x"][:, 0], 1.25e-3 * (1.0 + GROWTH * TIMES), rtol=1e-12)
    assert np.allclose(rows["velocity_y"][:, 0], STRETCH * 4.5e-3 + TILT * 1.25e-3, rtol=1e-12)
    assert np.allclose(rows["velocity_x"][:, 2], GROWTH * 2e-3, rtol=1e-12)
    assert np.allclose(rows["line_position"][:, 3], 5e-3 * (1.0 + GROWTH * TIMES), rtol=1e-12)


def test_vtkhdf_has_triangles_and_vtk_reads_them(run):
    with h5py.File(run.folder / "result.vtkhdf") as file:
        root = file["VTKHDF"]
        assert (root["Types"][()] == 5).all() and np.array_equal(root["Offsets"], 3 * np.arange(181))
        assert int(root["NumberOfConnectivityIds"][0]) == 540 == len(root["Connectivity"])
    reader_module = pytest.importorskip("vtkmodules.vtkIOHDF", reason="the vtk package is not installed")
    reader = reader_module.vtkHDFReader()
    reader.SetFileName(str(run.folder / "result.vtkhdf"))
    reader.UpdateInformation()
    reader.SetStep(3)
    reader.Update()
    grid, corners = reader.GetOutput(), run.arrays("mesh")["zone_nodes"]
    assert grid.GetNumberOfCells() == 180 and grid.GetCellType(0) == 5
    assert [grid.GetCell(7).GetPointId(k) for k in range(3)] == corners[7].tolist()
    assert grid.GetCellData().GetArray("pressure").GetValue(7) == pytest.approx(run.arrays("snapshots")["pressure"][3][7], rel=1e-6)


def test_pictures_show_triangles(run):
    """Maps and contours, profiles along a line, the set-up; a point of a profile has the value of the triangle that holds it."""
    ax = run.plot.map("pressure", mirror=False, contours=4)
    (zones,) = [part for part in ax.collections if isinstance(part, PolyCollection)]
    assert len(zones.get_paths()) == 180 and len(zones.get_paths()[0].vertices) == 4      # closed
    ax = run.plot.profile("pressure", time=0.0, start=(1.1e-3, 0.4e-3), end=(1.1e-3, 9.6e-3))
    place, values = map(np.asarray, ax.lines[0].get_data())
    linear = 1e6 * (0.4e-3 + 1e-3 * place)      # the pressure at the centre of a triangle of 1 mm, Pa
    factor = values.mean() / linear.mean()
    assert np.abs(values / factor - linear).max() < 1e6 * 0.7e-3
    assert "cells of two triangles" in run.plot.setup().get_legend().get_texts()[0].get_text()


def test_the_page_has_the_corners_of_triangles(run):
    found = run_data.description(run.folder)
    assert np.shape(found["zone_nodes"]) == (180, 3)
    assert one_run.answers(run.folder, "rod")["run&run=0"]["zone_nodes"]["shape"] == [180, 3]
