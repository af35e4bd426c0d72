# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""For a release: writes the repository's address into pyproject.toml, and into the links and pictures of README.md.

    write_urls.py URL

The tree does not know where it is kept; whoever releases it does. A package index shows README.md elsewhere.
"""

import re
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[1]


def project_urls(home, version):
    """The project's pages by their names in metadata."""
    return {
        "Source": home,
        "Documentation": f"{home}/blob/v{version}/Documentation/Python.md",
        "Changelog": f"{home}/blob/v{version}/CHANGELOG.md",
        "Issues": f"{home}/issues",
    }


def with_urls(text, home, version):
    """pyproject.toml's text with the table project.urls."""
    rows = "".join(f'{name} = "{page}"\n' for name, page in project_urls(home, version).items())
    return text.replace("[tool.scikit-build]\n", f"[project.urls]\n{rows}\n[tool.scikit-build]\n", 1)


def absolute(description, home, version):
    """README.md's text with addresses in place of paths, at the version's tag; pictures as in the repository."""

    def address(found):
        kind = "raw" if found[1] else "blob"
        return f"{found[1]}[{found[2]}]({home}/{kind}/v{version}/{found[3]})"

    return re.sub(r"(!?)\[([^\]]*)\]\((?!https?:|#)([^)]+)\)", address, description)


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        raise SystemExit("usage: write_urls.py URL")
    version = re.search(r"project\(FlipFlop\s+VERSION ([\d.]+)", (TOP / "CMakeLists.txt").read_text())[1]
    for name, change in (("pyproject.toml", with_urls), ("README.md", absolute)):
        file = TOP / name
        file.write_text(change(file.read_text(), sys.argv[1].rstrip("/"), version))
