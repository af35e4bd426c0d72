#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Does ptx_to_cxx.py translate as it says? One source is compiled for the host, and through nvcc
and the translator; what both compute must have the same bits. Skipped where there is no nvcc."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

TRANSLATOR = pathlib.Path(__file__).with_name("ptx_to_cxx.py")

CASES = "translated_numbers.h", "translated_cases.cu"

MAIN = r"""
#include "translated_cases.cu"
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace ptx
{
struct Launch { unsigned blockIndex, blockCount, threadIndex, threadCount; void (*wait)(); };
using Kernel = void (*)(const void* const* parameters, const Launch& launch);
Kernel find(const char* demangledName);
const char* const* names();
}

int main()
{
  const double special[] = { 0., -0., 1, -1, 0.5, 1.5, -2.5, 3, NAN, INFINITY, -INFINITY, 5e-324,
    -1e-310, 1e308, -1.7e308, 2147483647., 2147483648.5, -2147483648., -2147483649., 4294967295.,
    4294967296., 9223372036854775807., -9223372036854775808., 18446744073709551615., 1e-40, 3e38 };
  const S64 whole[] = { 0, 1, -1, 2, 3, 31, 32, 33, 63, 64, 127, 255, INT32_MAX, INT32_MIN,
    INT64_MAX, INT64_MIN, 0x80000000, 0xffffffff, 0x100000000 };
  std::mt19937_64 random(1);
  const int n = 4000;
  std::vector<Input> in(n);
  for (Input& x : in)
  {
    for (int k = 0; k < 4; ++k)
    {
      const U64 a = random(), b = random();
      const int range = a & 2 ? 1100 : 80;
      x.d[k] = a & 1 ? special[b % 26] : std::ldexp(double(S64(b)), int(a >> 8) % range);
      x.f[k] = a & 4 ? special[a / 8 % 26] : std::ldexp(double(S64(a)), int(b >> 8) % 80 - 63);
      x.l[k] = a & 8 ? whole[a / 64 % 19] : S64(random()) >> (a / 64 % 64);
      x.i[k] = int(a & 16 ? whole[b / 64 % 19] : S64(random()) >> (a / 64 % 64));
    }
  }
  int failures = 0;
  const auto check = [&](const char* name, void (*host)(const Settings&, const Input&, Sink))
  {
    std::vector<S64> counters[2] = { std::vector<S64>(32, 0), std::vector<S64>(32, 0) };
    std::vector<U64> out[2];
    Settings settings = { {}, nullptr, { 1, -2, 3, -4, 5 }, 'x' };
    for (int k = 0; k < 20; ++k) { settings.scale[k] = k * 0.75 - 2; }
    const std::string full =
      std::string(name) + "Kernel(Settings, Input const*, unsigned long long*, int)";
    const ptx::Kernel kernel = ptx::find(full.c_str());
    for (int side = 0; side < 2; ++side)
    {
      out[side].resize(n * Places);
      settings.counters = counters[side].data();
      const Input* const inputs = in.data();
      U64* const outputs = out[side].data();
      const void* const parameters[] = { &settings, &inputs, &outputs, &n };
      for (unsigned i = 0; i < n + 96u && (side == 0 || kernel); ++i)
      {
        if (side == 1) { kernel(parameters, { i / 128, (n + 127u) / 128, i % 128, 128 }); }
        else if (i < n) { host(settings, in[i], Sink{ outputs + Places * i }); }
      }
    }
    int wrong = counters[0] != counters[1];
    for (int i = 0; i < n * Places; ++i)
    {
      if (out[0][i] != out[1][i] && ++wrong < 6)
      {
        std::printf("  input %d, place %d: %llx %llx\n", i / Places, i % Places, out[0][i],
          out[1][i]);
      }
    }
    std::printf("%s: %s\n", name, kernel ? wrong ? "differs" : "same" : "missing");
    failures += wrong || !kernel;
  };
#define CHECK(name) check(#name, name);
  KERNELS(CHECK)
  int count = 0;
  while (ptx::names()[count]) { ++count; }
  std::printf("%d entries\n", count);
  return failures != 0 || ptx::find("no such kernel");
}
"""

REFUSED = """.version 7.0
.target sm_75
.address_size 64
.visible .entry kernel(.param .u64 kernel_param_0)
{
  .reg .f64 %fd<3>;
  .reg .pred %p<2>;
  .reg .b32 %r<3>;
  // line 9
  INSTRUCTION
  ret;
}
"""


def find_nvcc():
    candidates = [os.environ.get("NVCC"), shutil.which("nvcc"), "/usr/local/cuda/bin/nvcc"]
    return next((path for path in candidates if path and pathlib.Path(path).exists()), None)


