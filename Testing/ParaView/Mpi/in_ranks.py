# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
Run every case on all ranks, by mpiexec -n N pvbatch --sym in_ranks.py FOLDER, and write what each rank had
and got into the folder: its data as <case>.<rank>, the rest into <rank>.json. TestPieces.py judges it.
"""

import json
import os
import sys

import cases
import digests
import observing
import pieces
from vtkmodules.vtkCommonCore import vtkCharArray
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from vtkflipflop import vtkPFFHullFilter

FOUND = ("Dimension", "EngineUsed", "NumberOfInputPoints", "NumberOfNonFinitePoints")
FOUND_OF_HULL = ("Volume", "Area")


def keep(data, path):
    """Write data as VTK sends it to another rank; of all types, only signed char becomes another."""
    buffer = vtkCharArray()
    vtkCommunicator.MarshalDataObject(data, buffer)
    with open(path, "wb") as file:
        file.write(memoryview(buffer))


def run(name, folder, rank, messages):
    source, proxy = cases.pipeline(name, folder)
    source.UpdatePipeline()
    keep(source.GetClientSideObject().GetOutputDataObject(0), os.path.join(folder, f"{name}.{rank}"))
    messages.take()
    proxy.UpdatePipeline()
    algorithm = proxy.GetClientSideObject()
    outputs = [algorithm.GetOutputDataObject(port) for port in range(algorithm.GetNumberOfOutputPorts())]
    if cases.CASES[name].filter in cases.PLANAR:
        for port, output in enumerate(outputs):
            keep(output, os.path.join(folder, f"{name}-{port}.{rank}"))
    found = FOUND if cases.CASES[name].filter in cases.PLANAR else FOUND + FOUND_OF_HULL
    return {
        "messages": messages.take(),
        "error": algorithm.GetErrorCode(),
        "digests": [digests.digest(output) for output in outputs],
        "points": [digests.number_of_points(output) for output in outputs],
        "found": {key: getattr(algorithm, f"Get{key}")() for key in found},
    }


def stop(rank, ranks):
    """Numbers of points: of a run that the last rank aborts, of the next update, and with the flag reset."""
    hull = vtkPFFHullFilter()
    hull.SetInputData(pieces.ball(rank, ranks))
    counts = []
    if rank == ranks - 1:
        hull.AddObserver("ProgressEvent", lambda caller, event: counts or hull.SetAbortExecute(1))
    for again in (False, False, True):
        if again:
            hull.SetAbortExecute(0)
            hull.Modified()
        hull.Update()
        counts.append(hull.GetOutput().GetNumberOfPoints())
    return counts


def main(folder):
    controller = vtkMultiProcessController.GetGlobalController()
    rank = controller.GetLocalProcessId()
    messages = observing.Messages()
    results = {name: run(name, folder, rank, messages) for name in cases.CASES}
    results["stop"] = stop(rank, controller.GetNumberOfProcesses())
    with open(os.path.join(folder, f"{rank}.json"), "w") as file:
        json.dump(results, file)


main(sys.argv[1])
