# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A Markdown page's headings, links and code, as GitHub sees them."""

import re

FENCE = re.compile(r"\s*(```|~~~)")
HEADING = re.compile(r"(#{1,6})\s+(.*?)\s*#*\s*$")
LINK = re.compile(r"(?P<picture>!?)\[(?P<text>(?:[^\[\]]|\[[^\[\]]*\])*)\]\((?P<target>[^()\s]+)\)")
CODE = re.compile(r"(`+)((?:(?!\1).)*)\1")


def prose(text):
    """Each line with its number, from 1 on, and whether it is prose: not within a fence."""
    fence = None
    for number, line in enumerate(text.splitlines(), 1):
        mark = FENCE.match(line)
        if mark and fence in (None, mark[1]):
            fence = None if fence else mark[1]
            yield number, line, False
        else:
            yield number, line, fence is None


def anchor(title):
    """The name under which GitHub links to a heading, the first of its title."""
    title = LINK.sub(lambda link: link["text"], title)
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def headings(text):
    """(line number, level, title, anchor) of each heading."""
    seen = {}
    for number, line, is_prose in prose(text):
        heading = HEADING.match(line) if is_prose else None
        if heading:
            name = anchor(heading[2])
            count = seen.setdefault(name, 0)
            seen[name] += 1
            yield number, len(heading[1]), heading[2], f"{name}-{count}" if count else name


def replace_links(line, replacement):
    """The line with replacement(match of LINK) for each of its links outside code."""
    spans = [match.span() for match in CODE.finditer(line)]

    def outside(link):
        within = any(begin <= link.start() and link.end() <= end for begin, end in spans)
        return link[0] if within else replacement(link)

    return LINK.sub(outside, line)


def links(text):
    """(line number, match of LINK) of each link and picture."""
    for number, line, is_prose in prose(text):
        if is_prose:
            found = []
            replace_links(line, lambda link: found.append(link) or "")
            for link in found:
                yield number, link


def code(text):
    """(line number, what it says) of each span of code."""
    for number, line, is_prose in prose(text):
        if is_prose:
            for span in CODE.finditer(line):
                yield number, span[2]
