# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The algorithms that triangulate in a plane."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from textwrap import indent
from typing import Any

import numpy as np

from . import _core
from . import _vtkmodules as vtk
from ._arguments import Weights
from ._domain import Domain
from ._errors import FlipFlopError
from ._filter_arrays import array_to_process, factor_of
from ._filter_base import TakesLines, Task, block_for, reports
from ._filter_errors import SettingError
from ._filter_settings import Choice, Flag, Setting, number, numbers, with_settings
from ._filters_hull import vtkFFAlgorithm
from ._mesh_cells import Plane, add_measures, is_vertical_plane
from ._mesh_joined import Joined
from ._mesh_runs import TRIANGULATED, Run, split
from ._mesh_source import Source, SourceRule
from ._projection import BestFitting, ByTransform, Projection
from ._results import Report as Progress

_SHARE_OF_RINGS = 0.05  # of the progress, until closed lines are found
_vtkAbstractTransform = vtk.module("vtkCommonTransforms").vtkAbstractTransform
_vtkTransformFilter = vtk.module("vtkFiltersGeneral").vtkTransformFilter


def _transform(value: Any) -> Any:
    if value is not None and not isinstance(value, _vtkAbstractTransform):
        raise TypeError(f"a vtkAbstractTransform or None is required, not {value!r}")
    return value


def _a_point() -> Any:
    made = vtk.vtkPolyData()
    made.SetPoints(vtk.points_of(np.zeros((1, 3))))
    return made


class _Transform(Setting):
    def text(self, value: Any) -> str:
        return super().text(value) if value is None else "\n" + indent(str(value), "    ").rstrip()


@reports("NumberOfHiddenPoints", "NumberOfDroppedCells")
@with_settings(
    Choice(
        "ProjectionPlaneMode", 0, XYPlane="XY_PLANE", TransformPlane="TRANSFORM_PLANE",
        BestFittingPlane="BEST_FITTING_PLANE",
    ),
    _Transform("Transform", None, _transform),
    Choice("WeightMode", 0, Weights="WEIGHTS", Radii="RADII"),
    Setting("WeightFactor", 1.0, number),
    Flag("GenerateCellMeasures", False),
)
class vtkFFPlanarAlgorithm(vtkFFAlgorithm):
    """What the algorithms that work in a plane have in common: the plane, the points' weights, measures of cells."""

    def SetTransform(self, transform: Any) -> None:
        """Set what takes the points to the XY plane; it is used, unless it is None."""
        self.StoreTransform(transform)
        if transform is not None:
            self.SetProjectionPlaneMode(self.TRANSFORM_PLANE)

    def StoreTransform(self, transform: Any) -> None:
        """The same, but for whether it is used: for applications that set all properties."""
        if transform is not self._settings["Transform"]:
            self._set("Transform", transform)
            self._follow(transform)

    def _follow(self, transform: Any) -> None:
        """Makes one more input depend on the transform: the executive asks inputs for changes, and not Python."""
        port = self._ports[0]
        self.SetNumberOfInputPorts(port if transform is None else port + 1)
        if transform is not None:
            follower = _vtkTransformFilter()
            follower.SetInputDataObject(_a_point())
            follower.SetTransform(transform)
            self.SetInputConnection(port, follower.GetOutputPort())

    def GetNumberOfInputPorts(self) -> int:
        return self._ports[0]

    def GetMTime(self) -> int:
        """The last change, also of the transform."""
        own, transform = int(super().GetMTime()), self._settings["Transform"]
        return own if transform is None else max(own, int(transform.GetMTime()))

    def _projection(self) -> Projection:
        """The plane that was chosen."""
        mode = self._settings["ProjectionPlaneMode"]
        if mode != self.TRANSFORM_PLANE:
            return BestFitting() if mode == self.BEST_FITTING_PLANE else Projection()
        transform = self._settings["Transform"]
        if transform is None:
            raise SettingError(
                "Projection Plane Mode is Transform, and no Transform is set. Set one, or take another mode."
            )
        return ByTransform(transform)

    def _plane(self, run: Run, data: Any, task: Task, progress: Progress) -> Plane:
        """The points of a data set in the plane, with their weights."""
        chosen = self._settings
        array = array_to_process(self, data, _of(task)) if data.IsA("vtkDataSet") else None
        given = Weights(None if array is None else vtk.values_of(array), chosen["WeightMode"] == self.RADII, 1.0)
        cloud = run.cloud(block_for(data, task))
        given.factor = factor_of(chosen["WeightFactor"], array is not None and len(cloud.array) > 0)
        weights = run.weights(cloud, given, "radius" if given.are_radii else "weight")
        return run.plane(cloud, weights, self._projection(), progress)

    @contextmanager
    def _named_faults(self) -> Iterator[None]:
        """An error about numbers that are not finite, from in here, says of what these may be."""
        try:
            yield
        except FlipFlopError as error:
            how = "" if self._settings["ProjectionPlaneMode"] == self.XY_PLANE else " (as given, or projected)"
            error.what = f"A coordinate{how} or a weight"  # type: ignore[attr-defined]
            raise

    def _warn_of_vertical_plane(self, plane: Plane, core: Any, task: Task) -> None:
        """A line in the XY plane may be a plane in space."""
        mode = self._settings["ProjectionPlaneMode"]
        if mode == self.BEST_FITTING_PLANE or not is_vertical_plane(plane, core):
            return
        how = (
            "are on a line after the Transform, and were not before"
            if mode == self.TRANSFORM_PLANE
            else "are in one vertical plane, so in the XY plane they are on a line"
        )
        task.warnings.append(
            f"The points{_of(task)} {how}. To triangulate them in their own plane, set Projection Plane Mode to "
            "Best-Fitting Plane."
        )


