# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The algorithms that query something at points, about the points of a second input."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from . import _core
from . import _vtkmodules as vtk
from ._arguments import Weights
from ._errors import FlipFlopError
from ._filter_arrays import array_to_process, factor_of
from ._filter_base import (
    Algorithm,
    Report,
    TakesSource,
    Task,
    block_for,
    data_of,
    leaves_of_composite,
    reports,
    request_all,
)
from ._filter_errors import INPUT, NO_ERROR, naming
from ._filter_settings import VTK_INT_MAX, Choice, Flag, Setting, add_method, integer, number, numbers, with_settings
from ._filter_values import INTERPOLATION_MODE, Grid, InterpolatedData, settings_of_values
from ._filters_hull import blocks_for, name_of_block, threads_of_vtk
from ._hull import hull_queries
from ._meshes import Cloud, drop_report
from ._results import Report as Progress
from ._results import stretch

_vtkTimeStamp = vtk.module("vtkCommonCore").vtkTimeStamp


@reports("Dimension")
@with_settings(
    Setting("NumberOfThreads", 0, integer, -1, VTK_INT_MAX),
    Choice("NonFinitePoints", 0, Error="NON_FINITE_ERROR", Ignore="NON_FINITE_IGNORE"),
    Flag("SkipGhostPoints", True),
)
class vtkFFQueryAlgorithm(Algorithm):
    """What the algorithms have in common that query something at each point of their input.

    What is made of the second input is kept, until that input or a setting changes.
    """

    _ports = (2, 1)
    _result = ""
    _owner = ""  # of the second input's points, as errors name it

    def __init__(self, **settings: Any) -> None:
        self._made_time = _vtkTimeStamp()
        self._made_of: list[str] = []
        super().__init__(**settings)

    def FillInputPortInformation(self, port: int, info: Any) -> int:
        return super().FillInputPortInformation(0, info)  # both have to be there

    def RequestUpdateExtent(self, request: Any, inputs: Any, outputs: Any) -> int:
        request_all(inputs[1])
        return 1

    # ---- Of subclasses ----

    def _is_made(self) -> bool:
        """Whether something of the second input is there."""
        raise NotImplementedError

    def _drop(self) -> None:
        """Forget it."""
        raise NotImplementedError

    def _validate_source(self, data: Any, name: str) -> None:
        """Refuse a data set of the second input as it came."""

    def _query(self, data: Any, task: Task) -> None:
        """Adds what is asked for to the result, which is a shallow copy of the data."""
        raise NotImplementedError

    def _make(self, cloud: Cloud, part: Callable[[float, float], Any]) -> None:
        """Make it of these points, with the settings of each part of the run."""
        raise NotImplementedError

    _what, _share = "A coordinate", 0.4  # that may not be finite, of the second input; of the progress

    # ---- Details ----

    def _execute(self, data: Any, inputs: Any, task: Task) -> None:
        task.results[0].ShallowCopy(data)
        drop_report(task.results[0].GetFieldData())
        self._query(data, task)

    def _prepare(self, inputs: Any, progress: Progress) -> float:
        source = data_of(inputs[1])
        if source is None:
            raise FlipFlopError("There is no input. Set one.", "bad_argument")
        return self._prepare_of(source, progress)

    def _prepare_of(self, source: Any, progress: Progress) -> float:
        if self._is_current(source) and self._is_made():
            return 0.0
        self._drop()
        with naming(self._what):
            composite = source.IsA("vtkCompositeDataSet")
            name = f"the {self._owner}"
            if composite:
                for leaf, index in leaves_of_composite(source):
                    self._validate_source(leaf, name_of_block(index, f" of {name}"))
            else:
                self._validate_source(source, name)
            blocks = blocks_for(source, f" of {name}") if composite else [block_for(source, Task([], None, name))]
            cloud = Cloud(blocks, self._settings["SkipGhostPoints"], self._ignores)
            self._make(cloud, self._parts(self._ignores, stretch(progress, 0.0, self._share)))
        self._made_of = _addresses(source)
        return self._share

    @property
    def _ignores(self) -> bool:
        return bool(self._settings["NonFinitePoints"])

    def _parts(self, left_out: bool, progress: Progress) -> Callable[[float, float], Any]:
        threads = threads_of_vtk(self._settings["NumberOfThreads"])
        return lambda begin, end: _core.Settings(threads, False, left_out, 1, stretch(progress, begin, end))

    def _is_current(self, source: Any) -> bool:
        """Whether what was made last is of that source as it is, and of the settings as they are."""
        times = [self.GetMTime(), *(one.GetMTime() for one in _data_in(source))]
        if self._made_of == _addresses(source) and self._made_time.GetMTime() > max(times):
            return True
        self._made_time.Modified()  # from now on, changes count
        return False


