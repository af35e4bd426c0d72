# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Questions to hulls and triangulations of arrays, beside scipy and beside brute force."""

import itertools

import numpy as np
import pytest
import scipy.spatial

from vtkflipflop.arrays import (
    InputError, OutOfMemoryError, Side, convex_hull, convex_hulls, power_diagram, regular_triangulation
)  # fmt: skip

RANDOM = np.random.default_rng(9)
CUBE = np.array(list(itertools.product((0.0, 2.0), repeat=3)))
SQUARE = CUBE[:4, 1:]
LATTICE = np.stack(np.meshgrid(*3 * [np.arange(-1, 4)], indexing="ij"), -1).reshape(-1, 3)


# Hulls ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("ndim", [2, 3])
def test_neighbors_and_equations_are_scipys(ndim):
    points = RANDOM.random((200, ndim))
    ours, other = convex_hull(points), scipy.spatial.ConvexHull(points)
    place = {frozenset(cell): i for i, cell in enumerate(other.simplices.tolist())}
    for i, cell in enumerate(ours.simplices.tolist()):
        j = place[frozenset(cell)]
        assert np.allclose(ours.equations[i], other.equations[j], rtol=0, atol=1e-13)
        for corner, neighbor in zip(cell, ours.neighbors[i]):
            theirs = other.neighbors[j][other.simplices[j].tolist().index(corner)]
            assert place[frozenset(ours.simplices[neighbor].tolist())] == theirs


@pytest.mark.parametrize("flat", [False, True])
def test_sides_of_a_lattice(flat):
    """Every kind of place: corners, edges, faces, inside, outside."""
    hull, places = (convex_hull(SQUARE), LATTICE[:, :2]) if flat else (convex_hull(CUBE), LATTICE)
    expected = np.where(((places > 0) & (places < 2)).all(axis=1), Side.INSIDE, Side.ON)
    expected[((places < 0) | (places > 2)).any(axis=1)] = Side.OUTSIDE
    assert np.array_equal(hull.side(places), expected) and hull.side(places).dtype == np.int8
    assert np.array_equal(np.sign(hull.distance(places)), -expected)
    assert hull.side(places[0]) == Side.OUTSIDE and np.ndim(hull.side(places[0])) == 0
    contains = hull.contains(places)
    assert contains.dtype == bool and np.array_equal(contains, expected >= 0)
    assert np.array_equal(places[contains], [place for place in places if hull.contains(place)])


@pytest.mark.parametrize("ndim", [2, 3])
def test_measures_of_hulls(ndim):
    """The engine's tests hold these; here is their form."""
    points = RANDOM.integers(0, 4, (40, ndim))
    hull = convex_hull(points)
    directions = np.array(list(itertools.product((-2, -1, 0, 1, 2), repeat=ndim)))
    reach = directions @ points[hull.vertices].T
    assert ((directions * points[hull.support(directions)]).sum(axis=1) == reach.max(axis=1)).all()
    places = RANDOM.random((100, ndim)) * 9 - 3
    heights = places @ hull.equations[:, :-1].T + hull.equations[:, -1]
    inside = hull.side(places) > 0
    assert np.allclose(hull.distance(places)[inside], heights[inside].max(axis=1), rtol=0, atol=1e-13)
    assert (hull.distance(places)[~inside] >= heights[~inside].max(axis=1) - 1e-13).all()
    first, second, length = hull.diameter()
    assert first < second and length == scipy.spatial.distance.pdist(points).max()
    box = hull.minimal_box()
    assert np.allclose(box.axes @ box.axes.T, np.eye(ndim), rtol=0, atol=1e-14)
    assert (np.abs((points - box.center) @ box.axes.T) <= box.lengths / 2 + 1e-13).all()
    assert box.lower_bound <= box.volume <= np.ptp(points, axis=0).prod() * (1 + 1e-13)
    assert (np.diff(box.lengths) <= 0).all()


@pytest.mark.parametrize(
    "points", [CUBE[:0], CUBE[:1], CUBE[:2], CUBE[:4], SQUARE[:0], SQUARE[:1], SQUARE[:2]], ids=range(7)
)
def test_hulls_of_less(points):
    hull = convex_hull(points)
    places = RANDOM.random((10, points.shape[1])) + 5
    assert (hull.side(places) == Side.OUTSIDE).all() and not hull.contains(places).any()
    assert (hull.distance(places) > 0).all()
    assert (hull.side(points) == Side.ON).all() and hull.contains(points).all()
    assert (hull.distance(points) == 0).all()
    assert set(hull.support(places)) <= ({-1} if not len(points) else set(hull.vertices))
    assert hull.neighbors.shape == hull.simplices.shape
    assert hull.diameter().first == (-1 if not len(points) else min(hull.vertices))
    assert len(hull.equations) == (len(hull.simplices) if hull.dimension >= hull.ndim - 1 else 0)
    assert np.isfinite(hull.equations).all()


