# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What results have in common: they are pickled and copied, compare by identity, have rings, and come from calls."""

import copy
import multiprocessing
import pickle

import numpy as np
import pytest

from vtkflipflop import arrays
from vtkflipflop.arrays import (
    InputError,
    Polygons,
    alpha_complex,
    centroidal_cells,
    convex_hull,
    convex_hulls,
    convexify,
    power_diagram,
    prescribed_areas,
    refined_mesh,
    regular_triangulation,
    regular_triangulations,
    spherical_voronoi,
    split_crossings,
    terrain_mesh,
    voronoi_diagram,
)

RANDOM = np.random.default_rng(12)
SPACE, PLANE = RANDOM.random((200, 3)), RANDOM.random((200, 2))
SPHERE = (SPACE - 0.5) / np.linalg.norm(SPACE - 0.5, axis=1)[:, None]
WEIGHTS = RANDOM.random(200) * 0.01
CUBE = np.array([[x, y, z] for x in (0, 2) for y in (0, 2) for z in (0, 2)], float)
GRID = np.stack(np.meshgrid(np.arange(6), np.arange(6), indexing="ij"), -1).reshape(-1, 2)
RING = [0, 30, 35, 5]
HOLE = [7, 9, 21, 19]



def selected(whole):
    return whole.with_cells(np.arange(whole.nsimplex) % 3 > 0)


RESULTS = {
    "hull": lambda: convex_hull(SPACE),
    "hull of facets": lambda: convex_hull(CUBE, facets="polygons"),
    "hull in the plane": lambda: convex_hull(PLANE),
    "hull of nothing": lambda: convex_hull([]),
    "hull of columns": lambda: convex_hull(np.asfortranarray(SPACE)),
    "hull of every other point": lambda: convex_hull(SPACE[::2]),
    "convexified": lambda: convexify(CUBE, convex_hull(CUBE).simplices),
    "triangulation": lambda: regular_triangulation(PLANE),
    "weighted": lambda: regular_triangulation(SPACE, WEIGHTS, facets="polygons"),
    "triangulation of nothing": lambda: regular_triangulation(PLANE[:0]),
    "diagram": lambda: power_diagram(PLANE, WEIGHTS),
    "diagram of nothing": lambda: power_diagram(PLANE[:0]),
    "unbounded diagram": lambda: voronoi_diagram(PLANE, WEIGHTS),
    "rays": lambda: voronoi_diagram(PLANE).rays,
    "sphere": lambda: spherical_voronoi(SPHERE).triangulation,
    "spherical diagram": lambda: spherical_voronoi(SPHERE),
    "alpha complex": lambda: alpha_complex(PLANE, 0.05),
    "rescaled": lambda: regular_triangulation(PLANE * [1, 100], rescale=True),
    "selection": lambda: selected(regular_triangulation(PLANE, WEIGHTS)),
    "selection of polygons": lambda: selected(RESULTS["polygons"]()),
    "constrained": lambda: regular_triangulation(GRID, constraints=[[0, 35], [1, 17]]),
    "polygons": lambda: regular_triangulation(GRID, constraints=[[1, 2]], polygons=[RING, HOLE], facets="polygons"),
    "refined": lambda: refined_mesh(GRID, polygons=[RING, HOLE], minimum_angle=30),
    "terrain": lambda: terrain_mesh(SPACE, tolerance=0.1, constraints=[[0, 1]]),
    "split": lambda: split_crossings(GRID, [[0, 35], [1, 17], [5, 31]]),
    "hulls": lambda: convex_hulls(SPACE, [0, 50, 50, 200]),
    "triangulations": lambda: regular_triangulations(PLANE, [0, 50, 200], WEIGHTS),
    "centroidal": lambda: centroidal_cells(PLANE[:30], iterations=3),
    "prescribed": lambda: prescribed_areas(PLANE[:30], domain=[(0, 0), (2, 0), (1, 2)]),
    "validation": lambda: convex_hull(SPACE).validate(),
    "box": lambda: convex_hull(SPACE).minimal_box(),
    "image": lambda: regular_triangulation(PLANE).to_image(WEIGHTS, shape=(3, 4)),
    "rings": lambda: regular_triangulation(PLANE).boundary,
}
QUESTIONS = {
    "contains": lambda self: self.contains(np.eye(self.ndim)),
    "distance": lambda self: self.distance(np.full((20, self.ndim), 0.3)),
    "locate": lambda self: self.locate(PLANE),
    "interpolate": lambda self: self.interpolate(np.arange(self.npoints), PLANE),
    "alpha_complex": lambda self: self.alpha_complex(0.1).simplices,
    "values_at_points": lambda self: self.values_at_points(np.arange(len(self.points) - self.new_points)),
    "validate": lambda self: self.validate(),
}


