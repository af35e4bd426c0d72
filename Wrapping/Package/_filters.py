# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The algorithms in Python, under the names of the compiled classes."""

from ._filters_hull import vtkFFAlgorithm, vtkFFConvexifyFilter, vtkFFHullAlgorithm, vtkFFHullFilter
from ._filters_image import vtkFFPointsToImage
from ._filters_mesh import vtkFFMeshFilter
from ._filters_plane import vtkFFPlanarAlgorithm, vtkFFPowerDiagramFilter, vtkFFRegularTriangulationFilter
from ._filters_queries import vtkFFPointInterpolator2D, vtkFFQueryAlgorithm, vtkFFSelectEnclosedPoints
from ._filters_terrain import vtkFFTerrainMeshFilter

__all__ = [
    "vtkFFAlgorithm",
    "vtkFFConvexifyFilter",
    "vtkFFHullAlgorithm",
    "vtkFFHullFilter",
    "vtkFFMeshFilter",
    "vtkFFPlanarAlgorithm",
    "vtkFFPointInterpolator2D",
    "vtkFFPointsToImage",
    "vtkFFPowerDiagramFilter",
    "vtkFFQueryAlgorithm",
    "vtkFFRegularTriangulationFilter",
    "vtkFFSelectEnclosedPoints",
    "vtkFFTerrainMeshFilter",
]
