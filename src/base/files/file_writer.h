#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato {

class Replacement;

/// New content for a file, written incrementally, that replaces the file atomically, like
/// save_whole(): for content that does not fit into memory. Without commit() nothing changes,
/// except that a file that is not regular (`/dev/stdout`, a pipe) is written directly.
class FileWriter {
 public:
  /// Errors: kSystem with the system's reason.
  static Result<FileWriter> begin(const std::string& path);

  FileWriter(const FileWriter&) = delete;
  FileWriter(FileWriter&& other) noexcept;
  FileWriter& operator=(const FileWriter&) = delete;
  FileWriter& operator=(FileWriter&& other) noexcept;
  ~FileWriter();

  /// Errors: kSystem with the system's reason.
  Result<void> write(std::string_view bytes);

  /// Gives the new content the name; nothing comes after it. Errors: kSystem with the system's
  /// reason.
  Result<void> commit();

 private:
  explicit FileWriter(std::unique_ptr<Replacement> replacement);

  std::unique_ptr<Replacement> replacement_;
};

}  // namespace somato
