# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all algorithms have in common: their ports, a run on each data set, the report, and errors as VTK's.

An algorithm is its settings and the report of the last run. A run begins from nothing. A data set of a composite has a
run of its own: one at fault costs only itself.
"""

from __future__ import annotations

import _thread
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, fields
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _vtkmodules as vtk
from ._errors import AbortedError, FlipFlopError
from ._filter_errors import NO_ERROR, Failure
from ._filter_settings import add_method, add_property
from ._meshes import LEAVES, Block, block_of, drop_report, pass_field_data
from ._results import Report as Progress
from ._results import stretch

_execution = vtk.module("vtkCommonExecutionModel")
try:
    _Base = vtk.module("util.vtkAlgorithm").VTKPythonAlgorithmBase
except ImportError as error:
    raise ImportError(f"This VTK has no algorithms in Python: {error}", name=error.name) from None
_Pipeline = _execution.vtkStreamingDemandDrivenPipeline
_NOT_GENERATED = _Pipeline.REQUEST_DATA_NOT_GENERATED()
# The requests that an algorithm may answer: as the base does it, which looks for the keys each time.
_REQUESTS = (
    (_Pipeline.REQUEST_DATA_OBJECT(), "RequestDataObject"),
    (_Pipeline.REQUEST_INFORMATION(), "RequestInformation"),
    (_Pipeline.REQUEST_UPDATE_EXTENT(), "RequestUpdateExtent"),
    (_Pipeline.REQUEST_DATA(), "RequestData"),
)
vtkAlgorithm, vtkDataObject = _execution.vtkAlgorithm, vtk.module("vtkCommonDataModel").vtkDataObject
_new_object = vtk.module("vtkCommonDataModel").vtkDataObjectTypes.NewDataObject


@dataclass
class Report:
    """The figures of one data set, or the sums over those of a composite; of the dimension and errors, the greatest."""

    EngineUsed: int = -1
    EngineReason: str = ""
    Dimension: int = -1
    NumberOfInputPoints: int = 0
    NumberOfNonFinitePoints: int = 0
    Volume: float = 0.0
    Area: float = 0.0
    NumberOfHiddenPoints: int = 0
    NumberOfDroppedCells: int = 0
    NumberOfSplitPoints: int = 0
    NumberOfAddedPoints: int = 0
    NumberOfHeightDifferences: int = 0
    GreatestError: float = 0.0
    NumberOfPointsBeyond: int = 0
    NumberOfUnreachablePoints: int = 0
    NumberOfKeptSegments: int = 0
    NumberOfKeptTriangles: int = 0

    def add(self, other: Report) -> None:
        if 0 <= other.EngineUsed >= self.EngineUsed:
            self.EngineUsed, self.EngineReason = other.EngineUsed, other.EngineReason
        self.Dimension = max(self.Dimension, other.Dimension)
        self.GreatestError = max(self.GreatestError, other.GreatestError)
        for field in fields(self):
            if field.name.startswith("NumberOf") or field.name in ("Volume", "Area"):
                setattr(self, field.name, getattr(self, field.name) + getattr(other, field.name))


def reports(*names: str) -> Callable[[type], type]:
    """Gives a class Get methods for these figures of its report."""

    def installed(kind: type) -> type:
        for name in names:
            add_method(kind, f"Get{name}", lambda self, name=name: getattr(self._report, name))
            add_property(kind, name)
        return kind

    return installed


class Task:
    """The run on one data set: where its progress goes, and its report, warnings and outputs."""

    def __init__(self, results: list[Any], progress: Progress, name: str = "") -> None:
        self.results, self.progress, self.name = results, progress, name
        self.report = Report()
        self.warnings: list[str] = []

    def take(self, run: Any) -> None:
        """The figures of the cells that the engine made last."""
        statistics = run.core.statistics
        self.report.Dimension = run.core.dimension
        self.report.NumberOfInputPoints = statistics["points"]
        self.report.NumberOfNonFinitePoints = statistics["nonFinite"]
        self.report.EngineUsed, self.report.EngineReason = run.engine

    def adopt(self, port: int, made: Any) -> None:
        """What was made becomes the output, which keeps its field data."""
        result = self.results[port]
        result.CopyStructure(made)
        for get in ("GetPointData", "GetCellData"):
            getattr(result, get)().ShallowCopy(getattr(made, get)())
        result.GetFieldData().PassData(made.GetFieldData())


class Algorithm(_Base):  # type: ignore[misc, valid-type]
    """A VTK algorithm of points."""

    _ports = (1, 1)  # of input, of output
    _result = "vtkPolyData"  # the class of each result; empty: that of the input
    _title = ""  # what is made, for the progress text
    _advice = "Remove them, or set Non Finite Points to Ignore."  # where numbers are not finite
    _table: tuple[Any, ...] = ()

    if TYPE_CHECKING:  # what VTK's base and the table of settings bring

        def __getattr__(self, name: str) -> Any: ...

    def __init__(self, **settings: Any) -> None:
        super().__init__(nInputPorts=self._ports[0], nOutputPorts=self._ports[1])
        self._settings = {setting.name: setting.default for setting in self._table}
        self._report, self._code = Report(), NO_ERROR
        for name, value in settings.items():
            if not isinstance(getattr(type(self), name, None), property):
                raise TypeError(f"{type(self).__name__} has no setting {name!r}")
            setattr(self, name, value)

    def _set(self, name: str, *values: Any) -> None:
        """What the setter of that name does, for one that does more."""
        next(setting for setting in self._table if setting.name == name).assign(self, *values)

    # ---- What VTK's own algorithms have ----

    def GetClassName(self) -> str:
        return type(self).__name__

    @classmethod
    def IsTypeOf(cls, name: str) -> int:
        return int(any(kind.__name__ == name for kind in cls.__mro__))

    def IsA(self, name: str) -> int:
        return self.IsTypeOf(name) or int(super().IsA(name))

    @classmethod
    def SafeDownCast(cls, other: Any) -> Any:
        return other if isinstance(other, cls) else None

    def NewInstance(self) -> Any:
        return type(self)()

    def GetErrorCode(self) -> int:
        return self._code

    def SetInputData(self, *arguments: Any) -> None:
        """Set the data of a port, by default of the first one."""
        self.SetInputDataObject(*arguments)

    def AddInputData(self, *arguments: Any) -> None:
        """Add data to a port, by default to the first one."""
        self.AddInputDataObject(*arguments)

    def GetInput(self, port: int = 0) -> Any:
        return self.GetInputDataObject(port, 0) if self.GetNumberOfInputConnections(port) else None

    def GetOutput(self, port: int = 0) -> Any:
        """The output, if it is one data set; of a composite, GetOutputDataObject() gives it."""
        output = self.GetOutputDataObject(port)
        return output if output is not None and output.IsA(self._result or "vtkDataSet") else None

    def SetOutput(self, data: Any) -> None:
        self.GetExecutive().SetOutputData(0, data)

    output = property(lambda self: self.GetOutputDataObject(0))

    def PrintSelf(self) -> str:
        """The settings, a line each."""
        return "".join(f"  {one.name}: {one.text(self._settings[one.name])}\n" for one in self._table)

    def __str__(self) -> str:
        return f"{super().__str__()}{self.PrintSelf()}"

    def FillInputPortInformation(self, port: int, info: Any) -> int:
        """Composites are taken as they are, not iterated over by the executive."""
        info.Remove(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE())
        info.Append(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet")
        info.Append(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject")
        if port > 0:
            info.Set(vtkAlgorithm.INPUT_IS_OPTIONAL(), 1)
        return 1

    def FillOutputPortInformation(self, port: int, info: Any) -> int:
        info.Set(vtkDataObject.DATA_TYPE_NAME(), "vtkDataObject")
        return 1

    # ---- The requests ----

    def ProcessRequest(self, request: Any, inputs: Any, outputs: Any) -> int:
        if request.Has(_NOT_GENERATED):
            # The executive's first request of each run, also of one that is aborted before RequestData().
            self._report, self._code = Report(), NO_ERROR
            return 1
        for key, name in _REQUESTS:
            if request.Has(key):
                return int(getattr(self, name)(request, inputs, outputs))
        return 1

    def RequestDataObject(self, request: Any, inputs: Any, outputs: Any) -> int:
        """Each output is a result, or a composite of the input's structure; of an AMR, a vtkMultiBlockDataSet."""
        data = data_of(inputs[0])
        each = self._has_each(data)
        for port in range(outputs.GetNumberOfInformationObjects()):
            info = outputs.GetInformationObject(port)
            kind = self._result
            if each:
                is_kept = not kind or data.IsA("vtkDataObjectTree")
                kind = data.GetClassName() if is_kept else "vtkMultiBlockDataSet"
            elif not kind and data is not None and data.IsA("vtkDataSet"):
                kind = data.GetClassName()
            there = info.Get(vtkDataObject.DATA_OBJECT())
            if there is None or there.GetClassName() != kind:
                made = _new_object(kind or "vtkPolyData")
                info.Set(vtkDataObject.DATA_OBJECT(), made)
                self.GetOutputPortInformation(port).Set(vtkDataObject.DATA_EXTENT_TYPE(), made.GetExtentType())
        return 1

    def RequestData(self, request: Any, inputs: Any, outputs: Any) -> int:
        data = data_of(inputs[0])
        results = [outputs.GetInformationObject(i).Get(vtkDataObject.DATA_OBJECT()) for i in range(self._ports[1])]
        report = Report()
        self.SetProgressText(self._title)
        reached = 0.0

        def progress(fraction: float) -> bool:
            nonlocal reached
            reached = max(reached, fraction)  # a run that the CUDA engine gave up starts again on the CPU
            self.UpdateProgress(reached)
            return not self._is_aborted()

        try:
            for result in results:
                drop_report(result.GetFieldData())
            begin = self._prepare(inputs, progress)
            if data is None:
                raise FlipFlopError("There is no input. Set one.", "bad_argument")
            rest = stretch(progress, begin, 1.0)
            if self._has_each(data):
                self._work_on_each(data, inputs, results, rest, report)
            else:
                task = Task(results, rest)
                is_done = self._done(partial(self._execute, data, inputs, task), task)
                report = task.report
                if is_done and not progress(1.0):
                    raise AbortedError("", "aborted")
        except AbortedError:
            self._end_aborted(results, report)
        except KeyboardInterrupt:
            # VTK would swallow it. Another thread's turn comes when VTK has returned.
            self._end_aborted(results, report)
            _thread.start_new_thread(_thread.interrupt_main, ())
        except Exception as error:
            report = self._fail(error, "", results)
        self._report = report
        return 1

    # ---- Of subclasses ----

    def _prepare(self, inputs: Any, progress: Progress) -> float:
        """The work before that on the first data set. Returns the share of the progress that it took."""
        return 0.0

    def _execute(self, data: Any, inputs: Any, task: Task) -> None:
        """The work on one data set, or on the whole input."""
        raise NotImplementedError

    def _is_joined(self) -> bool:
        """Whether the data sets of a composite are one input."""
        return False

    # ---- Details ----

    def _has_each(self, data: Any) -> bool:
        return data is not None and bool(data.IsA("vtkCompositeDataSet")) and not self._is_joined()

    def _new_result(self, data: Any, kind: str) -> Any:
        if not kind and data is not None and data.IsA("vtkDataSet"):
            return data.NewInstance()
        return _new_object(kind or "vtkPolyData")

    def _work_on_each(
        self, data: Any, inputs: Any, outputs: list[Any], progress: Callable[[float], bool], report: Report,
    ) -> None:
        for output in outputs:
            output.CopyStructure(data)
        pieces = [leaf for leaf, _ in leaves_of_composite(data)]
        leaves = data.NewIterator()
        leaves.InitTraversal()
        for i, piece in enumerate(pieces):
            results = [self._new_result(piece, self._result) for _ in outputs]
            for result in results:
                pass_field_data(piece, result)
            name = f"data set {i} of the composite" if len(pieces) > 1 else ""
            task = Task(results, stretch(progress, i / len(pieces), (i + 1) / len(pieces)), name)
            self._done(partial(self._execute, piece, inputs, task), task)
            # The engine asks now and then, so perhaps not at all.
            if not progress((i + 0.5) / len(pieces)):
                raise AbortedError("", "aborted")
            report.add(task.report)
            for output, result in zip(outputs, results):
                output.SetDataSet(leaves, result)
            leaves.GoToNextItem()
            if not progress((i + 1) / len(pieces)):
                raise AbortedError("", "aborted")

    def _done(self, work: Callable[[], None], task: Task) -> bool:
        """Does it, and says its warnings, and why it failed; then there are no results."""
        try:
            work()
        except AbortedError:
            raise
        except Exception as error:
            task.report = self._fail(error, task.name, task.results, task.warnings)
            return False
        self._warn(task.warnings)
        return True

    def _fail(self, error: Exception, name: str, results: list[Any], warnings: Iterable[str] = ()) -> Report:
        """Says why the work on a data set of that name failed, and empties its results. Returns its report."""
        failure = Failure.of(error, name, self._advice)
        self._code = failure.code
        for result in results:
            result.Initialize()
        self._warn(warnings)
        self._say("Error", failure.message)
        return Report(NumberOfNonFinitePoints=failure.non_finite)

    def _is_aborted(self) -> bool:
        return bool(self.CheckAbort() if hasattr(self, "CheckAbort") else self.GetAbortExecute())

    def _end_aborted(self, results: list[Any], report: Report) -> None:
        """What was done of a composite stays. The pipeline is to know that the output is not whole."""
        if hasattr(self, "SetAbortOutput"):
            self.SetAbortOutput(True)
        if not results[0].IsA("vtkCompositeDataSet"):
            for result in results:
                result.Initialize()
            report.__init__()  # type: ignore[misc]

    def _warn(self, sentences: Iterable[str]) -> None:
        for sentence in sentences:
            self._say("Warning", sentence)

    def _say(self, kind: str, sentence: str) -> None:
        """Reports an error or a warning as VTK's macros do."""
        if not self.GetGlobalWarningDisplay():
            return
        where = sys._getframe(1).f_code
        address = self.GetAddressAsString("vtkObject").removeprefix("Addr=")
        text = f"In {where.co_filename}, line {where.co_firstlineno}\n{type(self).__name__} ({address}): {sentence}\n\n"
        if self.HasObserver(f"{kind}Event"):
            self.InvokeEvent(f"{kind}Event", f"{kind.upper()}: {text}")
        else:
            window = vtk.module("vtkCommonCore").vtkOutputWindow.GetInstance()
            getattr(window, f"Display{kind}Text")(f"{kind.upper()}: {text}")


