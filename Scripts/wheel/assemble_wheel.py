# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel to give away, from repaired wheels for one version of Python each.

    assemble_wheel.py --output FOLDER [--licence NAME FILE]... [--add FILE]... [--home URL] WHEEL...

The core has one file for Python 3.12 and later, but each module of VTK classes has one file for each version. The
first wheel gets those of the others, whose names tell the version, the licences of what travels with it, and files for
the package vtkflipflop. Where the repository's address is told, the metadata tell it, too, and the description's links
and pictures, which are relative in README.md, lead there: a package index shows the description elsewhere.
"""

import argparse
import base64
import hashlib
import re
import zipfile
from pathlib import Path


def is_versions_own(name):
    """Whether a file is an extension for one version of Python."""
    return ".cpython-" in Path(name).name


def content(wheel):
    """A wheel's files by their names."""
    with zipfile.ZipFile(wheel) as archive:
        return {info.filename: (info, archive.read(info)) for info in archive.infolist() if not info.is_dir()}


def add(files, path, file):
    files[path] = (zipfile.ZipInfo(path, (2026, 1, 1, 0, 0, 0)), file.read_bytes())


def add_licence(files, metadata, name, file):
    """Puts a licence where LICENSE is, and names it in the metadata, before the description."""
    add(files, f"{metadata.removesuffix('METADATA')}licenses/{name}", file)
    info, text = files[metadata]
    head, body = text.decode().split("\n\n", 1)
    files[metadata] = (info, f"{head}\nLicense-File: {name}\n\n{body}".encode())


def absolute(description, home, version):
    """The description with addresses in place of paths, at the version's tag; pictures as in the repository."""

    def address(found):
        kind = "raw" if found[1] else "blob"
        return f"{found[1]}[{found[2]}]({home}/{kind}/v{version}/{found[3]})"

    return re.sub(r"(!?)\[([^\]]*)\]\((?!https?:|#)([^)]+)\)", address, description)


def project_urls(home, version):
    """The project's pages by their names in metadata."""
    return {
        "Source": home,
        "Documentation": f"{home}/blob/v{version}/Documentation/Python.md",
        "Changelog": f"{home}/blob/v{version}/CHANGELOG.md",
        "Issues": f"{home}/issues",
    }


def add_home(files, metadata, home):
    info, text = files[metadata]
    head, description = text.decode().split("\n\n", 1)
    version = re.search(r"^Version: (\S+)", head, re.MULTILINE)[1]
    head += "".join(f"\nProject-URL: {name}, {page}" for name, page in project_urls(home, version).items())
    files[metadata] = (info, f"{head}\n\n{absolute(description, home, version)}".encode())


def record_row(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")
    return f"{name},sha256={digest},{len(data)}\n"


def assemble(output, wheels, licences=(), additions=(), home=None):
    first, *others = wheels
    files = content(first)
    for other in others:
        if other.name != first.name:
            raise SystemExit(f"{other} is not for the same systems as {first}")
        for name, entry in content(other).items():
            if is_versions_own(name):
                files.setdefault(name, entry)
    (metadata,) = (name for name in files if name.endswith(".dist-info/METADATA"))
    for name, file in licences:
        add_licence(files, metadata, name, Path(file))
    for file in additions:
        add(files, f"vtkflipflop/{file.name}", file)
    if home:
        add_home(files, metadata, home.rstrip("/"))
    record = metadata.replace("METADATA", "RECORD")
    info, _ = files.pop(record)
    rows = [record_row(name, data) for name, (_, data) in files.items()]
    files[record] = (info, "".join([*rows, f"{record},,\n"]).encode())
    output.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(output / first.name, "w") as archive:
        for info, data in files.values():
            archive.writestr(info, data, zipfile.ZIP_DEFLATED)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", required=True, type=Path)
    parser.add_argument("--licence", nargs=2, action="append", default=[], metavar=("NAME", "FILE"))
    parser.add_argument("--add", action="append", default=[], type=Path, metavar="FILE")
    parser.add_argument("--home", metavar="URL")
    parser.add_argument("wheels", nargs="+", type=Path)
    arguments = parser.parse_args()
    assemble(arguments.output, arguments.wheels, arguments.licence, arguments.add, arguments.home)
