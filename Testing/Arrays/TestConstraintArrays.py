# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays: triangulations with constraints and polygons, and their borders."""

import numpy as np
import pytest

from vtkflipflop.arrays import (
    AbortedError,
    ConstrainedTriangulation,
    InputError,
    Polygons,
    RegularTriangulation,
    refined_mesh,
    regular_triangulation,
    split_crossings,
    terrain_mesh,
    validate,
)

RANDOM = np.random.default_rng(21)
GRID = np.stack(np.meshgrid(np.arange(9), np.arange(9), indexing="ij"), -1).reshape(-1, 2)


def square(least, greatest):
    """The ids of the grid's points at a square's corners, counter-clockwise."""
    a, b = least, greatest
    return [9 * a + a, 9 * b + a, 9 * b + b, 9 * a + b]


def shoelace(points, ring):
    x, y = points[ring].T
    return 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))


def test_without_constraints_it_is_the_regular_triangulation():
    points = RANDOM.random((300, 2))
    plain = regular_triangulation(points)
    assert type(plain) is RegularTriangulation
    for given in ({"constraints": []}, {"polygons": ()}, {"constraints": np.empty((0, 2), int), "polygons": []}):
        ours = regular_triangulation(points, **given)
        assert type(ours) is ConstrainedTriangulation
        assert np.array_equal(ours.simplices, plain.simplices)
        assert ours.fixed_edges.shape == (0, 2) and ours.constraint_of.shape == (0,)


@pytest.mark.parametrize("facets", ["triangles", "polygons"])
def test_polygons_in_polygons(facets):
    rings = [square(0, 8), square(1, 7)[::-1], square(2, 6), square(3, 5)[::-1]]
    areas = [64, 64 - 36, 64 - 36 + 16, 64 - 36 + 16 - 4]
    for depth in range(1, 5):
        ours = regular_triangulation(GRID, polygons=rings[:depth], facets=facets)
        assert ours.areas.sum() == areas[depth - 1]
        assert ours.dropped == (64 - areas[depth - 1]) * (2 if facets == "triangles" else 1)
        assert sorted(shoelace(GRID, ring) for ring in ours.boundary) == sorted([64, -36, 16, -4][:depth])
        assert np.array_equal(ours.vertices, np.arange(81)) and ours.hidden.size == 0
        assert validate(ours)
        for other in ({"polygon_rule": "direction"}, {"polygons": [ring[::-1] for ring in rings[:depth]]}):
            again = regular_triangulation(GRID, **{"polygons": rings[:depth], "facets": facets, **other})
            assert np.array_equal(again.simplices, ours.simplices) and again.dropped == ours.dropped
            assert all(map(np.array_equal, again.polygons, ours.polygons))
    assert (ours.vertex_to_simplex == -1).sum() == 1  # in the middle of the innermost hole
    assert ours.within_edge_length(1.5).all() and not ours.within_edge_length(1).any()
    # Alone, a clockwise polygon keeps its inside; by direction, it is a hole in all.
    for rule, area in (("even-odd", 4), ("direction", 60)):
        alone = regular_triangulation(GRID, polygons=[square(2, 4)[::-1]], polygon_rule=rule)
        assert alone.areas.sum() == area
        assert alone.polygons.offsets[-1] == alone.polygons.connectivity.size == 4 * area


def test_rings_as_shapely_gives_them():
    """Clockwise outside, counter-clockwise holes, closed by their first point again."""
    angles = np.linspace(0, -2 * np.pi, 65)[:-1]
    disk = np.column_stack([np.cos(angles), np.sin(angles)])
    points = np.vstack([disk, 0.5 * disk, RANDOM.uniform(-1.5, 1.5, (500, 2))])
    outer, hole = [*range(64), 0], [64, *range(127, 63, -1)]
    assert shoelace(points, outer[:-1]) < 0 < shoelace(points, hole[:-1])
    whole = regular_triangulation(points, polygons=[outer])
    assert whole.areas.sum() == pytest.approx(-shoelace(points, outer[:-1]), rel=1e-12)
    ring = regular_triangulation(points, polygons=[outer, hole])
    assert ring.areas.sum() == pytest.approx(0.75 * whole.areas.sum(), rel=1e-12)
    for sides in ([outer, hole[::-1]], [outer[::-1], hole], [hole, outer]):
        assert np.array_equal(regular_triangulation(points, polygons=sides).simplices, ring.simplices)


