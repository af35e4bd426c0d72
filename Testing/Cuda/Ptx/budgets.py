#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Assemble the device code for one architecture, and hold every kernel to its budget.

    budgets.py --ptxas PTXAS --architecture sm_90 device-code.ptx

A fast kernel spills nothing and has no stack: it runs with many threads at a time, and what they
hold is memory that all of them fight for. An exact kernel runs with few, and its stack is bounded.
"""

import argparse
import re
import subprocess
import sys
import tempfile

FAST_REGISTERS = 80
TAIL_REGISTERS = 128  # of a block of 512 threads
EXACT_STACK = 4096  # bytes a thread, calls included
EXACT = re.compile(r"(Locate|Check)Exact")

ENTRY = re.compile(r"Compiling entry function '(\S+)'")
FRAME = re.compile(r"(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads")
USED = re.compile(r"Used (\d+) registers")
CUMULATIVE = re.compile(r"(\d+) bytes cumulative stack size")


def kernels(report):
    """Of each entry: name, registers, stack, bytes spilled."""
    name = frame = None
    for line in report.splitlines():
        if match := ENTRY.search(line):
            name, frame = match[1], None
        elif (match := FRAME.search(line)) and name and frame is None:
            frame = match  # the entry's own comes first, its functions' later
        elif (match := USED.search(line)) and name:
            stack = CUMULATIVE.search(line)
            yield (name, int(match[1]), int(stack[1]) if stack else int(frame[1]),
                   int(frame[2]) + int(frame[3]))
            name = None


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--ptxas", required=True)
    parser.add_argument("--architecture", required=True)
    parser.add_argument("ptx")
    options = parser.parse_args()
    with tempfile.NamedTemporaryFile(suffix=".cubin") as output:
        run = subprocess.run(
            [options.ptxas, "-v", f"-arch={options.architecture}", "-o", output.name, options.ptx],
            capture_output=True, text=True, check=False)
    if run.returncode:
        sys.exit(f"ptxas for {options.architecture} failed:\n{run.stderr}")
    found = list(kernels(run.stderr))
    names = subprocess.run(["c++filt"], input="\n".join(row[0] for row in found), text=True,
                           capture_output=True, check=True).stdout.splitlines()
    faults = 0
    print(f"{options.architecture}: registers, stack, spilled")
    for (_, registers, stack, spilled), name in zip(found, names):
        short = re.split(r"run(?:Kernel|BoundedKernel|Tail)<", name)[1].partition(">(")[0].replace("flipflop::", "")
        exact = EXACT.search(name) is not None
        most = TAIL_REGISTERS if "runTail<" in name else FAST_REGISTERS
        over = stack > EXACT_STACK if exact else registers > most or stack or spilled
        faults += 1 if over else 0
        print(f"{registers:5d} {stack:6d} {spilled:6d}  {short}{'   OVER BUDGET' if over else ''}")
    exact_count = sum(1 for row in found if EXACT.search(row[0]))
    if exact_count != 6 or len(found) < 30:
        sys.exit(f"{len(found)} kernels, {exact_count} of them exact, are not those expected")
    sys.exit(f"{faults} kernels are over their budgets" if faults else 0)


if __name__ == "__main__":
    main()
