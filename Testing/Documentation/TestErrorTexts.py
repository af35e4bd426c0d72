# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bad argument is told by a text of its own, which names the argument and what is allowed."""

import glob
import os
import re
import unittest

from tree import TOP, read


class TestErrorTexts(unittest.TestCase):
    def test_no_bad_argument_without_a_text(self):
        texts = 0
        for folder in ("Engine", "Cuda", "Filters", os.path.join("Wrapping", "Core")):
            for path in glob.glob(os.path.join(TOP, folder, "**", "*"), recursive=True):
                if not path.endswith((".cxx", ".h", ".cu")) or path.endswith("flipflop/Error.h"):
                    continue
                source = read(path)
                with self.subTest(os.path.relpath(path, TOP)):
                    self.assertEqual(re.findall(r"\bError\s*[({]\s*ErrorCode::BadArgument\b", source), [])
                texts += len(re.findall(r"\bbadArgument\(", source))
        self.assertGreater(texts, 30)


if __name__ == "__main__":
    unittest.main()
