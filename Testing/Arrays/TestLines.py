# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays: lines that have points of their own, geometries in and out, and bad ones."""

import pickle

import numpy as np
import pytest

from vtkflipflop.arrays import (
    AbortedError,
    InputError,
    JoinedTriangulation,
    constrained_triangulation,
    regular_triangulation,
    split_crossings,
    validate,
)

RANDOM = np.random.default_rng(40)
GROUND = RANDOM.uniform(0, 10, (200, 3))
SQUARE = ((0, 0), (0, 10), (10, 10), (10, 0), (0, 0))  # clockwise
HOLE = ((4, 4), (6, 4), (6, 6), (4, 6), (4, 4))


def mapping(kind, coordinates):
    return {"type": kind, "coordinates": coordinates}


class Shape:
    """As shapely has it."""

    def __init__(self, kind, coordinates):
        self.__geo_interface__ = mapping(kind, coordinates)


LINE = np.array([[1.0, 1, 5], [5, 5, 7], [9, 9, 3]])
OTHER = np.array([[1.0, 9, 0], [9, 2, 8]])


def test_points_that_lines_add():
    ground = np.vstack([GROUND, [5, 5, 2]])
    ours = constrained_triangulation(ground, [LINE, OTHER])
    assert type(ours) is JoinedTriangulation and validate(ours)
    assert np.array_equal(ours.points[:201], ground)
    # (5, 5) is a point; the lines cross at x = y = 9.875 / 1.875.
    at = 9.875 / 1.875
    assert np.array_equal(ours.points[201:205], [LINE[0], LINE[2], *OTHER])
    assert np.array_equal(ours.points[205, :2], [at, at])
    assert ours.point_origin.tolist() == [0] * 201 + [1] * 4 + [2]
    first, second = 7 - 4 * (at - 5) / 4, 8 * (at - 1) / 8
    assert ours.points[205, 2] == pytest.approx(first, rel=1e-15)
    assert ours.height_range[205] == pytest.approx([second, first], rel=1e-15)
    assert ours.height_range[200].tolist() == [2, 7] and ours.points[200, 2] == 2
    assert ours.differing == 2 and "2 points of several heights" in repr(ours)
    assert ours.geometry_of.tolist() == [0, 0, 0, 1, 1]
    assert ours.constraints.tolist() == [[201, 200], [200, 205], [205, 202], [203, 205], [205, 204]]
    # The first that crosses counts.
    assert constrained_triangulation(ground, [OTHER, LINE]).points[205, 2] == pytest.approx(second, rel=1e-15)
    again = pickle.loads(pickle.dumps(ours))
    assert np.array_equal(again.height_range, ours.height_range) and validate(again)
    for threads in (1, 2, 4):
        other = constrained_triangulation(ground, [LINE, OTHER], threads=threads)
        assert other.points.tobytes() == ours.points.tobytes() and np.array_equal(other.simplices, ours.simplices)


def test_points_on_lines_stay_on_them():
    line, across = np.array([(0, 0, 1), (6, 2, 1)]), np.array([(1, -1, 1), (1, 3, 1)])
    points = np.array([(3, 1, 7), (0, 4, 0), (6, 4, 0), (6, -2, 0), (0, -2, 0)], float)
    ours = constrained_triangulation(points, [line, across])
    assert (ours.fixed_edges == 0).sum() == 2 and ours.height_range[0].tolist() == [1, 7] and ours.points[0, 2] == 7
    split = split_crossings(np.vstack([points, line, across])[:, :2], [[5, 6], [7, 8]])
    assert (regular_triangulation(split.points, constraints=split).fixed_edges == 0).sum() == 2
    assert split.constraints.tolist() == [[5, 9], [9, 0], [0, 6], [7, 9], [9, 8]]
    # Of a side that two polygons share, and a line crosses, both have the same pieces: no hole is between them.
    polygons = [mapping("Polygon", [ring]) for ring in ([(0, 0), (6, 2), (0, 5)], [(0, 0), (3, 1), (6, 2), (6, -3)])]
    parcels = constrained_triangulation([], [*polygons, across[:, :2]])
    assert len(parcels.__geo_interface__["coordinates"]) == len(parcels.boundary) == 1
    # An end on another line, which a third one crosses.
    ends = [[(500473, 4100800), (500643, 4100562)], [(500578, 4100653), (500411, 4100744)],
            [(500300, 4100469), (500627, 4100683)]]
    utm = constrained_triangulation([], [np.array(pair, float) for pair in ends])
    at = np.flatnonzero((utm.points == ends[1][0]).all(axis=1))[0]
    assert (utm.fixed_edges == at).sum() == 3


