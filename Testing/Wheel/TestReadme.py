# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python of README.md and Documentation/Python.md runs as it is printed, page by page."""

import re
from pathlib import Path

import pytest

TOP = Path(__file__).resolve().parents[2]
PAGES = ("README.md", "Documentation/Python.md")


@pytest.mark.parametrize("page", PAGES)
def test_page(page, capsys, monkeypatch):
    monkeypatch.chdir(TOP)
    blocks = re.findall(r"```python\n(.*?)```", (TOP / page).read_text(), re.DOTALL)
    assert blocks
    names = {"__name__": page}
    for block in blocks:
        exec(compile(block, page, "exec"), names)  # later blocks use the names of earlier ones
        printed = capsys.readouterr().out.split()
        assert len(printed) >= block.count("print(")
        # What a comment says of a printed number: print(...)  # 6 facets
        assert set(re.findall(r"print\(.*\)  # (\d+)", block)) <= set(printed)
