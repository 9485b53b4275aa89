#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/result.h"

namespace somato::program {

/// Creates a folder and its parents. Errors: kSystem, with advice to change `flag`.
Result<void> make_folder(const std::filesystem::path& path, const std::string& flag = "--out");

/// The folder for the results of a study, created before the work begins, so that an hour of
/// training does not end at a missing folder. A created folder is removed if it remains empty.
class OutputFolder {
 public:
  /// `flag` names the folder, for messages.
  OutputFolder(std::filesystem::path path, std::string flag)
      : path_(std::move(path)), flag_(std::move(flag)) {}
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder(OutputFolder&&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  OutputFolder& operator=(OutputFolder&&) = delete;
  ~OutputFolder();

  /// Errors (kSystem): it cannot be created, or one of its files cannot be written.
  Result<void> make();

  /// The names of the files written to it.
  static std::vector<std::string> names() {
    return {"results.json", "map.svg", kSystem, "unfinished.journal"};
  }
  static constexpr const char* kSystem = "system.somato";

  const std::filesystem::path& path() const { return path_; }
  std::string results() const { return (path_ / "results.json").string(); }
  std::string map() const { return (path_ / "map.svg").string(); }
  std::string system() const { return (path_ / kSystem).string(); }
  std::string journal() const { return (path_ / "unfinished.journal").string(); }

 private:
  std::filesystem::path path_;
  std::string flag_;
  std::vector<std::filesystem::path> made_;  // innermost first
};

}  // namespace somato::program