def bits(value, depth=0):
    """All that a result has, to compare."""
    if isinstance(value, np.ndarray):
        return value.dtype.str, value.shape, value.tobytes()
    if isinstance(value, dict):
        return {key: bits(one) for key, one in value.items()}
    if isinstance(value, (tuple, list)) or hasattr(value, "offsets") and not isinstance(value, Polygons):
        return [bits(one) for one in value]
    names = [name for name in dir(value) if not name.startswith("_") and hasattr(value, name)]
    if type(value).__module__.startswith("vtkflipflop"):
        attributes = {name: getattr(value, name) for name in names}
        answers = {name: ask(value) for name, ask in QUESTIONS.items() if name in names}
        return bits({name: one for name, one in (attributes | answers).items() if not callable(one)})
    return value


@pytest.mark.parametrize("name", RESULTS)
@pytest.mark.parametrize("way", ["pickle", "old pickle", "deepcopy", "used"])
def test_copies_are_the_same(name, way):
    result = RESULTS[name]()
    if way == "used":
        bits(result)  # what is worked out when asked for, and what answers questions
    ways = {"old pickle": lambda: pickle.loads(pickle.dumps(result, 2)), "deepcopy": lambda: copy.deepcopy(result)}
    other = ways.get(way, lambda: pickle.loads(pickle.dumps(result)))()
    assert type(other) is type(result) and (isinstance(result, tuple) or repr(other) == repr(result))
    assert bits(other) == bits(result)
    for value in vars(other).values() if hasattr(other, "__dict__") else other:
        assert not isinstance(value, np.ndarray) or not value.flags.writeable


def test_a_copy_has_its_own_points():
    points = SPACE.copy()
    hull = convex_hull(points)
    assert copy.copy(hull) is hull
    other = copy.deepcopy(hull)
    points[:] = 7
    assert np.array_equal(other.points, SPACE) and other.validate()


def work(points):
    return convex_hull(points), regular_triangulation(points, constraints=[[0, 1]])


def test_results_come_back_from_other_processes():
    sets = [RANDOM.random((100, 2)) for _ in range(4)]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        found = pool.map(work, sets)
    for points, (hull, triangulation) in zip(sets, found):
        assert np.array_equal(hull.simplices, convex_hull(points).simplices)
        assert triangulation.validate() and triangulation.locate(points[0]) >= 0


def test_errors_are_pickled():
    with pytest.raises(InputError) as caught:
        convex_hull(np.full((3, 3), np.nan))
    other = pickle.loads(pickle.dumps(caught.value))
    assert type(other) is InputError and str(other) == str(caught.value)
    assert (other.code, other.index, other.count) == ("non_finite", 0, 3)
    batch = convex_hulls(np.full((4, 3), np.nan), [0, 2, 4], errors="keep")
    assert list(pickle.loads(pickle.dumps(batch)).errors) == [0, 1]


@pytest.mark.parametrize("name", ["hull", "diagram", "polygons", "hulls"])
def test_a_state_that_is_none(name):
    core = RESULTS[name]()
    core = core.__dict__.get("_whole", core._core)
    state = core.__getstate__()

    def spoilt(part):
        """Indices too large, and arrays too short."""
        if isinstance(part, tuple):
            return tuple(map(spoilt, part))
        return None if part is None else part[:-1] if part.dtype == float else part + 10**6

    wrong = core.__class__.__new__(core.__class__)
    with pytest.raises((ValueError, TypeError)):
        wrong.__setstate__(spoilt(state))


def test_results_compare_by_identity():
    for name in ("hull", "triangulation", "diagram", "constrained", "hulls", "rings"):
        one, other = RESULTS[name](), RESULTS[name]()
        assert one == one and one != other and len({one, other}) == 2
    assert convex_hull(CUBE).validate() == convex_hull(CUBE).validate()


