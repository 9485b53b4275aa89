#include "somato/studies/results.h"

#include <algorithm>
#include <cmath>

#include "studies/results_json.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kResultsVersion = 3;

Json metrics_json(const std::vector<Metric>& metrics) {
  Json json = Json::object();
  for (const Metric& metric : metrics) {
    json[metric.name] = {
        {"mean", metric.mean()}, {"sd", metric.standard_deviation()}, {"values", metric.values}};
    if (!metric.of_each.empty()) json[metric.name]["of_each"] = metric.of_each;
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
  }
  return json;
}

}  // namespace

// TOML's numbers, texts, switches and lists of them are JSON's as they stand; only a text that is
// not UTF-8 is not.
Json detail::setting_json(const std::string& value) {
  const Json json = Json::parse(value, nullptr, false);
  return json.is_discarded() ? Json(value) : json;
}

Json detail::system_json(const SystemResults& system) {
  Json json = {{"name", system.name}, {"protocol", system.protocol}};
  if (!system.group.empty()) json["group"] = system.group;
  json.update({{"label", system.label},
               {"samples", system.samples},
               {"metrics", metrics_json(system.metrics)},
               {"runs", runs_json(system.runs)}});
  return json;
}

Json detail::settings_json(const std::vector<Settings>& parts) {
  Json json = Json::object();
  for (const Settings& part : parts) {
    for (const Setting& setting : part.settings) {
      json[part.part][setting.name] = setting_json(setting.value);
    }
  }
  return json;
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

const Metric* SystemResults::find_metric(std::string_view metric) const {
  const auto found = std::find_if(metrics.begin(), metrics.end(),
                                  [&](const Metric& one) { return one.name == metric; });
  return found == metrics.end() ? nullptr : &*found;
}

std::string to_json(const StudyResults& results) {
  Json json = {{"version", kResultsVersion},
               {"study", results.study},
               {"seeds", results.seeds},
               {"settings", detail::settings_json(results.settings)},
               {"data_hash", results.data_hash}};
  if (!results.test_data_hash.empty()) json["test_data_hash"] = results.test_data_hash;
  json["systems"] = Json::array();
  for (const SystemResults& system : results.systems) {
    json["systems"].push_back(detail::system_json(system));
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace somato
