#!/usr/bin/env bash
# Checks format, project rules, and changed files with clang-tidy; with --fix, clang-format and
# clang-tidy correct the files. scripts/run_clang_tidy.py checks all files.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1:-} in
  '') fix=() format=(--dry-run --Werror) ;;
  --fix) fix=(--fix) format=(-i) ;;
  *)
    echo "lint: unknown option '$1'; did you mean '--fix'?" >&2
    exit 2
    ;;
esac

failed=()

# check NAME COMMAND...
check() {
  local name=$1
  shift
  if "$@"; then
    echo "ok: $name"
  else
    echo "FAILED: $name" >&2
    failed+=("$name")
  fi
}

listed() {
  git ls-files --cached --others --exclude-standard -- "$@"
}

check_shell() {
  local scripts
  mapfile -t scripts < <(listed dev '*.sh' .ci/run)
  shellcheck "${scripts[@]}"
}

check_format() {
  listed '*.h' '*.cc' | xargs -r clang-format-19 "${format[@]}"
}

scripts/setup.sh build test

check 'format' check_format
check 'include table' python3 scripts/check_includes.py
check 'mirrored tests' python3 scripts/check_mirrors.py
check 'house rules' python3 scripts/check_text.py
check 'types of the pages' python3 scripts/page_types.py --check
check 'shell scripts' check_shell
check 'clang-tidy of changed files' python3 scripts/run_clang_tidy.py --changed "${fix[@]}"

if [[ ${#failed[@]} -gt 0 ]]; then
  printf 'lint: failed: %s\n' "${failed[*]}" >&2
  exit 1
fi