@pytest.mark.parametrize("shape", [[], [[3, 4]], [[3, 4]] * 2, [[0, 0], [6, 8], [3, 4]], [[3, 0], [0, 4], [3, 0]],
                                   [[2, 1], [2, 0]]])
def test_flat_hulls_are_alike_in_the_plane_and_in_space(shape):
    """The same cells; a hull of one dimension less than its space has its equation and its measure, once."""
    flat = np.reshape(np.array(shape, float), (-1, 2))
    plane, space = convex_hull(flat), convex_hull(np.column_stack([flat, np.full(len(flat), 7.0)]))
    (other,) = convex_hulls(flat, [0, len(flat)])
    for hull in (plane, other):
        for name in ("dimension", "vertices", "simplices", "neighbors", "edges", "volume", "certificate"):
            assert np.array_equal(getattr(hull, name), getattr(space, name)), name
        assert [ring.tolist() for ring in hull.polygons] == [ring.tolist() for ring in space.polygons]
        assert np.shape(hull.simplices) == np.shape(space.simplices)
        assert hull.area == hull.diameter().length == space.diameter().length
        assert hull.equations.shape == ((1, 3) if hull.dimension == 1 else (0, 3))
        for *normal, offset in hull.equations:
            assert np.hypot(*normal) == pytest.approx(1) and normal[::-1] > [0, 0]
            assert np.allclose(flat @ normal + offset, 0, rtol=0, atol=1e-14)


def test_places_at_fault():
    hull, flat, triangulation = convex_hull(CUBE), convex_hull(SQUARE), regular_triangulation(SQUARE)
    bad = np.ones((3, 3))
    bad[1, 0] = np.nan
    for ask in (hull.contains, hull.distance, hull.support, triangulation.locate, triangulation.nearest):
        with pytest.raises(InputError, match="first at point 1"):
            ask(bad)
    assert hull.side(bad, non_finite="ignore").tolist() == [1, -1, 1]
    assert hull.contains(bad, non_finite="ignore").tolist() == [True, False, True]
    assert np.isnan(hull.distance(bad, non_finite="ignore")).tolist() == [False, True, False]
    assert triangulation.locate(bad, non_finite="ignore")[1] == -1
    for ask, places in (
        (hull.contains, SQUARE),
        (flat.contains, CUBE),
        (flat.side, CUBE[:0]),
        (flat.support, [1, 2, 3]),
        (triangulation.locate, np.ones((2, 3, 4))),
    ):
        with pytest.raises(ValueError,
                           match=r"are an array of shape \(..., [23]\) here, .* [23] coord.*; not of shape"):
            ask(places)


def test_places_of_any_shape():
    hull, triangulation = convex_hull(CUBE), regular_triangulation(RANDOM.random((30, 2)))
    flat, space = RANDOM.random((3, 4, 5, 2)), RANDOM.random((3, 4, 3)) * 3
    for ask, places in (
        (hull.contains, space),
        (hull.side, space),
        (hull.distance, space),
        (hull.support, space),
        (convex_hull(SQUARE).side, flat * 3),
        (convex_hull(SQUARE).support, flat),
        (triangulation.locate, flat),
        (triangulation.find_simplex, flat),
        (triangulation.nearest, flat),
        (triangulation.nearest, space),
    ):
        found, rows = ask(places), ask(places.reshape(-1, places.shape[-1]))
        assert found.shape == places.shape[:-1] and found.dtype == rows.dtype
        assert np.array_equal(found.ravel(), rows)
        assert np.array_equal(ask(places.tolist()), found)
        assert ask(places[:0]).shape == (0, *places.shape[1:-1])
        one = ask(places.reshape(-1, places.shape[-1])[0])
        assert np.ndim(one) == 0 and isinstance(one, np.generic) and one == rows[0]
    masked = np.ma.array(space, mask=False)
    masked[1, 2] = np.ma.masked
    assert not hull.contains(masked)[1, 2] and hull.side(masked)[1, 2] == -1


