# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in for the wheel vtk-sdk, from Debian's VTK of the same version and the wheel vtk.

The wheel vtk-sdk has what a VTK module is built with that runs beside the wheel vtk: headers, wrapping tools, a
CMake package. No index has it for every machine. But Debian's packages of the same version have the same files, and
the wheel vtk has the libraries. Where the two were configured differently, the wheel counts: vtkSMP.h is set by
its symbols, CMake's targets by its files. And the virtual tables of all classes must have the same size in both:
then headers and libraries fit, else this script stops.

    vtk_sdk.py --debian FOLDER --vtk-wheel FILE --output FOLDER

In the first folder libvtk9-dev, libvtk9.X, vtk9, python3-vtk9 and their C and C++ libraries are unpacked.
"""

import argparse
import base64
import hashlib
import os
import re
import shutil
import stat
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

LIBRARIES = Path("lib/x86_64-linux-gnu")
PYTHON = f"{sys.version_info[0]}.{sys.version_info[1]}"

# The components that the module asks for; the libraries that these link come along.
COMPONENTS = (
    "CommonExecutionModel",
    "CommonTransforms",
    "FiltersSources",
    "IOXML",
    "ParallelCore",
    "WrappingPythonCore",
)

TOOLS = ("vtkWrapHierarchy", "vtkWrapPython", "vtkWrapPythonInit")

# A tool of a newer Debian runs with the C library that it was linked against.
LAUNCHER = """#!/bin/sh
here=$(dirname "$(readlink -f "$0")")
exec "$here/tools/ld-linux-x86-64.so.2" --library-path "$here/tools" "$here/tools/{tool}" "$@"
"""


class Misfit(Exception):
    """Headers and libraries that do not belong together."""


# What is in a library ------------------------------------------------------------------------------------------


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def symbols(library):
    """Rows of address, size, kind and name."""
    rows = map(str.split, output_of("nm", "-D", "-S", "--defined-only", library).splitlines())
    return [row for row in rows if len(row) == 4]


def linked(library):
    return re.findall(r"\(NEEDED\).*\[(.*)\]", output_of("readelf", "-d", library))


def virtual_tables(library):
    """The size of each class's."""
    return {name.split("@")[0]: size for _, size, _, name in symbols(library) if name.startswith("_ZTV")}


# CMake's package -----------------------------------------------------------------------------------------------


def made_by(section):
    """The target that a section of an export file makes, and its kind, or None."""
    found = re.search(r"(?m)^add_\w+\((\S+) (\w+)", section)
    return found and found.groups()


def own_links(found):
    """A target's links without those to Debian's other packages, whose part the wheel's libraries contain."""
    own = r"(\\\$<LINK_ONLY:)?(VTK::|Threads::|Python3::)"
    return f'{found[1]} "{";".join(item for item in found[2].split(";") if re.match(own, item))}"'


def edit(path, change):
    path.write_text(change(path.read_text()))


