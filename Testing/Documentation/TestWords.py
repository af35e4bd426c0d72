# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts/check-words.py: the tree has no name with a replaced word, and a planted one is found."""

import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest

from tree import TOP

SCRIPT = os.path.join(TOP, "Scripts", "check-words.py")
sys.dont_write_bytecode = True
spec = importlib.util.spec_from_file_location("check_words", SCRIPT)
check_words = importlib.util.module_from_spec(spec)
spec.loader.exec_module(check_words)


def found(path, text):
    return check_words.complaints(path, text)


class TestWords(unittest.TestCase):
    def test_the_tree(self):
        if not os.path.exists(os.path.join(TOP, ".git")):
            self.skipTest("the script reads what git lists")
        run = subprocess.run([sys.executable, SCRIPT], stdout=subprocess.PIPE, check=False)
        self.assertEqual(run.returncode, 0, run.stdout.decode())

    def test_a_planted_name_is_found(self):
        (line,) = found("Engine/Run/Run.cxx", "int a;\nint leaveOut(int b);\n")
        self.assertEqual(line, "Engine/Run/Run.cxx:2: leaveOut; write exclude")

    def test_a_word_of_a_name_is_found_in_the_library(self):
        for name in ["vertexPlace", "toldPoints", "points_told", "MostPlaces"]:
            self.assertEqual(len(found("Engine/Run/Run.h", f"int {name};")), 1, name)
            self.assertEqual(found("Testing/Run.h", f"int {name};"), [], name)

    def test_a_file_is_found_by_its_name(self):
        self.assertEqual(len(found("Engine/Support/LowestOf.h", "")), 1)

    def test_comments_strings_and_other_words_are_not_read(self):
        text = "// its place\n/* told\n */ auto s = \"a place\"; int emplaced, replace, classroom;\n"
        self.assertEqual(found("Engine/Run/Run.h", text), [])
        self.assertEqual(found("Wrapping/a.py", 'x = "leaveOut"  # leaveOut\n'), [])

    def test_the_script_fails_on_a_planted_file(self):
        with tempfile.TemporaryDirectory(dir=TOP, prefix="build-") as folder:
            path = os.path.join(folder, "Planted.h")
            with open(path, "w", encoding="utf-8") as file:
                file.write("int numberFound;\n")
            run = subprocess.run(
                [sys.executable, SCRIPT, path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False
            )
        self.assertEqual(run.returncode, 1)
        self.assertIn("numberFound; write parallelCompact", run.stdout.decode())


if __name__ == "__main__":
    unittest.main()