def test_all_forms_are_the_same():
    lines, rings = [[0, 40], [40, 44, 80]], [square(0, 8), square(1, 4), square(4, 7)[::-1]]
    with pytest.raises(InputError, match=r"reverse polygons\[[01]\], which disagrees with polygons\[[01]\]"):
        regular_triangulation(GRID, polygons=rings, polygon_rule="direction")
    rings[1].reverse()
    one = regular_triangulation(GRID, constraints=lines, polygons=rings)
    closed = [[*ring, ring[0]] for ring in rings]
    packed = Polygons(np.array([3, 7, 11, 15]), np.concatenate([[0, 0, 0], *rings, [0]]))
    pairs = [[0, 40], [40, 44], [44, 80]]
    assert np.array_equal(one.constraints[:3], pairs) and one.constraints.shape == (15, 2)
    for constraints in (pairs, np.array(pairs, np.uint16), tuple(map(np.array, lines)), np.array(lines, object)):
        for polygons in (rings, closed, [*closed[:2], rings[2]], np.array(rings, np.int32), np.array(closed), packed):
            other = regular_triangulation(GRID, constraints=constraints, polygons=polygons)
            assert np.array_equal(other.simplices, one.simplices)
            assert np.array_equal(other.constraints, one.constraints)
            assert np.array_equal(other.constraint_of, one.constraint_of)
    assert len(one.fixed_edges) == len(one.constraint_of) > 15



def test_points_that_are_left_out():
    bad = GRID.astype(np.float64)
    bad[20] = np.nan
    masked = np.ma.array(GRID, mask=np.repeat(np.arange(81) == 20, 2))
    for points, policy in ((bad, "ignore"), (masked, "error")):
        ours = regular_triangulation(points, polygons=[square(0, 4)], non_finite=policy)
        assert 20 not in ours.vertices and ours.areas.sum() == 16 and validate(ours)
        assert len(ours.polygons.offsets) == 12 + 5 + 1  # twelve squares; around the gap, one and four triangles
        with pytest.raises(InputError, match="constraint 1, point 20") as caught:
            regular_triangulation(points, constraints=[[0, 1], [19, 20]], non_finite=policy)
        assert (caught.value.code, caught.value.index, caught.value.count) == ("constraint_point", 1, 20)
    with pytest.raises(InputError, match="first at point 20"):
        regular_triangulation(bad, constraints=[[0, 1]])


def test_every_dimension():
    line = np.arange(4)[:, None] * [1, 2]
    for points, constraints in ((GRID[:0], []), (GRID[:1], [[0, 0]]), (line, [[3, 0]])):
        ours, plain = regular_triangulation(points, constraints=constraints), regular_triangulation(points)
        assert np.array_equal(ours.simplices, plain.simplices) and ours.dimension == plain.dimension
        assert validate(ours)
        for ring in (ours.boundary, plain.boundary):
            assert ring.offsets.tolist() == [0] and ring.connectivity.size == 0
    assert ours.fixed_edges.tolist() == [[0, 1], [1, 2], [2, 3]] and ours.constraint_of.tolist() == [0, 0, 0]
    # Of points on a line nothing is inside or outside.
    assert regular_triangulation(line, polygons=[[0, 1, 3]]).dropped == 0


def test_when_nothing_is_inside():
    with pytest.warns(UserWarning,
                      match="no cell is inside the polygons, so none is left: what is on the left") as told:
        ours = regular_triangulation(GRID, polygons=[square(0, 8)[::-1]], polygon_rule="direction")
    assert [warning.filename for warning in told] == [__file__]
    with pytest.warns(UserWarning, match="no cell is inside the polygons, so none is left$"):
        assert regular_triangulation(GRID, polygons=[square(0, 8)] * 2).dropped == 128
    assert ours.simplices.shape == ours.neighbors.shape == (0, 3) and ours.dropped == 128
    assert ours.boundary.offsets.tolist() == ours.polygons.offsets.tolist() == [0]
    assert len(ours.convex_hull) == len(ours.areas) == len(ours.alphas) == 0
    assert (ours.vertex_to_simplex == -1).all() and ours.vertex_neighbor_vertices[1].size == 0


