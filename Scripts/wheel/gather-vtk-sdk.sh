#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
#
# gather-vtk-sdk.sh PYTHON FOLDER: puts the wheel vtk-sdk into FOLDER, of the version that pyproject.toml asks
# for and for that Python: the index's, or else a stand-in that vtk_sdk.py makes of Debian's VTK of the same
# version (its testing and unstable suites have it; nothing of them is installed) and the wheel vtk.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
interpreter=$1
folder=$(realpath -m "$2")

version=$(sed -n 's/.*"vtk-sdk==\([0-9.]*\)".*/\1/p' "$top/pyproject.toml")
tag=$("$interpreter" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
mkdir -p "$folder"
# What another version of this script, or of the project, has left there would be taken for the right one.
find "$folder" -name 'vtk_sdk-*.whl' \( ! -name "vtk_sdk-$version-*" \
  -o ! -newer "$top/Scripts/wheel/vtk_sdk.py" \) -delete
if compgen -G "$folder/vtk_sdk-$version-$tag-*.whl" >/dev/null; then
  exit
fi
say "The wheel vtk-sdk $version"
if answer=$("$interpreter" -m pip download --quiet --no-deps --only-binary :all: --dest "$folder" \
  "vtk-sdk==$version" 2>&1); then
  exit
fi
if grep -q "No matching distribution" <<<"$answer"; then
  echo "No index has it for this machine: it is made of Debian's VTK $version and the wheel vtk"
else
  echo "pip cannot fetch it, so it is made of Debian's VTK $version and the wheel vtk: $(tail -n 1 <<<"$answer")"
fi
if [ "$(dpkg --print-architecture)" != amd64 ]; then
  echo "That is written for x86-64 alone; put the wheel vtk-sdk into $folder" >&2
  exit 1
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"
mkdir -p "$work"/{etc,lists/partial,archives/partial,packages,debian}

# Where this machine has its Debian from, with newer suites. An archive that is frozen has an old date.
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep -m1 '/debian/*$' || true)
if [ -z "$mirror" ]; then
  echo "No Debian archive among the machine's package sources" >&2
  exit 1
fi
for suite in testing unstable; do
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main"
done >"$work/etc/sources.list"
cat >"$work/apt.conf" <<END
Dir::Etc::sourcelist "$work/etc/sources.list";
Dir::Etc::sourceparts "/dev/null";
Dir::Etc::preferencesparts "/dev/null";
Dir::State::lists "$work/lists";
Dir::State::status "/dev/null";
Dir::Cache "$work";
Acquire::Check-Valid-Until "false";
Acquire::Languages "none";
APT::Update::Error-Mode "any";
APT::Sandbox::User "root";
END
export APT_CONFIG="$work/apt.conf"
apt-get -qq update

found=$(apt-cache madison libvtk9-dev | awk -v version="$version" \
  '$3 ~ "^" version "[^0-9.]" {print $3; exit}')
if [ -z "$found" ]; then
  echo "Debian's testing and unstable have no VTK $version, but:" >&2
  apt-cache madison libvtk9-dev >&2
  exit 1
fi
(
  cd "$work/packages"
  apt-get -qq download libvtk9-dev="$found" "libvtk${version%.*}=$found" vtk9="$found" \
    python3-vtk9="$found" libc6 libstdc++6 libgcc-s1
)
unset APT_CONFIG
for package in "$work"/packages/*.deb; do
  dpkg -x "$package" "$work/debian"
done
"$interpreter" -m pip download --quiet --no-deps --only-binary :all: --dest "$work" "vtk==$version"
"$interpreter" "$top/Scripts/wheel/vtk_sdk.py" --debian "$work/debian" --vtk-wheel "$work"/vtk-*.whl \
  --output "$folder"
