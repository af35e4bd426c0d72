# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""From a mountain to its convex hull: the more heights weigh, the fewer points appear."""

from _common import HEIGHTS, INK, look, plotter, read, write

from vtkflipflop.pyvista import convex_hull, regular_triangulation

mountain = read("sainthelens.vtp")
height = mountain["Elevation"].astype(float)

# The corners of the hull's facets that face up.
hull = convex_hull(mountain)
facing_up = hull.regular_faces[hull.face_normals[:, 2] > 1e-6]
summits = set(hull["vtkOriginalPointIds"][facing_up.ravel()])

scene = plotter(3, (1350, 380))
before = set(range(mountain.n_points))
for panel, scale in enumerate((0, 2**12, 2**40)):
    surface = regular_triangulation(mountain, scale * height)
    appear = set(surface["vtkOriginalPointIds"])
    print(f"weights of {scale:,} m x height: {surface.n_points:,} points appear")
    assert summits <= appear <= before
    before = appear

    scene.subplot(0, panel)
    surface.points[:, 2] *= 1.5
    lines = {"show_edges": panel > 0, "edge_color": INK, "edge_opacity": 0.4}
    scene.add_mesh(surface, scalars="Elevation", cmap=HEIGHTS, **lines)
    look(scene, (0.7, 0.9, 0.75), text=f"{surface.n_points:,} points")
print(f"always among them: the {len(summits)} corners of the hull's upper side")
write(scene, "gallery-mountain-to-hull.png")