class Sdk:
    """The stand-in's content, laid out as Debian's /usr."""

    def __init__(self, debian, wheel, content):
        self.debian, self.wheel, self.content = Path(debian) / "usr", Path(wheel), Path(content)
        packages = list((self.debian / LIBRARIES / "cmake").glob("vtk-*"))
        if len(packages) != 1:
            raise Misfit(f"{debian}: one folder cmake/vtk-* wanted, {len(packages)} found")
        self.name = packages[0].name
        self.suffix = self.name[len("vtk-") :]

    def assemble(self):
        self.copy_libraries()
        self.copy_headers()
        self.copy_tools()
        self.copy_package()

    def in_wheel(self, debians_name):
        """The wheel's name for a library of Debian's, or None."""
        found = re.match(r"lib([A-Za-z_]\w*?)(3\.\d+)?-[\d.]+\.so", debians_name)
        names = [f"lib{found[1]}.so", f"lib{found[1]}{PYTHON}.so"] if found else []
        return next((name for name in names if (self.wheel / name).exists()), None)

    def libraries(self):
        """The wheel's libraries that the module needs, each compared with the headers' own."""
        wanted = [self.in_wheel(f"libvtk{name}-{self.suffix}.so") for name in COMPONENTS]
        if None in wanted:
            raise Misfit(f"the wheel has no {COMPONENTS[wanted.index(None)]} for Python {PYTHON}")
        done, compared = set(), 0
        while wanted:
            name = wanted.pop()
            if name in done:
                continue
            done.add(name)
            stem = re.sub(r"[0-9.]*\.so$", "", name)
            for twin in (self.debian / LIBRARIES).glob(f"{stem}-*.so.*.*"):
                here, there = virtual_tables(self.wheel / name), virtual_tables(twin)
                both = here.keys() & there.keys()
                other = sorted(table for table in both if here[table] != there[table])
                if other:
                    raise Misfit(f"{name}: the headers' classes are others: {', '.join(other[:5])}")
                compared += len(both)
            wanted += [name for name in linked(self.wheel / name) if (self.wheel / name).exists()]
        print(f"{len(done)} libraries of the wheel, {compared} virtual tables as the headers'")
        return sorted(done)

    def copy_libraries(self):
        (self.content / LIBRARIES).mkdir(parents=True)
        for name in self.libraries():
            shutil.copy2(self.wheel / name, self.content / LIBRARIES / name)

    def copy_headers(self):
        for folder in (Path("include") / self.name, LIBRARIES / self.name / "hierarchy"):
            shutil.copytree(self.debian / folder, self.content / folder)
        mangled = r"vtkSMPToolsImplILNS1_11BackendTypeE(\d)E"
        names = " ".join(row[3] for row in symbols(self.wheel / "libvtkCommonCore.so"))
        backends = set(re.findall(mangled, names))

        def smp(text):
            # In the order of vtkSMPToolsImpl.h's BackendType.
            for number, name in enumerate(("SEQUENTIAL", "STDTHREAD", "TBB", "OPENMP")):
                enabled, default = int(str(number) in backends), int(name == "STDTHREAD")
                text, one = re.subn(rf"(_ENABLE_{name}) \d", rf"\1 {enabled}", text)
                text, two = re.subn(rf"(_DEFAULT_IMPLEMENTATION_{name}) \d", rf"\1 {default}", text)
                if (one, two) != (1, 1):
                    raise Misfit(f"vtkSMP.h does not tell of {name}")
            text = re.sub(r"#define VTK_SMP_(TBB|OpenMP|Sequential)\b", "#define VTK_SMP_STDThread", text)
            return re.sub(r'(#define VTK_SMP_BACKEND) "\w+"', r'\1 "STDThread"', text)

        edit(self.content / "include" / self.name / "vtkSMP.h", smp)

    def copy_tools(self):
        tools = self.content / "bin" / "tools"
        tools.mkdir(parents=True)
        wanted = ["ld-linux-x86-64.so.2"]
        for tool in TOOLS:
            shutil.copy2(self.debian / "bin" / f"{tool}-{self.suffix}", tools / tool)
            launcher = self.content / "bin" / f"{tool}-{self.suffix}"
            launcher.write_text(LAUNCHER.format(tool=tool))
            launcher.chmod(0o755)
            wanted += linked(tools / tool)
        while wanted:
            name = wanted.pop()
            if not (tools / name).exists():
                shutil.copy2((self.debian / LIBRARIES / name).resolve(), tools / name)
                wanted += linked(tools / name)

    def with_file(self, block):
        """A target of an export file with the place of its file in the SDK, or nothing where it has none."""
        file = re.search(r'IMPORTED_LOCATION_NONE "\$\{_IMPORT_PREFIX\}/(.*)"', block)
        old = Path(file[1]) if file else Path()
        if old.parent == Path("bin"):
            return block if old.name in [f"{tool}-{self.suffix}" for tool in TOOLS] else ""
        name = self.in_wheel(old.name)
        if not name or not (self.content / LIBRARIES / name).exists():
            return ""
        block = block.replace(str(old), str(LIBRARIES / name))
        return re.sub(r'IMPORTED_SONAME_NONE ".*"', f'IMPORTED_SONAME_NONE "{name}"', block)

    def copy_package(self):
        package = self.content / LIBRARIES / "cmake" / self.name
        shutil.copytree(self.debian / LIBRARIES / "cmake" / self.name, package)
        (package / "VTKPython-targets-none.cmake").unlink()
        here = set()

        def files(text):
            head, *blocks = re.split(r"(?m)^(?=# Import target )", text)
            return "".join([head, *map(self.with_file, blocks), "\nset(CMAKE_IMPORT_FILE_VERSION)\n"])

        edit(package / "VTK-targets-none.cmake", files)
        with_files = (package / "VTK-targets-none.cmake").read_text()

        def targets(text):
            sections = re.split(r"(?m)^(?=# Create imported target |# Load information)", text)
            for section in list(sections):
                name, kind = made_by(section) or (None, None)
                if kind == "INTERFACE" or f"TARGET {name} " in with_files:
                    here.add(name)
                elif name:
                    sections.remove(section)
            text = re.sub(r'(INTERFACE_LINK_LIBRARIES) "(.*)"', own_links, "".join(sections))
            text = re.sub(r'foreach\(_target "viskores.*', "foreach(_target IN ITEMS)", text)
            expected = re.search(r"_cmake_expected_target IN ITEMS (.*)\)", text)[1]
            return text.replace(expected, " ".join(name for name in expected.split() if name in here))

        def properties(text):
            lines = text.splitlines(keepends=True)
            owners = [re.match(r'set_property\(TARGET "(.*?)"', line) for line in lines]
            return "".join(
                line for line, owner in zip(lines, owners) if not owner or owner[1] in here
            )

        def config(text):
            off = r'(NAME\}_(?:HAS_VISKORES|HAS_VTKm|WRAP_JAVA)") "ON"'
            text = re.sub(off, r'\1 "OFF"', text)
            return re.sub(r'(NAME\}_SMP_BACKENDS") ".*"', r'\1 "STDThread;Sequential"', text)

        edit(package / "VTK-targets.cmake", targets)
        for name in ("VTK-vtk", "vtkmodules-vtk-python"):
            edit(package / f"{name}-module-properties.cmake", properties)
        edit(package / "vtk-config.cmake", config)
        (package / "VTKPython-targets.cmake").write_text("# The wheel vtk has the wrapped modules.\n")
        (package / "VTK-vtk-module-find-packages.cmake").write_text(
            "find_package(Threads REQUIRED)\n"
            f"find_package(Python3 {PYTHON} EXACT REQUIRED COMPONENTS Interpreter Development.Module)\n"
        )


