# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.pyvista: meshes in, meshes out, errors as exceptions; on whatever VTK PyVista runs."""

import gc
import inspect
import subprocess
import sys
import typing

import numpy as np
import pytest
import pyvista as pv

import vtkflipflop.arrays
import vtkflipflop.pyvista
from vtkflipflop.pyvista import (
    FilterError,
    InputError,
    centroidal_cells,
    convex_hull,
    convexify,
    power_diagram,
    prescribed_areas,
    regular_triangulation,
)

FUNCTIONS = (convex_hull, convexify, regular_triangulation, power_diagram, centroidal_cells, prescribed_areas)
OF_POINTS = (convex_hull, regular_triangulation, power_diagram)
HAS_ACCESSORS = hasattr(pv, "register_dataset_accessor")


def random_points(count, seed=7):
    return np.random.default_rng(seed).random((count, 3))


def cloud(count=500):
    mesh = pv.PolyData(random_points(count))
    mesh.point_data["heat"] = np.arange(count, dtype=np.float32)
    return mesh


def starlike(seed=2):
    surface = pv.Sphere(theta_resolution=20, phi_resolution=20).triangulate()
    surface.points *= 1 + 0.2 * np.random.default_rng(seed).random((surface.n_points, 1))
    return surface


def planes_of(hull):
    """A point and an outward normal for each triangle."""
    corners = hull.points[hull.faces.reshape(-1, 4)[:, 1:]]
    return corners[:, 0], np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def plain(mesh):
    """The same as VTK's own class."""
    data = vtk_class(type(mesh))()
    data.ShallowCopy(mesh)
    return data


def vtk_class(kind):
    """The VTK class below PyVista's."""
    return next(one for one in kind.__mro__ if one.__name__.startswith("vtk") and hasattr(one, "SafeDownCast")
                and "pyvista" not in one.__module__)


# ---- Hulls ----------------------------------------------------------------------------------------------------------


def test_hull_is_closed_and_holds_the_points():
    mesh = cloud()
    hull = convex_hull(mesh)
    assert type(hull) is pv.PolyData
    assert hull.is_manifold
    assert hull.n_cells == 2 * hull.n_points - 4
    origins, normals = planes_of(hull)
    # The result is exact; this check is rounded.
    heights = np.einsum("fpc,fc->fp", mesh.points[None] - origins[:, None], normals)
    assert heights.max() < 1e-12


def test_same_as_the_arrays():
    mesh = cloud()
    hull = convex_hull(mesh)
    expected = vtkflipflop.arrays.convex_hull(mesh.points)
    assert np.array_equal(hull.point_data["vtkOriginalPointIds"], expected.vertices)
    ids = hull.point_data["vtkOriginalPointIds"]
    assert np.array_equal(ids[hull.faces.reshape(-1, 4)[:, 1:]], expected.simplices)
    assert hull.points.tobytes() == mesh.points[expected.vertices].tobytes()


def test_output_outlives_what_made_it():
    hull = convex_hull(random_points(100))
    points, faces = hull.points.copy(), hull.faces.copy()
    gc.collect()
    for seed in range(20):
        convex_hull(random_points(100, seed))
    assert np.array_equal(hull.points, points)
    assert np.array_equal(hull.faces, faces)
    moved = hull.copy()
    moved.points += 1  # it can be changed, too
    assert np.array_equal(hull.points, points)


def test_facets_of_a_box():
    assert convex_hull(pv.Cube()).n_cells == 12
    assert convex_hull(pv.Cube(), facet_mode="polygons").n_cells == 6


def test_points_that_span_less():
    point = convex_hull([[1, 2, 3], [1, 2, 3]])
    assert (point.n_points, point.n_verts, point.n_cells) == (1, 1, 1)
    line = convex_hull(np.outer(np.arange(5.0), [1, 2, 3]))
    assert (line.n_points, line.n_lines, line.n_cells) == (2, 1, 1)
    flat = convex_hull(pv.Plane(), facet_mode="polygons")
    assert (flat.n_points, flat.n_cells, flat.faces[0]) == (4, 1, 4)
    assert convex_hull(pv.Plane()).n_cells == 2
    for nothing in ([], pv.PolyData(), pv.UnstructuredGrid()):
        empty = convex_hull(nothing)
        assert (empty.n_points, empty.n_cells) == (0, 0)
        assert "vtkOriginalPointIds" in empty.point_data


def test_rows_of_two_lie_at_zero():
    hull = convex_hull(random_points(50)[:, :2], facet_mode="polygons")
    assert hull.n_cells == 1
    assert not hull.points[:, 2].any()


# ---- Data that comes along ------------------------------------------------------------------------------------------


def test_data_and_ids_come_along():
    mesh = cloud()
    hull = convex_hull(mesh)
    ids = hull.point_data["vtkOriginalPointIds"]
    assert np.array_equal(hull.point_data["heat"], mesh.point_data["heat"][ids])
    assert hull.point_data["heat"].dtype == np.float32
    assert np.array_equal(hull.points, mesh.points[ids])
    assert hull.active_scalars_name == "heat"
    assert "heat" not in convex_hull(mesh, pass_point_data=False).point_data


def test_every_type_of_data():
    mesh = pv.PolyData(random_points(80))
    values = {
        "flag": np.arange(80) % 3 == 0,
        "flags": (np.arange(240) % 3 == 0).reshape(80, 3),
        "wave": np.arange(80) * (1 + 2j),
        "name": np.array([f"point {i}" for i in range(80)]),
        "wide": 2**62 + np.arange(80),
        "vector": random_points(80, 3),
        "tensor": random_points(240, 4).reshape(80, 9),
    }
    values |= {kind: np.arange(80).astype(kind) for kind in "i1 u1 i2 u2 i4 u4 u8 f4 f8".split()}
    for name, array in values.items():
        mesh.point_data[name] = array
    shown, hidden = regular_triangulation(mesh, np.arange(80) % 7 / 50, return_hidden_points=True)
    assert hidden.n_points > 0
    for output in (convex_hull(mesh), shown, hidden):
        ids = np.array(output.point_data["vtkOriginalPointIds"])
        for name, array in values.items():
            found = output.point_data[name]
            assert found.dtype.kind == array.dtype.kind, name
            assert found.dtype == array.dtype or array.dtype.kind == "U"
            assert np.array_equal(found, array[ids]), name
    cells = power_diagram(mesh)
    assert np.array_equal(cells.cell_data["flag"], values["flag"][cells.cell_data["vtkOriginalPointIds"]])
    assert np.array_equal(cells.cell_data["name"], values["name"][cells.cell_data["vtkOriginalPointIds"]])


