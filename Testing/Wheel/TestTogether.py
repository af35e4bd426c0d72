# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkflipflop beside vtk and pyvista in one process: whatever is imported first, objects are shared."""

import itertools
import os
import re
import subprocess
import sys
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

import pytest

TOP = Path(__file__).resolve().parents[2]

PROGRAM = """
import {0}
import {1}
import {2}
source = vtk.vtkSphereSource()
hull = vtkflipflop.vtkFFHullFilter()
hull.SetInputConnection(source.GetOutputPort())
cleaned = vtk.vtkCleanPolyData()
cleaned.SetInputConnection(hull.GetOutputPort())
cleaned.Update()
assert isinstance(hull, vtk.vtkAlgorithm)
assert isinstance(hull.GetOutput(), vtk.vtkPolyData)
mesh = pyvista.wrap(cleaned.GetOutput())
points = mesh.points
points[0] = (0, 0, 9)  # the same memory
assert cleaned.GetOutput().GetPoint(0) == (0, 0, 9)
del hull, cleaned, source
libraries = [line.split()[-1] for line in open("/proc/self/maps") if "libvtkCommonCore" in line]
assert len(set(libraries)) == 1, libraries
print(mesh.n_points)
"""


def why_not():
    """Why the VTK classes cannot be used here; empty if they can."""
    try:
        from vtkflipflop import vtkFFHullFilter  # noqa: F401
    except ImportError as error:
        return str(error)
    return ""


@pytest.mark.skipif(bool(why_not()) or not find_spec("vtk"), reason=why_not() or "there is no package vtk")
@pytest.mark.parametrize("order", list(itertools.permutations(("vtk", "pyvista", "vtkflipflop"))))
def test_objects_are_shared(order):
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM.format(*order)], capture_output=True, text=True
    )
    assert done.returncode == 0 and done.stdout == "50\n", done.stdout + done.stderr


def test_nothing_of_the_machine_is_needed_but_its_c_library():
    import vtkflipflop

    folder = Path(vtkflipflop.__file__).parent
    allowed = {"libstdc++", "libgcc_s", "libm", "libc", "libpthread", "libdl", "librt"}
    (library,) = folder.glob("*.so")
    out = subprocess.run(["ldd", str(library)], capture_output=True, text=True, check=True).stdout
    assert {*re.findall(r"^\s*(\S+)\.so\S* => ", out, re.MULTILINE)} <= allowed, out


def test_the_version_is_that_of_the_project():
    import vtkflipflop

    text = (TOP / "CMakeLists.txt").read_text()
    expected = re.search(r"project\(FlipFlop\s+VERSION ([\d.]+)", text)[1]
    assert vtkflipflop.__version__ == version("vtkflipflop") == expected


FOREIGN = """
import pyvista
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkflipflop.pyvista import convex_hull
source = vtkSphereSource()
source.Update()
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, source.GetOutput())
for data in (source.GetOutput(), blocks, source.GetOutput().GetPoints()):
    try:
        convex_hull(data)
    except TypeError as error:
        print("is of another VTK" in str(error))
print(convex_hull(pyvista.Sphere()).n_points)
"""


@pytest.mark.skipif(not (find_spec("cvista") and find_spec("vtkmodules")), reason="needs vtk and cvista")
@pytest.mark.parametrize(("backend", "said"), [("vtk", ["842"]), ("cvista", ["True", "True", "True", "842"])])
def test_meshes_of_a_vtk_that_pyvista_does_not_run_on(backend, said):
    environment = {**os.environ, "PYVISTA_VTK_BACKEND": backend}
    done = subprocess.run([sys.executable, "-c", FOREIGN], capture_output=True, text=True, env=environment)
    assert done.stdout.split() == said, done.stdout + done.stderr
