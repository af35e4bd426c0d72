# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A packing of disks: Voronoi cells cut the large ones, power cells cut none."""

import numpy as np
import pyvista as pv
from _common import INK, look, plotter, write

from vtkflipflop.pyvista import power_diagram

# Disks of ever smaller radius, each at a random place where it overlaps none.
rng = np.random.default_rng(2013)
radii = np.geomspace(0.085, 0.012, 110)
centres = np.empty((0, 2))
while len(centres) < len(radii):
    radius = radii[len(centres)]
    centre = rng.uniform(radius, 1 - radius, 2)
    if (np.hypot(*(centres - centre).T) > radii[: len(centres)] + radius).all():
        centres = np.vstack([centres, centre])


def reaches_over(disk, corners):
    """Whether a disk reaches over an edge of its cell, whose corners run counter-clockwise."""
    x, y = (centres[disk] - corners).T
    u, v = (np.roll(corners, -1, axis=0) - corners).T
    return ((u * y - v * x) / np.hypot(u, v) < radii[disk] - 1e-9).any()


scene = plotter(2, (1000, 520))
square = {"box": (0, 1, 0, 1)}
for panel, (name, weights) in enumerate((("Voronoi", None), ("power", radii**2))):
    cells = power_diagram(centres, weights, **square)
    areas = cells.compute_cell_sizes()["Area"]
    owners = cells["vtkOriginalPointIds"]
    cut = [
        reaches_over(owner, cells.points[cell, :2])
        for owner, cell in zip(owners, cells.irregular_faces)
    ]
    print(f"{cells.n_cells} {name} cells, {sum(cut)} disks cut")
    assert np.isclose(areas.sum(), 1, rtol=1e-9)
    assert any(cut) == (name == "Voronoi")

    scene.subplot(0, panel)
    for disk, is_cut in zip(owners, cut):
        circle = pv.Polygon(center=(*centres[disk], 0), radius=radii[disk], n_sides=90)
        scene.add_mesh(circle, color="#f0a37f" if is_cut else "#a9c8ee", lighting=False)
    borders = cells.extract_all_edges().translate((0, 0, 0.01))
    scene.add_mesh(borders, color=INK, line_width=2)
    look(scene, (0, 0, 1), (0, 1, 0), f"{name} cells: {sum(cut)} disks cut")
write(scene, "gallery-disks.png")
