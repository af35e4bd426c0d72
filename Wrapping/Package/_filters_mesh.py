# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The algorithm that makes refined meshes."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

from . import _vtkmodules as vtk
from ._arguments import Weights
from ._errors import InputError
from ._filter_arrays import array_to_process
from ._filter_base import TakesLines, Task, block_for, data_of, reports
from ._filter_errors import SettingError
from ._filter_settings import VTK_ID_MAX, Choice, Flag, Setting, identifier, number, with_settings
from ._filters_hull import vtkFFAlgorithm
from ._mesh_refined import Refined
from ._mesh_source import Source, SourceRule
from ._meshes import Cloud
from ._results import Floats

_INPUT_POINTS = 1
_UNFINISHED = "some triangles are still thin, or too large."


@reports("NumberOfAddedPoints", "NumberOfSplitPoints", "NumberOfKeptSegments", "NumberOfKeptTriangles")
@with_settings(
    Setting("MinimumAngle", 25.0, number),
    Setting("MaximumArea", 0.0, number),
    Setting("MaximumNumberOfPoints", 0, identifier, 0, VTK_ID_MAX),
    Flag("SplitCrossingConstraints", False),
    Choice("PolygonRule", 0, EvenOdd="EVEN_ODD", Direction="DIRECTION"),
    Flag("ClosedLinesAsBorders", False),
)
class vtkFFMeshFilter(TakesLines, vtkFFAlgorithm):
    """A mesh of polygons and lines without small angles, for finite elements: exactly the triangulation of its edges."""

    _title, _ports = "Mesh", (2, 2)

    def _execute(self, data: Any, inputs: Any, task: Task) -> None:
        chosen, run = self._settings, self._run()
        self._use_cpu(run, "refined meshes are the CPU's")
        limits = self._limits()
        regions = _regions_of(data_of(inputs[1]), task)
        of = f" of {task.name}" if task.name else ""
        if not data.IsA("vtkPolyData"):
            sentence = "It must be a vtkPolyData, whose polygons and lines are meshed."
            raise InputError(f"The input{of} is a {data.GetClassName()}. {sentence}", "bad_argument")
        block = block_for(data, task)
        array = array_to_process(self, data, of, "input", "size")
        cloud = run.cloud(block)
        part = run.parts(cloud, task.progress)
        rule = SourceRule(_INPUT_POINTS, 2, chosen["ClosedLinesAsBorders"], False, True, "input")
        source = Source(data, cloud, rule, part(0.0, 0.05))
        refined = Refined(cloud, data, source, chosen["SplitCrossingConstraints"], part)
        areas = None if array is None else self._areas_of(refined.cloud, cloud, array)
        try:
            found = refined.found(limits, regions, areas, chosen["PolygonRule"] == self.DIRECTION, part(0.1, 1.0))
        except InputError as error:
            if error.code != "bad_argument" or error.index < 0:
                raise
            sentence = str(error).rsplit(": at index", 1)[0]
            raise InputError(f"Point {error.index} of the regions: {sentence}.", "bad_argument") from None
        for port, made in enumerate(refined.meshes(chosen["PassPointData"])):
            self._finish_ids(made.GetPointData())
            task.adopt(port, made)
        run.core = SimpleNamespace(dimension=found["dimension"], statistics=found["statistics"])
        if not found["is_complete"]:
            task.warnings.append(f"Maximum Number Of Points ended the refinement{of}: {_UNFINISHED}")
        figures = {
            "AddedPoints": len(found["points"]) - len(cloud.array),
            "SplitPoints": refined.crossings,
            "KeptSegments": found["kept_segments"],
            "KeptTriangles": found["kept_triangles"],
        }
        for name, value in figures.items():
            setattr(task.report, f"NumberOf{name}", value)
        self._report_on(task, run, **figures, Complete=np.int32(found["is_complete"]))

    def _limits(self) -> tuple[float, float, int]:
        """The least angle, the greatest area, and how many points there may be."""
        angle, area = self._settings["MinimumAngle"], self._settings["MaximumArea"]
        if not 0.0 <= angle <= 34.0:
            raise SettingError(f"Minimum Angle is {angle:g}; it must be from 0 to 34 degrees.")
        if not area >= 0.0:
            raise SettingError(f"Maximum Area is {area:g}; it must be above 0, or 0 for any.")
        return angle, area, self._settings["MaximumNumberOfPoints"]

    def _areas_of(self, cloud: Cloud, given: Cloud, array: Any) -> Floats | None:
        """The greatest area at each point, those where constraints cross among them."""
        values: Any = vtk.values_of(array)
        if cloud is not given:
            part = cloud.blocks[0].part
            assert part is not None
            values = vtk.values_of(array_to_process(self, part.mesh, "", "input", "size"))
        found = cloud.weights(Weights(values, False, 1.0), True, "size")
        if found is None:
            return None
        areas = np.ascontiguousarray(found, np.float64)
        wrong = np.flatnonzero(~(areas > 0.0))
        if len(wrong):
            row = int(cloud.ids(wrong[:1])[0])
            point = row if cloud.names is None else int(cloud.names[row])
            where = f" of {given.blocks[0].name}" if given.blocks[0].name else ""
            sentence = "it must be above 0, or infinite: any."
            raise InputError(f"The size of point {point}{where} is {areas[wrong[0]]:g}; {sentence}", "bad_argument")
        return areas


def _regions_of(data: Any, task: Task) -> Floats:
    """Rows of x, y, an area, and 0: of the points of the second input."""
    if data is not None and task.name:
        raise SettingError(
            "The regions are of one data set, and an input is a composite. Take one, merge them, or take the regions "
            "away."
        )
    if data is not None and not data.IsA("vtkPointSet"):
        sentence = "They must be points: a vtkPointSet."
        raise InputError(f"The regions are a {data.GetClassName()}. {sentence}", "bad_argument")
    count = 0 if data is None else data.GetNumberOfPoints()
    rows = np.zeros((count, 4))
    if count:
        rows[:, :2] = vtk.values_of(data.GetPoints().GetData()).reshape(count, 3)[:, :2]
        array = data.GetPointData().GetArray("MaximumArea")
        if array is not None:
            rows[:, 2] = [array.GetComponent(i, 0) for i in range(count)]
        wrong = np.flatnonzero(~(rows[:, 2] >= 0.0))
        if len(wrong):
            sentence = "it must be above 0, or 0 for that of all."
            area = f"{rows[wrong[0], 2]:g}"
            raise InputError(f"MaximumArea of point {wrong[0]} of the regions is {area}; {sentence}", "bad_argument")
    return rows
