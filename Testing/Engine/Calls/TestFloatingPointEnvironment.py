# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every call has the bits that it has in the default floating-point environment, and leaves the caller's as it was.

A process for each environment and number of threads: so the first call comes in that environment.
"""

import os
import subprocess
import unittest

BITS = os.environ["FLIPFLOP_ENVIRONMENT_BITS"]


def lines(environment, threads):
    """What the process writes: a call and a digest of its result on each line."""
    done = subprocess.run([BITS, environment, str(threads)], capture_output=True, text=True, check=False)
    if done.returncode == 77:
        raise unittest.SkipTest(f"there is no environment {environment} here")
    return done.stdout.splitlines(), done.returncode


class TestFloatingPointEnvironment(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.wanted, returned = lines("default", 1)
        assert returned == 0, cls.wanted[-1:]
        # Of subnormal numbers, areas are no doubles; beside 1, none is refined.
        refused = [line.split(",")[0] for line in cls.wanted if " error " in line]
        assert len(cls.wanted) > 130 and refused == ["refinedMesh", "centroidalCells", "prescribedAreas"], refused

    def check(self, environment, threads_tried=(2,)):
        for threads in threads_tried:
            found, returned = lines(environment, threads)
            different = [line for line in found if line not in self.wanted]
            print(f"{environment}, {threads} thread(s): {len(different)} of {len(self.wanted)} differ")
            self.assertEqual(different, [])
            self.assertEqual((len(found), returned), (len(self.wanted), 0))

    def test_default(self):
        self.check("default")

    def test_subnormal_numbers_flushed(self):
        self.check("flush")

    def test_rounding_upward(self):
        self.check("up", (1, 2))

    def test_rounding_downward(self):
        self.check("down")

    def test_rounding_toward_zero(self):
        self.check("zero")

    def test_exceptions_that_trap(self):
        self.check("trap")


if __name__ == "__main__":
    unittest.main()
