# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in for the wheel vtk-sdk, from Debian's VTK of the same version and the wheel vtk.

The wheel vtk-sdk has what a VTK module is built with that runs beside the wheel vtk: headers, wrapping tools,
CMake package. It is not on the package index for Linux. But Debian's packages of the same version have the
same files, and the wheel vtk has the libraries. Where the two configurations of VTK differ, the wheel's counts:
this script sets vtkSMP.h by the wheel's symbols and compares the virtual tables of all classes in both
libraries, so that headers and libraries fit, or it stops.

    vtk_sdk.py --debian FOLDER --vtk-wheel FILE --output FOLDER

FOLDER is where libvtk9-dev, libvtk9.X, vtk9 and the C and C++ libraries of their Debian are unpacked.
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

# What a module needs that depends on VTK's core, execution model and parallel core; what these link is found.
ROOTS = ("CommonExecutionModel", "CommonTransforms", "ParallelCore", "WrappingPythonCore", "FiltersSources")

TOOLS = ("vtkWrapHierarchy", "vtkWrapPython", "vtkWrapPythonInit")

# A tool of a newer Debian, run with the C library that it was linked against.
LAUNCHER = """#!/bin/sh
here=$(dirname "$(readlink -f "$0")")
exec "$here/tools/ld-linux-x86-64.so.2" --library-path "$here/tools" "$here/tools/{name}" "$@"
"""


class Misfit(Exception):
    """Headers and libraries that do not belong together."""


def symbols(library, *options):
    out = subprocess.run(["nm", "-D", *options, str(library)], capture_output=True, text=True, check=True)
    return [line.split() for line in out.stdout.splitlines()]


def virtual_tables(library):
    return {row[3].split("@")[0]: int(row[1], 16) for row in symbols(library, "-S", "--defined-only")
            if len(row) == 4 and row[3].startswith("_ZTV")}


def compare_virtual_tables(name, ours, debians):
    """A class whose table has another size in the headers' own library has other virtual functions."""
    here, there = virtual_tables(ours), virtual_tables(debians)
    other = sorted(table for table in here.keys() & there.keys() if here[table] != there[table])
    if other:
        raise Misfit(f"{name}: the wheel's classes differ from the headers': {', '.join(other[:5])}")
    return len(here.keys() & there.keys())


def linked(library):
    out = subprocess.run(["readelf", "-d", str(library)], capture_output=True, text=True, check=True)
    return re.findall(r"\(NEEDED\).*\[(.*)\]", out.stdout)