def test_lines_without_heights_lie_on_the_points():
    with pytest.warns(UserWarning, match=r"leave the points' hull: first at \(10.0, 1.0\), \d such .* heights are NaN"):
        ours = constrained_triangulation(GROUND, [LINE[:, :2] * [10, 1], OTHER[:, :2]])
    ours = constrained_triangulation(GROUND, [LINE[:, :2], OTHER[:, :2]])
    added = ours.points[200:]
    wanted = regular_triangulation(GROUND).interpolate(GROUND[:, 2], added[:, :2])
    assert np.array_equal(added[:, 2], wanted, equal_nan=True)
    assert ours.height_range is None and ours.differing == 0
    flat = constrained_triangulation(GROUND[:, :2], [LINE[:, :2], OTHER[:, :2]])
    assert flat.points.shape == (206, 2) and np.array_equal(flat.simplices, ours.simplices)


def test_all_forms_of_lines_are_the_same():
    lines = [mapping("LineString", LINE.tolist()), mapping("LineString", OTHER.tolist())]
    feature = [{"type": "Feature", "geometry": line, "properties": None} for line in lines]
    one = constrained_triangulation(GROUND, [LINE, OTHER])
    for form in (
        lines,
        tuple(lines),
        [Shape("LineString", LINE.tolist()), Shape("LinearRing", OTHER.tolist())],
        np.array([Shape("LineString", LINE), Shape("LineString", OTHER), None], object)[:2],
        mapping("MultiLineString", [LINE.tolist(), OTHER.tolist()]),
        {"type": "GeometryCollection", "geometries": lines},
        {"type": "FeatureCollection", "features": feature},
        [lines[0], {"type": "GeometryCollection", "geometries": [feature[1]["geometry"]]}],
    ):
        ours = constrained_triangulation(GROUND, form)
        assert ours.points.tobytes() == one.points.tobytes()
        assert np.array_equal(ours.constraints, one.constraints)
    assert np.array_equal(constrained_triangulation(GROUND, LINE).fixed_edges, [[200, 201], [201, 202]])


def test_polygons_are_borders():
    land = mapping("Polygon", (SQUARE, HOLE))
    ours = constrained_triangulation([], land)
    assert ours.areas.sum() == 96 and ours.points.shape == (8, 2)
    for form in (mapping("MultiPolygon", [(SQUARE, HOLE[::-1])]), [Shape("Polygon", (SQUARE[::-1], HOLE))]):
        other = constrained_triangulation([], form)
        assert rings_of(other.__geo_interface__["coordinates"]) == rings_of(ours.__geo_interface__["coordinates"])
    closed = [np.array(SQUARE), np.array(HOLE)]
    assert constrained_triangulation([], closed).areas.sum() == 100
    assert constrained_triangulation([], closed, closed_lines_as_borders=True).areas.sum() == 96
    with pytest.raises(InputError, match="reverse lines, ring [01], which disagrees with lines, ring [01]"):
        constrained_triangulation([], mapping("Polygon", (SQUARE[::-1], HOLE)), polygon_rule="direction")
    with pytest.warns(UserWarning, match="no cell is inside"):
        constrained_triangulation([], mapping("MultiPolygon", [[SQUARE]] * 2))


def test_of_several_features_their_union_is_inside():
    square = mapping("Polygon", [SQUARE, HOLE])
    bow = mapping("Polygon", [((9, 9), (13, 13), (13, 9), (9, 13), (9, 9))])
    ours = constrained_triangulation(GROUND[:, :2], [square, square, bow])
    assert ours.areas.sum() == pytest.approx(96 + 8 - 0.5, rel=1e-14) and validate(ours)
    assert constrained_triangulation([], [square, mapping("Polygon", [HOLE])]).areas.sum() == 100
    again = pickle.loads(pickle.dumps(constrained_triangulation([], [square, square], facets="polygons")))
    assert again.areas.sum() == constrained_triangulation([], [square, square]).areas.sum() == 96
    assert len(again.polygons) == len(constrained_triangulation([], [square, square]).polygons) > 0
    # All closed lines are one feature, each of them once.
    lines = [np.array(SQUARE), np.array(HOLE), np.array(SQUARE), mapping("Polygon", [HOLE])]
    for end, area in ((2, 96), (3, 96), (4, 100)):
        assert constrained_triangulation([], lines[:end], closed_lines_as_borders=True).areas.sum() == area
    with pytest.warns(UserWarning, match="no cell is inside"):
        constrained_triangulation([], [mapping("Polygon", [SQUARE])] * 2, polygon_rule="direction")


