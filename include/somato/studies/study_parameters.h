#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "somato/codes/standardization.h"
#include "somato/core/parameter.h"
#include "somato/maps/som_parameters.h"
#include "somato/recording/format.h"
#include "somato/studies/protocol.h"

namespace somato {

/// What is asked, and how often.
struct StudyParameters {
  std::string name;
  std::string label = "object";
  std::string individual;
  std::vector<Protocol> protocols{Protocol::kTrainIsTest, Protocol::kLeaveOneOut};
  std::size_t seeds = 20;
  std::uint64_t first_seed = 1;
  std::size_t wrong_groupings = 20;

  static const Declarations<StudyParameters>& declarations();
};

/// Where the samples come from.
struct RecordingParameters {
  RecordingFormat format = RecordingFormat::kIcubGrasp;

  static const Declarations<RecordingParameters>& declarations();
};

/// Which frames of an exploration make its vector.
enum class FrameChoice {
  kFirst,   ///< The first frame.
  kLast,    ///< The last frame.
  kChange,  ///< The last frame less the first: what happened during the exploration.
};

/// How an exploration becomes the map's input.
struct VectorParameters {
  std::vector<std::string> channels;
  FrameChoice frames = FrameChoice::kLast;
  bool standardize = true;
  ConstantColumns constant_columns = ConstantColumns::kRefuse;

  static const Declarations<VectorParameters>& declarations();
};

template <>
struct Choices<FrameChoice> {
  static const std::vector<std::pair<FrameChoice, std::string>>& all();
};

/// A whole study, as its TOML file describes it: a table for each part.
struct StudyDescription {
  StudyParameters study;
  RecordingParameters recording;
  VectorParameters vector;
  SomParameters map;
};

/// Reads a study from the tables [study], [recording], [vector] and [map]. Errors (kUsage) with
/// their place: unknown tables or keys (with the nearest known one), values out of range, no name,
/// no channels, no protocols.
Result<StudyDescription> read_study(const Table& file);

}  // namespace somato
