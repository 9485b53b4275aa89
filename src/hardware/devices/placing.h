#pragma once

#include <functional>
#include <string>

#include "somato/core/result.h"

namespace somato::devices {

/// Has the emulator at `port` place the thing with that name for a trial (from 0); see
/// emulation::PtyEmulator. Waits at most `timeout` seconds, and only while `should_continue`.
/// Errors (kSystem): no emulator there; (kData): it refuses, with its reason; (kInterrupted).
Result<void> place_by_emulator(const std::string& port, const std::string& thing, std::size_t trial,
                               double timeout, const std::function<bool()>& should_continue);

}  // namespace somato::devices
