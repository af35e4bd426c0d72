# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
The filters over ranks, in pvbatch: bit for bit what the plain classes make of the appended pieces in one
process. The cases are in cases.py; in_ranks.py runs them all in one mpiexec.
"""

import json
import os
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkCharArray
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet,
    vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection,
)
from vtkmodules.vtkIOParallelXML import (
    vtkXMLPartitionedDataSetCollectionWriter,
    vtkXMLPPolyDataWriter,
    vtkXMLPUnstructuredGridWriter,
)
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter
from vtkmodules.vtkParallelCore import vtkCommunicator

import cases
import digests
import observing
import pieces
import pipelines
import ranks

GATHERED = "are gathered on one, which triangulates them alone: rounding broke a power cell"


def write_files(folder):
    """Files in pieces, blocks and partitions, as other programs leave them."""
    for name, source, writer in (
        ("sphere.pvtp", cases.sphere(), vtkXMLPPolyDataWriter()),
        ("grid.pvtu", cases.grid(), vtkXMLPUnstructuredGridWriter()),
    ):
        source.UpdatePipeline()
        writer.SetInputConnection(source.GetClientSideObject().GetOutputPort(0))
        writer.SetDataModeToBinary()  # appended data cannot be read with every expat
        writer.SetNumberOfPieces(5)
        writer.SetEndPiece(4)
        writer.SetFileName(os.path.join(folder, name))
        writer.Write()

    blocks = vtkMultiBlockDataSet()
    for block in (0, 1, 3, 4):
        blocks.SetBlock(block, pieces.shell(block, 5))
    collection = vtkPartitionedDataSetCollection()
    for place, count in enumerate((4, 1, 3)):
        partitions = vtkPartitionedDataSet()
        for partition in range(count):
            partitions.SetPartition(partition, pieces.shell(10 * place + partition, count))
        collection.SetPartitionedDataSet(place, partitions)
    for name, data, writer in (
        ("blocks.vtm", blocks, vtkXMLMultiBlockDataWriter()),
        ("partitions.vtpc", collection, vtkXMLPartitionedDataSetCollectionWriter()),
    ):
        writer.SetInputDataObject(data)
        writer.SetDataModeToBinary()
        writer.SetFileName(os.path.join(folder, name))
        writer.Write()


class TestPieces(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.maxDiff = None
        cls.messages = observing.Messages()
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = temporary.name
        write_files(cls.folder)
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "in_ranks.py")
        process = ranks.start("pvbatch", "--dr", "--sym", script, cls.folder)
        cls.addClassCleanup(ranks.stop, process)
        output, _ = process.communicate()
        if process.returncode != 0:
            raise RuntimeError(f"pvbatch on {ranks.RANKS} ranks ended with {process.returncode}:\n{output}")
        cls.results = []
        for rank in range(ranks.RANKS):
            with open(os.path.join(cls.folder, f"{rank}.json")) as file:
                cls.results.append(json.load(file))

    def kept(self, name, rank):
        """The data that a rank had."""
        raw = numpy.fromfile(os.path.join(self.folder, f"{name}.{rank}"), numpy.int8)
        buffer = vtkCharArray()
        buffer.DeepCopy(numpy_to_vtk(raw))
        return vtkCommunicator.UnMarshalDataObject(buffer)

    def check_equal(self, found, data, case):
        """What one rank gave is what the plain class gives of the data in this process."""
        self.messages.take()
        plain = pieces.serial(cases.plain_class(case), data, case.settings)
        outputs = [plain.GetOutputDataObject(port) for port in range(plain.GetNumberOfOutputPorts())]
        self.assertEqual(found["points"], [digests.number_of_points(output) for output in outputs])
        self.assertEqual(
            [pieces.as_sent(one) for one in found["digests"]], [digests.digest(output) for output in outputs]
        )
        self.assertEqual(found["error"], plain.GetErrorCode())
        for name, value in found["found"].items():
            self.assertEqual(value, getattr(plain, f"Get{name}")(), name)
        return plain, [list(told) for told in self.messages.take()]

    def check_shares(self, name, case, datas, results):
        """Together, the ranks have the cells, the points and their data of the plain class."""
        self.messages.take()
        plain = pieces.serial(cases.plain_class(case), pieces.append(datas), case.settings)
        told = [message for message in results[0]["messages"] if GATHERED not in message[1]]
        self.assertEqual(told, [list(message) for message in self.messages.take()])
        union = pieces.union_of_cells if case.filter == cases.DIAGRAM else pieces.union
        for port in range(plain.GetNumberOfOutputPorts()):
            shares = [self.kept(f"{name}-{port}", rank) for rank in range(ranks.RANKS)]
            whole = pieces.blocks_of(plain.GetOutputDataObject(port))
            for place, expected in enumerate(whole):
                parts = [part for share in shares for part in pieces.blocks_of(share)[place]]
                for found, wanted in zip(union(parts), union(expected)):
                    self.assertEqual(len(found), len(wanted), (port, place))
                    self.assertTrue(found == wanted, (port, place))  # to show how they differ takes minutes
        for result in results[1:]:
            self.assertEqual(result["error"], 0)
            self.assertEqual(result["messages"], [])
            if told == results[0]["messages"]:  # nothing was gathered
                self.assertEqual(result["found"]["Dimension"], plain.GetDimension())
        for key, value in results[0]["found"].items():
            self.assertEqual(value, getattr(plain, f"Get{key}")(), key)

    def check_case(self, name):
        case = cases.CASES[name]
        datas = [self.kept(name, rank) for rank in range(ranks.RANKS)]
        results = [result[name] for result in self.results]
        counts = [digests.number_of_points(data) for data in datas]
        with_points = sum(count > 0 for count in counts)
        allowed = {"all": [ranks.RANKS], "some": range(2, ranks.RANKS + 1), "one": [1], "none": [0]}
        self.assertIn(with_points, allowed[case.ranks_with_points], counts)

        if case.filter == cases.CONVEXIFY:
            for result, data in zip(results, datas):
                plain, told = self.check_equal(result, data, case)
                self.assertEqual(result["messages"], told)
                self.assertGreater(plain.GetNumberOfInputPoints(), 0)
            return
        if case.filter in cases.PLANAR and not case.fails:
            self.check_shares(name, case, datas, results)
            return
        if case.says:
            expected = [["Error", case.says.format(last=ranks.RANKS - 1)]]
        else:
            _, expected = self.check_equal(results[0], pieces.append(datas, case.settings.get("CompositeMode")), case)
        self.assertEqual(results[0]["error"] != 0, case.fails)
        self.assertEqual(results[0]["points"][0] > 0, with_points > 0 and not case.fails)
        self.assertEqual(results[0]["messages"], expected)
        for result in results[1:]:
            self.assertEqual(result["points"], [0] * len(result["points"]))
            self.assertEqual(result["messages"], [])
            self.assertEqual(result["error"], results[0]["error"])

    def test_stop(self):
        """What one rank aborts is aborted on all, until all may run again: none waits for another."""
        first, *others = [result["stop"] for result in self.results]
        self.assertEqual(first[:2], [0, 0])
        self.assertGreater(first[2], 0)
        self.assertEqual(others, [[0, 0, 0]] * len(others))

    def test_baseline(self):
        """The ranks' hull of real data, the same as the serial one, is that which CGAL found."""
        case = cases.CASES["RealOnOneRank"]
        datas = [self.kept("RealOnOneRank", rank) for rank in range(ranks.RANKS)]
        hull, _ = self.check_equal(self.results[0]["RealOnOneRank"], pieces.append(datas), case)
        self.assertEqual(pipelines.cells_by_ids(hull.GetOutput()), pipelines.baseline("spot"))


def add_tests():
    for name in cases.CASES:
        setattr(TestPieces, f"test_{name}", lambda self, name=name: self.check_case(name))


add_tests()
if __name__ == "__main__":
    unittest.main()
