# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.pyvista in the plane: triangulations with weights, constraints, alpha; diagrams, cells of given areas."""

import numpy as np
import pytest
import pyvista as pv

from pyvista_meshes import cloud, rotation
from vtkflipflop import arrays
from vtkflipflop.pyvista import (
    InputError,
    centroidal_cells,
    constrained_triangulation,
    power_diagram,
    prescribed_areas,
    regular_triangulation,
    terrain_mesh,
    to_image,
)


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
    assert (power_diagram(points, non_finite="ignore").points[:, 2] == -3).all()
    assert (power_diagram(points[:3, :2]).points[:, 2] == 0).all()
    mesh = pv.PolyData(points[:4])
    mesh.point_data["vtkGhostType"] = np.array([0, 0, 0, 1], np.uint8)
    both = pv.MultiBlock({"a": mesh, "b": pv.PolyData(points[:4] + 1)})
    found = power_diagram(both)
    assert (found["a"].points[:, 2] == 5.1).all() and (found["b"].points[:, 2] == -2).all()
    negative = power_diagram(points[:3] * [1, 1, -0.0]).points[:, 2]
    assert not np.signbit(negative).any()


def test_radii_and_factors():
    """By name and by value; TestSameBits compares them with the filters'."""
    mesh = cloud(400)
    mesh.point_data["r"] = np.abs(np.sin(np.arange(400))) * 0.05
    radii = np.asarray(mesh.point_data["r"])
    expected = regular_triangulation(mesh, radii * radii, return_hidden_points=True)
    assert expected[1].n_points > 0
    for given, factor in (("r", 1), (radii.tolist(), 1), (8 * radii, 0.125), ("r", -1)):
        found = regular_triangulation(mesh, radii=given, weight_factor=factor, return_hidden_points=True)
        for one, other in zip(found, expected):
            np.testing.assert_array_equal(one["vtkOriginalPointIds"], other["vtkOriginalPointIds"])
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
    with pytest.raises(InputError, match="the square of a radius, times the factor, .* first at point 9"):
        regular_triangulation(mesh, radii=radii)
    with pytest.raises(InputError, match="a weight, times the factor, .* first at point 9"):
        regular_triangulation(mesh, radii, weight_factor=1e200)
    radii[9] = -np.inf
    with pytest.raises(InputError, match="NaN or infinite"):
        regular_triangulation(mesh, radii=radii)
    assert regular_triangulation(mesh, radii=radii, non_finite="ignore").n_points == 21
    for factor in (np.nan, np.inf):
        with pytest.raises(ValueError, match="weight_factor is a finite number"):
            regular_triangulation(mesh, weight_factor=factor)
    for factor in ("1", None, [1.0]):
        with pytest.raises(TypeError, match="weight_factor is a number"):
            power_diagram(mesh, weight_factor=factor)
    with pytest.raises(TypeError, match="the radii of a composite are the name of a point array"):
        regular_triangulation(pv.MultiBlock({"a": mesh}), radii=radii)


def test_alpha_and_longest_edges():
    mesh = pv.PolyData(np.array([[0, 0, 0], [6, 0, 0], [0, 8, 0], [30, 0, 0], [32, 0, 0]], float))
    for settings in ({"alpha": 5}, {"maximum_edge_length": 10}):
        found = regular_triangulation(mesh, **settings)
        assert found.regular_faces.tolist() == [[0, 1, 2]] and found.n_points == 5
    assert regular_triangulation(mesh, alpha=5, maximum_edge_length=9).n_cells == 0
    for name in ("alpha", "maximum_edge_length"):
        with pytest.raises(ValueError, match=f"{name} is a length"):
            regular_triangulation(mesh, **{name: np.nan})
        with pytest.raises(TypeError, match=f"{name} is a number"):
            regular_triangulation(mesh, **{name: "1"})


SQUARE = np.array([[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0], [1, 1, 0], [2, 1, 0], [2, 2, 0], [1, 2, 0]], float)


