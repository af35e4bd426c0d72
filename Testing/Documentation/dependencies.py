# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tree's folders, and which of them uses which: what its files include, import or name."""

import fnmatch
import os
import re

from tree import TOP, read

INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^"<>]+)[">]', re.MULTILINE)
CXX = {".h", ".cxx", ".cu"}

# Beside C++: who names this uses that folder. A suffix .in is CMake's, and means nothing.
NAMES = [
    (".py", re.compile(r"^\s*(?:from|import) \.?vtkFiltersFlipFlop\b", re.MULTILINE), "Filters"),
    (".py", re.compile(r"^\s*(?:from|import) vtkflipflop\b", re.MULTILINE), "Wrapping"),
    (".py", re.compile(r"\b\w+FlipFlop\("), "Plugin"),
    (".xml", re.compile(r'\bclass="vtkP?FF\w+"'), "Filters"),
]


def folders(top=TOP):
    """The folders at the top, without those that git ignores and the hidden ones."""
    ignore = []
    if os.path.exists(os.path.join(top, ".gitignore")):
        with open(os.path.join(top, ".gitignore"), encoding="utf-8") as file:
            ignore = [line.strip().strip("/") for line in file]
    return sorted(
        name
        for name in os.listdir(top)
        if os.path.isdir(os.path.join(top, name))
        and not name.startswith(".")
        and not any(fnmatch.fnmatch(name, pattern) for pattern in ignore)
    )


def sources(top, folder, suffixes):
    """(suffix, text) of a folder's files with one of the suffixes."""
    for path, _, names in os.walk(os.path.join(top, folder)):
        for name in names:
            suffix = os.path.splitext(name[:-3] if name.endswith(".in") else name)[1]
            if suffix in suffixes:
                with open(os.path.join(path, name), encoding="utf-8") as file:
                    yield suffix, file.read()


def headers(top, folder):
    """All names by which a folder's headers may be included."""
    names = set()
    base = os.path.join(top, folder)
    for path, _, files in os.walk(base):
        for name in files:
            if name.endswith(".h"):
                whole = os.path.relpath(os.path.join(path, name), top)
                own = os.path.relpath(whole, folder)
                public = own[len("include/"):] if own.startswith("include/") else own
                names |= {name, whole, public}
    return names


def dependencies(top=TOP):
    """The pairs (folder, another that it uses)."""
    all_folders = folders(top)
    headers_of = {folder: headers(top, folder) for folder in all_folders}
    found = set()
    for folder in all_folders:
        for suffix, text in sources(top, folder, CXX | {".py", ".xml"}):
            for name in INCLUDE.findall(text) if suffix in CXX else ():
                if name not in headers_of[folder]:
                    found |= {(folder, other) for other in all_folders if name in headers_of[other]}
            found |= {(folder, other) for kind, mark, other in NAMES
                      if kind == suffix and mark.search(text)}
    return {(user, used) for user, used in found if user != used}


def modules(top, folder):
    """The modules of a folder: its own folders, but for the public headers."""
    return [name for name in folders(os.path.join(top, folder)) if name != "include"]


def module_dependencies(top, folder):
    """The pairs (module, another of the same folder that it includes a header of)."""
    all_modules = set(modules(top, folder))
    return {
        (module, name.split("/")[0])
        for module in all_modules
        for _, text in sources(top, os.path.join(folder, module), CXX)
        for name in INCLUDE.findall(text)
        if name.split("/")[0] in all_modules - {module}
    }


def private_includes(top, folder):
    """What a folder's public headers include besides each other, the system's and the libraries'."""
    return {
        name
        for _, text in sources(top, os.path.join(folder, "include"), CXX)
        for name in INCLUDE.findall(text)
        if f'"{name}"' in text or name.split("/")[0] in modules(top, folder)
    }


def includes(top, folder):
    """For each file of a folder the names that it includes."""
    return {
        os.path.relpath(os.path.join(path, name), os.path.join(top, folder)): set(
            INCLUDE.findall(read(os.path.join(path, name)))
        )
        for path, _, names in os.walk(os.path.join(top, folder))
        for name in names
        if os.path.splitext(name)[1] in CXX
    }


def reached(start, edges):
    """All files that a file includes, over others, too."""
    found, left = set(), [start]
    while left:
        for name in edges.get(left.pop(), ()):
            name = f"include/{name}" if f"include/{name}" in edges else name
            if name not in found:
                found.add(name)
                left.append(name)
    return found


def public_calls(top, folder):
    """(name, whether all of it is in engineCall()) of each function of the public headers that a folder defines."""
    texts = [text for _, text in sources(top, os.path.join(folder, "include"), CXX)]
    declared = re.sub(r"//.*", "", "\n".join(texts))
    names = set(re.findall(r"\b(\w+)\(", declared))
    classes = "|".join(re.findall(r"^class (\w+)\n\{", declared, re.MULTILINE)) or "-"
    begin = re.compile(rf"^(?:\w[^\n;{{}}()=]*[ >&*])?((?:(?:{classes})::)?(\w+))\(", re.MULTILINE)
    for module in modules(top, folder):
        for _, text in sources(top, os.path.join(folder, module), {".cxx"}):
            text = re.sub(r"^namespace\n\{.*?^\}\n(?=\n\S|\})", "", text, flags=re.MULTILINE | re.DOTALL)
            for found in begin.finditer(text):
                rest = text[found.end():]
                is_defined = rest.find("\n{\n") >= 0 and ";" not in rest[:rest.find("\n{\n")].split("engineCall(")[0]
                if found[2] in names and is_defined:
                    yield found[1], bool(re.match(r"[^;{]*(?:\n\{\n  (?:return )?|: \w+\()engineCall\(", rest))


def reduced(pairs):
    """Without the pairs that a way over others tells, too."""
    def reaches(start, end, left):
        return any(a == start and (b == end or reaches(b, end, left)) for a, b in left)

    return {(a, b) for a, b in pairs if not reaches(a, b, pairs - {(a, b)})}
