# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every relative link and picture of every page leads to a file, and to a heading that is there."""

import os
import tempfile
import unittest

from dependencies import folders
from links import faults
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


class TestLinks(unittest.TestCase):
    def test_pages(self):
        places = [TOP] + [
            path for folder in folders() for path, _, _ in os.walk(os.path.join(TOP, folder))
        ]
        pages = [
            os.path.join(place, name)
            for place in places
            for name in os.listdir(place)
            if name.endswith(".md")
        ]
        self.assertIn(os.path.join(TOP, "README.md"), pages)
        self.assertIn(os.path.join(TOP, "Documentation", "Architecture.md"), pages)
        found = [
            f"{os.path.relpath(page, TOP)}:{number}: {target}: {fault}"
            for page in sorted(pages)
            for number, target, fault in faults(page)
        ]
        self.assertEqual(found, [], "\n" + "\n".join(found))

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
