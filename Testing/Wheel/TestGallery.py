# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery: each script runs, its claims hold, and the page shows what it prints and draws."""

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import pyvista as pv

pytest.importorskip("pyvista.plotting", reason="this PyVista cannot draw", exc_type=ImportError)
if pv.vtk_version_info < (9, 6):
    pytest.skip("the gallery was made with VTK 9.6", allow_module_level=True)

TOP = Path(__file__).resolve().parents[2]
FIGURES = TOP / "Documentation" / "Figures"
SCRIPTS = sorted((TOP / "Examples" / "Gallery").glob("[!_]*.py"))
PAGE = (TOP / "Documentation" / "Gallery.md").read_text(encoding="utf-8")


def sections(page):
    """By script: the pictures that its section of the page shows, and what it says is printed."""
    found = {}
    for section in re.split(r"^## ", page, flags=re.MULTILINE)[1:]:
        pictures = re.findall(r"!\[[^\]]+\]\(Figures/(gallery-[\w-]+\.png)\)", section)
        printed = re.findall(r"^    (.*)$", section, re.MULTILINE)
        for script in re.findall(r"\]\(\.\./Examples/Gallery/(\w+\.py)\)", section):
            assert script not in found, f"{script} has two sections"
            found[script] = pictures, printed
    return found


def pixels_of(path):
    image = pv.read(path)
    return image.dimensions, np.asarray(image.active_scalars, dtype=float)


def share_drawn(path):
    """The share of a picture's pixels that are not white."""
    _, pixels = pixels_of(path)
    return np.mean((pixels != 255).any(axis=1))


def test_the_page_shows_every_script_and_picture():
    shown = sections(PAGE)
    assert sorted(shown) == [script.name for script in SCRIPTS]
    pictures = [picture for pictures, _ in shown.values() for picture in pictures]
    assert sorted(pictures) == sorted(path.name for path in FIGURES.glob("gallery-*.png"))
    for picture in pictures:
        assert 0.05 < share_drawn(FIGURES / picture) < 0.95


def test_readme_s_picture_has_the_figures_that_were_printed():
    readme = (TOP / "README.md").read_text(encoding="utf-8")
    (caption, picture), *_ = re.findall(r"!\[([^\]]+)\]\(Documentation/Figures/([\w-]+\.png)\)", readme)
    (printed,) = (lines for pictures, lines in sections(PAGE).values() if picture in pictures)
    figures = re.findall(r"[\d,]*\d", caption)
    assert len(figures) > 3 and set(figures) <= set(re.findall(r"[\d,]*\d", " ".join(printed))), figures


def without_vtk_s_own(lines):
    """What VTK's own filters give may change from version to version."""
    return [re.sub(r"vtkDelaunay\dD: .*", "", line) for line in lines]


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.stem)
def test_script(script, tmp_path):
    run = subprocess.run(
        [sys.executable, script, "--output", tmp_path],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert run.returncode == 0, run.stderr
    pictures, printed = sections(PAGE)[script.name]
    *said, wrote = run.stdout.splitlines()
    assert without_vtk_s_own(said) == without_vtk_s_own(printed)
    assert wrote == f"wrote {tmp_path / pictures[0]}"
    assert sorted(path.name for path in tmp_path.iterdir()) == pictures

    # Another renderer may draw edges a little differently; another VTK's filters may give something else to draw.
    size, drawn = pixels_of(tmp_path / pictures[0])
    shown_size, shown = pixels_of(FIGURES / pictures[0])
    assert size == shown_size
    of_vtk = without_vtk_s_own(printed) != printed and said != printed
    assert of_vtk or np.mean(abs(drawn - shown)) < 3


def test_a_blank_picture_is_noticed(tmp_path):
    for meshes, drawn in (([], False), ([pv.Sphere()], True)):
        scene = pv.Plotter(off_screen=True)
        scene.set_background("white")
        for mesh in meshes:
            scene.add_mesh(mesh)
        scene.screenshot(tmp_path / "picture.png")
        assert (share_drawn(tmp_path / "picture.png") > 0.05) == drawn
