#!/usr/bin/env bash
# Runs a test and writes the processor time of its processes, as bash's `times` prints it:
#   with_processor_time.sh FILE COMMAND...
# Nothing is written if ctest kills the test after its time limit.
to=$1
shift
"$@"
status=$?
times >"$to"
exit "$status"
