#!/bin/sh
# cached_compiler.sh CCACHE CHECKOUT COMPILER ARGUMENT...: compiles with the compiler's cache.
# A precompiled header contains the paths of the checkout, so each checkout compiles its own. For its users
# ccache reads a file beside it, with a hash of the compiler, the options and the headers, which is the same in all checkouts.
set -eu
ccache=$1 checkout=$2
shift 2

is_header() {
  case " $* " in
    *' -x c++-header '* | *' -emit-pch '*) return 0 ;;
  esac
  return 1
}

# value_after OPTION ARGUMENT...
value_after() {
  wanted=$1
  shift
  while [ "$1" != "$wanted" ]; do shift; done
  echo "$2"
}

headers_in() {
  sed 's/^[^:]*://; s/\\$//' "$1" | tr -s ' ' '\n' | sed '/^$/d' | sort -u
}

if is_header "$@"; then
  "$@"
  {
    "$1" --version
    echo "$*"
    headers_in "$(value_after -MF "$@")" | xargs sha256sum
    # Sorted without the paths of the checkout, of which the order would otherwise depend on them.
  } | sed "s|$PWD||g; s|$checkout||g" | sort | sha256sum >"$(value_after -o "$@").sum"
  exit 0
fi

# What a source includes is known from the compiler's own list of dependencies, so that no source is preprocessed for the cache.
export CCACHE_BASEDIR="$checkout" CCACHE_PCH_EXTSUM=1 CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
exec "$ccache" "$@"
