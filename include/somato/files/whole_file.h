#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato {

class FileSystem;

/// The largest file that is read, in bytes (4 GiB): what a file claims is not trusted without end.
inline constexpr std::size_t kLargestFile = std::size_t{4} << 30;

/// All bytes of the file at `path` (a pipe or device too, until it ends).
/// Errors: kSystem with the system's reason (missing, unreadable, a folder); kData when there are
/// more than `limit` bytes.
Result<std::string> read_whole(const std::string& path, std::size_t limit = kLargestFile);

/// Makes `bytes` the content of the file at `path`, wholly or not at all.
///
/// The bytes go to a new file in the same folder, which is flushed to the disk and then takes the
/// name: whatever happens, even a power cut, `path` is the old file or the new one. A failure
/// removes the new file again; only a process that is killed can leave one behind
/// (`.somato-PROCESS-NUMBER.partial`). Permissions of an existing file are kept; a file that is
/// write-protected is refused. A symbolic link is followed. What is not a regular file
/// (`/dev/stdout`, a pipe) is written to directly.
/// Errors: kSystem with the system's reason.
Result<void> save_whole(const std::string& path, std::string_view bytes);

namespace detail {

/// The same on the given file system, for tests.
Result<std::string> read_whole(FileSystem& files, const std::string& path, std::size_t limit);
Result<void> save_whole(FileSystem& files, const std::string& path, std::string_view bytes);

}  // namespace detail

}  // namespace somato
