# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Voronoi cells in a polygon, weighted cells, and cells of prescribed areas: cells.py"""

import numpy as np

from vtkflipflop.arrays import power_diagram, prescribed_areas

rng = np.random.default_rng(3)
sites = rng.random((100, 2))
pentagon = [(0, 0), (2, 0), (3, 1), (1, 3), (-0.5, 1)]

voronoi = power_diagram(sites, domain=pentagon)
print(f"{len(voronoi)} cells, area {voronoi.areas.sum():.6f}")
largest = voronoi.areas.argmax()
corners = voronoi.vertices[voronoi.regions[largest]]
print(f"the largest is that of site {voronoi.sites[largest]}, with the corners {corners.round(2).tolist()}")

# Weights are squared lengths: a site of a larger weight has a larger cell. A box may be given by two corners.
power = power_diagram(sites, rng.random(100) * 0.01, domain=[(0, 0), (1, 1)])
print(f"{len(power)} cells of 100 sites, area {power.areas.sum():.6f}")

# Weights with which each cell has its share of the area.
found = prescribed_areas(sites, np.arange(1, 101), domain=pentagon)
print(f"{found.iterations} steps; the last cell has {found.areas[-1] / found.areas[0]:.3f} times the area of the first")
assert found.converged and abs(found.areas[-1] / found.areas[0] - 100) < 1e-3
