# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmarks/report.py: ratios are taken within a round, and what is wrong or missing shows."""

import contextlib
import importlib.util
import io
import os
import sys
import tempfile
import unittest

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.dont_write_bytecode = True
spec = importlib.util.spec_from_file_location("report", os.path.join(TOP, "Benchmarks", "report.py"))
report = importlib.util.module_from_spec(spec)
spec.loader.exec_module(report)

RESULTS = """# section: hull
family,count,program,threads,parts,round,status,seconds,peak_bytes,vertices,message
cube,1000,flipflop,1,0,0,ok,0.1,100,8,valid
cube,1000,flipflop,1,0,1,ok,0.2,300,8,
cube,1000,flipflop,1,0,2,ok,0.1,200,8,
cube,1000,qhull,1,0,0,wrong,0.4,100,9,"bad, bad"
cube,1000,qhull,1,0,1,ok,0.4,100,9,
cube,1000,qhull,1,0,2,failed,,,,error
cube,2000,flipflop,1,0,0,ok,0.1,100,8,valid
cube,2000,qhull,1,0,0,skipped,,,,too slow
"""


class TestReport(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "hull.csv")
        with open(self.path, "w", encoding="utf-8") as file:
            file.write(RESULTS)
        self.facts, rows = report.read(self.path)
        self.lines = list(report.summary(rows))

    def test_medians_and_ratios(self):
        ours, qhull = self.lines[:2]
        self.assertEqual(self.facts, ["# section: hull\n"])
        self.assertEqual((ours["status"], ours["seconds_median"], ours["peak_bytes"]), ("ok", "0.1", "200"))
        self.assertEqual(ours["ratio_qhull"], "3")  # 4 and 2; the medians of all would give 4
        self.assertEqual((qhull["status"], qhull["rounds"], qhull["message"]), ("wrong", 2, "bad, bad"))
        self.assertNotIn("ratio_flipflop", qhull)

    def test_the_table(self):
        with contextlib.redirect_stdout(io.StringIO()) as out:
            report.markdown(self.lines, ["vertices"])
        lines = out.getvalue().splitlines()
        self.assertEqual(lines[0],
                         "| family | count | vertices | flipflop, 1 thr., s | qhull, s | qhull / flipflop, 1 thr. |")
        self.assertEqual(lines[2], "| cube | 1,000 | 8 | 0.1 | 0.4* | 3.0 |")
        self.assertEqual(lines[3], "| cube | 2,000 | 8 | 0.1 | skipped | - |")

    def test_the_summary_is_read_as_results_are(self):
        path = self.path + ".summary"
        report.write_csv(path, self.facts, self.lines)
        facts, rows = report.read(path)
        self.assertEqual(facts, self.facts)
        self.assertEqual([row["program"] for row in rows], ["flipflop", "qhull"] * 2)
        self.assertEqual(rows[0]["ratio_qhull"], "3")


if __name__ == "__main__":
    unittest.main()