@pytest.mark.parametrize("turned", [0, 1, 5, 14])
def test_lines_are_joined_end_to_end(turned):
    corners = np.array([[0, 0], [4, 0], [4, 4], [2, 1], [0, 4.0]])
    sides = [np.array([corners[i], corners[(i + 1) % 5]])[:: -1 if turned >> i & 1 else 1] for i in range(5)]
    for rule in ("even-odd", "direction"):
        ours = constrained_triangulation([], sides, closed_lines_as_borders=True, polygon_rule=rule)
        # By direction, it runs as its first line does.
        assert ours.areas.sum() == (10 if rule == "even-odd" or not turned & 1 else 6)
    outline = [mapping("Polygon", [corners]), *sides]
    assert constrained_triangulation([], outline, closed_lines_as_borders=True).areas.sum() == 10


DEGENERATE = [
    ([mapping("Polygon", [SQUARE]), mapping("Polygon", [])], InputError, r"lines\[1\] is empty", 1, 100),
    ([mapping("Polygon", [SQUARE]), None], TypeError, r"lines\[1\] has no geometry: it is None", 1, 100),
    (mapping("Polygon", [SQUARE, [(5, 2), (5, 2)]]), InputError, r"lines, ring 1 has 1 point\(s\)", 1, 100),
    (mapping("MultiPolygon", [[SQUARE], [[(1, 1), (2, 2)], HOLE], []]), InputError, "lines, part 1, ring 0", 3, 100),
    ([mapping("Polygon", [SQUARE]), LINE[:1, :2], mapping("LineString", [])], InputError, r"\[1\] has 1 point", 2, 100),
    ([], InputError, "lines is empty", 1, None),
    (
        mapping("MultiPolygon", [[SQUARE], [[(0, 0), (1, 1), (1, 1), (0, 0)]]]),
        InputError,
        r"part 1, ring 0 has 2 point\(s\) without repeated ones: a ring takes 3",
        1,
        100,
    ),
    (mapping("MultiPolygon", [[SQUARE], [[(1, 1)] * 4, HOLE]]), InputError, "part 1, ring 0 has 1 point", 2, 100),
    ([mapping("Polygon", [SQUARE]), np.ones((2, 2))], InputError, r"\[1\] has 1 .* ones: a line takes 2", 1, 100),
]


@pytest.mark.parametrize("lines, error, sentence, count, area", DEGENERATE)
def test_what_has_too_few_points(lines, error, sentence, count, area):
    with pytest.raises(error, match=sentence):
        constrained_triangulation(GROUND[:, :2], lines)
    ours = constrained_triangulation(GROUND[:, :2], lines, degenerate="ignore")
    whole = regular_triangulation(GROUND[:, :2]).areas.sum()
    assert ours.degenerate == count and ours.areas.sum() == pytest.approx(area or whole, rel=1e-14)
    with pytest.raises(ValueError, match="degenerate is one of 'error', 'ignore', not 'skip'"):
        constrained_triangulation(GROUND, lines, degenerate="skip")


def rings_of(polygons):
    """The outer ring and the holes of each polygon, each from its lowest point."""

    def turned(ring):
        assert ring[0] == ring[-1]
        at = ring.index(min(ring))
        return ring[at:-1] + ring[:at]

    return sorted((turned(polygon[0]), *sorted(map(turned, polygon[1:]))) for polygon in polygons)


def test_geometries_come_back():
    island = ((4.5, 4.5), (5.5, 4.5), (5, 5.5), (4.5, 4.5))
    # A hole that touches the outer ring in its lowest corner, and a part that touches another in a corner.
    touching = ((0, 0), (2, 3), (3, 2), (0, 0))
    apart = ((10, 10), (12, 10), (12, 12), (10, 10))
    given = mapping("MultiPolygon", [(SQUARE[::-1], HOLE[::-1], touching), (island,), (apart,)])
    ours = constrained_triangulation([], given)
    back = ours.__geo_interface__
    assert back["type"] == "MultiPolygon"
    assert rings_of(back["coordinates"]) == rings_of(given["coordinates"])
    again = constrained_triangulation([], ours)
    assert again.areas.sum() == ours.areas.sum() == 96 - 2.5 + 0.5 + 2
    lines = ours.fixed_lines
    assert lines["type"] == "MultiLineString" and len(lines["coordinates"]) == len(ours.fixed_edges) == 17
    whole = constrained_triangulation(GROUND, LINE)
    assert len(whole.__geo_interface__["coordinates"]) == 1
    assert len(whole.fixed_lines["coordinates"][0][0]) == 3
    assert constrained_triangulation([], np.eye(2)).__geo_interface__["coordinates"] == []