def _as_output(kind: str) -> Callable[[Any], Any]:
    """The output, if it is of that class."""

    def getter(self: Any) -> Any:
        output = self.GetOutputDataObject(0)
        return output if output is not None and output.IsA(kind) else None

    return getter


# As vtkDataSetAlgorithm has it.
for _kind in ("PolyData", "StructuredPoints", "ImageData", "StructuredGrid", "UnstructuredGrid", "RectilinearGrid"):
    add_method(vtkFFQueryAlgorithm, f"Get{_kind}Output", _as_output(f"vtk{_kind}"))


def _data_in(source: Any) -> list[Any]:
    """A source and its blocks: a composite does not know when these change."""
    leaves = leaves_of_composite(source) if source.IsA("vtkCompositeDataSet") else ()
    return [source, *(leaf for leaf, _ in leaves)]


def _addresses(source: Any) -> list[str]:
    return [one.__this__ for one in _data_in(source)]


@with_settings(Flag("InsideOut", False), Flag("SelectPointsOnSurface", True), Flag("GenerateDistances", False))
class vtkFFSelectEnclosedPoints(vtkFFQueryAlgorithm):
    """Which points are in the convex hull of others, exactly."""

    _title, _owner = "Points in convex hull", "surface"
    _hull: Any = None  # the hull's dimension, and what answers queries

    def SetSurfaceData(self, surface: Any) -> None:
        self.SetInputData(1, surface)

    def SetSurfaceConnection(self, output: Any) -> None:
        self.SetInputConnection(1, output)

    def GetSurface(self) -> Any:
        return self.GetInput(1)

    def IsInside(self, point: int) -> int:
        """Whether the last run selected this point of the input: what its output says; 0 for a composite."""
        output = self.GetOutput()
        selected = None if output is None else output.GetPointData().GetAbstractArray("SelectedPoints")
        return int(selected.GetValue(point)) if selected and 0 <= point < selected.GetNumberOfValues() else 0

    def Initialize(self, surface: Any) -> None:
        """Prepare the hull of a surface's points, as a run does, for IsInsideSurface()."""
        self.Complete()
        self._report, self._code = Report(), NO_ERROR
        try:
            if surface is None:
                raise FlipFlopError("There is no surface. Set one.", "bad_argument")
            self._prepare_of(surface, None)
            self._report.Dimension = self._hull[0]
        except Exception as error:
            self._report = self._fail(error, "", [])

    def IsInsideSurface(self, *point: Any) -> int:
        """1 for an enclosed point, else 0; InsideOut does not matter."""
        x, y, z = numbers(3)(point[0] if len(point) == 1 else point)
        if self._hull is None:
            self._code = INPUT
            self._say("Error", "There is no surface to ask about: call Initialize() or update the filter first.")
            return 0
        found = self._hull[1].contains(np.array([[x, y, z]], np.float64), _core.Settings(1, False, True, 1, None))
        return int(self._are_enclosed(found)[0])

    def Complete(self) -> None:
        """Release the memory."""
        self._drop()

    def _is_made(self) -> bool:
        return self._hull is not None

    def _drop(self) -> None:
        self._hull = None

    def _make(self, cloud: Cloud, part: Callable[[float, float], Any]) -> None:
        core = cloud.engine(_core.convex_hull, cloud.array, part(0.0, 0.8))
        self._hull = core.dimension, cloud.engine(hull_queries, cloud.array, core, part(0.8, 1.0))

    def _query(self, data: Any, task: Task) -> None:
        cloud = Cloud([block_for(data, task)], False, self._ignores)
        part = self._parts(self._ignores, task.progress)
        dimension, queries = self._hull
        result = task.results[0]
        end = 0.3 if self._settings["GenerateDistances"] else 1.0
        sides = cloud.engine(queries.contains, cloud.array, part(0.0, end))
        arrays = result.GetPointData()
        if end < 1.0:
            distances = cloud.engine(queries.distance, cloud.array, part(end, 1.0))
            arrays.AddArray(vtk.array_of(distances, "FlipFlopDistance"))
        arrays.AddArray(vtk.copy_as("vtkSignedCharArray", sides, "FlipFlopSide"))
        selected = self._are_enclosed(sides) != self._settings["InsideOut"]
        # SetScalars() would remove the array that was active.
        index = arrays.AddArray(vtk.array_of(selected.astype(np.uint8), "SelectedPoints"))
        arrays.SetActiveAttribute(index, arrays.SCALARS)
        task.report.Dimension = dimension

    def _are_enclosed(self, sides: Any) -> Any:
        return sides >= (0 if self._settings["SelectPointsOnSurface"] else 1)


