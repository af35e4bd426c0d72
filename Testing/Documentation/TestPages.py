# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages stay short and begin with what they are for, and the filters have the methods that they name. Each table of
measurements has its plot.
"""

import glob
import os
import re
import unittest

from dependencies import folders
from markdown_page import code
from tree import TOP, read

# The most words, as wc -w counts them.
MOST = {"README.md": 1000, os.path.join("Documentation", "Architecture.md"): 2000}
MOST_IN_ALL = 26700


def pages():
    """The pages of the tree, from its top on."""
    found = glob.glob("*.md", root_dir=TOP)
    for folder in folders():
        root = os.path.join(TOP, folder)
        found += [os.path.join(folder, page) for page in glob.glob("**/*.md", root_dir=root, recursive=True)]
    return found


def methods():
    """Those of the filters, also by VTK's macros."""
    headers = "".join(map(read, glob.glob(os.path.join(TOP, "Filters", "**", "*.h"), recursive=True)))
    found = set(re.findall(r"\b(\w+)\(", headers))
    for kind, name in re.findall(r"\bvtk(Set|Get|Boolean)\w*Macro\((\w+)", headers):
        found |= {name + "On", name + "Off"} if kind == "Boolean" else {kind + name}
    return found


class TestPages(unittest.TestCase):
    def test_length(self):
        words = {page: len(read(page).split()) for page in pages()}
        self.assertGreater(len(words), 20)
        for page, most in MOST.items():
            self.assertLessEqual(words[page], most, page)
        self.assertLessEqual(sum(words.values()), MOST_IN_ALL)

    def test_begin(self):
        for page in pages():
            if page.startswith("Documentation"):
                with self.subTest(page):
                    title, _, rest = read(page).partition("\n\n")
                    self.assertTrue(title.startswith("# "))
                    self.assertRegex(rest, r"\A(After this (page|tutorial)|A test )")

    def test_methods(self):
        named = {
            method
            for page in pages()
            if page != "CHANGELOG.md"  # which names those that are gone
            for _, words in code(read(page))
            for method in re.findall(r"\b((?:Set|Get)[A-Z]\w+|[A-Z]\w+(?:On|Off))\(", words)
        }
        self.assertGreater(len(named), 5)
        self.assertEqual(named - methods(), set())

    def test_measurements(self):
        tables = glob.glob("*.csv", root_dir=os.path.join(TOP, "Documentation", "Measurements"))
        self.assertGreater(len(tables), 8)
        shown = "".join(map(read, pages()))
        for table in tables:
            with self.subTest(table):
                self.assertIn(f"](Measurements/{table})", shown)
                self.assertRegex(table, r"-\d{4}-\d\d-\d\d\.csv$")
                self.assertIn(f"](Figures/measured-{table[:-len('-2026-01-01.csv')]}.png)", shown)


if __name__ == "__main__":
    unittest.main()
