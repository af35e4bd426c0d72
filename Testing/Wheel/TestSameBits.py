# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.pyvista gives what the VTK filters give, array by array, bit for bit.

It runs where the filters fit the VTK that PyVista runs on.
"""

import sys
from pathlib import Path

import numpy as np
import pytest
import pyvista as pv

try:
    from vtkflipflop import (
        vtkFFAlgorithm,
            vtkFFConvexifyFilter,
        vtkFFHullFilter,
        vtkFFPointsToImage,
        vtkFFPowerDiagramFilter,
        vtkFFRegularTriangulationFilter,
        vtkFFTerrainMeshFilter,
    )
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkCommonTransforms import vtkTransform
except ImportError as error:
    pytest.skip(f"no VTK filters here: {error}", allow_module_level=True)
if not issubclass(pv.PolyData, vtkPolyData):
    pytest.skip("PyVista runs on another VTK than the filters", allow_module_level=True)

from vtkflipflop.pyvista import (
    constrained_triangulation,
    convex_hull,
    convexify,
    power_diagram,
    regular_triangulation,
    terrain_mesh,
    to_image,
)

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Python"))
import digests  # noqa: E402

TOP = Path(__file__).resolve().parents[2]
TRANSFORM = np.array([[0.8, 0.3, -0.1, 1], [-0.2, 0.7, 0.5, 2], [0.3, -0.4, 0.9, 3], [0, 0, 0, 1]])


def with_data(mesh):
    """The mesh with point data of many types, field data, and something active."""
    if not isinstance(mesh, pv.DataSet):
        return mesh
    count = mesh.n_points
    if count:
        ids = np.arange(count)
        for kind in "i1 u1 i2 u2 i4 u4 i8 u8 f4 f8".split():
            mesh.point_data[kind] = (ids % 100).astype(kind)
        mesh.point_data["flag"] = ids % 3 == 0
        mesh.point_data["name"] = np.array([f"p{i}" for i in ids])
        mesh.point_data["Normals"] = np.ones((count, 3))
        mesh.point_data["weight"] = np.sin(ids) * 1e-3
        mesh.point_data.active_normals_name = "Normals"
        mesh.point_data.active_scalars_name = "f4"
    mesh.field_data["source"] = [3, 4]
    mesh.field_data["FlipFlopVolume"] = [3.0]
    return mesh


def rows(count, seed=1):
    return np.random.default_rng(seed).random((count, 3))


def turned_image():
    grid = pv.ImageData(dimensions=(4, 5, 6), spacing=(0.1, 0.7, 1e-3), origin=(1, 1e6, -3))
    grid.SetDirectionMatrix(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6)
    return grid.extract_subset((1, 3, 0, 4, 2, 5))


def some_ghosts():
    mesh = pv.PolyData(rows(300))
    mesh.point_data["vtkGhostType"] = (np.arange(300) % 4).astype(np.uint8)
    return mesh


MESHES = {
    "empty": lambda: pv.PolyData(),
    "point": lambda: pv.PolyData(np.ones((4, 3))),
    "line": lambda: pv.PolyData(np.outer(np.arange(9.0), [1, 2, 3])),
    "plane": lambda: pv.Plane(direction=(1, 2, 3), i_resolution=7, j_resolution=5),
    "flat": lambda: pv.PolyData(rows(200) * [1, 1, 0]),
    "uniform": lambda: pv.PolyData(rows(2000)),
    "floats": lambda: pv.PolyData(rows(2000).astype(np.float32)),
    "lattice": lambda: pv.PolyData(np.stack(np.mgrid[:6, :5, :4], -1).reshape(-1, 3), force_float=False),
    "bytes": lambda: pv.PolyData((rows(300) * 255).astype(np.uint8), force_float=False),
    "grid": lambda: pv.PolyData(rows(100)).cast_to_unstructured_grid(),
    "image": lambda: pv.ImageData(dimensions=(3, 4, 5), origin=(0.1, 0.2, 0.3)),
    "turned": turned_image,
    "rectilinear": lambda: pv.RectilinearGrid(*(np.arange(n) ** 1.5 for n in (3, 4, 5))),
    "narrow": lambda: pv.RectilinearGrid(*(np.arange(n, dtype=np.float32) ** 0.5 for n in (3, 4, 5))),
    "far": lambda: pv.PolyData(rows(500) + 1e15),
    "ghosts": some_ghosts,
    "partitions": lambda: pv.PartitionedDataSet([made(name) for name in ("uniform", "floats", "empty", "ghosts")]),
    "blocks": lambda: blocks(),
    "autzen": lambda: pv.read(TOP / "Data" / "autzen.vtp"),
}


def made(name):
    return with_data(MESHES[name]())


def blocks():
    inner = pv.MultiBlock({"b": made("image"), "c": made("ghosts")})
    whole = pv.MultiBlock({"a": made("uniform"), "none": None, "inner": inner, "empty": pv.PolyData(),
                           "d": made("floats")})
    whole.field_data["survey"] = [7]
    return whole


def parts(data):
    found = digests.digest(data)
    del found["class"]  # of PyVista's own
    return found


def expect_same(function, kind, mesh, settings, calls):
    """The function with its settings gives what a filter of this class gives after these calls, on each port."""
    algorithm = kind()
    for name, values in calls.items():
        getattr(algorithm, name)(*values)
    algorithm.SetInputDataObject(mesh)
    algorithm.Update()
    assert algorithm.GetErrorCode() == 0
    found = function(mesh, **settings)
    for port, one in enumerate(found if isinstance(found, tuple) else (found,)):
        assert parts(one) == parts(algorithm.GetOutputDataObject(port)), port


def transform():
    turn = vtkTransform()
    turn.SetMatrix(TRANSFORM.ravel().tolist())
    return turn


POLYGONS = {"facets": "polygons"}, {"SetFacetMode": [vtkFFAlgorithm.FACETS_AS_POLYGONS]}
IGNORING = {"non_finite": "ignore"}, {"SetNonFinitePoints": [vtkFFAlgorithm.NON_FINITE_IGNORE]}
HIDDEN = {"return_hidden_points": True}, {}
PLANES = {
    "xy": ({}, {}),
    "fitted": ({"projection_plane_mode": "best_fitting_plane"},
               {"SetProjectionPlaneMode": [vtkFFPowerDiagramFilter.BEST_FITTING_PLANE]}),
    "turned": ({"transform": TRANSFORM}, {"SetTransform": [transform()]}),
}


def weighted(name, radii=False, factor=1.0):
    settings = {"radii" if radii else "weights": name, "weight_factor": factor}
    calls = {"SetInputArrayToProcess": [0, 0, 0, 0, name], "SetWeightMode": [int(radii)], "SetWeightFactor": [factor]}
    return settings, calls


HULLS = {
    "triangles": [],
    "polygons": [POLYGONS],
    "bare": [({"skip_ghost_points": False, "pass_point_data": False},
              {"SetSkipGhostPoints": [0], "SetPassPointData": [0]})],
    "of all": [({"composite_mode": "all_blocks"}, {"SetCompositeMode": [vtkFFHullFilter.HULL_OF_ALL_BLOCKS]})],
}
PLANAR = {"plain": [], "weights": [weighted("weight")]}
PLANAR |= {
    f"{'radii' if radii else 'weights'} {name} {factor}": [weighted(name, radii, factor)]
    for name in ("f4", "u2") for radii in (False, True) for factor in (0.03, -0.7)
}  # fmt: skip
TRIANGULATIONS = {"polygons": [POLYGONS], "hidden": [HIDDEN, weighted("weight")]}
for limit in (1e-9, 0.05, 2.0**0.5, 30.0, np.inf):
    TRIANGULATIONS[f"edges {limit}"] = [({"maximum_edge_length": limit}, {"SetMaximumEdgeLength": [limit]})]
    TRIANGULATIONS[f"alpha {limit}"] = [weighted("weight"), ({"alpha": limit}, {"SetAlpha": [limit]})]
TRIANGULATIONS["edges of polygons"] = [POLYGONS, *TRIANGULATIONS["edges 0.05"]]
DIAGRAMS = {"box": [weighted("weight"),
                    ({"box": (-0.25, 0.5, 0.125, 2)}, {"SetPowerDiagramBounds": [-0.25, 0.5, 0.125, 2]})]}


def joined(*rows):
    """One row of settings and of calls."""
    return {k: v for row in rows for k, v in row[0].items()}, {k: v for row in rows for k, v in row[1].items()}


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("row", HULLS)
def test_hulls(name, row):
    expect_same(convex_hull, vtkFFHullFilter, made(name), *joined(*HULLS[row]))


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("plane", PLANES)
def test_in_the_plane(name, plane):
    mesh = made(name)
    for rows in [*PLANAR.values(), *TRIANGULATIONS.values()]:
        expect_same(
            regular_triangulation, vtkFFRegularTriangulationFilter, mesh, *joined(PLANES[plane], *rows)
        )
    for rows in [*PLANAR.values(), *DIAGRAMS.values()]:
        expect_same(power_diagram, vtkFFPowerDiagramFilter, mesh, *joined(PLANES[plane], *rows))


@pytest.mark.parametrize("name", MESHES)
def test_terrain_meshes(name):
    tolerance = {"tolerance": 0.25}, {"SetTolerance": [0.25]}
    few = {"max_vertices": 20}, {"SetTolerance": [0], "SetMaximumNumberOfVertices": [20]}
    heights = {"heights": "u2"}, {"SetInputArrayToProcess": [0, 0, 0, 0, "u2"]}
    for rows in ([tolerance], [HIDDEN, tolerance], [HIDDEN, few], [HIDDEN, tolerance, heights]):
        expect_same(terrain_mesh, vtkFFTerrainMeshFilter, made(name), *joined(*rows))


@pytest.mark.parametrize("name", ["plane", "uniform", "floats", "lattice", "image", "rectilinear", "ghosts", "autzen"])
@pytest.mark.parametrize("mode, method", [(0, "linear"), (1, "natural"), (2, "clough-tocher")])
def test_images(name, mode, method):
    mesh = made(name)
    # Sums of few bits: rows are at the same positions, whatever side they are counted from.
    x0, x1, y0, y1 = np.asarray(mesh.bounds[:4]).round() + [-0.5, 0.5, -0.5, 0.5]
    step = 2.0 ** np.ceil(np.log2(max(x1 - x0, y1 - y0))) / 64
    filter_ = vtkFFPointsToImage()
    filter_.SetInputDataObject(mesh)
    filter_.SetSizeMode(vtkFFPointsToImage.SIZE_BY_SPACING)
    filter_.SetSpacing(step, step)
    filter_.SetUseInputBounds(False)
    filter_.SetSamplingBounds(x0, x1, y0, y1)
    filter_.SetInterpolationMode(mode)
    for threads in (1, 2, 4):
        filter_.SetNumberOfThreads(threads)
        filter_.Update()
        expected = pv.wrap(filter_.GetOutput())
        for array in (None, "f4", "u2"):
            found = to_image(mesh, array, spacing=step, bounds=(x0, x1, y0, y1), method=method)
            assert (found.dimensions, found.origin, found.spacing) == (expected.dimensions, expected.origin,
                                                                       expected.spacing)
            values = found[array or "Elevation"]
            assert np.array_equal(values, expected[array or "Elevation"].astype(values.dtype), equal_nan=True), array
            assert not np.isnan(values).all()


@pytest.mark.parametrize("name", ["uniform", "ghosts", "floats"])
def test_lines_with_points_of_their_own(name):
    mesh = made(name)
    points = [*mesh.points[1:3], [0.1, 0.2, 0.3], [0.9, 0.8, 0.7], [0.1, 0.9, 3], [0.9, 0.1, 4], [0.2, 0.2, 0]]
    lines = pv.PolyData(points, lines=[3, 1, 2, 3, 2, 4, 5], faces=[4, 2, 5, 3, 4])
    lines.point_data["f8"] = np.arange(7) + 0.5
    lines.point_data["name"] = np.array([f"q{i}" for i in range(7)])
    algorithm = vtkFFRegularTriangulationFilter()
    algorithm.SetInputDataObject(mesh)
    algorithm.SetSourceData(lines)
    algorithm.SetSplitCrossingConstraints(True)
    algorithm.Update()
    expected, found = pv.wrap(algorithm.GetOutput()), constrained_triangulation(mesh, lines)
    assert found.points.tobytes() == expected.points.tobytes()
    assert np.array_equal(found.regular_faces, expected.regular_faces)
    assert {*found.point_data.keys()} == {*expected.point_data.keys()}
    for array in found.point_data.keys():
        types = (mesh.GetPointData().GetAbstractArray(array).GetDataType() for mesh in (found, expected))
        assert len(set(types)) == 1, array  # PyVista calls its own flags bool
        rows = found["PointOrigin"] < 2 if array not in ("PointOrigin", "HeightRange") else slice(None)
        assert np.array_equal(found[array][rows], expected[array][rows],
                              equal_nan=found[array].dtype.kind == "f"), array
    crossing = found["PointOrigin"] == 2
    assert crossing.sum() == algorithm.GetNumberOfSplitPoints() > 0
    assert found["f8"][crossing] == pytest.approx(expected["f8"][crossing], nan_ok=True)


@pytest.mark.parametrize("facets", [[], [POLYGONS]])
@pytest.mark.parametrize("name", ["uniform", "ghosts", "far"])
def test_constraints(name, facets):
    mesh = made(name)
    # Edges of the triangulation, some as lines and one triangle as a polygon, cross nothing.
    faces = regular_triangulation(mesh)
    chains = faces["vtkOriginalPointIds"][faces.regular_faces]
    source = pv.PolyData(mesh.points, lines=[2, *chains[3][:2], 3, *chains[7]], faces=[3, *chains[11]])
    row = joined(*facets, ({"constraints": source}, {"SetSourceData": [source]}))
    expect_same(regular_triangulation, vtkFFRegularTriangulationFilter, mesh, *row)


def test_points_that_are_not_finite():
    mesh = made("ghosts")
    mesh.points[[4, 9, 100], [0, 1, 2]] = np.nan, np.inf, np.nan
    expect_same(convex_hull, vtkFFHullFilter, mesh, *IGNORING)
    for plane in PLANES.values():
        rows = plane, IGNORING, weighted("weight")
        expect_same(regular_triangulation, vtkFFRegularTriangulationFilter, mesh, *joined(*rows, HIDDEN))
        expect_same(power_diagram, vtkFFPowerDiagramFilter, mesh, *joined(*rows))


@pytest.mark.parametrize("facets", [[], [POLYGONS]])
@pytest.mark.parametrize("kernel", [[], [({"kernel": (0.01, 0.02, 0)}, {"SetKernelPoint": [0.01, 0.02, 0]})]])
def test_surfaces(kernel, facets):
    surface = pv.Sphere(theta_resolution=20, phi_resolution=20).triangulate()
    surface.points *= 1 + 0.2 * np.random.default_rng(2).random((surface.n_points, 1))
    surface = with_data(surface)
    quads = with_data(pv.Cube().clean())
    stripped = pv.Sphere(theta_resolution=12, phi_resolution=9).strip()
    assert quads.faces[0] == 4 and stripped.n_strips
    for mesh in (surface, pv.PolyData(), pv.MultiBlock({"a": surface, "b": None}), quads, stripped):
        expect_same(convexify, vtkFFConvexifyFilter, mesh, *joined(*kernel, *facets))