def test_constraints():
    mesh = pv.PolyData(SQUARE)
    rings = pv.PolyData(SQUARE, faces=[4, 0, 1, 2, 3, 4, 7, 6, 5, 4])
    found = regular_triangulation(mesh, constraints=rings)
    assert (found.n_points, found.area) == (8, 8)
    edge = regular_triangulation(mesh, constraints=pv.PolyData(SQUARE, lines=[2, 0, 2]))
    assert any({4, 0} <= set(cell) for cell in edge.regular_faces)
    assert (edge.regular_faces == regular_triangulation(mesh, constraints=[[0, 2], [2, 0]]).regular_faces).all()
    assert regular_triangulation(mesh, constraints=pv.PolyData()).n_cells == regular_triangulation(mesh).n_cells
    # Ghosts are left out, and ids are those of the mesh.
    ghosts = mesh.copy()
    ghosts.point_data["vtkGhostType"] = np.array([0, 0, 0, 0, 1, 0, 0, 0], np.uint8)
    found = regular_triangulation(ghosts, constraints=[[5, 7]])
    assert any({5, 7} <= set(found["vtkOriginalPointIds"][cell]) for cell in found.regular_faces)
    with pytest.raises(InputError, match="constraint 1 ends at point 4, which is not there or is left out"):
        regular_triangulation(ghosts, constraints=[[5, 7], [4, 6]])
    both = pv.PolyData(SQUARE, faces=[3, 5, 7, 6, 3, 0, 5, 7])
    with pytest.raises(InputError, match=r"reverse polygons\[0\], which disagrees with polygons\[1\], or pass"):
        regular_triangulation(ghosts, constraints=both, polygon_rule="direction")
    # Clockwise outside: by direction it is a hole, and nothing is left.
    outside = pv.PolyData(SQUARE, faces=[4, 3, 2, 1, 0])
    with pytest.warns(UserWarning, match="no cell is inside the polygons") as caught:
        assert regular_triangulation(mesh, constraints=outside, polygon_rule="direction").n_cells == 0
    assert [warning.filename for warning in caught if warning.category is UserWarning] == [__file__]


def test_constraints_with_points_of_their_own():
    mesh = pv.PolyData(SQUARE)
    lines = [2, 4, 6]
    own = SQUARE.copy()
    own[[0, 5], 0] += 1  # of no line
    own[4, 2] = 7  # left out in the plane
    expected = regular_triangulation(mesh, constraints=[[4, 6]])
    found = regular_triangulation(mesh, constraints=pv.PolyData(own, lines=lines))
    assert np.array_equal(found.regular_faces, expected.regular_faces)
    with pytest.raises(InputError, match="point 4 of constraints is at .*7.0.*, and point 4 of the mesh is at"):
        regular_triangulation(
            mesh, constraints=pv.PolyData(own, lines=lines), projection_plane_mode="best_fitting_plane"
        )
    own[6, 1] = np.nextafter(own[6, 1], 9)
    with pytest.raises(InputError, match="their 8 points must be those of the mesh, of which there are 8") as caught:
        regular_triangulation(mesh, constraints=pv.PolyData(own, lines=lines))
    assert (caught.value.code, caught.value.index, caught.value.count) == ("constraint_point", 0, 6)
    breaklines = pv.PolyData(np.array([[0.5, 0.5, 0], [1.5, 1.5, 0]]), lines=[2, 0, 1])
    with pytest.raises(InputError, match=r"point 0 of constraints is at \(0.5, 0.5, 0.0\)"):
        regular_triangulation(mesh, constraints=breaklines)


def test_closed_lines_are_borders():
    corners = np.array([[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 1, 0], [0, 4.0, 0]])
    sides = pv.PolyData(corners, lines=np.array([[2, i, (i + 1) % 5] for i in range(5)]).ravel())
    disc, square = pv.Polygon(radius=1, n_sides=30), pv.Polygon(n_sides=4, radius=8, fill=False)
    hull = pv.PolyData(corners)
    for lines, area in (
        (sides, 10),
        (sides.strip(join=True), 10),
        (pv.Plane(i_size=4, j_size=3).extract_feature_edges(), 12),
        (pv.Cube(bounds=(0, 2, 0, 3, 0, 4)).triangulate().slice("z"), 6),
        (disc, disc.area),  # a cell, and its outline as a line
        (disc + square, 128 - disc.area),
    ):
        found = constrained_triangulation(lines, lines, closed_lines_as_borders=True)
        assert found.area == pytest.approx(area, rel=1e-6)
    assert constrained_triangulation(hull, sides, closed_lines_as_borders=True, polygon_rule="direction").area == 10
    few = pv.PolyData(corners, lines=[1, 0, 2, 0, 2, 2, 1, 1], faces=[2, 0, 1, 4, 0, 1, 1, 0])
    with pytest.raises(InputError,
                       match=r"cell 0 of lines has 1 point\(s\): a line takes 2 or more; degenerate='ignore'"):
        constrained_triangulation(hull, few)
    both = constrained_triangulation(hull, few, degenerate="ignore")
    assert both.field_data["DegenerateLines"].tolist() == [4] and both.area == 16
    mesh = terrain_mesh(hull, lines=few, degenerate="ignore")
    assert mesh.field_data["DegenerateLines"].tolist() == [4]
    square, chains = pv.PolyData(SQUARE), pv.PolyData(SQUARE, lines=[1, 0, 2, 0, 2], faces=[2, 0, 1, 4, 0, 1, 2, 3])
    with pytest.raises(InputError, match=r"constraints\[0\] has 1 id\(s\); .*; degenerate='ignore' leaves it out$"):
        regular_triangulation(square, constraints=chains)
    for mesh in (
        regular_triangulation(square, constraints=chains, degenerate="ignore"),
        terrain_mesh(square, constraints=chains, degenerate="ignore"),
    ):
        assert mesh.field_data["DegenerateLines"].tolist() == [2]
    repeated = pv.PolyData(corners, faces=[4, 0, 1, 1, 0])
    with pytest.raises(InputError, match=r"cell 0 of lines has 2 point\(s\) without repeated ones: a ring takes 3"):
        constrained_triangulation(hull, repeated)


