# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The words of PTX: types, instructions with their modifiers and numbers of operands, declarations and
immediates. What is not here has no translation."""

import functools
import re
from collections import namedtuple

# PTX type -> C++ type; the names of the latter are in capitals because %f32 is a register.
CXX = {k + n: ("S" if k == "s" else "U") + n for k in "bus" for n in ("8", "16", "32", "64")}
CXX.update(f32="F32", f64="F64", pred="bool")
BITS = {t: 1 if t == "pred" else int(t[1:]) for t in CXX}

COMPARISONS = {"eq": "==", "ne": "!=", "lt": "<", "le": "<=", "gt": ">", "ge": ">="}
FLOAT_COMPARISONS = {  # with a NaN: false, and if their names end with u true
    "eq": "{0} == {1}", "lt": "{0} < {1}", "le": "{0} <= {1}", "gt": "{0} > {1}", "ge": "{0} >= {1}",
    "neu": "{0} != {1}", "ltu": "!({0} >= {1})", "leu": "!({0} > {1})", "gtu": "!({0} <= {1})",
    "geu": "!({0} < {1})"}
SPECIAL = {"%tid.x": "launch.threadIndex", "%ntid.x": "launch.threadCount",
           "%ctaid.x": "launch.blockIndex", "%nctaid.x": "launch.blockCount"}

# What is one expression: instruction -> (modifiers, types of the operands, for integers, for
# floats). "t" is the instruction's type, {T} that in C++, {U} the unsigned one.
EXPRESSIONS = {
    "sqrt": ("rn", "t", None, "std::sqrt({0})"),
    "min": ("", "t t", "{0} < {1} ? {0} : {1}", "leastFloat({0}, {1})"),
    "max": ("", "t t", "{0} > {1} ? {0} : {1}", "greatestFloat({0}, {1})"),
    "neg": ("", "t", "{U}(0 - {U}({0}))", "-{0}"),
    "abs": ("", "t", "{0} < 0 ? {U}(0 - {U}({0})) : {U}({0})", "std::fabs({0})"),
    "and": ("", "t t", "{0} & {1}", None), "or": ("", "t t", "{0} | {1}", None),
    "xor": ("", "t t", "{0} ^ {1}", None), "not": ("", "t", "complement({0})", None),
    "shl": ("", "t u32", "shiftLeft<{T}>({0}, {1})", None),
    "shr": ("", "t u32", "shiftRight<{T}>({0}, {1})", None),
    "bfi": ("", "t t u32 u32", "bfi<{T}>({0}, {1}, {2}, {3})", None),
    "selp": ("", "t t pred", "{2} ? {0} : {1}", "{2} ? {0} : {1}"),
}
# What rounds: without .rn the assembler may contract a product and a sum, or does round otherwise.
ROUNDING = ("add", "sub", "mul", "sqrt")

SPACES = "global local param "
# Instruction -> (the method that translates it, what may qualify it, number of operands). Whatever
# is not here is refused, as nvcc has not made it of the kernels so far; also fma, which no kernel asks for.
RULES = {
    "mov": ("move", "", 2), "cvta": ("move", "to " + SPACES, 2),
    "ld": ("load", "volatile v2 v4 " + SPACES, 2),
    "st": ("store", "volatile v2 v4 " + SPACES, 2),
    "add": ("add", "rn cc", 3), "addc": ("add", "cc", 3),
    "sub": ("add", "rn cc", 3), "subc": ("add", "cc", 3),
    "mul": ("multiply", "rn lo hi wide", 3), "mad": ("multiply", "lo", 4),
    "shf": ("funnel", "l r wrap clamp", 4), "clz": ("count_zeros", "", 2),
    "setp": ("compare", " ".join([*COMPARISONS, *FLOAT_COMPARISONS]), 3),
    "cvt": ("convert", "rn rzi", 2), "atom": ("atomic", "global add exch min max or", 3),
    "bra": ("branch", "uni", 1), "call": ("call", "uni", None), "ret": ("leave", "uni", 0),
    "bar": ("barrier", "sync", 1),
}
RULES.update((name, ("express", rule[0], len(rule[1].split()) + 1))
             for name, rule in EXPRESSIONS.items())


class Refused(Exception):
    """What has no exact translation here."""


Opcode = namedtuple("Opcode", "base flags types rule")
Register = namedtuple("Register", "name type")
Variable = namedtuple("Variable", "name type align count range")


@functools.lru_cache(maxsize=None)
def parse_opcode(text):
    base, *rest = text.split(".")
    if base not in RULES:
        raise Refused("unknown instruction")
    types = [word for word in rest if word in CXX]
    flags = [word for word in rest if word not in CXX]
    method, allowed, count = RULES[base]
    for flag in flags:
        if flag not in allowed.split():
            raise Refused(f"unknown modifier .{flag}")
    return Opcode(base, flags, types, (method, count))


def identifier(name):
    return re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")


def split_operands(text):
    """At the commas outside of brackets."""
    if not re.search(r"[{(]", text):
        return [word.strip() for word in text.split(",")] if text else []
    words, depth = [""], 0
    for char in text:
        depth += (char in "{([") - (char in "})]")
        if char == "," and depth == 0:
            words.append("")
        else:
            words[-1] += char
    return [word.strip() for word in words]


def parse_declaration(text):
    """The variables of '.space .align 8 .b8 name[48], ...'; a range's name is its prefix."""
    match = re.match(r"\s*((?:\.(?:align\s+\d+|\w+)\s*)*)(.*)", text, re.S)
    words, result = match[1].split(), []
    if match[1].count(".") > 2 + words.count(".align") + 2 * words.count(".ptr"):
        raise Refused("unknown attribute of a variable")
    types = [word[1:] for word in words if word[1:] in CXX]
    align = re.search(r"\.align\s+(\d+)", match[1])
    for name in match[2].split(","):
        parts = re.fullmatch(r"\s*([%$\w]+)\s*(<\d+>)?\s*((?:\[\d+\]\s*)*)", name)
        if not parts or len(types) != 1:
            raise Refused("unknown declaration")
        count = functools.reduce(lambda n, m: n * int(m), re.findall(r"\d+", parts[3]), 1)
        result.append(Variable(parts[1], types[0], int(align[1]) if align else BITS[types[0]] // 8,
                               count, bool(parts[2])))
    return result


def literal(text, type_name):
    """A C++ expression for an immediate operand, or None."""
    bits, is_float = BITS[type_name], type_name[0] == "f"
    match = re.fullmatch(r"0([fdFD])([0-9a-fA-F]{8}|[0-9a-fA-F]{16})", text)
    if match:
        if bits != 4 * len(match[2]) or (match[1] in "dD") != (bits == 64):
            raise Refused("an immediate of another size")
        digits = f"0x{match[2]}{'u' if bits == 32 else 'ull'}"
        return f"floatOf({CXX['b' + str(bits)]}({digits}))" if is_float else digits
    match = re.fullmatch(r"(-?)(0[xX][0-9a-fA-F]+|0[bB][01]+|\d+)U?", text)
    if not match:
        return None
    if is_float or (len(match[2]) > 1 and match[2].isdigit() and match[2][0] == "0"):
        raise Refused("unknown kind of immediate")
    value = int(match[1] + match[2], 0)
    if type_name == "pred":
        return "true" if value else "false"
    return f"{CXX[type_name]}({value & ((1 << bits) - 1):#x}{'ull' if bits == 64 else 'u'})"
