#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/explorations/given_names.h"
#include "recordings/mcap/mcap_records.h"
#include "somato/recording/recording.h"

namespace somato {

/// The profile in the header of a recording file. Later versions of the format will have a profile
/// such as `somato 2`, so that this one refuses their files.
inline constexpr std::string_view kRecordingProfile = "somato";
inline constexpr std::uint64_t kRecordingVersion = 1;

/// Bytes of the longest message or metadata record about an exploration.
inline constexpr std::size_t kLongestExplorationText = std::size_t{256} << 10;

/// The metadata records of a recording file, which say something about an exploration after its
/// beginning was written; see docs/formats/recording.md.
class ExplorationNotes {
 public:
  /// Exploration `index` of the file has this label, in place of one of the same name.
  static McapMetadata label(std::uint64_t index, const Label& label);

  /// Exploration `index` of the file does not belong to the recording.
  static McapMetadata left_out(std::uint64_t index);

  /// Takes the next record of the file; returns false if it is none of these, or is not valid.
  bool add(const McapMetadata& metadata);

  bool is_left_out(std::uint64_t index) const { return left_out_.contains(index); }

  /// The labels of an exploration that began with `own`.
  std::vector<Label> labels(std::uint64_t index, std::vector<Label> own) const {
    return names_.labels(index, std::move(own));
  }

 private:
  GivenNames names_;
  std::set<std::uint64_t> left_out_;
};

}  // namespace somato
