# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tree keeps what Documentation/Architecture.md promises: which folder, and which module, may use which."""

import os
import re
import tempfile
import unittest

from dependencies import (
    dependencies,
    folders,
    includes,
    private_includes,
    module_dependencies,
    modules,
    public_calls,
    reached,
)
from tree import TOP, read

# What a folder of the library may use of the others.
PROMISED = {
    "Engine": set(),
    "Checker": set(),
    "Cuda": {"Engine"},
    "Filters": {"Engine", "Cuda"},
    "Plugin": {"Filters"},
    "Wrapping": {"Filters", "Engine", "Cuda"},
}


# The modules of a folder of the library: each may use those before it.
MODULES = {
    "Engine": ["Support", "Points", "Predicates", "Mesh", "Geometry", "FlipFlop", "Finish", "Run",
               "Surface", "PowerDiagram", "Query", "HalfSpaces", "Validate", "Alpha", "Constraints", "Edit", "Terrain",
               "Refine", "Blocks", "Stream", "Transport"],
    "Cuda": ["Rounds", "Device", "Choice"],
}


# Public functions that compute with no coordinate.
WITHOUT_NUMBERS = {"BlockRun::pointsReceived", "adviseHugePages", "copyFromDevice", "cudaStatus", "describe",
                   "releaseCudaMemory", *("EditableTriangulation::" + name for name in (
                       "constraint", "constraintCount", "constraintNumberCount", "contains", "containsConstraint",
                       "dividedEdges", "idCount", "pointCount"))}


def of_page(page):
    """The folders that the tree of Architecture.md lists."""
    return set(re.findall(r"^    (\w+)/ ", page, re.MULTILINE))


def upward(pairs, order):
    """Those that use a module which is not before them."""
    return {(user, used) for user, used in pairs if order.index(used) > order.index(user)}


def of_table(page, folder):
    """The modules that the page's table names, in its order."""
    return re.findall(rf"^\| `{folder}/(\w+)/` \|", page, re.MULTILINE)


def broken_promises(arrows):
    return {(user, used) for user, used in arrows if used not in PROMISED.get(user, {used})}


class TestArchitecture(unittest.TestCase):
    def test_page_lists_every_folder(self):
        page = read("Documentation", "Architecture.md")
        self.assertEqual(of_page(page), set(folders()))
        self.assertIn("](Figures/architecture.svg)", page)
        tests = re.findall(r"(\w+)/", page.split("    Testing/ ")[1].split("    Benchmarks/ ")[0])
        self.assertEqual(set(tests), set(folders(os.path.join(TOP, "Testing"))))

    def test_the_library_keeps_its_promises(self):
        self.assertEqual(broken_promises(dependencies()), set())

    def test_modules_use_only_those_before_them(self):
        for folder, order in MODULES.items():
            self.assertEqual(set(modules(TOP, folder)), set(order))
            self.assertEqual(upward(module_dependencies(TOP, folder), order), set())
            self.assertEqual(private_includes(TOP, folder), set())

    def test_the_page_tells_of_every_module(self):
        page = read("Documentation", "Architecture.md")
        for folder, order in MODULES.items():
            self.assertEqual(of_table(page, folder), order)
        self.assertIn("](Figures/modules.svg)", page)

    def test_public_calls_have_the_default_environment(self):
        calls = [call for folder in MODULES for call in public_calls(TOP, folder)]
        self.assertGreater(len(calls), 60)
        self.assertEqual({name for name, is_within in calls if not is_within}, WITHOUT_NUMBERS)

    def test_every_source_refuses_fast_arithmetic(self):
        edges = includes(TOP, "Engine")
        sources = [name for name in edges if name.endswith(".cxx")]
        self.assertGreater(len(sources), 80)
        check = "Support/StrictArithmetic.h"
        self.assertEqual([name for name in sources if check not in reached(name, edges)], [])


def make_tree(top, files):
    for path, text in files.items():
        os.makedirs(os.path.join(top, os.path.dirname(path)), exist_ok=True)
        with open(os.path.join(top, path), "w", encoding="utf-8") as file:
            file.write(text)


