# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""How deep a folded surface lies below its convex hull, to which flips take it."""

import numpy as np
import pyvista as pv
from _common import BLUE, look, plotter, write

from vtkflipflop.pyvista import convex_hull, convexify

# A sphere with waves in its radius is star-shaped, whatever the waves are.
rng = np.random.default_rng(2013)
surface = pv.Icosphere(nsub=6)
waves = np.cos(surface.points @ rng.normal(0, 6, (3, 60)) + rng.uniform(0, 2 * np.pi, 60))
surface.points *= 1 + 0.02 * waves.sum(axis=1, keepdims=True)

# From the surface by flips, or from its points alone: the same hull.
hull, again = convexify(surface), convex_hull(surface)
assert np.array_equal(hull.points, again.points) and np.array_equal(hull.faces, again.faces)

# Inside of a convex hull, the nearest of its planes is as near as its surface.
normals = hull.face_normals.astype(float)
offsets = (hull.points[hull.regular_faces[:, 0]] * normals).sum(axis=1)
depth = np.full(surface.n_points, np.inf)
for normal, offset in zip(normals, offsets):
    depth = np.minimum(depth, offset - surface.points @ normal)
assert depth.min() > -1e-6 and depth[hull["vtkOriginalPointIds"]].max() < 1e-6
print(f"depth of the surface: {depth.mean():.2f} on average, {depth.max():.2f} at most")
print(f"the surface fills {surface.volume / hull.volume:.0%} of its hull")

scene = plotter(2, (1000, 500))
scene.add_mesh(surface, scalars=depth, cmap="YlGnBu", smooth_shading=True)
look(scene, (1.0, 0.3, -0.75), (0, 1, 0), "the surface, by its depth")
scene.subplot(0, 1)
scene.add_mesh(hull, color="#f3f0c8", show_edges=True, edge_color=BLUE)
look(scene, (1.0, 0.3, -0.75), (0, 1, 0), "its hull")
write(scene, "gallery-folds.png")
