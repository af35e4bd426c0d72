# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters that fail or warn, each set up as a row of Messages.md's tables says."""

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkLongLongArray, vtkStringArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkDataObject,
    vtkDataSetAttributes,
    vtkMultiBlockDataSet,
    vtkPartitionedDataSet,
    vtkPolyData,
    vtkRectilinearGrid,
    vtkTable,
)
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform

from vtkflipflop import (
    vtkFFConvexifyFilter,
    vtkFFHullFilter,
    vtkFFPointInterpolator2D,
    vtkFFPowerDiagramFilter,
    vtkFFRegularTriangulationFilter,
    vtkFFSelectEnclosedPoints,
)

from outcomes import poly_data, use_weights

TETRAHEDRON = "0 0 0; 4 0 0; 0 4 0; 0 0 4"
FACETS = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
# And beside it another, so that no point sees into both.
TWO = TETRAHEDRON + "; 9 0 0; 13 0 0; 9 4 0; 9 0 4"
FACETS_OF_TWO = FACETS + [[corner + 4 for corner in facet] for facet in FACETS]


def set_up(algorithm, data, **settings):
    for name, value in settings.items():
        getattr(algorithm, "Set" + name)(value)
    algorithm.SetInputDataObject(data)
    return algorithm


def integers(components, count, value=0):
    array = vtkLongLongArray()
    array.SetNumberOfComponents(components)
    array.SetNumberOfTuples(count)
    for i in range(components * count):
        array.SetValue(i, value)
    return array


def doubles(*values):
    array = vtkDoubleArray()
    for value in values:
        array.InsertNextValue(value)
    return array


def strings():
    array = vtkStringArray()
    array.SetNumberOfValues(3)
    return array


def hull(data, **settings):
    return set_up(vtkFFHullFilter(), data, **settings)


def hull_of_integers():
    data = poly_data("")
    data.GetPoints().SetData(integers(3, 4, 2**53 + 1))
    return hull(data)


def hull_of_a_wide_grid():
    grid = vtkRectilinearGrid()
    grid.SetDimensions(2, 1, 1)
    grid.SetXCoordinates(integers(1, 2, 2**53 + 1))
    grid.SetYCoordinates(integers(1, 1))
    grid.SetZCoordinates(integers(1, 1))
    return hull(grid)


def hull_of_a_bare_grid():
    grid = vtkRectilinearGrid()
    grid.SetDimensions(3, 2, 2)
    return hull(grid)


def hull_of_pairs():
    data = poly_data("0 0 0; 1 0 0")
    data.GetPoints().GetData().SetNumberOfComponents(2)
    return hull(data)


def hull_with_two_marks():
    data = poly_data("0 0 0; 1 0 0; 0 1 0")
    marks = vtkUnsignedCharArray()
    marks.SetName("vtkGhostType")
    marks.SetNumberOfValues(2)
    data.GetPointData().AddArray(marks)
    return hull(data)


def planar(kind, points="0 0 0; 1 0 0; 0 1 0", **settings):
    return set_up(kind(), poly_data(points), **settings)


def triangulation(**settings):
    return planar(vtkFFRegularTriangulationFilter, **settings)


def weighted(array, **settings):
    algorithm = triangulation(**settings)
    if array:
        array.SetName("weight")
        algorithm.GetInput().GetPointData().AddArray(array)
    return use_weights(algorithm)


def weighted_by(association, attribute):
    algorithm = weighted(strings())
    algorithm.SetInputArrayToProcess(0, 0, 0, association, attribute)
    return algorithm


def scaled(*factors):
    matrix = vtkMatrix4x4()
    for i, factor in enumerate(factors):
        matrix.SetElement(i, i, factor)
    transform = vtkTransform()
    transform.SetMatrix(matrix)
    return transform


def flattened(kind, **settings):
    """By a transform that has no inverse."""
    return planar(kind, Transform=scaled(1, 1, 0), ProjectionPlaneMode=PLANE, **settings)


def triangulation_of(points, **settings):
    return planar(vtkFFRegularTriangulationFilter, points, **settings)


def selection(surface):
    algorithm = set_up(vtkFFSelectEnclosedPoints(), poly_data(TETRAHEDRON))
    algorithm.SetSurfaceData(surface)
    return algorithm


def selection_by_a_table():
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, vtkTable())
    return selection(blocks)


def interpolation(source):
    algorithm = set_up(vtkFFPointInterpolator2D(), poly_data(TETRAHEDRON))
    algorithm.SetSourceData(source)
    algorithm.SetInputArrayToProcess(0, 1, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "weight")
    return algorithm


def interpolation_of(points):
    algorithm = vtkFFPointInterpolator2D()
    algorithm.SetInputData(poly_data(TETRAHEDRON))
    algorithm.SetSourceData(poly_data(points))
    return algorithm


