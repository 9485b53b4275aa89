#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include "flags/command_line.h"
#include "somato/core/result.h"
#include "somato/studies/study.h"
#include "terminal/folder_lock.h"

namespace somato::program {

/// The part of a command's work that one run does: unit `number`, counted from 1, and every
/// `of`-th after it. Units are the points of a sweep or the trainings of studies.
struct Part : StudyPart {
  std::string given_by = {};  ///< "SLURM_ARRAY_TASK_ID = 3", or empty.
};

/// The flag `--part`; `unit` is such as "point".
Flag part_flag(const std::string& unit);

/// Reads --part, or if it is not given the environment of a Slurm array task: the tasks in their
/// order are the parts. Errors (kUsage): an invalid part, and task numbers without equal steps.
Result<Part> read_part(const Arguments& arguments);

/// The folder that contains the folders of all parts of the work with results in `out`.
std::filesystem::path parts_folder(const std::filesystem::path& out);

/// Locks the folder `out`, or that of the part, which is created, against other runs. Errors:
/// kSystem.
Result<FolderLock> lock_work(const std::filesystem::path& out, const Part& part);

/// "Part 3 of 7 (SLURM_ARRAY_TASK_ID = 3) is done."; empty without parts.
std::string part_text(const Part& part);

/// Reports that this part is done and units of other parts are missing: `done` of `total`. `file`
/// is written by the last part.
void print_part(const Arguments& arguments, const Part& part,
                std::pair<std::size_t, std::size_t> done_of, const std::string& unit,
                const std::string& file);

}  // namespace somato::program
