# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python of pages runs as it is printed, and prints what its comments say: README.md and three others, tutorials as
notebooks, and the arrays' examples. A tutorial's pictures are those that its code draws.

What imports something that is not installed is left out, with all after it: it uses that, too. In the cookbook, and for
VTK classes that do not fit the VTK that is there, a block stands for itself.
"""

import importlib.util
import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from vtkflipflop import _vtk_check

TOP = Path(__file__).resolve().parents[2]
EXAMPLES = TOP / "Examples" / "Python" / "Arrays"
TUTORIALS = TOP / "Documentation" / "Tutorials"
FIGURES = TOP / "Documentation" / "Figures"
sys.path.insert(0, str(TOP / "Documentation"))
import notebooks  # noqa: E402

NOTEBOOKS = sorted(page.stem for page in TUTORIALS.glob("*.md") if "```python" in page.read_text())


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


def has_filters():
    try:
        _vtk_check.check()
    except ImportError:
        return False
    return True


def run(page, blocks, capsys, least=1):
    """How many blocks ran. Skips the test where fewer can than that."""
    names, ran = {"__name__": page}, 0
    for block in blocks:
        if "import vtkFF" in block and not has_filters() or missing(block) and page == "Cookbook":
            continue
        if lacking := missing(block):
            if ran < least:
                pytest.skip(f"without {', '.join(sorted(lacking))}")
            break
        exec(compile(block, page, "exec"), names)  # later blocks use the names of earlier ones
        ran += 1
        printed = capsys.readouterr().out
        # What a comment says of the first or last thing that is printed: print(...)  # 6 facets
        words = printed.replace(",", " ").split()
        assert set(re.findall(r"print\(.*\)  # ([^\s,]+)", block)) <= set(words), printed
        assert len(words) >= block.count("print(")
    return ran


@pytest.mark.parametrize("page", ["README.md", "Documentation/Python.md", "Documentation/FromScipy.md", "Documentation/CheckAResult.md"])
def test_page(page, capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    assert run(page, re.findall(r"```python\n(.*?)```", (TOP / page).read_text(), re.DOTALL), capsys)


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    return {path.stem: path for path in notebooks.write(tmp_path_factory.mktemp("notebooks"))}


def test_every_page_with_python_is_a_notebook(written):
    assert len(NOTEBOOKS) > 4 and sorted(written) == NOTEBOOKS
    for path in written.values():
        for cell in json.loads(path.read_text())["cells"]:
            if cell["cell_type"] == "markdown":
                for target in re.findall(r"\]\(([^()\s#]+)", "".join(cell["source"])):
                    assert ":" in target or (path.parent / target).exists(), target


@pytest.mark.parametrize("page", NOTEBOOKS)
def test_notebook(page, written, capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(written[page].parent)  # where Jupyter starts
    draw_into(tmp_path, monkeypatch)
    cells = json.loads(written[page].read_text())["cells"]
    code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    ran = run(page, code, capsys, 2)
    assert ran >= 2 or page == "Cookbook"
    if ran == len(code):
        check_pictures((TUTORIALS / f"{page}.md").read_text(), tmp_path)


def draw_into(folder, monkeypatch):
    """Files of pictures go there."""
    if importlib.util.find_spec("pyvista") is None:
        return
    try:
        plotter = importlib.import_module("pyvista.plotting").Plotter
    except ImportError:
        return
    screenshot = plotter.screenshot

    def into_folder(scene, filename=None, **settings):
        return screenshot(scene, filename and str(folder / filename), **settings)

    monkeypatch.setattr(plotter, "screenshot", into_folder)


def check_pictures(page, folder):
    """Those that the page shows are those that were drawn, in 256 colours."""
    drawn = sorted(path.name for path in folder.iterdir())
    assert drawn == sorted(re.findall(r"\]\(\.\./Figures/([\w-]+\.png)\)", page))
    for name in drawn:
        assert (FIGURES / name).stat().st_size < 150_000, name
        sizes, pixels = zip(*map(pixels_of, (FIGURES / name, folder / name)))
        assert sizes[0] == sizes[1], name
        assert 0.05 < np.mean((pixels[0] != 255).any(axis=1)) < 0.95, name
        # Another renderer may draw edges a little differently; before VTK 9.3 none is translucent.
        edges_are_opaque = tuple(importlib.import_module("pyvista").vtk_version_info)[:2] < (9, 3)
        assert edges_are_opaque or np.abs(pixels[0] - pixels[1]).mean() < 1.5, name


def pixels_of(path):
    import pyvista

    image = pyvista.read(path)
    return image.dimensions, np.asarray(image.active_scalars, float)[:, :3]


@pytest.mark.parametrize("example", sorted(EXAMPLES.glob("*.py")), ids=lambda path: path.name)
def test_example(example):
    done = subprocess.run([sys.executable, "-W", "error", str(example)], capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout and not done.stderr, done.stderr
    assert f"({EXAMPLES.name}/{example.name})" in (EXAMPLES.parent / "README.md").read_text()
