#pragma once

#include "flags/command_line.h"
#include "reproduce/match_run.h"
#include "somato/core/result.h"

namespace somato::program {

/// Fits a body to the recording of --match: simulates the draws of --over, and if no other part
/// has draws left, writes the results and prints them. Errors (kUsage): flags, tables and keys that
/// have no effect; several systems; those of reading the files. Others: those of MatchRun.
Result<void> run_match(const Arguments& arguments);

}  // namespace somato::program
