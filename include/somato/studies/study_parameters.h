#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/graph/system_description.h"
#include "somato/recording/format.h"
#include "somato/studies/protocol.h"

namespace somato {

/// What is asked, and how often.
struct StudyParameters {
  std::string name;
  std::string label = "object";
  std::vector<std::string> only;
  std::vector<std::string> labels;
  std::string individual;
  std::string order;
  std::string within;
  std::vector<std::string> mapped_with;
  std::string map;
  std::vector<Protocol> protocols{Protocol::kTrainIsTest, Protocol::kLeaveOneOut};
  std::vector<std::string> groups;
  std::size_t folds = 10;
  std::size_t seeds = 20;
  std::uint64_t first_seed = 1;
  std::size_t wrong_groupings = 20;

  static const Declarations<StudyParameters>& declarations();
};

/// Where the samples come from.
struct RecordingParameters {
  RecordingFormat format = RecordingFormat::kAutomatic;

  static const Declarations<RecordingParameters>& declarations();
};

/// A whole study, as its TOML file describes it.
struct StudyDescription {
  std::string where = {};  ///< `file:line` of [study], or another place to point at.
  StudyParameters study;
  RecordingParameters recording;
  SystemDescription system;
};

/// Reads a study from the tables [study] and [recording] and those of its system (see
/// read_system()). Errors (kUsage) with their place: unknown tables or keys (with the nearest known
/// one), values out of range, no name, no protocols, a protocol without what it needs.
Result<StudyDescription> read_study(const Table& file);

}  // namespace somato
