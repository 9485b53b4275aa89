#pragma once

#include <vector>

#include "explore/exploring_body.h"
#include "flags/command_line.h"

namespace somato::program {

/// The flags `--topics`, `--channels`, `--things` and `--duration`.
std::vector<Flag> topic_flags();

/// Errors (kUsage): a flag that has no effect without `--topics`, or with it.
Result<void> check_topic_flags(const Arguments& arguments);

/// The topics of a robot at the address `--topics`. A person places each thing of `--things`;
/// without that flag the only thing is "unknown", and is there already. Errors (kUsage): the flags;
/// the program was built without topics.
Result<BodySession> topic_session(const Arguments& arguments);

}  // namespace somato::program
