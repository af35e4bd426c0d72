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
        vtkFFConstrainedDelaunayFilter,
        vtkFFConvexifyFilter,
        vtkFFHullFilter,
        vtkFFPowerDiagramFilter,
        vtkFFRegularTriangulationFilter,
    )
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkCommonTransforms import vtkTransform
except ImportError as error:
    pytest.skip(f"no VTK filters here: {error}", allow_module_level=True)
if not issubclass(pv.PolyData, vtkPolyData):
    pytest.skip("PyVista runs on another VTK than the filters", allow_module_level=True)

from vtkflipflop.pyvista import convex_hull, convexify, power_diagram, regular_triangulation

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Python"))
import digests  # noqa: E402

TOP = Path(__file__).resolve().parents[2]
TRANSFORM = np.array([[0.8, 0.3, -0.1, 1], [-0.2, 0.7, 0.5, 2], [0.3, -0.4, 0.9, 3], [0, 0, 0, 1]])


def with_data(mesh):
    """The mesh with point data of many types, field data, and something active."""
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
    "autzen": lambda: pv.read(TOP / "Data" / "autzen.vtp"),
}


def blocks():
    made = pv.MultiBlock(
        {
            "a": with_data(MESHES["uniform"]()),
            "none": None,
            "inner": pv.MultiBlock({"b": with_data(MESHES["image"]()), "c": with_data(MESHES["ghosts"]())}),
            "empty": pv.PolyData(),
            "d": with_data(MESHES["floats"]()),
        }
    )
    made.field_data["survey"] = [7]
    return made


def outputs_of(algorithm, mesh):
    algorithm.SetInputDataObject(mesh)
    algorithm.Update()
    assert algorithm.GetErrorCode() == 0
    return [algorithm.GetOutputDataObject(port) for port in range(algorithm.GetNumberOfOutputPorts())]


def parts(data):
    found = digests.digest(data)
    del found["class"]  # of PyVista's own
    return found


def expect_same(found, expected):
    assert parts(found) == parts(expected)


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("facets", ["Triangles", "Polygons"])
def test_hulls(name, facets):
    mesh = with_data(MESHES[name]())
    algorithm = vtkFFHullFilter()
    algorithm.SetFacetMode(getattr(algorithm, f"FACETS_AS_{facets.upper()}"))
    (expected,) = outputs_of(algorithm, mesh)
    expect_same(convex_hull(mesh, facets=facets.lower()), expected)
    algorithm.SetSkipGhostPoints(False)
    algorithm.SetPassPointData(False)
    (expected,) = outputs_of(algorithm, mesh)
    found = convex_hull(mesh, facets=facets.lower(), skip_ghost_points=False, pass_point_data=False)
    expect_same(found, expected)


def planar_filter(make, projection, weights):
    algorithm = make()
    settings = {}
    if projection == "transform":
        transform = vtkTransform()
        transform.SetMatrix(TRANSFORM.ravel().tolist())
        algorithm.SetTransform(transform)
        settings["transform"] = TRANSFORM
    elif projection == "best_fitting_plane":
        algorithm.SetProjectionPlaneMode(algorithm.BEST_FITTING_PLANE)
        settings["projection_plane_mode"] = projection
    if weights:
        algorithm.SetInputArrayToProcess(0, 0, 0, 0, weights)
    return algorithm, settings


def triangulation_filter(projection, weights):
    return planar_filter(vtkFFRegularTriangulationFilter, projection, weights)


def diagram_filter(projection, weights):
    return planar_filter(vtkFFPowerDiagramFilter, projection, weights)[0]


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("projection", ["xy_plane", "best_fitting_plane", "transform"])
@pytest.mark.parametrize("weights", [None, "weight"])
def test_triangulations(name, projection, weights):
    mesh = with_data(MESHES[name]())
    algorithm, settings = triangulation_filter(projection, weights)
    expected, hidden, border = outputs_of(algorithm, mesh)
    (cells,) = outputs_of(diagram_filter(projection, weights), mesh)
    assert border.GetNumberOfPoints() == 0
    shown, left = regular_triangulation(mesh, weights, return_hidden_points=True, **settings)
    expect_same(shown, expected)
    expect_same(left, hidden)
    expect_same(power_diagram(mesh, weights, **settings), cells)
    algorithm.SetFacetMode(algorithm.FACETS_AS_POLYGONS)
    expect_same(
        regular_triangulation(mesh, weights, facets="polygons", **settings), outputs_of(algorithm, mesh)[0]
    )


