# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.arrays.centroidal_cells and prescribed_areas: what they promise, by other ways to get it."""

import numpy as np
import pytest

from vtkflipflop.arrays import (
    AbortedError,
    InputError,
    centroidal_cells,
    power_diagram,
    prescribed_areas,
)

RANDOM = np.random.default_rng(5)
BOX = (0, 1, 0, 1)
HEXAGON = np.column_stack([np.cos(np.arange(6) * np.pi / 3), np.sin(np.arange(6) * np.pi / 3)])


@pytest.mark.parametrize("domain", [BOX, [[0, 0], [1, 1]], HEXAGON, HEXAGON.tolist()])
def test_areas_are_met(domain):
    points, areas = RANDOM.uniform(-1, 2, (200, 2)), RANDOM.uniform(0.5, 1.5, 200)
    found = prescribed_areas(points, areas, domain)
    assert found.converged and found.error <= 1e-6 and len(found) == 200
    cells = power_diagram(points, found.weights, domain=domain)
    assert len(cells) == 200
    wanted = areas / areas.sum() * cells.areas.sum()
    assert (abs(cells.areas / wanted - 1) <= 1.01e-6).all()
    assert np.allclose(cells.areas, found.areas, rtol=1e-9)
    assert np.allclose(cells.centroids, found.centroids, atol=1e-9)
    assert np.array_equal(found.diagram.vertices, cells.vertices)
    assert found.weights.min() == 0 and not found.weights.flags.writeable
    assert {"seconds_solving", "seconds_measuring", "seconds_triangulating", "seconds_total"} < set(found.statistics)
    assert "200 sites" in repr(found)


def test_the_default_domain_is_the_box_of_the_points():
    points = RANDOM.uniform(5, 7, (50, 2)).astype(np.float32)
    found = prescribed_areas(points)
    assert np.isclose(found.areas.sum(), np.prod(np.ptp(points.astype(float), axis=0)))
    assert np.allclose(found.areas, found.areas.mean(), rtol=2e-6)
    moved = centroidal_cells(points, iterations=3)
    assert np.isclose(moved.areas.sum(), found.areas.sum())


def test_lloyd():
    points = RANDOM.random((60, 2))
    once = centroidal_cells(points, domain=BOX, iterations=1)
    voronoi = power_diagram(points, domain=BOX)
    assert np.allclose(once.sites, voronoi.centroids, atol=1e-14)
    assert np.isclose(once.last_move, np.hypot(*(voronoi.centroids - points).T).max())
    assert np.array_equal(once.diagram.areas, once.areas) and once.without_cell == 0
    found = centroidal_cells(points, domain=BOX, iterations=5000, tolerance=1e-8)
    assert found.converged and found.iterations < 5000 and "converged" in repr(found)


def test_weights_and_sites_without_a_cell():
    points = np.array([[0.2, 0.3], [0.2, 0.3], [9, 0.5], [0.8, 0.6]])
    found = centroidal_cells(points, [0, -1, 0, 0.1], BOX, iterations=2)
    assert found.without_cell == 2 and np.array_equal(found.sites[1:3], points[1:3])
    assert np.array_equal(found.areas == 0, [False, True, True, False])
    assert np.array_equal(found.diagram.sites, [0, 3]) and found.areas[3] > found.areas[0]


def test_nothing():
    assert len(centroidal_cells(np.empty((0, 2)))) == 0
    assert prescribed_areas(np.empty((0, 2))).converged


def test_errors():
    points = np.array([[0.2, 0.3], [0.5, 0.5], [0.2, 0.3], [0.8, 0.6]])
    with pytest.raises(InputError, match="two sites are at one position: sites 0, and 2") as caught:
        prescribed_areas(points)
    assert (caught.value.code, caught.value.index, caught.value.count) == ("duplicate_sites", 0, 2)
    with pytest.raises(InputError, match="not positive and finite: first at site 1, 2 such") as caught:
        prescribed_areas(points, [1, 0, 2, -1])
    assert caught.value.code == "bad_area"
    with pytest.raises(InputError, match="there are 3 areas for 4 points") as caught:
        prescribed_areas(points, [1, 2, 3])
    assert caught.value.code == "weight_count"
    with pytest.raises(InputError, match="NaN"):
        centroidal_cells([[0, 0], [np.nan, 1]], domain=BOX)
    with pytest.raises(InputError, match="domain: the box from x = 0.0 to 0.0"):
        centroidal_cells(points, domain=(0, 0, 0, 1))
    with pytest.raises(ValueError, match="areas are n numbers"):
        prescribed_areas(points, np.ones((4, 1)))
    with pytest.raises(ValueError, match="not an array of shape"):
        centroidal_cells(points, domain=[0, 1, 2])
    with pytest.raises(ValueError, match="iterations is 0 or more"):
        centroidal_cells(points, iterations=-1)
    with pytest.raises(ValueError, match="tolerance is 0 or more"):
        prescribed_areas(points, tolerance=float("nan"))
    with pytest.raises(AttributeError, match="frozen"):
        centroidal_cells(points, domain=BOX, iterations=0).areas = None


def test_a_run_is_stopped():
    with pytest.raises(AbortedError):
        centroidal_cells(RANDOM.random((20000, 2)), iterations=1000, progress=lambda done: False)
