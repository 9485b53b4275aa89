#!/usr/bin/env bash
# Installs the missing packages of scripts/packages.txt and, for building, the physics engine:
# setup.sh [PURPOSE...], by default all purposes except old-physics, a substitute.
# Does nothing if everything is installed.
set -euo pipefail
cd "$(dirname "$0")"

purposes() {
  sed -n 's/^\[\(.*\)\]$/\1/p' packages.txt
}

# The number of the release of Debian, such as 12.
release() {
  sed -n 's/^VERSION_ID="\(.*\)"$/\1/p' /etc/os-release 2>/dev/null
}

packages_for() {
  awk -v purpose="[$1]" -v release="$(release)" -F @ '
    /^\[/ { inside = ($0 == purpose); next }
    inside && /^[^#]/ && (NF == 1 || $2 == release) { print $1 }' packages.txt
}

# is_there PACKAGE[:COMMAND]
is_there() {
  if [[ $1 == *:* ]] && command -v "${1#*:}" >/dev/null; then
    return 0
  fi
  dpkg-query --show --showformat '${db:Status-Status}\n' "${1%%:*}" 2>/dev/null | grep -qx installed
}

as_root() {
  if [[ $(id -u) == 0 ]]; then
    "$@"
  else
    sudo "$@"
  fi
}

wanted=()
for purpose in "${@:-$(purposes | grep -vx old-physics)}"; do
  for word in $purpose; do
    if ! purposes | grep -qx -- "$word"; then
      echo "setup: unknown purpose '$word'; known purposes: $(purposes | paste -sd ' ')" >&2
      exit 2
    fi
    mapfile -t -O "${#wanted[@]}" wanted < <(packages_for "$word")
  done
done

install_missing() {
  if ! command -v dpkg-query >/dev/null; then
    echo "setup: this is not Debian; install the equivalents of these packages: ${wanted[*]%%:*}" >&2
    return 0
  fi
  local missing=() package
  for package in "${wanted[@]}"; do
    is_there "$package" || missing+=("${package%%:*}")
  done
  [[ ${#missing[@]} -gt 0 ]] || return 0
  if [[ $(id -u) != 0 ]] && ! command -v sudo >/dev/null; then
    echo "setup: packages are missing, and neither root nor sudo is available to install them;" \
      "as root, run: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  echo "Installing: ${missing[*]}"
  as_root apt-get update -q
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
}

install_missing
# Both are fetched at once: each waits for the network.
fetching=()
if [[ " $* " == *" build "* || $# == 0 ]]; then
  ./fetch_mujoco.sh &
  fetching+=($!)
fi
if [[ " $* " == *" test "* || $# == 0 ]]; then
  ./fetch_clang_tidy.sh &
  fetching+=($!)
fi
status=0
for process in "${fetching[@]}"; do
  wait "$process" || status=1
done
exit "$status"
