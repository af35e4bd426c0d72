# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The compiled classes and those in Python give the same, for settings and inputs at random: bits, figures, sentences.

It runs where one process has both kinds.
"""

import os
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkBitArray, vtkIdList, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
    vtkRectilinearGrid,
    vtkTable,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonTransforms import vtkGeneralTransform, vtkPerspectiveTransform, vtkTransform

try:
    from vtkflipflop import _filters as python
    from vtkflipflop import _vtk as compiled

    WHY_NOT = ""
except ImportError as error:
    WHY_NOT = f"One process does not have both kinds here: {error}"

# Where one kind may take a GPU, or says why not, both are set to the CPU.
ENGINE = [] if WHY_NOT or compiled.vtkFFHullFilter.GetCUDAProblem() == python.vtkFFHullFilter.GetCUDAProblem() else [1]
CASES = int(os.environ.get("FLIPFLOP_TEST_CASES", 120))
NUMBERS = [0.05, 0.3, 1.0, np.inf, -1.0, np.nan]
FLAGS = ["SkipGhostPoints", "PassPointData", "VisiblePointIds", "ReportAsFieldData", "VBiased", "FacetMode",
         "NonFinitePoints"]  # fmt: skip
OF_PLANE = {"GenerateCellMeasures": [0, 1], "ProjectionPlaneMode": [0, 1, 2], "WeightMode": [0, 1],
            "WeightFactor": [2.0, 0.0, *NUMBERS]}  # fmt: skip
OF_VALUES = {"InterpolationMode": [0, 1, 2], "NullPointsStrategy": [0, 1, 2], "NullValue": [3.0, np.nan],
             "InterpolateZ": [0, 1], "ZArrayName": ["z", "a0"], "ValidPointsMaskArrayName": ["valid"]}  # fmt: skip
SETTINGS = {
    "vtkFFHullFilter": {"CompositeMode": [0, 1]},
    "vtkFFRegularTriangulationFilter": {
        **OF_PLANE, "Alpha": NUMBERS, "AlphaLines": [0, 1], "AlphaVerts": [0, 1], "GenerateAlphas": [0, 1],
        "MaximumEdgeLength": NUMBERS, "GenerateBoundary": [0, 1], "SourcePoints": [0, 1, 2],
        "SplitCrossingConstraints": [0, 1], "PolygonRule": [0, 1], "ClosedLinesAsBorders": [0, 1],
    },
    "vtkFFPowerDiagramFilter": {
        **OF_PLANE, "PowerDiagramBounds": [(0.1, 0.8, -1.0, 2.0), (1.0, 0.0, 0.0, 1.0), (np.nan, 1.0, 0.0, 1.0)],
    },
    "vtkFFTerrainMeshFilter": {
        "Tolerance": NUMBERS, "MaximumNumberOfVertices": [0, 4, 20], "SourcePoints": [0, 1, 2],
        "SplitCrossingConstraints": [0, 1],
    },
    "vtkFFMeshFilter": {
        "MinimumAngle": [0.0, 20.0, 30.0, 40.0], "MaximumArea": [0.001, *NUMBERS],
        "SplitCrossingConstraints": [0, 1], "PolygonRule": [0, 1], "ClosedLinesAsBorders": [0, 1],
    },
    "vtkFFConvexifyFilter": {"KernelPoint": [(0.5, 0.5, 0.5), (5.0, 0.0, 0.0), (np.nan, 0.0, 0.0)]},
    "vtkFFSelectEnclosedPoints": {
        "GenerateDistances": [0, 1], "InsideOut": [0, 1], "SelectPointsOnSurface": [0, 1],
    },
    "vtkFFPointInterpolator2D": {
        **OF_VALUES, "WeightMode": [0, 1], "WeightFactor": [2.0, 0.0, *NUMBERS], "PassPointArrays": [0, 1],
        "PassCellArrays": [0, 1], "PassFieldArrays": [0, 1],
    },
    "vtkFFPointsToImage": {
        **OF_PLANE, **OF_VALUES, "SizeMode": [0, 1], "Dimensions": [(5, 7), (0, 3)],
        "Spacing": [(0.3, 0.1), (np.nan, 1.0)], "UseInputBounds": [0, 1],
        "SamplingBounds": [(0.1, 0.8, -1.0, 2.0), (1.0, 0.0, 0.0, 1.0)],
    },
}  # fmt: skip
FIGURES = ["Dimension", "EngineUsed", "EngineReason", "ErrorCode", "Volume", "Area", "GreatestError"] + [
    f"NumberOf{what}"
    for what in ("InputPoints", "NonFinitePoints", "HiddenPoints", "DroppedCells", "SplitPoints", "AddedPoints",
                 "HeightDifferences", "PointsBeyond", "UnreachablePoints", "KeptSegments", "KeptTriangles")
]  # fmt: skip
# What the report has of the work and the machine.
OF_THE_WORK = ("FlipFlopSeconds", "FlipFlopThreads")


class Made:
    """Settings and inputs, at random."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)

    def one_of(self, choices):
        return choices[self.random.integers(len(choices))]

    def chance(self, share):
        return self.random.random() < share

    def calls(self, name):
        kind = getattr(compiled, name)
        choices = {**{flag: [0, 1] for flag in FLAGS if hasattr(kind, f"Set{flag}")}, **SETTINGS[name]}
        found = [("SetEngine", engine) for engine in ENGINE if hasattr(kind, "SetEngine")]
        found += [(f"Set{key}", self.one_of(values)) for key, values in choices.items() if self.chance(0.25)]
        if ("WeightMode" in choices or "Tolerance" in choices or "MinimumAngle" in choices) and self.chance(0.4):
            array = self.one_of(["w", "w", "w", "a0", "None", "", "missing", 0])
            found.append(("SetInputArrayToProcess", 0, 0, 0, self.one_of([0, 0, 0, 1]), array))
        if "MinimumAngle" in choices:
            found.append(("SetMaximumNumberOfPoints", self.one_of([10, 50, 2000])))
        if "ProjectionPlaneMode" in choices and self.chance(0.2):
            transform = self.one_of([vtkTransform, vtkGeneralTransform, vtkPerspectiveTransform])()
            transform.RotateX(30.0)
            transform.Scale(2.0, 1.0, self.one_of([0.0, 1.0]))
            found.append(("SetTransform", transform))
        return found

    def rows(self):
        rows = self.random.random((self.one_of([0, 1, 2, 5, 30, 200]), 3))
        kind = self.one_of(["any", "lattice", "line", "vertical", "point"])
        if kind == "lattice":
            rows = np.round(6.0 * rows) / 6.0
        elif kind == "line":
            rows = np.round(5.0 * rows[:, :1]) * [1.0, 2.0, self.one_of([0.0, 1.0])]
        elif kind != "any":
            rows[:, 1 if kind == "vertical" else slice(None)] = 0.5
        if len(rows) and self.chance(0.05):
            rows[self.random.integers(len(rows)), self.random.integers(3)] = self.one_of([np.nan, np.inf])
        elif self.chance(0.1):
            return np.round(6.0 * rows).astype(np.int32)
        elif self.chance(0.05):
            return self.integers(rows.shape)
        return rows.astype(self.one_of([np.float32, np.float64]))

    def integers(self, shape):
        """Of 64 bits; there may be one that no double holds."""
        rows = np.round(6.0 * self.random.random(shape)).astype(np.int64)
        if rows.size and self.chance(0.3):
            rows.ravel()[self.random.integers(rows.size)] = 2**53 + 1
        return rows

    def array(self, count):
        kind = self.one_of(["f4", "f8", "i8", "u1", "text", "bit", "vector"])
        if kind == "vector":
            return numpy_to_vtk(self.random.random((count, 3)), deep=True)
        if kind == "i8":
            return numpy_to_vtk(self.integers(count), deep=True)
        if kind not in ("text", "bit"):
            return numpy_to_vtk((100.0 * self.random.random(count)).astype(kind), deep=True)
        array = vtkStringArray() if kind == "text" else vtkBitArray()
        array.SetNumberOfValues(count)
        for i in range(count):
            array.SetValue(i, f"{i % 7}" if kind == "text" else i % 2)
        return array

    def with_data(self, data):
        count, attributes = data.GetNumberOfPoints(), data.GetPointData()
        arrays = {f"a{i}": self.array(count) for i in range(self.random.integers(4))}
        if self.chance(0.4):
            numbers = self.one_of([0.02, 1.0]) * self.random.random(count)
            arrays["w"] = numpy_to_vtk(self.integers(count) if self.chance(0.1) else numbers, deep=True)
        if self.chance(0.15):
            marks = self.random.choice(np.array([0, 0, 1, 2], np.uint8), count)
            if self.chance(0.1):
                marks[:] = 1
            arrays["vtkGhostType"] = numpy_to_vtk(marks[1:] if self.chance(0.05) else marks, deep=True)
        for name, array in arrays.items():
            array.SetName(name)
            attributes.AddArray(array)
            if not array.IsA("vtkStringArray") and array.GetNumberOfComponents() == 1 and self.chance(0.3):
                attributes.SetActiveScalars(name)
        return data

    def data_set(self):
        if self.chance(0.1):
            data = vtkImageData()
            data.SetDimensions(*self.random.integers(1, 5, 3).tolist())
            data.SetSpacing(0.1, 0.3, 0.7)
        elif self.chance(0.05):
            data = vtkRectilinearGrid()
            sizes = self.random.integers(1, 5, 3)
            data.SetDimensions(*sizes.tolist())
            for setter, size in zip((data.SetXCoordinates, data.SetYCoordinates, data.SetZCoordinates), sizes):
                setter(numpy_to_vtk(self.integers(size - self.chance(0.05)), deep=True))
        else:
            data = self.one_of([vtkPolyData, vtkUnstructuredGrid])()
            points = vtkPoints()
            points.SetData(numpy_to_vtk(self.rows(), deep=True))
            data.SetPoints(points)
        return self.with_data(data)

    def data(self):
        if self.chance(0.85):
            return self.data_set()
        whole = vtkMultiBlockDataSet()
        for i in range(self.random.integers(4)):
            whole.SetBlock(i, self.one_of([self.data_set(), self.data_set(), None, vtkTable()]))
        return whole

    def surface(self):
        """A hull whose points have been moved, and which may have a hole."""
        if self.chance(0.2):
            return self.data()
        hull = compiled.vtkFFHullFilter()
        hull.SetFacetMode(self.one_of([0, 1]))
        hull.SetInputData(self.data_set())
        hull.SetNonFinitePoints(hull.NON_FINITE_IGNORE)
        hull.Update()
        if not hull.GetOutput().GetNumberOfPoints():
            return vtkPolyData()
        surface, rows = vtkPolyData(), vtk_to_numpy(hull.GetOutput().GetPoints().GetData())
        points, cells = vtkPoints(), vtkCellArray()
        rows = rows * self.one_of([1.0, 1.0 + 0.2 * self.random.random((len(rows), 1))])
        points.SetData(numpy_to_vtk(np.ascontiguousarray(rows), deep=True))
        surface.SetPoints(points)
        polygons, ids = hull.GetOutput().GetPolys(), vtkIdList()
        for i in range(1 if self.chance(0.1) else 0, polygons.GetNumberOfCells()):
            polygons.GetCellAtId(i, ids)
            cells.InsertNextCell(ids)
        if self.chance(0.1):
            corners = self.one_of([[0, 1], [0, 1, 0, 1]])
            cells.InsertNextCell(len(corners), corners)
        if self.chance(0.1):
            lines = vtkCellArray()
            lines.InsertNextCell(2, [0, 0])
            self.one_of([surface.SetVerts, surface.SetLines])(lines)
        surface.SetPolys(cells)
        return self.with_data(surface)

    def source(self, data):
        """Lines and polygons of the data's points, or of others."""
        source, count = vtkPolyData(), data.GetNumberOfPoints()
        if self.chance(0.5):
            points = vtkPoints()
            points.SetData(numpy_to_vtk(self.rows(), deep=True))
            source.SetPoints(points)
            count = source.GetNumberOfPoints()
            self.with_data(source)
        self.add_cells(source, count)
        return source

    def drawing(self):
        """A data set, most often with lines and polygons of its points."""
        data = self.data()
        if data.IsA("vtkUnstructuredGrid") and self.chance(0.8):
            points, data = data, vtkPolyData()
            data.SetPoints(points.GetPoints())
            data.GetPointData().ShallowCopy(points.GetPointData())
        if data.IsA("vtkPolyData"):
            self.add_cells(data, data.GetNumberOfPoints())
        return data

    def add_cells(self, source, count):
        for add, least in ((source.SetLines, 1), (source.SetPolys, 3)):
            cells = vtkCellArray()
            for _ in range(self.random.integers(4) if count else 0):
                ids = self.random.integers(0, count, self.random.integers(least, least + 3)).tolist()
                if self.chance(0.05):
                    ids[0] = self.one_of([-1, count])
                cells.InsertNextCell(len(ids), ids)
            add(cells)


