# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A square with a hole and a fault line in it, triangulated: shape.py"""

import numpy as np

from vtkflipflop.arrays import regular_triangulation

outside = [(0, 0), (4, 0), (4, 4), (0, 4)]  # counter-clockwise
hole = [(1, 1), (1, 2), (2, 2), (2, 1)]  # clockwise
line = [(3, 0.5), (3.2, 2), (3, 3.5)]
scattered = np.random.default_rng(4).uniform(0, 4, (500, 2))
points = np.vstack([outside, hole, line, scattered])

# Polygons and constraints are ids: rows of points.
shape = regular_triangulation(points, polygons=[[0, 1, 2, 3], [4, 5, 6, 7]], constraints=[[8, 9, 10]])
area = shape.areas.sum()
print(f"{len(shape.simplices)} triangles, area {area:.6f}; {shape.dropped} triangles of the hole were left out")
assert abs(shape.areas.sum() - 15) < 1e-12
print(f"{len(shape.fixed_edges)} edges are sides or parts of the line")
assert shape.validate()