def test_a_tuple_of_arrays_could_be_points_or_coordinates():
    hull, triangulation = convex_hull(CUBE), regular_triangulation(SQUARE)
    xs, ys, zs = RANDOM.random((3, 2))
    for ask, places in (
        (triangulation.locate, (xs, ys)),
        (triangulation.locate, (xs.tolist(), ys.tolist())),
        (triangulation.nearest, (xs, ys, zs)),
        (lambda places: triangulation.interpolate(range(4), places), (xs, ys)),
        (hull.contains, (xs, ys, zs)),
    ):
        with pytest.raises(ValueError, match=r"a tuple of [23] arrays could be points or coordinates: write numpy"):
            ask(places)
    assert triangulation.locate((1, 1)) >= 0 and triangulation.locate((xs[0], ys[0])) >= 0
    assert triangulation.locate(((1, 1), (1, 1), (1, 1), (1, 1))).shape == (4,)


# Triangulations ---------------------------------------------------------------------------------------------------


def test_neighbors_of_triangles_are_scipys():
    points = RANDOM.random((300, 2))
    ours, other = regular_triangulation(points), scipy.spatial.Delaunay(points)
    place = {frozenset(cell): i for i, cell in enumerate(other.simplices.tolist())}
    for i, cell in enumerate(ours.simplices.tolist()):
        j = place[frozenset(cell)]
        for corner, neighbor in zip(cell, ours.neighbors[i]):
            theirs = other.neighbors[j][other.simplices[j].tolist().index(corner)]
            assert (neighbor < 0) == (theirs < 0)
            assert neighbor < 0 or place[frozenset(ours.simplices[neighbor].tolist())] == theirs
    assert {frozenset(edge) for edge in ours.convex_hull.tolist()} == {
        frozenset(edge) for edge in other.convex_hull.tolist()
    }
    starts, links = ours.vertex_neighbor_vertices
    their_starts, their_links = other.vertex_neighbor_vertices
    assert np.array_equal(starts, their_starts)
    for i in range(300):
        assert links[starts[i] : starts[i + 1]].tolist() == sorted(their_links[starts[i] : starts[i + 1]])
    assert all(i in ours.simplices[ours.vertex_to_simplex[i]] for i in range(300))


@pytest.mark.parametrize("facets", ["triangles", "polygons"])
def test_locate(facets):
    points = RANDOM.random((300, 2))
    ours, other = regular_triangulation(points, facets=facets), scipy.spatial.Delaunay(points)
    places = RANDOM.random((1000, 2)) * 1.4 - 0.2
    found, theirs = ours.locate(places), other.find_simplex(places)
    assert np.array_equal(found < 0, theirs < 0)
    for mine, its in zip(found, theirs):
        assert mine < 0 or set(ours.simplices[mine]) == set(other.simplices[its])
    assert ours.find_simplex(places[0]) == found[0]


def test_nearest():
    points, weights, places = RANDOM.random((200, 2)), RANDOM.random(200) * 0.01, RANDOM.random((500, 2)) * 2 - 0.5
    power = ((places[:, None] - points[None]) ** 2).sum(axis=2)
    assert np.array_equal(regular_triangulation(points).nearest(places), power.argmin(axis=1))
    assert np.array_equal(regular_triangulation(points, weights).nearest(places), (power - weights).argmin(axis=1))


@pytest.mark.parametrize("weights", [None, RANDOM.random(100) * 1e-6], ids=["plain", "weighted"])
@pytest.mark.parametrize("method", ["linear", "natural", "clough-tocher", "laplace"])
def test_interpolate(method, weights):
    points, places = RANDOM.random((100, 2)), RANDOM.random((300, 2)) * 1.2 - 0.1
    triangulation = regular_triangulation(points, weights)
    assert len(triangulation.hidden) == 0
    plane = points @ [2.0, -3.0] + 1
    found = triangulation.interpolate(plane, places, method)
    outside = triangulation.locate(places) < 0
    assert np.array_equal(np.isnan(found), outside) and 0 < outside.sum() < 300
    assert np.allclose(found[~outside], (places @ [2.0, -3.0] + 1)[~outside], rtol=0, atol=1e-13)
    values = RANDOM.random((100, 3))
    assert np.array_equal(triangulation.interpolate(values, points, method), values)
    assert triangulation.interpolate(values, places[0], method).shape == (3,)
    assert np.ndim(triangulation.interpolate(plane, points[4], method)) == 0
    rows = triangulation.interpolate(values, places, method)
    assert np.array_equal(rows[:, 1], triangulation.interpolate(values[:, 1], places, method), equal_nan=True)
    with pytest.raises(ValueError, match="'natural', 'clough-tocher', 'laplace', not 'cubic'"):
        triangulation.interpolate(plane, places, "cubic")
    with pytest.raises(ValueError, match="values are 100 numbers or rows, not an array of shape"):
        triangulation.interpolate(plane[1:], places)


