#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# build-reference.sh [WHEEL]: the reference as HTML in build/reference: cpp/ has the C++ API and the pages, by Doxygen,
# python/ the Python API of arrays and of PyVista, by pdoc, notebooks/ the tutorials. index.html leads to them. What it
# needs is installed. WHEEL is a wheel that is built already; without one, the tree is installed by pip.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

reference="$top/build/reference"
wheel=$(realpath "${1:-$top}")
"$top/Scripts/install-dependencies.sh" test wheel
rm -rf "$reference"
mkdir -p "$reference"

say "C++: Doxygen"
targets=(documentation)
configure_and_build default reference-cpp -DFLIPFLOP_BUILD_DOCUMENTATION=ON -DFLIPFLOP_BUILD_FILTERS=OFF \
  -DFLIPFLOP_CUDA=OFF -DBUILD_TESTING=OFF
cp -r "$top/build/reference-cpp/Documentation/html" "$reference/cpp"

say "Python: pdoc"
"$python" -m venv --clear "$top/build/reference-python"
"$top/build/reference-python/bin/pip" install --quiet pdoc "$wheel[pyvista]"
(cd "$reference" && "$top/build/reference-python/bin/python" -B "$top/Documentation/python_reference.py" python)
"$python" -B "$top/Documentation/notebooks.py" "$reference/notebooks"

cat >"$reference/index.html" <<'EOF'
<!doctype html><meta charset="utf-8"><title>FlipFlop</title>
<h1>FlipFlop</h1>
<ul><li><a href="cpp/index.html">C++, and all pages</a></li>
<li><a href="python/index.html">Python</a></li>
<li><a href="notebooks/">The tutorials as notebooks</a></li></ul>
EOF

# What is shown is what is documented.
grep -q "vtkFFHullFilter" "$reference/cpp/classvtkFFHullFilter.html"
grep -q "regular_triangulation" "$reference/python/vtkflipflop/arrays.html"
grep -q "convex_hull" "$reference/python/vtkflipflop/pyvista.html"
say "Written: $reference/index.html"
