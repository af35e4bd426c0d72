# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A rotated grid, far from the origin: still a cube, where tolerances make cavities."""

import numpy as np
import pyvista as pv
from _common import BLUE, look, plotter, write

from vtkflipflop.pyvista import convex_hull

# A rotation in whole numbers, 21 times as large: no coordinate is rounded, far out either.
rotation = np.array([[1, 2, 2], [2, 1, -2], [2, -2, 1]]) @ [[2, 3, 6], [3, -6, 2], [6, 2, -3]]
positions = np.stack(np.mgrid[0:11, 0:11, 0:11], axis=-1).reshape(-1, 3)

for offset in (0, 2**40):
    grid = pv.PolyData((positions @ rotation + offset).astype(float))
    grid["position"] = positions
    hull = convex_hull(grid, facets="polygons")
    assert (hull.n_cells, hull.n_points) == (6, 8)
    assert np.isin(hull["position"], (0, 10)).all()

    with pv.vtk_verbosity("off"):  # it warns of each point that it leaves out
        surface = grid.delaunay_3d().extract_surface(algorithm="geometry")
    corners = surface["position"][surface.regular_faces]
    in_a_side = ((corners == 0).all(axis=1) | (corners == 10).all(axis=1)).any(axis=1)
    inside = np.count_nonzero(~in_a_side)
    print(f"offset {offset:,}: {hull.n_cells} facets, {hull.n_points} corners;", end=" ")
    print(f"vtkDelaunay3D: {surface.n_cells:,} triangles, {inside} of them inside of the cube")

surface.points -= offset
hull.points -= offset
scene = plotter(2, (1000, 500))
sides, cavities = surface.extract_cells(in_a_side), surface.extract_cells(~in_a_side)
scene.add_mesh(sides, color="#9cc3f2", opacity=0.15, show_edges=True, edge_color=BLUE)
scene.add_mesh(cavities, color="#f07d46", show_edges=True, edge_color=BLUE)
view = (0.7, -1.1, -0.9) @ rotation, (1.0, 0.0, 0.0) @ rotation
look(scene, *view, f"vtkDelaunay3D: {inside} triangles inside")
scene.subplot(0, 1)
scene.add_mesh(hull, color="#b9d3f5", show_edges=True, edge_color=BLUE, line_width=2)
look(scene, *view, f"vtkFFHullFilter: {hull.n_cells} facets")
write(scene, "gallery-rotated-cube.png")