def _of(task: Task) -> str:
    return f" of {task.name}" if task.name else ""


def refuse_weights(plane: Plane) -> None:
    if plane.weights is not None:
        raise SettingError("Constraints take no weights. Choose no weights' array.")


def _length(value: float, name: str, zero: str) -> float | None:
    """A length; None: there is none."""
    if not value >= 0.0:
        raise SettingError(f"{name} is {value:g}; it must be a length, or 0 for {zero}.")
    return value or None


@reports("NumberOfSplitPoints", "NumberOfAddedPoints", "NumberOfHeightDifferences")
@with_settings(
    Setting("Alpha", 0.0, number),
    Flag("AlphaLines", False),
    Flag("AlphaVerts", False),
    Flag("GenerateAlphas", False),
    Setting("MaximumEdgeLength", 0.0, number),
    Flag("GenerateBoundary", False),
    Choice(
        "SourcePoints", 0, AutomaticPoints="AUTOMATIC_POINTS", InputPoints="INPUT_POINTS", OwnPoints="OWN_POINTS"
    ),
    Flag("SplitCrossingConstraints", False),
    Choice("PolygonRule", 0, EvenOdd="EVEN_ODD", Direction="DIRECTION"),
    Flag("ClosedLinesAsBorders", False),
)
class vtkFFRegularTriangulationFilter(TakesLines, vtkFFPlanarAlgorithm):
    """The exact Delaunay triangulation in the plane, with weights or with edges of a source.

    Its ports are the cells, the hidden points, the border of the cells, and the edges that constraints run along.
    """

    _ports = (2, 4)
    _title = "Delaunay triangulation"

    def _execute(self, data: Any, inputs: Any, task: Task) -> None:
        chosen = self._settings
        source = self._source(inputs, task)
        alpha = _length(chosen["Alpha"], "Alpha", "the whole triangulation")
        longest = _length(chosen["MaximumEdgeLength"], "Maximum Edge Length", "edges of any length")
        run = self._run()
        if source is not None:
            self._use_cpu(run, "constraints are the CPU's")
        with self._named_faults():
            plane = self._plane(run, data, task, task.progress)
            joined = None if source is None else self._joined(run, plane, source, task)
            cells = plane.triangulated() if joined is None else joined.cells()
        core = cells.core
        self._warn_of_vertical_plane(plane, core, task)
        if chosen["GenerateCellMeasures"]:
            plane.projection.lie_beneath(plane.cloud.array, core)
        dropped = cells.drop(alpha, longest, chosen["AlphaLines"], chosen["AlphaVerts"])
        dropped += 0 if joined is None else joined.core.dropped
        self._write(run, cells, plane, joined, task)
        more = {"HiddenPoints": len(core.hidden()), "DroppedCells": dropped}
        report = task.report
        report.NumberOfHiddenPoints, report.NumberOfDroppedCells = more.values()
        if joined is not None:
            figures = joined.crossings, joined.added, joined.differing
            report.NumberOfSplitPoints, report.NumberOfAddedPoints, report.NumberOfHeightDifferences = figures
            more |= zip(("SplitPoints", "AddedPoints", "HeightDifferences"), figures)
        self._report_on(task, run, **more)

    def _joined(self, run: Run, plane: Plane, source: Any, task: Task) -> Joined:
        chosen = self._settings
        refuse_weights(plane)
        dimensions = 2 if plane.projection.is_xy else 3
        rule = SourceRule(chosen["SourcePoints"], dimensions, chosen["ClosedLinesAsBorders"])
        part = run.parts(plane.cloud, task.progress)
        constraints = Source(source, plane.cloud, rule, part(0.0, _SHARE_OF_RINGS))
        is_directed = chosen["PolygonRule"] == self.DIRECTION
        joined = Joined(plane, source, constraints, chosen["SplitCrossingConstraints"], is_directed, part)
        if joined.core.dropped and not joined.core.inside().cell_count:
            task.warnings.append(
                "No cell is inside the polygons of the source, so there are points and no cells."
                + (
                    " What is on the left of a side is inside: reverse the polygons, or set Polygon Rule to Even-Odd."
                    if is_directed
                    else ""
                )
            )
        return joined

    def _write(self, run: Run, cells: Any, plane: Plane, joined: Joined | None, task: Task) -> None:
        chosen = self._settings
        made = run.cells_of(plane.cloud, cells.core)
        cells.add_complex(made)
        if chosen["GenerateCellMeasures"]:
            add_measures(made, cells.measures(), plane.projection)
        if chosen["GenerateAlphas"]:
            made.GetCellData().AddArray(vtk.array_of(cells.alphas(), "Alpha"))
        found = [made, cells.hidden(run.pass_data)]
        if chosen["GenerateBoundary"]:
            found.append(cells.boundary(run.pass_data))
        for mesh in found:
            self._finish_ids(mesh.GetPointData())
        if joined is not None:
            joined.add_marks(made, cells.core.vertices())
        for port, mesh in enumerate(found):
            task.adopt(port, mesh)
        if joined is not None:
            edges = vtk.vtkPolyData()
            joined.fixed_edges(made, edges)
            task.adopt(3, edges)