def test_lines_that_cannot_be_used():
    mesh = pv.PolyData(SQUARE)
    for lines, error, sentence in (
        (pv.PolyData(), InputError, "lines is empty"),
        (pv.PolyData([[0, 0, 0], [np.nan, 0, 0]], lines=[2, 0, 1]), InputError,
         "point 1 of cell 0 of lines, .* has a coord"),
        (mesh.cast_to_unstructured_grid(), TypeError, "lines are a PolyData or geometries, not a vtkUnstructuredGrid"),
        ([np.zeros((1, 3))], InputError, r"lines\[0\] has 1 point"),
    ):
        with pytest.raises(error, match=sentence):
            constrained_triangulation(mesh, lines)
    with pytest.raises(TypeError, match="the mesh is a composite"):
        constrained_triangulation(pv.MultiBlock([mesh]), mesh)


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


def test_terrain_meshes():
    x, y = np.meshgrid(np.arange(30.0), np.arange(20.0), indexing="ij")
    points = np.column_stack([x.ravel(), y.ravel(), 2 * np.sin(x / 4).ravel() * np.cos(y / 3).ravel()])
    mesh = pv.PolyData(points)
    mesh.point_data["depth"] = -2 * points[:, 2]
    line = [3, 25, 47, 69]
    for heights in (None, "depth", mesh["depth"]):
        levels = points[:, 2] if heights is None else mesh["depth"]
        wanted = arrays.terrain_mesh(points, levels, tolerance=0.2, constraints=[line])
        found, rest = terrain_mesh(
            mesh, heights, tolerance=0.2, constraints=pv.PolyData(points, lines=[4, *line]), return_hidden_points=True
        )
        ids, others = found["vtkOriginalPointIds"], rest["vtkOriginalPointIds"]
        assert np.array_equal(ids, wanted.vertices) and np.array_equal(ids[found.regular_faces], wanted.simplices)
        assert np.array_equal(np.sort([*ids, *others]), np.arange(600)) and rest.n_verts == len(others)
        assert np.array_equal(rest["TerrainError"], wanted.errors[others]) and abs(rest["TerrainError"]).max() <= 0.2
        assert np.array_equal(found["depth"], mesh["depth"][ids]) and np.array_equal(found.points, mesh.points[ids])
    assert terrain_mesh(mesh, tolerance=0.2, max_vertices=9).n_points == 9
    ghosts = mesh.copy()
    ghosts.point_data["vtkGhostType"] = (np.arange(600) == 0).astype(np.uint8)
    assert 0 not in terrain_mesh(ghosts)["vtkOriginalPointIds"]
    blocks = terrain_mesh(pv.MultiBlock([mesh, mesh]), "depth", tolerance=0.5)
    assert blocks[0].n_points == blocks[1].n_points == terrain_mesh(mesh, "depth", tolerance=0.5).n_points
    with pytest.raises(InputError, match="the heights' array \"none\" is missing"):
        terrain_mesh(mesh, "none")
    with pytest.raises(ValueError, match="points of two coordinates take heights"):
        terrain_mesh(points[:, :2])
    with pytest.raises(TypeError, match="the heights of a composite are the name of a point array"):
        terrain_mesh(pv.MultiBlock([mesh]), points[:, 2])


