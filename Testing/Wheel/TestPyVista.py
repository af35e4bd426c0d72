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
    with pytest.raises(TypeError, match="vtkFFHullFilter has no property facets; it has .*, facet_mode, .*, v_biased"):
        convex_hull(cloud(), facets=1)
    for name in ("abort_execute", "facet_mode_to_polygons", "engine_to"):
        with pytest.raises(TypeError, match=f"no property {name}"):
            convex_hull(cloud(), **{name: True})


CHOICES = {
    "engine": '"automatic", "cpu" or "cuda"',
    "facet_mode": '"polygons" or "triangles"',
    "non_finite_points": '"error" or "ignore"',
    "composite_mode": '"all_blocks" or "each_block"',
    "projection_plane_mode": '"best_fitting_plane", "transform" or "xy_plane"',
    "power_diagram_box_mode": '"bounds" or "points"',
}


@pytest.mark.parametrize("name", CHOICES)
def test_an_unknown_choice_lists_the_choices(name):
    function = regular_triangulation if name.startswith("p") else convex_hull
    for value in ("poly", "", -1, 7, 2**40, 0.5, None, [0]):
        with pytest.raises(ValueError, match=f"^{name} is {CHOICES[name]}, not ") as raised:
            function(cloud(), **{name: value})
        assert str(raised.value).endswith(repr(value))


def test_choices_by_name_and_number():
    for value in ("polygons", "Polygons", 1, np.int64(1), vtkFFHullFilter.FACETS_AS_POLYGONS):
        assert convex_hull(pv.Cube(), facet_mode=value).n_cells == 6
    flat = regular_triangulation(cloud(), projection_plane_mode="xy_plane")
    assert np.array_equal(flat.faces, regular_triangulation(cloud()).faces)


@pytest.mark.parametrize(
    ("name", "values"),
    [
        ("number_of_threads", (-1, -(2**31), 2**31, 2**70, 1.5, "four", None, [1])),
        ("cuda_threshold", (-1, 2**70, "none")),
        ("pass_point_data", ("yes", 2, -1, None, [])),
        ("v_biased", ("yes", 2, 0.5)),
        ("report_as_field_data", ("no", None)),
        ("visible_point_ids", ("no", None)),
        ("progress_bar", ("no", 2, None)),
    ],
)
def test_a_value_out_of_range_is_refused(name, values):
    for value in values:
        for function in (convex_hull, convexify, regular_triangulation, power_diagram):
            with pytest.raises(ValueError, match=f"^{name} (cannot be|is True or False, not) ") as raised:
                function(pv.Cube().triangulate(), **{name: value})
            assert repr(value) in str(raised.value)


def test_other_values_out_of_range():
    for value in ((1, 2), "origin", (0, 0, np.nan), None):
        with pytest.raises(ValueError, match="^kernel_point cannot be "):
            convexify(pv.Cube().triangulate(), kernel_point=value)
    for value in ((0, 1, 0), "all"):
        with pytest.raises(ValueError, match="^power_diagram_bounds cannot be "):
            power_diagram(cloud(), power_diagram_bounds=value)
    with pytest.raises(ValueError, match="^transform cannot be "):
        regular_triangulation(cloud(), transform=np.eye(4))
    with pytest.raises(ValueError, match="^return_hidden_points is True or False, not 'no'"):
        regular_triangulation(cloud(), return_hidden_points="no")
    with pytest.raises(ValueError, match="^power_diagram.. generates a power diagram"):
        power_diagram(cloud(), generate_power_diagram=False)


def test_values_in_range_are_taken():
    hull = convex_hull(
        cloud(), number_of_threads=np.int32(2), pass_point_data=0, v_biased=np.True_, cuda_threshold=10**12
    )
    assert "heat" not in hull.point_data
    assert np.array_equal(hull.faces, convex_hull(cloud()).faces)
    surface = pv.Cube().triangulate()
    for point in ((0.1, 0, 0), [0.1, 0, 0], np.array([0.1, 0, 0])):
        assert convexify(surface, kernel_point=point, use_kernel_point=True).n_points == 8
    cells = power_diagram(
        cloud(), generate_power_diagram=True, power_diagram_box_mode="bounds", power_diagram_bounds=(-1, 2, -1, 2)
    )
    assert cells.area == pytest.approx(9)


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
