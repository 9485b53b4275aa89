#include "somato/studies/results.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "studies/results/fold_comparison.h"
#include "studies/results/results_json.h"
#include "studies/results/short_number.h"
#include "systems/graph/graph_json.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

Json metrics_json(const std::vector<Metric>& metrics) {
  Json json = Json::object();
  for (const Metric& metric : metrics) {
    json[metric.name] = {
        {"mean", metric.mean()}, {"sd", metric.standard_deviation()}, {"values", metric.values}};
    if (!metric.of_each.empty()) json[metric.name]["of_each"] = metric.of_each;
  }
  return json;
}

Json map_json(const TrainedMap& map) {
  Json json = {{"grid", detail::grid_json(map.grid)},
               {"u_matrix", detail::short_numbers(std::span<const double>(map.u_matrix))}};
  if (map.grid.graph()) {
    json["edge_distances"] = detail::short_numbers(std::span<const double>(map.edge_distances));
  }
  return json;
}

Json runs_json(const std::vector<Run>& runs) {
  Json json = Json::array();
  for (const Run& run : runs) {
    json.push_back({{"seed", run.seed},
                    {"winners", run.winners},
                    {"labels", run.labels},
                    {"predictions", run.predictions}});
    for (const auto& [label, predictions] : run.other_predictions) {
      json.back()["other_predictions"][label] = predictions;
    }
    if (run.map) json.back()["map"] = map_json(*run.map);
  }
  return json;
}

// Each recording once; parts refer to them by their numbers.
class RecordingList {
 public:
  Json numbers_of(const std::vector<RecordingInfo>& recordings) {
    Json numbers = Json::array();
    for (const RecordingInfo& one : recordings) numbers.push_back(number_of(one));
    return numbers;
  }

  Json json() const {
    Json list = Json::array();
    for (const RecordingInfo& one : recordings_) {
      list.push_back({{"name", one.name},
                      {"source", one.source},
                      {"seed", one.seed},
                      {"hash", one.hash},
                      {"explorations", one.explorations}});
    }
    return list;
  }

 private:
  std::size_t number_of(const RecordingInfo& recording) {
    const auto known = std::find(recordings_.begin(), recordings_.end(), recording);
    const auto number = static_cast<std::size_t>(known - recordings_.begin());
    if (known == recordings_.end()) recordings_.push_back(recording);
    return number;
  }

  std::vector<RecordingInfo> recordings_;
};

Json model_json(const std::optional<ModelFile>& model) {
  if (!model) return nullptr;
  return {{"path", model->path}, {"hash", model->hash}, {"seed", model->seed}};
}

Json part_json(const PartResults& part, RecordingList& recordings) {
  Json pairs = Json::array();
  for (const Pair& pair : part.pairs) pairs.push_back({pair.recording, pair.seed});
  Json protocols = Json::array();
  for (const ProtocolResults& one : part.protocols) protocols.push_back(detail::protocol_json(one));
  return {{"question", part.question},
          {"system", part.system},
          {"variation", part.variation},
          {"study", part.study},
          {"parameters", detail::parameters_json(part.parameters)},
          {"model", model_json(part.model)},
          {"recordings", recordings.numbers_of(part.recordings)},
          {"test_recordings", recordings.numbers_of(part.test_recordings)},
          {"pairs", std::move(pairs)},
          {"protocols", std::move(protocols)}};
}

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json range_json(const std::optional<ClaimRange>& range) {
  return range ? Json{range->low, range->high} : Json(nullptr);
}

// The measured values, and the verdict on them.
Json measured_json(const ClaimOutcome& outcome) {
  const Metric values{outcome.claim.metric, outcome.values};
  Json json = {{"verdict", choice_name(outcome.verdict())},
               {"reason", outcome.reason()},
               {"share", outcome.share()},
               {"mean", outcome.mean()},
               {"sd", outcome.values.empty() ? Json(nullptr) : Json(values.standard_deviation())},
               {"by_chance", optional_json(outcome.by_chance)},
               {"chance_share", optional_json(outcome.chance_share)},
               {"values", outcome.values}};
  if (outcome.limit) json["limit"] = *outcome.limit;
  return json;
}

