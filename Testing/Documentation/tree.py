# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the tree is, and what its files say."""

import os

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def read(*path):
    """A file's text, given its path, from the tree's top on if it is relative."""
    with open(os.path.join(TOP, *path), encoding="utf-8") as file:
        return file.read()
