# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages' relative links and pictures lead to files and headings; the files they name are there."""

import os
import tempfile
import unittest

from dependencies import folders
from links import faults, missing_files
from tree import TOP

# Right and wrong ones in turn; what is code is no link.
SAMPLE = """# A page

[heading](#a-page) and [none](#b-page)
![picture](there.png) and ![none](absent.png)
[page](other.md) and [none](others.md)
[its heading](other.md#c-plus-plus--python-1) and [none](other.md#c)
[`code`](sub/) and [none](sub/none), [far](https://example.org/none)

    [indented](is-text-here-too.md)

`[code](none.md)`

```
[fenced](none.md)
```

| [in a table](none.csv) | [and](there.png#none) |
"""

OTHER = """# Other

## C plus plus & Python

## C plus plus & Python
"""


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def all_pages():
    places = [TOP] + [
        path for folder in folders() for path, _, _ in os.walk(os.path.join(TOP, folder))
    ]
    return sorted(
        os.path.join(place, name)
        for place in places
        for name in os.listdir(place)
        if name.endswith(".md")
    )


class TestLinks(unittest.TestCase):
    def test_pages_are_found(self):
        self.assertIn(os.path.join(TOP, "README.md"), all_pages())
        self.assertIn(os.path.join(TOP, "Documentation", "Architecture.md"), all_pages())

    def test_pages(self):
        for page in all_pages():
            with self.subTest(os.path.relpath(page, TOP)):
                self.assertEqual(list(faults(page)), [])

    def test_files_that_pages_name(self):
        for page in all_pages():
            with self.subTest(os.path.relpath(page, TOP)):
                self.assertEqual(list(missing_files(page, TOP, folders())), [])

    def test_a_missing_file_is_noticed(self):
        with tempfile.TemporaryDirectory() as top:
            os.mkdir(os.path.join(top, "Engine"))
            write(os.path.join(top, "Engine", "Hull.h"), "")
            page = os.path.join(top, "page.md")
            write(page, "`Engine/Hull.h` `Engine/*.h` `Engine/` `Other/Hull.h` `Engine.h`\n"
                        "`Engine/None.h` `Engine/None.sh --all` `Engine/*.cxx`\n")
            self.assertEqual(
                list(missing_files(page, top, ["Engine"])),
                [(2, "Engine/None.h"), (2, "Engine/None.sh"), (2, "Engine/*.cxx")],
            )

    def test_a_broken_page_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(os.path.join(folder, "sub"))
            write(os.path.join(folder, "there.png"), "")
            write(os.path.join(folder, "other.md"), OTHER)
            page = os.path.join(folder, "page.md")
            write(page, SAMPLE)
            self.assertEqual(
                list(faults(page)),
                [
                    (3, "#b-page", "no such heading"),
                    (4, "absent.png", "no such file"),
                    (5, "others.md", "no such file"),
                    (6, "other.md#c", "no such heading"),
                    (7, "sub/none", "no such file"),
                    (9, "is-text-here-too.md", "no such file"),
                    (17, "none.csv", "no such file"),
                    (17, "there.png#none", "a heading of what is no page"),
                ],
            )


if __name__ == "__main__":
    unittest.main()
