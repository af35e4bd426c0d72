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
from pyvista_meshes import cloud, random_points, rotation, starlike
from vtkflipflop.pyvista import (
    FilterError,
    InputError,
    centroidal_cells,
    convex_hull,
    convexify,
    power_diagram,
    prescribed_areas,
    regular_triangulation,
    terrain_mesh,
)

FUNCTIONS = (convex_hull, convexify, regular_triangulation, power_diagram, centroidal_cells, prescribed_areas,
             terrain_mesh)
OF_POINTS = (convex_hull, regular_triangulation, power_diagram)
HAS_ACCESSORS = hasattr(pv, "register_dataset_accessor")


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


def test_same_as_the_arrays():
    mesh = cloud()
    hull = convex_hull(mesh)
    expected = vtkflipflop.arrays.convex_hull(mesh.points)
    assert np.array_equal(hull.point_data["vtkOriginalPointIds"], expected.vertices)
    ids = hull.point_data["vtkOriginalPointIds"]
    assert np.array_equal(ids[hull.faces.reshape(-1, 4)[:, 1:]], expected.simplices)
    assert hull.points.tobytes() == mesh.points[expected.vertices].tobytes()


def test_points_that_span_less():
    assert convex_hull(pv.Cube(), facets="polygons").n_cells == 6
    point = convex_hull([[1, 2, 3], [1, 2, 3]])
    assert (point.n_points, point.n_verts, point.n_cells) == (1, 1, 1)
    line = convex_hull(np.outer(np.arange(5.0), [1, 2, 3]))
    assert (line.n_points, line.n_lines, line.n_cells) == (2, 1, 1)
    for nothing in ([], pv.PolyData(), pv.UnstructuredGrid(), pv.ImageData(), pv.RectilinearGrid()):
        empty = convex_hull(nothing)
        assert (empty.n_points, empty.n_cells) == (0, 0)
        assert "vtkOriginalPointIds" in empty.point_data
    flat = convex_hull(random_points(50)[:, :2], facets="polygons")
    assert flat.n_cells == 1 and not flat.points[:, 2].any()


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
    mesh.point_data["vtkGhostType"] = (np.arange(100) % 3).astype(np.uint8)
    kept = np.arange(0, 100, 3)
    hull, expected = convex_hull(mesh), convex_hull(mesh.points[kept])
    assert np.array_equal(hull.points, expected.points) and np.array_equal(hull.faces, expected.faces)
    assert np.array_equal(hull.point_data["vtkOriginalPointIds"], kept[expected.point_data["vtkOriginalPointIds"]])
    assert regular_triangulation(mesh, skip_ghost_points=False).n_points == 100
    mesh.points[6] = mesh.points[1] = np.nan
    with pytest.raises(InputError, match="first at point 6, 1 such"):
        convex_hull(mesh)


# ---- What is accepted -----------------------------------------------------------------------------------------------


def test_whatever_pyvista_wraps():
    points = random_points(200)
    data = pv.PolyData(points)
    for mesh in (points, points.tolist(), pv.pyvista_ndarray(points), plain(data), data.cast_to_unstructured_grid(),
                 pv.PointSet(points), data.GetPoints(), data.GetPoints().GetData()):  # fmt: skip
        for function in OF_POINTS:
            assert np.array_equal(function(mesh).points, function(data).points)


def test_grids_whose_points_are_implied():
    axes = [np.arange(size) ** 1.5 for size in (4, 5, 6)]
    turned = pv.ImageData(dimensions=(4, 5, 6), spacing=(0.1, 0.7, 1e-3), origin=(1, 1e6, -3))
    turned.SetDirectionMatrix(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6)
    floats = pv.RectilinearGrid(*(axis.astype(np.float32) for axis in axes))
    for grid in (turned.extract_subset((1, 3, 2, 4, 0, 2)), pv.RectilinearGrid(*axes), floats):
        grid.point_data["heat"] = np.arange(grid.n_points)
        hull = convex_hull(grid, facets="polygons")
        ids = np.array(hull.point_data["vtkOriginalPointIds"])
        assert np.array_equal(hull.point_data["heat"], ids)
        # Not grid.points, which in PyVista 0.44 are not turned. VTK's GetPoint() rounds more than the hull.
        assert np.allclose(hull.points, [grid.GetPoint(i) for i in ids], rtol=1e-9)
    assert hull.points.dtype == np.float32 and (hull.n_points, hull.n_cells) == (8, 6)


def test_too_many_points_of_an_image():
    with pytest.raises(InputError, match="more points than 32-bit indices can name"):
        convex_hull(pv.ImageData(dimensions=(2**16, 2**16, 2)))


@pytest.mark.parametrize("kind", "i1 u1 <i2 >i2 >i4 <i8 <f2 <f4 >f8 g".split())
def test_points_keep_their_type(kind):
    """VTK has all but half and longdouble."""
    corners = np.array([[x, y, z] for x in (3, 90) for y in (0, 7) for z in (1, 100)])
    stored = {"<f2": np.float32, "g": np.float64}.get(kind, np.dtype(kind).newbyteorder("="))
    hull = convex_hull(corners.astype(kind))
    assert hull.points.dtype == stored and np.array_equal(hull.points, corners)
    blocks = pv.MultiBlock([pv.PolyData(corners, force_float=False), pv.PolyData(corners.astype(np.float32))])
    assert convex_hull(blocks, composite_mode="all_blocks").points.dtype == np.float64


