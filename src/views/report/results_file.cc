#include "views/report/results_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "base/text/format_version.h"
#include "views/report/checked_json.h"

namespace somato {
namespace {

using detail::CheckedJson;

constexpr std::uint64_t kMostNeurons = (1U << 24U) - 1;
constexpr double kMostGroupings = 1e9;
constexpr double kRounding = 1e-9;
constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();

std::vector<std::string> texts(const CheckedJson& json) {
  std::vector<std::string> all;
  json.each([&](const CheckedJson& one) { all.push_back(one.text()); });
  return all;
}

std::string optional_text(const CheckedJson& json, const std::string& key) {
  return json.has(key) ? json.at(key).text() : std::string();
}

void expect_length(const CheckedJson& json, std::size_t length) {
  if (json.size() == length) return;
  json.refuse(fmt::format("has {} entries, but needs {}", json.size(), length));
}

// Values with how often they occurred: lists of two.
Distribution distribution_of(const CheckedJson& json) {
  Distribution distribution;
  json.each([&](const CheckedJson& entry) {
    std::vector<double> numbers;
    entry.each([&](const CheckedJson& number) { numbers.push_back(number.number()); });
    if (entry.ok()) expect_length(entry, 2);
    if (!entry.ok()) return;
    if (numbers[1] < 1.0 || numbers[1] > kMostGroupings || numbers[1] != std::floor(numbers[1])) {
      entry.refuse("does not state how often the value occurred");
      return;
    }
    distribution[numbers[0]] = static_cast<std::size_t>(numbers[1]);
  });
  if (json.ok() && distribution.empty()) json.refuse("has no value");
  return distribution;
}

Metric metric_of(const std::string& name, const CheckedJson& json, std::size_t runs) {
  Metric metric{name, {}};
  static_cast<void>(json.at("mean").number_or_nan());
  static_cast<void>(json.at("sd").number_or_nan());
  const CheckedJson values = json.at("values");
  values.each([&](const CheckedJson& value) { metric.values.push_back(value.number_or_nan()); });
  if (json.ok()) expect_length(values, runs);
  if (!json.has("of_each")) return metric;
  const CheckedJson of_each = json.at("of_each");
  of_each.each(
      [&](const CheckedJson& of_run) { metric.of_each.push_back(distribution_of(of_run)); });
  if (json.ok()) expect_length(of_each, runs);
  return metric;
}

std::vector<std::string> classes_of(const CheckedJson& json, std::size_t samples) {
  std::vector<std::string> names = texts(json);
  if (json.ok()) expect_length(json, samples);
  return names;
}

std::vector<double> numbers_of(const CheckedJson& json, std::size_t count) {
  std::vector<double> numbers;
  json.each([&](const CheckedJson& number) { numbers.push_back(number.number()); });
  if (json.ok()) expect_length(json, count);
  return numbers;
}

// Connected neurons of a map with `neurons` neurons.
std::vector<NeuronGraph::Edge> edges_of(const CheckedJson& json, std::size_t neurons) {
  std::set<NeuronGraph::Edge> edges;
  json.each([&](const CheckedJson& edge) {
    std::vector<std::size_t> ends;
    edge.each([&](const CheckedJson& end) { ends.push_back(end.whole(kAny)); });
    if (edge.ok()) expect_length(edge, 2);
    if (!edge.ok()) return;
    const bool is_edge = ends[0] < ends[1] && ends[1] < neurons;
    if (!is_edge || !edges.emplace(ends[0], ends[1]).second) edge.refuse("is not an edge");
  });
  return {edges.begin(), edges.end()};
}

Grid graph_of(const CheckedJson& json, std::size_t neurons) {
  const CheckedJson listed = json.at("edges");
  if (neurons == 0 || neurons > NeuronGraph::kMostNeurons) json.refuse("is no graph of neurons");
  std::vector<NeuronGraph::Edge> edges = edges_of(listed, neurons);
  if (!json.ok()) return {};
  return Grid(std::make_shared<const NeuronGraph>(neurons, std::move(edges)));
}

// The cells of a graph follow from its edges.
Grid grid_of(const CheckedJson& json) {
  const std::size_t rows = json.at("rows").whole(kMostNeurons);
  const std::size_t columns = json.at("columns").whole(kMostNeurons);
  const auto lattice = choice_named<Lattice>("lattice", json.at("lattice").text(), {});
  const auto topology = choice_named<Topology>("topology", json.at("topology").text(), {});
  if (!json.ok()) return {};
  if (json.has("edges")) return graph_of(json, columns);
  if (lattice && topology && Grid::validate(rows, columns, *lattice, *topology)) {
    return {rows, columns, *lattice, *topology};
  }
  json.refuse("is no grid of a map");
  return {};
}

// A map by which samples with these winners were tested.
TrainedMap map_of(const CheckedJson& json, const std::vector<std::size_t>& winners) {
  TrainedMap map{grid_of(json.at("grid"))};
  if (!json.ok()) return map;
  map.u_matrix = numbers_of(json.at("u_matrix"), map.grid.size());
  if (map.grid.graph()) {
    map.edge_distances = numbers_of(json.at("edge_distances"), map.grid.graph()->edges().size());
  }
  const auto most = std::max_element(winners.begin(), winners.end());
  if (json.ok() && most != winners.end() && *most >= map.grid.size()) {
    json.refuse(fmt::format("has no neuron {}, which is a winner", *most));
  }
  return map;
}

Run run_of(const CheckedJson& json, std::size_t samples) {
  Run run;
  run.seed = json.at("seed").whole(kAny);
  const CheckedJson winners = json.at("winners");
  winners.each(
      [&](const CheckedJson& winner) { run.winners.push_back(winner.whole(kMostNeurons)); });
  if (json.ok()) expect_length(winners, samples);
  run.labels = classes_of(json.at("labels"), samples);
  run.predictions = classes_of(json.at("predictions"), samples);
  if (json.has("map")) run.map = map_of(json.at("map"), run.winners);
  if (!json.has("other_predictions")) return run;
  json.at("other_predictions").entries([&](const std::string& name, const CheckedJson& named) {
    run.other_predictions.emplace_back(name, classes_of(named, samples));
  });
  return run;
}

FoldComparison comparison_of(const CheckedJson& json) {
  FoldComparison comparison{json.at("choice").text(), json.at("other").text()};
  comparison.largest_block = json.at("largest_block").whole(kAny);
  comparison.samples = json.at("samples").whole(kAny);
  comparison.right = json.at("right").whole(kAny);
  comparison.other_right = json.at("other_right").whole(kAny);
  comparison.only_right = json.at("only_right").whole(kAny);
  comparison.only_other_right = json.at("only_other_right").whole(kAny);
  return comparison;
}

ProtocolResults protocol_of(const CheckedJson& json) {
  ProtocolResults results{json.at("protocol").text(),
                          optional_text(json, "group"),
                          json.at("label").text(),
                          json.at("samples").whole(kAny),
                          {},
                          {}};
  json.at("runs").each(
      [&](const CheckedJson& run) { results.runs.push_back(run_of(run, results.samples)); });
  json.at("metrics").entries([&](const std::string& name, const CheckedJson& metric) {
    results.metrics.push_back(metric_of(name, metric, results.runs.size()));
  });
  if (json.has("chosen_neighbours")) {
    json.at("chosen_neighbours").entries([&](const std::string& kind, const CheckedJson& folds) {
      results.chosen_neighbours[kind] = folds.whole(kAny);
    });
  }
  if (json.has("fold_comparison")) {
    results.fold_comparison = comparison_of(json.at("fold_comparison"));
  }
  return results;
}

std::vector<Settings> parameters_of(const CheckedJson& json) {
  std::vector<Settings> all;
  json.entries([&](const std::string& part, const CheckedJson& settings) {
    all.push_back({part, {}});
    settings.entries([&](const std::string& name, const CheckedJson& value) {
      all.back().settings.push_back({name, value.text()});
    });
  });
  return all;
}

RecordingInfo recording_of(const CheckedJson& json) {
  return {json.at("name").text(), json.at("source").text(), json.at("seed").whole(kAny),
          json.at("hash").text(), json.at("explorations").whole(kAny)};
}

// Results may name files of their own folder only.
bool is_below(const std::filesystem::path& path) {
  return path.has_filename() && path.is_relative() &&
         std::find(path.begin(), path.end(), "..") == path.end();
}

std::optional<ModelFile> model_of(const CheckedJson& json) {
  if (json.is_null()) return {};
  ModelFile model{json.at("path").text(), json.at("hash").text(), json.at("seed").whole(kAny)};
  if (json.ok() && !is_below(model.path))
    json.at("path").refuse("is not in the folder of the results");
  return model;
}

Pair pair_of(const CheckedJson& json, std::size_t recordings) {
  std::vector<std::uint64_t> numbers;
  json.each([&](const CheckedJson& number) { numbers.push_back(number.whole(kAny)); });
  if (json.ok()) expect_length(json, 2);
  if (!json.ok()) return {};
  if (numbers[0] >= recordings) json.refuse("refers to a recording that does not exist");
  return {numbers[0], numbers[1]};
}

std::vector<RecordingInfo> chosen(const CheckedJson& json,
                                  const std::vector<RecordingInfo>& recordings) {
  std::vector<RecordingInfo> all;
  json.each([&](const CheckedJson& one) {
    const std::uint64_t number = one.whole(kAny);
    if (one.ok() && number >= recordings.size())
      one.refuse("refers to a recording that does not exist");
    if (one.ok()) all.push_back(recordings[number]);
  });
  return all;
}

// All protocols have a run for each pair.
void read_protocols(const CheckedJson& json, PartResults& part) {
  json.each([&](const CheckedJson& one) {
    part.protocols.push_back(protocol_of(one));
    if (one.ok()) expect_length(one.at("runs"), part.pairs.size());
  });
}

PartResults part_of(const CheckedJson& json, const std::vector<RecordingInfo>& recordings) {
  PartResults part;
  part.question = json.at("question").text();
  part.system = json.at("system").text();
  part.variation = json.at("variation").text();
  part.study = json.at("study").text();
  part.parameters = parameters_of(json.at("parameters"));
  part.model = model_of(json.at("model"));
  part.recordings = chosen(json.at("recordings"), recordings);
  part.test_recordings = chosen(json.at("test_recordings"), recordings);
  if (!part.test_recordings.empty()) {
    expect_length(json.at("test_recordings"), part.recordings.size());
  }
  json.at("pairs").each([&](const CheckedJson& pair) {
    part.pairs.push_back(pair_of(pair, part.recordings.size()));
  });
  read_protocols(json.at("protocols"), part);
  return part;
}

Claim claim_of(const CheckedJson& json) {
  Claim claim;
  claim.text = json.at("text").text();
  claim.paper = json.at("paper").text();
  claim.question = json.at("question").text();
  claim.system = json.at("system").text();
  claim.variation = json.at("variation").text();
  claim.metric = json.at("metric").text();
  claim.protocol = json.at("protocol").text();
  claim.group = json.at("group").text();
  claim.than_system = optional_text(json, "than_system");
  claim.than_variation = optional_text(json, "than_variation");
  claim.than_metric = optional_text(json, "than_metric");
  claim.published = json.at("published").number_or_nothing();
  claim.at_least = json.at("at_least").number_or_nothing();
  claim.at_most = json.at("at_most").number_or_nothing();
  return claim;
}

// The measured values of a claim. The verdict follows from the rest, and is refused where it does
// not.
void read_measured(const CheckedJson& json, ClaimOutcome& outcome) {
  outcome.undecidable = json.at("reason").text();
  json.at("values").each(
      [&](const CheckedJson& value) { outcome.values.push_back(value.number_or_nan()); });
  outcome.by_chance = json.at("by_chance").number_or_nothing();
  outcome.chance_share = json.at("chance_share").number_or_nothing();
  if (json.has("limit")) outcome.limit = json.at("limit").number();
  const std::string verdict = json.at("verdict").text();
  const double share = json.at("share").number();
  if (!json.ok()) return;
  if (verdict != choice_name(outcome.verdict())) {
    json.at("verdict").refuse("is '" + verdict + "', which does not follow from its values");
  }
  if (std::abs(share - outcome.share()) > kRounding) {
    json.at("share").refuse("does not follow from its values");
  }
}

ClaimCriterion criterion_of(const CheckedJson& json) {
  const auto criterion = choice_named<ClaimCriterion>("judged_by", json.text(), {});
  if (!criterion && json.ok()) json.refuse("is no criterion of claims");
  return criterion.value_or(ClaimCriterion::kShareOfPairs);
}

std::optional<ClaimRange> range_of(const CheckedJson& json) {
  if (json.is_null()) return {};
  std::vector<double> ends;
  json.each([&](const CheckedJson& end) { ends.push_back(end.number()); });
  if (!json.ok()) return {};
  expect_length(json, 2);
  return json.ok() ? std::optional(ClaimRange{ends[0], ends[1]}) : std::nullopt;
}

ClaimOutcome as_written_of(const CheckedJson& json, const Claim& claim) {
  ClaimOutcome outcome{claim, {}, {}};
  outcome.claim.criterion = criterion_of(json.at("judged_by"));
  outcome.claim.metric = json.at("metric").text();
  outcome.claim.published = json.at("published").number_or_nothing();
  outcome.claim.at_least = json.at("at_least").number_or_nothing();
  outcome.claim.at_most = json.at("at_most").number_or_nothing();
  outcome.claim.bounds_included = json.at("bounds_included").truth();
  json.at("recordings").each([&](const CheckedJson& recording) {
    outcome.recordings.push_back(static_cast<std::size_t>(recording.whole(kAny)));
  });
  outcome.chance_range = range_of(json.at("chance_range"));
  read_measured(json, outcome);
  return outcome;
}

ClaimOutcome outcome_of(const CheckedJson& json) {
  ClaimOutcome outcome{claim_of(json), {}, {}};
  outcome.claim.contradicted_by = optional_text(json, "contradicted_by");
  read_measured(json, outcome);
  if (json.has("as_written")) {
    outcome.as_written.push_back(as_written_of(json.at("as_written"), outcome.claim));
  }
  return outcome;
}

Results results_of(const CheckedJson& root) {
  std::vector<RecordingInfo> recordings;
  root.at("recordings").each([&](const CheckedJson& one) {
    recordings.push_back(recording_of(one));
  });
  Results results;
  root.at("parts").each(
      [&](const CheckedJson& one) { results.parts.push_back(part_of(one, recordings)); });
  root.at("claims").each(
      [&](const CheckedJson& one) { results.claims.push_back(outcome_of(one)); });
  root.at("not_applicable").each([&](const CheckedJson& one) {
    results.not_applicable.push_back({one.at("system").text(), one.at("reason").text()});
  });
  return results;
}

}  // namespace

Result<Results> parse_results(std::string_view text, const std::string& path) {
  SOMATO_TRY(const auto json, detail::parse_results_json(text, path));
  std::optional<Error> trouble;
  const CheckedJson root(json, trouble);
  // Earlier versions had systems in the place of parts.
  if (!root.has("version") || !(root.has("parts") || root.has("systems"))) {
    return fail(ErrorKind::kData, "not a results.json of a study or a reproduction", path,
                "use a file written by 'somato run' or 'somato reproduce'");
  }
  const std::string advice =
      "run 'somato run' or 'somato reproduce' of this version again to write a new results.json";
  const std::uint64_t version = root.at("version").whole(kAny);
  if (!trouble && version != kResultsVersion) {
    return unsupported_format(version, kResultsVersion, path, advice);
  }
  Results results = trouble ? Results{} : results_of(root);
  if (!trouble) return results;
  trouble->where = path;
  trouble->advice = advice;
  return fail(std::move(*trouble));
}

}  // namespace somato
