#include "studies/results/main_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace somato {
namespace {

// The nearest training sample of a training sample is this sample.
bool holds_out(const ProtocolResults& protocol) {
  return protocol.protocol != "train_is_test";
}

std::optional<MainResult> result_of(const PartResults& part, std::size_t number) {
  const ProtocolResults& protocol = part.protocols[number];
  const Metric* accuracy = protocol.find_metric("accuracy");
  const auto chance = accuracy_by_chance(protocol);
  if (accuracy == nullptr || !chance) return {};
  MainResult result{number, accuracy->mean(), accuracy->standard_deviation(), {}, *chance};
  if (const Metric* baseline = protocol.find_metric("baseline_accuracy")) {
    result.baseline = baseline->mean();
  }
  return result;
}

// The kinds of neighbours in the order of how often they were chosen.
std::string in_brackets(const std::map<std::string, std::size_t>& chosen) {
  std::vector<std::pair<std::string, std::size_t>> kinds(chosen.begin(), chosen.end());
  std::sort(kinds.begin(), kinds.end(), [](const auto& one, const auto& other) {
    return std::tie(other.second, one.first) < std::tie(one.second, other.first);
  });
  std::size_t all = 0;
  for (const auto& [kind, folds] : kinds) all += folds;
  std::string text;
  for (const auto& [kind, folds] : kinds) {
    text += text.empty() ? " (" : "; ";
    text += kinds.size() == 1 ? kind : fmt::format("{} in {} of {} folds", kind, folds, all);
  }
  return text.empty() ? text : text + ")";
}

// The expected share of right classes: of each class the share of its samples times that of its
// predictions.
double chance_of(const Run& run) {
  std::map<std::string, std::pair<double, double>> counts;
  for (const std::string& label : run.labels) counts[label].first += 1.0;
  for (const std::string& predicted : run.predictions) counts[predicted].second += 1.0;
  double sum = 0.0;
  for (const auto& [name, count] : counts) sum += count.first * count.second;
  const auto samples = static_cast<double>(run.labels.size());
  return sum / (samples * samples);
}

}  // namespace

std::optional<MainResult> main_result(const PartResults& part) {
  std::optional<MainResult> chosen;
  for (const bool held_out : {true, false}) {
    for (std::size_t i = 0; i < part.protocols.size(); ++i) {
      if (holds_out(part.protocols[i]) != held_out) continue;
      const auto result = result_of(part, i);
      if (result && (!chosen || result->accuracy < chosen->accuracy)) chosen = result;
    }
    if (chosen) return chosen;
  }
  return chosen;
}

std::optional<double> accuracy_by_chance(const ProtocolResults& protocol) {
  double sum = 0.0;
  std::size_t runs = 0;
  for (const Run& run : protocol.runs) {
    if (run.predictions.empty() || run.predictions.size() != run.labels.size()) continue;
    sum += chance_of(run);
    ++runs;
  }
  if (runs == 0) return {};
  return sum / static_cast<double>(runs);
}

std::optional<double> above_best_neighbour(const ProtocolResults& protocol) {
  const Metric* accuracy = protocol.find_metric("accuracy");
  const Metric* best = protocol.find_metric("best_neighbour_accuracy");
  if (accuracy == nullptr || best == nullptr || !holds_out(protocol)) return {};
  return accuracy->mean() - best->mean();
}

std::string best_neighbour_sentence(const ProtocolResults& protocol) {
  const auto above = above_best_neighbour(protocol);
  if (!above) return {};
  const double points = std::round(1000.0 * std::fabs(*above)) / 10.0;
  const std::string accuracy =
      fmt::format("{:.3f}", protocol.find_metric("best_neighbour_accuracy")->mean());
  if (points == 0.0) {
    return fmt::format("The map is as accurate as the best nearest neighbour, {}{}.", accuracy,
                       in_brackets(protocol.chosen_neighbours));
  }
  return fmt::format("The map is {:.1f} points {} the best nearest neighbour, {}{}.", points,
                     *above < 0.0 ? "below" : "above", accuracy,
                     in_brackets(protocol.chosen_neighbours));
}

std::optional<double> far_below_baseline(const ProtocolResults& protocol) {
  constexpr double kMuch = 0.05;
  const Metric* accuracy = protocol.find_metric("accuracy");
  const Metric* baseline = protocol.find_metric("baseline_accuracy");
  if (accuracy == nullptr || baseline == nullptr || !holds_out(protocol)) return {};
  const double below =
      std::max(baseline->mean() - accuracy->mean(), -above_best_neighbour(protocol).value_or(0.0));
  return below > kMuch ? std::optional(below) : std::nullopt;
}

std::optional<CollapsedMap> collapsed_map(const ProtocolResults& protocol) {
  if (protocol.find_metric("accuracy") == nullptr) return {};
  std::optional<CollapsedMap> collapsed;
  for (const Run& run : protocol.runs) {
    const std::set<std::size_t> winners(run.winners.begin(), run.winners.end());
    const std::set<std::string> classes(run.labels.begin(), run.labels.end());
    if (winners.empty() || winners.size() >= classes.size()) continue;
    if (!collapsed || winners.size() < collapsed->winners) {
      collapsed = CollapsedMap{winners.size(), classes.size()};
    }
  }
  return collapsed;
}

std::vector<Confusion> confusions(const ProtocolResults& protocol, std::size_t most) {
  std::map<std::string, std::size_t> samples;
  std::map<std::pair<std::string, std::string>, std::size_t> wrong;
  for (const Run& run : protocol.runs) {
    for (std::size_t i = 0; i < std::min(run.labels.size(), run.predictions.size()); ++i) {
      ++samples[run.labels[i]];
      if (run.labels[i] != run.predictions[i]) ++wrong[{run.labels[i], run.predictions[i]}];
    }
  }
  std::vector<Confusion> all;
  all.reserve(wrong.size());
  for (const auto& [classes, count] : wrong) {
    all.push_back({classes.first, classes.second, count, samples[classes.first]});
  }
  std::sort(all.begin(), all.end(), [](const Confusion& one, const Confusion& other) {
    return std::tie(other.count, one.label, one.predicted) <
           std::tie(one.count, other.label, other.predicted);
  });
  all.resize(std::min(all.size(), most));
  return all;
}

}  // namespace somato
