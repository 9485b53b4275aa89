#!/usr/bin/env bash
# Builds Somato for 64-bit ARM with Debian's cross compiler and checks it under qemu-user, on Debian 12 for x86_64:
#   arm64.sh STAGE...
#   arm64.sh packages build same_bits tests readme counts
# Prints the seconds of each stage. `packages` requires root, and changes the system: it installs libraries of the
# other architecture, which displace libwebsockets-dev of this one. Use a system of its own (scripts/other_systems.sh arm64).
set -euo pipefail
cd "$(dirname "$0")/.."

readonly build=build/arm64

# The rooms whose tests run: those with arithmetic, files and protocols. Not run, because each would take too long under
# qemu or needs more than the cross compiler: bodies (simulated hands: minutes each), studies, views and program (whole
# trainings; many start the program, which the kernel cannot run by itself), the other rooms of hardware and all of web,
# peers, mcap and python (other programs of the machine's own architecture).
readonly rooms='base\.(kernels|core|numbers|arrays|archives)|maps\.[a-z_]+|systems\.(codes|graph)|recordings\.(file|explorations)|hardware\.protocols'

libraries() {
  local package
  sed -n '/^\[build\]$/,/^\[python\]$/p' scripts/packages.txt | grep -xE '[a-z0-9-]+-dev' | while read -r package; do
    if apt-cache show --no-all-versions "$package" | grep -qx 'Architecture: all'; then
      echo "$package"
    else
      echo "$package:arm64"
    fi
  done
  echo libgtest-dev:arm64
}

packages() {
  local wanted
  dpkg --add-architecture arm64
  apt-get update -q
  mapfile -t wanted < <(libraries)
  DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends g++ g++-aarch64-linux-gnu qemu-user ccache \
    cmake ninja-build python3 python3-pip nodejs npm git "${wanted[@]}" </dev/null
  scripts/fetch_mujoco.sh aarch64
}

targets() {
  cmake --build "$build" --target "$@"
}

build() {
  cmake --preset arm64
  targets same_bits base_tests maps_tests systems_tests recordings_tests hardware_tests somato_program guard_arm64 \
    guard_arm64_scalar
}

# The lines of every machine.
same_bits() {
  qemu-aarch64 "$build/tests/same_bits/same_bits" | diff tests/same_bits/expected.txt -
  echo "same_bits: $(wc -l <tests/same_bits/expected.txt) lines as on x86_64"
}

# A death test starts its program again, which only the kernel of that architecture can.
tests() {
  GTEST_FILTER='-*DeathTest.*' ctest --test-dir "$build" --output-on-failure -R "^($rooms)\$"
  echo "Not run: $(ctest --test-dir "$build" -N | grep -oE '[a-z_]+\.[a-zA-Z0-9_.]+$' | grep -vxE "$rooms" | paste -sd ' ')"
}

# The commands of README.md, with the program under qemu.
readme() {
  local program=$PWD/$build/somato_by_qemu
  printf '#!/bin/sh\nexec qemu-aarch64 "%s" "$@"\n' "$PWD/$build/somato" >"$program"
  chmod +x "$program"
  python3 scripts/run_doc_blocks.py --source . --scratch "$build/readme" --program "$program" --only README.md
}

counts() {
  python3 bench/guard_arm64.py "$build"
}

for stage in "$@"; do
  case $stage in
    packages | build | same_bits | tests | readme | counts) ;;
    *) echo "arm64: unknown stage '$stage'; there are packages, build, same_bits, tests, readme and counts" >&2 && exit 2 ;;
  esac
done
for stage in "${@:?arm64: a stage is missing: packages, build, same_bits, tests, readme or counts}"; do
  SECONDS=0
  "$stage"
  echo "$stage: $SECONDS s"
done