class Sdk:
    def __init__(self, debian, wheel, content):
        self.debian, self.wheel, self.content = Path(debian) / "usr", Path(wheel), Path(content)
        packages = list((self.debian / LIBRARIES / "cmake").glob("vtk-*"))
        if len(packages) != 1:
            raise Misfit(f"{debian}: one folder cmake/vtk-* wanted, {len(packages)} found")
        self.suffix = packages[0].name[len("vtk-"):]
        self.headers = self.content / "include" / f"vtk-{self.suffix}"
        self.package = self.content / LIBRARIES / "cmake" / f"vtk-{self.suffix}"

    def in_wheel(self, target_file):
        """The wheel's name for a library of Debian's, or None."""
        found = re.match(r"lib([A-Za-z_]\w*?)(3\.\d+)?-[\d.]+\.so", target_file)
        if not found:
            return None
        names = [f"lib{found[1]}.so", f"lib{found[1]}{sys.version_info[0]}.{sys.version_info[1]}.so"]
        return next((name for name in names if (self.wheel / "vtkmodules" / name).exists()), None)

    def libraries(self):
        """The wheel's libraries that ROOTS need, compared with those that the headers belong to."""
        wanted = [self.in_wheel(f"libvtk{root}-{self.suffix}.so") for root in ROOTS]
        if None in wanted:
            raise Misfit(f"the wheel has no {ROOTS[wanted.index(None)]} for this Python")
        done, tables = set(), 0
        while wanted:
            name = wanted.pop()
            if name in done:
                continue
            done.add(name)
            library = self.wheel / "vtkmodules" / name
            theirs = list((self.debian / LIBRARIES).glob(f"{re.sub(r'[0-9.]*.so$', '', name)}-*.so.*.*"))
            if theirs:
                tables += compare_virtual_tables(name, library, theirs[0])
            wanted += [needed for needed in linked(library) if (self.wheel / "vtkmodules" / needed).exists()]
        print(f"{len(done)} libraries of the wheel, {tables} virtual tables as in the headers' own libraries")
        return sorted(done)

    def copy_libraries(self):
        folder = self.content / LIBRARIES
        folder.mkdir(parents=True, exist_ok=True)
        for name in self.libraries():
            shutil.copy2(self.wheel / "vtkmodules" / name, folder / name)

    def copy_headers(self):
        shutil.copytree(self.debian / "include" / f"vtk-{self.suffix}", self.headers)
        hierarchy = LIBRARIES / f"vtk-{self.suffix}"
        shutil.copytree(self.debian / hierarchy, self.content / hierarchy)
        core = self.wheel / "vtkmodules" / "libvtkCommonCore.so"
        backends = {found for row in symbols(core, "--defined-only")
                    for found in re.findall(r"vtkSMPToolsImplILNS1_11BackendTypeE(\d)E", row[-1])}
        path = self.headers / "vtkSMP.h"
        text = path.read_text()
        # The order of vtkSMPToolsImpl.h's BackendType.
        for number, name in enumerate(("SEQUENTIAL", "STDTHREAD", "TBB", "OPENMP")):
            text, count = re.subn(rf"(#define VTK_SMP_ENABLE_{name}) \d", rf"\1 {int(str(number) in backends)}", text)
            if count != 1:
                raise Misfit(f"vtkSMP.h says nothing of {name}")
            text = re.sub(rf"(#define VTK_SMP_DEFAULT_IMPLEMENTATION_{name}) \d", rf"\1 {int(name == 'STDTHREAD')}", text)
        text = re.sub(r"#define VTK_SMP_(TBB|OpenMP|Sequential|STDThread)\b", "#define VTK_SMP_STDThread", text)
        text = re.sub(r'(#define VTK_SMP_BACKEND) "\w+"', r'\1 "STDThread"', text)
        path.write_text(text)

    def copy_tools(self):
        tools = self.content / "bin" / "tools"
        tools.mkdir(parents=True)
        for tool in TOOLS:
            shutil.copy2(self.debian / "bin" / f"{tool}-{self.suffix}", tools / tool)
            launcher = self.content / "bin" / f"{tool}-{self.suffix}"
            launcher.write_text(LAUNCHER.format(name=tool))
            launcher.chmod(0o755)
        wanted = [name for tool in TOOLS for name in linked(tools / tool)] + ["ld-linux-x86-64.so.2"]
        while wanted:
            name = wanted.pop()
            if (tools / name).exists():
                continue
            shutil.copy2((self.debian / LIBRARIES / name).resolve(), tools / name)
            wanted += linked(tools / name)

    def imported_files(self, text):
        """The targets of an export file that the wheel or the tools have, with their places in the SDK."""
        head, *blocks = re.split(r"(?m)^(?=# Import target )", text)
        kept = [head]
        for block in blocks:
            file = re.search(r'IMPORTED_LOCATION_NONE "\$\{_IMPORT_PREFIX\}/(.*)"', block)
            if not file:
                continue
            old = Path(file[1])
            if old.parent == Path("bin"):
                if old.name not in [f"{tool}-{self.suffix}" for tool in TOOLS]:
                    continue
            else:
                name = self.in_wheel(old.name)
                if not name or not (self.content / LIBRARIES / name).exists():
                    continue
                block = block.replace(str(old), str(LIBRARIES / name))
                block = re.sub(r'IMPORTED_SONAME_NONE ".*"', f'IMPORTED_SONAME_NONE "{name}"', block)
            kept.append(block)
        return "".join(kept) + "\nset(CMAKE_IMPORT_FILE_VERSION)\n"

    def copy_package(self):
        shutil.copytree(self.debian / LIBRARIES / "cmake" / f"vtk-{self.suffix}", self.package)
        for pattern in ("VTKJava*", "VTKPython-targets-none.cmake"):
            for path in self.package.glob(pattern):
                path.unlink()
        path = self.package / "VTK-targets-none.cmake"
        path.write_text(self.imported_files(path.read_text()))

        # What Debian's libraries take from other packages, the wheel's bring along.
        path = self.package / "VTK-targets.cmake"
        text = re.sub(r'(INTERFACE_LINK_LIBRARIES) "(.*)"', lambda found: '{} "{}"'.format(found[1], ";".join(
            item for item in found[2].split(";") if re.match(r"(\\\$<LINK_ONLY:)?(VTK::|Threads::|Python3::)", item))), path.read_text())
        text = re.sub(r'foreach\(_target "viskores.*', "foreach(_target IN ITEMS)", text)
        path.write_text(text)
        (self.package / "VTK-vtk-module-find-packages.cmake").write_text(
            f"find_package(Threads REQUIRED)\nfind_package(Python3 {sys.version_info[0]}.{sys.version_info[1]} EXACT REQUIRED\n"
            "  COMPONENTS Interpreter Development.Module)\n")
        path = self.package / "vtk-config.cmake"
        text = path.read_text()
        for setting in ("HAS_VISKORES", "HAS_VTKm", "WRAP_JAVA"):
            text = re.sub(rf'(NAME\}}_{setting}") "ON"', r'\1 "OFF"', text)
        text = re.sub(r'(NAME\}_SMP_BACKENDS") ".*"', r'\1 "STDThread;Sequential"', text)
        path.write_text(text)

    def assemble(self):
        self.copy_libraries()
        self.copy_headers()
        self.copy_tools()
        self.copy_package()


