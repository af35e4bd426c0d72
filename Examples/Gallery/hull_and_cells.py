# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scan in its convex hull, checked in whole numbers; and points with weights: triangles, power cells, the hidden."""

import numpy as np
from _common import BLUE, INK, ORANGE, look, plotter, read, write

from vtkflipflop.pyvista import convex_hull, power_diagram, regular_triangulation

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

# Disks of several sizes: the square of a radius is a weight.
rng = np.random.default_rng(2013)
sites, radii = rng.random((150, 2)) * (1.25, 1), rng.gamma(2, 0.02, 150)
triangles, hidden = regular_triangulation(sites, radii**2, return_hidden_points=True)
cells = power_diagram(sites, radii**2, box=(0, 1.25, 0, 1))
assert triangles.n_points + hidden.n_points == len(sites)
assert set(cells["vtkOriginalPointIds"]) <= set(triangles["vtkOriginalPointIds"])
print(f"{triangles.n_cells} triangles and {cells.n_cells} cells", end=" ")
print(f"of {triangles.n_points} sites, {hidden.n_points} hidden")

scene = plotter(2, (1200, 560))
dots = {"render_points_as_spheres": True}
scene.add_points(figure.points, color="#a87a5c", point_size=7, **dots)
scene.add_mesh(hull, color="#9cc3f2", opacity=0.4, culling="back")
scene.add_mesh(hull, style="wireframe", color=BLUE, opacity=0.5, culling="back")
look(scene, (1.0, 0.3, -0.75), (0, 1, 0), f"convex hull: {figure.n_points:,} points, {hull.n_points} corners")
scene.subplot(0, 1)
cells["radius"] = radii[cells["vtkOriginalPointIds"]]
scene.add_mesh(cells, scalars="radius", cmap="Blues", clim=(-0.02, 0.25), lighting=False)
scene.add_mesh(cells.extract_all_edges().translate((0, 0, 0.01)), color="white", line_width=5)
scene.add_mesh(triangles.extract_all_edges().translate((0, 0, 0.02)), color=BLUE, line_width=2)
for points, color in ((triangles.points, INK), (hidden.points, ORANGE)):
    scene.add_points(points + (0, 0, 0.03), color=color, point_size=11, **dots)
text = f"triangles and power cells of {triangles.n_points} weighted points; {hidden.n_points} hidden"
look(scene, (0, 0, 1), (0, 1, 0), text)
write(scene, "gallery-hull-and-cells.png")
