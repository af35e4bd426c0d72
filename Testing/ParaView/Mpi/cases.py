# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pipelines that run over ranks: a source of distributed data, a filter of the plugin, its settings."""

import os
from typing import Callable, NamedTuple

import vtkflipflop
from paraview import simple

import pieces
import pipelines

AS_ONE = {"CompositeMode": 1}
POLYGONS = {"FacetMode": 1}
HULL, CONVEXIFY = "ConvexHullFlipFlop", "ConvexifyFlipFlop"
TRIANGULATION = "RegularWeightedDelaunayTriangulationFlipFlop"
DELAUNAY, DIAGRAM = "DelaunayTriangulation2DFlipFlop", "VoronoiPowerDiagramFlipFlop"
PLANAR = TRIANGULATION, DELAUNAY, DIAGRAM


class Case(NamedTuple):
    source: Callable  # of the folder with the files that write_files() made; gives a proxy
    settings: dict = {}
    filter: str = HULL
    ranks_with_points: str = "all"  # or "some" (two at least), "one", "none"
    fails: bool = False
    says: str = ""  # the error where only ranks can have it, not one process


def made(kind, data_type="vtkPolyData"):
    def source(folder=None):
        proxy = simple.ProgrammableSource(OutputDataSetType=data_type)
        proxy.Script = pieces.SOURCE.format(kind=kind)
        proxy.ScriptRequestInformation = pieces.INFORMATION
        return proxy

    source.kind = kind
    return source


def of_file(name):
    return lambda folder: simple.OpenDataFile(os.path.join(folder, name))


def real(name):
    """Real data as it comes: a file of one piece, which the first rank reads."""
    return lambda folder=None: pipelines.real(name)


def sphere(folder=None):
    return simple.Sphere(ThetaResolution=60, PhiResolution=40)


def grid(folder=None):
    return simple.CleantoGrid(Input=simple.Wavelet(WholeExtent=[-6, 6] * 3))


def group(folder=None):
    return simple.GroupDatasets(Input=[sphere(), grid()])


def with_ghosts(folder=None):
    """A surface, with a layer of cells of the other ranks."""
    ghost_cells = getattr(simple, "GhostCells", None) or simple.GhostCellsGenerator  # before ParaView 6
    return ghost_cells(Input=sphere())


def made_blocks(kind):
    return made(kind, "vtkMultiblockDataSet")


def made_partitions(kind):
    return made(kind, "vtkPartitionedDataSetCollection")


