#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is built by default: on top, inside another project, inside a build of VTK's modules, with a device and without.

Everything is configured, and nothing compiled but for one source by flags that it refuses.
"""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
CMAKE = os.environ.get("FLIPFLOP_CMAKE", "cmake")
GENERATOR = os.environ.get("FLIPFLOP_GENERATOR", "Ninja")
HAS_VTK = os.environ.get("FLIPFLOP_FILTERS", "ON") == "ON"
ENGINE_ALONE = "-DFLIPFLOP_BUILD_FILTERS=OFF"

ADD_SUBDIRECTORY = f'add_subdirectory("{TOP.as_posix()}" FlipFlop)'
# What the page for C++ users says, as it stands there.
BLOCKS = re.findall(r"```cmake\n(.*?)```", (TOP / "Documentation" / "Cxx.md").read_text(), re.DOTALL)
INSTALLED, FETCH_CONTENT, MODULES = BLOCKS  # the first is built by Testing/Cxx/RunPackage.cmake
VTK_MODULES = """
include(GNUInstallDirs)
find_package(VTK REQUIRED COMPONENTS CommonCore CommonDataModel CommonExecutionModel CommonTransforms
  IOCore IOXML IOXMLParser ParallelCore
  OPTIONAL_COMPONENTS ParallelDIY ParallelMPI diy2)
message("HOST_VTK ${VTK_VERSION}")
""" + MODULES


class Configured:
    """A build tree: what CMake printed, its cache, and what would be compiled."""

    def __init__(self, source, build, *options, path=None):
        python = f"-DPython3_EXECUTABLE={sys.executable}"
        command = [CMAKE, "-S", source, "-B", build, "-G", GENERATOR, "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", python]
        environment = dict(os.environ, PATH=path or os.environ["PATH"])
        environment.pop("CUDAARCHS", None)
        done = subprocess.run([*command, *options], capture_output=True, text=True, env=environment, check=False)
        self.printed = done.stdout + done.stderr
        self.failed = done.returncode != 0
        lines = (Path(build) / "CMakeCache.txt").read_text().splitlines()
        self.cache = dict(re.findall(r"^([^#/\n][^:\n]*):[A-Z]+=(.*)$", "\n".join(lines), re.MULTILINE))
        commands = Path(build) / "compile_commands.json"
        entries = json.loads(commands.read_text()) if commands.exists() else []
        self.commands = {entry["file"]: entry["command"] for entry in entries}

    def compiles(self, part):
        """The commands for the files whose path has the part."""
        return [command for file, command in self.commands.items() if part in file]

    def parts(self):
        """The project's folders in which something is compiled."""
        files = [Path(file).resolve() for file in self.commands]
        return {file.relative_to(TOP).parts[0] for file in files if TOP in file.parents}