@pytest.mark.parametrize("method", ["linear", "natural", "clough-tocher", "laplace"])
def test_images(method):
    points = RANDOM.random((80, 2)) * [30, 20] + [400, -7]
    triangulation = regular_triangulation(points)
    values = RANDOM.random((80, 2))
    image = triangulation.to_image(values, spacing=(0.5, 0.75), method=method, fill_value=-1)
    a, b, c, d, e, f = image.transform
    (left, bottom), (right, top) = points.min(axis=0), points.max(axis=0)
    assert (a, b, c, d, e, f) == (0.5, 0, left, 0, -0.75, top)
    assert image.bounds[0] == left and image.bounds[3] == top
    assert 0 <= image.bounds[2] - right < 0.5 and 0 <= bottom - image.bounds[1] < 0.75
    rows, columns = image.array.shape[:2]
    # rasterio.transform.xy() of a pixel is its center.
    assert np.allclose(image.x, a * (np.arange(columns) + 0.5) + c)
    assert np.allclose(image.y, e * (np.arange(rows) + 0.5) + f)
    centers = np.stack(np.meshgrid(image.x, image.y), axis=-1)
    assert np.array_equal(image.array, triangulation.interpolate(values, centers, method, fill_value=-1))
    array, transform = triangulation.to_image(
        values[:, 0].astype(np.float32), shape=(5, 7), bounds=((410, 0), (417, 10)), method=method, threads=2
    )
    assert array.shape == (5, 7) and array.dtype == np.float32 and transform == (1, 0, 410, 0, -2, 10)
    # A length that is a whole number of pixels but for rounding.
    assert triangulation.to_image(values, spacing=0.1, bounds=(0, 0.3, 0, 0.6)).array.shape == (6, 3, 2)


def test_images_that_cannot_be():
    triangulation = regular_triangulation(SQUARE)
    for error, message, wrong in (
        (TypeError, "a spacing or a shape: give one", {}),
        (TypeError, "a spacing or a shape: give one", {"spacing": 1, "shape": (2, 2)}),
        (ValueError, "shape is 1 or more rows and columns, not 0", {"shape": (0, 2)}),
        (TypeError, "shape is two integers, rows and columns, not 3", {"shape": 3}),
        (TypeError, "shape is two integers, rows and columns; 2.5 is none", {"shape": (2, 2.5)}),
        (ValueError, "spacing is above 0, not -1", {"spacing": -1}),
        (ValueError, "spacing is 2 finite numbers", {"spacing": np.nan}),
        (ValueError, "makes too many pixels", {"spacing": 1e-300}),
        (ValueError, "bounds are a box", {"shape": (2, 2), "bounds": [[0, 0], [1, 0], [0, 1]]}),
        (TypeError, "dtype is float32 or float64, not 'int8'", {"shape": (2, 2), "dtype": "int8"}),
        (OutOfMemoryError, "^out of memory: 9223372036854775807 bytes", {"shape": (2**31, 2**31)}),
        (OutOfMemoryError, "^out of memory: 9223372036854775807 bytes", {"spacing": 1e-9}),
        (OutOfMemoryError, r"^out of memory: \d+ bytes", {"shape": (2**24, 2**24)}),
        (InputError, "^a length of 5e-324 cannot be divided into 2 pixels$",
         {"shape": (2, 2), "bounds": (0, 5e-324, 0, 1)}),
        (InputError, "^a length of inf cannot be divided into 3 pixels$",
         {"shape": (3, 2), "bounds": (0, 1, -1e308, 1e308)}),
    ):
        with pytest.raises(error, match=message):
            triangulation.to_image(range(4), **wrong)
    with pytest.raises(ValueError, match="box has no inside: give bounds"):
        regular_triangulation([[0, 0], [1, 0]]).to_image([1, 2], shape=(2, 2))
    nothing = regular_triangulation(SQUARE[:0])
    with pytest.raises(ValueError, match="an image of no point: give bounds"):
        nothing.to_image([], shape=(2, 2))
    assert np.isnan(nothing.to_image([], shape=(2, 2), bounds=(0, 1, 0, 1)).array).all()