def write_wheel(folder, version, tag, output):
    """Packs folder as the wheel vtk_sdk, with the entry point by which scikit-build-core finds the SDK."""
    information = folder / f"vtk_sdk-{version}.dist-info"
    information.mkdir()
    (information / "METADATA").write_text(f"Metadata-Version: 2.1\nName: vtk-sdk\nVersion: {version}\n"
                                          "Summary: Stand-in, made of Debian's VTK and the wheel vtk\n")
    (information / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: vtk_sdk.py\nRoot-Is-Purelib: false\nTag: {tag}\n")
    (information / "entry_points.txt").write_text("[cmake.prefix]\nvtk-sdk = vtk_sdk.content\n")
    record = information / "RECORD"
    lines = []
    path = output / f"vtk_sdk-{version}-{tag}.whl"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        for file in sorted(folder.rglob("*")):
            if file.is_dir():
                continue
            name, data = str(file.relative_to(folder)), file.read_bytes()
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            lines.append(f"{name},sha256={digest},{len(data)}")
            entry = zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0))
            entry.external_attr = (stat.S_IFREG | (0o755 if os.access(file, os.X_OK) else 0o644)) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
        name = str(record.relative_to(folder))
        archive.writestr(name, "\n".join([*lines, f"{name},,", ""]))
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--debian", required=True, type=Path)
    parser.add_argument("--vtk-wheel", required=True, type=Path)
    parser.add_argument("--output", required=True, type=Path)
    arguments = parser.parse_args()
    version, python, abi, platform = arguments.vtk_wheel.stem.split("-")[1:5]
    with tempfile.TemporaryDirectory() as work:
        vtk, sdk = Path(work) / "vtk", Path(work) / "sdk"
        with zipfile.ZipFile(arguments.vtk_wheel) as archive:
            archive.extractall(vtk, [name for name in archive.namelist() if re.search(r"/lib[^/]*\.so", name)])
        content = sdk / "vtk_sdk" / "content"
        content.mkdir(parents=True)
        for package in (sdk / "vtk_sdk", content):
            (package / "__init__.py").touch()
        Sdk(arguments.debian, vtk, content).assemble()
        found = re.search(r'#define VTK_VERSION "(.*)"', next(content.rglob("vtkVersionMacros.h")).read_text())[1]
        if found != version:
            raise Misfit(f"the headers are of VTK {found}, the libraries of {version}")
        print(write_wheel(sdk, version, f"{python}-{abi}-{platform}", arguments.output))


if __name__ == "__main__":
    try:
        main()
    except Misfit as error:
        sys.exit(f"vtk_sdk.py: {error}")