def test_shapely_and_geopandas():
    shapely = pytest.importorskip("shapely")
    geopandas = pytest.importorskip("geopandas")
    land = shapely.Polygon(SQUARE, [HOLE])
    road = shapely.LineString([(-1, 5), (11, 5.5)])
    ours = constrained_triangulation(GROUND[:, :2], geopandas.GeoSeries([land, road]))
    back = shapely.geometry.shape(ours)
    assert back.is_valid and back.equals(land) and len(back.geoms) == 1 and len(back.geoms[0].interiors) == 1
    assert set(ours.geometry_of) == {0, 1}
    fixed = shapely.geometry.shape(ours.fixed_lines)
    assert fixed.length == pytest.approx(land.length + road.length)
    steep = shapely.LineString([(0, 0, 1), (9, 8, 2)])
    assert constrained_triangulation(GROUND, steep).points[-1].tolist() == [9, 8, 2]


BAD = [
    ([LINE, mapping("LineString", [[0, 0, 0], [1, np.nan, 0]])], InputError,
     r"lines\[1\], vertex 1: \(1.0, nan, 0.0\)"),
    (mapping("Polygon", [SQUARE, [(1, 1), (2, np.inf), (2, 1)]]), InputError, "lines, ring 1, vertex 1"),
    ([[[0, 0], [1, 1]]], TypeError, r"lines\[0\]\[0\]\[0\] is no geometry: a geometry has __geo_interface__"),
    ([LINE, LINE[:1]], InputError, r"lines\[1\] has 1 point\(s\): a line takes 2 or more"),
    (mapping("Polygon", [[(0, 0), (1, 1), (0, 0)]]), InputError, r"ring 0 has 2 point\(s\): a ring takes 3 or more"),
    (mapping("MultiLineString", [[(0, 0), (1, 1, 1)]]), InputError, "lines, part 0: coordinates cannot be read"),
    ([LINE, OTHER[:, :2]], InputError, r"lines have 2 coordinates or 3, .* lines\[0\] has 3 and lines\[1\] has 2"),
    ([], InputError, "lines is empty"),
    ({"type": "GeometryCollection", "geometries": []}, InputError, "lines is empty"),
    ([LINE, mapping("LineString", [])], InputError, r"lines\[1\] is empty"),
    ({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": None}]}, TypeError,
     r"features\[0\] has no"),
    (mapping("Point", [0, 0]), TypeError, "lines is a Point, and no line"),
    ({"type": "Circle"}, TypeError, "lines is no geometry: its type is 'Circle'"),
    ({"type": "Polygon"}, TypeError, "lines is a Polygon without a list of coordinates"),
    ({"type": "LineString"}, TypeError, "lines has no list of coordinates, but a NoneType"),
    ("LINESTRING (0 0, 1 1)", TypeError, "not of type str"),
    (7, TypeError, "not of type int"),
    (np.zeros((3, 4)), InputError, "lines: points are an array of n by 3 or n by 2"),
]


@pytest.mark.parametrize("lines, error, sentence", BAD)
def test_bad_lines(lines, error, sentence):
    with pytest.raises(error, match=sentence):
        constrained_triangulation(GROUND, lines)


def test_other_bad_input():
    itself = []
    itself.append(itself)
    with pytest.raises(TypeError, match="nested more than 100 levels"):
        constrained_triangulation(GROUND, itself)
    with pytest.raises(InputError, match="lines have heights, and points have none"):
        constrained_triangulation(GROUND[:, :2], LINE)
    with pytest.raises(TypeError, match="closed_lines_as_borders is True or False"):
        constrained_triangulation(GROUND, LINE, closed_lines_as_borders="yes")
    bad = GROUND.copy()
    bad[3, 0] = np.nan
    with pytest.raises(InputError, match="first at point 3"):
        constrained_triangulation(bad, LINE)
    assert 3 not in constrained_triangulation(bad, LINE, non_finite="ignore").vertices
    done = []
    many = RANDOM.random((300_000, 3))
    constrained_triangulation(many, LINE, threads=1, progress=done.append)
    assert done == sorted(done) and len(done) > 1
    with pytest.raises(AbortedError):
        constrained_triangulation(many, LINE, progress=lambda fraction: False)
