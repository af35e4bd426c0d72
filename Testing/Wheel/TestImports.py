# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What import vtkflipflop gives in every build: layers when they are asked for, and a reason for what is not there."""

import subprocess
import sys
from importlib.util import find_spec

import pytest

import vtkflipflop
from vtkflipflop import _vtk_check

HAS_VTK = bool(find_spec("vtkmodules") or find_spec("cvista"))
MISSING = "VTK is missing: pip install vtk. Without it there is vtkflipflop.arrays"
WITHOUT_CLASSES = "from vtkflipflop import _vtk_check; _vtk_check.BUILT = False\n"
WITH_ANOTHER_VTK = """
from vtkflipflop import _vtk_check
def misfit(): raise ImportError("the VTK here is another one")
_vtk_check.check = misfit
"""


def printed(program):
    done = subprocess.run([sys.executable, "-W", "error", "-c", program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("before", ["", WITHOUT_CLASSES, WITH_ANOTHER_VTK], ids=["here", "without", "another"])
@pytest.mark.parametrize(
    "program",
    [
        "import inspect; inspect.getmembers(vtkflipflop)",
        "import pydoc; pydoc.render_doc(vtkflipflop)",
        "from vtkflipflop import *",
        "[getattr(vtkflipflop, name) for name in dir(vtkflipflop)]",
        "assert not hasattr(vtkflipflop, 'nonsense') and not hasattr(vtkflipflop, '_nonsense')",
    ],
)
def test_looking_around_raises_nothing(before, program):
    printed(f"import vtkflipflop\n{before}\n{program}")


@pytest.mark.parametrize("before", [WITHOUT_CLASSES, WITH_ANOTHER_VTK], ids=["without", "another"])
def test_classes_in_python_need_vtk_alone(before):
    program = "print(hasattr(vtkflipflop, 'vtkFFHullFilter'), dir(vtkflipflop), vtkflipflop.__all__)"
    said = printed(f"import vtkflipflop\n{before}\n{program}")
    assert said.startswith(str(HAS_VTK)) and ("vtkFF" in said) == HAS_VTK


def test_a_layer_is_loaded_when_it_is_asked_for():
    assert printed("import sys, vtkflipflop; print('numpy' in sys.modules)") == "False\n"
    assert "<class" in printed("import vtkflipflop; print(vtkflipflop.arrays.ConvexHull)")
    assert "arrays" in dir(vtkflipflop)
    assert ("pyvista" in dir(vtkflipflop)) == bool(find_spec("pyvista"))


def test_a_name_of_a_layer_is_found():
    for name in ("convex_hull", "InputError"):
        with pytest.raises(ImportError, match=f"from vtkflipflop.arrays import {name}.*vtkflipflop.pyvista"):
            exec(f"from vtkflipflop import {name}")
        with pytest.raises(AttributeError, match=f"no attribute '{name}'. It is in vtkflipflop.arrays"):
            getattr(vtkflipflop, name)
    for name in ("nonsense", "ConvexHul"):
        with pytest.raises(ImportError, match=f"no attribute '{name}'$"):
            exec(f"from vtkflipflop import {name}")


def test_a_build_without_classes_names_those_that_have_them(monkeypatch):
    monkeypatch.setattr(_vtk_check, "BUILT", False)
    match = "is a compiled class only.*has no compiled VTK classes. Those by CMake have them"
    with pytest.raises(ImportError, match=match if HAS_VTK else MISSING):
        exec("from vtkflipflop import vtkPFFHullFilter")
    with pytest.raises(AttributeError, match=match if HAS_VTK else MISSING):
        vtkflipflop.vtkPFFHullFilter


@pytest.mark.skipif(HAS_VTK, reason="VTK is there")
def test_without_vtk():
    assert vtkflipflop.vtk_classes is None
    with pytest.raises(ImportError, match=MISSING):
        exec("from vtkflipflop import vtkFFHullFilter")
    with pytest.raises(AttributeError, match=MISSING):
        vtkflipflop.vtkFFHullFilter


@pytest.mark.skipif(bool(find_spec("pyvista")), reason="PyVista is there")
def test_without_pyvista():
    assert not hasattr(vtkflipflop, "pyvista")
    with pytest.raises(ImportError, match="pyvista"):
        exec("from vtkflipflop import pyvista")
