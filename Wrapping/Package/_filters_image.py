# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The algorithm that makes images of values between points."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from . import _core
from . import _vtkmodules as vtk
from ._filter_base import TakesLines, Task, data_of, request_all
from ._filter_errors import SettingError
from ._filter_settings import VTK_INT_MAX, Choice, Flag, Setting, integer, numbers, with_settings
from ._filter_values import INTERPOLATION_MODE, Grid, InterpolatedData, settings_of_values
from ._filters_plane import box_of, refuse_weights, vtkFFPlanarAlgorithm
from ._mesh_cells import Plane
from ._mesh_runs import Run
from ._mesh_source import Source, SourceRule
from ._projection import BestFitting
from ._results import stretch

_DataObject = vtk.module("vtkCommonDataModel").vtkDataObject
_Pipeline = vtk.module("vtkCommonExecutionModel").vtkStreamingDemandDrivenPipeline
_cross = vtk.module("vtkCommonCore").vtkMath.Cross
# Of the progress, until the triangulation is there, and until it is ready for queries.
_TRIANGULATED, _PREPARED = 0.2, 0.4
_EMPTY = Grid((0.0, 0.0), (1.0, 1.0), (0, 0))


@with_settings(
    Choice("SizeMode", 0, "By", Dimensions="SIZE_BY_DIMENSIONS", Spacing="SIZE_BY_SPACING"),
    Setting("Dimensions", (256, 256), numbers(2, integer)),
    Setting("Spacing", (1.0, 1.0), numbers(2)),
    Flag("UseInputBounds", True),
    Setting("SamplingBounds", (0.0, 1.0, 0.0, 1.0), numbers(4)),
    INTERPOLATION_MODE,
    *settings_of_values(math.nan),
)
class vtkFFPointsToImage(TakesLines, vtkFFPlanarAlgorithm):
    """An image of values between points in the plane, over their triangulation."""

    _title, _ports, _result = "Image of points", (2, 1), "vtkImageData"

    def RequestInformation(self, request: Any, inputs: Any, outputs: Any) -> int:
        info, grid = outputs.GetInformationObject(0), _EMPTY
        info.Remove(_DataObject.ORIGIN())  # of other settings, or of an image that is the input
        info.Remove(_DataObject.SPACING())
        try:
            self._check(False)
            if not self._settings["UseInputBounds"]:
                grid = self._grid_of(self._settings["SamplingBounds"])
                if self._settings["ProjectionPlaneMode"] != self.BEST_FITTING_PLANE:
                    info.Set(_DataObject.ORIGIN(), (*grid.origin, 0.0), 3)
                    info.Set(_DataObject.SPACING(), (*grid.spacing, 1.0), 3)
            elif self._settings["SizeMode"] == self.SIZE_BY_DIMENSIONS:
                grid = grid._replace(size=self._settings["Dimensions"])
        except SettingError:
            pass  # RequestData() says so
        info.Set(_Pipeline.WHOLE_EXTENT(), _extent_of(grid), 6)
        return 1

    def RequestUpdateExtent(self, request: Any, inputs: Any, outputs: Any) -> int:
        for vector in inputs:
            request_all(vector)
        return 1

    def RequestData(self, request: Any, inputs: Any, outputs: Any) -> int:
        output = data_of(outputs)
        if not output.IsA("vtkImageData"):  # a composite
            return super().RequestData(request, inputs, outputs)
        # The executive leaves the last run's scalars and geometry.
        output.GetPointData().Initialize()
        _set_geometry(_EMPTY, None, output)
        super().RequestData(request, inputs, outputs)
        # Else the executive would take an image that is smaller than announced for none.
        info = outputs.GetInformationObject(0)
        for key in (_Pipeline.WHOLE_EXTENT(), _Pipeline.UPDATE_EXTENT()):
            info.Set(key, output.GetExtent(), 6)
        return 1

    def _execute(self, data: Any, inputs: Any, task: Task) -> None:
        source = self._source(inputs, task)
        self._check(source is not None)
        run = self._run(0)  # values by natural neighbours have other last bits over polygons
        with self._named_faults():
            plane = self._plane(run, data, task, stretch(task.progress, 0.0, _TRIANGULATED))
            constrained = None if source is None else self._constrained(run, plane, source)
            core = plane.triangulated().core if constrained is None else constrained.inside()
        run.core = core
        self._warn_of_vertical_plane(plane, core, task)
        positions, result = plane.positions, task.results[0]
        task.report.NumberOfHiddenPoints = len(core.hidden())
        self._report_on(task, run, HiddenPoints=task.report.NumberOfHiddenPoints)
        part = run.parts(plane.cloud, task.progress)
        chosen = part(_TRIANGULATED, _PREPARED)
        if constrained is None:
            queries = _core.triangulation_queries(positions, plane.weights, core, chosen)
        else:
            queries = _core.constrained_queries(positions, constrained, chosen)
        cloud, arrays = plane.cloud, self._settings["PassPointData"]
        values = InterpolatedData(
            self._settings, queries, len(cloud.array), cloud.heights(), cloud.source().GetPointData() if arrays else None
        )
        box = self._settings["SamplingBounds"]
        if self._settings["UseInputBounds"]:
            if core.dimension < 0:
                return
            box = tuple(_core.triangulation_box(positions, core))
        grid = self._grid_of(box)
        rest = run.parts(cloud, stretch(task.progress, _PREPARED, 1.0))
        values.at_grid(grid, 1, rest, result.GetPointData())
        _set_geometry(grid, plane.projection, result)

    def _constrained(self, run: Run, plane: Plane, mesh: Any) -> Any:
        """The triangulation with breaklines."""
        self._use_cpu(run, "constraints are the CPU's")
        refuse_weights(plane)
        dimensions = 2 if plane.projection.is_xy else 3
        source = Source(mesh, plane.cloud, SourceRule(self.INPUT_POINTS, dimensions, False, False, False), plane.settings)
        arguments = plane.positions, source.ends, source.sides, False, None, plane.settings
        return source.engine(_core.constrained_triangulation, *arguments)

    def _check(self, has_source: bool) -> None:
        """Refuses settings that no data make right."""
        chosen = self._settings
        by_spacing = chosen["SizeMode"] == self.SIZE_BY_SPACING
        size, spacing = chosen["Dimensions"], chosen["Spacing"]
        if not by_spacing and min(size) < 1:
            raise SettingError(f"Dimensions are {size}; each must be 1 or more.")
        if by_spacing and not all(math.isfinite(length) and length > 0.0 for length in spacing):
            raise SettingError(f"Spacing is ({spacing[0]:g}, {spacing[1]:g}); it must be above 0 and finite.")
        if not chosen["UseInputBounds"]:
            box_of(chosen["SamplingBounds"], "The image's box")
        unaware = (
            chosen["InterpolationMode"] == self.NATURAL_NEIGHBOR or chosen["NullPointsStrategy"] == self.CLOSEST_POINT
        )
        if has_source and unaware:
            raise SettingError(
                "Natural neighbours and closest points do not know breaklines. Choose another, or take the source away."
            )

    def _grid_of(self, box: tuple[float, ...]) -> Grid:
        """The pixels that cover a box."""
        size, spacing = [], []
        for k in range(2):
            length = box[2 * k + 1] - box[2 * k]
            if self._settings["SizeMode"] == self.SIZE_BY_DIMENSIONS:
                count = self._settings["Dimensions"][k]
                step = length / count
            else:
                step = self._settings["Spacing"][k]
                steps = length / step - 1e-6
                if not steps <= VTK_INT_MAX:
                    raise SettingError(f"A Spacing of {step:g} makes too many pixels of a length of {length:g}.")
                count = max(1, math.ceil(steps))
            if not (math.isfinite(step) and step > 0.0):
                raise SettingError(f"A length of {length:g} cannot be divided into {count} pixels.")
            size.append(count)
            spacing.append(step)
        # Of whole pixels, the first row of an image is the lowest one; they begin at the top.
        top = box[3] - spacing[1] / 2.0 - float(size[1] - 1) * spacing[1]
        return Grid((box[0] + spacing[0] / 2.0, top), (spacing[0], spacing[1]), (size[0], size[1]))


def _extent_of(grid: Grid) -> tuple[int, ...]:
    columns, rows = grid.size
    return 0, columns - 1, 0, rows - 1, 0, 0 if columns > 0 else -1


def _set_geometry(grid: Grid, projection: Any, image: Any) -> None:
    """Where the image of a plane is in space."""
    image.SetExtent(_extent_of(grid))
    image.SetSpacing(*grid.spacing, 1.0)
    image.SetOrigin(*grid.origin, 0.0)
    x, y, z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), [0.0, 0.0, 0.0]
    if isinstance(projection, BestFitting):
        x, y = projection.axes
        image.SetOrigin(projection.to_space(np.array([grid.origin]), "the image's origin")[0].tolist())
    _cross(x, y, z)
    image.SetDirectionMatrix(*(axis[k] for k in range(3) for axis in (x, y, z)))