def test_arrays_of_another_layout_and_names_of_components():
    mesh = pv.PolyData(random_points(20))
    core = next(kind.__module__ for kind in pv.PolyData.__mro__ if kind.__name__ == "vtkObject")
    soa = sys.modules[core].vtkSOADataArrayTemplate["float64"]()
    soa.SetName("soa")
    soa.SetNumberOfComponents(2)
    soa.SetNumberOfTuples(20)
    for i in range(20):
        soa.SetTuple2(i, i, -i)
    soa.SetComponentName(1, "minus")
    mesh.GetPointData().AddArray(soa)
    hull = convex_hull(mesh)
    ids = hull.point_data["vtkOriginalPointIds"]
    assert np.array_equal(hull.point_data["soa"], np.column_stack([ids, -ids]))
    assert hull.GetPointData().GetArray("soa").GetComponentName(1) == "minus"


def test_what_is_active_stays_so_but_for_normals():
    sphere = pv.Sphere().compute_normals()
    sphere.point_data["v"] = sphere.points * 2
    sphere.point_data.active_vectors_name = "v"
    sphere.point_data["s"] = sphere.points[:, 2]
    sphere.point_data.active_scalars_name = "s"
    hull = convex_hull(sphere)
    assert hull.point_data.active_scalars_name == "s"
    assert hull.point_data.active_vectors_name == "v"
    assert "Normals" in hull.point_data
    assert hull.GetPointData().GetNormals() is None


def test_field_data_come_along():
    mesh = cloud(30)
    mesh.field_data["source"] = ["scan 7"]
    mesh.field_data["FlipFlopVolume"] = [1.0]
    blocks = pv.MultiBlock({"a": mesh})
    blocks.field_data["kept"] = [7]
    for function in OF_POINTS:
        output = function(mesh)
        assert list(output.field_data["source"]) == ["scan 7"]
        assert "FlipFlopVolume" not in output.field_data
        composite = function(blocks)
        assert list(composite.field_data["kept"]) == [7]
        assert list(composite["a"].field_data["source"]) == ["scan 7"]


def test_ghost_points_are_left_out():
    mesh = cloud(100)
    marks = np.zeros(100, np.uint8)
    marks[::3] = 1
    marks[1::3] = 2
    mesh.point_data["vtkGhostType"] = marks
    left = np.flatnonzero(marks == 0)
    hull = convex_hull(mesh)
    expected = convex_hull(mesh.points[left])
    assert np.array_equal(hull.points, expected.points)
    assert np.array_equal(hull.faces, expected.faces)
    assert np.array_equal(hull.point_data["vtkOriginalPointIds"], left[expected.point_data["vtkOriginalPointIds"]])
    shown = regular_triangulation(mesh, "heat")
    assert np.array_equal(shown.faces, regular_triangulation(mesh.points[left], mesh["heat"][left]).faces)
    assert regular_triangulation(mesh, skip_ghost_points=False).n_points == 100
    cells = power_diagram(mesh, skip_ghost_points=False)
    assert set(cells.cell_data["vtkGhostType"]) == {0, 1, 32}
    mesh.points[5] = mesh.points[2] = np.nan
    with pytest.raises(InputError, match="first at point 2, 2 such") as raised:
        convex_hull(mesh)
    assert raised.value.index == 2


# ---- What is accepted -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["array", "list", "vtk", "unstructured", "set"])
def test_whatever_pyvista_wraps(kind):
    points = random_points(200)
    mesh = {
        "array": lambda: points,
        "list": lambda: points.tolist(),
        "vtk": lambda: plain(pv.PolyData(points)),
        "unstructured": lambda: pv.PolyData(points).cast_to_unstructured_grid(),
        "set": lambda: pv.PointSet(points),
    }[kind]()
    for function in OF_POINTS:
        assert np.array_equal(function(mesh).points, function(pv.PolyData(points)).points)


def image():
    grid = pv.ImageData(dimensions=(4, 5, 6), spacing=(0.1, 0.7, 1e-3), origin=(1, 1e6, -3))
    grid.SetDirectionMatrix(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6)
    return grid


def test_grids_whose_points_are_implied():
    axes = [np.arange(size) ** 1.5 for size in (4, 5, 6)]
    grids = {
        "image": pv.ImageData(dimensions=(4, 5, 6), origin=(1, 2, 3), spacing=(0.1, 0.7, 3)),
        "turned": image(),
        "rectilinear": pv.RectilinearGrid(*axes),
        "floats": pv.RectilinearGrid(*(axis.astype(np.float32) for axis in axes)),
        "structured": pv.RectilinearGrid(*axes).cast_to_structured_grid(),
    }
    for name, grid in grids.items():
        grid.point_data["heat"] = np.arange(grid.n_points)
        hull = convex_hull(grid, facet_mode="polygons")
        assert name == "turned" or (hull.n_points, hull.n_cells) == (8, 6)  # turned, it is rounded
        ids = np.array(hull.point_data["vtkOriginalPointIds"])
        assert np.array_equal(hull.point_data["heat"], ids)
        # Not grid.points, which in PyVista 0.44 are not turned. VTK's GetPoint() rounds more than the hull.
        assert np.allclose(hull.points, [grid.GetPoint(i) for i in ids], rtol=1e-9)
    assert convex_hull(grids["floats"]).points.dtype == np.float32
    assert convex_hull(pv.ImageData()).n_points == convex_hull(pv.RectilinearGrid()).n_points == 0


