# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The ground of an airborne survey: low points weigh more, and hide trees and roofs."""

import numpy as np
from _common import HEIGHTS, look, plotter, read, write
from matplotlib.tri import LinearTriInterpolator, Triangulation

from vtkflipflop.pyvista import regular_triangulation

survey = read("autzen.vtp")
height = survey["Elevation"]
everything = regular_triangulation(survey)

# The points appear that the dome z = -(x^2 + y^2) / 400 touches, moved about below the survey.
ground, hidden = regular_triangulation(survey, -400.0 * height, return_hidden_points=True)
ids = np.concatenate([part["vtkOriginalPointIds"] for part in (ground, hidden)])
assert np.array_equal(np.sort(ids), np.arange(survey.n_points))

# No hidden point lies below the ground.
x, y, z = ground.points.T
ground_at = LinearTriInterpolator(Triangulation(x, y, ground.regular_faces), z)
above = hidden["Elevation"] - ground_at(*hidden.points[:, :2].T)
assert above.count() == hidden.n_points and above.min() > -1e-6
print(f"{survey.n_points:,} points: {ground.n_points:,} of the ground, {hidden.n_points:,} hidden")
print(f"hidden ones are up to {above.max():.0f} feet above it, on average {above.mean():.0f}")

scene = plotter(2, (1200, 400))
colours = {"scalars": "Elevation", "cmap": HEIGHTS, "clim": np.percentile(height, (1, 99))}
titles = (f"all {survey.n_points:,} points", f"{ground.n_points:,} points that appear")
for panel, (surface, title) in enumerate(zip((everything, ground), titles)):
    scene.subplot(0, panel)
    surface.points[:, 2] *= 4
    scene.add_mesh(surface, **colours)
    look(scene, (0.45, -1.0, 0.5), text=title)
write(scene, "gallery-lidar-ground.png")
