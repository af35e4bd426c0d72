# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The convex hull of a million points, and how far others are from it: hull.py"""

import numpy as np

from vtkflipflop.arrays import convex_hull

points = np.random.default_rng(1).standard_normal((1_000_000, 3))
hull = convex_hull(points)
print(f"{len(points)} points, {len(hull.vertices)} vertices, {len(hull.simplices)} triangles, volume {hull.volume:.3f}")

# Ids are rows of the caller's array.
corners = points[hull.simplices]
print(f"the first triangle has the corners {hull.simplices[0]}, at {np.round(corners[0], 2).tolist()}")

distances = hull.distance([[0, 0, 0], [10, 0, 0]])  # negative inside, 0 on the surface, positive outside
print(f"the origin is {-distances[0]:.3f} inside, (10, 0, 0) is {distances[1]:.3f} outside")
assert distances[0] < 0 < distances[1]

first, second, length = hull.diameter()
print(f"the vertices {first} and {second} are farthest apart: {length:.3f}")
