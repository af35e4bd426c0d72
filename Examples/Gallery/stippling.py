# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture drawn in dots (A. Secord, "Weighted Voronoi stippling", 2002): each dot moves to the middle of its ink."""

import numpy as np
import pyvista as pv
from _common import INK, look, plotter, write

from vtkflipflop.arrays import regular_triangulation

# A ball that is lit from the left and above, and its shadow on the ground: how dark is each pixel, 0 to 1?
SIZE = 800
x, y = (np.stack(np.meshgrid(np.arange(SIZE), np.arange(SIZE)), -1).reshape(-1, 2).T + 0.5) / SIZE
u, v = (x - 0.45) / 0.3, (y - 0.6) / 0.3
front = np.sqrt(np.clip(1 - u**2 - v**2, 0, None))
light = np.clip(-0.5 * u + 0.6 * v + 0.62 * front, 0, 1)
shadow = 0.75 * np.exp(-((((x - 0.58) / 0.3) ** 2 + ((y - 0.27) / 0.07) ** 2) ** 2))
darkness = np.where(front > 0, 0.97 * (1 - light) ** 1.5 + 0.03, shadow)

# What is nearly white needs no dot. At first, pixels are drawn at random, dark ones more often.
DOTS = 3000
grey = (255 * (1 - darkness)).astype(np.uint8)
is_inked = darkness > 0.002
x, y, darkness = x[is_inked], y[is_inked], darkness[is_inked]
pixels = np.column_stack([x, y])
rng = np.random.default_rng(2002)
dots = pixels[rng.choice(len(pixels), DOTS, replace=False, p=darkness / darkness.sum())]


def owners_of(dots):
    """The dot of each pixel, and how far its ink is away: the root of the mean square."""
    owners = regular_triangulation(dots).nearest(pixels)
    squares = ((pixels - dots[owners]) ** 2).sum(axis=1)
    return owners, np.sqrt(np.average(squares, weights=darkness))


owners, before = owners_of(dots)
print(f"{DOTS:,} dots at random: ink is {100 * before:.2f}% of the width away from its dot")
away = before
for _ in range(60):
    ink = np.bincount(owners, darkness, DOTS)
    moved = [np.bincount(owners, darkness * axis, DOTS) / np.maximum(ink, 1e-9) for axis in (x, y)]
    dots = np.where(ink[:, None] > 0, np.column_stack(moved), dots)
    owners, nearer = owners_of(dots)
    assert nearer <= away + 1e-12
    away = nearer
print(f"in the middle of their ink: {100 * away:.2f}%")
assert away < 0.8 * before

scene = plotter(2, (1000, 540))
picture = pv.ImageData(dimensions=(SIZE + 1, SIZE + 1, 1), spacing=(1 / SIZE, 1 / SIZE, 1))
picture.cell_data["grey"] = np.column_stack([grey, grey, grey])
scene.subplot(0, 0)
scene.add_mesh(picture, scalars="grey", rgb=True, lighting=False)
scene.add_mesh(picture.outline(), color=INK)
look(scene, (0, 0, 1), (0, 1, 0), "a picture")
scene.subplot(0, 1)
disks = pv.PolyData(np.column_stack([dots, np.zeros(DOTS)])).glyph(
    geom=pv.Disc(inner=0, outer=0.0034, c_res=12), orient=False, scale=False
)
scene.add_mesh(disks, color=INK, lighting=False)
scene.add_mesh(picture.outline(), color=INK)
look(scene, (0, 0, 1), (0, 1, 0), f"{DOTS:,} dots")
write(scene, "gallery-stippling.png")
