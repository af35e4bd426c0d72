# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of PyVista that several tests take."""

import numpy as np
import pyvista as pv


def random_points(count, seed=7):
    return np.random.default_rng(seed).random((count, 3))


def cloud(count=500):
    mesh = pv.PolyData(random_points(count))
    mesh.point_data["heat"] = np.arange(count, dtype=np.float32)
    return mesh


def starlike(seed=2):
    surface = pv.Sphere(theta_resolution=20, phi_resolution=20).triangulate()
    surface.points *= 1 + 0.2 * np.random.default_rng(seed).random((surface.n_points, 1))
    return surface


def rotation():
    """Takes y to z, and x to twice itself."""
    return np.array([[2.0, 0, 0, 1], [0, 0, -1, 2], [0, 1, 0, 3], [0, 0, 0, 1]])
