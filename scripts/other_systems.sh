#!/usr/bin/env bash
# Runs ./dev run and ./dev test of the committed tree on fresh Debian systems, each in a folder of its own:
#   other_systems.sh [--cache FOLDER] [--only-run] [RELEASES [ARCHITECTURE]]
#   other_systems.sh 13         # releases are separated by commas; default: 12,13
#   other_systems.sh 12,13 arm64
#   other_systems.sh arm64      # the cross compiler of Debian 12, and what it has built under qemu-user (scripts/arm64.sh)
# Requires root, debootstrap, about 10 GB and, on two cores, more than half an hour a system. Another
# architecture than the machine's also requires qemu-user-static. Prints the seconds and the tests that
# passed, and the names of those that failed; the logs stay in build/other_systems. --only-run leaves out
# ./dev test; --cache keeps the results of compilers in FOLDER for the next run, so that the seconds say
# nothing about a fresh machine.
set -euo pipefail
cd "$(dirname "$0")/.."

readonly logs=$PWD/build/other_systems

complain() {
  echo "other_systems: $*" >&2
}

# shellcheck source=scripts/bare_system.sh
source scripts/bare_system.sh

cache='' only_run=''
while [[ ${1:-} == --* ]]; do
  case $1 in
    --cache)
      mkdir -p "${2:?--cache requires a folder}"
      cache=$(realpath "$2")
      shift 2
      ;;
    --only-run) only_run=yes && shift ;;
    *) complain "unknown option '$1'; there are --cache FOLDER and --only-run" && exit 2 ;;
  esac
done
cross=''
if [[ ${1:-} == arm64 ]]; then
  [[ $# == 1 ]] || { complain "arm64 is the cross compiler of Debian 12; nothing may follow it" && exit 2; }
  cross=yes
  set -- 12
fi
IFS=, read -ra releases <<<"${1:-12,13}"
readonly architecture=${2:-$(dpkg --print-architecture)}

require_releases "${releases[@]}"
require_systems

work=$(mktemp -d /var/tmp/somato-systems.XXXXXX)
trap 'rm -rf --one-file-system "$work"' EXIT
mkdir -p "$logs"

bare_checkout() {
  bare_system "$1" "$2" git && git clone --quiet . "$2/somato"
}

make_system() {
  bare_checkout "$@" && inside "$2" /somato/scripts/setup.sh build test
}

make_cross_system() {
  bare_checkout "$@" && inside "$2" /somato/scripts/arm64.sh packages
}

# The stages, the numbers of tests and the names of those that failed, as ./dev test has printed them.
print_tests() {
  grep -aE '^(ok|FAILED) +[0-9]+ s +[0-9]+ s of processors|tests passed, [0-9]+ tests failed|^FAILED ' "$log" |
    sed 's/^/          /'
}

# Returns whether all passes on Debian $1. Errors do not end the function: each step says whether it has failed.
run_system() {
  local root=$work/$1 result=0
  log=$logs/debian-$1-$architecture.log
  : >"$log"
  echo "== Debian $1 (${codenames[$1]}, $architecture), $(git rev-parse --short HEAD)"
  if step 'set-up' make_system "${codenames[$1]}" "$root"; then
    step './dev run' inside "$root" /somato/dev run || result=1
    [[ $only_run ]] || step './dev test' inside "$root" /somato/dev test || result=1
    print_tests
  else
    result=1
  fi
  [[ $result == 0 ]] || tail -n 20 "$log" >&2
  rm -rf --one-file-system "$root"
  return "$result"
}

# Builds for 64-bit ARM on Debian $1 and checks what was built.
run_cross() {
  local root=$work/cross result=0 stage
  log=$logs/debian-$1-cross-arm64.log
  : >"$log"
  echo "== Debian $1 (${codenames[$1]}, $architecture), for arm64, $(git rev-parse --short HEAD)"
  if step 'set-up' make_cross_system "${codenames[$1]}" "$root" &&
    step 'build' inside "$root" /somato/scripts/arm64.sh build; then
    for stage in same_bits tests readme counts; do
      step "$stage" inside "$root" /somato/scripts/arm64.sh "$stage" || result=1
    done
    grep -aE '^same_bits:|tests passed, [0-9]+ tests failed|^Not run:|^(ok|skipped) .*README' "$log" | sed 's/^/          /'
  else
    result=1
  fi
  [[ $result == 0 ]] || tail -n 20 "$log" >&2
  rm -rf --one-file-system "$root"
  return "$result"
}

failed=()
for release in "${releases[@]}"; do
  if [[ $cross ]]; then
    run_cross "$release" || failed+=("$release, for arm64")
  else
    run_system "$release" || failed+=("$release")
  fi
done
echo "Logs: $logs"
if [[ ${#failed[@]} -gt 0 ]]; then
  complain "failed on Debian ${failed[*]}"
  exit 1
fi