def test_polygons_are_a_sequence_of_rings():
    rings = convex_hull(CUBE).polygons
    assert len(rings) == 6
    assert all(isinstance(ring, np.ndarray) and len(ring) == 4 for ring in rings)
    assert [ring.tolist() for ring in rings] == rings.connectivity.reshape(6, 4).tolist()
    assert rings[-1].tolist() == rings.connectivity[20:].tolist()
    assert [ring.tolist() for ring in rings[1:3]] == [rings[1].tolist(), rings[2].tolist()]
    assert rings.offsets.tolist() == list(range(0, 25, 4))
    for index in (6, -7):
        with pytest.raises(IndexError, match="of 6"):
            rings[index]
    with pytest.raises(AttributeError, match="frozen"):
        rings.offsets = rings.offsets
    assert repr(rings) == "<Polygons: 6, of 24 corners>"
    shape = regular_triangulation(GRID, polygons=[RING, HOLE])
    assert len(shape.boundary) == 2 and len(convex_hull([]).polygons) == 0
    diagram = power_diagram(PLANE)
    assert len(diagram.cells) == len(diagram.regions) == len(diagram)
    assert all(np.array_equal(*both) for both in zip(diagram.cells, diagram.regions))
    # They go in where they come out, as rings too.
    for form in (shape.boundary, list(shape.boundary), shape.boundary[:]):
        assert np.array_equal(regular_triangulation(GRID, polygons=form).simplices, shape.simplices)


@pytest.mark.parametrize(
    "name, call",
    [
        ("ConvexHull", r"convex_hull\(points\)"),
        ("RegularTriangulation", r"regular_triangulation\(points\)"),
        ("ConstrainedTriangulation", r"regular_triangulation\(points, constraints=...\)"),
        ("PowerDiagram", r"power_diagram\(points\)"),
        ("AlphaComplex", r"alpha_complex\(points, alpha\)"),
        ("RefinedMesh", r"refined_mesh\(points\)"),
        ("TerrainMesh", r"terrain_mesh\(points, tolerance=...\)"),
        ("HullBatch", r"convex_hulls\(points, offsets\)"),
        ("TriangulationBatch", r"regular_triangulations\(points, offsets\)"),
        ("CentroidalCells", r"centroidal_cells\(points\)"),
        ("PrescribedAreas", r"prescribed_areas\(points\)"),
    ],
)
def test_the_types_of_results_name_the_call(name, call):
    for arguments in ((PLANE,), (), (PLANE, WEIGHTS, None)):
        with pytest.raises(TypeError, match=f"{name} is the type of a result: call {call}$"):
            getattr(arrays, name)(*arguments)


# Points that change after the call ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "ask",
    [
        lambda t: t.locate([0.5, 0.5]),
        lambda t: t.interpolate(np.zeros(50), [0.5, 0.5]),
        lambda t: t.polygons,
        lambda t: t.alphas,
        lambda t: t.alpha_complex(1),
        lambda t: t.power_diagram(),
        lambda t: t.__geo_interface__ if hasattr(type(t), "fixed_lines") else t.alphas,
        lambda t: t.fixed_lines if hasattr(type(t), "fixed_lines") else t.alphas,
    ],
)
@pytest.mark.parametrize("constraints", [None, [[0, 1]]])
@pytest.mark.parametrize("value", ["other", "nan"])
def test_points_that_changed(ask, constraints, value):
    points = RANDOM.random((50, 2))
    triangulation = regular_triangulation(points, constraints=constraints)
    points[:] = RANDOM.random((50, 2)) if value == "other" else np.nan
    try:
        found = ask(triangulation)
    except TypeError as error:
        assert constraints and "a constrained triangulation has no" in str(error)
    except InputError as error:
        assert str(error).startswith("the points have changed since they were given") and error.code == "points_changed"
    else:
        assert constraints and value == "other" and found is not None


def test_points_of_hulls_that_changed():
    for ndim in (2, 3):
        points = RANDOM.random((50, ndim))
        hull, other = convex_hull(points), convex_hull(points)
        points[:] = RANDOM.random((50, ndim))
        with pytest.raises(InputError, match="the points have changed"):
            hull.polygons
        points[:] = np.nan
        for name in ["equations", "min_bound", "max_bound", "certificate"] + ["area"] * (ndim == 2):
            with pytest.raises(InputError, match="the points have changed"):
                getattr(other, name)
