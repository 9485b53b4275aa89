# Fresh systems of Debian, for scripts that source this file: other_systems.sh and release.sh. $architecture is that
# of the systems; $cache, if not empty, the folder that keeps the results of compilers; $log the file for the output of steps.
# shellcheck shell=bash
# shellcheck disable=SC2034,SC2154
declare -rA codenames=([12]=bookworm [13]=trixie)

# inside ROOT COMMAND...: runs a command in a system, with /proc, /sys and /dev, in name spaces that end with it: no mount
# and no process of it remains.
inside() {
  # shellcheck disable=SC2016
  unshare --mount --pid --fork --kill-child bash -ec '
    root=$1 cache=$2
    shift 2
    mount -t proc proc "$root/proc"
    mount -t sysfs -o ro sysfs "$root/sys"
    mount --rbind /dev "$root/dev"
    mount -t tmpfs tmpfs "$root/dev/shm"
    if [[ -n $cache ]]; then
      mkdir -p "$root/root/.cache/ccache"
      mount --bind "$cache" "$root/root/.cache/ccache"
    fi
    exec chroot "$root" env -u TMPDIR -u CCACHE_DIR -u XDG_CACHE_HOME HOME=/root LANG=C.UTF-8 \
      PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$@"
  ' inside "$1" "${cache:-}" "${@:2}" </dev/null
}

# The system reaches the network as this machine does: name servers, certificates, settings of apt and pip. Its own name
# is that of every installation.
copy_settings() {
  local root=$1 file
  printf '127.0.0.1 localhost\n::1 localhost\n' >"$root/etc/hosts"
  cp --dereference /etc/resolv.conf "$root/etc/" &&
    apt-config dump | grep '^Acquire::' >"$root/etc/apt/apt.conf.d/90machine" &&
    for file in /usr/local/share/ca-certificates /etc/pip.conf; do
      [[ ! -e $file ]] || cp -rT "$file" "$root$file" || return 1
    done &&
    inside "$root" update-ca-certificates
}

# bare_system CODENAME ROOT [PACKAGES]: the smallest installation, with these packages, separated by commas.
bare_system() {
  debootstrap --variant=minbase --arch="$architecture" --include="ca-certificates${3:+,$3}" "$1" "$2" &&
    copy_settings "$2"
}

# Ends the script unless systems can be made.
require_systems() {
  if [[ $(id -u) != 0 ]]; then
    complain "root is required, to mount /proc, /sys and /dev in each system; run it with sudo"
    exit 1
  fi
  if ! command -v debootstrap >/dev/null; then
    complain "debootstrap is missing; install it with: apt-get install debootstrap"
    exit 1
  fi
}

# Ends the script unless each of these is a known release.
require_releases() {
  local release
  for release in "$@"; do
    [[ ! -v codenames[$release] ]] || continue
    complain "unknown release '$release' of Debian; there are: ${!codenames[*]}"
    exit 2
  done
}

failures=0
# step NAME COMMAND...: runs it with the log; prints whether it passes, and its seconds, and counts failures.
step() {
  local name=$1 result=ok
  shift
  SECONDS=0
  "$@" >>"$log" 2>&1 || result=FAILED
  printf '%-10s%6d s  %s\n' "$result" "$SECONDS" "$name"
  [[ $result == ok ]] || failures=$((failures + 1))
  [[ $result == ok ]]
}
