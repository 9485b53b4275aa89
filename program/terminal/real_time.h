#pragma once

#include "somato/core/result.h"

namespace somato::program {

/// The real-time priority (SCHED_FIFO) of `somato live --realtime`: above the programs of users,
/// below the interrupt threads of a real-time kernel (50), which deliver the bytes that are read.
inline constexpr int kRealTimePriority = 40;

/// Locks the memory of the program, also what it will allocate, and checks that its threads may
/// take the real-time priority. Errors (kSystem) say which permissions are missing, and how a user
/// or a unit of systemd gets them; nothing is locked then.
Result<void> prepare_real_time();

/// Gives the real-time priority to the calling thread, but not to threads that it starts. Only
/// after prepare_real_time().
void take_real_time_priority();

}  // namespace somato::program
