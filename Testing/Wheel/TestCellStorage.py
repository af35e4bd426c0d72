# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cell arrays as VTK 9.6 and later may store them: of one size, and with ids of any type."""

import numpy as np
import pytest
import pyvista as pv

from vtkflipflop.pyvista import convexify

pytestmark = pytest.mark.skipif(pv.vtk_version_info < (9, 6), reason="VTK before 9.6 stores cells in one way")


def starlike():
    surface = pv.Sphere(theta_resolution=9, phi_resolution=9).triangulate()
    surface.points *= 1 + 0.2 * np.random.default_rng(4).random((surface.n_points, 1))
    return surface


@pytest.mark.parametrize("kind", [np.int16, np.int32, np.int64])
@pytest.mark.parametrize("one_size", [True, False])
def test_surface(kind, one_size):
    surface = starlike()
    corners = surface.faces.reshape(-1, 4)[:, 1:]
    ids = pv.convert_array(np.ascontiguousarray(corners, kind).ravel(), deep=True)
    cells = pv.CellArray()
    if one_size:
        assert cells.SetData(3, ids)
    else:
        offsets = np.arange(0, 3 * len(corners) + 1, 3).astype(np.int16)
        assert cells.SetData(pv.convert_array(offsets, deep=True), ids)
    data = pv.PolyData()
    data.SetPoints(surface.GetPoints())
    data.SetPolys(cells)
    expected = convexify(surface)
    hull = convexify(data)
    assert np.array_equal(hull.faces, expected.faces)
    assert np.array_equal(hull.points, expected.points)
