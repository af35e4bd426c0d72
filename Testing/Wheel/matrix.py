#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the wheel beside each VTK and PyVista that users may have, on each Python: a new environment for each pair.

    matrix.py [--pythons PYTHON,...] [--only WORD] [--work FOLDER] WHEEL...

Of the wheels, pip takes the one that fits a Python. An environment that the package index has no files for is named
so, with pip's reason. Documentation/Install.md sums up the table that is printed. The exit code is 1 if a test fails.
"""

import argparse
import json
import os
import re
import subprocess
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]

ARRAYS = ["Testing/Arrays", "Testing/Wheel/TestPages.py"]
PYVISTA = [*(f"Testing/Arrays/Test{name}.py" for name in ("Bits", "Forms", "Typing")), "Testing/Wheel"]
CLASSES = [*PYVISTA, "Testing/Python"]

# What is installed beside the wheel, without what it would bring along by itself; and the tests.
ENVIRONMENTS = {
    "numpy alone": (["mypy", "scipy"], ARRAYS),
    **{
        f"vtk {version}": ([f"vtk=={version}.*", "pyvista", "tqdm", "scipy", "mypy"], CLASSES)
        for version in ("9.2", "9.3", "9.4", "9.5", "9.6", "9.7")
    },
    "cvista": (["cvista", "pyvista", "tqdm", "scipy", "mypy"], PYVISTA),
    "oldest PyVista": (["pyvista==0.44.*", "vtk<9.5", "tqdm", "scipy", "mypy"], PYVISTA),
}

SHOWN = ("numpy", "vtk", "cvista", "pyvista")


def said(command, **keywords):
    return subprocess.run(command, capture_output=True, text=True, **keywords)


def installed(python, wheels, requirements):
    """None, or why it cannot be."""
    binary = ["--only-binary", ":all:", "--quiet"]
    folders = [option for wheel in wheels for option in ("--find-links", str(wheel.parent))]
    steps = [["vtkflipflop", *requirements, "pytest", *folders]]
    if "cvista" in requirements:
        # PyVista asks for vtk, which cvista replaces.
        others = [name for name in requirements if name != "pyvista"]
        steps = [["vtkflipflop", *others, "pytest", *folders], ["--no-deps", "pyvista"]]
    for step in steps:
        done = said([python, "-m", "pip", "install", *binary, *step])
        if done.returncode:
            return done.stderr.strip().splitlines()[-1]
    if "cvista" in requirements:
        said([python, "-m", "pip", "install", *binary, *needed_but_vtk(python)])
    return None


def needed_but_vtk(python):
    """What PyVista needs beside VTK."""
    program = "from importlib.metadata import requires; print(*requires('pyvista'), sep='\\n')"
    lines = said([python, "-c", program]).stdout.splitlines()
    return [line for line in lines if "extra ==" not in line and not re.match(r"vtk\b", line)]


def versions(python):
    found = json.loads(said([python, "-m", "pip", "list", "--format", "json"]).stdout)
    known = {package["name"].lower(): package["version"] for package in found}
    return ", ".join(f"{name} {known[name]}" for name in SHOWN if name in known)


def tried(python, tests, folder):
    """The summary of pytest's, and whether all is right."""
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": ""}
    command = [python, "-m", "pytest", "-q", "-rs", "-p", "no:cacheprovider", "--override-ini", "python_files=Test*.py"]
    done = said([*command, *(str(TOP / test) for test in tests)], cwd=folder, env=environment)
    (folder / "pytest.log").write_text(done.stdout + done.stderr)
    lines = done.stdout.strip().splitlines()
    return re.sub(r" in [\d.]+s.*", "", lines[-1] if lines else "nothing was printed"), done.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--pythons", default=",".join(f"python3.{minor}" for minor in range(11, 15)))
    parser.add_argument("--only", default="", help="only environments whose name has this")
    parser.add_argument("--work", type=Path, default=TOP / "build" / "matrix")
    parser.add_argument("wheels", nargs="+", type=lambda text: Path(text).resolve())
    arguments = parser.parse_args()

    right = True
    print("| Python | environment | versions | tests |\n|---|---|---|---|")
    for name in arguments.pythons.split(","):
        version = said(["sh", "-c", f"{name} -c 'import platform; print(platform.python_version())'"]).stdout.strip()
        for label, (requirements, tests) in ENVIRONMENTS.items():
            if arguments.only not in label:
                continue
            if not version:
                print(f"| {name} | {label} | | not on this machine |", flush=True)
                continue
            folder = arguments.work / f"{version} {label}".replace(" ", "-")
            subprocess.run([name, "-m", "venv", "--clear", folder], check=True)
            python = folder / "bin" / "python"
            said([python, "-m", "pip", "install", "--quiet", "--upgrade", "pip"])
            problem = installed(python, arguments.wheels, requirements)
            summary, passed = (problem, True) if problem else tried(python, tests, folder)
            right = right and passed
            print(f"| {version} | {label} | {'' if problem else versions(python)} | {summary} |", flush=True)
    sys.exit(0 if right else 1)


if __name__ == "__main__":
    main()
