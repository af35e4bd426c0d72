# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What help() says of the filters: a text for each class and method, as VTK's wrapper lays it out."""

import pydoc
import re
import unittest

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

import vtkflipflop

CLASSES = [getattr(vtkflipflop, name) for name in vtkflipflop.__all__]


def own_methods(cls):
    """The methods that a class has of its own, by name, without Python's."""
    return {
        name: member
        for name, member in vars(cls).items()
        if callable(member) and not isinstance(member, type) and not name.startswith("_")
    }


def text_of(name, doc):
    """A method's doc string without its signatures."""
    paragraphs = re.split(r"\n\s*\n", (doc or "").strip())
    return "\n\n".join(part for part in paragraphs if not part.startswith(name + "("))


def torn_items(text):
    """The lines that are neither within an item of a list nor apart from it."""
    torn = []
    inside = False
    for line in text.splitlines():
        if line.startswith("- "):
            inside = True
        elif not line.strip():
            inside = False
        elif inside and not line.startswith("  "):
            torn.append(line)
    return torn


@unittest.skipUnless(vtkflipflop.vtk_classes == "compiled", "VTK's wrapper has not made these texts")
class TestHelp(unittest.TestCase):
    def test_every_class_has_a_text(self):
        self.assertGreaterEqual(len(CLASSES), 7)
        for cls in CLASSES:
            with self.subTest(cls.__name__):
                self.assertRegex(cls.__doc__, rf"^{cls.__name__} - \w+")
                self.assertGreater(len(cls.__doc__), 200)

    @unittest.skipUnless(text_of("GetAbortExecute", vtkAlgorithm.GetAbortExecute.__doc__),
                         "this VTK (9.1) reads the comment of a group for its first method alone, of its own classes, too")
    def test_every_method_has_a_text(self):
        counted = 0
        for cls in CLASSES:
            for name, method in own_methods(cls).items():
                counted += 1
                with self.subTest(f"{cls.__name__}.{name}"):
                    self.assertTrue(text_of(name, method.__doc__).strip(), method.__doc__)
        self.assertGreater(counted, 100)

    def test_nothing_is_a_table(self):
        for cls in CLASSES:
            texts = {cls.__name__: cls.__doc__}
            texts.update((name, method.__doc__) for name, method in own_methods(cls).items())
            for name, text in texts.items():
                with self.subTest(f"{cls.__name__}: {name}"):
                    self.assertNotIn("|", text.replace("|x - p|^2", ""))

    def test_lists_stay_lists(self):
        lists = 0
        for cls in CLASSES:
            texts = [cls.__doc__] + [method.__doc__ for method in own_methods(cls).values()]
            for text in texts:
                lists += "\n- " in text
                self.assertEqual(torn_items(text), [], text)
        self.assertGreater(lists, 10)

    def test_help_shows_them(self):
        page = pydoc.plain(pydoc.render_doc(vtkflipflop.vtkFFHullFilter))
        self.assertIn("- coplanar points: one polygon, once (or its triangles)", page)
        self.assertIn("how facets are given", page)


if __name__ == "__main__":
    unittest.main()
