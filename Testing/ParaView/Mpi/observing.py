# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests see of data and of messages, in whatever process: a client, a server's rank, plain Python."""

import re

from vtkmodules.vtkCommonCore import vtkOutputWindow

from digests import leaves


def of_field(data, name):
    """The one value of a field data array, for each leaf that has it."""
    found = [leaf.GetFieldData().GetAbstractArray(name) for leaf in leaves(data).values() if leaf]
    return [array.GetValue(0) for array in found if array]


class Messages:
    """Errors and warnings that reach this process's output window, as pairs of a kind and its words."""

    def __init__(self):
        self.told = []
        for kind in ("Error", "Warning"):
            vtkOutputWindow.GetInstance().AddObserver(f"{kind}Event", self._observer(kind))

    def _observer(self, kind):
        def observe(caller, event, text):
            # What VTK puts before the words is the source line, the class and the object.
            for words in re.findall(r"\(0x[0-9a-f]+\): (.*)", text) or [text.strip()]:
                self.told.append((kind, words))

        observe.CallDataType = "string0"
        return observe

    def take(self):
        """All since the last call."""
        told, self.told = self.told, []
        return told
