# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the architecture are the tree: boxes are its folders, arrows tell which uses which."""

import html
import re
import unittest

from dependencies import dependencies, folders, reduced, module_dependencies, modules
from tree import TOP, read


def of_source(dot):
    """The boxes and arrows of the picture's source."""
    boxes = set(re.findall(r"^\s*(\w+) \[label", dot, re.MULTILINE))
    arrows = set(re.findall(r"^\s*(\w+) -> (\w+);", dot, re.MULTILINE))
    return boxes, arrows


def of_picture(svg):
    """The boxes and arrows that were drawn."""
    titles = [html.unescape(title) for title in re.findall(r"<title>(.*?)</title>", svg)]
    arrows = {tuple(title.split("->")) for title in titles if "->" in title}
    return {title for title in titles if "->" not in title} - {"architecture", "modules"}, arrows


def words_of_source(dot):
    """What the boxes say, line by line."""
    lines = re.split(r"<[^<>]*>", " ".join(re.findall(r"label = <(.*)>\]", dot)))
    return {line.strip() for line in lines} - {""}


def words_of_picture(svg):
    return {html.unescape(text).strip() for text in re.findall(r"<text[^>]*>(.*?)</text>", svg)}


SOURCE = read("Documentation", "architecture.dot")
MODULES_SOURCE = read("Documentation", "modules.dot")


class TestPictures(unittest.TestCase):
    def test_source(self):
        boxes, arrows = of_source(SOURCE)
        self.assertEqual(boxes, set(folders()))
        self.assertEqual(arrows, dependencies())

    def test_picture_is_drawn_from_the_source(self):
        picture = read("Documentation", "Figures", "architecture.svg")
        self.assertEqual(of_picture(picture), of_source(SOURCE))
        self.assertEqual(words_of_picture(picture), words_of_source(SOURCE))

    def test_the_picture_of_modules(self):
        boxes, arrows = of_source(MODULES_SOURCE)
        self.assertEqual(boxes, set(modules(TOP, "Engine")))
        self.assertEqual(arrows, reduced(module_dependencies(TOP, "Engine")))
        picture = read("Documentation", "Figures", "modules.svg")
        self.assertEqual(of_picture(picture), (boxes, arrows))
        self.assertEqual(words_of_picture(picture), words_of_source(MODULES_SOURCE))


if __name__ == "__main__":
    unittest.main()