@pytest.mark.parametrize(
    "given, error, words, index, count",
    [
        ({"constraints": [[0, 1], [2, 81]]}, InputError, "not in the triangulation: constraint 1, point 81$", 1, 81),
        ({"constraints": [[0, 1], [-1, 2]]}, InputError, "constraint 1, point -1$", 1, -1),
        ({"constraints": [[0, 1, 2], [3, 99]]}, InputError, r"point 99; constraint 2 is of constraints\[1\]$", 2, 99),
        ({"polygons": [[0, 1, 9], [0, 9, 99]]}, InputError, r"point 99; constraint 4 is of polygons\[1\]$", 4, 99),
        ({"constraints": [[0, 10], [1, 9]]}, InputError, "cross between points: constraint 1, and constraint 0$", 1, 0),
        ({"polygons": [[0, 9, 10], [1, 9, 18]]}, InputError, r"of polygons\[1\]; constraint 2 is of pol", 3, 2),
        (
            {"polygons": [square(0, 4), square(1, 3)], "polygon_rule": "direction"},
            InputError,
            r"disagree about what is inside: reverse polygons\[1\], which disagrees with polygons\[0\], "
            "or pass polygon_rule='even-odd'$",
            7,
            3,
        ),
        ({"polygons": [], "polygon_rule": "left"}, ValueError, "polygon_rule is one of 'even-odd', 'direction'", 0, 0),
        ({"polygons": [], "polygon_rule": 1}, TypeError, "polygon_rule is one of 'even-odd', 'direction'", 0, 0),
        ({"polygons": [[0, 1, 9], [2, 3]]}, InputError, r"polygons\[1\] has 2 id\(s\); it takes 3 or more", 1, 1),
        ({"polygons": [[2, 3, 2]]}, InputError, r"polygons\[0\] has 2 id\(s\)", 0, 1),
        ({"polygons": [[]]}, InputError, r"polygons\[0\] has 0 id\(s\)", 0, 1),
        ({"constraints": [[0, 1], [7]]}, InputError, r"constraints\[1\] has 1 id\(s\); it takes 2 or more", 1, 1),
        ({"polygons": Polygons(np.array([0, 4]), np.arange(3))}, InputError,
         "offsets of polygons ascend from 0 to 3, .* but offset 1 is 4$", 1, 1),
        ({"constraints": np.ma.array([[0, 1]], mask=[[0, 1]])}, InputError,
         r"constraints: entry \[0, 1\] is masked", 0, 1),
        ({"constraints": np.array([[0, 2**64 - 1]], np.uint64)}, InputError, "out of range", -1, 0),
        ({"constraints": [[0, 1.0]]}, TypeError, "the ids of constraints are integers, not of type float64", 0, 0),
        ({"polygons": [[0, 1, 2, 3], [0, 1.5, 2]]}, TypeError, r"the ids of polygons\[1\] are integers", 0, 0),
        ({"constraints": 3}, TypeError, "constraints are sequences of ids, not of type int", 0, 0),
        ({"constraints": [0, 1]}, ValueError, "not an array of shape", 0, 0),
        ({"constraints": [], "weights": np.zeros(81)}, InputError, "constraints take no weights", -1, 0),
        ({"polygons": [], "engine": "cuda"}, InputError, "the CUDA engine was asked for, but constraints", -1, 0),
    ],
)
def test_errors(given, error, words, index, count):
    with pytest.raises(error, match=words) as caught:
        regular_triangulation(GRID, **given)
    if error is InputError:
        assert (caught.value.index, caught.value.count) == (index, count)


def test_what_constrained_triangulations_have_not():
    ours = regular_triangulation(GRID, constraints=[[0, 80]])
    for call in (ours.nearest, ours.power_diagram):
        with pytest.raises(TypeError, match="a constrained triangulation has no .*: take that of the points without"):
            call([0, 0])
    with pytest.raises(InputError, match="a constrained triangulation has no natural neighbours: take method='linear'"):
        ours.interpolate(range(81), [0, 0], "natural")
    with pytest.raises(InputError, match="a constrained triangulation has no natural neighbours: take method='linear'"):
        ours.interpolate(range(81), [0, 0], "laplace")
    with pytest.raises(InputError, match="natural neighbours are those of a regular triangulation"):
        ours.natural_neighbours([[0, 0]])
    with pytest.raises(AttributeError, match="frozen"):
        ours.dropped = 1
    arrays = (ours.constraints, ours.fixed_edges, ours.constraint_of, ours.boundary.offsets, ours.boundary.connectivity)
    assert not any(array.flags.writeable for array in arrays)
    assert repr(ours) == "<ConstrainedTriangulation of 81 points: dimension 2, 128 cells, 0 dropped, 8 fixed edges>"


def test_breaklines_count_in_what_is_interpolated():
    """A ridge along a constraint stays one; without it, the surface is cut across."""
    points, height = np.array([[0, 0], [10, 0], [5, 1], [5, -1]]), [1, 1, 0, 0]
    assert regular_triangulation(points).interpolate(height, [2.5, 0]) == 0.5
    assert regular_triangulation(points, constraints=[[0, 1]]).interpolate(height, [2.5, 0]) == 1


def test_progress_of_both_parts_is_one():
    points, told = RANDOM.random((100_000, 2)), []
    points[:4] = [[-1, -1], [2, -1], [2, 2], [-1, 2]]
    regular_triangulation(points, polygons=[range(4)], progress=told.append)
    assert told and told == sorted(told) and 0 <= told[0] and told[-1] <= 1
    with pytest.raises(AbortedError):
        regular_triangulation(points, polygons=[range(4)], progress=lambda fraction: False)


