#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato {

class Replacement;

/// New content for a file, written piece by piece, that takes the file's place wholly or not at
/// all, as save_whole() does: for more than fits into memory. Without commit() everything stays as
/// it was, except that what is not a regular file (`/dev/stdout`, a pipe) is written to directly.
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
