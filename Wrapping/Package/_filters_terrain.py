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
from ._filter_base import TakesLines, Task, block_for, reports
from ._filter_errors import SettingError, naming
from ._filter_settings import VTK_ID_MAX, Choice, Flag, Setting, identifier, number, with_settings
from ._filters_hull import vtkFFAlgorithm
from ._input import column_of
from ._mesh_joined import Part
from ._mesh_source import Source, SourceRule, of_source
from ._mesh_terrain import Survey, meshes_of_terrain
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
    Setting("MaximumNumberOfVertices", 0, identifier, 0, VTK_ID_MAX),
)
class vtkFFTerrainMeshFilter(TakesLines, vtkFFAlgorithm):
    """A triangulation of some of the points, from which no other is farther, vertically, than a tolerance: exactly."""

    _title, _ports = "Terrain mesh", (2, 2)

    def _execute(self, data: Any, inputs: Any, task: Task) -> None:
        with naming("A coordinate or a height"):
            self._make(data, inputs, task)

    def _make(self, data: Any, inputs: Any, task: Task) -> None:
        run = self._run()
        self._use_cpu(run, "terrain meshes are the CPU's")
        limits, source = self._limits(), self._source(inputs, task)
        heights = self._heights_of(data, task, "input") if data.IsA("vtkDataSet") else None
        cloud = run.cloud(block_for(data, task))
        levels = run.weights(cloud, Weights(heights, False, 1.0), "height")
        part = run.parts(cloud, task.progress)
        survey = None
        if source is None:
            ends = np.empty((0, 2), np.int64)
            arguments = cloud.array, levels, ends, *limits[:2], part(0.0, 1.0), limits[2]
            found, _ = cloud.engine(_core.terrain_mesh, *arguments)
        else:
            survey = self._survey(cloud, levels, source, task, part)
            found = survey.mesh(limits, part(0.2, 1.0))
        self._write(found, cloud, survey, task)
        run.core = SimpleNamespace(dimension=found["dimension"], statistics=found["statistics"])
        self._report_on(task, run, **self._figures(found, survey, task))

    def _survey(self, cloud: Cloud, levels: Any, mesh: Any, task: Task, part: Part) -> Survey:
        chosen = self._settings
        source = Source(mesh, cloud, SourceRule(chosen["SourcePoints"], 2, False), part(0.0, 0.0))
        own = None
        if source.is_own and len(source.points):  # what is wrong with these is reported first
            heights = self._heights_of(mesh, task, "source")
            with of_source():
                own = None if heights is None else column_of(heights, "height", True)[0]
        return Survey(cloud, levels, mesh, source, own, chosen["SplitCrossingConstraints"], part)

    def _write(self, found: dict[str, Any], cloud: Cloud, survey: Survey | None, task: Task) -> None:
        whole = cloud if survey is None else survey.cloud

        def points_of(rows: Ids) -> Any:
            made = whole.mesh(whole.ids(rows), self._settings["PassPointData"])
            self._finish_ids(made.GetPointData())
            if survey is not None:
                survey.add_marks(made, rows)
            return made

        for port, made in enumerate(meshes_of_terrain(found, points_of, True)):
            task.adopt(port, made)

    def _figures(self, found: dict[str, Any], survey: Survey | None, task: Task) -> dict[str, Any]:
        """Those of the report, and the same for field data."""
        report = task.report
        report.GreatestError = found["greatest_error"]
        report.NumberOfPointsBeyond, report.NumberOfUnreachablePoints = found["beyond"], found["unreachable"]
        if survey is not None:
            report.NumberOfSplitPoints, report.NumberOfAddedPoints = survey.crossings, survey.added
            report.NumberOfHeightDifferences = survey.differing
        names = "PointsBeyond", "UnreachablePoints", "SplitPoints", "AddedPoints", "HeightDifferences"
        counts = {name: getattr(report, f"NumberOf{name}") for name in names}
        return {"Tolerance": found["tolerance"], "GreatestError": report.GreatestError, **counts}

    def _heights_of(self, data: Any, task: Task, owner: str) -> Any:
        """The numbers of the array of heights; None: heights are z."""
        array = array_to_process(self, data, f" of {task.name}" if task.name else "", owner, "height")
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