@pytest.mark.parametrize("method", ["linear", "natural", "clough-tocher", "laplace"])
def test_values_and_places_of_any_shape(method):
    points, places = RANDOM.random((50, 2)), RANDOM.random((3, 4, 2)) * 1.4 - 0.2
    triangulation = regular_triangulation(points)
    values = RANDOM.random((50, 2, 5))
    outside = triangulation.locate(places) < 0
    assert 0 < outside.sum() < 12
    found = triangulation.interpolate(values, places, method)
    assert found.shape == (3, 4, 2, 5) and np.array_equal(np.isnan(found).all(axis=(2, 3)), outside)
    for i in range(2):
        expected = triangulation.interpolate(values[:, i], places.reshape(-1, 2), method).reshape(3, 4, 5)
        assert np.array_equal(found[..., i, :], expected, equal_nan=True)
    filled = triangulation.interpolate(values, places, method, fill_value=-1)
    assert np.array_equal(filled, np.where(outside[..., None, None], -1, found))
    assert triangulation.interpolate(values, places[0, 0], method).shape == (2, 5)
    one = triangulation.interpolate(values[:, 0, 0], [9, 9], method, fill_value=7)
    assert isinstance(one, np.float64) and one == 7
    # A value that is NaN is not outside.
    values[:] = np.nan
    filled = triangulation.interpolate(values, places, method, fill_value=-1)
    assert np.array_equal(np.isnan(filled[..., 0, 0]), ~outside)
    with pytest.raises(TypeError, match="fill_value is a number, not 'nan'"):
        triangulation.interpolate(values, places, fill_value="nan")


def test_values_of_nothing():
    triangulation, nothing = regular_triangulation(SQUARE), regular_triangulation(SQUARE[:0])
    assert triangulation.interpolate(np.empty((4, 0)), [[1, 1], [2, 2]]).shape == (2, 0)
    assert triangulation.interpolate(np.empty((4, 0, 3)), [1, 1], fill_value=2).shape == (0, 3)
    found = nothing.interpolate(np.empty((0, 3)), [[1, 1], [2, 2]])
    assert found.shape == (2, 3) and np.isnan(found).all()
    assert nothing.interpolate([], [[1, 1]]).shape == (1,)


def test_values_that_are_no_real_numbers():
    for values in (np.arange(4) + 1j, ["1"] * 4, [1, 2, 3, 4j]):
        with pytest.raises(TypeError, match="values are real numbers, not of type"):
            regular_triangulation(SQUARE).interpolate(values, [1, 1])


def test_find_simplex_names_what_it_has_not():
    for wrong in ({"tol": 1e-9}, {"bruteforce": True}):
        with pytest.raises(TypeError, match=r"find_simplex\(\) takes no .*tol: it is exact, and needs no tolerance"):
            regular_triangulation(SQUARE).find_simplex([1, 1], **wrong)


def test_measures():
    points = RANDOM.random((200, 2))
    triangulation = regular_triangulation(points)
    assert triangulation.areas.sum() == pytest.approx(convex_hull(points).volume, rel=1e-13)
    assert np.allclose(triangulation.centroids, points[triangulation.simplices].mean(axis=1), rtol=0, atol=1e-15)
    diagram = power_diagram(points, domain=(0, 1, 0, 1))
    assert diagram.areas.sum() == pytest.approx(1, rel=1e-14)
    assert np.allclose(diagram.areas @ diagram.centroids, 0.5, rtol=0, atol=1e-14)


@pytest.mark.parametrize("points", [SQUARE[:0], SQUARE[:1], SQUARE[:2], SQUARE[[0, 1, 0]]], ids=range(4))
def test_triangulations_of_less(points):
    triangulation = regular_triangulation(points)
    assert triangulation.neighbors.shape == triangulation.simplices.shape
    assert len(triangulation.convex_hull) == 0
    assert len(triangulation.areas) == len(triangulation.simplices)
    starts, links = triangulation.vertex_neighbor_vertices
    assert len(starts) == len(points) + 1 and len(links) == (2 if triangulation.dimension == 1 else 0)
    assert triangulation.locate([[9.0, 9.0]]).tolist() == [-1]
    assert triangulation.nearest([[9.0, 9.0]])[0] == (len(points[:2]) - 1 if len(points) else -1)


