# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tests observe of a filter."""


def errors_of(algorithm):
    """A list that will hold the messages of the algorithm's errors."""
    messages = []

    def observe(caller, event, message):
        messages.append(message)

    observe.CallDataType = "string0"
    algorithm.AddObserver("ErrorEvent", observe)
    # It says no more than that the algorithm failed.
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda caller, event: None)
    return messages
