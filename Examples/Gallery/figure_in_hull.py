# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scanned figure in its convex hull, whose facets are checked in whole numbers."""

import numpy as np
from _common import BLUE, ORANGE, look, plotter, read, write

from vtkflipflop.pyvista import convex_hull

figure = read("spot.vtp")
hull = convex_hull(figure, facets="polygons")
ids = hull.point_data["vtkOriginalPointIds"]
assert np.array_equal(figure.points[ids], hull.points)

# Each float is a whole number of 2^-149, and Python's integers round nothing.
whole = np.vectorize(int, otypes=[object])(figure.points.astype(float) * 2.0**149)
facets = [ids[face] for face in hull.irregular_faces]
for facet in facets:
    a, b, c = whole[facet[:3]]
    above = (whole - a) @ np.cross(b - a, c - a)
    assert (above <= 0).all(), "a point lies outside"
    assert set(ids[above[ids] == 0]) == set(facet), "a facet is not flat, or in pieces"

quads = sum(len(facet) == 4 for facet in facets)
print(f"{figure.n_points:,} points, {hull.n_points} of them corners of the hull")
print(f"{len(facets)} facets, {quads} of them with four corners")

scene = plotter(2, (1000, 500))
points = {"point_size": 8, "render_points_as_spheres": True}
scene.add_mesh(hull, color="#9cc3f2", opacity=0.3)
scene.add_points(figure.points, color="#a87a5c", **points)
look(scene, (1.0, 0.3, -0.75), (0, 1, 0), f"{figure.n_points:,} points")
scene.subplot(0, 1)
scene.add_mesh(hull, color="#b9d3f5", show_edges=True, edge_color=BLUE)
scene.add_points(hull.points, color=ORANGE, **points)
look(scene, (1.0, 0.3, -0.75), (0, 1, 0), f"{hull.n_points} corners, {hull.n_cells} facets")
write(scene, "gallery-figure-in-hull.png")
