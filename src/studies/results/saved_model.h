#pragma once

#include <filesystem>
#include <string>

#include "somato/core/result.h"
#include "somato/graph/system_model.h"
#include "somato/studies/results.h"

namespace somato {

/// The hash of the bytes of a file: `fnv1a64:` and 16 hexadecimal digits. Errors: kSystem.
Result<std::string> hash_of_file(const std::string& path);

/// Saves the trained system of a study in a folder of results and records it in `results`. `path`
/// is relative to the folder. Errors: kSystem.
Result<void> save_model(const std::filesystem::path& folder, const std::string& path,
                        const SystemModel& model, PartResults& results);

}  // namespace somato
