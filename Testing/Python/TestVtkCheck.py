# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Beside a VTK that they do not fit, the VTK classes say so before a library is loaded; the VTKs here are stand-ins."""

import importlib
import inspect
import os
import pydoc
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import vtkflipflop
import vtkmodules
from vtkflipflop import _vtk_check

PROGRAM = """
import sys
sys.path[:0] = {path!r}
import vtkflipflop  # what needs no VTK is there in any case
try:
    from vtkflipflop import vtkFFHullFilter
except ImportError as error:
    print(error)
assert not [line for line in open("/proc/self/maps") if "libvtk" in line]
"""

# The true module's file is large; its strings are what counts.
STRINGS = b"\x7fELF\0%s\0"


@unittest.skipUnless(_vtk_check.BUILT, "a build without compiled VTK classes")
class TestVtkCheck(unittest.TestCase):
    def said(self, version, library, hidden=False):
        """What the import says beside a VTK of that version, whose module is linked with that library."""
        with tempfile.TemporaryDirectory() as folder:
            if not hidden:
                modules = Path(folder, "vtkmodules")
                modules.mkdir()
                (modules / "__init__.py").write_text(f'__version__ = "{version}"\n')
                (modules / "vtkCommonCore.cpython-311-x86_64-linux-gnu.so").write_bytes(STRINGS % library.encode())
            package = Path(folder, "vtkflipflop")
            package.mkdir()
            for file in ("__init__.py", "_vtk.py", "_vtk_check.py"):
                (package / file).write_bytes(Path(vtkflipflop.__file__).with_name(file).read_bytes())
            done = subprocess.run(
                # -S: no VTK but that of the folder
                [sys.executable, "-S", "-c", PROGRAM.format(path=[folder])],
                env={key: value for key, value in os.environ.items() if key != "PYTHONPATH"},
                capture_output=True,
                text=True,
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            return done.stdout.replace(folder, "FOLDER")

    def test_its_own(self):
        """The stand-in is taken: what is missing next is the wrapped module."""
        self.assertIn("vtkflipflop.vtkFiltersFlipFlop", self.said(vtkmodules.__version__, _vtk_check.LIBRARY))

    def test_none(self):
        said = self.said("", "", hidden=True)
        self.assertIn("The classes in Python, vtkflipflop.arrays and vtkflipflop.pyvista run with any VTK", said)
        self.assertRegex(said, r"^vtkflipflop [\d.]+ was built for.*Python finds no VTK\. The way out: ")

    def test_another_build(self):
        """Of a distribution or conda, say."""
        said = self.said(vtkmodules.__version__, "libvtkCommonCore-another.so.1")
        self.assertIn(f"FOLDER/vtkmodules is of VTK {vtkmodules.__version__}", said)
        self.assertIn(f"does without {_vtk_check.LIBRARY}", said)

    def test_the_array_layer_is_told_to_be_elsewhere(self):
        for name in ("vtkflipflop.arrays", "vtkflipflop._core"):
            with self.assertRaisesRegex(ImportError, "has the VTK classes alone.*pip install"):
                importlib.import_module(name)
        self.assertFalse(hasattr(vtkflipflop, "arrays") or "arrays" in dir(vtkflipflop))
        with self.assertRaisesRegex(ImportError, "no attribute 'convex_hull'. .*has the VTK classes alone"):
            from vtkflipflop import convex_hull  # noqa: F401

    def test_looking_around_raises_nothing(self):
        inspect.getmembers(vtkflipflop)
        self.assertIn("vtkFFHullFilter", pydoc.render_doc(vtkflipflop))
        exec("from vtkflipflop import *", {})
        self.assertFalse(hasattr(vtkflipflop, "nonsense"))


if __name__ == "__main__":
    unittest.main()