class TakesSource:
    """What algorithms have in common whose second input is a source."""

    if TYPE_CHECKING:  # what VTK's base brings

        def __getattr__(self, name: str) -> Any: ...

    def SetSourceData(self, source: Any) -> None:
        self.SetInputData(1, source)

    def SetSourceConnection(self, connection: Any) -> None:
        self.SetInputConnection(1, connection)

    def GetSource(self) -> Any:
        return self.GetInput(1)


class TakesLines(TakesSource):
    """The same, where the source may be left out: its lines and polygons are edges."""

    def RemoveSource(self) -> None:
        self.SetSourceConnection(None)

    def RequestUpdateExtent(self, request: Any, inputs: Any, outputs: Any) -> int:
        request_all(inputs[1])
        return 1


def block_for(data: Any, task: Task) -> Block:
    """The points of a data set, which errors name as the task does."""
    if not any(map(data.IsA, LEAVES)):
        of = f" of {task.name}" if task.name else ""
        raise FlipFlopError(
            f"The data{of} is a {data.GetClassName()}. It must be a vtkDataSet, or a composite of these.",
            "bad_argument",
        )
    return block_of(data, task.name)


def add_report(field_data: Any, core: Any, task: Task, **more: Any) -> None:
    """A run's report as field data."""
    statistics = core.statistics
    report = task.report
    figures = {
        "Dimension": np.int32(report.Dimension),
        "Engine": "CUDA" if report.EngineUsed == 2 else "CPU",
        "EngineReason": report.EngineReason,
        "Threads": np.int32(statistics["threads"]),
    }
    figures |= {name[0].upper() + name[1:]: value for name, value in statistics.items() if name != "threads"}
    for name, value in (figures | more).items():
        if isinstance(value, int):
            array = vtk.ids_of(np.array([value]))
        else:
            array = vtk.array_of(np.array([value], object if isinstance(value, str) else None))
        array.SetName(f"FlipFlop{name}")
        field_data.AddArray(array)


def leaves_of_composite(data: Any) -> Iterator[tuple[Any, int]]:
    """The data sets of a composite, with their flat indices."""
    leaves = data.NewIterator()
    leaves.InitTraversal()
    while not leaves.IsDoneWithTraversal():
        yield leaves.GetCurrentDataObject(), leaves.GetCurrentFlatIndex()
        leaves.GoToNextItem()


def data_of(vector: Any) -> Any:
    """The first data object of a port; None: there is none."""
    info = vector.GetInformationObject(0)
    return None if info is None else info.Get(vtkDataObject.DATA_OBJECT())


def request_all(vector: Any) -> None:
    """Ask for all of an input, whatever part of an output is asked for."""
    info, pipeline = vector.GetInformationObject(0), _Pipeline
    if info is None:
        return
    info.Remove(pipeline.UPDATE_EXTENT())
    if info.Has(pipeline.WHOLE_EXTENT()):
        info.Set(pipeline.UPDATE_EXTENT(), info.Get(pipeline.WHOLE_EXTENT()), 6)
    info.Set(pipeline.UPDATE_PIECE_NUMBER(), 0)
    info.Set(pipeline.UPDATE_NUMBER_OF_PIECES(), 1)
    info.Set(pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0)