class TestConfigure(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def on_top(self, *options, **more):
        return Configured(TOP, self.folder / "build", *options, **more)

    def host(self, text, *options, standard=None):
        """Configures a project that has the text in its CMakeLists.txt."""
        source = self.folder / "host"
        source.mkdir()
        lines = ["cmake_minimum_required(VERSION 3.20)", "project(Host LANGUAGES C CXX)"]
        lines += [f"set(CMAKE_CXX_STANDARD {standard})"] if standard else []
        (source / "CMakeLists.txt").write_text("\n".join([*lines, text, ""]))
        (source / "FlipFlop").symlink_to(TOP, target_is_directory=True)
        configured = Configured(source, self.folder / "build", *options)
        self.assertFalse(configured.failed, configured.printed)
        return configured

    def assert_libraries_alone(self, configured, *parts):
        self.assertEqual(configured.parts(), {"Engine", "Cuda", *parts})
        for name in ("CMAKE_BUILD_TYPE", "BUILD_SHARED_LIBS", "BUILD_TESTING", "CMAKE_CUDA_ARCHITECTURES"):
            self.assertEqual(configured.cache.get(name, ""), "", name)

    def test_without_cgal_and_googletest(self):
        options = [ENGINE_ALONE, "-DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON"]
        configured = self.on_top(*options)
        self.assertFalse(configured.failed, configured.printed)
        self.assertIn("Left out: the tests of the engine, and the fuzzers: no GoogleTest and CGAL was",
                      configured.printed)
        self.assertEqual(configured.cache["CMAKE_BUILD_TYPE"], "Release")
        configured = self.on_top(*options, "-DFLIPFLOP_ALL_TESTS=ON")
        self.assertTrue(configured.failed)

    def test_without_tests(self):
        configured = self.on_top(*([] if HAS_VTK else [ENGINE_ALONE]), "-DBUILD_TESTING=OFF")
        self.assertFalse(configured.failed, configured.printed)
        self.assertEqual(configured.parts(), {"Engine", "Cuda", "Filters"} if HAS_VTK else {"Engine", "Cuda"})

    def test_arithmetic_is_strict(self):
        unsafe = "-funsafe-math-optimizations -ffp-contract=fast"
        configured = self.on_top(ENGINE_ALONE, "-DBUILD_TESTING=OFF", f"-DCMAKE_CXX_FLAGS={unsafe}")
        commands = configured.compiles("/Engine/") + configured.compiles("/Cuda/Choice/")
        self.assertGreater(len(commands), 80)
        for command in commands:
            last = re.findall(r"-f(?:no-)?unsafe-math-optimizations|-ffp-contract=\w+", command)[-2:]
            self.assertEqual(set(last), {"-ffp-contract=off", "-fno-unsafe-math-optimizations"}, command)
        (command,) = configured.compiles("/Fans.cxx")
        for flags, is_refused in ((unsafe, False), ("-ffast-math", True), ("-ffinite-math-only", True)):
            words = shlex.split(command.replace(unsafe, f"{flags} -fsyntax-only"))
            done = subprocess.run(words, cwd=self.folder / "build", capture_output=True, text=True, check=False)
            self.assertEqual("FlipFlop is exact only with" in done.stderr, is_refused, done.stderr)
            self.assertEqual(done.returncode != 0, is_refused, done.stderr)

    def test_subdirectory(self):
        self.assert_libraries_alone(self.host(ADD_SUBDIRECTORY, ENGINE_ALONE))

    def test_fetch_content(self):
        self.assert_libraries_alone(self.host(FETCH_CONTENT, ENGINE_ALONE))

    @unittest.skipUnless(HAS_VTK, "no VTK")
    def test_fetch_content_after_vtk(self):
        """The page's first project, with the second block in place of the installed package."""
        lines = INSTALLED.replace("find_package(FlipFlop REQUIRED)\n", FETCH_CONTENT)
        self.assertNotEqual(lines, INSTALLED)
        program = self.folder / "main.cxx"
        program.write_text("int main() {}")
        lines = lines.replace("main.cxx", program.as_posix())
        self.assertTrue(self.host(lines).compiles("main.cxx"))

    @unittest.skipUnless(HAS_VTK, "no VTK")
    def test_subdirectory_with_filters(self):
        configured = self.host(ADD_SUBDIRECTORY)
        self.assert_libraries_alone(configured, "Filters")
        self.assertFalse(configured.compiles("Python.cxx"))

    @unittest.skipUnless(HAS_VTK, "no VTK")
    def test_module_of_another_build(self):
        configured = self.host(VTK_MODULES, standard=20)
        self.assertEqual(configured.cache.get("CMAKE_BUILD_TYPE", ""), "")
        # The headers of VTK 9.1 are no C++20.
        version = re.search(r"HOST_VTK ([0-9.]+)", configured.printed)[1]
        new = [int(number) for number in version.split(".")] >= [9, 3]
        for file, standard in (
            ("Engine/Run/", 20),
            ("FlipFlop/Filters/vtkFFHull", 20 if new else 17),
            ("FlipFlop/Filters/Parallel/vtkPFFHull", 20 if new else 17),
        ):
            commands = configured.compiles(file)
            self.assertTrue(commands)
            for command in commands:
                self.assertEqual(re.findall(r"-std=(?:gnu|c)\+\+(\d+)", command), [str(standard)])

    def test_no_device(self):
        configured = self.on_top(ENGINE_ALONE, "-DBUILD_TESTING=OFF", path=self.with_devices())
        said = re.findall("No CUDA engine: .*", configured.printed)
        self.assertEqual(len(said), 1, configured.printed)
        self.assertIn("nvidia-smi finds no device", said[0])

    def test_device(self):
        configured = self.on_top(ENGINE_ALONE, "-DBUILD_TESTING=OFF",
                                 path=self.with_devices("9.0", "8.6", "9.0", "6.1"))
        if shutil.which("nvcc"):
            self.assertIn("The CUDA engine is built for 90;86\n", configured.printed)
            commands = configured.compiles(".cu")
            self.assertTrue(commands)
            for command in commands:
                for flag in ("-fmad=false", "-ftz=false", "-prec-div=true", "-prec-sqrt=true", "-ffp-contract=off"):
                    self.assertIn(flag, command)
        else:
            self.assertIn("No CUDA engine: no CUDA compiler was found", configured.printed)

    def test_vtk_decides_for_its_modules(self):
        configured = self.on_top(ENGINE_ALONE, "-DBUILD_TESTING=OFF", "-DVTK_USE_CUDA=OFF",
                                 path=self.with_devices("9.0"))
        self.assertIn("No CUDA engine: VTK_USE_CUDA is OFF", configured.printed)

    def with_devices(self, *capabilities):
        """A PATH whose nvidia-smi finds devices of these compute capabilities; none: it fails."""
        tools = self.folder / "tools"
        tools.mkdir()
        lines = "".join(f"echo {capability}\n" for capability in capabilities) or "exit 9\n"
        (tools / "nvidia-smi").write_text(f"#!/bin/sh\n{lines}")
        (tools / "nvidia-smi").chmod(0o755)
        return f"{tools}{os.pathsep}{os.environ['PATH']}"


if __name__ == "__main__":
    unittest.main()
