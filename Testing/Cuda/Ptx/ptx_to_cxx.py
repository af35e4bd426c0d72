#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Translate PTX to C++, so that device code runs on the CPU, one thread after the other.

    ptx_to_cxx.py input.ptx... -o out.cxx [--namespace NAME] [--split N]

Every .entry and .func becomes a C++ function, every register a local variable, every branch a goto.
Generic addresses are the CPU's: memory of all spaces is memory, and parameters are passed by
address. A thread is a warp of its own, of which lane 0 alone is active. At a barrier of its block
it calls launch.wait. What has no exact translation (approximations, roundings but to nearest,
shared memory, other barriers), and what is not known here, is refused by name and line; nothing is
guessed. NaNs are NaNs, but their bits are the
CPU's. The head and the end of the result are ptx_preamble.cxx.in and ptx_interface.cxx.in; it must be
compiled with -ffp-contract=off.
"""

import argparse
import pathlib
import re
import sys

from ptx_function import Function
from ptx_syntax import (
    identifier, parse_declaration, Refused,
)

TEMPLATES = pathlib.Path(__file__).parent
PREAMBLE = (TEMPLATES / "ptx_preamble.cxx.in").read_text()
INTERFACE = "\n" + (TEMPLATES / "ptx_interface.cxx.in").read_text()

HEADER = re.compile(r"((?:\.(?:visible|weak|extern)\s+)*)\.(entry|func)\s+(?:\(([^)]*)\)\s*)?"
                    r"([$%\w]+)\s*(?:\(([^)]*)\))?[^{;]*([{;])")
SKIPPED = re.compile(r"\s+|\.(?:version|target)\b[^\n]*|\.address_size\s+64\b"
                     r"|\.section\s+[^{]*\{[^}]*\}")
STATEMENT = re.compile(r"\s*(?:([{}])|([$%\w]+)\s*:(?!:)|([^;{}]+(?:\{[^{}]*\}[^;{}]*)*);)")


class Module:
    """One file of PTX."""

    def __init__(self, path, prefix, taken):
        self.path, self.prefix, self.taken = path, prefix, taken
        self.functions = {}
        self.bodies = []  # name, start, end, function
        self.entries = []  # mangled name, function
        # What is left out keeps its lines.
        self.text = re.sub(r"//[^\n]*|/\*.*?\*/|^\s*\.(?:loc|file)\b[^\n]*",
                           lambda m: "\n" * m[0].count("\n"), path.read_text(), flags=re.S | re.M)

    def refuse(self, position, statement, reason):
        line = self.text.count("\n", 0, position) + 1
        statement = " ".join(statement.split())[:200]
        raise Refused(f"{self.path}:{line}: refused '{statement}': {reason}")

    def new_name(self, name):
        result = self.prefix + identifier(name)
        if self.taken.setdefault(result, (self, name)) != (self, name):
            raise Refused(f"two names {result}")
        return result

    def translate(self):
        position = 0
        while position < len(self.text):
            skipped = SKIPPED.match(self.text, position)
            match = skipped or HEADER.match(self.text, position)
            try:
                if not match:
                    raise Refused("unknown directive")
                position = match.end() if skipped else self.define(match)
            except Refused as error:
                text = match[0] if match else self.text[position:position + 80].split("\n")[0]
                self.refuse(position, text, error)
        for start, end, function in self.bodies:
            self.translate_body(start, end, function)

    def define(self, match):
        """A function; where it ends."""
        linkage, kind, results, name, parameters, end = match.groups()
        if ".extern" in linkage:
            return match.end()
        new = self.new_name(name)
        self.functions[name] = new
        if end == ";":
            return match.end()
        results, parameters = (
            [parse_declaration(word)[0] for word in (text or "").split(",") if word.strip()]
            for text in (results, parameters))
        function = Function(self, new, kind == "entry", results, parameters)
        if function.is_entry:
            self.entries.append((name, function))
        depth = 1
        for brace in re.compile(r"[{}]").finditer(self.text, match.end()):
            depth += 1 if brace[0] == "{" else -1
            if depth == 0:
                self.bodies.append((match.end(), brace.start(), function))
                return brace.end()
        raise Refused("no end")

    def translate_body(self, start, end, function):
        position, end = start, start + len(self.text[start:end].rstrip())
        while position < end:
            match = STATEMENT.match(self.text, position, end)
            if not match:
                self.refuse(position, self.text[position:position + 80], "unknown statement")
            position = match.end()
            brace, label, statement = match.groups()
            try:
                if brace:
                    function.open_scope() if brace == "{" else function.close_scope()
                elif label:
                    function.lines.append(f"{function.label(label)}:;")
                else:
                    function.translate(statement.strip())
            except Refused as error:
                self.refuse(match.start(match.lastindex), statement or label, error)
            except (ValueError, IndexError, KeyError):
                self.refuse(match.start(match.lastindex), statement or label, "unknown operands")


def dispatch_table(modules):
    """Instances of one template may be in several modules, if they do the same."""
    seen, lines = {}, []
    for module in modules:
        for mangled, function in module.entries:
            text = "".join(function.lines).replace(module.prefix, "")
            if seen.setdefault(mangled, text) != text:
                raise Refused(f"{module.path}: a second and different {mangled}")
            if len(seen) > len(lines):
                sizes = ", ".join(str(size) for size in function.parameter_sizes)
                lines.append(f'  {{ "{mangled}", {function.name}, {{ {sizes} }}, '
                             f'{str(function.waits).lower()} }},\n')
    return INTERFACE.replace("@ENTRIES@", "".join(lines))


def generate(modules, namespace, count):
    """The texts of so many files, the last one with the table."""
    functions = [function for module in modules for _, _, function in module.bodies]
    head = PREAMBLE.replace("@NAMESPACE@", namespace)
    head += "\n".join(f"{function.signature()};" for function in functions) + "\n"
    texts, sizes = [[] for _ in range(count)], [0] * count
    for function in sorted(functions, key=lambda function: -function.count):
        lightest = sizes.index(min(sizes))
        texts[lightest].append(function.text())
        sizes[lightest] += function.count + 1
    texts[-1].append(dispatch_table(modules))
    return [f"{head}\n" + "\n".join(text) + "\n}\n" for text in texts]


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("input", nargs="+", type=pathlib.Path)
    parser.add_argument("-o", required=True, type=pathlib.Path, dest="output", metavar="out.cxx")
    parser.add_argument("--namespace", default="ptx")
    parser.add_argument("--split", type=int, metavar="N", help="write out_0.cxx, ... instead")
    parser.add_argument("--verbose", action="store_true", help="instructions of each function")
    options = parser.parse_args()
    taken = {}
    modules = [Module(path, f"m{i}_", taken) for i, path in enumerate(options.input)]
    try:
        for module in modules:
            module.translate()
        texts = generate(modules, options.namespace, options.split or 1)
    except Refused as error:
        sys.exit(f"ptx_to_cxx.py: {error}")
    for i, text in enumerate(texts):
        path = options.output
        if options.split:
            path = path.with_name(f"{path.stem}_{i}{path.suffix}")
        path.write_text(text)
    if options.verbose:
        for module in modules:
            for _, _, function in module.bodies:
                print(f"{function.count:8d} {function.name}")


if __name__ == "__main__":
    main()
