#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/files/open_file.h"
#include "somato/core/result.h"

namespace somato {

/// A file that is read in parts, mostly sequentially.
class McapInput {
 public:
  /// Errors: kSystem with the system's reason; kUsage for a file that is not regular.
  static Result<McapInput> open(FileSystem& files, const std::string& path);

  const std::string& path() const { return path_; }
  std::size_t size() const { return size_; }

  /// The bytes from `place` on, `count` of them unless the file ends before; valid until the next
  /// call. Errors: kSystem with the system's reason.
  Result<std::string_view> view(std::size_t place, std::size_t count);

 private:
  McapInput(OpenFile file, std::string path, std::size_t size)
      : file_(std::move(file)), path_(std::move(path)), size_(size) {}

  OpenFile file_;
  std::string path_;
  std::size_t size_;
  std::string window_;
  std::size_t window_place_ = 0;
};

}  // namespace somato
