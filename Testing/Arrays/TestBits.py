# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The array layer's results have the bits of the VTK filters', by the baseline of Testing/Python/TestOutputs.py."""

import hashlib
import re
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Python"))
import given  # noqa: E402

from vtkflipflop.arrays import convex_hull, convexify, regular_triangulation  # noqa: E402

BASELINE = {}
for line in given.BASELINE.read_text().splitlines():
    digest, case, part = re.fullmatch(r"(\w+)  (.*?); (.*)", line).groups()
    BASELINE.setdefault(case, {})[part.removeprefix("port 0, ")] = digest

# What arrays have no counterpart of: the data that come along with a data set's points.
CARRIED = re.compile(r".*(Elevation|weight|Verts).*")

INPUTS = {name: (points, weights) for name, points, weights in given.made()}
for name in ("autzen", "sainthelens", "spot"):
    points = given.read_points(f"{name}.vtp")
    INPUTS[name] = points, given.weights_of(points)


def kind_of(points):
    return {"f4": "float", "f8": "double"}[points.dtype.str[1:]]


def cells(vertices, polygons):
    """As a data set has them: corners count among its own points."""
    yield "Polys Offsets", polygons.offsets
    yield "Polys Connectivity", np.searchsorted(vertices, polygons.connectivity)


def triangles(simplices):
    offsets = np.arange(0, simplices.size + 1, 3)
    return type("Triangles", (), {"offsets": offsets, "connectivity": simplices.ravel()})


def chosen(points, ids):
    yield f"points {kind_of(points)}", points[ids]
    yield "Point data vtkOriginalPointIds idtype 1", ids


def hull_parts(hull, polygons):
    yield from chosen(hull.points, hull.vertices)
    yield from cells(hull.vertices, polygons)
    yield "Volume", np.float64(hull.volume)
    yield "Area", np.float64(hull.area)


def compare(case, parts):
    found = {part: hashlib.sha256(np.ascontiguousarray(value).tobytes()).hexdigest() for part, value in parts}
    expected = {part: digest for part, digest in BASELINE[case].items() if not CARRIED.match(part)}
    assert found == expected


@pytest.mark.parametrize("name", INPUTS)
def test_hull(name):
    for facets in ("triangles", "polygons"):
        hull = convex_hull(INPUTS[name][0], facets=facets)
        compare(f"hull, triangles: {name}", hull_parts(hull, triangles(hull.simplices)))
        compare(f"hull, polygons: {name}", hull_parts(hull, hull.polygons))


@pytest.mark.parametrize("name", INPUTS)
@pytest.mark.parametrize("weighted", [False, True])
def test_triangulation(name, weighted):
    points, weights = INPUTS[name]
    one = regular_triangulation(points, weights if weighted else None, facets="polygons")
    diagram = one.power_diagram()

    def parts():
        yield from chosen(points, one.vertices)
        yield from cells(one.vertices, triangles(one.simplices))
        for part, value in chosen(points, one.hidden):
            if len(one.hidden) or not part.startswith("points"):  # a data set without points has no type of them
                yield f"port 1, {part}", value

    def diagram_parts():
        lowest = np.full(len(diagram.vertices), points[:, 2].min() + 0.0, np.float64)
        yield "points double", np.column_stack([diagram.vertices, lowest])
        yield "Polys Offsets", diagram.cells.offsets
        yield "Polys Connectivity", diagram.cells.connectivity
        yield "Cell data vtkOriginalPointIds idtype 1", diagram.sites

    kind = "weight" if weighted else "none"
    compare(f"triangulation, {kind}: {name}", parts())
    compare(f"power diagram, {kind}: {name}", diagram_parts())



def test_convexify():
    hull = convex_hull(INPUTS["uniform"][0])
    corners = hull.points[hull.vertices]
    again = convexify(corners, np.searchsorted(hull.vertices, hull.simplices))

    compare("convexify: uniform", hull_parts(again, triangles(again.simplices)))
