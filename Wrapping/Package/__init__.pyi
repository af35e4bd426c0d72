# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
from typing import Any, Literal

from . import arrays as arrays
from . import pyvista as pyvista
from . import spatial as spatial
from ._filters import vtkFFAlgorithm as vtkFFAlgorithm
from ._filters import vtkFFConvexifyFilter as vtkFFConvexifyFilter
from ._filters import vtkFFHullAlgorithm as vtkFFHullAlgorithm
from ._filters import vtkFFHullFilter as vtkFFHullFilter
from ._filters import vtkFFMeshFilter as vtkFFMeshFilter
from ._filters import vtkFFPlanarAlgorithm as vtkFFPlanarAlgorithm
from ._filters import vtkFFPointInterpolator2D as vtkFFPointInterpolator2D
from ._filters import vtkFFPointsToImage as vtkFFPointsToImage
from ._filters import vtkFFPowerDiagramFilter as vtkFFPowerDiagramFilter
from ._filters import vtkFFQueryAlgorithm as vtkFFQueryAlgorithm
from ._filters import vtkFFRegularTriangulationFilter as vtkFFRegularTriangulationFilter
from ._filters import vtkFFSelectEnclosedPoints as vtkFFSelectEnclosedPoints
from ._filters import vtkFFTerrainMeshFilter as vtkFFTerrainMeshFilter

__version__: str
vtk_classes: Literal["compiled", "python"] | None
# The compiled classes alone.
vtkFFStreamedWriter: Any
vtkPFFHullFilter: Any
vtkPFFPowerDiagramFilter: Any
vtkPFFRegularTriangulationFilter: Any