@pytest.mark.parametrize("method", ["natural", "laplace", "linear"])
@pytest.mark.parametrize("weighted", [False, True])
def test_natural_neighbours_have_the_shares_of_values(method, weighted):
    random = np.random.default_rng(11)
    points = random.random((200, 2))
    triangulation = regular_triangulation(points, random.random(200) * 0.01 if weighted else None)
    places = np.concatenate([random.random((50, 2)), points[:3], [[9, 9]]])
    indptr, ids, shares = triangulation.natural_neighbours(places, method)
    assert indptr[-1] == indptr[-2] == len(ids) == len(shares)
    values = random.random(200)
    for i, place in enumerate(places[:-1]):
        mine = slice(indptr[i], indptr[i + 1])
        if mine.start == mine.stop:
            assert triangulation.locate(place) < 0
            continue
        assert (np.diff(ids[mine]) > 0).all()
        assert (shares[mine] >= 0).all()
        np.testing.assert_allclose(shares[mine].sum(), 1, rtol=1e-14)
        np.testing.assert_allclose(shares[mine] @ points[ids[mine]], place, atol=1e-13)
        found = triangulation.interpolate(values, place, method)
        np.testing.assert_allclose(shares[mine] @ values[ids[mine]], found, atol=1e-14)
    with pytest.raises(ValueError, match="'natural', 'laplace', 'linear', not 'clough-tocher'"):
        triangulation.natural_neighbours(places, "clough-tocher")
    with pytest.raises(InputError, match="NaN or infinite: first at point 1"):
        triangulation.natural_neighbours([[0, 0], [np.nan, 0]])


@pytest.mark.parametrize("unit", [1.0, 1e-200, 1e200])
def test_gradients(unit):
    points = RANDOM.random((300, 2))
    x, y = points.T
    weights = np.where(np.arange(300) % 9, 0.0, -0.01)
    triangulation = regular_triangulation(points * unit, weights * unit**2 if unit > 1e-100 and unit < 1e100 else None)
    values = np.stack([x * x - 3 * x * y, x - 2 * y, 0 * x + 5], axis=1)
    wanted = np.array([[2 * x - 3 * y, 1 + 0 * x, 0 * x], [-3 * x, 0 * x - 2, 0 * x]]).T.swapaxes(1, 2)
    found = triangulation.gradients(values, threads=2) * unit
    assert found.shape == (300, 2, 3) and not triangulation.gradients(x).flags.writeable
    visible = triangulation.vertices
    np.testing.assert_allclose(found[visible], wanted[visible], atol=1e-9)
    assert np.isnan(found[triangulation.hidden]).all() and (unit != 1 or len(triangulation.hidden))
    np.testing.assert_array_equal(triangulation.gradients(values[:, 1]) * unit, found[..., 1])
    assert triangulation.gradients(values.reshape(300, 1, 3)).shape == (300, 2, 1, 3)
    assert triangulation.gradients(np.empty((300, 0))).shape == (300, 2, 0)


def test_gradients_are_the_slopes_of_the_smooth_surface():
    grid = np.mgrid[0:10, 0:10].reshape(2, -1).T
    points, values = grid + 0.6 * RANDOM.random((100, 2)), RANDOM.random(100)
    inside = ((grid > 0) & (grid < 9)).all(axis=1)  # at the border, triangles may be flat, and slopes end soon
    for triangulation in (regular_triangulation(points), regular_triangulation(points, constraints=[[3, 4]])):
        gradients = triangulation.gradients(values)
        for angle in np.linspace(0, 6, 9):
            step = 1e-7 * np.array([np.cos(angle), np.sin(angle)])
            rise = triangulation.interpolate(values, points + step, "clough-tocher") - values
            np.testing.assert_allclose(rise[inside] / 1e-7, (gradients @ step)[inside] / 1e-7, atol=1e-3)


def test_gradients_of_less():
    for points in ([], [[1, 2]], [[1, 2], [2, 4], [1, 2]]):
        flat = regular_triangulation(np.reshape(points, (-1, 2)))
        assert flat.gradients(np.ones(len(points))).shape == (len(points), 2)
        assert np.isnan(flat.gradients(np.ones(len(points)))).all()
    with pytest.raises(ValueError, match="values are 3 numbers or rows, not an array of shape"):
        flat.gradients([1, 2])
