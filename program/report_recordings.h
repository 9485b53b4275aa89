#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reproduction_recordings.h"
#include "somato/core/result.h"
#include "somato/report/report.h"

namespace somato::program {

/// The recordings in the folder of a results.json and in its folder `recordings`, of those that are
/// there.
std::vector<GivenRecordings> recordings_beside(const std::filesystem::path& results);

/// Recordings that results may be of, found by their content.
class ReportRecordings {
 public:
  /// Adds a recording, a folder of them, or data sets that somebody named. They are looked at
  /// first. Errors: those of GivenRecordings::at() and of reading them.
  Result<void> add_named(const std::string& path);

  /// Adds recordings_beside(): what cannot be read is passed over, and nothing is read before it is
  /// asked for.
  void add_beside(const std::filesystem::path& results);

  /// The one with that content_hash().
  ReportRecording find(const std::string& hash);

 private:
  struct Place {
    std::size_t given;
    std::size_t number;
  };

  Result<std::string> look_at(Place place);
  ReportRecording take(Place place);

  std::vector<GivenRecordings> given_;
  std::vector<Place> unread_;
  std::map<std::string, Place> known_;
};

}  // namespace somato::program
