# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is put into the wheel, and what is told in several places."""

import base64
import csv
import hashlib
import io
import re
import sys
import tomllib
import zipfile
from importlib.metadata import distribution
from pathlib import Path

import pytest

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "Scripts" / "wheel"))
import assemble_wheel  # noqa: E402
import write_urls  # noqa: E402

PROJECT = tomllib.loads((TOP / "pyproject.toml").read_text())
NAME = "vtkflipflop-0.1.0-cp312-abi3-any.whl"
INFORMATION = "vtkflipflop-0.1.0.dist-info"


@pytest.fixture
def wheel(tmp_path):
    """Makes a small wheel for one version of Python."""

    def make(tag, description="About it.\n"):
        folder = tmp_path / tag
        folder.mkdir()
        with zipfile.ZipFile(folder / NAME, "w") as archive:
            archive.writestr("vtkflipflop/_core.abi3.so", "core")
            archive.writestr(f"vtkflipflop/vtkFiltersFlipFlop.{tag}.so", tag)
            archive.writestr(f"{INFORMATION}/METADATA", f"Name: vtkflipflop\nVersion: 0.1.0\n\n{description}")
            archive.writestr(f"{INFORMATION}/RECORD", "stale")
        return folder / NAME

    return make


def assembled(tmp_path, *wheels, **more):
    assemble_wheel.assemble(tmp_path / "out", wheels, **more)
    with zipfile.ZipFile(tmp_path / "out" / NAME) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def test_wheels_are_joined(tmp_path, wheel):
    files = assembled(tmp_path, wheel("cpython-312"), wheel("cpython-313"))
    assert files["vtkflipflop/vtkFiltersFlipFlop.cpython-312.so"] == b"cpython-312"
    assert files["vtkflipflop/vtkFiltersFlipFlop.cpython-313.so"] == b"cpython-313"


def test_the_record_is_true(tmp_path, wheel):
    (tmp_path / "types.pyi").write_text("x: int\n")
    files = assembled(tmp_path, wheel("cpython-312"), additions=[tmp_path / "types.pyi"])
    rows = {row[0]: row[1:] for row in csv.reader(io.StringIO(files[f"{INFORMATION}/RECORD"].decode()))}
    assert rows.keys() == files.keys() and "vtkflipflop/types.pyi" in files
    for name, data in files.items():
        if not name.endswith("RECORD"):
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")
            assert rows[name] == [f"sha256={digest}", str(len(data))]


def test_a_licence_is_added_and_named(tmp_path, wheel):
    files = assembled(tmp_path, wheel("cpython-312"), licences=[("oneTBB/LICENSE", TOP / "LICENSE")])
    assert files[f"{INFORMATION}/licenses/oneTBB/LICENSE"] == (TOP / "LICENSE").read_bytes()
    head, description = files[f"{INFORMATION}/METADATA"].decode().split("\n\n")
    assert "License-File: oneTBB/LICENSE" in head.splitlines() and description == "About it.\n"


def test_relative_links_become_addresses(tmp_path, wheel):
    text = "![a picture](Figures/a.png) [page](Page.md#part) [far](https://example.com) [here](#there)\n"
    files = assembled(tmp_path, wheel("cpython-312", text), home="https://example.org/flipflop/")
    head, description = files[f"{INFORMATION}/METADATA"].decode().split("\n\n")
    assert description == (
        "![a picture](https://example.org/flipflop/raw/v0.1.0/Figures/a.png) "
        "[page](https://example.org/flipflop/blob/v0.1.0/Page.md#part) [far](https://example.com) [here](#there)\n"
    )
    assert "Project-URL: Source, https://example.org/flipflop" in head.splitlines()


def test_a_release_writes_its_addresses():
    text = write_urls.with_urls((TOP / "pyproject.toml").read_text(), "https://example.org/flipflop", "0.1.0")
    written = tomllib.loads(text)
    assert written["project"].pop("urls") == assemble_wheel.project_urls("https://example.org/flipflop", "0.1.0")
    assert written == PROJECT


def test_device_code_is_for_who_asks():
    assert PROJECT["tool"]["scikit-build"]["cmake"]["define"]["FLIPFLOP_CUDA"] == "OFF"


def test_all_of_the_readme_s_links_become_addresses():
    text = (TOP / "README.md").read_text()
    links = re.findall(r"\]\(([^)]+)\)", assemble_wheel.absolute(text, "https://example.org", "1"))
    assert links and all(re.match("https?:|#", link) for link in links)


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