# The wheel -----------------------------------------------------------------------------------------------------


def write_wheel(folder, version, tag, output):
    """Packs folder as the wheel vtk_sdk, with the entry point by which scikit-build-core finds its content."""
    information = folder / f"vtk_sdk-{version}.dist-info"
    information.mkdir()
    (information / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: vtk-sdk\nVersion: {version}\n"
        "Summary: Stand-in, made of Debian's VTK and the wheel vtk\n"
    )
    (information / "WHEEL").write_text(
        f"Wheel-Version: 1.0\nGenerator: vtk_sdk.py\nRoot-Is-Purelib: false\nTag: {tag}\n"
    )
    (information / "entry_points.txt").write_text("[cmake.prefix]\nvtk-sdk = vtk_sdk.content\n")
    record = []
    path = output / f"vtk_sdk-{version}-{tag}.whl"
    unfinished = path.with_suffix(".part")
    with zipfile.ZipFile(unfinished, "w") as archive:

        def add(name, data, mode):
            entry = zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0))
            entry.external_attr = (stat.S_IFREG | mode) << 16
            archive.writestr(entry, data, zipfile.ZIP_DEFLATED, 1)

        for file in sorted(path for path in folder.rglob("*") if path.is_file()):
            name, data = str(file.relative_to(folder)), file.read_bytes()
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")
            record.append(f"{name},sha256={digest},{len(data)}\n")
            add(name, data, 0o755 if os.access(file, os.X_OK) else 0o644)
        name = f"{information.name}/RECORD"
        add(name, "".join([*record, f"{name},,\n"]), 0o644)
    return unfinished.rename(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("--debian", "--vtk-wheel", "--output"):
        parser.add_argument(name, required=True, type=Path)
    arguments = parser.parse_args()
    version, tag = arguments.vtk_wheel.stem.split("-", 2)[1:]
    with tempfile.TemporaryDirectory() as work:
        with zipfile.ZipFile(arguments.vtk_wheel) as archive:
            names = [name for name in archive.namelist() if re.search(r"/lib[^/]*\.so", name)]
            archive.extractall(work, names)
        sdk = Path(work) / "sdk"
        content = sdk / "vtk_sdk" / "content"
        content.mkdir(parents=True)
        for package in (content.parent, content):
            (package / "__init__.py").touch()
        Sdk(arguments.debian, Path(work) / "vtkmodules", content).assemble()
        text = next(content.rglob("vtkVersionMacros.h")).read_text()
        found = re.search(r'#define VTK_VERSION "(.*)"', text)[1]
        if found != version:
            raise Misfit(f"the headers are of VTK {found}, the libraries of {version}")
        print(write_wheel(sdk, version, tag, arguments.output))


if __name__ == "__main__":
    try:
        main()
    except Misfit as error:
        sys.exit(f"vtk_sdk.py: {error}")
