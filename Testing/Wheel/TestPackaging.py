# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is put into the wheel, and what is told in several places."""

import re
import sys
import tomllib
from importlib.metadata import distribution
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "Scripts"))
import write_urls  # noqa: E402

PROJECT = tomllib.loads((TOP / "pyproject.toml").read_text())
HOME = "https://example.org/flipflop"


def test_relative_links_become_addresses():
    text = "![a picture](Figures/a.png) [page](Page.md#part) [far](https://example.com) [here](#there)\n"
    assert write_urls.absolute(text, HOME, "0.1.0") == (
        "![a picture](https://example.org/flipflop/raw/v0.1.0/Figures/a.png) "
        "[page](https://example.org/flipflop/blob/v0.1.0/Page.md#part) [far](https://example.com) [here](#there)\n"
    )


def test_all_of_the_readme_s_links_become_addresses():
    text = (TOP / "README.md").read_text()
    links = re.findall(r"\]\(([^)]+)\)", write_urls.absolute(text, HOME, "1"))
    assert links and all(re.match("https?:|#", link) for link in links)


def test_a_release_writes_its_addresses():
    written = tomllib.loads(write_urls.with_urls((TOP / "pyproject.toml").read_text(), HOME, "0.1.0"))
    assert written["project"].pop("urls") == write_urls.project_urls(HOME, "0.1.0")
    assert written == PROJECT


def test_device_code_is_for_who_asks():
    assert PROJECT["tool"]["scikit-build"]["cmake"]["define"]["FLIPFLOP_CUDA"] == "OFF"


def test_what_travels_along_has_its_licence():
    files = [str(file) for file in distribution("vtkflipflop").files]
    assert not any("vtkflipflop.libs" in file for file in files)
    for licence in PROJECT["project"]["license-files"]:
        assert any(file.endswith(f"licenses/{licence}") for file in files)


def test_numpy_is_all_that_is_needed():
    assert PROJECT["project"]["dependencies"] == ["numpy>=1.25"]
    needed = [line for line in distribution("vtkflipflop").requires if "extra ==" not in line]
    assert needed == ["numpy>=1.25"]


def test_the_recipe_for_conda_tells_the_same():
    recipe = (TOP / "Scripts" / "conda" / "recipe.yaml").read_text()
    version = re.search(r"project\(FlipFlop\s+VERSION ([\d.]+)", (TOP / "CMakeLists.txt").read_text())[1]
    assert f'version: "{version}"' in recipe
    for requirement in (*PROJECT["build-system"]["requires"], *PROJECT["project"]["dependencies"]):
        if not re.match("boost|cmeel", requirement):  # conda's have other names and versions
            assert "- " + re.sub(r"([a-z])([<>=])", r"\1 \2", requirement, count=1) in recipe
