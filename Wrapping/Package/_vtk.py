# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The compiled VTK classes. They are loaded only with a VTK that they fit."""

from ._vtk_check import check

check()  # before any library is loaded: with another VTK than it was built for, that would end the process

from .vtkFiltersFlipFlop import (  # noqa: E402
    vtkFFAlgorithm,
    vtkFFConvexifyFilter,
    vtkFFHullAlgorithm,
    vtkFFHullFilter,
    vtkFFMeshFilter,
    vtkFFPlanarAlgorithm,
    vtkFFPointInterpolator2D,
    vtkFFPointsToImage,
    vtkFFPowerDiagramFilter,
    vtkFFQueryAlgorithm,
    vtkFFRegularTriangulationFilter,
    vtkFFSelectEnclosedPoints,
    vtkFFStreamedWriter,
    vtkFFTerrainMeshFilter,
)
from .vtkFiltersParallelFlipFlop import (  # noqa: E402
    vtkPFFHullFilter,
    vtkPFFPowerDiagramFilter,
    vtkPFFRegularTriangulationFilter,
)

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
    "vtkFFStreamedWriter",
    "vtkFFTerrainMeshFilter",
    "vtkPFFHullFilter",
    "vtkPFFPowerDiagramFilter",
    "vtkPFFRegularTriangulationFilter",
]
