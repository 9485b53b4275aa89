#!/usr/bin/env bash
# Installs the pinned clang-tidy in build/clang-tidy.
set -euo pipefail
cd "$(dirname "$0")/.."

readonly folder=build/clang-tidy
version=$(sed -n 's/^clang-tidy==\([^ ]*\).*/\1/p' scripts/clang_tidy.txt)

[[ ! -e $folder/$version ]] || exit 0

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
scripts/unpack_wheel.sh scripts/clang_tidy.txt "$work/wheel"
touch "$work/wheel/clang_tidy/data/$version"
chmod +x "$work/wheel/clang_tidy/data/bin/clang-tidy"
mkdir -p build
rm -rf "$folder"
mv "$work/wheel/clang_tidy/data" "$folder"
