# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The algorithms that make hulls."""

from __future__ import annotations

import math
from enum import IntEnum
from typing import Any

import numpy as np

from . import _core
from . import _vtkmodules as vtk
from ._errors import InputError
from ._filter_base import Algorithm, Task, add_report, block_for, data_of, leaves_of_composite, reports
from ._filter_errors import Failure, SettingError
from ._filter_settings import (
    VTK_ID_MAX,
    VTK_INT_MAX,
    Choice,
    Flag,
    Setting,
    add_enumeration,
    identifier,
    integer,
    number,
    numbers,
    with_settings,
)
from ._mesh_runs import Run
from ._meshes import Block, Cloud, add_block_index, block_of
from ._results import Report as Progress

_FACETS, _NON_FINITE, _ENGINES = ("triangles", "polygons"), ("error", "ignore"), ("automatic", "cpu", "cuda")


@reports("Dimension", "NumberOfInputPoints", "NumberOfNonFinitePoints", "EngineUsed")
@with_settings(
    Choice("Engine", 0, Automatic="ENGINE_AUTOMATIC", CPU="ENGINE_CPU", CUDA="ENGINE_CUDA"),
    Setting("CUDAThreshold", VTK_ID_MAX, identifier, 0, VTK_ID_MAX),
    Setting("NumberOfThreads", 0, integer, -1, VTK_INT_MAX),
    Choice("FacetMode", 0, Triangles="FACETS_AS_TRIANGLES", Polygons="FACETS_AS_POLYGONS"),
    Choice("NonFinitePoints", 0, Error="NON_FINITE_ERROR", Ignore="NON_FINITE_IGNORE"),
    Flag("SkipGhostPoints", True),
    Flag("PassPointData", True),
    Flag("VisiblePointIds", False),
    Flag("ReportAsFieldData", False),
    Flag("VBiased", True),
)
class vtkFFAlgorithm(Algorithm):
    """What the algorithms have in common: the engine, threads, and what is done with points and their data."""

    EngineType = IntEnum("EngineType", {"ENGINE_NONE": -1, "ENGINE_AUTOMATIC": 0, "ENGINE_CPU": 1, "ENGINE_CUDA": 2})

    @staticmethod
    def IsCUDAAvailable() -> bool:
        """Whether this build has a CUDA engine and this machine a device that can run it."""
        return _core.cuda_status()[1]

    @staticmethod
    def GetCUDADeviceName() -> str:
        """The device's name; empty: there is none."""
        return _core.cuda_status()[2]

    @staticmethod
    def GetCUDAProblem() -> str:
        """Why there is no device; empty: there is one."""
        return _core.cuda_status()[3]

    def GetEngineUsedAsString(self) -> str:
        return {1: "CPU", 2: "CUDA"}.get(self._report.EngineUsed, "None")

    def GetEngineReason(self) -> str:
        return self._report.EngineReason or "no engine has run"

    def _run(self, facets: int | None = None) -> Run:
        """A run of the engine with these settings."""
        chosen = self._settings
        run = Run(
            _FACETS[chosen["FacetMode"] if facets is None else facets],
            threads_of_vtk(chosen["NumberOfThreads"]),
            _NON_FINITE[chosen["NonFinitePoints"]],
            _ENGINES[chosen["Engine"]],
            chosen["SkipGhostPoints"],
            chosen["PassPointData"],
        )
        run.v_biased = chosen["VBiased"]
        if chosen["CUDAThreshold"] < VTK_INT_MAX:
            run.cuda_from = chosen["CUDAThreshold"]
        return run

    def _use_cpu(self, run: Run, reason: str) -> None:
        """The work is the CPU engine's, for this reason."""
        if self._settings["Engine"] == 2:
            raise SettingError(f"The CUDA engine was asked for, but {reason}. Set Engine to Automatic or CPU.")
        run.use_cpu(reason)

    def _source(self, inputs: Any, task: Task) -> Any:
        """The input of port 1, whose lines and polygons are edges; None: there is none."""
        source = data_of(inputs[1])
        if source is not None and task.name:
            raise SettingError(
                "The source's lines are for one data set, and an input is a composite. Take one data set, merge them, "
                "or take the source away."
            )
        if source is not None and not source.IsA("vtkPolyData"):
            raise InputError(
                f"The source is a {source.GetClassName()}. It must be a vtkPolyData, whose lines and polygons are "
                "edges of the triangulation.",
                "bad_argument",
            )
        return source

    def _finish_ids(self, attributes: Any) -> None:
        """The ids are given again by another name, if that was asked for."""
        ids = attributes.GetArray("vtkOriginalPointIds")
        if self._settings["VisiblePointIds"] and ids is not None:
            copy = ids.NewInstance()
            copy.ShallowCopy(ids)
            copy.SetName("OriginalPointIds")
            attributes.AddArray(copy)

    def _report_on(self, task: Task, run: Run, **more: Any) -> None:
        """The figures of the engine's last cells become the report, and field data if that was asked for."""
        task.take(run)
        if self._settings["ReportAsFieldData"]:
            add_report(task.results[0].GetFieldData(), run.core, task, **more)