def test_crossings_are_split():
    square = np.array([[0, 0], [2, 0], [2, 2], [0, 2]], np.float32)
    with pytest.raises(InputError, match="constraint 1, and constraint 0"):
        regular_triangulation(square, constraints=[[0, 2], [1, 3]])
    split = split_crossings(square, [[0, 2], [1, 3]])
    assert split.new_points == 1
    assert split.points.tolist() == [*square.tolist(), [1, 1]]
    assert split.constraints.tolist() == [[0, 4], [4, 2], [1, 4], [4, 3]]
    assert split.constraint_of.tolist() == [0, 0, 1, 1]
    found = regular_triangulation(split.points, constraints=split)
    assert len(found.simplices) == 4
    assert found.validate()
    # A polygon that crosses itself has no inside that its sides agree about.
    tie = split_crossings(square, polygons=[[0, 1, 3, 2]])
    assert (tie.new_points, tie.sides) == (1, 6)
    assert tie.polygon_of.tolist() == [0] * 6
    with pytest.raises(InputError, match=r"the sides of polygons\[0\] disagree with each other"):
        regular_triangulation(tie.points, constraints=tie, polygon_rule="direction")
    assert regular_triangulation(tie.points, constraints=tie).areas.sum() == 2
    with pytest.raises(ValueError, match="leave polygons out"):
        regular_triangulation(tie.points, constraints=tie, polygons=[[0, 1, 2]])
    with pytest.raises(InputError, match="constraint 0, point 4"):
        split_crossings(square, [[0, 4]])


def test_chains_of_too_few_ids_are_left_out():
    lines, rings = [[0, 40], [7], [40, 44, 80], []], [[], square(0, 8), [3, 4, 3], square(2, 5), [9, 10], [11]]
    good = {"constraints": [lines[0], lines[2]], "polygons": [rings[1], rings[3]]}
    given = {"constraints": lines, "polygons": rings}
    packed = Polygons(np.cumsum([0, *map(len, rings)]), np.concatenate([np.array(ring, int) for ring in rings]))
    wanted = regular_triangulation(GRID, **good)
    assert wanted.degenerate == 0
    for polygons in (rings, packed):
        ours = regular_triangulation(GRID, constraints=lines, polygons=polygons, degenerate="ignore")
        assert ours.degenerate == 6
        for name in ("simplices", "constraints", "constraint_of", "dropped"):
            assert np.array_equal(getattr(ours, name), getattr(wanted, name))
    # The caller's numbers stay: of what is left out, of errors, and of pieces.
    sentence = r"constraints\[1\] has 1 id\(s\); .*; degenerate='ignore' leaves it out$"
    with pytest.raises(InputError, match=sentence) as raised:
        regular_triangulation(GRID, **given)
    assert (raised.value.index, raised.value.count) == (1, 2)
    with pytest.raises(InputError, match=r"^polygons\[0\] has 0 id\(s\); it takes 3 or more") as raised:
        regular_triangulation(GRID, polygons=rings)
    assert (raised.value.index, raised.value.count) == (0, 4)
    with pytest.raises(InputError, match=r"point 99; constraint 3 is of polygons\[1\]$"):
        regular_triangulation(GRID, polygons=[[1, 2], [0, 1, 9, 10, 99]], degenerate="ignore")
    split = split_crossings(GRID, [[5], [0, 40], [36, 4]], rings, degenerate="ignore")
    assert split.degenerate == 5 and set(split.polygon_of) == {1, 3} and split.new_points == 0
    again = regular_triangulation(split.points, constraints=split)
    assert again.degenerate == 5 and again.areas.sum() == 64 - 9
    # As if nothing was given: all is inside.
    nothing = regular_triangulation(GRID, polygons=[[0, 1], []], degenerate="ignore")
    assert (nothing.degenerate, nothing.dropped, nothing.areas.sum()) == (2, 0, 64)
    mesh = refined_mesh(GRID, **given, degenerate="ignore")
    assert mesh.degenerate == 6 and mesh.areas.sum() == pytest.approx(64 - 9, rel=1e-13)
    with pytest.raises(InputError, match=r"constraints\[1\] has 1 id"):
        refined_mesh(GRID, **given)
    terrain = terrain_mesh(GRID, np.zeros(81), constraints=lines, degenerate="ignore")
    assert terrain.degenerate == 2 and terrain.fixed_edges.tolist() == [[0, 40], [40, 44], [44, 80]]
    for call in (regular_triangulation, split_crossings, refined_mesh):
        with pytest.raises(ValueError, match="degenerate is one of 'error', 'ignore', not 'skip'"):
            call(GRID, constraints=[], degenerate="skip")
