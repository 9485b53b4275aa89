#pragma once

#include <cstddef>
#include <string>

#include "base/files/open_file.h"
#include "somato/core/result.h"

namespace somato {

/// The name of the file that grows beside `path` until it is complete.
std::string partial_path(const std::string& path);

/// The command that recovers the recording in the partial file of `path`.
std::string recover_command(const std::string& path);

/// Creates the partial file of `path` and locks it until it is closed. One that an earlier process
/// left is used again if it has at most `empty` bytes, that is, no data. Errors (kUsage): another
/// process writes it, or it has data, which are not touched; kSystem with the system's reason.
Result<OpenFile> create_partial_file(FileSystem& files, const std::string& path, std::size_t empty);

}  // namespace somato
