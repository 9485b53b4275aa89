#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "somato/core/result.h"

namespace somato {

/// A folder that appears at its path with all its files, or not at all. Its files are written into
/// a folder beside it, which only a killed process can leave behind
/// (`.somato-PROCESS-NUMBER.partial`).
class NewFolder {
 public:
  /// Errors: kSystem with the system's reason, also if something is at the path.
  static Result<NewFolder> begin(const std::filesystem::path& path);

  NewFolder(const NewFolder&) = delete;
  NewFolder(NewFolder&& other) noexcept
      : path_(std::move(other.path_)), beside_(std::exchange(other.beside_, {})) {}
  NewFolder& operator=(const NewFolder&) = delete;
  NewFolder& operator=(NewFolder&&) = delete;
  ~NewFolder();

  /// The path at which to write the file of that name.
  std::string file(const std::string& name) const { return (beside_ / name).string(); }

  /// Moves the folder to its path. Errors: kSystem with the system's reason.
  Result<void> commit();

 private:
  NewFolder(std::filesystem::path path, std::filesystem::path beside)
      : path_(std::move(path)), beside_(std::move(beside)) {}

  std::filesystem::path path_;
  std::filesystem::path beside_;  // Empty once it has been moved.
};

}  // namespace somato