def test_terrain_meshes_with_lines():
    x, y = np.meshgrid(np.arange(30.0), np.arange(20.0), indexing="ij")
    points = np.column_stack([x.ravel(), y.ravel(), 2 * np.sin(x / 4).ravel() * np.cos(y / 3).ravel()])
    mesh = pv.PolyData(points)
    mesh.point_data["depth"] = -2 * points[:, 2]
    own = np.array([[0.5, 3.5, 4], [20.5, 15.25, 6], [3, 17, 1], [25.5, 2.5, 1]])
    lines = pv.PolyData(own, lines=[2, 0, 1, 2, 2, 3])
    lines.point_data["depth"] = np.arange(4.0)
    wanted = arrays.terrain_mesh(points, tolerance=0.2, lines=[own[:2], own[2:]])
    for given in (lines, [own[:2], own[2:]]):
        found, rest = terrain_mesh(mesh, tolerance=0.2, lines=given, return_hidden_points=True)
        assert np.array_equal(found.points, wanted.joined.points[wanted.vertices])
        assert np.array_equal(wanted.vertices[found.regular_faces], wanted.simplices)
        assert np.array_equal(found["PointOrigin"], wanted.joined.point_origin[wanted.vertices])
        assert np.array_equal(found["HeightRange"], wanted.joined.height_range[wanted.vertices])
        assert (found["PointOrigin"] > 0).sum() == 4 and (found["vtkOriginalPointIds"] == -1).sum() == 4
        ids = rest["vtkOriginalPointIds"]
        assert np.array_equal(rest["TerrainError"], wanted.errors[ids]) and abs(rest["TerrainError"]).max() <= 0.2
        assert rest.n_points + found.n_points == 604 and not rest["PointOrigin"].any()
        added = found["depth"][found["PointOrigin"] == 1]
        assert added.tolist() == [0, 1, 3] if given is lines else np.isnan(added).all()
    with pytest.raises(InputError, match=r"their own, call .*, or terrain_mesh\(\) with them as lines"):
        terrain_mesh(mesh, constraints=lines)
    with pytest.raises(TypeError, match="lines are for one data set, and the mesh is a composite"):
        terrain_mesh(pv.MultiBlock([mesh]), lines=lines)
    with pytest.raises(ValueError, match="breaklines are constraints or lines, not both"):
        terrain_mesh(mesh, constraints=[[0, 1]], lines=lines)
    with pytest.raises(ValueError, match="lines have their heights in z: leave heights out"):
        terrain_mesh(mesh, "depth", lines=lines)
    own[1, 2] = np.nan
    with pytest.raises(InputError, match="point 1 of cell 0 of lines, .* has a coordinate that is NaN or infinite"):
        terrain_mesh(mesh, lines=pv.PolyData(own, lines=[2, 0, 1]))


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
    for name, words in {"nowhere": "is missing", "pairs": "has 2 components",
                        "words": ".* does not hold numbers"}.items():
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
    assert regular_triangulation(mesh, "w", non_finite="ignore").n_points == 29
    mesh.points[7, 2] = np.inf  # a z counts, too
    assert regular_triangulation(mesh, "w", non_finite="ignore").n_points == 28


def test_cells_fill_the_box():
    places = np.random.default_rng(5).random((300, 2))
    cells = power_diagram(places)
    sizes = cells.bounds
    assert cells.n_cells == 300
    assert cells.area == pytest.approx((sizes[1] - sizes[0]) * (sizes[3] - sizes[2]))
    assert power_diagram([]).n_points == power_diagram([], box=(0, 1, 0, 1)).n_points == 0
    plane = pv.Plane(i_resolution=7, j_resolution=5, direction=(1, 2, 3), center=(5, 6, 7))
    tilted = power_diagram(plane, projection_plane_mode="best_fitting_plane")
    assert tilted.n_cells == 48
    assert np.allclose((tilted.points - plane.center) @ [1, 2, 3], 0, atol=1e-5)


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


def test_images():
    mesh = pv.PolyData(np.random.default_rng(8).random((200, 3)) * [10, 6, 1])
    mesh.point_data["pair"] = np.random.default_rng(9).random((200, 2))
    image = to_image(mesh, spacing=0.25, method="clough-tocher", fill_value=-5)
    assert image.dimensions[2] == 1 and image.spacing == (0.25, 0.25, 1)
    flat = arrays.regular_triangulation(mesh.points[:, :2])
    found = flat.to_image(mesh.points[:, 2], spacing=0.25, method="clough-tocher", fill_value=-5)
    assert np.array_equal(image["Elevation"].reshape(found.array.shape), found.array[::-1])
    assert np.allclose(image.points[0, :2], (found.x[0], found.y[-1]))
    assert np.allclose(image.points[-1, :2], (found.x[-1], found.y[0]))
    mesh.point_data["vtkGhostType"] = (np.arange(200) < 3).astype(np.uint8)
    pairs = to_image(mesh, "pair", shape=(4, 9), bounds=((2, 2), (8, 4)))
    rest = arrays.regular_triangulation(mesh.points[3:, :2])
    expected = rest.to_image(mesh["pair"][3:], shape=(4, 9), bounds=((2, 2), (8, 4)))
    assert np.array_equal(pairs["pair"].reshape(4, 9, 2), expected.array[::-1], equal_nan=True)
    assert to_image(np.zeros((4, 3)) + np.eye(4, 3), [1, 2, 3, 4], shape=(2, 2))["values"].shape == (4,)
    with pytest.raises(InputError, match="point array \"none\" is missing"):
        to_image(mesh, "none", spacing=1)
    with pytest.raises(TypeError, match="combine the blocks"):
        to_image(pv.MultiBlock([mesh]), spacing=1)
