# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python of README.md and of two other pages runs as it is printed, page by page; so do the arrays' examples.

Where there is no PyVista, a page ends where it is first used. Where the VTK classes do not fit the VTK that is there, what
uses them is left out.
"""

import importlib.util
import re
import subprocess
import sys
from pathlib import Path

import pytest

from vtkflipflop import _vtk_check

TOP = Path(__file__).resolve().parents[2]
PAGES = ("README.md", "Documentation/Python.md", "Documentation/CheckAResult.md")
EXAMPLES = TOP / "Examples" / "Python" / "Arrays"


def has_filters():
    try:
        _vtk_check.check()
    except ImportError:
        return False
    return True


@pytest.mark.parametrize("page", PAGES)
def test_page(page, capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", (TOP / page).read_text(), re.DOTALL)
    assert blocks
    names = {"__name__": page}
    for block in blocks:
        if "pyvista" in block and not importlib.util.find_spec("pyvista"):
            break
        if "import vtkFF" in block and not has_filters():
            continue
        exec(compile(block, page, "exec"), names)  # later blocks use the names of earlier ones
        printed = capsys.readouterr().out.split()
        assert len(printed) >= block.count("print(")
        # What a comment says of a printed number: print(...)  # 6 facets
        assert set(re.findall(r"print\(.*\)  # (\w+)", block)) <= set(printed)


@pytest.mark.parametrize("example", sorted(EXAMPLES.glob("*.py")), ids=lambda path: path.name)
def test_example(example):
    done = subprocess.run([sys.executable, "-W", "error", str(example)], capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout and not done.stderr, done.stderr
    assert f"({EXAMPLES.name}/{example.name})" in (EXAMPLES.parent / "README.md").read_text()
