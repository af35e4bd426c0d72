# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every error bound of the sources has a proof of the very expression, and both agree (Documentation/Exactness.md).

A script quotes what it mirrors:
    #: FILE FUNCTION    what follows is in this function
    #= CODE             is there, and is the script's next definition
    #- CODE             is there
"""
import functools
import os
import re
import resource
import shutil
import subprocess
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BOUNDS = "Engine/Predicates/ErrorBounds.h"
PROOFS = "Testing/Proofs"
TABLE = "Testing/Proofs/Lemmas.txt"
LITERAL = re.compile(r"\b0x[0-9a-fA-F.]+p[-+]?\d+|\b\d+\.?\d*e[-+]?\d+|\b(?:\w+::)*numeric_limits<\w+>::epsilon\(\)")

# Numbers with an exponent that bound no error: what they are instead.
OTHER = {
    "Engine/Finish/Measure.h": ("fixed point", "0x1p50", "0x1p31", "0x1p-50", "0x1p-81"),
    "Engine/Points/ScaledRange.h": ("where a lattice is looked for", "1e-60", "1e60", "0x1p-10"),
    "Engine/Constraints/ConstraintCrossings.cxx": ("units of a count of units", "0x1p-52", "0x1p-1074"),
    "Engine/Geometry/LiftedGeometry.h": ("lattices (lattice.gappa), and no overflow", "0x1p25", "0x1p1000", "0x1p13"),
    "Engine/Geometry/HullLocator.cxx": ("a guard against division by zero", "1e-20", "1e-30", "1e-30"),
    "Engine/Geometry/HullStart.cxx": ("a map's shape", "1e-24"),
    "Engine/Run/FurthestSite.cxx": ("a map's shape", "0x1p-500", "0x1p500"),
    "Engine/Surface/StarShape.cxx": ("a kernel that exact signs accept or refuse", "0x1p48"),
    "Engine/HalfSpaces/HalfSpaces.cxx": ("half-spaces far away, of which none may remain; ranges of positions", "0x1p1023", "0x1p1000",
                                         "0x1p-500", "0x1p500"),
    "Engine/HalfSpaces/SurelyRedundant.cxx": ("margins that its header proves", "0x1p-24", "0x1p-50", "0x1p300"),
    "Engine/HalfSpaces/InteriorPoint.cxx": ("a box for an interior that exact signs accept or refuse", "0x1p20"),
    "Engine/Surface/LinearProgram.h": ("a kernel that exact signs accept or refuse", "1e-13"),
    "Engine/Query/FacetPlane.h": ("ranges of a rounded result", "0x1p-120", "0x1p1000", "0x1p1023"),
    "Engine/Query/SurfaceTree.cxx": ("which way to a rounded result", "0x1p-32", "0x1p-120", "1e-3"),
    "Engine/Query/UnitFrame.h": ("no overflow", "0x1p1000"),
    "Engine/Query/PlaneValues.h": ("when a result is computed again, and ranges", "0x1p-4", "0x1p-12", "0x1p-30",
                                   "0x1p-480", "0x1p-120", "0x1p240"),
    "Engine/Query/TriangleShares.cxx": ("ranges of a rounded result", "0x1p-900", "0x1p900"),
    "Engine/Query/SiteGradients.cxx": ("the rank of a fit", "1e-6"),
    "Engine/Query/OffsetFrame.h": ("a range of a rounded result", "0x1p-300"),
    "Engine/Query/EdgeLengths.cxx": ("the range of expansions", "1e-120", "1e145"),
    "Engine/Refine/SplitPoints.h": ("where a search ends", "std::numeric_limits<double>::epsilon()"),
    "Engine/Query/MinimalBox.cxx": ("a search, and its unit", "0x1p1000", "1e-12", "1e-12", "1e-12"),
    "Engine/Points/Scan.cxx": ("doubles that are integers", "0x1.8p52", "0x1p50", "0x1p53"),
    "Engine/Predicates/RoundedFractions.h": ("no overflow (bounded.gappa), and what rounded-fraction.gappa assumes",
                                             "0x1p-150", "0x1p150", "0x1p-300", "0x1p300", "0x1p-20", "0x1p150"),
    "Engine/Predicates/FixedSigns.h": ("integers", "0x1p124"),
    "Engine/Transport/PrescribedAreas.cxx": ("a goal of iterations", "1e-15"),
    "Engine/PowerDiagram/BoxScale.h": ("units in the last place", "0x1p-52", "0x1p-1074"),
    "Engine/PowerDiagram/CellLines.cxx": ("no overflow; the least normal number", "0x1p-1022", "0x1p1000"),
    "Engine/include/flipflop/PrescribedAreas.h": ("a default", "1e-6"),
    "Cuda/Device/CudaExecutor.cu": ("milliseconds", "1e-3", "1e-3"),
    "Cuda/Rounds/OrderKernels.h": ("no overflow", "1e300"),
}


@functools.lru_cache(None)
def read(name):
    return (ROOT / name).read_text()


@functools.lru_cache(None)
def listed(folder, endings):
    return [str(p.relative_to(ROOT)) for p in (ROOT / folder).rglob("*") if p.suffix in endings]


class Tree:
    """The sources, some of them replaced: None is a file that is not there."""

    def __init__(self, **changed):
        self.changed = {name.replace("__", "/"): text for name, text in changed.items()}

    def read(self, name):
        return self.changed[name] if name in self.changed else read(name)

    def files(self, folder, *endings):
        names = set(listed(folder, endings))
        return sorted(name for name in names if self.changed.get(name, "") is not None)


def value(expression):
    """Of a constant expression in C++ or Gappa, exactly."""
    def number(match):
        mantissa, binary = re.fullmatch(r"(?:0x)?([\d.]+)(?:[pb]([-+]?\d+))?", match[0]).groups()
        return f'(Fraction("{mantissa}") * Fraction(2) ** ({binary or 0}))'
    return eval(re.sub(r"0x1p[-+]?\d+|\d+b[-+]?\d+|\d+\.?\d*", number, expression), {"Fraction": Fraction})


def squeeze(text):
    return re.sub(r"\s+", "", text)


def translated(code):
    """An expression of C++ as Gappa has it."""
    code = re.sub(r"\bthis->|\bstd::", "", code)
    while (start := code.find("fabs(")) >= 0:
        depth, end = 1, start + 5
        while depth:
            depth += {"(": 1, ")": -1}.get(code[end], 0)
            end += 1
        code = code[:start] + "|" + code[start + 5:end - 1] + "|" + code[end:]
    code = re.sub(r"->|(?<=[\w\]])\.(?=[a-zA-Z])|\[", "_", code).replace("]", "")
    return squeeze(re.sub(r"0x1p", "1b", code))


@functools.lru_cache(None)
def region(text, anchor):
    """Where in a source a function, a constructor or a class is, without comments and spaces."""
    if not anchor:
        return squeeze(text)
    found = re.search(r"\s+".join(re.escape(word) for word in anchor.split()), text)
    if not found:
        return ""
    begin = text.rfind("\n", 0, found.start()) + 1
    first = text[begin:].split("\n", 1)[0]
    if first.rstrip().endswith("}"):
        return squeeze(first)
    indent = re.match(r" *", first)[0]
    end = re.compile(rf"^{indent}}}", re.M).search(text, begin)
    return squeeze(re.sub(r"//.*", "", text[begin:end.end() if end else len(text)]))


@functools.lru_cache(None)
def words(text):
    return frozenset(re.findall(r"\w+", re.sub(r"//.*", "", text)))


@functools.lru_cache(None)
def numbers(text):
    """Those with an exponent."""
    return sorted(LITERAL.findall(re.sub(r'//.*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', "", text)))


def bounds(tree):
    """{constant: (value, scripts that prove it)}"""
    result, scripts = {}, []
    for line in re.split(r"\n(?!\s*///(?! @))", re.sub(r"\n/// (?![\w-]+(, [\w-]+)*:|@)", " ", tree.read(BOUNDS))):
        for part in line.split("\n"):
            if group := re.match(r"/// ([\w-]+(?:, [\w-]+)*):", part):
                scripts = group[1].split(", ")
            elif constant := re.match(r"constexpr double (\w+) = (.*);", part):
                result[constant[1]] = (value(constant[2]), scripts)
    return result


def quotes(tree, script):
    """What is at fault in a script's quotations, and the constants that it quotes."""
    faults, constants, file, where = [], set(), "", ""
    lines = tree.read(script).splitlines()
    for number, line in enumerate(lines):
        if line.startswith("#: "):
            file, _, anchor = line[3:].strip().partition(" ")
            where = region(tree.read(file), anchor)
            if not where:
                faults.append(f"{script}: {file} has no {anchor}")
        elif line.startswith(("#= ", "#- ")):
            code = line[3:].strip()
            if squeeze(code) not in where:
                faults.append(f"{script}: {file} does not have: {code}")
            if line[1] == "-":
                continue
            definition = re.fullmatch(r"(\w+)\s*(?:rnd)?=\s*(.*);", lines[number + 1])
            quoted = re.fullmatch(r"(?:this->)?([\w.\[\]]+)(?: = |\()(.*?)\)?|(return) (.*);", code)
            name, mirrored = (quoted[1], quoted[2]) if quoted and quoted[1] else (None, quoted[4] if quoted else "")
            if quoted and quoted[1] and "(" in code.split("=")[0] and not code.startswith(quoted[1] + " ="):
                mirrored = code[len(quoted[1]) + 1:-1]
            elif quoted and quoted[1]:
                mirrored = code.split(" = ", 1)[1]
            if file == BOUNDS:
                constants.add(name)
                same = definition and definition[1] == name and value(definition[2]) == value(mirrored)
            else:
                same = definition and squeeze(definition[2]) == translated(mirrored) and (
                    name is None or definition[1] == translated(name))
            if not same:
                faults.append(f"{script}: not the same: {code} | {lines[number + 1]}")
    return faults, constants


