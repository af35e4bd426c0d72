# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.pyvista: meshes in, meshes out, errors as exceptions."""

import subprocess
import sys

import numpy as np
import pytest
import pyvista as pv
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet,
    vtkPartitionedDataSetCollection,
    vtkPolyData,
    vtkTable,
)

from vtkflipflop import vtkFFHullFilter
from vtkflipflop.pyvista import (
    FilterError,
    convex_hull,
    convexify,
    power_diagram,
    regular_triangulation,
)


def random_points(count, seed=7):
    return np.random.default_rng(seed).random((count, 3))


def cloud(count=500):
    mesh = pv.PolyData(random_points(count))
    mesh.point_data["heat"] = np.arange(count, dtype=np.float32)
    return mesh


def planes_of(hull):
    """A point and an outward normal for each triangle."""
    corners = hull.points[hull.faces.reshape(-1, 4)[:, 1:]]
    return corners[:, 0], np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def plain(mesh):
    """The same as VTK's own class."""
    data = vtkPolyData()
    data.ShallowCopy(mesh)
    return data


def test_hull_is_closed_and_holds_the_points():
    mesh = cloud()
    hull = convex_hull(mesh)
    assert type(hull) is pv.PolyData
    assert hull.is_manifold
    assert hull.n_cells == 2 * hull.n_points - 4
    origins, normals = planes_of(hull)
    # The filter is exact; this check is rounded.
    heights = np.einsum("fpc,fc->fp", mesh.points[None] - origins[:, None], normals)
    assert heights.max() < 1e-12


def test_data_and_ids_come_along():
    mesh = cloud()
    hull = convex_hull(mesh)
    ids = hull.point_data["vtkOriginalPointIds"]
    assert np.array_equal(hull.point_data["heat"], mesh.point_data["heat"][ids])
    assert hull.point_data["heat"].dtype == np.float32
    assert np.array_equal(hull.points, mesh.points[ids])


def test_same_as_the_filter_itself():
    mesh = cloud()
    algorithm = vtkFFHullFilter()
    algorithm.SetInputData(mesh)
    algorithm.SetFacetModeToPolygons()
    algorithm.Update()
    expected = pv.wrap(algorithm.GetOutput())
    hull = convex_hull(mesh, facet_mode="polygons")
    assert np.array_equal(hull.faces, expected.faces)
    assert np.array_equal(hull.points, expected.points)


def test_output_outlives_what_made_it():
    hull = convex_hull(random_points(100))
    before = hull.points.copy()
    convex_hull(random_points(100, seed=8))
    assert np.array_equal(hull.points, before)


def test_facets_of_a_box():
    assert convex_hull(pv.Cube(), facet_mode="polygons").n_cells == 6


@pytest.mark.parametrize("kind", ["array", "vtk", "unstructured"])
def test_whatever_pyvista_wraps(kind):
    points = random_points(200)
    mesh = {
        "array": lambda: points,
        "vtk": lambda: plain(pv.PolyData(points)),
        "unstructured": lambda: pv.PolyData(points).cast_to_unstructured_grid(),
    }[kind]()
    assert np.array_equal(convex_hull(mesh).points, convex_hull(pv.PolyData(points)).points)


def test_grids_whose_points_are_implied():
    grid = pv.ImageData(dimensions=(4, 5, 6))
    grid.point_data["heat"] = np.arange(grid.n_points)
    axes = [np.arange(size) ** 1.5 for size in (4, 5, 6)]
    for mesh in (grid, pv.RectilinearGrid(*axes), pv.MultiBlock({"inner": pv.MultiBlock([grid])})):
        hull = convex_hull(mesh, facet_mode="polygons")
        if isinstance(hull, pv.MultiBlock):
            assert hull.keys() == mesh.keys()
            hull = hull[0][0]
            assert sorted(hull.point_data["heat"]) == sorted(hull.point_data["vtkOriginalPointIds"])
        assert (hull.n_points, hull.n_cells) == (8, 6)


def test_blocks():
    blocks = pv.MultiBlock([pv.Sphere(), pv.Cube(center=(3, 0, 0))])
    each = convex_hull(blocks)
    assert isinstance(each, pv.MultiBlock)
    assert [block.n_points for block in each] == [pv.Sphere().n_points, 8]
    one = convex_hull(blocks, composite_mode="all_blocks")
    assert type(one) is pv.PolyData
    assert one.bounds == blocks.bounds


def test_weights_by_name_and_by_value():
    mesh = cloud()
    mesh.point_data["w"] = np.random.default_rng(3).random(mesh.n_points) * 0.02
    triangulation, hidden = regular_triangulation(mesh, "w", return_hidden_points=True)
    assert hidden.n_points > 0
    assert triangulation.n_points + hidden.n_points == mesh.n_points
    other = regular_triangulation(mesh, mesh.point_data["w"])
    assert np.array_equal(triangulation.faces, other.faces)
    assert "weights" not in mesh.point_data
    assert regular_triangulation(mesh).n_points == mesh.n_points


