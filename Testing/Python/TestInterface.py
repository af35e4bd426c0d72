# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The compiled classes and those in Python have the same methods, constants, defaults and ports.

Each build compares its classes with one list. --write makes it anew from the compiled ones:

    PYTHONPATH=<the folder that holds vtkflipflop> python3 TestInterface.py --write
"""

import re
import sys
import unittest

from vtkmodules import vtkCommonExecutionModel as execution
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase

import vtkflipflop

import given

BASELINE = given.BASELINE.parent / "interface.txt"
# What a class has of VTK's is not listed.
OF_VTK = {"PrintSelf", *dir(VTKPythonAlgorithmBase)} | {
    name
    for kind in ("vtkPolyDataAlgorithm", "vtkDataSetAlgorithm", "vtkImageAlgorithm")
    for name in dir(getattr(execution, kind))
}
# These tell of the machine and of the build.
OF_THE_MACHINE = {"GetCUDADeviceName", "GetCUDAProblem", "IsCUDAAvailable"}
IN_BOTH = [
    name
    for name in vtkflipflop.__all__
    if not name.startswith("vtkPFF") and name != "vtkFFStreamedWriter"  # compiled classes alone
]
ABSTRACT = ("Algorithm",)


def value_of(algorithm, name):
    """What a method without arguments returns; nothing, if it takes some."""
    try:
        found = getattr(algorithm, name)()
    except TypeError:
        return ""
    if isinstance(found, bool):
        found = int(found)
    return f" = {found!r}" if not hasattr(found, "GetClassName") else f" = a {found.GetClassName()}"


def lines_of(name):
    """All that is public of a class, one line each."""
    kind = getattr(vtkflipflop, name)
    made = None if name.endswith(ABSTRACT) else kind()
    if made is not None:
        yield f"{name}: {made.GetNumberOfInputPorts()} input, {made.GetNumberOfOutputPorts()} output"
    for member in sorted(set(dir(kind)) - OF_VTK):
        if re.fullmatch(r"[A-Z][A-Z0-9_]+", member):
            yield f"{name}.{member} = {int(getattr(kind, member))}"
        elif re.fullmatch(r"[A-Z]\w*", member):
            has_value = made is not None and member.startswith(("Get", "Is")) and member not in OF_THE_MACHINE
            yield f"{name}.{member}{value_of(made, member) if has_value else ''}"


def lines():
    return [line for name in sorted(IN_BOTH) for line in lines_of(name)]


class TestInterface(unittest.TestCase):
    def test_it_is_that_of_the_list(self):
        expected = BASELINE.read_text().splitlines()
        self.assertGreater(len(expected), 500)
        found = set(lines())
        self.assertEqual(sorted(set(expected) - found), [], "is missing")
        self.assertEqual(sorted(found - set(expected)), [], "is not in the list")


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        BASELINE.write_text("\n".join(lines()) + "\n")
    else:
        unittest.main()
