#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Translate PTX to C++, so that device code runs on the CPU, one thread after the other.

    ptx_to_cxx.py input.ptx... -o out.cxx [--namespace NAME] [--split N]

Every .entry and .func becomes a C++ function, every register a local variable, every branch a goto.
Generic addresses are the CPU's: memory of all spaces is memory, and parameters are passed by
address. A thread is a warp of its own, of which lane 0 alone is active. What has no exact
translation (approximations, roundings but to nearest, shared memory, barriers), and what is not
known here, is refused by name and line; nothing is guessed. NaNs are NaNs, but their bits are the
CPU's. The head and the end of the result are ptx_preamble.cxx.in and ptx_interface.cxx.in; it must be
compiled with -ffp-contract=off.
"""

import argparse
import functools
import pathlib
import re
import sys
from collections import namedtuple

# PTX type -> C++ type; the names of the latter are in capitals because %f32 is a register.
CXX = {k + n: ("S" if k == "s" else "U") + n for k in "bus" for n in ("8", "16", "32", "64")}
CXX.update(f32="F32", f64="F64", pred="bool")
BITS = {t: 1 if t == "pred" else int(t[1:]) for t in CXX}

COMPARISONS = {"eq": "==", "ne": "!=", "lt": "<", "le": "<=", "gt": ">", "ge": ">=",
               "lo": "<", "ls": "<=", "hi": ">", "hs": ">="}  # the latter are unsigned
FLOAT_COMPARISONS = {  # with a NaN: false, and if their names end with u true
    "eq": "{0} == {1}", "ne": "differ({0}, {1})", "lt": "{0} < {1}", "le": "{0} <= {1}",
    "gt": "{0} > {1}", "ge": "{0} >= {1}", "equ": "!differ({0}, {1})", "neu": "{0} != {1}",
    "ltu": "!({0} >= {1})", "leu": "!({0} > {1})", "gtu": "!({0} <= {1})", "geu": "!({0} < {1})",
    "num": "({0} == {0} && {1} == {1})", "nan": "({0} != {0} || {1} != {1})"}
LOGIC = {"and": "&", "or": "|", "xor": "^"}
ROUND_TO_INTEGER = {"rni": "nearbyint", "rzi": "trunc", "rmi": "floor", "rpi": "ceil"}
TESTS = {"finite": "std::isfinite({0})", "infinite": "std::isinf({0})", "number": "{0} == {0}",
         "notanumber": "{0} != {0}", "normal": "std::isnormal({0})",
         "subnormal": "std::fpclassify({0}) == FP_SUBNORMAL"}
SPECIAL = {"%tid.x": "launch.threadIndex", "%ntid.x": "launch.threadCount",
           "%ctaid.x": "launch.blockIndex", "%nctaid.x": "launch.blockCount",
           "%laneid": "0u", "%lanemask_eq": "1u", "%lanemask_le": "1u", "%lanemask_lt": "0u",
           "%lanemask_ge": "0xffffffffu", "%lanemask_gt": "0xfffffffeu", "WARP_SZ": "32u"}
SPECIAL.update((f"%{r}.{axis}", "1u" if r.startswith("n") else "0u")
               for r in ("tid", "ntid", "ctaid", "nctaid") for axis in "yz")

# What is one expression: instruction -> (modifiers, types of the operands, for integers, for
# floats). "t" is the instruction's type, {T} that in C++, {U} the unsigned one.
EXPRESSIONS = {
    "div": ("rn", "t t", "quotient<{T}>({0}, {1})", "{0} / {1}"),
    "rem": ("", "t t", "remainderOf<{T}>({0}, {1})", None),
    "fma": ("rn", "t t t", None, "fused({0}, {1}, {2})"),
    "rcp": ("rn", "t", None, "1 / {0}"), "sqrt": ("rn", "t", None, "std::sqrt({0})"),
    "min": ("", "t t", "{0} < {1} ? {0} : {1}", "leastFloat({0}, {1})"),
    "max": ("", "t t", "{0} > {1} ? {0} : {1}", "greatestFloat({0}, {1})"),
    "neg": ("", "t", "{U}(0 - {U}({0}))", "-{0}"),
    "abs": ("", "t", "{0} < 0 ? {U}(0 - {U}({0})) : {U}({0})", "std::fabs({0})"),
    "copysign": ("", "t t", None, "std::copysign({1}, {0})"),
    "and": ("", "t t", "{0} & {1}", None), "or": ("", "t t", "{0} | {1}", None),
    "xor": ("", "t t", "{0} ^ {1}", None), "not": ("", "t", "complement({0})", None),
    "cnot": ("", "t", "{0} == 0", None), "lop3": ("", "t t t t", "lop3({0}, {1}, {2}, {3})", None),
    "shl": ("", "t u32", "shiftLeft<{T}>({0}, {1})", None),
    "shr": ("", "t u32", "shiftRight<{T}>({0}, {1})", None),
    "bfe": ("", "t u32 u32", "bfe<{T}>({0}, {1}, {2})", None),
    "bfi": ("", "t t u32 u32", "bfi<{T}>({0}, {1}, {2}, {3})", None),
    "prmt": ("", "t t t", "prmt({0}, {1}, {2})", None), "brev": ("", "t", "brev<{T}>({0})", None),
    "selp": ("", "t t pred", "{2} ? {0} : {1}", "{2} ? {0} : {1}"),
}
# What rounds: without .rn the assembler may contract a product and a sum, or does round otherwise.
ROUNDING = ("add", "sub", "mul", "fma", "div", "rcp", "sqrt")

SPACES = "global local const param param::entry param::func "
ATOMIC = "add and or xor min max inc dec "
SCOPES = "cta cluster gpu sys "
CACHING = "ca cg cs lu cv wb wt nc weak L1::no_allocate L2::64B L2::128B L2::256B "
# Instruction -> (the method that translates it, what may qualify it, number of operands). Whatever
# is not here is refused.
RULES = {
    "mov": ("move", "", 2), "cvta": ("move", "to " + SPACES, 2),
    "ld": ("load", "volatile relaxed acquire v2 v4 " + SPACES + SCOPES + CACHING, 2),
    "st": ("store", "volatile relaxed release v2 v4 " + SPACES + SCOPES + CACHING, 2),
    "add": ("add", "rn cc", 3), "addc": ("add", "cc", 3),
    "sub": ("add", "rn cc", 3), "subc": ("add", "cc", 3),
    "mul": ("multiply", "rn lo hi wide", 3),
    "mad": ("multiply", "lo hi wide cc", 4), "madc": ("multiply", "lo hi cc", 4),
    "shf": ("funnel", "l r wrap clamp", 4), "bfind": ("find_bit", "shiftamt", 2),
    "popc": ("count_bits", "", 2), "clz": ("count_bits", "", 2),
    "setp": ("compare", " ".join([*COMPARISONS, *FLOAT_COMPARISONS, *LOGIC]), None),
    "testp": ("test", " ".join(TESTS), 2), "slct": ("select_by_sign", "", 4),
    "cvt": ("convert", "rn sat " + " ".join(ROUND_TO_INTEGER), 2),
    "atom": ("atomic", "relaxed acquire release acq_rel exch cas " + ATOMIC + SPACES + SCOPES,
             None),
    "red": ("atomic", "relaxed release " + ATOMIC + SPACES + SCOPES, 2),
    "membar": ("fence", "cta gl sys", 0), "fence": ("fence", "sc acq_rel " + SCOPES, 0),
    "bra": ("branch", "uni", 1), "brx": ("branch_by_table", "idx uni", 2),
    "call": ("call", "uni", None), "ret": ("leave", "uni", 0), "trap": ("trap", "", 0),
    "bar": ("nothing", "warp sync", 1), "nanosleep": ("nothing", "", 1),
    "activemask": ("active_mask", "", 1), "vote": ("vote", "sync all any uni ballot", 3),
    "shfl": ("shuffle", "sync idx up down bfly", 5),
}
RULES.update((name, ("express", rule[0], len(rule[1].split()) + 1))
             for name, rule in EXPRESSIONS.items())

TEMPLATES = pathlib.Path(__file__).parent
PREAMBLE = (TEMPLATES / "ptx_preamble.cxx.in").read_text()

INTERFACE = "\n" + (TEMPLATES / "ptx_interface.cxx.in").read_text()


class Refused(Exception):
    """What has no exact translation here."""


Opcode = namedtuple("Opcode", "base flags types rule")
Register = namedtuple("Register", "name type")
Variable = namedtuple("Variable", "name type align count range value")


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
    text, _, value = text.partition("=")
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
                               count, bool(parts[2]), value.strip()))
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


class Function:
    """One .entry or .func: its statements become lines of C++."""

    def __init__(self, module, name, is_entry, results, parameters):
        self.module, self.name, self.is_entry = module, name, is_entry
        self.addresses = [{}]  # by scope: names of .param and .local variables
        self.registers = [{}]
        self.ranges = [{}]
        self.used = {}  # C++ type -> names of registers
        self.arrays = []
        self.labels = {}
        self.tables = {}
        self.lines = []
        self.count = 0  # of instructions
        self.scopes = 0  # so far
        self.scope = [0]  # the open ones
        for kind, variables in (("result", results), ("parameter", parameters)):
            for i, variable in enumerate(variables):
                self.addresses[0][variable.name] = f"{kind}{i}"
        self.counts = len(results), len(parameters)

    # What the operands are.

    def find_register(self, name):
        for level in range(len(self.registers) - 1, -1, -1):
            if name in self.registers[level]:
                return self.registers[level][name]
            match = re.fullmatch(r"(.*?\D)(\d+)", name)
            if match and match[1] in self.ranges[level]:
                prefix, type_name = self.ranges[level][match[1]]
                register = Register(prefix + match[2], type_name)
                self.registers[level][name] = register
                self.used.setdefault(CXX[type_name], []).append(register.name)
                return register
        return None

    def find_address(self, name):
        for scope in reversed(self.addresses):
            if name in scope:
                return scope[name]
        return self.module.addresses.get(name)

    def read(self, operand, type_name, may_be_wider=False):
        """A C++ expression of the type's value."""
        if type_name == "pred" and operand.startswith("!"):
            return "!" + self.read(operand[1:], "pred")
        special = operand in SPECIAL
        register = Register(SPECIAL[operand], "u32") if special else self.find_register(operand)
        if register:
            name, held = register
            bits = BITS[type_name]
            if (held == "pred") != (type_name == "pred") or BITS[held] < bits or (
                    BITS[held] > bits and not may_be_wider):
                raise Refused(f"{operand} is of another size")
            if held[0] == "f":
                if BITS[held] != bits:
                    raise Refused(f"{operand} is of another size")
                return name if type_name[0] == "f" else f"{CXX[type_name]}(bitsOf({name}))"
            if type_name[0] == "f":
                return f"floatOf({CXX['b' + str(bits)]}({name}))"
            return name if CXX[type_name] == CXX[held] else f"{CXX[type_name]}({name})"
        value = literal(operand, type_name)
        if value is not None:
            return value
        match = re.fullmatch(r"([%$\w]+)\s*(?:\+\s*(\d+))?", operand)
        address = match and self.find_address(match[1])
        if not address or BITS[type_name] != 64 or type_name[0] == "f":
            raise Refused(f"unknown operand {operand}")
        return f"{CXX[type_name]}({address})" + (f" + {match[2]}" if match[2] else "")

    def write(self, operand, type_name, value, may_be_wider=False):
        """A C++ statement that assigns a value of the type."""
        if operand == "_":
            return f"(void)({value});"
        register = self.find_register(operand)
        if not register:
            raise Refused(f"unknown destination {operand}")
        name, held = register
        bits = BITS[type_name]
        if (held == "pred") != (type_name == "pred") or BITS[held] < bits or (
                BITS[held] > bits and (not may_be_wider or "f" in (held[0], type_name[0]))):
            raise Refused(f"{operand} is of another size")
        if held[0] == "f" and type_name[0] != "f":
            return f"{name} = floatOf({CXX['b' + str(bits)]}({value}));"
        if held[0] != "f" and type_name[0] == "f":
            return f"{name} = bitsOf({CXX[type_name]}({value}));"
        # Through the type: that extends the sign.
        through = "" if held[0] == "f" or held == "pred" else CXX[type_name]
        return f"{name} = {through}({value});"

    def address(self, operand):
        match = re.fullmatch(r"\[\s*([%$\w]+)\s*(?:\+\s*(-?\d+))?\s*\]", operand)
        if not match:
            raise Refused(f"unknown address {operand}")
        register = self.find_register(match[1])
        if register and BITS[register.type] != 64:
            raise Refused(f"{operand} is not of 64 bits")
        base = register.name if register else self.find_address(match[1])
        if not base:
            raise Refused(f"unknown address {operand}")
        return f"(U64({base}) + ({match[2] or 0}))"

    # Statements.

    def translate(self, text):
        """All of one statement but for its semicolon."""
        if text[0] == ".":
            self.declare(text)
            return
        match = re.fullmatch(r"(?:@(!?)([%$\w]+)\s+)?([a-z][\w.:]*)\s*(.*)", text, re.S)
        if not match:
            raise Refused("unknown statement")
        opcode, operands = parse_opcode(match[3]), split_operands(match[4])
        method, count = opcode.rule
        if count is not None and len(operands) != count:
            raise Refused(f"{len(operands)} operands")
        kind = (opcode.types or ["b32"])[0]
        if opcode.base in ROUNDING and (kind[0] == "f") != ("rn" in opcode.flags):
            raise Refused("not rounded to nearest (is -fmad=false missing?)")
        line = getattr(self, method)(opcode, operands)
        if match[2]:
            line = f"if ({match[1]}{self.read(match[2], 'pred')}) {{ {line} }}"
        self.lines.append("  " + line)
        self.count += 1

    def declare(self, text):
        if re.match(r"\.pragma\b", text):
            return
        variables = parse_declaration(text)
        space = text.split()[0]
        scope = f"_{self.scope[-1]}" if self.scope[-1] else ""
        for variable in variables:
            name = identifier(variable.name) + (scope or "_0")
            if space == ".reg" and variable.range:
                prefix = identifier(variable.name) + (scope and scope + "_")
                self.ranges[-1][variable.name] = (prefix, variable.type)
            elif space == ".reg":
                self.registers[-1][variable.name] = Register(name, variable.type)
                self.used.setdefault(CXX[variable.type], []).append(name)
            elif space in (".param", ".local"):
                size = max(8, variable.count * BITS[variable.type] // 8)
                self.addresses[-1][variable.name] = name
                self.arrays.append(f"alignas({max(8, variable.align)}) Byte {name}[{size}];")
            else:
                raise Refused("unknown declaration")

    def open_scope(self):
        self.scopes += 1
        self.scope.append(self.scopes)
        for stack in (self.addresses, self.registers, self.ranges):
            stack.append({})

    def close_scope(self):
        for stack in (self.scope, self.addresses, self.registers, self.ranges):
            stack.pop()

    def label(self, name):
        """Of the function: a second one of another scope fails to compile."""
        result = "L_" + identifier(name)
        if self.labels.setdefault(result, name) != name:
            raise Refused(f"two labels {result}")
        return result

    # Moving.

    def move(self, op, a):
        kind = op.types[0]
        for i in (0, 1):
            if a[i].startswith("{"):
                parts = split_operands(a[i][1:-1])
                bits = BITS[kind] // len(parts)
                part, cxx = f"b{bits}", CXX[kind]
                if i == 1:
                    values = [f"({cxx}({self.read(p, part)}) << {j * bits})"
                              for j, p in enumerate(parts)]
                    return self.write(a[0], kind, " | ".join(values))
                lines = [self.write(p, part, f"{CXX[part]}(whole >> {j * bits})")
                         for j, p in enumerate(parts)]
                return f"{{ const {cxx} whole = {self.read(a[1], kind)}; {' '.join(lines)} }}"
        return self.write(a[0], kind, self.read(a[1], kind))

    @staticmethod
    def order(op):
        strong = {"acquire": "ACQUIRE", "release": "RELEASE", "acq_rel": "ACQ_REL"}
        return "__ATOMIC_" + next((strong[f] for f in op.flags if f in strong), "RELAXED")

    def elements(self, op, operand):
        """The registers of a vector and their type."""
        kind = op.types[0]
        is_vector = "v2" in op.flags or "v4" in op.flags
        parts = split_operands(operand[1:-1]) if is_vector else [operand]
        if is_vector and len(parts) != (2 if "v2" in op.flags else 4):
            raise Refused("a vector of another length")
        is_atomic = {"volatile", "relaxed", "acquire", "release"} & set(op.flags)
        if is_atomic and kind[0] == "f":
            kind = "b" + kind[1:]
        return parts, kind, is_atomic

    def load(self, op, a):
        parts, kind, is_atomic = self.elements(op, a[0])
        lines = []
        for i, part in enumerate(parts):
            place = f"(M{CXX[kind]}*)(from + {i * BITS[kind] // 8})"
            value = f"__atomic_load_n({place}, {self.order(op)})" if is_atomic else f"*{place}"
            lines.append(self.write(part, kind, value, True))
        return f"{{ const U64 from = {self.address(a[1])}; {' '.join(lines)} }}"

    def store(self, op, a):
        parts, kind, is_atomic = self.elements(op, a[1])
        lines = []
        for i, part in enumerate(parts):
            place = f"(M{CXX[kind]}*)(to + {i * BITS[kind] // 8})"
            value = self.read(part, kind, True)
            lines.append(f"__atomic_store_n({place}, {value}, {self.order(op)});" if is_atomic
                         else f"*{place} = {value};")
        return f"{{ const U64 to = {self.address(a[0])}; {' '.join(lines)} }}"

    # Arithmetic.

    def express(self, op, a):
        kind = op.types[0]
        _, types, *templates = EXPRESSIONS[op.base]
        template = templates[kind[0] == "f"]
        if len(op.types) != 1 or template is None:
            raise Refused("unknown type")
        x = [self.read(word, kind if t == "t" else t) for word, t in zip(a[1:], types.split())]
        unsigned = CXX["b" + kind[1:]] if kind != "pred" else "bool"
        return self.write(a[0], kind, template.format(*x, T=CXX[kind], U=unsigned))

    def add(self, op, a):
        kind, is_add = op.types[0], op.base.startswith("add")
        sign = "+" if is_add else "-"
        if kind[0] == "f":
            return self.write(a[0], kind, f"{self.read(a[1], kind)} {sign} {self.read(a[2], kind)}")
        kind, cxx = "u" + kind[1:], "U" + kind[1:]  # signed integers must not overflow
        x, y = self.read(a[1], kind), self.read(a[2], kind)
        carry = "carry" if op.base.endswith("c") else "false"
        if "cc" in op.flags:
            call = "addCarry" if is_add else "subtractBorrow"
            return self.write(a[0], kind, f"{call}<{cxx}>({x}, {y}, {carry}, carry)")
        extra = f" {sign} {carry}" if carry == "carry" else ""
        return self.write(a[0], kind, f"{x} {sign} {y}{extra}")

    def multiply(self, op, a):
        kind = op.types[0]
        if kind[0] == "f":
            if op.base != "mul":
                raise Refused("not an fma")
            return self.write(a[0], kind, f"{self.read(a[1], kind)} * {self.read(a[2], kind)}")
        part = next((f for f in op.flags if f in ("lo", "hi", "wide")), None)
        bits, sign = BITS[kind], "S" if kind[0] == "s" else "U"
        if part is None or (part == "wide" and bits == 64):
            raise Refused("unknown product")
        double = f"{sign}{2 * bits}"
        x, y = self.read(a[1], kind), self.read(a[2], kind)
        if part == "lo":
            factor = f"U{max(bits, 32)}"  # a product of unsigned shorts is signed
            value = f"U{bits}({factor}({x}) * {factor}({y}))"
        else:
            value = f"({double}({x}) * {double}({y}))"
            value = f"U{bits}({value} >> {bits})" if part == "hi" else f"U{2 * bits}{value}"
        kind = f"u{2 * bits if part == 'wide' else bits}"
        if op.base == "mul":
            return self.write(a[0], kind, value)
        carry = "carry" if op.base == "madc" else "false"
        c = self.read(a[3], kind)
        if "cc" in op.flags:
            return self.write(a[0], kind, f"addCarry<{CXX[kind]}>({value}, {c}, {carry}, carry)")
        return self.write(a[0], kind, f"{value} + {c} + {carry}")

    # Bits.

    def count_bits(self, op, a):
        call = "leadingZeros" if op.base == "clz" else "__builtin_popcountll"
        return self.write(a[0], "u32", f"{call}({self.read(a[1], op.types[0])})")

    def funnel(self, op, a):
        direction, mode = op.flags
        low, high, n = (self.read(x, "u32") for x in a[1:])
        n = f"{n} & 31" if mode == "wrap" else f"atMost32({n})"
        call = "funnelLeft" if direction == "l" else "funnelRight"
        return self.write(a[0], "u32", f"{call}({low}, {high}, {n})")

    def find_bit(self, op, a):
        x, above = self.read(a[1], op.types[0]), "true" if op.flags else "false"
        return self.write(a[0], "u32", f"findBit<{CXX[op.types[0]]}>({x}, {above})")

    # Choosing.

    def select_by_sign(self, op, a):
        kind, by = op.types
        x, y, sign = self.read(a[1], kind), self.read(a[2], kind), self.read(a[3], by)
        return self.write(a[0], kind, f"{sign} >= 0 ? {x} : {y}")

    def compare(self, op, a):
        kind = op.types[0]
        x, y = self.read(a[1], kind), self.read(a[2], kind)
        name, results = op.flags[0], a[0].split("|")
        value = FLOAT_COMPARISONS[name].format(x, y) if kind[0] == "f" else (
            f"{x} {COMPARISONS[name]} {y}")
        if (len(op.flags) != len(a) - 2 or (len(op.flags) == 2 and op.flags[1] not in LOGIC)
                or (name in ("lo", "ls", "hi", "hs") and kind[0] == "s")):
            raise Refused("unknown comparison")
        values = ["is", "!is"]
        also = ""
        if len(a) == 4:
            also = f", also = {self.read(a[3], 'pred')}"
            values = [f"{v} {LOGIC[op.flags[1]]} also" for v in values]
        lines = [self.write(r.strip(), "pred", v) for r, v in zip(results, values)]
        return f"{{ const bool is = {value}{also}; {' '.join(lines)} }}"

    def test(self, op, a):
        return self.write(a[0], "pred", TESTS[op.flags[0]].format(self.read(a[1], op.types[0])))

    def convert(self, op, a):
        to, kind = op.types
        rounding = [flag for flag in op.flags if flag != "sat"]
        x = self.read(a[1], kind, True)
        if rounding and rounding[0] in ROUND_TO_INTEGER and kind[0] == "f":
            x = f"std::{ROUND_TO_INTEGER[rounding[0]]}({x})"
            if to[0] != "f":  # saturates anyhow
                return self.write(a[0], to, f"integerOf<{CXX[to]}>({x})", True)
            is_exact = to == kind
        elif to[0] != "f" and kind[0] != "f":
            is_exact = not rounding
            if "sat" in op.flags:
                return self.write(a[0], to, f"saturate<{CXX[to]}>({x})", True)
        else:
            exact = to == kind or (to == "f64" and kind != "f64" and BITS[kind] <= 32)
            is_exact = to[0] == "f" and (rounding == ["rn"] or (exact and not rounding))
        if not is_exact or "sat" in op.flags:
            raise Refused("unknown conversion")
        return self.write(a[0], to, f"{CXX[to]}({x})", True)

    # Threads together.

    def atomic(self, op, a):
        kind = "b" + op.types[0][1:] if op.types[0][0] == "f" else op.types[0]
        what = next((f for f in op.flags if f in ("exch", "cas", "inc", "dec", "min", "max", "add",
                                                  "and", "or", "xor")), None)
        results, values = (a[:1], a[2:]) if op.base == "atom" else (["_"], a[1:])
        if len(values) != (2 if what == "cas" else 1) or what is None or kind[0] == "p":
            raise Refused("unknown atomic operation")
        place, x = self.address(a[-1 - len(values)]), ", ".join(self.read(v, kind) for v in values)
        builtin = {"exch": "exchange_n", "add": "fetch_add", "and": "fetch_and", "or": "fetch_or",
                   "xor": "fetch_xor"}.get(what)
        if op.types[0][0] == "f":
            if what not in ("add", "exch"):
                raise Refused("unknown atomic operation")
            builtin, what = (None, "add bits") if what == "add" else (builtin, what)
        if builtin:
            value = f"__atomic_{builtin}((M{CXX[kind]}*){place}, {x}, {self.order(op)})"
        else:
            call = "atomic" + what.title().replace(" ", "")
            value = f"{call}<{CXX[kind]}, {self.order(op)}>({place}, {x})"
        return self.write(results[0], kind, value)

    def fence(self, op, a):
        return "__atomic_thread_fence(__ATOMIC_SEQ_CST);"

    def nothing(self, op, a):
        if op.base == "bar" and op.flags != ["warp", "sync"]:
            raise Refused("a barrier")
        return ";"

    def active_mask(self, op, a):
        return self.write(a[0], "u32", "1u")

    def vote(self, op, a):
        if len(op.flags) != 2:
            raise Refused("unknown vote")
        value = "true" if op.flags[1] == "uni" else self.read(a[1], "pred")
        return self.write(a[0], op.types[0], value)

    def shuffle(self, op, a):
        # Upwards nothing is below lane 0: it keeps its own.
        value, lane = self.read(a[1], "b32"), self.read(a[2], "u32")
        result, _, inside = a[0].partition("|")
        kept = value if "up" in op.flags else f"onlyLane({value}, {lane})"
        lines = [f"const bool inside = {lane} == 0;", self.write(result.strip(), "b32", kept)]
        lines += [self.write(inside.strip(), "pred", "inside")] if inside else []
        return f"{{ {' '.join(lines)} }}"

    # Elsewhere.

    def branch(self, op, a):
        return f"goto {self.label(a[0])};"

    def branch_by_table(self, op, a):
        targets = self.tables.get(a[1])
        if targets is None:
            raise Refused(f"no table {a[1]}")
        cases = [f"case {i}: goto {self.label(t)};" for i, t in enumerate(targets)]
        return f"switch ({self.read(a[0], 'u32')}) {{ {' '.join(cases)} default: std::abort(); }}"

    def call(self, op, a):
        results = split_operands(a.pop(0)[1:-1].strip()) if a[0].startswith("(") else []
        target = a.pop(0)
        values = split_operands(a.pop(0)[1:-1].strip()) if a and a[0].startswith("(") else []
        passed = [self.find_address(name) for name in results + values]
        if not all(passed):
            raise Refused("arguments that are not .param variables")
        register = self.find_register(target)
        if register:
            types = "".join(", Byte*" for _ in passed)
            callee = f"((void (*)(const Launch&{types})){register.name})"
        else:
            callee = self.module.functions.get(target)
            if not callee:
                raise Refused(f"a call of {target}, which is not defined here")
        return f"{callee}({', '.join(['launch', *passed])});"

    def leave(self, op, a):
        return "return;"

    def trap(self, op, a):
        return "std::abort();"

    # The result.

    def signature(self):
        if self.is_entry:
            return f"void {self.name}(const void* const* parameters, const Launch& launch)"
        names = [f"result{i}" for i in range(self.counts[0])]
        names += [f"parameter{i}" for i in range(self.counts[1])]
        return f"void {self.name}(const Launch& launch{''.join(', Byte* ' + n for n in names)})"

    def text(self):
        head = [self.signature(), "{", "  (void)launch;", "  bool carry = false;"]
        if self.is_entry:
            head += [f"  Byte* const parameter{i} = (Byte*)parameters[{i}];"
                     for i in range(self.counts[1])]
        for cxx, names in sorted(self.used.items()):
            # Zeros, as a compiler may leave what does not matter unassigned.
            head += [f"  {cxx} {', '.join(n + ' = 0' for n in names[i:i + 12])};"
                     for i in range(0, len(names), 12)]
        return "\n".join(head + ["  " + a for a in self.arrays] + self.lines + ["}", ""])


HEADER = re.compile(r"((?:\.(?:visible|weak|extern)\s+)*)\.(entry|func)\s+(?:\(([^)]*)\)\s*)?"
                    r"([$%\w]+)\s*(?:\(([^)]*)\))?[^{;]*([{;])")
VARIABLE = re.compile(r"(\.[^;{=]*(?:=[^;]*)?);")
SKIPPED = re.compile(r"\s+|\.(?:version|target)\b[^\n]*|\.address_size\s+64\b"
                     r"|\.section\s+[^{]*\{[^}]*\}")
STATEMENT = re.compile(r"\s*(?:([{}])|([$%\w]+)\s*:(?!:)|([^;{}]+(?:\{[^{}]*\}[^;{}]*)*);)")


class Module:
    """One file of PTX."""

    def __init__(self, path, prefix, taken):
        self.path, self.prefix, self.taken = path, prefix, taken
        self.addresses = {}  # of variables and functions, as C++ expressions
        self.functions = {}
        self.variables = []
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
            match = skipped or HEADER.match(self.text, position) or VARIABLE.match(
                self.text, position)
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
        """A function or a variable; where it ends."""
        if match.re is VARIABLE:
            text = re.sub(r"^\s*(\.(visible|weak)\s+)*", "", match[1])
            if not re.match(r"\.(global|const)\b", text):
                raise Refused("unknown declaration")
            variable, = parse_declaration(text)
            name = self.new_name(variable.name)
            self.addresses[variable.name] = name
            self.variables.append((variable, name))
            return match.end()
        linkage, kind, results, name, parameters, end = match.groups()
        if ".extern" in linkage:
            return match.end()
        new = self.new_name(name)
        self.addresses[name] = self.functions[name] = new
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
        for match in re.compile(r"([$%\w]+)\s*:\s*\.branchtargets([^;]*);").finditer(
                self.text, start, end):
            function.tables[match[1]] = split_operands(match[2].strip())
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
                    table = re.compile(r"\s*\.(branchtargets|callprototype)\b[^;]*;").match(
                        self.text, position)
                    position = table.end() if table else position
                    function.lines += [] if table else [f"{function.label(label)}:;"]
                else:
                    function.translate(statement.strip())
            except Refused as error:
                self.refuse(match.start(match.lastindex), statement or label, error)
            except (ValueError, IndexError, KeyError):
                self.refuse(match.start(match.lastindex), statement or label, "unknown operands")

    def definition(self, variable, name):
        """An initialised array."""
        elements = []
        text = variable.value
        for element in split_operands(text[1:-1] if text.startswith("{") else text):
            value = literal(element, variable.type)
            match = re.fullmatch(r"(?:generic\()?\s*([$%\w]+)\s*\)?\s*(?:\+\s*(\d+))?", element)
            if value is None and match and match[1] in self.addresses and (
                    CXX[variable.type] == "U64"):
                value = f"U64({self.addresses[match[1]]}) + {match[2] or 0}"
            if value is None:
                raise Refused(f"unknown initial value {element} of {variable.name}")
            elements.append(value)
        return f"{self.declaration(variable, name)} = {{ {', '.join(elements)} }};"

    @staticmethod
    def declaration(variable, name, linkage=""):
        return f"alignas({variable.align}) {linkage}{CXX[variable.type]} {name}[{variable.count}]"


def dispatch_table(modules):
    """Instances of one template may be in several modules, if they do the same."""
    seen, lines = {}, []
    for module in modules:
        for mangled, function in module.entries:
            text = "".join(function.lines).replace(module.prefix, "")
            if seen.setdefault(mangled, text) != text:
                raise Refused(f"{module.path}: a second and different {mangled}")
            if len(seen) > len(lines):
                lines.append(f'  {{ "{mangled}", {function.name} }},\n')
    return INTERFACE.replace("@ENTRIES@", "".join(lines))


def generate(modules, namespace, count):
    """The texts of so many files, the last one with the data and the table."""
    functions = [function for module in modules for _, _, function in module.bodies]
    head = PREAMBLE.replace("@NAMESPACE@", namespace)
    head += "\n".join(f"{function.signature()};" for function in functions) + "\n"
    tail = []
    for module in modules:
        for variable, name in module.variables:
            head += module.declaration(variable, name, "extern ") + ";\n"
            tail.append(module.definition(variable, name))
    texts, sizes = [[] for _ in range(count)], [0] * count
    for function in sorted(functions, key=lambda function: -function.count):
        lightest = sizes.index(min(sizes))
        texts[lightest].append(function.text())
        sizes[lightest] += function.count + 1
    texts[-1] += tail + [dispatch_table(modules)]
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
