# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package is typed: mypy knows what each layer takes and gives, and finds nothing to complain of in it."""

import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

import vtkflipflop

pytest.importorskip("mypy", reason="mypy is not installed")

ARRAYS = """
import numpy as np
import vtkflipflop
from numpy.typing import NDArray
from typing import assert_type
from vtkflipflop.arrays import CentroidalCells, PrescribedAreas, centroidal_cells, prescribed_areas
from vtkflipflop.arrays import CellSelection, RescaledTriangulation
from vtkflipflop.arrays import ConvexHull, Diameter, HullBatch, InputError, OrientedBox, Polygons
from vtkflipflop.arrays import Validation, convex_hull, convex_hulls, convexify, power_diagram, regular_triangulation
from vtkflipflop.arrays import PowerDiagram, RegularTriangulation, AlphaComplex, ConstrainedTriangulation, TerrainMesh
from vtkflipflop.arrays import alpha_complex, refined_mesh, terrain_mesh, validate, voronoi_diagram
from vtkflipflop.arrays import directions_of, spherical_triangulation, spherical_voronoi
from pathlib import Path
from vtkflipflop.arrays import Streamed, TriangulationBatch, regular_triangulations, constrained_triangulation, stream

hull = convex_hull([[0.0, 0, 0]], threads=2, progress=print)
assert_type(hull, ConvexHull)
assert_type(hull.vertices, NDArray[np.int64])
assert_type(hull.simplices, NDArray[np.int64])
assert_type(hull.polygons, Polygons)
assert_type(hull.volume, float)
assert_type(hull.area, float)
assert_type(hull.statistics, dict[str, float])
assert_type(hull.equations, NDArray[np.float64])
assert_type(hull.neighbors, NDArray[np.int64])
assert_type(hull.diameter(), Diameter)
assert_type(hull.minimal_box(), OrientedBox)
assert_type(validate(hull), Validation)
assert_type(convexify(hull.points, hull.simplices), ConvexHull)
assert_type(hull.contains([0, 0, 0]), np.bool_ | NDArray[np.bool_])
assert_type(hull.side([0, 0, 0]), np.int8 | NDArray[np.int8])
assert_type(hull.distance(hull.points), np.float64 | NDArray[np.float64])
assert_type(hull.support([[0, 0, 1]]), np.int64 | NDArray[np.int64])
print(hull.points[hull.contains(hull.points)], bool(hull.contains([0, 0, 0])))
assert_type(len(hull.polygons), int)
assert_type(hull.polygons[0], NDArray[np.int64])
assert_type([ring for ring in hull.polygons], list[NDArray[np.int64]])
batch = convex_hulls(np.zeros((4, 3)), [0, 2, 4])
assert_type(batch, HullBatch)
assert_type(batch[0], ConvexHull)
assert_type(batch[1:], list[ConvexHull])
assert_type(batch.volumes, NDArray[np.float64])
assert_type(convex_hulls([np.zeros((4, 3)), np.zeros((0, 3))]), HullBatch)
assert_type(regular_triangulations([np.zeros((4, 2))], weights=[np.zeros(4)]), TriangulationBatch)
assert_type(hull.edges, NDArray[np.int64])
triangulation = regular_triangulation(np.zeros((4, 2)), np.zeros(4))
assert_type(triangulation, RegularTriangulation)
assert_type(regular_triangulation(np.zeros((4, 2)), rescale=True), RescaledTriangulation)
assert_type(triangulation.hidden, NDArray[np.int64])
assert_type(triangulation.power_diagram(), PowerDiagram)
assert_type(triangulation.locate([0, 0]), np.int64 | NDArray[np.int64])
assert_type(triangulation.find_simplex([0, 0]), np.int64 | NDArray[np.int64])
assert_type(triangulation.nearest([0, 0]), np.int64 | NDArray[np.int64])
assert_type(triangulation.interpolate([1, 2], [0, 0], "natural"), np.float64 | NDArray[np.float64])
assert_type(power_diagram([[0.0, 1]]).regions, list[NDArray[np.int64]])
assert_type(power_diagram([[0.0, 1]]).neighbors, tuple[NDArray[np.int64], NDArray[np.int64]])
assert_type(voronoi_diagram([[0.0, 1]]).cells, Polygons)
assert_type(spherical_voronoi([[0.0, 0]], lonlat=True).areas, NDArray[np.float64])
assert_type(spherical_triangulation(directions_of([0.0, 9], 0)).simplices, NDArray[np.int64])
assert_type(triangulation.voronoi_diagram().rays.directions, NDArray[np.float64])
constrained = regular_triangulation(np.zeros((4, 2)), constraints=[[0, 1], [1, 2, 3]], threads=1)
assert_type(constrained, ConstrainedTriangulation)
assert_type(constrained.fixed_edges, NDArray[np.int64])
assert_type(constrained.dropped, int)
assert_type(constrained.interpolate([1, 2], [0, 0], fill_value=0), np.float64 | NDArray[np.float64])
assert_type(regular_triangulation(np.zeros((4, 2)), polygons=triangulation.boundary), ConstrainedTriangulation)
assert_type(regular_triangulation([[0, 1]], constraints=[], polygons=[np.arange(3)]), ConstrainedTriangulation)
assert_type(triangulation.alphas, NDArray[np.float64])
assert_type(triangulation.alpha_complex(1), AlphaComplex)
assert_type(alpha_complex([[0.0, 1]], 0.5).within, NDArray[np.bool_])
assert_type(alpha_complex([[0.0, 1]], 0.5).boundary, Polygons)
assert_type(triangulation.with_cells(triangulation.within_edge_length(1)), CellSelection)
assert_type(alpha_complex([[0.0, 1]], 0.5).cells.locate([0, 0]), np.int64 | NDArray[np.int64])
assert_type(centroidal_cells([[0.0, 1]], domain=(0, 1, 0, 1)), CentroidalCells)
assert_type(centroidal_cells([[0.0, 1]]).diagram, PowerDiagram)
assert_type(prescribed_areas([[0.0, 1]], [1], [[0, 0], [1, 0], [0, 1]]), PrescribedAreas)
assert_type(prescribed_areas([[0.0, 1]]).weights, NDArray[np.float64])
assert_type(terrain_mesh([[0.0, 1, 2]], tolerance=1, constraints=[[0, 0]]), TerrainMesh)
assert_type(terrain_mesh([[0.0, 1]], [2.0], max_vertices=9).errors, NDArray[np.float64])
assert_type(refined_mesh([[0.0, 1]], polygons=[[0, 0, 0]], holes=[[1, 2]]).simplices, NDArray[np.int64])
assert_type(constrained_triangulation([[0.0, 1, 2]], np.zeros((2, 3))).point_origin, NDArray[np.uint8])
assert_type(stream(["a.npz", np.zeros((2, 2)), {"points": [[0, 0]]}], "out", kind="hull", memory=2**30), Streamed)
assert_type(stream([], Path("out")).files, tuple[Path, ...])
assert_type(InputError("").index, int)
assert_type(vtkflipflop.arrays.convex_hull([[0.0, 0, 0]]), ConvexHull)
assert_type(power_diagram([[0.0, 1]], domain=((0, 0), (1, 1))), PowerDiagram)
"""

