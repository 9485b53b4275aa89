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
names=()
processes=()
printed=$(mktemp -d)
trap 'rm -rf "$printed"' EXIT

# check NAME COMMAND...: starts the check beside the others.
check() {
  local number=${#names[@]}
  names+=("$1")
  shift
  "$@" >"$printed/$number" 2>&1 &
  processes+=($!)
}

# Waits for the checks that were started, and prints what each of them has printed.
finish_checks() {
  local number
  for number in "${!names[@]}"; do
    if wait "${processes[number]}"; then
      cat "$printed/$number"
      echo "ok: ${names[number]}"
    else
      cat "$printed/$number" >&2
      echo "FAILED: ${names[number]}" >&2
      failed+=("${names[number]}")
    fi
  done
  names=()
  processes=()
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
  listed '*.h' '*.cc' | xargs -r -P "$(nproc)" -n 50 clang-format-19 "${format[@]}"
}

scripts/setup.sh build test

check 'format' check_format
check 'rooms' python3 scripts/check_rooms.py
check 'includes' python3 scripts/check_includes.py
check 'names of a wing' python3 scripts/check_names.py
check 'mirrored tests' python3 scripts/check_mirrors.py
check 'recipes' python3 scripts/recipes.py --check
check 'house rules' python3 scripts/check_text.py
check 'types of the pages' python3 scripts/page_types.py --check
check 'metrics of the pages' python3 scripts/page_metrics.py --check
check 'pages of the headers' python3 scripts/header_pages.py --check
check 'shell scripts' check_shell
finish_checks
# It uses all cores itself, and with --fix it changes files, as clang-format does.
check 'clang-tidy of changed files' python3 scripts/run_clang_tidy.py --changed "${fix[@]}"
finish_checks

if [[ ${#failed[@]} -gt 0 ]]; then
  printf 'lint: failed: %s\n' "${failed[*]}" >&2
  exit 1
fi
