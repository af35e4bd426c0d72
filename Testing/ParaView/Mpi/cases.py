# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pipelines that run over ranks: a source of distributed data, a filter of the plugin, settings. What the filters
make of such data the C++ tests hold (Testing/Cxx/Mpi); these connect them with ParaView's proxies."""

from typing import NamedTuple

import vtkflipflop
from paraview import simple

import pieces

AS_ONE = {"CompositeMode": 1}
POLYGONS = {"FacetMode": 1}
WEIGHTS = {"Weights": ["POINTS", "Weight"]}
HULL, TRIANGULATION, DIAGRAM = "ConvexHullFlipFlop", "Delaunay2DFlipFlop", "Voronoi2DFlipFlop"


class Case(NamedTuple):
    kind: str  # of the points, in pieces.KINDS
    settings: dict = {}
    filter: str = HULL


CASES = {
    "Ball": Case("ball"),
    "LatticePolygons": Case("lattice", POLYGONS),
    "LastRankOnly": Case("last"),
    "Blocks": Case("blocks"),
    "BlocksAsOne": Case("blocks", AS_ONE),
    "RealSpread": Case("spot", POLYGONS),
    "Delaunay": Case("disks", POLYGONS, TRIANGULATION),
    "Regular": Case("disks", WEIGHTS, TRIANGULATION),
    "Disks": Case("disks", {**WEIGHTS, "GenerateCellMeasures": 1}, DIAGRAM),
    # What cannot be done.
    "Nan": Case("with_nan"),
    "NanInTriangulation": Case("with_nan", {}, TRIANGULATION),
    "SomeWeights": Case("some_weights", WEIGHTS, TRIANGULATION),
    "NoWeights": Case("disks", {"Weights": ["POINTS", "Missing"]}, TRIANGULATION),
}


def plain_class(case):
    """The class that does in one process what a case does in all."""
    return {
        HULL: vtkflipflop.vtkPFFHullFilter,
        TRIANGULATION: vtkflipflop.vtkPFFRegularTriangulationFilter,
        DIAGRAM: vtkflipflop.vtkPFFPowerDiagramFilter,
    }[case.filter]


def pipeline(name):
    """The proxies of a case: its source and its filter."""
    case = CASES[name]
    data_type = "vtkMultiblockDataSet" if case.kind == "blocks" else "vtkPolyData"
    source = simple.ProgrammableSource(OutputDataSetType=data_type)
    source.Script = pieces.SOURCE.format(kind=case.kind)
    source.ScriptRequestInformation = pieces.INFORMATION
    return source, getattr(simple, case.filter)(Input=source, ReportAsFieldData=1, **case.settings)