def constrained(lines, polygons=(), points="0 -3 0; 1 0 0; 0 3 0; -1 0 0", **settings):
    """With a source of lines and polygons."""
    source = vtkPolyData()
    for add, cells in ((source.SetLines, lines), (source.SetPolys, polygons)):
        array = vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell))
            for point in cell:
                array.InsertCellPoint(point)
        add(array)
    algorithm = planar(vtkFFRegularTriangulationFilter, points, **settings)
    algorithm.SetSourceData(source)
    return algorithm


def constrained_with_points(points, **settings):
    algorithm = constrained([[0, 2]], **settings)
    algorithm.GetSource().SetPoints(poly_data(points).GetPoints())
    return algorithm


def constrained_by_damaged_lines():
    algorithm = constrained([[0, 2]])
    algorithm.GetSource().GetLines().GetConnectivityArray().SetNumberOfTuples(1)
    return algorithm


def constrained_to_a_ghost():
    algorithm = constrained([[0, 1]])
    marks = vtkUnsignedCharArray()
    marks.SetName("vtkGhostType")
    for mark in (0, vtkDataSetAttributes.DUPLICATEPOINT, 0, 0):
        marks.InsertNextValue(mark)
    algorithm.GetInput().GetPointData().AddArray(marks)
    return algorithm


def constrained_with_weights():
    algorithm = constrained([[0, 1]])
    weights = doubles(0.0, 1.0, 2.0, 3.0)
    weights.SetName("weight")
    algorithm.GetInput().GetPointData().AddArray(weights)
    return use_weights(algorithm)


def surface_of_lines():
    algorithm = surface([])
    lines = vtkCellArray()
    lines.InsertNextCell(2)
    lines.InsertCellPoint(0)
    lines.InsertCellPoint(1)
    algorithm.GetInput().SetLines(lines)
    return algorithm


def surface_without_its_last_corner():
    algorithm = surface(FACETS)
    corners = algorithm.GetInput().GetPolys().GetConnectivityArray()
    corners.SetNumberOfTuples(corners.GetNumberOfTuples() - 1)
    return algorithm


def surface(facets, points=TETRAHEDRON, **settings):
    data = poly_data(points)
    cells = vtkCellArray()
    for facet in facets:
        cells.InsertNextCell(len(facet))
        for corner in facet:
            cells.InsertCellPoint(corner)
    data.SetPolys(cells)
    return set_up(vtkFFConvexifyFilter(), data, **settings)


def surface_with_a_vertex(facets):
    algorithm = surface(facets)
    vertex = vtkCellArray()
    vertex.InsertNextCell(1)
    vertex.InsertCellPoint(0)
    algorithm.GetInput().SetVerts(vertex)
    return algorithm


NAN = float("nan")
INTEGER = 2**53 + 1  # no double
PLANE = vtkFFRegularTriangulationFilter.TRANSFORM_PLANE
FITTING = vtkFFRegularTriangulationFilter.BEST_FITTING_PLANE
RADII = vtkFFRegularTriangulationFilter.RADII
IGNORE = vtkFFRegularTriangulationFilter.NON_FINITE_IGNORE
BOUNDS = vtkFFPowerDiagramFilter.BOX_OF_BOUNDS
DIRECTION = vtkFFRegularTriangulationFilter.DIRECTION
CUDA = vtkFFHullFilter.ENGINE_CUDA
POINTS, CELLS = vtkDataObject.FIELD_ASSOCIATION_POINTS, vtkDataObject.FIELD_ASSOCIATION_CELLS