WRONG = """
from vtkflipflop.arrays import convex_hull, stream
convex_hull([[0, 0, 0]], colour="red")
convex_hull([[0, 0, 0]]).volume = 3.0
convex_hull([[0, 0, 0]]).corners
convex_hull([[0, 0, 0]], facets="squares")
convex_hull([[0, 0, 0]], non_finite="drop", engine="gpu")
stream(iter([]), "out", kind="terrain")
"""


def said(tmp_path, *arguments):
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path), *arguments]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    return done.stdout + done.stderr


def test_the_array_layer(tmp_path):
    (tmp_path / "use.py").write_text(ARRAYS)
    assert said(tmp_path, "use.py").startswith("Success")


def test_what_is_wrong_is_found(tmp_path):
    (tmp_path / "use.py").write_text(WRONG)
    lines = [line for line in said(tmp_path, "use.py").splitlines() if "error:" in line]
    assert [line.split(":")[1] for line in lines] == ["3", "4", "5", "6", "7", "7", "8", "8"], lines


def test_the_package_itself(tmp_path):
    assert said(tmp_path, "-p", "vtkflipflop.arrays").startswith("Success")


@pytest.mark.skipif(not importlib.util.find_spec("pyvista"), reason="no PyVista")
def test_the_functions_for_pyvista(tmp_path):
    (tmp_path / "use.py").write_text(
        "import pyvista as pv\n"
        "from vtkflipflop.pyvista import convex_hull, regular_triangulation\n"
        "convex_hull(pv.PolyData(), facets='polygons', threads=2)\n"
        "shown, hidden = regular_triangulation([[0.0, 0, 0]], return_hidden_points=True)\n"
        "convex_hull(pv.PolyData(), facets='squares')\n"
        "convex_hull(pv.PolyData(), colour='red')\n"
    )
    lines = [line for line in said(tmp_path, "use.py").splitlines() if line.startswith("use.py") and "error:" in line]
    assert [line.split(":")[1] for line in lines] == ["5", "6"], lines


@pytest.mark.skipif(
    not (Path(vtkflipflop.__file__).parent / "vtkFiltersFlipFlop.pyi").exists()
    or not importlib.util.find_spec("vtkmodules"),
    reason="no VTK classes, or no VTK",
)
def test_the_vtk_classes(tmp_path):
    (tmp_path / "use.py").write_text(
        "from typing import assert_type\n"
        "from vtkflipflop import vtkFFHullFilter, vtkPFFRegularTriangulationFilter\n"
        "hull = vtkFFHullFilter()\n"
        "assert_type(hull.GetVolume(), float)\n"
        "hull.SetNumberOfThreads('two')\n"
    )
    lines = [line for line in said(tmp_path, "use.py").splitlines() if "error:" in line]
    assert [line.split(":")[1] for line in lines] == ["5"], lines