@pytest.mark.parametrize("name", ["uniform", "floats", "bytes", "image", "ghosts", "far"])
@pytest.mark.parametrize("array", ["weight", "f4", "u2"])
@pytest.mark.parametrize("factor", [1.0, 0.03, -0.7])
@pytest.mark.parametrize("radii", [False, True])
def test_radii_and_factors(name, array, factor, radii):
    mesh = with_data(MESHES[name]())
    mesh.point_data["weight"] = np.abs(mesh.point_data["weight"])
    algorithm, _ = triangulation_filter("xy_plane", array)
    diagram = diagram_filter("xy_plane", array)
    for each in (algorithm, diagram):
        each.SetWeightMode(int(radii))
        each.SetWeightFactor(factor)
    expected, hidden, border = outputs_of(algorithm, mesh)
    (cells,) = outputs_of(diagram, mesh)
    assert border.GetNumberOfPoints() == 0
    settings = {"radii" if radii else "weights": array, "weight_factor": factor}
    shown, left = regular_triangulation(mesh, return_hidden_points=True, **settings)
    expect_same(shown, expected)
    expect_same(left, hidden)
    expect_same(power_diagram(mesh, **settings), cells)


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("projection", ["xy_plane", "best_fitting_plane", "transform"])
@pytest.mark.parametrize("facets", ["Triangles", "Polygons"])
def test_long_edges(name, projection, facets):
    mesh = with_data(MESHES[name]())
    algorithm, settings = triangulation_filter(projection, None)
    algorithm.SetFacetMode(getattr(algorithm, f"FACETS_AS_{facets.upper()}"))
    for limit in (1e-9, 0.05, 1.0, 2.0**0.5, 30.0, np.inf):
        algorithm.SetMaximumEdgeLength(limit)
        expected = outputs_of(algorithm, mesh)[0]
        found = regular_triangulation(mesh, maximum_edge_length=limit, facets=facets.lower(), **settings)
        expect_same(found, expected)


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("projection", ["xy_plane", "best_fitting_plane", "transform"])
@pytest.mark.parametrize("weights", [None, "weight"])
def test_alpha_complexes(name, projection, weights):
    mesh = with_data(MESHES[name]())
    algorithm, settings = triangulation_filter(projection, weights)
    for alpha in (1e-9, 0.05, 1.0, 30.0, np.inf):
        algorithm.SetAlpha(alpha)
        expected = outputs_of(algorithm, mesh)[0]
        expect_same(regular_triangulation(mesh, weights, alpha=alpha, **settings), expected)


@pytest.mark.parametrize("name", ["uniform", "ghosts", "far"])
@pytest.mark.parametrize("facets", ["Triangles", "Polygons"])
def test_constraints(name, facets):
    mesh = with_data(MESHES[name]())
    algorithm, settings = planar_filter(vtkFFConstrainedDelaunayFilter, "xy_plane", None)
    algorithm.SetFacetMode(getattr(algorithm, f"FACETS_AS_{facets.upper()}"))
    # Edges of the triangulation, some as lines and one triangle as a polygon, cross nothing.
    faces = regular_triangulation(mesh)
    ids = faces["vtkOriginalPointIds"]
    chains = ids[faces.regular_faces]
    source = pv.PolyData(mesh.points, lines=[2, *chains[3][:2], 3, *chains[7]], faces=[3, *chains[11]])
    algorithm.SetSourceData(source)
    expected = outputs_of(algorithm, mesh)[0]
    expect_same(regular_triangulation(mesh, constraints=source, facets=facets.lower(), **settings), expected)


