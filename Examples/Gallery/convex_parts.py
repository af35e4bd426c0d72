# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A figure in convex parts, as a physics engine wants it: the hull of each block."""

import numpy as np
import pyvista as pv
from _common import look, plotter, read, write

from vtkflipflop.pyvista import convex_hull

figure = read("spot.vtp")
xyz = figure.points.astype(float)

# Centres of parts by k-means, from points each as far as can be from those before.
centres = xyz[:1]
while len(centres) < 24:
    away = np.linalg.norm(xyz[:, None] - centres, axis=2).min(axis=1)
    centres = np.vstack([centres, xyz[away.argmax()]])
for _ in range(20):
    away = np.linalg.norm(xyz[:, None] - centres, axis=2)
    centres = np.array([xyz[away.argmin(axis=1) == i].mean(axis=0) for i in range(len(centres))])

# A point belongs to each part that is nearly as near as the nearest: no gaps are left.
near = away <= 1.2 * away.min(axis=1, keepdims=True)
parts = pv.MultiBlock({f"part {i}": pv.PolyData(xyz[near[:, i]]) for i in range(len(centres))})
hulls = convex_hull(parts)
assert hulls.keys() == parts.keys()
for part, hull in zip(parts, hulls):
    assert np.array_equal(part.points[hull["vtkOriginalPointIds"]], hull.points)

# One hull of all blocks is the figure's; each of its points tells the block that it is from.
whole = convex_hull(parts, composite_mode="all_blocks")
assert set(map(tuple, whole.points)) == set(map(tuple, convex_hull(figure).points))
blocks = len(np.unique(whole["BlockIndex"]))
print(f"{len(hulls)} hulls have {sum(hull.n_points for hull in hulls):,} points")
print(f"one hull of all has {whole.n_points}, which are from {blocks} of the parts")
print(f"its volume is {whole.volume / sum(hull.volume for hull in hulls):.1f} times theirs")

scene = plotter(2, (1000, 480))
colours = ["#a6cee3", "#fdd89a", "#bde0a8", "#d6c4e6", "#f5d0c8", "#cfdcdc", "#f3eba6"]
for panel, (apart, title) in enumerate(((0, f"{len(hulls)} hulls"), (0.35, "moved apart"))):
    scene.subplot(0, panel)
    for i, hull in enumerate(hulls):
        scene.add_mesh(hull.translate(apart * centres[i]), color=colours[i % len(colours)])
    look(scene, (1.0, 0.3, -0.75), (0, 1, 0), title)
write(scene, "gallery-convex-parts.png")
