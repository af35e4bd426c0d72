# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""One function of PTX: its statements become lines of C++, its registers local variables."""

import re

from ptx_syntax import (
    BITS, COMPARISONS, CXX, EXPRESSIONS, FLOAT_COMPARISONS, identifier, literal, parse_declaration,
    parse_opcode, Refused, Register, ROUNDING, SPECIAL, split_operands,
)


class Function:
    """One .entry or .func: its statements become lines of C++."""

    def __init__(self, module, name, is_entry, results, parameters):
        self.module, self.name, self.is_entry = module, name, is_entry
        self.waits = False  # at a barrier
        self.addresses = [{}]  # by scope: names of .param and .local variables
        self.registers = [{}]
        self.ranges = [{}]
        self.used = {}  # C++ type -> names of registers
        self.arrays = []
        self.labels = {}
        self.lines = []
        self.count = 0  # of instructions
        self.scopes = 0  # so far
        self.scope = [0]  # the open ones
        for kind, variables in (("result", results), ("parameter", parameters)):
            for i, variable in enumerate(variables):
                self.addresses[0][variable.name] = f"{kind}{i}"
        self.counts = len(results), len(parameters)
        self.parameter_sizes = [v.count * BITS[v.type] // 8 for v in parameters]

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
        return self.module.functions.get(name)

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

    def elements(self, op, operand):
        """The registers of a vector and their type."""
        kind = op.types[0]
        is_vector = "v2" in op.flags or "v4" in op.flags
        parts = split_operands(operand[1:-1]) if is_vector else [operand]
        if is_vector and len(parts) != (2 if "v2" in op.flags else 4):
            raise Refused("a vector of another length")
        return parts, kind, "volatile" in op.flags

    def place(self, op, operand):
        """Where an instruction reads or writes; what is to be global memory can be checked there."""
        address = self.address(operand)
        return f"inGlobal({address})" if "global" in op.flags else address

    def load(self, op, a):
        parts, kind, is_atomic = self.elements(op, a[0])
        lines = []
        for i, part in enumerate(parts):
            place = f"(M{CXX[kind]}*)(from + {i * BITS[kind] // 8})"
            value = f"strongLoad({place})" if is_atomic else f"*{place}"
            lines.append(self.write(part, kind, value, True))
        return f"{{ const U64 from = {self.place(op, a[1])}; {' '.join(lines)} }}"

    def store(self, op, a):
        parts, kind, is_atomic = self.elements(op, a[1])
        lines = []
        for i, part in enumerate(parts):
            place = f"(M{CXX[kind]}*)(to + {i * BITS[kind] // 8})"
            value = self.read(part, kind, True)
            lines.append(f"__atomic_store_n({place}, {value}, __ATOMIC_RELAXED);" if is_atomic
                         else f"*{place} = {value};")
        return f"{{ const U64 to = {self.place(op, a[0])}; {' '.join(lines)} }}"

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
        return self.write(a[0], kind, value if op.base == "mul" else f"{value} + {self.read(a[3], kind)}")

    # Bits.

    def count_zeros(self, op, a):
        return self.write(a[0], "u32", f"leadingZeros({self.read(a[1], op.types[0])})")

    def funnel(self, op, a):
        direction, mode = op.flags
        low, high, n = (self.read(x, "u32") for x in a[1:])
        n = f"{n} & 31" if mode == "wrap" else f"atMost32({n})"
        call = "funnelLeft" if direction == "l" else "funnelRight"
        return self.write(a[0], "u32", f"{call}({low}, {high}, {n})")

    # Choosing.

    def compare(self, op, a):
        kind = op.types[0]
        x, y = self.read(a[1], kind), self.read(a[2], kind)
        form = FLOAT_COMPARISONS[op.flags[0]] if kind[0] == "f" else f"{{0}} {COMPARISONS[op.flags[0]]} {{1}}"
        return self.write(a[0], "pred", form.format(x, y))

    def convert(self, op, a):
        to, kind = op.types
        x = self.read(a[1], kind, True)
        if op.flags == ["rzi"] and kind[0] == "f" and to[0] != "f":
            return self.write(a[0], to, f"integerOf<{CXX[to]}>(std::trunc({x}))", True)
        integers = to[0] != "f" and kind[0] != "f"
        exact = integers or to == kind or (to == "f64" and BITS[kind] <= 32)
        if not (exact and not op.flags) and not (to[0] == "f" and op.flags == ["rn"]):
            raise Refused("unknown conversion")
        return self.write(a[0], to, f"{CXX[to]}({x})", True)

    # Threads together.

    def atomic(self, op, a):
        kind = op.types[0]
        what = next((f for f in op.flags if f != "global"), None)
        if what is None or kind[0] in "fp" or "global" not in op.flags:
            raise Refused("unknown atomic operation")
        value = f"atomic{what.title()}<{CXX[kind]}>({self.place(op, a[1])}, {self.read(a[2], kind)})"
        return self.write(a[0], kind, value)

    def barrier(self, op, a):
        if op.flags != ["sync"] or a != ["0"] or not self.is_entry:
            raise Refused("a barrier")
        self.waits = True
        return "if (!launch.wait) { std::abort(); } launch.wait();"

    # Elsewhere.

    def branch(self, op, a):
        return f"goto {self.label(a[0])};"

    def call(self, op, a):
        results = split_operands(a.pop(0)[1:-1].strip()) if a[0].startswith("(") else []
        target = a.pop(0)
        values = split_operands(a.pop(0)[1:-1].strip()) if a and a[0].startswith("(") else []
        passed = [self.find_address(name) for name in results + values]
        if not all(passed):
            raise Refused("arguments that are not .param variables")
        callee = self.module.functions.get(target)
        if not callee:
            raise Refused(f"a call of {target}, which is not defined here")
        return f"{callee}({', '.join(['launch', *passed])});"

    def leave(self, op, a):
        return "return;"

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
