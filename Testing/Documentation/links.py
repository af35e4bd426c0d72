# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Links, pictures and named files of Markdown pages that are not there.

What lies elsewhere (https:) is not asked for. A file is named by code that begins with a folder
of the tree; a * in it stands for anything.
"""

import glob
import os

from markdown_page import code, headings, links
from tree import read


def fault_of(page, target):
    """What is wrong with a link's target, or None."""
    path, _, anchor = target.partition("#")
    goal = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
    if not os.path.exists(goal):
        return "no such file"
    if anchor:
        if not goal.endswith(".md"):
            return "a heading of what is no page"
        if anchor not in [name for _, _, _, name in headings(read(goal))]:
            return "no such heading"
    return None


def faults(page):
    """(line number, target, what is wrong) of each link of the page that leads nowhere."""
    for number, link in links(read(page)):
        if ":" not in link["target"]:
            fault = fault_of(page, link["target"])
            if fault:
                yield number, link["target"], fault


def missing_files(page, top, folders):
    """(line number, path) of each file or folder that the page names and the tree has not."""
    for number, words in code(read(page)):
        path = words.split()[0] if words.split() else ""
        if path.split("/")[0] in folders and "/" in path and not glob.glob(os.path.join(top, path)):
            yield number, path