add_enumeration(vtkFFAlgorithm, "SourcePointsType", {"AUTOMATIC_POINTS": 0, "INPUT_POINTS": 1, "OWN_POINTS": 2})
_smp = vtk.module("vtkCommonCore").vtkSMPTools


def threads_of_vtk(count: int) -> int:
    """For the engine, 0 is all of the machine's: here -1, and where VTK has no threads of its own."""
    if count:
        return max(count, 0)
    return 0 if _STARTED_SERIAL and _smp.GetBackend() == "Sequential" else int(_smp.GetEstimatedNumberOfThreads())


_STARTED_SERIAL = _smp.GetBackend() == "Sequential"


@reports("Volume", "Area")
class vtkFFHullAlgorithm(vtkFFAlgorithm):
    """What algorithms that make hulls have in common."""

    def _write(self, hull: Any, run: Run, task: Task) -> None:
        task.adopt(0, hull)
        task.report.Volume, task.report.Area = run.core.volume, run.core.area
        self._report_on(task, run, Volume=run.core.volume, Area=run.core.area)

    def GetPlanes(self, planes: Any) -> bool:
        """Sets a vtkPlanes to the planes of the output's facets, with normals that point outwards. False: an error."""
        output = self.GetOutputDataObject(0)
        sentence = ""
        if planes is None:
            sentence = "There is nothing to give the planes to: GetPlanes() takes a vtkPlanes."
        elif output is not None and not output.IsA("vtkPolyData"):
            sentence = (
                f"The output is a {output.GetClassName()}, which has no planes of its own. Take the hull of one block, "
                "or one hull of all blocks."
            )
        elif output is None or self.GetDimension() != 3 or not output.GetNumberOfPolys():
            sentence = (
                "There is no hull of dimension 3 that planes could bound: update the filter first; its points must not "
                "lie in one plane."
            )
        if planes is not None:
            planes.SetPoints(None)
            planes.SetNormals(None)
        if sentence:
            failure = Failure.of(InputError(sentence, "bad_argument"), "", "")
            self._code = failure.code
            self._say("Error", failure.message)
            return False
        points, found, firsts = _planes_of(output)
        positions = vtk.points_of(points[firsts].astype(np.float64))
        planes.SetPoints(positions)
        planes.SetNormals(vtk.array_of(np.ascontiguousarray(found[:, :3])))
        self._code = 0
        return True


def _planes_of(hull: Any) -> tuple[Any, Any, Any]:
    """The points, of each facet its plane, and its first corner."""
    cloud = Cloud([block_of(hull, "")], False, False)
    polygons = hull.GetPolys()
    offsets = vtk.values_of(polygons.GetOffsetsArray()).astype(np.int64)
    corners = vtk.values_of(polygons.GetConnectivityArray()).astype(np.int64)
    return cloud.array, _core.planes_of_facets(cloud.array, offsets, corners), corners[offsets[:-1]]


