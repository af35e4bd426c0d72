#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run a test of something that is broken on purpose: passes where the test fails, also by a crash or by not ending."""
import subprocess
import sys

SECONDS = 600


def is_noticed(command, seconds=SECONDS):
    """(whether it is, what it says at last)"""
    try:
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return True, f"not done in {seconds} s"
    said = [line for line in run.stdout.splitlines() if not line.startswith("ok ")]
    return run.returncode != 0, f"status {run.returncode}: " + " / ".join(said[-3:])


if __name__ == "__main__":
    noticed, said = is_noticed(sys.argv[1:])
    print(said)
    sys.exit(0 if noticed else 1)
