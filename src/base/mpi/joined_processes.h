#pragma once

#include <cstddef>

#include "somato/core/process_group.h"

namespace somato {

/// The processes that a launcher such as mpiexec has started together. Implemented by a separate
/// library, which the program loads when it finds itself among such processes, so that no other
/// user depends on MPI.
class JoinedProcesses : public ProcessGroup {
 public:
  /// The number of them on this machine.
  virtual std::size_t on_this_machine() const = 0;

  /// Ends the group; every process must call it. Nothing comes after it.
  virtual void leave() = 0;

  /// Ends all processes with this exit code, because this one cannot continue.
  virtual void end_all(int exit_code) = 0;
};

/// The function of that library that joins them; the result is valid until the program ends.
using JoinProcesses = JoinedProcesses* (*)();
inline constexpr const char* kJoinProcesses = "somato_join_processes";

}  // namespace somato
