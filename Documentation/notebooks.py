# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tutorials as Jupyter notebooks: python3 notebooks.py FOLDER

Each page of Tutorials/ that has Python becomes FOLDER/<page>.ipynb. Its pictures and links name files of the source
tree, so FOLDER lies there: build/notebooks, for example.
"""

import json
import os
import re
import sys
from pathlib import Path

TUTORIALS = Path(__file__).resolve().parent / "Tutorials"
TOP = TUTORIALS.parents[1]
# Code reads files of Data/ from the tree's top.
FIRST = "import os\n\nos.chdir({path!r})  # where Data/ is"


def cells(page, folder):
    """(is it code, text) of a page's parts, with its links from the folder on."""

    def moved(link):
        if ":" in link[2] or link[2].startswith("#"):
            return link[0]
        return f"{link[1]}({os.path.relpath(page.parent / link[2], folder)})"

    for is_code, text in enumerate_parts(page.read_text(encoding="utf-8")):
        yield is_code, text if is_code else re.sub(r"(\[[^\]]*\])\(([^()\s]+)\)", moved, text)


def enumerate_parts(text):
    for number, part in enumerate(re.split(r"^```python\n(.*?)^```$", text, flags=re.DOTALL | re.MULTILINE)):
        if part.strip():
            yield number % 2 == 1, part.strip()


def notebook(page, folder):
    """A notebook's JSON, or None of a page without Python."""
    parts = list(cells(page, folder))
    if not any(is_code for is_code, _ in parts):
        return None
    parts.insert(1, (True, FIRST.format(path=os.path.relpath(TOP, folder))))

    def cell(number, is_code, text):
        of_code = {"execution_count": None, "outputs": []} if is_code else {}
        return {"cell_type": "code" if is_code else "markdown", "id": f"cell-{number}", "metadata": {},
                **of_code, "source": text.splitlines(keepends=True)}  # fmt: skip

    return {
        "cells": [cell(number, *part) for number, part in enumerate(parts)],
        "metadata": {
            "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
            "language_info": {"name": "python"},
        },
        "nbformat": 4,
        "nbformat_minor": 5,
    }


def write(folder):
    folder = Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    for page in sorted(TUTORIALS.glob("*.md")):
        if made := notebook(page, folder):
            path = folder / f"{page.stem}.ipynb"
            path.write_text(json.dumps(made, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
            yield path


if __name__ == "__main__":
    for path in write(sys.argv[1]):
        print("wrote", path)