def test_what_has_no_points_is_refused():
    for thing in (pv.Table(np.zeros((3, 3))), None, "text", b"bytes", 3, {"x": 1}, object()):
        for function in FUNCTIONS:
            with pytest.raises(TypeError, match=f"^{type(thing).__name__} has no points to take"):
                function(thing)
    names = {"IsA": lambda self, name: True, "GetDataObjectType": lambda self: 0, "__module__": "fork.data"}
    with pytest.raises(TypeError, match="^PolyData is of another VTK, the module fork.data"):
        convex_hull(type("PolyData", (), names)())
    blocks = vtk_class(pv.MultiBlock)()
    blocks.SetBlock(0, vtk_class(pv.Table)())
    with pytest.raises(InputError, match="^the block of flat index 1 is of the type (vtk)?Table, which has no points"):
        convex_hull(blocks)
    for no_surface in (pv.ImageData(dimensions=(2, 2, 2)), random_points(9)):
        with pytest.raises(TypeError, match=f"^{type(no_surface).__name__} is no surface"):
            convexify(no_surface)


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


def test_partitions():
    """Each has a hull of its own, as VTK's filters have; one of all counts them as blocks."""
    pieces = [cloud(60), pv.ImageData(dimensions=(2, 2, 2), origin=(0.5, 0.5, 0.5))]
    partitions = pv.PartitionedDataSet(pieces)
    hull = convex_hull(partitions)
    assert type(hull) is pv.PartitionedDataSet and len(hull) == 2
    for found, piece in zip(hull, pieces):
        assert np.array_equal(found.points, convex_hull(piece).points)
    one = convex_hull(partitions, composite_mode="all_blocks")
    assert np.array_equal(one.points, convex_hull(np.vstack([piece.points for piece in pieces])).points)
    assert set(one.point_data["BlockIndex"]) == {1, 2} and "heat" not in one.point_data


def test_composites_that_pyvista_has_no_class_for():
    partitions = pv.PartitionedDataSet([pv.Cube(), pv.Cube(center=(3, 0, 0))])
    kind = vtk_class(pv.PartitionedDataSet)
    # Some of cvista's classes say that they are of vtkmodules.
    module = sys.modules.get(kind.__module__) or sys.modules["cvista" + kind.__module__.removeprefix("vtkmodules")]
    collection = getattr(module, kind.__name__ + "Collection")()
    collection.SetPartitionedDataSet(0, partitions)
    hull = convex_hull(collection)
    assert hull.GetNumberOfPartitionedDataSets() == 1
    assert [hull.GetPartition(0, k).GetNumberOfPoints() for k in range(2)] == [8, 8]
    assert convex_hull(collection, composite_mode="all_blocks").n_points == 8


# ---- Arguments ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("function", FUNCTIONS)
def test_flags_and_numbers(function):
    mesh = cloud() if function is prescribed_areas else starlike()  # which has two sites at one position
    for value in ("yes", 2, -1, None, []):
        with pytest.raises(TypeError, match="^pass_point_data is True or False, not"):
            function(mesh, pass_point_data=value)
    assert function(mesh, pass_point_data=np.False_).n_points > 0
    if function is convexify:
        for kernel, kind in (((1, 2), ValueError), ((0, 0, np.nan), ValueError), ("origin", TypeError)):
            with pytest.raises(kind, match="^kernel is 3 .*numbers, not"):
                convexify(mesh, kernel)


def test_progress(capfd):
    mesh = cloud(200_000)
    for function in (regular_triangulation, power_diagram):
        fractions = []
        function(mesh, progress=fractions.append)
        assert fractions == sorted(fractions) and fractions[-1] > 0.5
        with pytest.raises(vtkflipflop.arrays.AbortedError):
            function(mesh, progress=lambda fraction: False)
    for function in OF_POINTS:
        function(nested(), progress=True)
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
        ("convex_hull", (), {"facets": "polygons", "pass_point_data": False}),
        ("convexify", ((0, 0, 0),), {"facets": "polygons"}),
        ("regular_triangulation", ("w",), {"transform": rotation(), "threads": 1}),
        ("centroidal_cells", ("w",), {"domain": (-1, 1, -1, 1), "iterations": 2}),
        ("prescribed_areas", (None,), {"domain": (-1, 1, -1, 1), "iterations": 2}),
        ("power_diagram", ("w",), {"box": (-1, 1, -1, 1), "non_finite": "ignore"}),
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
        "print(pv.Cube().flipflop.convex_hull(facets='polygons').n_cells)\n"
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
        "convex_hull(pv.Cube())\n"
        "power_diagram(pv.MultiBlock([pv.Plane()]), projection_plane_mode='best_fitting_plane')\n"
        "print(sorted(name for name in roots() - before if name.startswith(('vtk', 'cvista'))))\n"
        "print('vtkflipflop._vtk' in sys.modules)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout.splitlines() == ["['vtkflipflop']", "False"], done.stdout + done.stderr
