"""Two-dimensional runs in the run folder: result.h5 for xarray, gauges, budgets, and result.vtkhdf for ParaView."""

import h5py
import numpy as np
import pytest
import xarray
from plane_runs import GROWTH, STRETCH, TILT, motion, record

TIMES = np.array([0.0, 2e-6, 4e-6, 10e-6])


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return record(tmp_path_factory.mktemp("plane") / "rod.run")


def test_snapshots_have_zone_and_node_fields_with_units(run):
    with xarray.open_dataset(run.folder / "result.h5", group="snapshots", engine="h5netcdf") as rows:
        assert rows["pressure"].dims == ("time", "zone") and rows["velocity_x"].dims == ("time", "node")
        assert rows["pressure"].attrs["units"] == "Pa" and rows["position_x"].attrs["units"] == "m"
        assert np.array_equal(rows["time"], TIMES)
        assert set(np.unique(rows["region"].values)) == {"rod", "sleeve"}
        assert np.allclose(rows["centre_x"].values[:2], [0.25e-3, 0.25e-3]) and np.allclose(rows["centre_y"].values[:2], [0.5e-3, 1.5e-3])
    with xarray.open_dataset(run.folder / "result.h5", group="mesh", engine="h5netcdf") as mesh:
        assert mesh["zone_nodes"].shape == (90, 4) and set(mesh["block_of"].values) == {0, 1}
    assert run.snapshots["density"].coords["centre_y"].dims == ("zone",)


def test_gauges_read_the_motion(run):
    rows, names = run.arrays("gauges"), run.gauge_names()
    assert names == ["inside", "end", "glue", "streak"]
    grown = 1.0 + GROWTH * TIMES
    assert np.allclose(rows["position_x"][:, 0], 1.25e-3 * grown, rtol=1e-12)
    assert np.allclose(rows["velocity_y"][:, 0], STRETCH * 4.5e-3 + TILT * 1.25e-3, rtol=1e-12)
    assert np.allclose(rows["pressure"][:, 0], 1e12 * 4.5e-3 * (TIMES + 1e-6), rtol=1e-12)
    # the mean over the rod's end counts area: of each ring between nodes its middle radius, 4 rings of 0.5 mm
    middle = np.array([0.25, 0.75, 1.25, 1.75]) * 1e-3
    assert np.allclose(rows["velocity_x"][:, 1], GROWTH * (middle**2).sum() / middle.sum(), rtol=1e-12)
    assert np.allclose(rows["velocity_x"][:, 2], GROWTH * 2e-3, rtol=1e-12)
    assert np.isnan(rows["line_position"][:, :3]).all()
    assert np.isfinite(rows["temperature"][:, 0]).all() and np.isnan(rows["temperature"][:, 2]).all()


def test_a_line_of_sight_sees_where_the_surface_crosses_it(run):
    """The sleeve's side stays straight and parallel to the axis here, so the crossing moves as the material does: tilt it and it does not."""
    rows = run.arrays("gauges")
    assert np.allclose(rows["line_position"][:, 3], 5e-3 * (1.0 + GROWTH * TIMES), rtol=1e-12)
    assert np.allclose(rows["line_velocity"][:, 3], 5e-3 * GROWTH, rtol=1e-10)


def test_a_line_of_sight_counts_the_slope_of_the_surface():
    """A surface at the angle theta that slides along itself: its material does not move along the line, the crossing does."""
    from plane_runs import DECK, Moving

    from hugoniot.diagnostics.gauges2d import Sampler
    from hugoniot.problem.deck import read_deck_text
    from hugoniot.state import State2D

    problem = read_deck_text(DECK).problem
    solver, slope, speed = Moving(problem), 0.2, 1000.0
    sampler, state = Sampler(problem), solver.state()
    r, z = problem.mesh.nodes
    found = []
    for time in (0.0, 1e-7):
        nodes = {"position_x": r + slope * z, "position_y": z + speed * time, "velocity_x": 0.0 * r, "velocity_y": 0.0 * r + speed}
        found.append(sampler(State2D(time, 0, state.zones, nodes, problem.mesh.zone_nodes)))
    seen = [values["line_position"][3] for values in found]
    assert found[0]["line_velocity"][3] == pytest.approx(-speed * slope, rel=1e-12)
    assert seen[1] - seen[0] == pytest.approx(-speed * slope * 1e-7, rel=1e-9)
    assert found[0]["velocity_x"][3] == 0.0


