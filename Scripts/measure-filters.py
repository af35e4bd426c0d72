#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""How large the VTK layer is, beside the bounds it is to keep: measure-filters.py [BUILD]

BUILD is a folder in which the filters are built: its libraries' exported symbols are counted, too. Exit status 1 if a
bound is not kept.
"""

import re
import subprocess
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[1]
LONGEST = 80


def sources(folder, without=()):
    for path in sorted((TOP / folder).rglob("*")):
        if path.suffix in (".h", ".cxx") and not any(part in without for part in path.relative_to(TOP).parts):
            yield path


def lines(folder, without=()):
    return sum(len(path.read_text().splitlines()) for path in sources(folder, without))


def long_functions(folder):
    """Functions of more than LONGEST lines: a { and its } at the line's begin, as clang-format has them."""
    found = []
    for path in sources(folder):
        begin = None
        for number, line in enumerate(path.read_text().splitlines()):
            if line == "{":
                begin = number
            elif line == "}" and begin is not None:
                if number - begin - 1 > LONGEST:
                    found.append(f"{path.name}:{begin + 1}")
                begin = None
    return found


def installed_classes():
    """Those of the lists CLASSES in the modules' CMakeLists.txt."""
    found = set()
    for path in (TOP / "Filters" / "CMakeLists.txt", TOP / "Filters" / "Parallel" / "CMakeLists.txt"):
        text = path.read_text()
        for block in re.findall(r"(?:set\(classes|\bCLASSES)\s+((?:vtk\w+\s+)+)", text):
            found.update(block.split())
        for block in re.findall(r"set\(classes\s+([^)]*)\)", text):
            found.update(block.split())
    return found


def private_exports(build):
    """Exported symbols of classes that are not installed."""
    installed, found = installed_classes(), []
    for library in sorted(Path(build).rglob("libvtkFilters*FlipFlop*.so")):
        if library.is_symlink():
            continue
        symbols = subprocess.run(
            ["nm", "--dynamic", "--demangle", "--defined-only", library], check=True, capture_output=True, text=True
        ).stdout
        for line in symbols.splitlines():
            classes = re.findall(r"\b(vtkP?FF\w+)::", line) or re.findall(r"\b(vtkP?FF\w+)", line)
            if classes and classes[0] not in installed:
                found.append(line)
    return found


def methods(name):
    """Public methods that a class adds to vtkAlgorithm's, its superclasses of this module included.

    New(), the methods of the type macros and overrides are vtkAlgorithm's.
    """
    count = 0
    while name:
        path = next(iter(TOP.glob(f"Filters/**/{name}.h")), None)
        if path is None:
            break
        text = path.read_text()
        body = text[text.index("public:") : text.index("\nprotected:")]
        for macro in re.findall(r"\bvtk\w*Macro\(", body):
            count += 0 if "TypeMacro" in macro else 2 if "Boolean" in macro else 1
        body = re.sub(r"vtk\w*Macro\([^;]*\);|/\*.*?\*/|//[^\n]*|enum \w+\s*\{.*?\};", "", body, flags=re.DOTALL)
        found = re.findall(r"(?<!->)(?<!::)\b([A-Z]\w+)\([^;{]*\)\s*(?:const)?\s*(override)?\s*(?:;|\{)", body)
        count += sum(method != "New" and not overrides for method, overrides in found)
        base = re.search(rf"class \S+ (?:VTK_MARSHALAUTO )?{name}\s*: public (\w+)", text)
        name = base[1] if base and base[1].startswith("vtkFF") else None
    return count


def main(build=None):
    classes = sorted(installed_classes())
    most = max(classes, key=methods)
    rows = [
        ("lines of Filters without Parallel", lines("Filters", ("Parallel",)), 6000),
        ("lines of Filters/Parallel", lines("Filters/Parallel"), 2500),
        ("lines of Testing/Cxx", lines("Testing/Cxx"), 9000),
        (f"functions of more than {LONGEST} lines", len(long_functions("Filters")), 0),
        (f"methods beyond vtkAlgorithm's, at most ({most})", methods(most), 60),
    ]
    if build:
        rows.append(("exported symbols of classes that are not installed", len(private_exports(build)), 0))
    for what, found, bound in rows:
        print(f"{what:60}{found:>7}  of {bound}{'' if found <= bound else '  (missed)'}")
    for function in long_functions("Filters"):
        print("  longer:", function)
    return any(found > bound for _, found, bound in rows)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
