# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
Data in pieces, and what one process makes of them.

A programmable source calls fill() on each rank. append() joins what the ranks had, in their order, and
serial() runs a filter's plain class on it: that is what the ranks together have to give, bit for bit.
"""

import os

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints, vtkStringArray, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from digests import arrays, leaves

SOURCE = """
import pieces
pieces.fill(self, {kind!r})
"""
INFORMATION = """
import pieces
pieces.announce(self)
"""


def announce(source):
    """Without this, only the first rank would be asked for data."""
    information = source.GetExecutive().GetOutputInformation(0)
    information.Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)


def fill(source, kind):
    controller = vtkMultiProcessController.GetGlobalController()
    made = KINDS[kind](controller.GetLocalProcessId(), controller.GetNumberOfProcesses())
    source.GetOutputDataObject(0).ShallowCopy(made)


def cloud(points, **data):
    """Points with data; strings become a vtkStringArray."""
    poly = vtkPolyData()
    poly.SetPoints(vtkPoints())
    poly.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    for name, column in data.items():
        if isinstance(column, list):
            array = vtkStringArray()
            for value in column:
                array.InsertNextValue(value)
        else:
            array = numpy_to_vtk(numpy.ascontiguousarray(column), deep=True)
        array.SetName(name)
        poly.GetPointData().AddArray(array)
    return poly


def random_of(rank):
    return numpy.random.Generator(numpy.random.PCG64(1000 + rank))


def ball(rank, ranks, count=3000):
    random = random_of(rank)
    points = random.normal(size=(count, 3)).astype(numpy.float32)
    return cloud(
        points,
        Heat=random.random(count).astype(numpy.float32),
        Rank=numpy.full(count, rank, numpy.int8),
        Pair=random.random((count, 2)),
        Tag=[f"{rank}/{i}" for i in range(count)],
    )


def shell(rank, ranks):
    points = random_of(rank).normal(size=(1500, 3))
    return cloud(points / numpy.linalg.norm(points, axis=1)[:, None], Rank=numpy.full(1500, rank))


def lattice(rank, ranks):
    """The same cube of integers on each rank, in another order: all ties and duplicates there are."""
    points = numpy.indices((7, 7, 7)).reshape(3, -1).T.astype(float)
    return cloud(random_of(rank).permutation(points), Rank=numpy.full(343, rank))


def last(rank, ranks):
    return ball(rank, ranks) if rank == ranks - 1 else vtkPolyData()


def with_nan(rank, ranks):
    """The 18th point of the last rank is not finite."""
    points = vtk_to_numpy(ball(rank, ranks).GetPoints().GetData()).copy()
    if rank == ranks - 1:
        points[17, 1] = numpy.nan
    return cloud(points, Rank=numpy.full(len(points), rank))


def disks(rank, ranks):
    """Disks around integer places, many of them cocircular, with weights that hide some."""
    random = random_of(rank)
    points = random.integers(0, 60, (1200, 3)).astype(float)
    return cloud(points, Weight=random.integers(0, 12, 1200).astype(numpy.float32), Height=points[:, 2])


def some_weights(rank, ranks):
    """Weights on all ranks but the last."""
    poly = disks(rank, ranks)
    if rank == ranks - 1:
        poly.GetPointData().RemoveArray("Weight")
    return poly


def blocks(rank, ranks):
    """Blocks that every rank has, one has, none has, in two levels."""
    inner = vtkMultiBlockDataSet()
    inner.SetNumberOfBlocks(2)
    inner.SetBlock(0, shell(rank + 10, ranks) if rank == 1 else None)
    inner.SetBlock(1, lattice(rank, ranks))
    outer = vtkMultiBlockDataSet()
    outer.SetNumberOfBlocks(4)
    outer.SetBlock(0, ball(rank, ranks))
    outer.SetBlock(1, inner)
    outer.SetBlock(2, None)
    outer.SetBlock(3, ball(rank + 20, ranks) if rank == ranks - 1 else None)
    return outer


def spot(rank, ranks):
    """Real data, dealt out to the ranks point by point."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(os.environ["FLIPFLOP_SOURCE"], "Data", "spot.vtp"))
    reader.Update()
    return select(reader.GetOutput(), range(rank, reader.GetOutput().GetNumberOfPoints(), ranks))


KINDS = {maker.__name__: maker for maker in (ball, lattice, last, with_nan, disks, some_weights, blocks, spot)}


