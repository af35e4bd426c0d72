# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
from . import arrays as arrays
from . import pyvista as pyvista
from .vtkFiltersFlipFlop import vtkFFAlgorithm as vtkFFAlgorithm
from .vtkFiltersFlipFlop import vtkFFConvexifyFilter as vtkFFConvexifyFilter
from .vtkFiltersFlipFlop import vtkFFHullAlgorithm as vtkFFHullAlgorithm
from .vtkFiltersFlipFlop import vtkFFHullFilter as vtkFFHullFilter
from .vtkFiltersFlipFlop import vtkFFPlanarAlgorithm as vtkFFPlanarAlgorithm
from .vtkFiltersFlipFlop import vtkFFPointInterpolator2D as vtkFFPointInterpolator2D
from .vtkFiltersFlipFlop import vtkFFPointsToImage as vtkFFPointsToImage
from .vtkFiltersFlipFlop import vtkFFPowerDiagramFilter as vtkFFPowerDiagramFilter
from .vtkFiltersFlipFlop import vtkFFQueryAlgorithm as vtkFFQueryAlgorithm
from .vtkFiltersFlipFlop import vtkFFRegularTriangulationFilter as vtkFFRegularTriangulationFilter
from .vtkFiltersFlipFlop import vtkFFSelectEnclosedPoints as vtkFFSelectEnclosedPoints
from .vtkFiltersFlipFlop import vtkFFStreamedWriter as vtkFFStreamedWriter
from .vtkFiltersFlipFlop import vtkFFTerrainMeshFilter as vtkFFTerrainMeshFilter
from .vtkFiltersParallelFlipFlop import vtkPFFHullFilter as vtkPFFHullFilter
from .vtkFiltersParallelFlipFlop import vtkPFFPowerDiagramFilter as vtkPFFPowerDiagramFilter
from .vtkFiltersParallelFlipFlop import vtkPFFRegularTriangulationFilter as vtkPFFRegularTriangulationFilter

__version__: str