def proven(tree, script):
    """{constant: the bound that a script proves}"""
    found = re.findall(r"^Proven\d* = (.*); # (\w+)$", tree.read(script), re.M)
    return {name: value(expression) for expression, name in found}


def defined(script, name):
    return re.search(rf"^{name} = (.*);", script, re.M)[1]


def faults(tree):
    """What of sources and scripts does not fit together."""
    result = []
    constants = bounds(tree)
    scripts = tree.files(PROOFS, ".gappa")
    quoted, ratios = {}, {}
    for script in scripts:
        found, names = quotes(tree, script)
        result += found
        stem = Path(script).stem
        quoted[stem] = names
        for name, bound in proven(tree, script).items():
            ours = constants[name][0] if name in constants else value(defined(tree.read(script), name))
            ratios[name] = max(ours / bound, ratios.get(name, 0))
        if stem != "lattice" and not any(stem in of for _, of in constants.values()):
            result.append(f"{script}: {BOUNDS} does not name it")
    used = set().union(*(words(tree.read(name)) for name in tree.files("Engine", ".h", ".cxx") if name != BOUNDS))
    for name, (_, of) in constants.items():
        result += [f"{name}: there is no {stem}.gappa" for stem in of if stem not in quoted]
        if not any(name in quoted.get(stem, ()) for stem in of):
            result.append(f"{name}: no script quotes it")
        if name not in used:
            result.append(f"{name}: the sources do not use it")
    result += [f"{name}: {float(ratio):.3f} times what is proven" for name, ratio in ratios.items()
               if not Fraction(999, 1000) < ratio <= 2]
    for name in tree.files("Engine", ".h", ".cxx") + tree.files("Cuda", ".h", ".cxx", ".cu"):
        found = numbers(tree.read(name))
        if name != BOUNDS and found != sorted(OTHER.get(name, ("",))[1:]):
            result.append(f"{name}: {found}: a bound belongs into {BOUNDS}, with a proof; else say what it is in OTHER")
    return result


