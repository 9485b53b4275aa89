#!/usr/bin/env bash
# Unpacks the wheel that a file of pinned requirements names: unpack_wheel.sh REQUIREMENTS FOLDER [MACHINE], for
# machines like this one or for MACHINE, such as aarch64.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# The tag of the interpreter is irrelevant: the files are the same for each.
python3 -m pip --disable-pip-version-check download --quiet --no-deps --only-binary :all: \
  --implementation cp --python-version 311 --platform "manylinux_2_28_${3:-$(uname -m)}" \
  --require-hashes --requirement "$1" --dest "$work"
python3 -m zipfile -e "$work"/*.whl "$2"
