#!/usr/bin/env bash
# Makes every artefact of a release, and checks each in a fresh system without a compiler (docs/packages.md):
#   release.sh [--cache FOLDER] [--out FOLDER] [--cross FILE] [--no-wheel] [--made] [RELEASES [ARCHITECTURE]]
#   release.sh 12 arm64 --cross FILE    # options may also stand first
# By default for Debian 12 and 13 and the architecture of this machine, in out/release. Packages for the release of this
# machine are built here, in build/package; others in a fresh system with a compiler. --cross FILE is a toolchain file of
# CMake for another ARCHITECTURE, with which they are built here; checks then require qemu-user-static. --made only checks
# packages that an earlier call has made. --cache keeps the results of compilers of the fresh systems in FOLDER. Requires
# root and, without a cache, half an hour a release on two cores. The logs and the table of artefacts, artefacts.md, are
# in the same folder.
set -euo pipefail
cd "$(dirname "$0")/../.."
# shellcheck source=scripts/bare_system.sh
source scripts/bare_system.sh

complain() {
  echo "release: $*" >&2
}

cache='' out=$PWD/out/release cross='' without_wheel='' made='' words=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --cache) mkdir -p "${2:?--cache requires a folder}" && cache=$(realpath "$2") && shift 2 ;;
    --out) out=$(realpath -m "${2:?--out requires a folder}") && shift 2 ;;
    --cross) cross=$(realpath "${2:?--cross requires a file}") && shift 2 ;;
    --no-wheel) without_wheel=yes && shift ;;
    --made) made=yes && shift ;;
    -h | --help) sed -n '2,/^set /s/^# //p' "$0" && exit ;;
    --*) complain "unknown option '$1'; there are --cache, --out, --cross, --no-wheel and --made" && exit 2 ;;
    *) words+=("$1") && shift ;;
  esac
done
IFS=, read -ra releases <<<"${words[0]:-12,13}"
native=$(dpkg --print-architecture)
readonly native architecture=${words[1]:-$native} table=$out/artefacts.md
require_releases "${releases[@]}"
scripts/setup.sh package
require_systems
mkdir -p "$out"
work=$(mktemp -d /var/tmp/somato-release.XXXXXX)
trap 'rm -rf --one-file-system "$work"' EXIT

is_here() {
  [[ $(sed -n 's/^VERSION_ID="\(.*\)"$/\1/p' /etc/os-release) == "$1" ]] &&
    [[ $architecture == "$native" || -n $cross ]]
}

# make_packages RELEASE FOLDER
make_packages() {
  local root=$work/build-$1
  [[ -z $made || ! -d $2 ]] || return 0
  rm -rf "$2"
  if is_here "$1"; then
    SUFFIX=${cross:+$architecture} DEB_HOST_ARCH=$architecture \
      scripts/release/pack.sh "$2" ${cross:+"-DCMAKE_TOOLCHAIN_FILE=$cross"} || return
    # The interface of 1.0 in abi/ is that of amd64 (docs/stability.md).
    if [[ $architecture == amd64 ]]; then scripts/release/check_abi.py build/package/src/libsomato.so.1; fi
    return
  fi
  bare_system "${codenames[$1]}" "$root" git &&
    git clone --quiet . "$root/somato" &&
    inside "$root" /somato/scripts/release/pack.sh /packages &&
    cp -r "$root/packages" "$2" &&
    rm -rf --one-file-system "$root"
}

