# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The reference of the Python package as HTML, by pdoc: python3 python_reference.py FOLDER

pdoc spells out the types of annotations. NumPy's ArrayLike is a union of a dozen protocols, and NDArray has a tuple of
its shape; here both keep their names.
"""

import sys
import types
import warnings
from pathlib import Path

import numpy.typing
import pdoc
import pyvista  # noqa: F401 (with NumPy's own types)


class ArrayLike:
    __module__ = "numpy.typing"


class NDArray:
    __module__ = "numpy.typing"
    __class_getitem__ = classmethod(types.GenericAlias)


# Before the package is imported.
numpy.typing.ArrayLike = ArrayLike
numpy.typing.NDArray = NDArray

# It cannot say where the attributes of exceptions come from, and warns of each.
warnings.simplefilter("ignore")
pdoc.render.configure(docformat="numpy", show_source=False)
pdoc.pdoc("vtkflipflop.arrays", "vtkflipflop.pyvista", output_directory=Path(sys.argv[1]))
