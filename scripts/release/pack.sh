#!/usr/bin/env bash
# Builds the packages of Debian (docs/packages.md) for the system on which it runs, or for another architecture:
#   pack.sh FOLDER [CMAKE_OPTION...]     such as -DCMAKE_TOOLCHAIN_FILE=... for a cross compiler
# The files of the packages are in FOLDER afterwards. The build is build/package, or build/package-SUFFIX with the
# variable SUFFIX.
set -euo pipefail
folder=$(realpath -m "${1:?pack.sh requires a folder for the packages}")
shift
cd "$(dirname "$0")/../.."

readonly build=build/package${SUFFIX:+-$SUFFIX}
# The time of everything in the packages, so that the same commit gives the same files.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null || stat --format %Y CHANGELOG.md)
export SOURCE_DATE_EPOCH

scripts/setup.sh build package
# shellcheck source=/dev/null
source /etc/os-release
cmake --preset package -B "$build" -DSOMATO_DEBIAN_REVISION="1~deb$VERSION_ID" \
  -DSOMATO_DEBIAN_SUITE="$VERSION_CODENAME" "$@"
cmake --build "$build"
rm -rf "$build/packages"
(cd "$build" && cpack -B packages)
mkdir -p "$folder"
cp "$build"/packages/*.deb "$folder/"
