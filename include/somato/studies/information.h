#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "somato/studies/study_parameters.h"

namespace somato {

/// What is asked of the vectors that reach a map.
struct InformationParameters {
  std::vector<std::string> labels{"object"};
  std::string individual;
  std::string order;
  std::string within;
  std::string map;
  std::size_t shuffles = 1000;
  std::uint64_t seed = 1;

  static const Declarations<InformationParameters>& declarations();
};

/// What vectors tell of one label. docs/reference/information.md defines each figure.
struct LabelInformation {
  std::string label;
  std::size_t classes = 0;
  double accuracy = 0.0;  ///< Of the nearest neighbour, each exploration left out in turn.
  double chance = 0.0;    ///< The same of a neighbour drawn at random.
  std::optional<double> accuracy_new_individuals;  ///< The nearest is one of another individual.
  std::optional<double> chance_new_individuals;
  std::optional<double> distance_ratio;  ///< Mean distance between classes to that within them.
};

/// How well vectors follow a number, such as a size.
struct OrderInformation {
  struct Group {
    std::string name;
    std::size_t individuals = 0;
    double correlation = 0.0;
  };
  std::vector<Group> groups;    ///< Those with three individuals of different numbers.
  double correlation = 0.0;     ///< The mean over the groups, 0 to 1.
  double shuffled = 0.0;        ///< The same of shuffled numbers.
  double shuffled_share = 1.0;  ///< Share of the shufflings that come as high.
};

/// How much the vectors tell before any map has seen them: what a map could at best show.
struct Information {
  std::string study;
  std::string data_hash;
  InformationParameters asked;
  std::string module;            ///< Which gives the vectors.
  std::size_t explorations = 0;  ///< One vector each.
  std::size_t elements = 0;      ///< Of a vector.
  std::vector<LabelInformation> labels;
  std::optional<OrderInformation> order;
};

/// Measures the vectors that the map of a study learns from, without any training; where a
/// standardization comes right before the map, what comes in at that. Keeps the distances of all
/// pairs: 8 bytes each. The same for any number of threads.
///
/// Errors: a recording that is not valid (kData) or lacks the channels or labels asked for
/// (kUsage); a system that cannot be built, has no map, or more than one that could be meant, or in
/// which modules learn before the map (kUsage); labels that tell nothing apart, an individual with
/// two numbers or in two groups, a label that is no number, no group with three numbers (kData).
Result<Information> measure_information(const StudyDescription& description,
                                        const Recording& recording,
                                        const InformationParameters& asked,
                                        std::size_t threads = 1);

/// As information.json, version 1; the same bytes for the same figures.
std::string to_json(const Information& information);

}  // namespace somato
