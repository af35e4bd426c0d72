# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages.md lists all that the filters say, word by word: each message is provoked here, or by the test it names."""

import glob
import os
import re
import unittest

from failures import FAILURES, WARNINGS
from outcomes import errors_while_updating, messages_while_updating
from tree import TOP, read
from vtkflipflop import vtkFFAlgorithm

PAGE = read("Documentation", "Messages.md")
FAILURE = "| when | the filter says | the engine throws |"
WARNING = "| when | the filter warns |"
RARE = "| the filter says | test | the engine throws |"
# Strings of the sources that nobody is shown: of an exception that is always caught, of profiles.
UNSEEN = {"a value that no double holds", "to the host", "from the host"}


def rows_below(header):
    """The cells of all tables of this header, without their rules."""
    rows = []
    for table in PAGE.split(f"\n{header}\n")[1:]:
        lines = table.split("\n\n", 1)[0].splitlines()[1:]
        rows += [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    return rows


def matches(message, row):
    """Whether the message is the row's, where a … is anything."""
    return re.fullmatch(".+".join(map(re.escape, row.split("…"))), message) is not None


def strings(source):
    """A C++ source's string literals; those next to each other are one."""
    source = re.sub(r"//[^\n]*|/\*.*?\*/|static_assert\(.*?\);", "", source, flags=re.DOTALL)
    one = r'"(?:[^"\\\n]|\\.)*"'
    for literals in re.findall(rf"{one}(?:\s*{one})*", source):
        parts = re.findall(r'"((?:[^"\\\n]|\\.)*)"', literals)
        yield "".join(parts).replace('\\"', '"').replace("\\n", "\n")


def sources(*folders):
    for folder in folders:
        for path in glob.glob(os.path.join(TOP, folder, "**", "*"), recursive=True):
            if path.endswith((".cxx", ".h", ".cu")):
                yield path


class TestMessages(unittest.TestCase):
    def test_failures(self):
        rows = rows_below(FAILURE)
        self.assertEqual([row[0] for row in rows], list(FAILURES))
        for name, sentence, _ in rows:
            if name == "the CUDA engine, where there is none" and vtkFFAlgorithm.IsCUDAAvailable():
                continue
            with self.subTest(name):
                algorithm = FAILURES[name]()
                messages = errors_while_updating(algorithm)
                self.assertEqual(len(messages), 1)
                self.assertTrue(matches(messages[0], sentence), messages[0])
                self.assertNotEqual(algorithm.GetErrorCode(), 0)
                for port in range(algorithm.GetNumberOfOutputPorts()):
                    output = algorithm.GetOutputDataObject(port)
                    self.assertEqual(output.GetNumberOfElements(0), 0)

    def test_warnings(self):
        rows = rows_below(WARNING)
        self.assertEqual([row[0] for row in rows], list(WARNINGS))
        for name, sentence in rows:
            with self.subTest(name):
                algorithm = WARNINGS[name]()
                self.assertEqual(messages_while_updating(algorithm, "WarningEvent"), [sentence])
                self.assertEqual(algorithm.GetErrorCode(), 0)
                self.assertGreater(algorithm.GetOutput().GetNumberOfPoints(), 0)

    def test_the_others_are_in_the_tests_named(self):
        rows = rows_below(RARE)
        self.assertGreater(len(rows), 10)
        untested = 0
        for sentence, test, _ in rows:
            with self.subTest(sentence):
                if not test:
                    untested += 1
                    continue
                files = glob.glob(os.path.join(TOP, "Testing", "Cxx", "**", test + ".cxx"), recursive=True)
                self.assertEqual(len(files), 1, test)
                said = list(strings(read(files[0])))
                parts = [part.strip() for part in sentence.split("…") if len(part.split()) >= 3]
                self.assertTrue(any(part in text for part in parts for text in said), parts)
        self.assertEqual(untested, 1)

    def test_nothing_else_is_said(self):
        """Every string of several words in the sources is on the page."""
        found = 0
        page = " ".join(PAGE.split())
        for path in sources("Filters", "Cuda/Choice", "Cuda/Device"):
            said = strings(read(path))
            for text in (part for string in said for part in re.split(r"\{[a-z]+\}", string)):
                if len(re.findall(r"[A-Za-z]{2,}", text)) < 3 or "%" in text or text in UNSEEN:
                    continue
                found += 1
                with self.subTest(os.path.relpath(path, TOP)):
                    self.assertTrue(" ".join(text.split()) in page, text)
        self.assertGreater(found, 80)

    def test_steps(self):
        told = "\n".join(row[1] for row in rows_below("| what | steps |"))
        steps = set()
        for path in sources("Engine", "Cuda"):
            for call in re.findall(r"\bstage\(([^;]*)\);", read(path)):
                steps |= {text for text in strings(call) if not text.endswith("-")}  # but names of files
        self.assertIn("scanning", steps)
        self.assertEqual({step for step in steps if step not in told}, set())

    def test_every_code_is_told(self):
        codes = re.search(r"enum class ErrorCode\n\{(.*?)\};", read("Engine", "include", "flipflop", "Error.h"),
                          re.DOTALL)
        codes = set(re.findall(r"^\s*(\w+)\s*(?:,|///<)", codes[1], re.MULTILINE))
        self.assertIn("NonFinite", codes)
        told = set(re.findall(r"`([A-Z]\w+)`", PAGE))
        self.assertEqual(codes - told, set())

    def test_tests_that_are_named_exist(self):
        tests = set()
        for path in glob.glob(os.path.join(TOP, "Testing", "Engine", "*", "Test*.cxx")):
            tests |= set(re.findall(r"^TEST(?:_P|_F)?\((\w+), (\w+)\)", read(path), re.MULTILINE))
        named = {
            tuple(name)
            for page in (PAGE, read("Documentation", "Exactness.md"))
            for name in re.findall(r"`([A-Z]\w+)\.([A-Z]\w+)`", page)
        }
        self.assertGreater(len(named), 10)
        self.assertEqual(named - tests, set())


if __name__ == "__main__":
    unittest.main()
