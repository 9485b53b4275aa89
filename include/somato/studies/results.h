#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/maps/grid.h"
#include "somato/studies/claim.h"

namespace somato {

/// Values with their numbers of occurrences.
using Distribution = std::map<double, std::size_t>;

/// A measure over pairs of recording and seed: one value per pair. docs/reference/results.md
/// defines each metric.
struct Metric {
  std::string name;
  std::vector<double> values;
  /// For a metric `_chance`: for each pair the values whose mean is in `values`, one for each wrong
  /// grouping or shuffle. Empty for other metrics.
  std::vector<Distribution> of_each = {};

  double mean() const;
  /// The sample standard deviation (divided by the count minus one); 0 for a single value.
  double standard_deviation() const;
};

/// The map of a training.
struct TrainedMap {
  Grid grid;                                ///< For maps that grow, another one in each training.
  std::vector<double> u_matrix = {};        ///< See u_matrix().
  std::vector<double> edge_distances = {};  ///< See edge_distances().

  bool operator==(const TrainedMap&) const = default;
};

/// The results of one pair, by sample in the order of the recording.
struct Run {
  std::uint64_t seed = 0;
  std::vector<std::size_t> winners;      ///< On the map by which the sample was tested.
  std::vector<std::string> labels;       ///< The true classes.
  std::vector<std::string> predictions;  ///< The predicted classes.
  /// The predictions of further labels, by their names.
  std::vector<std::pair<std::string, std::vector<std::string>>> other_predictions;
  /// The map by which all samples were tested; empty if there were several.
  std::optional<TrainedMap> map = {};
};

/// How many of the same samples the maps of two fold choices name rightly, each trained with the
/// first seed of a recording; sums over the recordings.
struct FoldComparison {
  std::string choice;             ///< The fold choice of the study.
  std::string other;              ///< The one that it is compared with.
  std::size_t largest_block = 0;  ///< Explorations of a class that blocks test together, at most.
  std::size_t samples = 0;        ///< 0 if blocks of one exploration were not compared.
  std::size_t right = 0;          ///< Samples named rightly under the choice of the study.
  std::size_t other_right = 0;    ///< The same under the other choice.
  std::size_t only_right = 0;     ///< Named rightly under the choice of the study only.
  std::size_t only_other_right = 0;  ///< Named rightly under the other choice only.

  bool operator==(const FoldComparison&) const = default;
};

/// A system under one protocol.
struct ProtocolResults {
  std::string protocol;
  std::string group;  ///< The group that leave_group_out holds out.
  std::string label;
  std::size_t samples = 0;
  std::vector<Metric> metrics;
  std::vector<Run> runs;
  /// The number of folds that chose each kind of nearest neighbour for `best_neighbour_accuracy`,
  /// such as "manhattan, standardized".
  std::map<std::string, std::size_t> chosen_neighbours = {};
  std::optional<FoldComparison> fold_comparison =
      {};  ///< The comparison of fold choices, if there is one.

  /// The metric with that name, or nullptr.
  const Metric* find_metric(std::string_view metric) const;
};

/// A parameter with its value in TOML notation.
struct Setting {
  std::string name;
  std::string value;
};

/// The parameters of one part of a study, such as "module.map".
struct Settings {
  std::string part;
  std::vector<Setting> settings;
};

/// The parameters as a table of TOML, after an empty line.
std::string to_toml(const Settings& settings);

/// A recording used for training or testing.
struct RecordingInfo {
  std::string name;
  std::string source;      ///< The explorer, with engine and seed; "given" for a file.
  std::uint64_t seed = 0;  ///< The seed of the exploration; 0 for a given recording.
  std::string hash;        ///< See content_hash().
  std::size_t explorations = 0;

  bool operator==(const RecordingInfo&) const = default;
};

/// One training and test of a system: the number of the recording, among those of the part, and the
/// seed of the training.
struct Pair {
  std::size_t recording = 0;
  std::uint64_t seed = 0;
};

/// The file of a trained system, trained on all samples of the part's first recording.
struct ModelFile {
  std::string path;  ///< Relative to the folder of results.json.
  std::string hash;  ///< The hash of its bytes: `fnv1a64:` and 16 hexadecimal digits.
  std::uint64_t seed = 0;
};

/// A study that was run, and its results over all pairs of recording and seed.
struct PartResults {
  std::string question;              ///< The question it belongs to; empty: none.
  std::string system;                ///< Name of the study.
  std::string variation;             ///< Empty: the unchanged system.
  std::string study;                 ///< Its TOML; the seeds are those of `pairs`.
  std::vector<Settings> parameters;  ///< All of them, as resolved for the first recording.
  std::optional<ModelFile> model;    ///< Empty if none was saved.
  std::vector<RecordingInfo> recordings;
  std::vector<RecordingInfo>
      test_recordings;  ///< The recordings of test_data: one for each of `recordings`.
  std::vector<Pair> pairs;
  std::vector<ProtocolResults>
      protocols;  ///< Metrics with one value per pair, runs with one per pair.
};

/// A system that does not fit the given recordings.
struct NotApplicable {
  std::string system;
  std::string reason;
};

/// The results of one command: the content of results.json. A single study is one part.
struct Results {
  std::vector<PartResults> parts;
  std::vector<ClaimOutcome> claims;
  std::vector<NotApplicable> not_applicable;
};

/// The results as results.json, version kResultsVersion; the same bytes for the same results.
std::string to_json(const Results& results);

/// The version of the format of results.json.
inline constexpr std::uint64_t kResultsVersion = 4;

}  // namespace somato