def select(data, points):
    """Some points of a data set, with their data, as a vtkPolyData."""
    poly = vtkPolyData()
    kept = vtkIdList()
    for point in points:
        kept.InsertNextId(point)
    poly.SetPoints(vtkPoints())
    poly.GetPoints().SetDataType(data.GetPoints().GetDataType())
    data.GetPoints().GetPoints(kept, poly.GetPoints())
    for array in arrays(data.GetPointData()):
        column = array.NewInstance()
        column.SetName(array.GetName())
        column.SetNumberOfComponents(array.GetNumberOfComponents())
        column.InsertTuplesStartingAt(0, kept, array)
        poly.GetPointData().AddArray(column)
    return poly


def append(datas):
    """What the ranks have, as one: block by block, each rank's points after those of the rank before."""
    joined = []
    for block in zip(*(leaves(data).values() for data in datas)):
        appended = vtkAppendPolyData()
        for piece in filter(None, block):
            appended.AddInputData(piece)
        if any(block):
            appended.Update()
        joined.append(appended.GetOutput() if any(block) else None)
    first = datas[0]
    if not first.IsA("vtkDataObjectTree"):
        return joined[0]
    whole = first.NewInstance()
    whole.CopyStructure(first)
    iterator = first.NewTreeIterator()
    iterator.SkipEmptyNodesOff()
    iterator.InitTraversal()
    for appended in joined:
        whole.SetDataSet(iterator, appended)
        iterator.GoToNextItem()
    return whole


def serial(filter_class, data, settings):
    """The filter's plain class, run on all of the data with the settings of the plugin's proxy."""
    plain = filter_class()
    plain.SetReportAsFieldData(True)
    for name, value in settings.items():
        if name == "Weights":
            plain.SetInputArrayToProcess(0, 0, 0, 0, value[1])
        else:
            getattr(plain, f"Set{name}")(value)
    plain.SetInputDataObject(data)
    plain.Update()
    return plain


def rows(fields):
    """Each tuple of a data set's arrays but ghost marks, as bytes, beside their names and types, sorted."""
    columns = {}
    own = [array for array in arrays(fields) if array.GetName() != vtkDataSetAttributes.GhostArrayName()]
    for array in sorted(own, key=lambda array: array.GetName()):
        if array.IsA("vtkStringArray"):
            column = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
        else:
            values = vtk_to_numpy(array)
            column = [row.tobytes() for row in values]
            columns[f"type of {array.GetName()}"] = [values.dtype.str] * len(values)
        columns[array.GetName()] = column
    return list(columns), list(zip(*columns.values()))


def union(shares):
    """
    What polygonal data in shares has: each point of an id with its place and data, and the cells by the ids of
    their corners, with their data. Of a point that several shares have, all but one are marked as duplicates.
    """
    points, duplicates, cells, names = [], [], [], set()
    for poly in shares:
        if not poly.GetNumberOfPoints():
            continue
        ids = vtk_to_numpy(poly.GetPointData().GetArray("vtkOriginalPointIds"))
        places = vtk_to_numpy(poly.GetPoints().GetData())
        point_names, point_rows = rows(poly.GetPointData())
        names.add((places.dtype.str, *point_names))
        ghosts_of = poly.GetPointGhostArray()
        marks = vtk_to_numpy(ghosts_of) if ghosts_of else numpy.zeros(len(ids), numpy.uint8)
        for i, place, row, mark in zip(ids, places, point_rows, marks):
            (duplicates if mark else points).append((int(i), place.tobytes(), row))
        cell_rows = rows(poly.GetCellData())[1] or [()] * poly.GetNumberOfCells()
        corners = vtkIdList()
        for cell in range(poly.GetNumberOfCells()):
            poly.GetCellPoints(cell, corners)
            by_ids = tuple(int(ids[corners.GetId(k)]) for k in range(corners.GetNumberOfIds()))
            cells.append((poly.GetCellType(cell), by_ids, cell_rows[cell]))
    assert set(duplicates) <= set(points), "a duplicate is not as the point that is its owner's"
    return names, sorted(points), sorted(cells)


def union_of_cells(shares):
    """The cells of power diagrams, which have ids, by their corners' places."""
    cells = []
    for poly in shares:
        names, cell_rows = rows(poly.GetCellData())
        corners = vtkIdList()
        for cell in range(poly.GetNumberOfCells()):
            poly.GetCellPoints(cell, corners)
            places = [poly.GetPoint(corners.GetId(k)) for k in range(corners.GetNumberOfIds())]
            cells.append((names, cell_rows[cell], places))
    return (sorted(cells),)


def as_sent(found):
    """The digest of data that VTK has sent to another process: VTK 9.6 makes char of signed char there."""
    if vtkVersion.GetVTKMajorVersion() * 100 + vtkVersion.GetVTKMinorVersion() < 906:
        return found
    return {part.replace(" signed char ", " char "): value for part, value in found.items()}
