#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# install-paraview.sh: see to a ParaView, 5.11 or later, with its development files. Where PARAVIEW_ROOT names one (the
# prefix that holds bin/pvpython), that is it: /usr on Debian testing, with paraview-dev and python3-paraview installed. Else Debian's packages are unpacked, not installed, into
# build/paraview-root: ParaView's Python package conflicts with that of VTK, which the VTK build needs.
# Unpacked, it runs in place. Where all is there, nothing is done and no privilege is needed.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# It runs, so the libraries that it needs are there as well; and it is not too old.
check='
import paraview.simple
assert tuple(map(int, paraview.__version__.split(".")[:2])) >= (5, 11), "older than ParaView 5.11"
'
runs() {
  [ -n "$(find "$paraview"/lib* -maxdepth 4 -name paraview-config.cmake 2>/dev/null)" ] &&
    "$paraview/bin/pvpython" -c "$check" >/dev/null 2>&1
}
if runs; then
  "$top/Scripts/link-paraview-modules.sh"
  exit 0
fi
if [ -n "${PARAVIEW_ROOT:-}" ]; then
  echo "PARAVIEW_ROOT is $PARAVIEW_ROOT, and no ParaView 5.11 or later with development files runs there" >&2
  exit 1
fi

root=$(dirname "$paraview")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

say "ParaView: unpack its packages in $root"
download() {
  (cd "$work" && apt-get download -qq -o APT::Sandbox::User=root paraview paraview-dev python3-paraview)
}
# There may be no lists of packages yet, or old ones.
download 2>/dev/null || { apt_get update && download; }

rm -rf "$root"
mkdir -p "$root"
for package in "$work"/*.deb; do
  dpkg -x "$package" "$root"
done

# Their dependencies are installed, but for those on each other.
needed=$(for package in "$work"/*.deb; do
  dpkg-deb -f "$package" Depends
done | tr ',' '\n' | sed 's/^ *//' | grep -Ev '^(paraview|paraview-dev|python3-paraview)( |$)' | sort -u | paste -sd,)
apt_get satisfy -y --no-install-recommends "$needed"

runs || { echo "ParaView does not run in $root" >&2; "$paraview/bin/pvpython" -c "$check"; exit 1; }