def content(array):
    if array.IsA("vtkStringArray") or array.IsA("vtkBitArray"):
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    return vtk_to_numpy(array).tobytes()


def arrays_of(fields):
    """All arrays in their order, and which are active."""
    arrays = [fields.GetAbstractArray(i) for i in range(fields.GetNumberOfArrays())]
    found = [
        (one.GetName(), one.GetClassName(), one.GetNumberOfComponents(),
         None if one.GetName() and one.GetName().startswith(OF_THE_WORK) else content(one))
        for one in arrays
    ]  # fmt: skip
    if hasattr(fields, "NUM_ATTRIBUTES"):
        active = map(fields.GetAbstractAttribute, range(fields.NUM_ATTRIBUTES))
        found.append([one and one.GetName() for one in active])
    return found


def all_of(data):
    """All that makes up an output, down to the bits."""
    if data is None or not data.IsA("vtkDataSet"):
        is_tree = data is not None and data.IsA("vtkMultiBlockDataSet")
        blocks = [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())] if is_tree else []
        return [data and data.GetClassName(), *map(all_of, blocks)]
    found = [data.GetClassName(), data.GetNumberOfPoints(), data.GetNumberOfCells()]
    if data.IsA("vtkPointSet"):
        points = data.GetPoints()
        found.append(points and (points.GetData().GetClassName(), content(points.GetData())))
    if data.IsA("vtkImageData"):
        found.append(repr((data.GetExtent(), data.GetOrigin(), data.GetSpacing(), data.GetDirectionMatrix().GetData())))
    for cells in (data.GetVerts(), data.GetLines(), data.GetPolys()) if data.IsA("vtkPolyData") else ():
        ids = (cells.GetOffsetsArray(), cells.GetConnectivityArray()) if cells.GetNumberOfCells() else ()
        found.append([vtk_to_numpy(array).tolist() for array in ids])
    return found + [arrays_of(fields) for fields in (data.GetPointData(), data.GetCellData(), data.GetFieldData())]