@with_settings(
    INTERPOLATION_MODE,
    *settings_of_values(0.0),
    Choice("WeightMode", 0, Weights="WEIGHTS", Radii="RADII"),
    Setting("WeightFactor", 1.0, number),
    Flag("PassPointArrays", True),
    Flag("PassCellArrays", True),
    Flag("PassFieldArrays", True),
)
class vtkFFPointInterpolator2D(TakesSource, vtkFFQueryAlgorithm):
    """Point data between points in the plane, by their triangulation."""

    _title, _owner, _what = "Point interpolation", "source", "A coordinate or a weight"
    _data: InterpolatedData | None = None
    _dimension = -1

    def __init__(self, **settings: Any) -> None:
        self._excluded: list[str] = []
        super().__init__(**settings)

    def AddExcludedArray(self, name: str | None) -> None:
        """Name an array of the source that is not interpolated."""
        self._excluded.append(name or "")
        self.Modified()

    def ClearExcludedArrays(self) -> None:
        self._excluded.clear()
        self.Modified()

    def PrintSelf(self) -> str:
        names = "".join(f"    {name}\n" for name in self._excluded)
        return f"{super().PrintSelf()}  ExcludedArrays: {len(self._excluded)}\n{names}"

    def _is_made(self) -> bool:
        return self._data is not None

    def _drop(self) -> None:
        self._data = None

    def _validate_source(self, data: Any, name: str) -> None:
        if data.IsA("vtkDataSet"):
            array_to_process(self, data, f" of {name}", "source")

    def _make(self, cloud: Cloud, part: Callable[[float, float], Any]) -> None:
        chosen, source = self._settings, cloud.source()
        of = f" of {cloud.blocks[0].name}" if len(cloud.blocks) == 1 else ""
        array = array_to_process(self, source, of, "source")
        factor = factor_of(chosen["WeightFactor"], array is not None)
        given = Weights(None if array is None else vtk.values_of(array), chosen["WeightMode"] == 1, factor)
        weights = cloud.weights(given, self._ignores, "radius" if given.are_radii else "weight", True)
        core = cloud.engine(_core.regular_triangulation, cloud.array, weights, part(0.0, 0.5))
        queries = cloud.engine(_core.triangulation_queries, cloud.array, weights, core, part(0.5, 1.0))
        data, excluded = source.GetPointData(), self._excluded
        self._data = InterpolatedData({**chosen}, queries, len(cloud.array), cloud.heights(), data, excluded)
        self._dimension = core.dimension

    def _query(self, data: Any, task: Task) -> None:
        assert self._data is not None
        result = task.results[0]
        for name, fields in (
            ("Point", result.GetPointData()), ("Cell", result.GetCellData()), ("Field", result.GetFieldData())
        ):
            if not self._settings[f"Pass{name}Arrays"] and fields is not None:
                fields.Initialize()
        part = self._parts(self._ignores, task.progress)
        grid = _grid_of(data)
        if grid:
            self._data.at_grid(grid, data.GetDimensions()[2], part, result.GetPointData())
        else:
            cloud = Cloud([block_for(data, task)], False, self._ignores)
            cloud.engine(self._data.at_points, cloud.array, self._ignores, part, result.GetPointData())
        task.report.Dimension = self._dimension


def _grid_of(image: Any) -> Grid | None:
    """Where the pixels of an image's slices are. None: they are not along the axes, not finite, or none."""
    if not image.IsA("vtkImageData") or image.GetNumberOfPoints() == 0:
        return None
    if not image.GetDirectionMatrix().IsIdentity():
        return None
    extent, origin, spacing = image.GetExtent(), image.GetOrigin()[:2], image.GetSpacing()[:2]
    ends = [origin[k] + extent[2 * k + end] * spacing[k] for k in range(2) for end in range(2)]
    if not all(map(math.isfinite, (*origin, *spacing, *ends))):
        return None
    return Grid(origin, spacing, image.GetDimensions()[:2], extent[0:4:2])
