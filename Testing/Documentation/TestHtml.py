# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The HTML that Doxygen wrote into FLIPFLOP_HTML: its links and pictures lead to files."""

import os
import tempfile
import unittest
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit


class Targets(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.found = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in {"href", "src", "data"} and value:
                self.found.append(value)


def faults(folder):
    """(page, target) of each relative link that leads to no file."""
    for page in sorted(os.listdir(folder)):
        if page.endswith(".html"):
            with open(os.path.join(folder, page), encoding="utf-8") as file:
                for target in Targets(file.read()).found:
                    parts = urlsplit(target)
                    path = unquote(parts.path)
                    if not parts.scheme and not os.path.exists(os.path.join(folder, path)):
                        yield page, target


class TestHtml(unittest.TestCase):
    def test_pages(self):
        html = os.environ["FLIPFLOP_HTML"]
        for page in ("index", "classvtkFFHullFilter", "structflipflop_1_1Statistics"):
            self.assertTrue(os.path.exists(os.path.join(html, page + ".html")), page)
        self.assertEqual(list(faults(html)), [])

    def test_a_broken_page_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "a.html"), "w", encoding="utf-8") as file:
                file.write('<a href="a.html#x"/><a href="x://y"/><a href="b.md"/>')
                file.write('<img src="c.png"/>')
            self.assertEqual(list(faults(folder)), [("a.html", "b.md"), ("a.html", "c.png")])


if __name__ == "__main__":
    unittest.main()
