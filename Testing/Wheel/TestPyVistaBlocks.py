# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.pyvista: composites with blocks at fault. The other blocks have their results."""

import numpy as np
import pytest
import pyvista as pv

import vtkflipflop.arrays
from pyvista_meshes import cloud, random_points, starlike
from vtkflipflop.pyvista import (
    InputError,
    centroidal_cells,
    convex_hull,
    convexify,
    power_diagram,
    prescribed_areas,
    regular_triangulation,
)


def spoilt(count, bad):
    """Blocks of points, of which some have a NaN at point 3. Block k has the flat index k + 1."""
    blocks = pv.MultiBlock([cloud(10 + k % 7) for k in range(count)])
    for k in bad:
        points = random_points(10)
        points[3, 1] = np.nan
        blocks[k] = pv.PolyData(points)
    return blocks


@pytest.mark.parametrize("function", (convex_hull, regular_triangulation, power_diagram))
def test_one_of_many_blocks_is_at_fault(function):
    blocks = spoilt(199, [90])
    with pytest.raises(InputError,
                       match="first at point 3 of the block .*flat index 91.*; no result: 1 of 199") as raised:
        function(blocks)
    error = raised.value
    assert (error.code, error.index, error.count) == ("non_finite", 3, 1)
    assert list(error.errors) == [91]
    assert error.result.n_blocks == 199
    for k, block in enumerate(blocks):
        if k == 90:
            assert error.result[k] is None
        else:
            assert error.result[k] == function(block)


def test_several_blocks_are_at_fault():
    blocks = spoilt(30, range(0, 30, 3))
    with pytest.raises(InputError) as raised:
        regular_triangulation(blocks, return_hidden_points=True)
    assert "no result: 10 of 30 blocks, of flat index 1, 4, 7, 10, 13, 16, 19, 22 and 2 more; " in str(raised.value)
    assert list(raised.value.errors) == list(range(1, 31, 3))
    shown, hidden = raised.value.result
    assert [block is None for block in shown] == [block is None for block in hidden] == [k % 3 == 0 for k in range(30)]
    # One hull of all needs all; and where no block has a result there is none.
    for call in (lambda: convex_hull(blocks, composite_mode="all_blocks"), lambda: convex_hull(spoilt(3, range(3)))):
        with pytest.raises(InputError, match="first at point 3 of the block") as raised:
            call()
        assert raised.value.result is None
    # An abort is none of a block's.
    with pytest.raises(vtkflipflop.arrays.AbortedError) as raised:
        regular_triangulation(pv.MultiBlock([blocks[0], cloud(200_000)]), progress=lambda fraction: False)
    assert raised.value.result is None


def test_transport_and_surfaces_in_blocks():
    for function in (centroidal_cells, prescribed_areas):
        with pytest.raises(InputError, match="flat index 2") as raised:
            function(spoilt(4, [1]))
        assert [block is None for block in raised.value.result] == [False, True, False, False]
    surfaces = pv.MultiBlock([starlike(), pv.Plane(), starlike(3), random_points(4)])
    with pytest.raises(InputError, match="no result: 2 of 4 blocks") as raised:
        convexify(surfaces)
    assert list(raised.value.errors) == [2, 4]
    assert [block is None for block in raised.value.result] == [False, True, False, True]
