# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tutorials, as notebooks: each cell of code runs, and prints what its comments say.

Cells that import what is not installed are left out; in the cookbook each cell stands for itself.
"""

import importlib.util
import json
import re
import sys
from pathlib import Path

import pytest

TOP = Path(__file__).resolve().parents[2]
TUTORIALS = TOP / "Documentation" / "Tutorials"
sys.path.insert(0, str(TOP / "Documentation"))
import notebooks  # noqa: E402

PAGES = sorted(page.stem for page in TUTORIALS.glob("*.md") if "```python" in page.read_text())


def missing(code):
    """What the code imports and is not here."""
    names = set(re.findall(r"^(?:import|from) (\w+)", code, re.MULTILINE))
    # PyVista is looked for through us, too.
    names |= {"pyvista"} if "vtkflipflop.pyvista" in code else set()
    lacking = {name for name in names if importlib.util.find_spec(name) is None}
    if "pv.Plotter" in code and not lacking:
        try:
            importlib.import_module("pyvista.plotting")
        except ImportError:
            return {"a PyVista that can draw"}
    return lacking


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    return {path.stem: path for path in notebooks.write(tmp_path_factory.mktemp("notebooks"))}


def test_every_page_with_python_is_a_notebook(written):
    assert len(PAGES) > 4 and sorted(written) == PAGES


@pytest.mark.parametrize("page", PAGES)
def test_notebook(page, written, capsys, monkeypatch):
    monkeypatch.chdir(written[page].parent)  # where Jupyter starts
    cells = json.loads(written[page].read_text())["cells"]
    names = {"__name__": page}
    ran = 0
    for cell in cells:
        code = "".join(cell["source"])
        if cell["cell_type"] != "code":
            continue
        if lacking := missing(code):
            if page == "Cookbook":
                continue
            if ran < 2:
                pytest.skip(f"without {', '.join(sorted(lacking))}")
            break  # the rest uses it, too
        exec(compile(code, page, "exec"), names)
        ran += 1
        printed = capsys.readouterr().out
        # What a comment says of the first or last thing that is printed: print(...)  # 6
        expected = re.findall(r"print\(.*\)  # (\S+)$", code, re.MULTILINE)
        words = printed.replace(",", " ").split()
        assert all(word in words for word in expected), printed
    assert ran >= 2 or page == "Cookbook"


def test_links_lead_to_files(written):
    for path in written.values():
        for cell in json.loads(path.read_text())["cells"]:
            if cell["cell_type"] == "markdown":
                for target in re.findall(r"\]\(([^()\s#]+)", "".join(cell["source"])):
                    assert ":" in target or (path.parent / target).exists(), target
