# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Doxygen's filter for our Markdown pages: python3 doxygen_page.py PAGE.md

Doxygen 1.9.4 knows neither GitHub's names for headings nor links to headings of other pages. So
each heading is given a label, page-<page>-<anchor>, and each link to a page becomes one to a label.
Files that are no pages are not part of the HTML: a link to one becomes its path.
"""

import os
import re
import sys

from markdown_page import headings, prose, replace_links

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def label(page, anchor=""):
    """Of a page, given by its path, or of one of its headings."""
    name = os.path.splitext(os.path.relpath(page, TOP))[0]
    name = re.sub(r"\W", "-", name).lower()
    return f"page-{name}-{anchor}" if anchor else f"page-{name}"


def in_doxygen(page, link):
    target, _, anchor = link["target"].partition("#")
    if ":" in link["target"]:
        return link[0]
    if link["picture"]:  # Doxygen looks in IMAGE_PATH
        return f"![{link['text']}]({os.path.basename(target)})"
    path = os.path.join(os.path.dirname(page), target) if target else page
    if path.endswith(".md"):
        return f"[{link['text']}](#{label(path, anchor)})"
    return f"{link['text']} (`{os.path.relpath(path, TOP)}`)"


def convert(page, text):
    labels = {
        number: label(page, "" if level == 1 else anchor)
        for number, level, _, anchor in headings(text)
    }
    for number, line, is_prose in prose(text):
        if is_prose:
            line = replace_links(line, lambda link: in_doxygen(page, link))
        yield f"{line} {{#{labels[number]}}}" if number in labels else line


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        print("\n".join(convert(os.path.abspath(sys.argv[1]), file.read())))
