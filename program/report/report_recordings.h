#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "reproduce/reproduction_recordings.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "views/report/report.h"

namespace somato::program {

/// The existing recordings in the folder of a results.json and in its folder `recordings`.
std::vector<GivenRecordings> recordings_beside(const std::filesystem::path& results);

/// Recordings for results, identified by their content.
class ReportRecordings {
 public:
  /// Adds a recording, a folder of recordings, or data sets named by the user, which are searched
  /// first. Errors: those of GivenRecordings::at() and of reading them.
  Result<void> add_named(const std::string& path);

  /// Adds a table named by the user, as each of the results' studies reads it. Errors: those of
  /// reading it, if no study can.
  Result<void> add_table(const std::string& path, const std::vector<ReportFile>& files);

  /// Adds recordings_beside(): unreadable ones are skipped, and each is only read when it is
  /// needed.
  void add_beside(const std::filesystem::path& results);

  /// The recording with that content_hash(), or nullptr.
  std::shared_ptr<const Recording> find(const std::string& hash);

  /// The path of a recording that find() has found, as a command in the working folder names it.
  std::string path(const std::string& hash) const;

 private:
  struct Place {
    std::size_t given;
    std::size_t number;
  };

  Result<std::string> look_at(Place place);
  std::shared_ptr<const Recording> take(Place place);

  std::vector<GivenRecordings> given_;
  std::vector<Place> unread_;
  std::map<std::string, Place> known_;
};

}  // namespace somato::program