FAILURES = {
    "points of two coordinates": hull_of_pairs,
    "a coordinate is NaN or infinite": lambda: hull(poly_data("0 0 0; nan 0 0")),
    "an integer coordinate that no double holds": hull_of_integers,
    "a rectilinear grid without its coordinates": hull_of_a_bare_grid,
    "an integer coordinate of such a grid": hull_of_a_wide_grid,
    "two marks for three points": hull_with_two_marks,
    "a coordinate or a weight is NaN": lambda: triangulation_of("0 0 0; nan 0 0"),
    "the same after a projection": lambda: triangulation_of("0 0 0; nan 0 0", ProjectionPlaneMode=FITTING),
    "the array of weights is missing": lambda: weighted(None),
    "weights are strings": lambda: weighted(strings()),
    "weights of two components": lambda: weighted(integers(2, 3)),
    "two weights for three points": lambda: weighted(integers(1, 2)),
    "weights of cells": lambda: weighted_by(CELLS, "weight"),
    "weights are the active scalars, which are not there": lambda: weighted_by(
        POINTS, vtkDataSetAttributes.SCALARS
    ),
    "an integer weight that no double holds": lambda: weighted(integers(1, 3, INTEGER)),
    "an integer radius that no double holds": lambda: weighted(integers(1, 3, INTEGER), WeightMode=RADII),
    "a negative radius": lambda: weighted(doubles(0.0, -1.0, -2.0), WeightMode=RADII),
    "a radius whose square no double holds": lambda: weighted(doubles(1e200, 0.0, 0.0), WeightMode=RADII),
    "a weight that a factor takes too far": lambda: weighted(doubles(0.0, 1e300, 0.0), WeightFactor=1e10),
    "a factor of weights that is NaN": lambda: weighted(doubles(0.0, 0.0, 0.0), WeightFactor=NAN),
    "a projection by transform, without one": lambda: triangulation(ProjectionPlaneMode=PLANE),
    "a box of the power diagram without an inside": lambda: planar(
        vtkFFPowerDiagramFilter, PowerDiagramBoxMode=BOUNDS, PowerDiagramBounds=(0, 0, 0, 1)
    ),
    "a power diagram after a flat transform": lambda: flattened(vtkFFPowerDiagramFilter),
    "centroids after a flat transform": lambda: flattened(
        vtkFFRegularTriangulationFilter, GenerateCellMeasures=True
    ),
    "points without cells, as a surface": lambda: surface([]),
    "vertices alone, as a surface": lambda: surface_with_a_vertex([]),
    "lines alone, as a surface": surface_of_lines,
    "a vertex cell beside polygons": lambda: surface_with_a_vertex(FACETS),
    "a used point is NaN": lambda: surface(FACETS, TETRAHEDRON[:-1] + "nan"),
    "cells with a corner too few": surface_without_its_last_corner,
    "a polygon of two points": lambda: surface([[0, 1], *FACETS]),
    "a triangle with a corner twice": lambda: surface([*FACETS, [0, 1, 1]]),
    "a polygon that crosses itself": lambda: surface([[0, 1, 2, 3], *FACETS], "0 0 0; 1 1 0; 1 0 0; 0 1 0"),
    "a triangle is missing": lambda: surface(FACETS[:3]),
    "a triangle is there three times": lambda: surface([FACETS[0], FACETS[0], *FACETS]),
    "a triangle is turned over": lambda: surface([FACETS[0][::-1], *FACETS[1:]]),
    "the kernel point is outside": lambda: surface(
        FACETS, KernelPoint=(9, 9, 9), UseKernelPoint=True
    ),
    "the kernel point is on a triangle": lambda: surface(
        FACETS, KernelPoint=(1, 1, 0), UseKernelPoint=True
    ),
    "the kernel point is not finite": lambda: surface(
        FACETS, KernelPoint=(NAN, 0, 0), UseKernelPoint=True
    ),
    "no point sees all triangles": lambda: surface(FACETS_OF_TWO, TWO),
    "a table among the blocks of a surface": selection_by_a_table,
    "a coordinate of a surface is NaN or infinite": lambda: selection(poly_data("0 0 0; nan 0 0")),
    "a source without its array of weights": lambda: interpolation(poly_data(TETRAHEDRON)),
    "a coordinate of a source is NaN or infinite": lambda: interpolation_of("0 0 0; 1 0 0; 0 inf 0"),
    "constraints with a corner too few": constrained_by_damaged_lines,
    "a constraint to a point that is not there": lambda: constrained([[0, 9]]),
    "a constraint to a ghost point": constrained_to_a_ghost,
    "a constraint to a point that is NaN": lambda: constrained(
        [[0, 1]], points="0 -3 0; nan 0 0; 0 3 0; -1 0 0", NonFinitePoints=IGNORE
    ),
    "constraints that cross": lambda: constrained([[0, 2], [1, 3]]),
    "polygons that disagree": lambda: constrained(
        [],
        [[0, 1, 2, 3], [4, 5, 6, 7]],
        points="0 0 0; 9 0 0; 9 9 0; 0 9 0; 3 3 0; 6 3 0; 6 6 0; 3 6 0",
        PolygonRule=DIRECTION,
    ),
    "a polygon that crosses itself, by direction": lambda: constrained(
        [],
        [[0, 1, 3, 2]],
        points="0 0 0; 2 0 0; 2 2 0; 0 2 0",
        SplitCrossingConstraints=True,
        PolygonRule=DIRECTION,
    ),
    "constraints with points of their own": lambda: constrained_with_points(
        "0 -3 0; 1 0 0; 0 3.5 0; -1 0 0", SourcePoints=vtkFFRegularTriangulationFilter.INPUT_POINTS
    ),
    "constraints with too few points": lambda: constrained_with_points("0 -3 0"),
    "constraints and weights": constrained_with_weights,
    "the CUDA engine, where there is none": lambda: hull(poly_data("0 0 0"), Engine=CUDA),
    "the CUDA engine for constraints": lambda: constrained([[0, 1]], Engine=CUDA),
}
WARNINGS = {
    "polygons with no inside": lambda: constrained([], [[0, 1, 2], [0, 1, 2]]),
    "the same by direction": lambda: constrained([], [[0, 3, 2, 1]], PolygonRule=DIRECTION),
    "points in one vertical plane": lambda: triangulation_of("0 0 0; 1 1 0; 0 0 1"),
    "points that a transform puts on a line": lambda: planar(
        vtkFFRegularTriangulationFilter, Transform=scaled(1, 0, 1), ProjectionPlaneMode=PLANE
    ),
}
