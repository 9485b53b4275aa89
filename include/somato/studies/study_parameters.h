#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/graph/system_description.h"
#include "somato/recording/format.h"
#include "somato/studies/alteration.h"

namespace somato {

/// Division into training and test explorations.
enum class Protocol {
  kTrainIsTest,        ///< All for both, as in the papers: it measures memory, not generalization.
  kLeaveOneOut,        ///< Each exploration in turn is tested by a system trained on the others.
  kLeaveGroupOut,      ///< The same with all explorations that share a label.
  kLeaveClassOut,      ///< Each class in turn is unknown to a system trained on the others, of
                       ///< which some explorations are held out.
  kFolds,              ///< The same with equal parts, with each class distributed over all of them.
  kObjectAfterObject,  ///< The parts of kFolds; classes are learned one after another.
  kTestData,  ///< A separate test recording is tested by a system trained on the complete other
              ///< recording.
};

template <>
struct Choices<Protocol> {
  static const std::vector<std::pair<Protocol, std::string>>& all();
};

/// The choice of the explorations of a class that are tested together by k_folds, and by the
/// protocols that use its parts.
enum class FoldChoice {
  kBlocks,       ///< Consecutive ones, in the order of the recording.
  kInterleaved,  ///< Drawn at random, so that neighbours are in different parts.
};

template <>
struct Choices<FoldChoice> {
  static const std::vector<std::pair<FoldChoice, std::string>>& all();
};

/// The explorations of an object that are kept for replay.
enum class ReplayChoice {
  kRandom,         ///< Drawn at random.
  kFirst,          ///< The first of the recording.
  kNearestToMean,  ///< Those nearest to the mean of the object.
  kMostDistant,    ///< The one nearest to the mean, then those most distant from those chosen.
};

template <>
struct Choices<ReplayChoice> {
  static const std::vector<std::pair<ReplayChoice, std::string>>& all();
};

/// The labels, protocols and seeds of a study.
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
  std::string recall;
  std::vector<std::string> predictions;
  std::vector<Protocol> protocols{Protocol::kTrainIsTest, Protocol::kLeaveOneOut};
  std::vector<std::string> groups;
  std::size_t folds = 10;
  FoldChoice fold_choice = FoldChoice::kBlocks;
  std::size_t test_last = 0;
  std::size_t replay_per_object = 0;
  ReplayChoice replay_choice = ReplayChoice::kRandom;
  std::size_t generated_per_object = 0;
  double generated_spread = 0.1;
  bool unknown = false;
  double false_alarm_rate = 0.05;
  std::size_t calibration_folds = 5;
  std::optional<double> whitening_shrinkage;
  std::size_t taught_per_class = 0;
  std::size_t seeds = 20;
  std::uint64_t first_seed = 1;
  std::size_t wrong_groupings = 20;

  /// Whether the study has this protocol.
  bool has(Protocol protocol) const;

  static const Declarations<StudyParameters>& declarations();
};

/// A complete study, as described by its TOML file.
struct StudyDescription {
  std::string where = {};  ///< `FILE:LINE` of [study], or another location.
  std::string text = {};   ///< The text of its file, for the results; empty: to_toml().
  StudyParameters study;
  RecordingParameters recording;
  std::vector<Alteration> altered = {};  ///< Alterations of the test explorations.
  SystemDescription system;
};

/// Reads a study from the tables [study], [recording] and [altered.NAME] and those of its system
/// (see read_system()). Errors (kUsage) with their location: unknown tables or keys (with the
/// nearest known one), values out of range, no name, no protocols, a protocol without its required
/// settings.
Result<StudyDescription> read_study(const Table& file);

/// Gives the parameters that none of the study's protocols reads their defaults, except those named
/// `given`: after the protocols of a study were changed, those of its file may have no effect.
void reset_unread(StudyParameters& study, const std::vector<std::string>& given);

/// The study as TOML that is read back to the same study: tables [study], [recording] and
/// [altered.NAME] without defaults, then its system.
std::string to_toml(const StudyDescription& description);

}  // namespace somato
