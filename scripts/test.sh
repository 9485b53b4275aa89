#!/usr/bin/env bash
# Every test and check, stopping at the first stage that fails; a line a stage at the end.
set -euo pipefail
cd "$(dirname "$0")/.."

summary=()
stage='start'
started=0

finish() {
  local status=$?
  [[ $status == 0 ]] || summary+=("$(printf 'FAILED %5d s  %s' $((SECONDS - started)) "$stage")")
  printf '\n'
  printf '%s\n' "${summary[@]}"
}
trap finish EXIT

# run_stage NAME COMMAND...
run_stage() {
  stage=$1
  started=$SECONDS
  shift
  printf '\n== %s\n' "$stage"
  "$@"
  summary+=("$(printf 'ok     %5d s  %s' $((SECONDS - started)) "$stage")")
}

run_stage 'set-up' scripts/setup.sh build test
for preset in dev asan tsan; do
  run_stage "$preset: build" ./dev build "$preset"
  run_stage "$preset: tests" ctest --preset "$preset" -j "$(nproc)"
done
run_stage 'lint' scripts/lint.sh
