#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""ptx_to_cxx.py where a wrong translation could hide a fault of the kernels: what C++ leaves open or would round
otherwise, and what must be refused. All else shows in the stand-in, whose rounds are compared with the host's."""

import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

TRANSLATOR = pathlib.Path(__file__).with_name("ptx_to_cxx.py")
NAN, ONE, TWO, TINY = "0d7FF8000000000000", "0d3FF0000000000000", "0d4000000000000000", "0d3C90000000000000"

# An instruction, the register that it writes, and what is in it then.
CASES = [
    (f"add.rn.f64 %fd1, {ONE}, {TINY};", "%fd1", 1.0),
    (f"min.f64 %fd1, {NAN}, {TWO};", "%fd1", 2.0),
    ("max.f64 %fd1, 0d8000000000000000, 0d0000000000000000;", "%fd1", 0.0),
    (f"setp.ltu.f64 %p1, {NAN}, {ONE}; selp.b32 %r1, 1, 0, %p1;", "%r1", 1),
    (f"setp.lt.f64 %p1, {NAN}, {ONE}; selp.b32 %r1, 1, 0, %p1;", "%r1", 0),
    (f"setp.neu.f64 %p1, {NAN}, {ONE}; selp.b32 %r1, 1, 0, %p1;", "%r1", 1),
    ("cvt.rzi.s32.f64 %r1, 0d41F0000000000000;", "%r1", 2**31 - 1),
    ("cvt.rn.f64.s32 %fd1, -3;", "%fd1", -3.0),
    ("cvt.s64.s32 %rd1, -2;", "%rd1", 2**64 - 2),
    ("shl.b32 %r1, 1, 32;", "%r1", 0),
    ("shr.s32 %r1, -8, 40;", "%r1", 2**32 - 1),
    ("shr.u64 %rd1, 8, 64;", "%rd1", 0),
    ("shf.l.wrap.b32 %r1, 0x80000001, 3, 33;", "%r1", 7),
    ("shf.r.clamp.b32 %r1, 1, 3, 40;", "%r1", 3),
    ("mul.hi.u64 %rd1, 0xFFFFFFFFFFFFFFFF, 3;", "%rd1", 2),
    ("mul.wide.s32 %rd1, -2, 3;", "%rd1", 2**64 - 6),
    ("mul.lo.s32 %r1, 0x10001, 0x10001;", "%r1", 0x20001),
    ("add.cc.u32 %r2, 0xFFFFFFFF, 2; addc.u32 %r1, 5, 0;", "%r1", 6),
    ("sub.cc.u32 %r2, 1, 2; subc.u32 %r1, 5, 0;", "%r1", 4),
    ("clz.b32 %r1, 0;", "%r1", 32),
    ("bfi.b64 %rd1, 0xFF, 0x12345678, 8, 4;", "%rd1", 0x12345F78),
    ("atom.global.min.u32 %r2, [%rd9], 4; ld.global.u32 %r1, [%rd9];", "%r1", 4),
    ("atom.global.max.u32 %r1, [%rd9], 9;", "%r1", 7),
    ("atom.global.exch.b32 %r1, [%rd9], 1; ld.global.u32 %r1, [%rd9];", "%r1", 1),
]
REFUSED = [
    "fma.rn.f64 %fd1, %fd1, %fd2, %fd1;",     "sin.approx.f32 %r1, %r2;", "add.rz.f64 %fd1, %fd1, %fd2;",
    "add.f64 %fd1, %fd1, %fd2;", "bar.sync 1;",
    "mov.u32 %r1, %clock;", "ld.shared.u32 %r1, [%r2];", "add.s32 %r1, %r2;", "mov.u32 %r1, %fd1;",
    "cvt.rz.f32.f64 %r1, %fd1;", "call.uni nowhere;", ".shared .b8 memory[4];",
]  # fmt: skip

PTX = """.version 7.0
.target sm_75
.address_size 64
.visible .entry kernel(.param .u64 kernel_param_0)
{
  .reg .f64 %fd<3>; .reg .pred %p<2>; .reg .b32 %r<3>; .reg .b64 %rd<10>;
  ld.param.u64 %rd8, [kernel_param_0]; add.s64 %rd9, %rd8, 8192;
INSTRUCTIONS
  ret;
}
"""
STORE = {"%fd1": "f64", "%r1": "u32", "%rd1": "u64"}
MAIN = r"""
#include "%s"
#include <cstdio>
int main()
{
  static unsigned long long memory[2048];
  const void* out = memory;
  const void* const parameters[] = { &out };
  ptx::entryOf("kernel")->kernel(parameters, { 0, 1, 0, 1 });
  for (int i = 0; i < %d; ++i) { std::printf("%%llx\n", memory[i]); }
}
"""


def run(*command, **settings):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, **settings)


class TestPtxToCxx(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def translate(self, instructions):
        (self.folder / "input.ptx").write_text(PTX.replace("INSTRUCTIONS", instructions))
        return run(sys.executable, "-B", TRANSLATOR, self.folder / "input.ptx", "-o", self.folder / "out.cxx")

    def test_values(self):
        lines = []
        for i, (instruction, register, _) in enumerate(CASES):
            lines += ["  st.global.u32 [%rd9], 7;", f"  {instruction.replace('; ', ';  ')}"]
            lines.append(f"  st.global.{STORE[register]} [%rd8+{8 * i}], {register};")
        done = self.translate("\n".join(lines))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        (self.folder / "main.cxx").write_text(MAIN % (self.folder / "out.cxx", len(CASES)))
        flags = ["-std=c++17", "-O1", "-w", "-ffp-contract=off", "-DPTX_GLOBAL_BEGIN=0", "-DPTX_GLOBAL_END=~0ull"]
        done = run(os.environ.get("CXX", "g++"), *flags, self.folder / "main.cxx", "-o", self.folder / "main",
                   "-pthread")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = run(self.folder / "main").stdout.split()
        self.assertEqual(len(found), len(CASES))
        for (instruction, _, wanted), bits in zip(CASES, found):
            if isinstance(wanted, float):
                wanted = struct.unpack("<Q", struct.pack("<d", wanted))[0]
            self.assertEqual(int(bits, 16), wanted, instruction)

    def test_refused(self):
        for instruction in REFUSED:
            with self.subTest(instruction):
                done = self.translate(instruction)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(f"input.ptx:8: refused '{instruction[:-1]}", done.stderr)
                self.assertFalse((self.folder / "out.cxx").exists())


if __name__ == "__main__":
    unittest.main()
