# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.pyvista: refined meshes of polygons and lines."""

import numpy as np
import pytest
import pyvista as pv

from vtkflipflop import arrays
from vtkflipflop.pyvista import InputError, refined_mesh

CORNERS = np.array([[0.0, 0, 0], [4, 0, 0], [4, 4, 4], [0, 4, 4], [1, 1, 1], [3, 1, 1], [2, 3, 3]])


def plate():
    """A square with a triangular hole; z is y."""
    mesh = pv.PolyData(CORNERS, faces=[4, 0, 1, 2, 3, 3, 4, 5, 6])
    mesh.point_data["u"] = CORNERS @ [2.0, 3.0, 0.0]
    mesh.point_data["size"] = np.full(7, 0.05)
    return mesh


def test_same_as_the_arrays():
    wanted = arrays.refined_mesh(CORNERS, polygons=[[0, 1, 2, 3], [4, 5, 6]], minimum_angle=30, maximum_area=0.1)
    found = refined_mesh(plate(), minimum_angle=30, maximum_area=0.1)
    used = np.unique(wanted.simplices)
    assert np.array_equal(used[found.regular_faces], wanted.simplices)
    assert np.array_equal(found.points[:, :2], wanted.points[used])
    assert np.array_equal(found["Area"], wanted.areas) and np.array_equal(found["MinimumAngle"], wanted.angles)
    assert set(found["Region"]) == {-1}
    assert np.array_equal(found["vtkOriginalPointIds"], np.where(used < 7, used, -1))
    assert found.points[:, 2] == pytest.approx(found.points[:, 1], abs=1e-14)
    assert found["u"] == pytest.approx(found.points @ [2.0, 3.0, 0.0], abs=1e-13)
    assert found.flipflop.refined_mesh(minimum_angle=0).n_cells > 0 if hasattr(found, "flipflop") else True


def test_areas_and_regions():
    assert refined_mesh(plate(), maximum_area="size")["Area"].max() <= 0.05
    assert refined_mesh(plate(), maximum_area=np.float64(0.1))["Area"].max() <= 0.1
    small = refined_mesh(plate(), maximum_area=lambda positions: 0.01 + 0.02 * positions[:, 0])
    assert (small["Area"] <= 0.01 + 0.02 * small.cell_centers().points[:, 0] + 1e-12).all()
    found = refined_mesh(plate(), regions=[[0.5, 0.5, 0.02]])
    assert found["Area"].max() <= 0.02 and set(found["Region"]) == {0}
    blocks = refined_mesh(pv.MultiBlock([plate(), None, plate()]), maximum_area=0.1)
    assert blocks[1] is None and blocks[0].n_cells == blocks[2].n_cells > 100


def test_lines():
    cross = pv.PolyData(CORNERS, lines=[2, 0, 2, 2, 1, 3])
    with pytest.raises(InputError, match="cell 1 of the mesh crosses one of cell 0.*Add one to the mesh .*split_cross"):
        refined_mesh(cross)
    found = refined_mesh(cross, split_crossings=True, maximum_area=0.5)
    assert found["Area"].sum() == pytest.approx(16)
    ring = pv.PolyData(CORNERS, lines=[5, 0, 1, 2, 3, 0, 4, 4, 5, 6, 4])
    assert refined_mesh(ring)["Area"].sum() == pytest.approx(16)
    assert refined_mesh(ring, closed_lines_as_borders=True)["Area"].sum() == pytest.approx(14)


def test_bad_input():
    with pytest.raises(InputError, match='the sizes\' array "none" is missing'):
        refined_mesh(plate(), maximum_area="none")
    with pytest.raises(InputError, match=r"inside of the mesh, on no constraint: regions\[1\]"):
        refined_mesh(plate(), regions=[[0.5, 0.5], [2, 2]])
    with pytest.raises(TypeError, match="a number, a point array's name or a function"):
        refined_mesh(plate(), maximum_area=[1, 2])
    with pytest.raises(TypeError, match="a PolyData is wanted"):
        refined_mesh(CORNERS)
    with pytest.raises(InputError, match="no surface: a PolyData is wanted"):
        refined_mesh(pv.ImageData(dimensions=(2, 2, 1)))
    with pytest.warns(UserWarning, match="maximum_points ended"):
        assert refined_mesh(plate(), maximum_area=1e-3, maximum_points=20).n_points <= 27
