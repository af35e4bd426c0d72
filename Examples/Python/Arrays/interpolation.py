# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights between scattered measurements, some of which are masked: interpolation.py"""

import numpy as np

from vtkflipflop.arrays import regular_triangulation

rng = np.random.default_rng(2)
positions = rng.random((10_000, 2))
heights = np.sin(5 * positions[:, 0]) * positions[:, 1]
triangulation = regular_triangulation(positions)
print(f"{len(triangulation.simplices)} triangles")

# At the nodes of a grid; NaN outside the convex hull of the positions.
x, y = np.meshgrid(np.linspace(0.1, 0.9, 9), np.linspace(0.1, 0.9, 9))
nodes = np.column_stack([x.ravel(), y.ravel()])
truth = np.sin(5 * nodes[:, 0]) * nodes[:, 1]
for method in ("linear", "natural"):
    found = triangulation.interpolate(heights, nodes, method)
    print(f"{method}: off by {abs(found - truth).max():.1e} at most")
    assert abs(found - truth).max() < 0.01

# A masked value, as rasterio reads no data, is NaN: so is what it would enter.
masked = np.ma.array(np.where(positions[:, 0] < 0.5, -9999, heights), mask=positions[:, 0] < 0.5)
found = triangulation.interpolate(masked, nodes)
print(f"{np.isnan(found).sum()} of {len(nodes)} nodes are NaN")
assert np.isnan(found[nodes[:, 0] < 0.45]).all() and not np.isnan(found[nodes[:, 0] > 0.55]).any()