class TestDependencies(unittest.TestCase):
    """A tree of a few files, one of each kind that counts, and of each that does not."""

    FILES = {
        ".gitignore": "/build-*/\n__pycache__/\n",
        "build-1/Made.cxx": '#include "Hull.h"\n',
        ".hidden/none.py": "import vtkflipflop\n",
        "Engine/include/flipflop/Hull.h": "#include <vector>\n#include <flipflop/Error.h>\n",
        "Engine/include/flipflop/Error.h": "#include <string>\n",
        "Engine/Run/Run.h": "#include <flipflop/Hull.h>\n",
        "Engine/Run/Run.cxx": '#include "Run/Run.h"\n#include "Mesh/Mesh.h"\n',
        "Engine/Mesh/Mesh.h": "#include <flipflop/Error.h>\n",
        "Cuda/Device/Rounds.cu": '  #  include "Run/Run.h"\n',
        "Cuda/Hull.py": "# import vtkflipflop\n",
        "Filters/vtkFFHullFilter.h": "// #include <flipflop/Hull.h>\n",
        "Plugin/Hull.xml.in": '<SourceProxy name="FlipFlopConvexHull" class="vtkPFFHullFilter">\n',
        "Wrapping/__init__.py.in": "from .vtkFiltersFlipFlop import (\n",
        "Examples/a.py": "from vtkflipflop import vtkFFHullFilter\n",
        "Examples/a.cxx": "#include <vtkFFHullFilter.h>\n",
        "Testing/a.cxx": "#include <flipflop/Hull.h>\n#include <tbb/vtkFFHullFilter.h>\n",
        "Testing/a.py": "simple.ConvexHullFlipFlop()\n",
    }
    USES = {
        ("Cuda", "Engine"),
        ("Plugin", "Filters"),
        ("Wrapping", "Filters"),
        ("Examples", "Wrapping"),
        ("Examples", "Filters"),
        ("Testing", "Engine"),
        ("Testing", "Plugin"),
    }

    # One file each that goes where it may not.
    WRONG = {
        "Engine/Mesh/Up.h": '#include "Run/Run.h"\n',
        "Engine/include/flipflop/Private.h": '#include "Mesh/Mesh.h"\n',
        "Engine/Run/Filter.cxx": '#include "vtkFFHullFilter.h"\n',
    }

    def test_what_is_wrong_is_noticed(self):
        with tempfile.TemporaryDirectory() as top:
            make_tree(top, self.FILES)
            self.assertEqual(folders(top), ["Cuda", "Engine", "Examples", "Filters", "Plugin", "Testing", "Wrapping"])
            self.assertEqual(dependencies(top), self.USES)
            self.assertEqual(broken_promises(dependencies(top)), set())
            self.assertEqual(modules(top, "Engine"), ["Mesh", "Run"])
            self.assertEqual(module_dependencies(top, "Engine"), {("Run", "Mesh")})
            self.assertEqual(private_includes(top, "Engine"), set())
            make_tree(top, self.WRONG)
            self.assertEqual(upward(module_dependencies(top, "Engine"), ["Mesh", "Run"]), {("Mesh", "Run")})
            self.assertEqual(private_includes(top, "Engine"), {"Mesh/Mesh.h"})
            self.assertEqual(broken_promises(dependencies(top)), {("Engine", "Filters")})

    def test_a_call_in_the_callers_environment_is_noticed(self):
        header = "class Queries\n{\n  Queries(int a); // or (b)\n  int at(int) const;\n};\nint sum(int a,\n  int b);\n"
        source = (
            "namespace\n{\n\nint sum(int a)\n{\n  return a;\n}\n\n}\n\n"
            "Queries::Queries(int a)\n  : b(engineCall([&] { return a; }))\n"
            "{\n}\n\nint Queries::at(int i) const\n{\n  return i;\n}\n\n"
            "int sum(int a, int b)\n{\n  return engineCall([&] { return a; });\n}\n"
        )
        with tempfile.TemporaryDirectory() as top:
            make_tree(top, {"Engine/include/flipflop/Sum.h": header, "Engine/Run/Sum.cxx": source})
            self.assertEqual(
                dict(public_calls(top, "Engine")), {"Queries::Queries": True, "Queries::at": False, "sum": True}
            )


if __name__ == "__main__":
    unittest.main()