def run(classes, name, calls, inputs):
    """What a class gives: all outputs, all figures of the report, all it says."""
    algorithm, said = getattr(classes, name)(), []

    def hear(caller, event, text):
        said.append((event, text.split("): ", 1)[1].strip()))

    hear.CallDataType = "string0"
    for event in ("ErrorEvent", "WarningEvent"):
        algorithm.AddObserver(event, hear)
    for method, *values in calls:
        getattr(algorithm, method)(*values)
    for port, data in enumerate(inputs):
        algorithm.SetInputDataObject(port, data)
    algorithm.Update()
    report = {one: getattr(algorithm, f"Get{one}")() for one in FIGURES if hasattr(algorithm, f"Get{one}")}
    outputs = [all_of(algorithm.GetOutputDataObject(i)) for i in range(algorithm.GetNumberOfOutputPorts())]
    return {"said": said, "report": report, "outputs": outputs}


@unittest.skipIf(WHY_NOT, WHY_NOT)
class TestBothKinds(unittest.TestCase):
    def compare(self, name, second=None, chance=1.0, first=Made.data):
        """In so many cases there is a second input, which the method makes for the first."""
        good = 0
        for seed in range(CASES):
            made = Made(seed)
            calls, inputs = made.calls(name), [first(made)]
            if second and made.chance(chance):
                inputs.append(second(made, inputs[0]))
            with self.subTest(seed=seed, calls=calls):
                expected, found = (run(classes, name, calls, inputs) for classes in (compiled, python))
                for part, value in expected.items():
                    self.assertEqual(found[part], value, part)
                good += expected["report"]["ErrorCode"] == 0
        self.assertGreater(good, CASES // 5)

    def test_hulls(self):
        self.compare("vtkFFHullFilter")

    def test_surfaces(self):
        self.compare("vtkFFConvexifyFilter", first=Made.surface)

    def test_triangulations(self):
        self.compare("vtkFFRegularTriangulationFilter", Made.source, 0.6)

    def test_power_diagrams(self):
        self.compare("vtkFFPowerDiagramFilter")

    def test_terrain_meshes(self):
        self.compare("vtkFFTerrainMeshFilter", Made.source, 0.4)

    def test_meshes(self):
        self.compare("vtkFFMeshFilter", lambda made, _: made.data_set(), 0.1, Made.drawing)

    def test_enclosed_points(self):
        self.compare("vtkFFSelectEnclosedPoints", lambda made, _: made.data_set())

    def test_interpolated_points(self):
        self.compare("vtkFFPointInterpolator2D", lambda made, _: made.data_set())

    def test_images(self):
        self.compare("vtkFFPointsToImage", Made.source, 0.3)


if __name__ == "__main__":
    unittest.main()