def run(*command, **settings):
    return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True, **settings)


class TestRefusal(unittest.TestCase):
    """What cannot be translated exactly must stop the translation."""

    def translate(self, instruction):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder, "input.ptx")
            source.write_text(REFUSED.replace("INSTRUCTION", instruction))
            output = pathlib.Path(folder, "out.cxx")
            result = run(sys.executable, TRANSLATOR, source, "-o", output)
            return result.returncode, result.stdout, output.exists()

    def test_known(self):
        result = self.translate("add.rn.f64 %fd1, %fd1, 0d3FF0000000000000;")
        self.assertEqual(result, (0, "", True))

    def test_refused(self):
        for instruction in ("sin.approx.f32 %r1, %r2;", "add.rz.f64 %fd1, %fd1, %fd2;",
                            "add.f64 %fd1, %fd1, %fd2;", "rcp.approx.ftz.f64 %fd1, %fd2;",
                            "bar.sync 1;", "bar.arrive 0;", "mov.u32 %r1, %clock;", "ld.shared.u32 %r1, [%r2];",
                            "add.s32 %r1, %r2;", "mov.u32 %r1, %fd1;", "mov.u32 %r1, %r9x;",
                            "cvt.rz.f32.f64 %r1, %fd1;", "setp.lt.b32 %p1, %r1, %fd2;",
                            "call.uni nowhere;", ".shared .b8 memory[4];"):
            with self.subTest(instruction):
                code, message, is_written = self.translate(instruction)
                self.assertNotEqual(code, 0)
                self.assertIn(f"input.ptx:10: refused '{instruction[:-1]}", message)
                self.assertFalse(is_written)


@unittest.skipUnless(find_nvcc(), "no nvcc: set NVCC, or have it in PATH")
class TestTranslation(unittest.TestCase):
    """The same bits as the host's."""

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        for name in CASES:
            shutil.copy(TRANSLATOR.with_name(name), cls.folder)
        (cls.folder / "main.cxx").write_text(MAIN)
        cls.must("nvcc", find_nvcc(), "-ptx", "-fmad=false", "-std=c++17", "-O3",
                 "-arch=compute_75", "translated_cases.cu", "-o", "kernels.ptx")
        cls.must("main", *cls.compiler(), "-c", "main.cxx", "-o", "main.o")
        cls.must("translation", sys.executable, TRANSLATOR, "kernels.ptx", "-o", "kernels.cxx")

    @classmethod
    def compiler(cls):
        return os.environ.get("CXX", "g++"), "-std=c++17", "-O1", "-ffp-contract=off"

    @classmethod
    def must(cls, what, *command):
        result = run(*command, cwd=cls.folder)
        if result.returncode:
            raise AssertionError(f"{what} fails:\n{result.stdout}")

    def outcome(self, *sources):
        objects = [source + ".o" for source in sources]
        for source, result in zip(sources, objects):
            self.must("compilation", *self.compiler(), "-c", source, "-o", result)
        self.must("linking", *self.compiler(), "main.o", *objects, "-o", "program")
        return run("./program", cwd=self.folder)

    def test_same(self):
        result = self.outcome("kernels.cxx")
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("12 entries", result.stdout)

    def test_split(self):
        self.must("translation", sys.executable, TRANSLATOR, "kernels.ptx", "-o", "part.cxx",
                  "--split", "3")
        result = self.outcome("part_0.cxx", "part_1.cxx", "part_2.cxx")
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_wrong_translations_are_noticed(self):
        text = (self.folder / "kernels.cxx").read_text()
        begin = text.index("  (void)launch;")  # behind the preamble
        for kind, before, after in (
                ("a difference of floats", r"(\bfd\d+ = .*) - ", r"\1 + "),
                ("a bitwise operation", r"= U64\((rd\d+) \^ (rd\d+)\)", r"= U64(\1 | \2)"),
                ("an fma", r"\bfused\((fd\d+), (fd\d+), (fd\d+)\)", r"(\1 * \2 + \3)"),
                ("a shift", r"shiftRight<S32>", "shiftRight<U32>"),
                ("an atomic operation", r"atomicMin<U64", "atomicMax<U64")):
            with self.subTest(kind):
                changed, count = re.subn(before, after, text[begin:], 1)
                self.assertEqual(count, 1)
                (self.folder / "wrong.cxx").write_text(text[:begin] + changed)
                result = self.outcome("wrong.cxx")
                self.assertNotEqual(result.returncode, 0)
                self.assertIn(": differs", result.stdout)


if __name__ == "__main__":
    unittest.main()
