#!/usr/bin/env bash
# Installs the pinned physics engine in build/mujoco, or the distribution's if it cannot be downloaded:
# fetch_mujoco.sh [MACHINE]; for another machine than this one, such as aarch64, in build/mujoco-MACHINE.
set -euo pipefail
cd "$(dirname "$0")/.."

readonly machine=${1:-$(uname -m)}
folder=build/mujoco
[[ $machine == "$(uname -m)" ]] || folder+=-$machine
version=$(sed -n 's/^mujoco==\([^ ]*\).*/\1/p' scripts/mujoco.txt)

[[ ! -e $folder/lib/libmujoco.so.$version ]] || exit 0

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

if scripts/unpack_wheel.sh scripts/mujoco.txt "$work/wheel" "$machine"; then
  mkdir -p "$work/mujoco/lib"
  mv "$work/wheel/mujoco/include" "$work/mujoco/include"
  mv "$work/wheel/mujoco/libmujoco.so.$version" "$work/mujoco/lib/"
  mv "$work/wheel/mujoco-$version.dist-info/licenses" "$work/mujoco/licenses"
  ln -s "libmujoco.so.$version" "$work/mujoco/lib/libmujoco.so"
  mkdir -p build
  rm -rf "$folder"
  mv "$work/mujoco" "$folder"
  exit 0
fi

if [[ $machine != "$(uname -m)" ]]; then
  echo "fetch_mujoco: MuJoCo $version for $machine cannot be downloaded" >&2
  exit 1
fi
echo "fetch_mujoco: MuJoCo $version cannot be downloaded; the older version of the distribution is used," \
  "whose results differ" >&2
rm -rf "$folder"
scripts/setup.sh old-physics
