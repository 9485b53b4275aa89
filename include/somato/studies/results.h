#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace somato {

/// Values, each with how often it occurred.
using Distribution = std::map<double, std::size_t>;

/// A figure over seeds: one value a seed, in the order of the seeds. docs/reference/results.md
/// defines each metric.
struct Metric {
  std::string name;
  std::vector<double> values;
  /// Of a metric `_by_luck`: for each seed the values of which `values` has the mean, one for each
  /// wrong grouping or shuffling. Empty for other metrics, and where a file does not have them.
  std::vector<Distribution> of_each = {};

  double mean() const;
  /// The sample standard deviation (divided by the count less one); 0 for a single value.
  double standard_deviation() const;
};

/// What one seed gave, sample by sample in the order of the recording.
struct Run {
  std::uint64_t seed = 0;
  std::vector<std::size_t> winners;      ///< On the map that was tested with the sample.
  std::vector<std::string> labels;       ///< The true classes.
  std::vector<std::string> predictions;  ///< The classes the map named.
  /// The same for further labels, by their names.
  std::vector<std::pair<std::string, std::vector<std::string>>> other_predictions;
};

/// A system under one protocol.
struct SystemResults {
  std::string name;
  std::string protocol;
  std::string group;  ///< Of leave_group_out.
  std::string label;
  std::size_t samples = 0;
  std::vector<Metric> metrics;
  std::vector<Run> runs;

  /// The metric of that name, or nullptr.
  const Metric* find_metric(std::string_view metric) const;
};

/// A parameter with its value as TOML writes it.
struct Setting {
  std::string name;
  std::string value;
};

/// The parameters of one part of the study.
struct Settings {
  std::string part;
  std::vector<Setting> settings;
};

/// What a study found: the content of results.json.
struct StudyResults {
  std::string study;
  std::size_t seeds = 0;
  std::vector<Settings> settings;
  std::string data_hash;
  std::string test_data_hash;  ///< Of the recording for test_data; empty without one.
  std::vector<SystemResults> systems;
};

/// The results as results.json, version 3; the same bytes for the same results.
std::string to_json(const StudyResults& results);

}  // namespace somato
