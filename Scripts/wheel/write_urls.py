# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""For a release: writes the repository's address into pyproject.toml, from where all metadata have it.

    write_urls.py URL

The tree does not know where it is kept; whoever releases it does.
"""

import re
import sys
from pathlib import Path

from assemble_wheel import project_urls

TOP = Path(__file__).resolve().parents[2]


def with_urls(text, home, version):
    """pyproject.toml's text with the table project.urls."""
    rows = "".join(f'{name} = "{page}"\n' for name, page in project_urls(home, version).items())
    return text.replace("[tool.scikit-build]\n", f"[project.urls]\n{rows}\n[tool.scikit-build]\n", 1)


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        raise SystemExit("usage: write_urls.py URL")
    version = re.search(r"project\(FlipFlop\s+VERSION ([\d.]+)", (TOP / "CMakeLists.txt").read_text())[1]
    file = TOP / "pyproject.toml"
    file.write_text(with_urls(file.read_text(), sys.argv[1].rstrip("/"), version))