@with_settings(
    Choice("PowerDiagramBoxMode", 0, BoxOfPoints="BOX_OF_POINTS", BoxOfBounds="BOX_OF_BOUNDS"),
    Setting("PowerDiagramBounds", (0.0, 1.0, 0.0, 1.0), numbers(4)),
)
class vtkFFPowerDiagramFilter(vtkFFPlanarAlgorithm):
    """The exact Voronoi or power diagram of points in the plane, clipped to a box."""

    _title = "Power diagram"
    _lengths: tuple[tuple[float, ...], tuple[float, float]] | None = None  # as given, and of which box

    def SetPowerDiagramBounds(self, *bounds: Any) -> None:
        """Set the box (xmin, xmax, ymin, ymax); it is used."""
        self.StorePowerDiagramBounds(*bounds)
        self.SetPowerDiagramBoxMode(self.BOX_OF_BOUNDS)

    def StorePowerDiagramBounds(self, *bounds: Any) -> None:
        """The same, but for whether it is used: for applications that set all properties."""
        self._set("PowerDiagramBounds", *bounds)

    def StorePowerDiagramCorner(self, x: float, y: float, z: float) -> None:
        """Set the box's least corner alone; its lengths stay."""
        x0, x1, y0, y1 = box = self._settings["PowerDiagramBounds"]
        is_same = self._lengths is not None and self._lengths[0] == box
        self._store_box(x, y, *(self._lengths[1] if is_same else (x1 - x0, y1 - y0)))  # type: ignore[index]

    def StorePowerDiagramLengths(self, x: float, y: float, z: float) -> None:
        """Set the box's lengths alone; its least corner stays."""
        box = self._settings["PowerDiagramBounds"]
        self._store_box(box[0], box[2], x, y)

    def _store_box(self, x: float, y: float, length: float, height: float) -> None:
        self.StorePowerDiagramBounds(x, x + length, y, y + height)
        self._lengths = self._settings["PowerDiagramBounds"], (length, height)  # not rounded

    def _execute(self, data: Any, inputs: Any, task: Task) -> None:
        domain = Domain(None)
        if self._settings["PowerDiagramBoxMode"] == self.BOX_OF_BOUNDS:
            domain = Domain(np.array(box_of(self._settings["PowerDiagramBounds"], "The power diagram's box")))
        run = self._run(1)
        with self._named_faults():
            first, second = split(task.progress, TRIANGULATED)
            plane = self._plane(run, data, task, first)
            found = run.power_cells(plane, domain, second)
        self._warn_of_vertical_plane(plane, run.core, task)
        made = run.mesh_of_power_cells(plane, found)
        self._finish_ids(made.GetCellData())
        if self._settings["GenerateCellMeasures"]:
            add_measures(made, _core.power_cell_measures(found), plane.projection)
        task.adopt(0, made)
        task.report.NumberOfHiddenPoints = len(run.core.hidden())
        self._report_on(task, run, HiddenPoints=task.report.NumberOfHiddenPoints)


def box_of(box: tuple[float, ...], what: str) -> tuple[float, ...]:
    """The box (xmin, xmax, ymin, ymax), if it has an inside."""
    if not (all(map(math.isfinite, box)) and box[0] < box[1] and box[2] < box[3]):
        numbers_ = ", ".join(f"{x:g}" for x in box)
        raise SettingError(
            f"{what} has no inside or is not finite: it is (xmin, xmax, ymin, ymax) = ({numbers_})."
        )
    return box