// The second measure of a claim.
Json as_written_json(const ClaimOutcome& outcome) {
  const Claim& claim = outcome.claim;
  Json json = {
      {"judged_by", choice_name(claim.criterion)},   {"metric", claim.metric},
      {"published", optional_json(claim.published)}, {"at_least", optional_json(claim.at_least)},
      {"at_most", optional_json(claim.at_most)},     {"bounds_included", claim.bounds_included}};
  json.update(measured_json(outcome));
  json["range"] = range_json(outcome.range());
  json["chance_range"] = range_json(outcome.chance_range);
  json["recordings"] = outcome.recordings;
  return json;
}

Json outcome_json(const ClaimOutcome& outcome) {
  Json json = detail::claim_json(outcome.claim);
  if (!outcome.claim.contradicted_by.empty()) {
    json["contradicted_by"] = outcome.claim.contradicted_by;
  }
  json.update(measured_json(outcome));
  for (const ClaimOutcome& second : outcome.as_written)
    json["as_written"] = as_written_json(second);
  return json;
}

}  // namespace

Json detail::protocol_json(const ProtocolResults& protocol) {
  Json json = {{"protocol", protocol.protocol}};
  if (!protocol.group.empty()) json["group"] = protocol.group;
  json.update({{"label", protocol.label},
               {"samples", protocol.samples},
               {"metrics", metrics_json(protocol.metrics)},
               {"runs", runs_json(protocol.runs)}});
  if (!protocol.chosen_neighbours.empty()) json["chosen_neighbours"] = protocol.chosen_neighbours;
  if (protocol.fold_comparison) {
    json["fold_comparison"] = fold_comparison_json(*protocol.fold_comparison);
  }
  return json;
}

Json detail::fold_comparison_json(const FoldComparison& comparison) {
  return {{"choice", comparison.choice},
          {"other", comparison.other},
          {"largest_block", comparison.largest_block},
          {"samples", comparison.samples},
          {"accuracy", optional_json(accuracy_by(comparison.choice, comparison))},
          {"other_accuracy", optional_json(accuracy_by(comparison.other, comparison))},
          {"right", comparison.right},
          {"other_right", comparison.other_right},
          {"only_right", comparison.only_right},
          {"only_other_right", comparison.only_other_right},
          {"neighbours_leak", neighbours_leak(comparison)},
          {"sentence", sentence_of(comparison)}};
}

Json detail::parameters_json(const std::vector<Settings>& parts) {
  Json json = Json::object();
  for (const Settings& part : parts) {
    json[part.part] = Json::object();
    for (const Setting& setting : part.settings) json[part.part][setting.name] = setting.value;
  }
  return json;
}

Json detail::claim_json(const Claim& claim) {
  Json json = {{"text", claim.text},           {"paper", claim.paper},
               {"question", claim.question},   {"system", claim.system},
               {"variation", claim.variation}, {"metric", claim.metric},
               {"protocol", claim.protocol},   {"group", claim.group}};
  if (claim.compares()) {
    json["than_system"] = claim.than_system;
    json["than_variation"] = claim.than_variation;
    json["than_metric"] = claim.other_metric();
  }
  json["published"] = optional_json(claim.published);
  json["at_least"] = optional_json(claim.at_least);
  json["at_most"] = optional_json(claim.at_most);
  return json;
}

std::string to_toml(const Settings& settings) {
  std::string text = "\n[" + settings.part + "]\n";
  for (const Setting& one : settings.settings) text += one.name + " = " + one.value + "\n";
  return text;
}

double Metric::mean() const {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double Metric::standard_deviation() const {
  if (values.size() < 2) return 0.0;
  const double center = mean();
  double sum = 0.0;
  for (const double value : values) sum += (value - center) * (value - center);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

const Metric* ProtocolResults::find_metric(std::string_view metric) const {
  const auto found = std::find_if(metrics.begin(), metrics.end(),
                                  [&](const Metric& one) { return one.name == metric; });
  return found == metrics.end() ? nullptr : &*found;
}

std::string to_json(const Results& results) {
  RecordingList recordings;
  Json parts = Json::array();
  for (const PartResults& part : results.parts) parts.push_back(part_json(part, recordings));
  Json claims = Json::array();
  for (const ClaimOutcome& outcome : results.claims) claims.push_back(outcome_json(outcome));
  Json skipped = Json::array();
  for (const NotApplicable& one : results.not_applicable) {
    skipped.push_back({{"system", one.system}, {"reason", one.reason}});
  }
  const Json json = {{"version", kResultsVersion},
                     {"recordings", recordings.json()},
                     {"parts", std::move(parts)},
                     {"claims", std::move(claims)},
                     {"not_applicable", std::move(skipped)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace somato
