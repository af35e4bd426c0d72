# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The algorithm that makes terrain meshes."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

from . import _core
from . import _vtkmodules as vtk
from ._arguments import Weights
from ._filter_arrays import array_to_process
from ._filter_base import Task, block_for, reports
from ._filter_errors import SettingError, naming
from ._filter_settings import VTK_ID_MAX, Choice, Flag, Setting, integer, number, with_settings
from ._filters_hull import vtkFFAlgorithm
from ._mesh_terrain import meshes_of_terrain
from ._meshes import Cloud
from ._results import Ids


@reports(
    "GreatestError", "NumberOfPointsBeyond", "NumberOfUnreachablePoints", "NumberOfSplitPoints", "NumberOfAddedPoints",
    "NumberOfHeightDifferences",
)
@with_settings(
    Choice("SourcePoints", 0, AutomaticPoints="AUTOMATIC_POINTS", InputPoints="INPUT_POINTS", OwnPoints="OWN_POINTS"),
    Flag("SplitCrossingConstraints", False),
    Setting("Tolerance", -1.0, number),
    Setting("MaximumNumberOfVertices", 0, integer, 0, VTK_ID_MAX),
)
class vtkFFTerrainMeshFilter(vtkFFAlgorithm):
    """A triangulation of some of the points, from which no other is farther, vertically, than a tolerance: exactly."""

    _title, _ports = "Terrain mesh", (2, 2)

    def SetSourceData(self, source: Any) -> None:
        self.SetInputData(1, source)

    def SetSourceConnection(self, output: Any) -> None:
        self.SetInputConnection(1, output)

    def RemoveSource(self) -> None:
        self.SetInputConnection(1, None)

    def GetSource(self) -> Any:
        return self.GetInput(1)

    def _execute(self, data: Any, inputs: Any, task: Task) -> None:
        with naming("A coordinate or a height"):
            self._make(data, inputs, task)

    def _make(self, data: Any, inputs: Any, task: Task) -> None:
        run = self._run()
        self._use_cpu(run, "terrain meshes are the CPU's")
        limits = self._limits()
        heights = self._heights_of(data, f" of {task.name}" if task.name else "") if data.IsA("vtkDataSet") else None
        ignores = bool(self._settings["NonFinitePoints"])
        cloud = Cloud([block_for(data, task)], self._settings["SkipGhostPoints"], ignores)
        levels = None if heights is None else cloud.weights(Weights(heights, False, 1.0), ignores, "height")
        ends = np.empty((0, 2), np.int64)
        chosen = run.settings(cloud, task.progress)
        found = cloud.engine(_core.terrain_mesh, cloud.array, levels, ends, *limits[:2], chosen, limits[2])

        def points_of(rows: Ids) -> Any:
            made = cloud.mesh(cloud.ids(rows), self._settings["PassPointData"])
            self._finish_ids(made.GetPointData())
            return made

        for port, made in enumerate(meshes_of_terrain(found, points_of, True)):
            task.adopt(port, made)
        run.core = SimpleNamespace(dimension=found["dimension"], statistics=found["statistics"])
        report = task.report
        report.GreatestError = found["greatest_error"]
        report.NumberOfPointsBeyond, report.NumberOfUnreachablePoints = found["beyond"], found["unreachable"]
        self._report_on(
            task, run,
            Tolerance=found["tolerance"],
            GreatestError=report.GreatestError,
            PointsBeyond=report.NumberOfPointsBeyond,
            UnreachablePoints=report.NumberOfUnreachablePoints,
            SplitPoints=report.NumberOfSplitPoints,
            AddedPoints=report.NumberOfAddedPoints,
            HeightDifferences=report.NumberOfHeightDifferences,
        )

    def _heights_of(self, data: Any, of: str, owner: str = "input") -> Any:
        """The numbers of the array of heights; None: heights are z."""
        array = array_to_process(self, data, of, owner, "height")
        return None if array is None else vtk.values_of(array)

    def _limits(self) -> tuple[float, int, bool]:
        """The tolerance, how many vertices there may be, and whether the former is a fraction of the heights' range."""
        tolerance = self._settings["Tolerance"]
        if tolerance == -1.0:
            return 0.01, self._settings["MaximumNumberOfVertices"], True
        if not tolerance >= 0.0:
            raise SettingError(
                f"Tolerance is {tolerance:g}; it must be 0 or more, or -1 for a hundredth of the heights' range."
            )
        return tolerance, self._settings["MaximumNumberOfVertices"], False
