#pragma once

#include <cstddef>
#include <string>

#include "command_line.h"
#include "somato/core/result.h"

namespace somato::program {

/// The part of a sweep's points that one run computes: point `number`, counted from 1, and every
/// `of`-th point after it.
struct SweepPart {
  std::size_t number = 1;
  std::size_t of = 1;
  std::string given_by = {};  ///< "SLURM_ARRAY_TASK_ID = 3", or empty.

  bool is_whole() const { return of == 1; }
  /// "3-of-7".
  std::string folder_name() const;
};

/// Reads --part, or if it is not given the environment of a Slurm array task: the tasks in their
/// order are the parts. Errors (kUsage): an invalid part, and task numbers without equal steps.
Result<SweepPart> read_sweep_part(const Arguments& arguments);

}  // namespace somato::program
