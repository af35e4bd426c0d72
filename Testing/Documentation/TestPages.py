# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages stay short and begin with what they are for; each table of measurements has its plot."""

import glob
import os
import unittest

from dependencies import folders
from tree import TOP, read

# The most words, as wc -w counts them.
MOST = {"README.md": 1000, os.path.join("Documentation", "Architecture.md"): 2000}
MOST_IN_ALL = 25000


def pages():
    """The pages of the tree, from its top on."""
    found = glob.glob("*.md", root_dir=TOP)
    for folder in folders():
        root = os.path.join(TOP, folder)
        found += [os.path.join(folder, page) for page in glob.glob("**/*.md", root_dir=root, recursive=True)]
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
