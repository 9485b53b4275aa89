#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato {

class FileSystem;

/// The maximum size of a file that is read, in bytes (4 GiB).
inline constexpr std::size_t kLargestFile = std::size_t{4} << 30;

/// All bytes of the file at `path` (a pipe or device too, until it ends).
/// Errors: kSystem with the system's reason (missing, unreadable, a folder); kData when there are
/// more than `limit` bytes.
Result<std::string> read_whole(const std::string& path, std::size_t limit = kLargestFile);

/// Makes `bytes` the content of the file at `path`, atomically.
///
/// The bytes are written to a new file in the same folder, which is flushed to the disk and then
/// renamed: in all cases, including a power failure, `path` is the old file or the new one. On
/// failure the new file is removed; only a killed process can leave one behind
/// (`.somato-PROCESS-NUMBER.partial`). Permissions of an existing file are kept; a write-protected
/// file is refused. A symbolic link is followed. A file that is not regular (`/dev/stdout`, a pipe)
/// is written directly. Errors: kSystem with the system's reason.
Result<void> save_whole(const std::string& path, std::string_view bytes);

namespace detail {

/// The same on the given file system, for tests.
Result<std::string> read_whole(FileSystem& files, const std::string& path, std::size_t limit);
Result<void> save_whole(FileSystem& files, const std::string& path, std::string_view bytes);

}  // namespace detail

}  // namespace somato