WEIGHTS = {"Weights": ["POINTS", "Weight"]}
IDS = {"VisiblePointIds": 1}  # as the panel of the power diagram has it
UNLIKE = (
    "Processes have different numbers of blocks: process 0 has 2, process {last} has 3. Give all the same, "
    "without data where there is none, or merge the blocks."
)
CASES = {
    # Sources that give pieces in ways of their own.
    "Sphere": Case(sphere),
    "Grid": Case(grid),
    "GridPolygons": Case(grid, POLYGONS),
    "RealOnOneRank": Case(real("spot"), POLYGONS, ranks_with_points="one"),
    "RealSpread": Case(made("spot"), POLYGONS),
    "SphereGhosts": Case(with_ghosts),
    "FileOfPolyData": Case(of_file("sphere.pvtp")),
    "FileOfGrids": Case(of_file("grid.pvtu")),
    # Points made for each rank.
    "Ball": Case(made("ball")),
    "BallWithIds": Case(made("ball"), {"VisiblePointIds": 1, "NumberOfThreads": 2, "VBiased": 1}),
    "BallWithoutData": Case(made("ball"), {"PassPointData": 0}),
    "Shell": Case(made("shell")),
    "Lattice": Case(made("lattice")),
    "LatticePolygons": Case(made("lattice"), POLYGONS),
    "Plane": Case(made("plane"), POLYGONS),
    "Line": Case(made("line")),
    "One": Case(made("one")),
    "LastRankOnly": Case(made("last"), ranks_with_points="one"),
    "Nothing": Case(made("nothing"), ranks_with_points="none"),
    "UnlikeArrays": Case(made("unlike_arrays")),
    "Ghosts": Case(made("ghosts")),
    "NanIgnored": Case(made("with_nan"), {"NonFinitePoints": 1}),
    # Blocks, in our own way and as ParaView's readers give them.
    "Blocks": Case(made_blocks("blocks")),
    "BlocksAsOne": Case(made_blocks("blocks"), AS_ONE),
    "Group": Case(group),
    "GroupAsOne": Case(group, {**AS_ONE, **POLYGONS}),
    "FileOfBlocks": Case(of_file("blocks.vtm"), ranks_with_points="some"),
    "FileOfPartitions": Case(of_file("partitions.vtpc"), ranks_with_points="some"),
    "FileOfPartitionsAsOne": Case(of_file("partitions.vtpc"), AS_ONE, ranks_with_points="some"),
    "UnlikePartitions": Case(made_partitions("unlike_partitions")),
    "UnlikePartitionsAsOne": Case(made_partitions("unlike_partitions"), AS_ONE),
    "Partitions": Case(made("partitions", "vtkPartitionedDataSet")),
    # In the plane.
    "Disks": Case(made("disks"), {**WEIGHTS, **IDS}, DIAGRAM),
    "Delaunay": Case(made("disks"), POLYGONS, DELAUNAY),
    "Voronoi": Case(made("disks"), IDS, DIAGRAM),
    "DisksShared": Case(made("disks"), WEIGHTS, TRIANGULATION),
    "DelaunayShared": Case(made("disks"), POLYGONS, TRIANGULATION),
    "TerrainShared": Case(made("sainthelens"), {"Weights": ["POINTS", "Elevation"]}, TRIANGULATION),
    "Terrain": Case(made("sainthelens"), {"Weights": ["POINTS", "Elevation"], **IDS}, DIAGRAM),
    "TerrainOnOneRank": Case(real("autzen"), {}, TRIANGULATION, "one"),
    "BestPlane": Case(made("plane"), {"ProjectionPlaneMode": 2}, TRIANGULATION),
    "TriangulationOfBlocks": Case(made_blocks("blocks"), {}, TRIANGULATION),
    "TriangulationOfUnlikePartitions": Case(made_partitions("unlike_partitions"), {}, TRIANGULATION),
    # A filter like any other: each rank has a result of its own.
    "Convexify": Case(made("star"), {}, CONVEXIFY),
    # What cannot be done.
    "Nan": Case(made("with_nan"), fails=True),
    "NanInTriangulation": Case(made("with_nan"), {}, TRIANGULATION, fails=True),
    "SomeWeights": Case(made("some_weights"), WEIGHTS, TRIANGULATION, fails=True),
    "NoWeights": Case(made("disks"), {"Weights": ["POINTS", "Missing"]}, TRIANGULATION, fails=True),
    "UnlikeBlocks": Case(made_blocks("unlike_blocks"), fails=True, says=UNLIKE),
    "UnlikeBlocksInTriangulation": Case(
        made_blocks("unlike_blocks"), {}, TRIANGULATION, fails=True, says=UNLIKE
    ),
    # And after all of that:
    "BallAgain": Case(made("ball")),
}


def plain_class(case):
    """The class that does in one process what a case does in all."""
    return {
        HULL: vtkflipflop.vtkPFFHullFilter,
        CONVEXIFY: vtkflipflop.vtkFFConvexifyFilter,
        TRIANGULATION: vtkflipflop.vtkPFFRegularTriangulationFilter,
        DELAUNAY: vtkflipflop.vtkPFFDelaunayFilter,
        DIAGRAM: vtkflipflop.vtkPFFPowerDiagramFilter,
    }[case.filter]


def pipeline(name, folder=None):
    """The proxies of a case: its source and its filter."""
    case = CASES[name]
    source = case.source(folder)
    return source, getattr(simple, case.filter)(Input=source, **case.settings)
