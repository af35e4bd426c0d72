# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A mountain as columns: Voronoi cells that carry their points' data."""

import numpy as np
import pyvista as pv
from _common import HEIGHTS, look, plotter, read, write

from vtkflipflop.pyvista import power_diagram

# Some of the samples; not of the rim, where the model has no data.
mountain = read("sainthelens.vtp")
inside = np.flatnonzero(mountain["Elevation"] > mountain["Elevation"].min())
chosen = np.random.default_rng(2013).choice(inside, 2000, replace=False)
samples = pv.PolyData(mountain.points[chosen])
samples["Elevation"] = mountain["Elevation"][chosen]

cells = power_diagram(samples)
assert np.array_equal(cells["Elevation"], samples["Elevation"][cells["vtkOriginalPointIds"]])
areas = cells.compute_cell_sizes()["Area"]
x_min, x_max, y_min, y_max, *_ = samples.bounds
assert np.isclose(areas.sum(), (x_max - x_min) * (y_max - y_min), rtol=1e-9)
print(f"{cells.n_cells:,} cells, {areas.sum() / 1e6:.1f} square kilometres")
print(f"mean height {np.average(cells['Elevation'], weights=areas):.0f} m, by area")

flat = cells.points * (1, 1, 0)
points, faces, heights = [], [], []
for cell, height in zip(cells.irregular_faces, cells["Elevation"]):
    bottom = len(points) + np.arange(len(cell))
    top = bottom + len(cell)
    points += [*(flat[cell] + (0, 0, 900)), *(flat[cell] + (0, 0, 1.5 * height))]
    faces += [top, *zip(bottom, np.roll(bottom, -1), np.roll(top, -1), top)]
    heights += [height] * (1 + len(cell))
columns = pv.PolyData.from_irregular_faces(np.array(points), faces)

scene = plotter(1, (900, 560))
scene.add_mesh(columns, scalars=np.array(heights), cmap=HEIGHTS)
look(scene, (0.7, 0.9, 0.75))
write(scene, "gallery-columns.png")
