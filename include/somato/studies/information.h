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

/// Parameters of the measures of a map's input vectors.
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

/// Information of the vectors about one label. docs/reference/information.md defines each measure.
struct LabelInformation {
  std::string label;
  std::size_t classes = 0;
  double accuracy =
      0.0;  ///< The nearest neighbour's accuracy, with each exploration left out in turn.
  double chance = 0.0;  ///< The same for a randomly drawn neighbour.
  std::optional<double>
      accuracy_new_individuals;  ///< For the nearest exploration of another individual.
  std::optional<double> chance_new_individuals;
  std::optional<double>
      distance_ratio;  ///< Mean distance between classes divided by that within classes.
  /// The share of the variance of each element of the vectors that lies between the classes, 0 to 1
  /// (the correlation ratio; Fisher 1925); 0 for an element with a single value.
  std::vector<double> explained = {};
};

/// The correlation of the vectors with a number, such as a size.
struct OrderInformation {
  /// The correlation within a group of individuals.
  struct Group {
    std::string name;
    std::size_t individuals = 0;
    double correlation = 0.0;
  };
  std::vector<Group> groups;    ///< Number of groups with three individuals of different numbers.
  double correlation = 0.0;     ///< The mean over the groups, 0 to 1.
  double shuffled = 0.0;        ///< The same for shuffled numbers.
  double shuffled_share = 1.0;  ///< Share of the shuffles with an equal or higher value.
};

/// Information in the vectors before any map: an upper limit for a map.
struct Information {
  std::string study;
  std::string data_hash;
  InformationParameters parameters;
  std::string module;                      ///< The module whose output the vectors are.
  std::size_t explorations = 0;            ///< One vector each.
  std::size_t elements = 0;                ///< The length of a vector.
  std::vector<std::string> element_names;  ///< One for each.
  std::vector<LabelInformation> labels;
  std::optional<OrderInformation> order;
};

/// Measures the vectors from which the map of a study learns, without any training; if a
/// standardization is directly before the map, the input of the standardization. Stores the
/// distances of all pairs: 8 bytes each. The result is the same for any number of threads.
///
/// Errors: a recording that is not valid (kData) or lacks the required channels or labels (kUsage);
/// a system that cannot be built, has no map, or an ambiguous one, or in which modules learn before
/// the map (kUsage); labels with a single value, an individual with two numbers or in two groups, a
/// label that is not a number, no group with three numbers (kData).
Result<Information> measure_information(const StudyDescription& description,
                                        const Recording& recording,
                                        const InformationParameters& parameters,
                                        std::size_t threads = 1);

/// As information.json, version 1; the same bytes for the same measures.
std::string to_json(const Information& information);

}  // namespace somato