@with_settings(
    Choice("CompositeMode", 0, HullOfEachBlock="HULL_OF_EACH_BLOCK", HullOfAllBlocks="HULL_OF_ALL_BLOCKS"),
    Setting("NumberOfStreamDivisions", 1, integer, 1, VTK_INT_MAX),
)
class vtkFFHullFilter(vtkFFHullAlgorithm):
    """The exact convex hull of points; of a composite, of each data set, or one of all.

    A number of stream divisions above 1 changes nothing here: the input is taken as a whole, which has the same hull.
    """

    _title = "Convex hull"

    def _is_joined(self) -> bool:
        return self._settings["CompositeMode"] == 1

    def _prepare(self, inputs: Any, progress: Progress) -> float:
        if self._settings["NumberOfStreamDivisions"] > 1 and self._has_each(data_of(inputs[0])):
            raise SettingError(
                "A composite that is streamed has one hull. Set Composite Mode to Hull of All Blocks, or Number Of "
                "Stream Divisions to 1."
            )
        return 0.0

    def _execute(self, data: Any, inputs: Any, task: Task) -> None:
        run = self._run()
        joined = bool(data.IsA("vtkCompositeDataSet"))
        blocks = blocks_for(data) if joined else [block_for(data, task)]
        hull = run.hull(blocks, task.progress)
        self._finish_ids(hull.GetPointData())
        if joined and blocks:
            add_block_index(hull, blocks)
        self._write(hull, run, task)


def blocks_for(data: Any, of: str = "") -> list[Block]:
    """The data sets of a composite as one input, which errors name: " of the surface"."""
    blocks = []
    for leaf, index in leaves_of_composite(data):
        block = block_for(leaf, Task([], None, name_of_block(index, of)))
        block.flat_index = index
        blocks.append(block)
    return blocks


def name_of_block(index: int, of: str) -> str:
    return f"the block of flat index {index}{of}"


@with_settings(
    Setting("KernelPoint", (0.0, 0.0, 0.0), numbers(3, number)),
    Flag("UseKernelPoint", False),
)
class vtkFFConvexifyFilter(vtkFFHullAlgorithm):
    """The convex hull of a closed star-shaped surface, reached by flips alone."""

    _title = "Convexify"
    _advice = "They are corners of the surface, which has to be mended."

    def SetEngine(self, engine: int) -> None:
        """Set the engine, which is never CUDA's."""
        self._set("Engine", min(engine, self.ENGINE_CPU))

    def SetKernelPoint(self, *point: Any) -> None:
        """Set the point from which the surface is star-shaped; it is used."""
        self.StoreKernelPoint(*point)
        self.SetUseKernelPoint(True)

    def StoreKernelPoint(self, *point: Any) -> None:
        """The same, but for whether it is used: for applications that set all properties."""
        self._set("KernelPoint", *point)

    def _execute(self, data: Any, inputs: Any, task: Task) -> None:
        run = self._run()
        self._use_cpu(run, "this filter runs on the CPU")
        kernel = self._settings["KernelPoint"] if self._settings["UseKernelPoint"] else None
        if kernel and not all(map(math.isfinite, kernel)):
            raise SettingError(f"The kernel point ({', '.join(f'{x:g}' for x in kernel)}) is not finite.")
        if not data.IsA("vtkPolyData"):
            of = f" of {task.name}" if task.name else ""
            raise InputError(f"The data{of} is a {data.GetClassName()}. It must be a vtkPolyData.", "bad_argument")
        hull = run.convexified(block_for(data, task), kernel, task.progress)
        self._finish_ids(hull.GetPointData())
        self._write(hull, run, task)