def test_bounds_of_diagrams():
    for projection in ("xy_plane", "best_fitting_plane", "transform"):
        mesh = with_data(MESHES["uniform"]())
        bounds = (-0.25, 0.5, 0.125, 2)
        algorithm, settings = planar_filter(vtkFFPowerDiagramFilter, projection, "weight")
        algorithm.SetPowerDiagramBounds(*bounds)
        (cells,) = outputs_of(algorithm, mesh)
        expect_same(power_diagram(mesh, "weight", box=bounds, **settings), cells)


def test_points_that_are_not_finite():
    mesh = with_data(MESHES["ghosts"]())
    mesh.points[[4, 9, 100], [0, 1, 2]] = np.nan, np.inf, np.nan
    hull = vtkFFHullFilter()
    hull.SetNonFinitePoints(hull.NON_FINITE_IGNORE)
    expect_same(convex_hull(mesh, non_finite="ignore"), outputs_of(hull, mesh)[0])
    for projection in ("xy_plane", "best_fitting_plane", "transform"):
        algorithm, settings = triangulation_filter(projection, "weight")
        algorithm.SetNonFinitePoints(algorithm.NON_FINITE_IGNORE)
        diagram = diagram_filter(projection, "weight")
        diagram.SetNonFinitePoints(diagram.NON_FINITE_IGNORE)
        expected = outputs_of(algorithm, mesh)
        settings["non_finite"] = "ignore"
        found = regular_triangulation(mesh, "weight", return_hidden_points=True, **settings)
        expect_same(found[0], expected[0])
        expect_same(found[1], expected[1])
        expect_same(power_diagram(mesh, "weight", **settings), outputs_of(diagram, mesh)[0])


def test_composites():
    hull = vtkFFHullFilter()
    expect_same(convex_hull(blocks()), outputs_of(hull, blocks())[0])
    hull.SetCompositeMode(hull.HULL_OF_ALL_BLOCKS)
    expect_same(convex_hull(blocks(), composite_mode="all_blocks"), outputs_of(hull, blocks())[0])
    algorithm, settings = triangulation_filter("best_fitting_plane", "weight")
    expected = outputs_of(algorithm, blocks())
    found = regular_triangulation(blocks(), "weight", return_hidden_points=True, **settings)
    expect_same(found[0], expected[0])
    expect_same(found[1], expected[1])
    diagram = diagram_filter("best_fitting_plane", "weight")
    expect_same(power_diagram(blocks(), "weight", **settings), outputs_of(diagram, blocks())[0])


def test_partitions():
    pieces = [with_data(MESHES[name]()) for name in ("uniform", "floats", "empty", "ghosts")]
    partitions = pv.PartitionedDataSet(pieces)
    expect_same(convex_hull(partitions), outputs_of(vtkFFHullFilter(), partitions)[0])
    algorithm, _ = triangulation_filter("xy_plane", "weight")
    expected = outputs_of(algorithm, partitions)
    expect_same(regular_triangulation(partitions, "weight"), expected[0])
    diagram = diagram_filter("xy_plane", "weight")
    expect_same(power_diagram(partitions, "weight"), outputs_of(diagram, partitions)[0])


@pytest.mark.parametrize("kernel", [None, (0.01, 0.02, 0)])
@pytest.mark.parametrize("facets", ["Triangles", "Polygons"])
def test_surfaces(kernel, facets):
    surface = pv.Sphere(theta_resolution=20, phi_resolution=20).triangulate()
    surface.points *= 1 + 0.2 * np.random.default_rng(2).random((surface.n_points, 1))
    surface = with_data(surface)
    algorithm = vtkFFConvexifyFilter()
    algorithm.SetFacetMode(getattr(algorithm, f"FACETS_AS_{facets.upper()}"))
    if kernel:
        algorithm.SetKernelPoint(*kernel)
    quads = with_data(pv.Cube().clean())
    stripped = pv.Sphere(theta_resolution=12, phi_resolution=9).strip()
    assert quads.faces[0] == 4 and stripped.n_strips
    for mesh in (surface, pv.PolyData(), pv.MultiBlock({"a": surface, "b": None}), quads, stripped):
        (expected,) = outputs_of(algorithm, mesh)
        expect_same(convexify(mesh, kernel, facets=facets.lower()), expected)


def test_the_filters_are_the_real_ones():
    assert issubclass(vtkFFHullFilter, vtkFFAlgorithm)