def test_flat_arrays_and_cells_fill_the_box():
    places = np.random.default_rng(5).random((300, 2))
    assert regular_triangulation(places).n_points == 300
    cells = power_diagram(places)
    assert cells.n_cells == 300
    sizes = cells.bounds
    assert cells.area == pytest.approx((sizes[1] - sizes[0]) * (sizes[3] - sizes[2]))


def test_convexify():
    surface = pv.Sphere(theta_resolution=20, phi_resolution=20).triangulate()
    surface.points *= 1 + 0.2 * np.random.default_rng(2).random((surface.n_points, 1))
    hull = convexify(surface)
    assert np.array_equal(hull.points, convex_hull(surface).points)


def test_errors_are_exceptions_with_the_filter_s_words():
    points = random_points(10)
    points[3, 1] = np.nan
    with pytest.raises(FilterError, match=r"^A coordinate is NaN or infinite: first at point 3"):
        convex_hull(points)
    assert convex_hull(points, non_finite_points="ignore").n_points > 0
    with pytest.raises(FilterError, match='"nowhere" is missing'):
        regular_triangulation(cloud(), "nowhere")


def test_what_has_no_points_is_refused():
    table = pv.Table(np.zeros((3, 3)))
    for function in (convex_hull, convexify, regular_triangulation, power_diagram):
        with pytest.raises(FilterError, match="^Table has no points to take"):
            function(table)
        with pytest.raises(FilterError, match="^NoneType has no points to take"):
            function(None)
    with pytest.raises(FilterError, match="flat index 1 is a vtkTable"):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, vtkTable())
        convex_hull(blocks)
    with pytest.raises(FilterError, match="^ImageData is no surface"):
        convexify(pv.ImageData(dimensions=(2, 2, 2)))


def test_integers_are_not_rounded():
    grid = np.array([[20_000_000 + i, j] for i in range(8) for j in range(8)])
    triangulation, hidden = regular_triangulation(grid, return_hidden_points=True)
    assert (triangulation.n_points, hidden.n_points) == (64, 0)
    assert triangulation.points[:, 0].max() == 20_000_007
    with pytest.raises(FilterError, match="64-bit integer that no double holds: first at point 0"):
        convex_hull(np.array([[2**53 + 1, 0, 0], [0, 1, 0]]))


def test_weights_leave_arrays_alone():
    mesh = cloud(30)
    mesh.point_data["weights"] = np.arange(30)
    triangulation = regular_triangulation(mesh, np.zeros(30))
    assert set(triangulation.point_data.keys()) == {"heat", "weights", "vtkOriginalPointIds"}
    assert np.array_equal(triangulation["weights"], triangulation["vtkOriginalPointIds"])
    assert "weights" not in power_diagram(cloud(30), np.zeros(30)).cell_data
    with pytest.raises(TypeError, match="the name of a point array"):
        regular_triangulation(pv.MultiBlock([cloud(30)]), np.zeros(30))
    with pytest.raises(FilterError, match="29 value"):
        regular_triangulation(cloud(30), np.zeros(29))


def test_other_composites():
    partitions = pv.PartitionedDataSet([pv.ImageData(dimensions=(2, 2, 2)), pv.Cube(center=(3, 0, 0))])
    assert convex_hull(partitions, composite_mode="all_blocks", facet_mode="polygons").n_points > 0
    collection = vtkPartitionedDataSetCollection()
    collection.SetPartitionedDataSet(0, partitions)
    assert convex_hull(collection).GetNumberOfPartitionedDataSets() == 1
    blocks = pv.MultiBlock([pv.Cube()])
    blocks.field_data["kept"] = [7]
    assert list(convex_hull(blocks).field_data["kept"]) == [7]


def test_errors_are_exceptions_where_vtk_tells_none():
    vtkObject.GlobalWarningDisplayOff()
    try:
        with pytest.raises(FilterError, match="GlobalWarningDisplayOff"):
            convex_hull(np.full((4, 3), np.nan))
        with pytest.raises(FilterError, match="no points to take"):
            convex_hull(pv.Table(np.zeros((3, 3))))
        assert convex_hull(random_points(10)).n_points > 0
    finally:
        vtkObject.GlobalWarningDisplayOn()


def test_a_wrong_property_is_named():
    with pytest.raises(TypeError, match="vtkFFHullFilter has no property facets"):
        convex_hull(cloud(), facets=1)
    with pytest.raises(TypeError, match='vtkFFHullFilter has no engine="quantum"'):
        convex_hull(cloud(), engine="quantum")
    with pytest.raises(TypeError, match="no property abort_execute"):
        convex_hull(cloud(), abort_execute=True)


def test_progress_bar(capfd):
    convex_hull(cloud(), progress_bar=True)
    assert "vtkFFHullFilter" in capfd.readouterr().err


def test_methods_of_meshes_without_an_import():
    program = (
        "import sys, pyvista as pv\n"
        "assert 'vtkflipflop' not in sys.modules\n"
        "print(pv.Cube().flipflop.convex_hull(facet_mode='polygons').n_cells)\n"
        "print(pv.MultiBlock([pv.Cube()]).flipflop.convex_hull(composite_mode='all_blocks').n_points)\n"
        "print(pv.Plane().flipflop.regular_triangulation().n_points)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout.split() == ["6", "8", "121"], done.stderr