def test_points_of_an_image_are_vtk_s_own():
    for grid in (image(), image().extract_subset((1, 3, 2, 4, 0, 2))):
        found = convex_hull(grid, facet_mode="polygons")
        low = grid.GetExtent()[::2]
        size = grid.GetDimensions()
        for i, point in zip(found.point_data["vtkOriginalPointIds"].tolist(), found.points):
            at = [i % size[0] + low[0], i // size[0] % size[1] + low[1], i // size[0] // size[1] + low[2]]
            place = [0.0, 0.0, 0.0]
            grid.TransformIndexToPhysicalPoint(at, place)
            assert tuple(point) == tuple(place)


def test_too_many_points_of_an_image():
    with pytest.raises(InputError, match="more points than 32-bit indices can name"):
        convex_hull(pv.ImageData(dimensions=(2**16, 2**16, 2)))


def test_integers_are_not_rounded():
    grid = np.array([[20_000_000 + i, j] for i in range(8) for j in range(8)])
    triangulation, hidden = regular_triangulation(grid, return_hidden_points=True)
    assert (triangulation.n_points, hidden.n_points) == (64, 0)
    assert triangulation.points[:, 0].max() == 20_000_007
    space = np.column_stack([grid, grid[:, 0] % 3]).astype(np.int32)
    hull = convex_hull(pv.PolyData(space, force_float=False))
    assert hull.points.dtype == np.int32
    assert np.array_equal(hull.points, space[hull.point_data["vtkOriginalPointIds"]])
    with pytest.raises(InputError, match="no number that a double holds, 9007199254740993: first at point 0"):
        convex_hull(np.array([[2**53 + 1, 0, 0], [0, 1, 0]]))


def test_what_has_no_points_is_refused():
    table = pv.Table(np.zeros((3, 3)))
    for function in FUNCTIONS:
        with pytest.raises(TypeError, match="^Table has no points to take"):
            function(table)
        with pytest.raises(TypeError, match="^NoneType has no points to take"):
            function(None)
    blocks = vtk_class(pv.MultiBlock)()
    blocks.SetBlock(0, vtk_class(pv.Table)())
    with pytest.raises(InputError, match="^the block of flat index 1 is of the type (vtk)?Table, which has no points"):
        convex_hull(blocks)
    with pytest.raises(TypeError, match="^ImageData is no surface"):
        convexify(pv.ImageData(dimensions=(2, 2, 2)))


# ---- Composites -----------------------------------------------------------------------------------------------------


def nested():
    return pv.MultiBlock(
        {
            "ball": pv.Sphere(),
            "none": None,
            "inner": pv.MultiBlock({"cube": pv.Cube(center=(3, 0, 0)), "image": pv.ImageData(dimensions=(3, 3, 3))}),
            "empty": pv.PolyData(),
        }
    )


def test_blocks():
    blocks = nested()
    each = convex_hull(blocks)
    assert type(each) is pv.MultiBlock
    assert each.keys() == blocks.keys()
    assert each["none"] is None
    assert type(each["inner"]) is pv.MultiBlock and each["inner"].keys() == blocks["inner"].keys()
    assert type(each["inner"]["cube"]) is pv.PolyData
    assert each["ball"].n_points == pv.Sphere().n_points
    assert each["inner"]["cube"].n_points == each["inner"]["image"].n_points == 8
    assert each["empty"].n_points == 0
    gc.collect()
    assert np.array_equal(each["inner"]["cube"].points, convex_hull(blocks["inner"]["cube"]).points)


def test_one_hull_of_all_blocks():
    blocks = nested()
    for block in (blocks["ball"], blocks["inner"]["cube"], blocks["inner"]["image"]):
        block.point_data["heat"] = np.arange(block.n_points, dtype=float)
    one = convex_hull(blocks, composite_mode="all_blocks")
    assert type(one) is pv.PolyData
    box = pv.MultiBlock([blocks["ball"], blocks["inner"]["cube"], blocks["inner"]["image"]]).bounds
    assert tuple(one.bounds) == tuple(box)
    ids, flat = np.array(one.point_data["vtkOriginalPointIds"]), np.array(one.point_data["BlockIndex"])
    assert flat.dtype == np.uint32
    starts = {1: 0, 4: blocks["ball"].n_points, 5: blocks["ball"].n_points + blocks["inner"]["cube"].n_points}
    assert set(flat) <= set(starts)
    own = ids - np.array([starts[i] for i in flat.tolist()])
    assert np.array_equal(one.point_data["heat"], own)
    assert convex_hull(pv.MultiBlock(), composite_mode="all_blocks").n_points == 0
    assert "BlockIndex" not in convex_hull(pv.Cube(), composite_mode="all_blocks").point_data


def test_blocks_of_several_types_give_doubles():
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    blocks = pv.MultiBlock([pv.PolyData(corners.astype(np.float32)), pv.PolyData(corners + 5, force_float=False)])
    one = convex_hull(blocks, composite_mode="all_blocks")
    assert one.points.dtype == np.float64
    same = pv.MultiBlock([pv.PolyData(corners, force_float=False), pv.PolyData(corners + 5, force_float=False)])
    assert convex_hull(same, composite_mode="all_blocks").points.dtype == corners.dtype


def test_errors_name_the_block():
    for function in OF_POINTS:
        blocks = nested()
        blocks["inner"]["cube"].points[3, 1] = np.nan
        words = r'first at point 3 of the block "cube" \(flat index 4\), 1 such'
        with pytest.raises(InputError, match=words):
            function(blocks)
    with pytest.raises(InputError, match=words):
        convex_hull(blocks, composite_mode="all_blocks")
    with pytest.raises(InputError, match=r'"w" of the block "ball" \(flat index 1\) is missing'):
        regular_triangulation(blocks, "w")
    surface = starlike()
    surface.points[7] *= -1
    with pytest.raises(InputError, match=r'"spiky" \(flat index 2\)'):
        convexify(pv.MultiBlock({"good": starlike(), "spiky": surface}), (0, 0, 0))


def test_every_function_takes_blocks():
    blocks = pv.MultiBlock({"a": cloud(60), "b": pv.MultiBlock([cloud(40)])})
    shown, hidden = regular_triangulation(blocks, "heat", return_hidden_points=True)
    for one, other, mesh in ((shown["a"], hidden["a"], cloud(60)), (shown["b"][0], hidden["b"][0], cloud(40))):
        assert one.n_points + other.n_points == mesh.n_points
        assert np.array_equal(one.faces, regular_triangulation(mesh, "heat").faces)
    assert power_diagram(blocks)["b"][0].n_cells == 40
    surfaces = pv.MultiBlock({"a": starlike(), "b": None})
    assert np.array_equal(convexify(surfaces)["a"].faces, convex_hull(starlike()).faces)


def test_partitions_are_pieces_of_one_data_set():
    pieces = [cloud(60), pv.ImageData(dimensions=(2, 2, 2))]
    partitions = pv.PartitionedDataSet(pieces)
    hull = convex_hull(partitions)
    assert type(hull) is pv.PartitionedDataSet and len(hull) == 1
    points = np.vstack([piece.points for piece in pieces])
    assert np.array_equal(hull[0].points, convex_hull(points).points)
    one = convex_hull(partitions, composite_mode="all_blocks")
    assert np.array_equal(one.points, hull[0].points)
    assert "BlockIndex" not in one.point_data and "heat" not in one.point_data


def test_composites_that_pyvista_has_no_class_for():
    partitions = pv.PartitionedDataSet([pv.Cube(), pv.Cube(center=(3, 0, 0))])
    kind = vtk_class(pv.PartitionedDataSet)
    # Some of cvista's classes say that they are of vtkmodules.
    module = sys.modules.get(kind.__module__) or sys.modules["cvista" + kind.__module__.removeprefix("vtkmodules")]
    collection = getattr(module, kind.__name__ + "Collection")()
    collection.SetPartitionedDataSet(0, partitions)
    hull = convex_hull(collection)
    assert hull.GetNumberOfPartitionedDataSets() == 1
    assert hull.GetPartition(0, 0).GetNumberOfPoints() == 8
    assert convex_hull(collection, composite_mode="all_blocks").n_points == 8


# ---- Triangulations and diagrams ------------------------------------------------------------------------------------


def test_weights_by_name_and_by_value():
    mesh = cloud()
    mesh.point_data["w"] = np.random.default_rng(3).random(mesh.n_points) * 0.02
    triangulation, hidden = regular_triangulation(mesh, "w", return_hidden_points=True)
    assert hidden.n_points > 0
    assert triangulation.n_points + hidden.n_points == mesh.n_points
    assert hidden.n_verts == hidden.n_cells == hidden.n_points
    assert np.array_equal(hidden.point_data["w"], mesh["w"][hidden.point_data["vtkOriginalPointIds"]])
    other = regular_triangulation(mesh, mesh.point_data["w"])
    assert np.array_equal(triangulation.faces, other.faces)
    assert set(mesh.point_data.keys()) == {"heat", "w"}
    assert set(other.point_data.keys()) == {"heat", "w", "vtkOriginalPointIds"}
    assert regular_triangulation(mesh).n_points == mesh.n_points


def test_diagrams_lie_at_the_lowest_point():
    points = np.array([[0, 0, 7], [4, 0, 5.1], [0, 4, 9], [0, 0, -3], [1, 1, -np.inf], [np.nan, 0, -8]])
    heights = power_diagram(points[:3]).points[:, 2]
    assert len(heights) and (heights == 5.1).all()
    assert (power_diagram(points[:4]).points[:, 2] == -3).all()  # a duplicate, which is hidden
    assert (power_diagram(points, non_finite_points="ignore").points[:, 2] == -3).all()
    assert (power_diagram(points[:3, :2]).points[:, 2] == 0).all()
    mesh = pv.PolyData(points[:4])
    mesh.point_data["vtkGhostType"] = np.array([0, 0, 0, 1], np.uint8)
    both = pv.MultiBlock({"a": mesh, "b": pv.PolyData(points[:4] + 1)})
    found = power_diagram(both)
    assert (found["a"].points[:, 2] == 5.1).all() and (found["b"].points[:, 2] == -2).all()
    negative = power_diagram(points[:3] * [1, 1, -0.0]).points[:, 2]
    assert not np.signbit(negative).any()


def test_radii_and_factors():
    mesh = cloud(400)
    mesh.point_data["r"] = np.abs(np.sin(np.arange(400))) * 0.05
    radii = np.asarray(mesh.point_data["r"])
    expected = regular_triangulation(mesh, radii * radii, return_hidden_points=True)
    assert expected[1].n_points > 0
    for found in (
        regular_triangulation(mesh, radii="r", return_hidden_points=True),
        regular_triangulation(mesh, radii=radii.tolist(), return_hidden_points=True),
        regular_triangulation(mesh, radii=8 * radii, weight_factor=0.125, return_hidden_points=True),
        mesh.flipflop.regular_triangulation(radii="r", weight_factor=-1, return_hidden_points=True)
        if hasattr(mesh, "flipflop") else expected,
    ):
        for one, other in zip(found, expected):
            np.testing.assert_array_equal(one.points, other.points)
            np.testing.assert_array_equal(one["vtkOriginalPointIds"], other["vtkOriginalPointIds"])
    cells = power_diagram(mesh, radii="r", weight_factor=1.5)
    np.testing.assert_array_equal(cells.points, power_diagram(mesh, (1.5 * radii) * (1.5 * radii)).points)
    np.testing.assert_array_equal(
        power_diagram(mesh, "r", weight_factor=0.1).points, power_diagram(mesh, 0.1 * radii).points
    )
    # float32 is squared in double
    narrow = radii.astype(np.float32)
    np.testing.assert_array_equal(
        regular_triangulation(mesh, radii=narrow).faces, regular_triangulation(mesh, narrow.astype(float) ** 2).faces
    )
    assert regular_triangulation(pv.PolyData(), radii="absent").n_points == 0


def test_radii_that_cannot_be_used():
    mesh = cloud(30)
    with pytest.raises(ValueError, match="weights or radii, not both"):
        regular_triangulation(mesh, np.ones(30), radii=np.ones(30))
    radii = np.ones(30)
    radii[[7, 9]] = -1
    with pytest.raises(InputError, match="a radius is negative: first at point 7, 2 such") as error:
        regular_triangulation(mesh, radii=radii)
    assert (error.value.index, error.value.count) == (7, 2)
    mesh.point_data["vtkGhostType"] = (np.arange(30) < 8).astype(np.uint8)
    with pytest.raises(InputError, match="a radius is negative: first at point 9, 1 such"):
        power_diagram(mesh, radii=radii)
    radii[9] = 1e200
    with pytest.raises(InputError, match="the square of a radius, times weight_factor, .* first at point 9"):
        regular_triangulation(mesh, radii=radii)
    with pytest.raises(InputError, match="a weight, times weight_factor, .* first at point 9"):
        regular_triangulation(mesh, radii, weight_factor=1e200)
    radii[9] = -np.inf
    with pytest.raises(InputError, match="NaN or infinite"):
        regular_triangulation(mesh, radii=radii)
    assert regular_triangulation(mesh, radii=radii, non_finite_points="ignore").n_points == 21
    for factor in (np.nan, np.inf):
        with pytest.raises(ValueError, match="weight_factor is a finite number"):
            regular_triangulation(mesh, weight_factor=factor)
    for factor in ("1", None, [1.0]):
        with pytest.raises(TypeError, match="weight_factor is a number"):
            power_diagram(mesh, weight_factor=factor)
    with pytest.raises(TypeError, match="the radii of a composite are the name of a point array"):
        regular_triangulation(pv.MultiBlock({"a": mesh}), radii=radii)


@pytest.mark.parametrize("facets", ["triangles", "polygons"])
def test_long_edges(facets):
    mesh = pv.PolyData(np.array([[0, 0, 0], [1, 0, 9], [1, 1, 0], [0, 1, 0], [3, 0.5, 0]], float))
    whole = regular_triangulation(mesh, facet_mode=facets)
    found = regular_triangulation(mesh, facet_mode=facets, maximum_edge_length=1)
    assert found.n_points == whole.n_points == 5
    assert found.n_cells == (0 if facets == "triangles" else 1)
    found = regular_triangulation(mesh, facet_mode=facets, maximum_edge_length=2)
    assert found.n_cells == whole.n_cells - 1
    assert regular_triangulation(mesh, facet_mode=facets, maximum_edge_length=np.inf).n_cells == whole.n_cells
    for limit in (-1, np.nan):
        with pytest.raises(ValueError, match="maximum_edge_length is a length of 0 or more"):
            regular_triangulation(mesh, maximum_edge_length=limit)
    with pytest.raises(TypeError, match="maximum_edge_length is a number"):
        regular_triangulation(mesh, maximum_edge_length="1")


SQUARE = np.array([[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0], [1, 1, 0], [2, 1, 0], [2, 2, 0], [1, 2, 0]], float)


def test_constraints():
    mesh = pv.PolyData(SQUARE)
    rings = pv.PolyData(SQUARE, faces=[4, 0, 1, 2, 3, 4, 7, 6, 5, 4])
    found = regular_triangulation(mesh, constraints=rings)
    assert found.n_points == 8
    assert found.area == 8
    edge = regular_triangulation(mesh, constraints=pv.PolyData(SQUARE, lines=[2, 0, 2]))
    assert any({4, 0} <= set(cell) for cell in edge.regular_faces)
    assert (edge.regular_faces == regular_triangulation(mesh, constraints=[[0, 2], [2, 0]]).regular_faces).all()
    assert regular_triangulation(mesh, constraints=pv.PolyData()).n_cells == regular_triangulation(mesh).n_cells
    # Ghosts are left out, and ids are those of the mesh.
    ghosts = mesh.copy()
    ghosts.point_data["vtkGhostType"] = np.array([0, 0, 0, 0, 1, 0, 0, 0], np.uint8)
    found = regular_triangulation(ghosts, constraints=[[5, 7]])
    ids = found["vtkOriginalPointIds"]
    assert any({5, 7} <= set(ids[cell]) for cell in found.regular_faces)
    with pytest.raises(InputError, match="constraint 1 ends at point 4, which is not there or is left out"):
        regular_triangulation(ghosts, constraints=[[5, 7], [4, 6]])
    with pytest.raises(InputError, match="from point 5, to point 6"):
        regular_triangulation(ghosts, constraints=pv.PolyData(SQUARE, faces=[3, 5, 7, 6, 3, 0, 5, 7]))


def test_constraints_that_cannot_be_used():
    mesh = pv.PolyData(SQUARE)
    with pytest.raises(InputError, match="constraint 1, and constraint 0"):
        regular_triangulation(mesh, constraints=[[4, 6], [5, 7]])
    with pytest.raises(InputError, match="constraint 0, point 8"):
        regular_triangulation(mesh, constraints=[[4, 8]])
    with pytest.raises(ValueError, match="constraints take no weights"):
        regular_triangulation(mesh, np.zeros(8), constraints=[[4, 6]])
    with pytest.raises(ValueError, match="constraints are the CPU's"):
        regular_triangulation(mesh, constraints=[[4, 6]], engine="cuda")
    with pytest.raises(TypeError, match="the mesh is a composite"):
        regular_triangulation(pv.MultiBlock([mesh]), constraints=[[4, 6]])
    with pytest.raises(TypeError, match="not a vtkUnstructuredGrid"):
        regular_triangulation(mesh, constraints=mesh.cast_to_unstructured_grid())


def test_alpha():
    mesh = pv.PolyData(np.array([[0, 0, 0], [6, 0, 0], [0, 8, 0], [30, 0, 0], [32, 0, 0]], float))
    found = regular_triangulation(mesh, alpha=5)
    assert found.regular_faces.tolist() == [[0, 1, 2]]
    assert found.n_points == 5
    assert regular_triangulation(mesh, alpha=np.nextafter(5, 0)).n_cells == 0
    assert regular_triangulation(mesh, alpha=5, maximum_edge_length=9).n_cells == 0
    assert regular_triangulation(mesh, alpha=np.inf).n_cells == regular_triangulation(mesh).n_cells
    for alpha in (-1, np.nan):
        with pytest.raises(ValueError, match="alpha is a length of 0 or more"):
            regular_triangulation(mesh, alpha=alpha)


def test_cells_of_prescribed_areas():
    mesh = cloud(40)
    shares = np.arange(1.0, 41)
    domain = [(0, 0), (2, 0), (1, 2)]
    cells = prescribed_areas(mesh, shares, domain=domain)
    assert cells.n_cells == 40
    assert np.allclose(cells["Area"], 2 * shares / shares.sum(), rtol=1e-6)
    assert np.allclose(cells.compute_cell_sizes(length=False, volume=False)["Area"], cells["Area"], rtol=1e-9)
    assert cells.field_data["Converged"][0] == 1
    assert (cells["heat"] == mesh["heat"]).all()
    diagram = power_diagram(mesh, cells["Weight"])
    assert diagram.n_cells <= 40
    mesh.point_data["share"] = shares
    both = prescribed_areas(pv.MultiBlock([mesh]), "share", domain=domain)
    assert (both[0]["Area"] == cells["Area"]).all()
    with pytest.raises(TypeError, match="the areas of a composite are the name of a point array"):
        prescribed_areas(pv.MultiBlock([mesh]), shares)
    with pytest.raises(InputError, match="site"):
        prescribed_areas(mesh, -shares)


def test_centroidal_cells():
    mesh = cloud(30)
    cells = centroidal_cells(mesh, domain=(0, 1, 0, 1), iterations=2000, tolerance=1e-6)
    assert cells.field_data["Converged"][0] == 1
    assert np.isclose(cells["Area"].sum(), 1)
    assert np.abs(cells["Site"] - cells["Centroid"]).max() < 1e-5
    assert cells["Centroid"][:, 2].tolist() == [mesh.points[:, 2].min()] * cells.n_cells
    assert centroidal_cells(np.empty((0, 3))).n_cells == 0


def test_weights_that_cannot_be_used():
    mesh = cloud(30)
    mesh.point_data["pairs"] = np.zeros((30, 2))
    mesh.point_data["words"] = ["w"] * 30
    for name, words in {"nowhere": "is missing", "pairs": "has 2 components", "words": ".* does not hold numbers"}.items():
        with pytest.raises(InputError, match=f'the weights\' array "{name}" {words}'):
            regular_triangulation(mesh, name)
    with pytest.raises(InputError, match="is missing"):
        regular_triangulation(mesh.points, "heat")
    with pytest.raises(InputError, match="there are 29 weights, .* 30"):
        regular_triangulation(mesh, np.zeros(29))
    with pytest.raises(TypeError, match="the weights of a composite are the name of a point array"):
        regular_triangulation(pv.MultiBlock([mesh]), np.zeros(30))
    mesh.point_data["w"] = np.where(np.arange(30) == 4, np.nan, 0)
    with pytest.raises(InputError, match="first at point 4, 1 such"):
        regular_triangulation(mesh, "w")
    assert regular_triangulation(mesh, "w", non_finite_points="ignore").n_points == 29


def test_a_z_that_is_not_finite_counts():
    mesh = cloud(30)
    mesh.points[4, 2] = np.inf
    with pytest.raises(InputError, match="first at point 4, 1 such"):
        regular_triangulation(mesh)
    assert regular_triangulation(mesh, non_finite_points="ignore").n_points == 29


def test_flat_arrays_and_cells_fill_the_box():
    places = np.random.default_rng(5).random((300, 2))
    assert regular_triangulation(places).n_points == 300
    cells = power_diagram(places)
    assert cells.n_cells == 300
    sizes = cells.bounds
    assert cells.area == pytest.approx((sizes[1] - sizes[0]) * (sizes[3] - sizes[2]))
    for bounds in ((-1, 2, -1, 2), [-1, 2, -1, 2], np.array([-1, 2, -1, 2])):
        assert power_diagram(places, power_diagram_bounds=bounds).area == pytest.approx(9)
    assert power_diagram([]).n_points == power_diagram([], power_diagram_bounds=(0, 1, 0, 1)).n_points == 0
    assert power_diagram([[1, 2, 0]]).n_cells == 1


def test_points_of_a_tilted_plane():
    plane = pv.Plane(i_resolution=7, j_resolution=5, direction=(1, 2, 3), center=(5, 6, 7))
    shown = regular_triangulation(plane, projection_plane_mode="best_fitting_plane")
    assert (shown.n_points, shown.area) == (48, pytest.approx(1, rel=1e-6))
    assert np.array_equal(shown.points, plane.points)
    cells = power_diagram(plane, projection_plane_mode="best_fitting_plane")
    assert cells.n_cells == 48
    normal = np.array([1, 2, 3]) / 14**0.5
    assert np.allclose((cells.points - plane.center) @ normal, 0, atol=1e-6)


def rotation():
    """Takes y to z, and x to twice itself."""
    return np.array([[2.0, 0, 0, 1], [0, 0, -1, 2], [0, 1, 0, 3], [0, 0, 0, 1]])


class WithMatrix:
    matrix = rotation()


@pytest.mark.parametrize("given", [rotation, WithMatrix, lambda: rotation().tolist(),
                                   lambda: pv.vtkmatrix_from_array(rotation())])
def test_transforms(given):
    mesh = cloud(80)
    places = mesh.points @ rotation()[:3, :3].T + rotation()[:3, 3]
    shown = regular_triangulation(mesh, transform=given())
    assert np.array_equal(shown.faces, regular_triangulation(places).faces)
    assert np.array_equal(shown.points, mesh.points)
    again = regular_triangulation(mesh, transform=given(), projection_plane_mode="transform")
    assert np.array_equal(shown.faces, again.faces)
    cells = power_diagram(mesh, transform=given())
    there = cells.points @ rotation()[:3, :3].T + rotation()[:3, 3]
    assert np.allclose(there[:, 2], 0)
    assert np.allclose(there[:, :2], power_diagram(places).points[:, :2])


def test_transforms_that_cannot_be_used():
    for wrong in (np.eye(3), np.full((4, 4), np.nan)):
        with pytest.raises(ValueError, match="^transform is 4 by 4 finite numbers, not"):
            regular_triangulation(cloud(), transform=wrong)
    with pytest.raises(TypeError, match="^transform is 4 by 4 numbers, not of type str"):
        regular_triangulation(cloud(), transform="turn")
    with pytest.raises(ValueError, match='="transform" needs a transform'):
        regular_triangulation(cloud(), projection_plane_mode="transform")
    with pytest.raises(ValueError, match="takes no transform"):
        regular_triangulation(cloud(), projection_plane_mode="best_fitting_plane", transform=np.eye(4))
    flat = np.diag([1.0, 1, 0, 1])
    assert regular_triangulation(cloud(), transform=flat).n_points == 500
    with pytest.raises(InputError, match="has no inverse"):
        power_diagram(cloud(), transform=flat)


# ---- Surfaces -------------------------------------------------------------------------------------------------------


def test_convexify():
    surface = starlike()
    surface.point_data["heat"] = np.arange(surface.n_points)
    expected = convex_hull(surface)
    for kernel in (None, (0.01, 0, 0), [0, 0, 0], np.zeros(3)):
        hull = convexify(surface, kernel)
        assert np.array_equal(hull.points, expected.points)
        assert np.array_equal(hull.faces, expected.faces)
        assert np.array_equal(hull["heat"], hull["vtkOriginalPointIds"])
    assert convexify(pv.Cube().triangulate().clean(), facet_mode="polygons").n_cells == 6
    assert convexify(pv.PolyData()).n_points == 0


CUBE = np.array([[x, y, z] for z in (0.0, 1) for y in (0.0, 1) for x in (0.0, 1)])
SQUARES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def squares(cells, points=CUBE):
    return pv.PolyData(points, faces=[number for cell in cells for number in (len(cell), *cell)])


def test_surfaces_of_polygons():
    expected = convex_hull(CUBE)
    strips = squares(SQUARES[:2])
    strips.strips = [10, 4, 0, 5, 1, 7, 3, 6, 2, 4, 0]
    for surface in (squares(SQUARES), squares([cell[::-1] for cell in SQUARES]), strips):
        for kernel in (None, (0.5, 0.25, 0.5)):
            hull = convexify(surface, kernel)
            assert np.array_equal(hull.points, expected.points) and np.array_equal(hull.faces, expected.faces)
    with pytest.raises(InputError, match=r"first at cell 1, 2 such triangle") as error:
        convexify(squares(SQUARES), (0.5, 0.5, 2))
    assert (error.value.code, error.value.index) == ("not_star_shaped", 1)
    with pytest.raises(InputError, match=r"first at cell 2, 2 such triangle") as error:
        convexify(strips, (0.5, -2, 0.5))
    # Concave ends: a box with a ditch along its top.
    profile = [[0, 0], [2, 0], [4, 0], [4, 3], [3, 3], [2, 2], [1, 3], [0, 3]]
    points = np.array([[x, y, z] for y in (0.0, 2) for x, z in profile])
    walls = [[i, i + 8, (i + 1) % 8 + 8, (i + 1) % 8] for i in range(8)]
    ditch = squares([list(range(8)), list(range(15, 7, -1)), *walls], points)
    assert np.array_equal(convexify(ditch).faces, convex_hull(points).faces)
    with pytest.raises(InputError, match='first at cell 0 of the block "open"'):
        convexify(pv.MultiBlock({"closed": ditch, "open": squares(SQUARES[:5])}))


def test_surfaces_that_are_none():
    closed = starlike()
    open_one = pv.PolyData(closed.points, closed.faces[: 4 * 50])
    points = pv.PolyData()
    points.SetPoints(pv.vtk_points(random_points(3)))
    with_vertex = starlike()
    with_vertex.verts = [1, 0]
    for words, surface in {
        "the surface has no polygons: its cells are vertices; convex_hull": cloud(5),
        "the surface has no polygons: its cells are lines": pv.Line(),
        "but cell 0 is a vertex cell": with_vertex,
        "cell 1 is a polygon of 2": pv.PolyData(CUBE, faces=[4, 0, 2, 3, 1, 2, 4, 5]),
        "the surface is not closed: first at cell 0, 4 edge": squares(SQUARES[:5]),
        "a polygon crosses or touches itself: first at cell 3, 1 such": squares([*SQUARES[:3], [2, 7, 6, 3]]),
        "corner is out of range or used twice: first at cell 4, 2 such": squares([*SQUARES[:4], [0, 1, 1, 2], [0, 1, 9]]),
        "the surface has no cells, but 3 point": points,
        "the surface is not closed: first at triangle": open_one,
    }.items():
        with pytest.raises(InputError, match=words):
            convexify(surface)


# ---- Arguments ------------------------------------------------------------------------------------------------------


def test_errors_are_the_arrays_own():
    assert FilterError is vtkflipflop.arrays.FlipFlopError
    points = random_points(10)
    points[3, 1] = np.nan
    with pytest.raises(FilterError, match=r"NaN or infinite: first at point 3, 1 such point\(s\) in all") as raised:
        convex_hull(points)
    assert isinstance(raised.value, vtkflipflop.arrays.InputError)
    assert (raised.value.code, raised.value.index, raised.value.count) == ("non_finite", 3, 1)
    assert convex_hull(points, non_finite_points="ignore").n_points > 0


CHOICES = {
    "engine": "'automatic', 'cpu', 'cuda'",
    "facet_mode": "'triangles', 'polygons'",
    "non_finite_points": "'error', 'ignore'",
    "composite_mode": "'each_block', 'all_blocks'",
    "projection_plane_mode": "'xy_plane', 'best_fitting_plane', 'transform'",
}


@pytest.mark.parametrize("name", CHOICES)
def test_an_unknown_choice_lists_the_choices(name):
    function = regular_triangulation if name.startswith("p") else convex_hull
    for kind, values in ((ValueError, ("poly", "", "Polygons")), (TypeError, (-1, 0, 0.5, None, [0], True))):
        for value in values:
            with pytest.raises(kind, match=f"^{name} is one of {CHOICES[name]}, not ") as raised:
                function(cloud(), **{name: value})
            assert str(raised.value).endswith(repr(value))


@pytest.mark.parametrize("function", FUNCTIONS)
def test_other_arguments(function):
    mesh = cloud() if function is prescribed_areas else starlike()  # which has two sites at one place
    for value in (-1, -(2**31), 2**31, 2**70):
        with pytest.raises(ValueError, match="^number_of_threads is 0 .all. or more, not"):
            function(mesh, number_of_threads=value)
    for value in (1.5, "four", None, [1]):
        with pytest.raises(TypeError, match="^number_of_threads is an integer, not"):
            function(mesh, number_of_threads=value)
    assert function(mesh, number_of_threads=np.int8(2)).n_points > 0
    for name in ("pass_point_data", "progress_bar"):
        for value in ("yes", 2, -1, None, []):
            with pytest.raises(TypeError, match=f"^{name} is True or False, not"):
                function(mesh, **{name: value})
        assert function(mesh, **{name: np.False_}).n_points > 0
    with pytest.raises(TypeError, match="unexpected keyword argument 'facets'"):
        function(mesh, facets="triangles")


def test_numbers_out_of_range():
    surface = pv.Cube().triangulate()
    for value in ((1, 2), (0, 0, np.nan)):
        with pytest.raises(ValueError, match="^kernel_point is 3 finite numbers, not"):
            convexify(surface, value)
    with pytest.raises(TypeError, match="^kernel_point is 3 numbers, not 'origin'"):
        convexify(surface, "origin")
    for value in ((0, 1, 0), (0, 1, 0, np.inf)):
        with pytest.raises(ValueError, match="^power_diagram_bounds is 4 finite numbers, not"):
            power_diagram(cloud(), power_diagram_bounds=value)
    with pytest.raises(ValueError, match="^power_diagram_bounds have no inside"):
        power_diagram(cloud(), power_diagram_bounds=(0, 1, 1, 0))


def test_threads_and_engines_change_nothing():
    mesh = cloud(20000)
    expected = convex_hull(mesh)
    for settings in ({"number_of_threads": 1}, {"number_of_threads": 4}, {"engine": "cpu"}):
        assert np.array_equal(convex_hull(mesh, **settings).faces, expected.faces)


def test_progress_bar(capfd):
    for function in OF_POINTS:
        function(nested(), progress_bar=True)
        assert "100%" in capfd.readouterr().err
        function(nested())
        assert not capfd.readouterr().err


# ---- Methods of meshes ----------------------------------------------------------------------------------------------


def test_methods_have_the_functions_arguments():
    for function in FUNCTIONS:
        method = getattr(vtkflipflop.pyvista.Accessor, function.__name__)
        parameters = list(inspect.signature(function).parameters.values())[1:]
        assert list(inspect.signature(method).parameters.values())[1:] == parameters
        assert method.__doc__ == function.__doc__
        for parameter in parameters:
            assert f"{parameter.name}" in function.__doc__
        typing.get_type_hints(function), typing.get_type_hints(method)


@pytest.mark.skipif(not HAS_ACCESSORS, reason="PyVista before 0.48 has no accessors")
def test_methods_do_what_the_functions_do():
    mesh = starlike()
    mesh.point_data["w"] = np.arange(mesh.n_points) / 1e4
    for name, arguments, settings in (
        ("convex_hull", (), {"facet_mode": "polygons", "pass_point_data": False}),
        ("convexify", ((0, 0, 0),), {"facet_mode": "polygons"}),
        ("regular_triangulation", ("w",), {"transform": rotation(), "number_of_threads": 1}),
        ("centroidal_cells", ("w",), {"domain": (-1, 1, -1, 1), "iterations": 2}),
        ("prescribed_areas", (None,), {"domain": (-1, 1, -1, 1), "iterations": 2}),
        ("power_diagram", ("w",), {"power_diagram_bounds": (-1, 1, -1, 1), "non_finite_points": "ignore"}),
    ):
        subject = cloud() if name == "prescribed_areas" else mesh
        expected = getattr(vtkflipflop.pyvista, name)(subject, *arguments, **settings)
        found = getattr(subject.flipflop, name)(*arguments, **settings)
        assert np.array_equal(found.faces, expected.faces)
        assert found.array_names == expected.array_names


@pytest.mark.skipif(not HAS_ACCESSORS, reason="PyVista before 0.48 has no accessors")
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


def test_no_other_vtk_is_loaded():
    """Only what PyVista itself loads: not this package's VTK classes, and no second VTK."""
    program = (
        "import sys, pyvista as pv\n"
        "roots = lambda: {name.split('.')[0] for name in sys.modules}\n"
        "before = roots()\n"
        "from vtkflipflop.pyvista import convex_hull, power_diagram\n"
        "convex_hull(pv.Cube()), power_diagram(pv.MultiBlock([pv.Plane()]), projection_plane_mode='best_fitting_plane')\n"
        "print(sorted(name for name in roots() - before if name.startswith(('vtk', 'cvista'))))\n"
        "print('vtkflipflop._vtk' in sys.modules)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout.splitlines() == ["['vtkflipflop']", "False"], done.stdout + done.stderr
