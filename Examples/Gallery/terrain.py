# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A terrain's points, a mesh of some of them within a tolerance of all, and a raster."""

import numpy as np
import pyvista as pv
from _common import HEIGHTS, INK, look, plotter, read, write

from vtkflipflop.arrays import regular_triangulation
from vtkflipflop.pyvista import terrain_mesh

TOLERANCE, PIXEL = 20.0, 25.0  # metres

mountain = read("sainthelens.vtp")
height = mountain["Elevation"].astype(float)
mesh, others = terrain_mesh(mountain, tolerance=TOLERANCE, return_hidden_points=True)
assert mesh.n_points + others.n_points == mountain.n_points
errors = abs(others["TerrainError"])
assert errors.max() <= TOLERANCE
print(f"{mesh.n_points:,} of {mountain.n_points:,} points are within {TOLERANCE:g} m of all")
print(f"the others are {errors.mean():.1f} m from the mesh on average, and at most {errors.max():.1f} m")

# Of all points, by a smooth surface through them.
every = regular_triangulation(mountain.points[:, :2])
raster = every.to_image(height, spacing=PIXEL, method="clough-tocher")
print(f"{raster.array.shape[1]} x {raster.array.shape[0]} pixels of {PIXEL:g} m")

# Light from the north-west, 45 degrees high, on slopes of the same heights as in the other panels.
down, right = np.gradient(1.5 * raster.array, PIXEL)
light = (np.array([-1, 1, np.sqrt(2)]) / 2).reshape(3, 1, 1)
normal = np.array([-right, down, np.ones_like(down)])
shade = np.clip((normal * light).sum(axis=0) / np.linalg.norm(normal, axis=0), 0, 1)
low, high = np.percentile(height, (1, 99))
colours = HEIGHTS((raster.array - low) / (high - low))[..., :3] * (0.25 + 0.95 * shade[..., None])
picture = pv.ImageData(dimensions=(*raster.array.shape[::-1], 1))
picture.point_data["colours"] = (255 * colours[::-1].clip(0, 1)).reshape(-1, 3).astype(np.uint8)

scene = plotter(3, (1300, 360))
by_height = {"scalars": "Elevation", "cmap": HEIGHTS, "clim": (low, high)}
for data in (mountain, mesh):
    data.points[:, 2] *= 1.5
view = (0.7, 0.9, 0.75)
scene.subplot(0, 0)
scene.add_mesh(mountain, point_size=4, lighting=False, **by_height)
look(scene, view, text=f"{mountain.n_points:,} points")
scene.subplot(0, 1)
scene.add_mesh(mesh, show_edges=True, edge_color=INK, edge_opacity=0.5, **by_height)
look(scene, view, text=f"{mesh.n_points:,} of them, within {TOLERANCE:g} m of all")
scene.subplot(0, 2)
scene.add_mesh(picture, scalars="colours", rgb=True, lighting=False)
look(scene, (0, 0, 1), (0, 1, 0), text=f"a raster, {PIXEL:g} m a pixel")
write(scene, "gallery-terrain.png")
