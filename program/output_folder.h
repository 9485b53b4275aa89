#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/result.h"

namespace somato::program {

/// The folder for what a study finds, made before the work begins: an hour of training should not
/// end at a missing folder. A folder that was made goes again when nothing came to be in it.
class OutputFolder {
 public:
  /// `flag` is the one that names it, for messages.
  OutputFolder(std::filesystem::path path, std::string flag)
      : path_(std::move(path)), flag_(std::move(flag)) {}
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder(OutputFolder&&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  OutputFolder& operator=(OutputFolder&&) = delete;
  ~OutputFolder();

  /// Errors (kSystem): it cannot be made, or something stands in the place of one of its files.
  Result<void> make();

  /// The names of the files that come to be in it.
  static std::vector<std::string> names() {
    return {"results.json", "map.svg", "system.somato", "unfinished.journal"};
  }

  std::string results() const { return (path_ / "results.json").string(); }
  std::string map() const { return (path_ / "map.svg").string(); }
  std::string system() const { return (path_ / "system.somato").string(); }
  std::string journal() const { return (path_ / "unfinished.journal").string(); }

 private:
  std::filesystem::path path_;
  std::string flag_;
  std::vector<std::filesystem::path> made_;  // innermost first
};

}  // namespace somato::program
