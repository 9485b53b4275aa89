#pragma once

#include <cstddef>
#include <string>

#include "base/mpi/joined_processes.h"
#include "flags/command_line.h"
#include "somato/core/result.h"

namespace somato::program {

/// The processes that run a command together, or only this one.
class Processes {
 public:
  /// Joins the processes that a launcher of MPI has started; from then on only the first prints.
  /// Errors (kSystem): there are several, and this program was built without MPI.
  static Result<Processes> join();

  /// nullptr: only this process.
  JoinedProcesses* group() const { return group_; }

  /// Ends the group and returns `done`, which the processes must agree on. A process that fails
  /// otherwise ends the others when it ends.
  Result<void> leave(Result<void> done) const;

 private:
  JoinedProcesses* group_ = nullptr;
};

/// The flag `--threads`, or all cores divided among the processes on this machine.
Result<std::size_t> threads_of(const Arguments& arguments, const JoinedProcesses* processes);

/// Fails (kUsage) if a launcher of MPI has started several processes of the command, which would
/// all do the same.
Result<void> refuse_several_processes(const std::string& command);

}  // namespace somato::program