def test_budgets_are_kept_by_region_and_by_chain(run):
    rows = run.arrays("budget")
    assert np.allclose(rows["kinetic_energy"].sum(axis=1), 5.0) and rows["kinetic_energy"].shape == (4, 2)
    assert np.allclose(rows["work sleeve.top"], TIMES) and run.unit("budget", "work sleeve.top") == "J/rad"
    assert run.setup["boundaries"]["rod.left"]["kind"] == "axis" and run.setup["boundaries"]["sleeve.right"]["kind"] == "free"
    assert any("Caramana" in text for text in run.setup["references"])


def test_vtkhdf_has_the_structure_of_a_temporal_grid(run):
    with h5py.File(run.folder / "result.vtkhdf") as file:
        root = file["VTKHDF"]
        assert bytes(root.attrs["Type"]) == b"UnstructuredGrid" and root.attrs["Version"].tolist() == [2, 2]
        steps = root["Steps"]
        assert steps.attrs["NSteps"] == 4 and np.array_equal(steps["Values"], TIMES)
        nodes, zones = int(root["NumberOfPoints"][0]), int(root["NumberOfCells"][0])
        assert root["Points"].shape == (4 * nodes, 3) and root["CellData/pressure"].shape == (4 * zones,)
        assert np.array_equal(steps["PointOffsets"], nodes * np.arange(4)) and (steps["CellOffsets"][()] == 0).all()
        assert np.array_equal(steps["CellDataOffsets/pressure"], zones * np.arange(4)) and (steps["CellDataOffsets/block"][()] == 0).all()
        assert root["PointData/velocity"].shape == (4 * nodes, 3) and root["CellData/pressure"].attrs["units"] == "Pa"
        assert np.array_equal(root["Offsets"], 4 * np.arange(zones + 1)) and (root["Types"][()] == 9).all()


def test_vtkhdf_is_the_same_in_blocks_straight_to_the_disk(run, tmp_path, monkeypatch):
    from hugoniot.output import hdf5, vtkhdf
    from hugoniot.output.series import Table

    rows, mesh = run.arrays("snapshots"), run.arrays("mesh")
    columns = {name: rows[name] for name, shape in rows.shapes.items() if name in ("time", "cycle") or len(shape) == 2}
    monkeypatch.setattr(hdf5, "IN_MEMORY", 0)
    monkeypatch.setattr(vtkhdf, "ROWS", 100)
    vtkhdf.write_vtkhdf(tmp_path / "again.vtkhdf", Table.of(columns), mesh["zone_nodes"], mesh["block_of"])
    with h5py.File(run.folder / "result.vtkhdf") as one, h5py.File(tmp_path / "again.vtkhdf") as other:
        names = []
        one.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
        assert len(names) > 20 and all(np.array_equal(one[name][()], other[name][()], equal_nan=True) for name in names)
        assert np.array_equal(one["VTKHDF/Points"][:, 1], rows["position_y"].ravel()) and not one["VTKHDF/Points"][:, 2].any()


def test_vtk_reads_every_step(run):
    reader_module = pytest.importorskip("vtkmodules.vtkIOHDF", reason="the vtk package is not installed")
    from vtkmodules.util.numpy_support import vtk_to_numpy

    reader = reader_module.vtkHDFReader()
    reader.SetFileName(str(run.folder / "result.vtkhdf"))
    reader.UpdateInformation()
    mesh = run.arrays("mesh")
    assert reader.GetNumberOfSteps() == 4
    for step in range(4):
        reader.SetStep(step)
        reader.Update()
        grid = reader.GetOutput()
        points = vtk_to_numpy(grid.GetPoints().GetData())
        assert grid.GetNumberOfCells() == len(mesh["zone_nodes"]) and grid.GetCellType(0) == 9
        assert np.allclose(points[:, 0], run.arrays("snapshots")["position_x"][step], rtol=1e-6)
        pressure = vtk_to_numpy(grid.GetCellData().GetArray("pressure"))
        assert np.allclose(pressure, run.arrays("snapshots")["pressure"][step], rtol=1e-6)
        velocity = vtk_to_numpy(grid.GetPointData().GetArray("velocity"))
        assert np.allclose(velocity[:, 1], run.arrays("snapshots")["velocity_y"][step], rtol=1e-6)
        assert [grid.GetCell(5).GetPointId(k) for k in range(4)] == mesh["zone_nodes"][5].tolist()


def test_the_motion_of_these_tests_is_its_own_derivative():
    from plane_runs import DECK

    from hugoniot.problem.deck import read_deck_text

    mesh = read_deck_text(DECK).problem.mesh
    early, late = motion(mesh, 1e-6), motion(mesh, 2e-6)
    for axis in ("x", "y"):
        assert np.allclose((late[f"position_{axis}"] - early[f"position_{axis}"]) / 1e-6, early[f"velocity_{axis}"], rtol=1e-8, atol=1e-8)
