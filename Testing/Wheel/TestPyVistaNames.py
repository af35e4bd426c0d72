# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop.pyvista's arguments: named as those of vtkflipflop.arrays, and with the same meaning."""

import inspect
import typing

import numpy as np
import pytest

import vtkflipflop.arrays
from pyvista_meshes import cloud
from vtkflipflop.pyvista import (
    centroidal_cells,
    constrained_triangulation,
    convex_hull,
    convexify,
    power_diagram,
    prescribed_areas,
    refined_mesh,
    regular_triangulation,
    terrain_mesh,
)

FUNCTIONS = (
    convex_hull, convexify, regular_triangulation, constrained_triangulation, power_diagram, centroidal_cells,
    prescribed_areas, refined_mesh, terrain_mesh,
)  # fmt: skip
# Of a mesh, an argument may be a point array's name; and what comes first is not one of arrays.
OWN_TYPES = {"points", "mesh", "surface", "triangles", "weights", "heights", "areas", "constraints", "domain", "box",
             "kernel", "maximum_area", "regions"}


@pytest.mark.parametrize("function", FUNCTIONS)
def test_arguments_have_the_names_of_the_array_layer(function):
    """What both have is called the same, in the same order, with the same default and the same type."""
    here = inspect.signature(function).parameters
    there = inspect.signature(getattr(vtkflipflop.arrays, function.__name__)).parameters
    common = [name for name in there if name in here]
    missing = set(there) - set(here)
    # Lines and polygons come in one mesh; a surface has its triangles. Meshes to refine may have cells of few points.
    # Meshes have one unit.
    lacking = {refined_mesh: {"degenerate"}, regular_triangulation: {"rescale"}}.get(function, set())
    assert missing <= {"points", "polygons", "triangles", "constraints", "lines", "holes", *lacking}
    assert "threads" in common and "progress" in common
    for name in common:
        assert here[name].default == there[name].default, name
        if name not in OWN_TYPES:
            types = [typing.get_type_hints(one)[name] for one in (function,
                                                                  getattr(vtkflipflop.arrays, function.__name__))]
            assert types[0] == types[1] or types[1] is str, name  # or a Literal of strings
    # What is called otherwise there: within_edge_length(limit).
    own = {"composite_mode", "projection_plane_mode", "transform", "radii", "weight_factor", "maximum_edge_length",
           "return_hidden_points", "skip_ghost_points", "pass_point_data", "alpha", "split_crossings",
           "closed_lines_as_borders", "non_finite"}
    assert set(here) - set(there) <= {"mesh", "surface", *own}


def test_0_and_none_are_off():
    flat = cloud(100)
    flat.point_data["radius"] = np.full(100, 0.001)
    whole = regular_triangulation(flat).n_cells
    for name in ("alpha", "maximum_edge_length"):
        for value in (None, 0, 0.0, np.inf):
            assert regular_triangulation(flat, **{name: value}).n_cells == whole
            assert regular_triangulation(flat, radii="radius", **{name: value}).n_cells == whole
        assert regular_triangulation(flat, **{name: 1e-9}).n_cells == 0