# The tags that are overridden are named in packaging/debian.
check_policy() {
  lintian --allow-root --fail-on error,warning "$1"/*.deb
}

apt_install() {
  inside "$1" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${@:2}"
}

# install_program ROOT RELEASE FOLDER: the steps of the Dockerfile's image.
install_program() {
  bare_system "${codenames[$2]}" "$1" &&
    cp -r "$3" "$1/packages" &&
    mkdir "$1/checked" &&
    inside "$1" apt-get update -q &&
    apt_install "$1" "$(cd "$1" && echo ./packages/somato_*.deb)" &&
    inside "$1" bash -c '! command -v cc c++ gcc g++ clang cmake' &&
    inside "$1" somato --version
}

# The README's five minutes, and its Python with the wheel, still without a compiler. python3 runs the blocks.
follow_readme() {
  local root=$1 python=()
  git clone --quiet . "$root/somato" &&
    apt_install "$root" python3 python3-venv &&
    if compgen -G "$out/wheel/*.whl"; then
      cp -r "$out/wheel" "$root/wheel" &&
        inside "$root" python3 -m venv /venv &&
        inside "$root" bash -c '/venv/bin/pip install /wheel/*.whl' || return 1
      python=(--python /venv/bin/python)
    fi &&
    inside "$root" bash -c '! command -v cc c++ gcc g++ clang cmake' &&
    inside "$root" python3 /somato/scripts/run_doc_blocks.py --source /somato --scratch /checked/readme \
      --program /usr/bin/somato "${python[@]}" --only README.md
}

# The unit is complete, and the program says to its manager what it waits for.
check_service() {
  apt_install "$1" systemd &&
    inside "$1" systemd-analyze verify --man=no somato-live@skin.service &&
    inside "$1" systemd-analyze security --offline=yes --threshold=25 somato-live@skin.service &&
    inside "$1" python3 /somato/scripts/release/run_service.py /usr/lib/systemd/system/somato-live@.service
}

# Programs in C and C++ with the packages of the library, linked with either library.
build_with_library() {
  local root=$1 library
  apt_install "$root" "$(cd "$root" && echo ./packages/libsomato[0-9]*.deb)" \
    "$(cd "$root" && echo ./packages/libsomato-dev*.deb)" g++ cmake make || return 1
  for library in somato shared; do
    # shellcheck disable=SC2016
    inside "$root" bash -ec '
      cmake -S /somato/tests/install/maps -B "/checked/maps-$1" -DSOMATO_LIBRARY="$1"
      cmake --build "/checked/maps-$1"
      cd /checked && "/checked/maps-$1/user"' build "$library" || return 1
  done
  inside "$root" bash -ec '
    somato run icub_joints --data /somato/examples/synthetic_grasps --seeds 1 --out /checked/icub
    cmake -S /somato/examples/c -B /checked/c -DSOMATO_LIBRARY=shared && cmake --build /checked/c
    printf "1 2 3 4 5 6 7 8 9\n" | /checked/c/user /checked/icub/system.somato
    ldd /checked/c/user | grep libsomato.so.1
    cmake -S /somato/tests/install/simulation -B /checked/simulation && cmake --build /checked/simulation && /checked/simulation/user'
}

# row FILE NEEDS CHECKS...: one of the table.
row() {
  printf '| %s | %s | %s | %s |\n' "$(basename "$1")" "$(numfmt --to=iec --suffix=B "$(stat --format %s "$1")")" "$2" "$3" \
    >>"$table"
}

# needs FILE: the packages that a package depends on, without versions.
needs() {
  dpkg-deb --field "$1" Depends | sed 's/ ([^)]*)//g'
}

run_release() {
  local folder=$out/debian-$1-$architecture root=$work/$1 file
  log=$out/debian-$1-$architecture.log
  : >"$log"
  echo "== Debian $1 (${codenames[$1]}, $architecture), $(git rev-parse --short HEAD)"
  step 'packages' make_packages "$1" "$folder" || return 1
  local passed=''
  step 'lintian' check_policy "$folder" && passed='lintian'
  if step 'installed, without a compiler' install_program "$root" "$1" "$folder"; then
    step "the README's five minutes" follow_readme "$root" && passed+=", the README's five minutes without a compiler"
    step 'service' check_service "$root" && passed+=', the service'
    for file in "$folder"/somato_*.deb; do row "$file" "$(needs "$file")" "$passed"; done
    passed=''
    step 'programs with the library' build_with_library "$root" &&
      passed='lintian, programs in C and C++ built and run'
    for file in "$folder"/libsomato*.deb; do row "$file" "$(needs "$file")" "$passed"; done
  fi
  [[ $failures == 0 ]] || tail -n 20 "$log" >&2
  rm -rf --one-file-system "$root"
}

make_wheel() {
  rm -rf "$out/wheel"
  scripts/release/wheel.sh "$out/wheel"
}

printf '| artefact | size | needs | run on it |\n|---|---|---|---|\n' >"$table"
if [[ -z $without_wheel && $architecture == "$native" ]]; then
  log=$out/wheel.log
  : >"$log"
  echo "== wheel ($architecture), $(git rev-parse --short HEAD)"
  if step 'wheel' make_wheel; then
    versions=$(sed -n 's/^passed with Python //p' "$log" | paste -sd ' ')
    for file in "$out"/wheel/*.whl; do
      row "$file" "$(sed -n 's/^needs //p' "$log")" "abi3audit; the README's Python with $versions"
    done
  else
    tail -n 20 "$log" >&2
  fi
fi
for release in "${releases[@]}"; do
  run_release "$release" || true
done
cat "$table"
echo "Artefacts, logs and this table: $out"
if [[ $failures -gt 0 ]]; then
  complain "$failures steps failed"
  exit 1
fi