def prove(name):
    """What Gappa says."""
    run = subprocess.run(["gappa", "-Eprecision=200", str(ROOT / name)], capture_output=True, text=True, timeout=60)
    return name, run.returncode, run.stdout + run.stderr


def seconds_of(name):
    """Of the processor, that Gappa takes."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    prove(name)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def ratios_of(tree, script):
    """Ours over what is proven, by constant."""
    text = tree.read(script)
    return {name: f"{float(value(defined(text, name)) / bound):.2f}" for name, bound in proven(tree, script).items()}


def table():
    """What TABLE has."""
    for script in Tree().files(PROOFS, ".gappa"):
        ratios = ", ".join(f"`{name}` {ratio}" for name, ratio in ratios_of(Tree(), script).items())
        milliseconds = min(seconds_of(script) for _ in range(3)) * 1000
        print(f"| {Path(script).stem} | {ratios or 'exact'} | {milliseconds:.0f} |")


class Proofs(unittest.TestCase):
    def test_sources_and_scripts_are_the_same(self):
        self.assertEqual(faults(Tree()), [])

    def test_table_has_the_ratios(self):
        shown = dict(re.findall(r"^\| ([\w-]+) \| (.*) \| \d+ \|$", Tree().read(TABLE), re.M))
        found = {}
        for script in Tree().files(PROOFS, ".gappa"):
            text = ", ".join(f"`{name}` {ratio}" for name, ratio in ratios_of(Tree(), script).items())
            found[Path(script).stem] = text or "exact"
        self.assertEqual(shown, found)

    @unittest.skipUnless(shutil.which("gappa"), "no gappa was found")
    def test_gappa_proves_each(self):
        with ThreadPoolExecutor() as pool:
            for name, status, output in pool.map(prove, Tree().files(PROOFS, ".gappa")):
                with self.subTest(name):
                    self.assertEqual((status, output), (0, ""))


    @unittest.skipUnless(shutil.which("gappa") and os.environ.get("FLIPFLOP_NIGHTLY"), "nightly, or no gappa was found")
    def test_half_of_what_is_proven_is_not(self):
        # So no script proves by hypotheses that exclude each other.
        for name in Tree().files(PROOFS, ".gappa"):
            text = Tree().read(name)
            half = re.sub(r"^(Proven = )(.*); #", r"\1(\2) * 0.5; #", text, flags=re.M)
            with self.subTest(name):
                if half == text:
                    self.assertEqual(Path(name).stem, "lattice")
                    continue
                try:
                    run = subprocess.run(["gappa", "-Eprecision=200"], input=half, capture_output=True, text=True,
                                         timeout=2)
                    self.assertNotEqual(run.returncode, 0)
                except subprocess.TimeoutExpired:
                    pass


class Mutants(unittest.TestCase):
    """Each change is noticed."""

    def notice(self, name, old, new):
        text = Tree().read(name)
        self.assertIn(old, text)
        self.assertTrue(faults(Tree(**{name: text.replace(old, new, 1)})), f"{name}: {old} -> {new}")

    def test_constants(self):
        for name, (number, _) in bounds(Tree()).items():
            self.notice(BOUNDS, f" {name} = ", f" {name} = 1.5 * ")

    def test_expressions(self):
        self.notice("Engine/Predicates/ExactSigns.h", "const double det = left - right;",
                    "const double det = left + right;")
        self.notice("Engine/Predicates/ExactSigns.h", "most > PlaneFloor &&", "most >= 0 &&")
        self.notice("Engine/Geometry/HullGeometry.h", "(u[2] * v[0] - u[0] * v[2])", "(u[2] * v[0] - v[2] * u[0])")
        self.notice("Engine/Geometry/LiftedGeometry.h", "std::fabs(vw) + std::fabs(wv)", "std::fabs(vw - wv)")
        self.notice("Engine/FlipFlop/PartTriangulation.cxx", "std::fabs(left) + std::fabs(right);", "std::fabs(value);")
        self.notice("Engine/Predicates/RoundedFractions.h", " +\n        BoundedUnderflow", "")
        self.notice("Testing/Proofs/determinant.gappa", "det rnd= (u_1 * v_2 - u_2 * v_1)", "det rnd= (u_1 * v_2)")
        self.notice("Testing/Proofs/in-circle.gappa", "bd rnd= w_b_x", "bd rnd= w_a_x")

    def test_removed_scripts(self):
        for name in Tree().files(PROOFS, ".gappa"):
            if Path(name).stem != "lattice":
                self.assertTrue(faults(Tree(**{name: None})), name)

    def test_new_bounds(self):
        self.notice("Engine/Geometry/Direction.h", "double sum = 0;", "double sum = 0; const double error = 1e-15;")
        self.notice("Cuda/Rounds/CellWriter.h", "namespace flipflop",
                    "constexpr double Bound = 3 * 0x1p-53;\nnamespace flipflop")
        self.notice(BOUNDS, "\n}\n", "constexpr double NewError = 0x1p-50;\n\n}\n")


if __name__ == "__main__":
    if sys.argv[1:] == ["--table"]:
        table()
    else:
        unittest.main()
