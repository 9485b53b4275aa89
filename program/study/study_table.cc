#include "study/study_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "studies/results/fold_comparison.h"
#include "studies/results/main_result.h"
#include "studies/results/metric_table.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

// A single map has no deviation.
std::string summary(const Metric& metric) {
  if (metric.values.size() == 1) return fmt::format("{:.3f}", metric.mean());
  return fmt::format("{:.3f} +- {:.3f}", metric.mean(), metric.standard_deviation());
}

std::string advice(const ProtocolResults& system) {
  const auto below = far_below_baseline(system);
  if (!below) return {};
  const double above = above_best_neighbour(system).value_or(0.0);
  if (-above >= *below) {  // as the sentence about the best neighbour states
    return "  More neurons, more iterations or a standardization may help: "
           "docs/below-the-baseline.md.\n";
  }
  return fmt::format(
      "  The map is {:.0f} points below the nearest known sample. More neurons, more iterations or "
      "a\n"
      "  standardization may help: docs/below-the-baseline.md.\n",
      100 * *below);
}

// A sentence in lines.
std::string sentence(const std::string& text) {
  constexpr std::size_t kWidth = 96;
  std::string lines;
  std::string line;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!line.empty() && line.size() + word.size() >= kWidth)
      lines += std::exchange(line, "") + "\n";
    line += (line.empty() ? "  " : " ") + word;
    begin = end + 1;
  }
  return line.empty() ? lines : lines + line + "\n";
}

// How far the map is from the best nearest neighbour, and whether neighbours in the recording leak.
std::string sentences(const ProtocolResults& system) {
  std::string text = sentence(best_neighbour_sentence(system));
  if (system.fold_comparison) text += sentence(sentence_of(*system.fold_comparison));
  return text;
}

std::string collapse(const ProtocolResults& system) {
  const auto collapsed = collapsed_map(system);
  if (!collapsed) return {};
  return fmt::format(
      "  Warning: the map has {} for {} classes, which it cannot separate. A map that\n"
      "  grows needs a higher activity_threshold or by_names = true, another map more neurons.\n",
      counted(collapsed->winners, "winner"), collapsed->classes);
}

std::string missing_accuracy(const ProtocolResults& system) {
  if (system.find_metric("accuracy") != nullptr) return {};
  return fmt::format(
      "  accuracy: not measured, because no {} of the test data occurs in the training data\n",
      system.label);
}

// The mean of a metric, or nothing if it was not measured.
std::string mean_of(const ProtocolResults& system, const std::string& name) {
  const Metric* metric = system.find_metric(name);
  return metric == nullptr ? std::string() : fmt::format("{:.3f}", metric->mean());
}

// The level of a metric by chance.
std::string chance_of(const ProtocolResults& system, const std::string& name) {
  if (name != "accuracy") return mean_of(system, name + "_chance");
  const auto chance = accuracy_by_chance(system);
  return chance ? fmt::format("{:.3f}", *chance) : std::string();
}

std::vector<std::string> main_names(const ProtocolResults& system) {
  std::vector<std::string> names;
  for (const MetricInfo& info : metric_table()) {
    if (info.in_run_table && system.find_metric(info.name)) names.emplace_back(info.name);
  }
  return names;
}

// The main metrics, with their value by chance and the nearest-neighbour baseline.
std::string main_metrics(const ProtocolResults& system) {
  const std::vector<std::string> names = main_names(system);
  std::size_t width = 20;
  for (const std::string& name : names) width = std::max(width, name.size());
  std::string text = fmt::format("  {:<{}} {:<18} {:<10} {}\n", "", width, "map", "by chance",
                                 "nearest neighbour");
  for (const std::string& name : names) {
    std::string row =
        fmt::format("  {:<{}} {:<18} {:<10} {}", name, width, summary(*system.find_metric(name)),
                    chance_of(system, name), mean_of(system, "baseline_" + name));
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

// The learners of object_after_object, a row each.
std::string learners_table(const ProtocolResults& system) {
  std::string text =
      fmt::format("  {:<34} {:<18} {:<18} {}\n", "", "accuracy", "forgetting", "values kept");
  for (const auto& [title, prefix] : {std::pair{"map", ""},
                                      {"plain SOM", "plain_som_"},
                                      {"nearest neighbour, all kept", "baseline_"},
                                      {"nearest neighbour, memory of map", "same_memory_"}}) {
    const std::string before = prefix;
    const Metric* kept = system.find_metric(before + "values_kept");
    const Metric* accuracy = system.find_metric(before + "accuracy");
    const Metric* forgetting = system.find_metric(before + "forgetting");
    if (kept == nullptr || accuracy == nullptr || forgetting == nullptr) continue;
    text += fmt::format("  {:<34} {:<18} {:<18} {:.0f}\n", title, summary(*accuracy),
                        summary(*forgetting), kept->mean());
  }
  return text;
}

// Names that no neuron was left for.
std::string refused_names(const ProtocolResults& system) {
  const Metric* refused = system.find_metric("names_refused");
  if (refused == nullptr || refused->mean() == 0.0) return {};
  return fmt::format(
      "  {:.1f} % of the names were refused, because all neurons of the map had names; use a "
      "larger\n"
      "  map.\n",
      100.0 * refused->mean());
}

// The effect of given names under leave_class_out: a row for each number of names.
std::string names_table(const ProtocolResults& system) {
  std::string text;
  for (std::size_t names = 0;; ++names) {
    const auto find = [&](const std::string& name) {
      return system.find_metric(fmt::format("{}_after_{}", name, names));
    };
    const Metric* known = find("known_accuracy");
    if (known == nullptr) return text + refused_names(system);
    if (names == 0) {
      text = fmt::format("  {:<20} {:<18} {:<18} {}\n", "names given", "accuracy, new",
                         "accuracy, known", "known ones changed");
    }
    const Metric* taught = find("taught_accuracy");
    const Metric* changed = find("known_changed");
    std::string row =
        fmt::format("  {:<20} {:<18} {:<18} {}", names, taught == nullptr ? "" : summary(*taught),
                    summary(*known), changed == nullptr ? "" : summary(*changed));
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
}

std::string all_metrics(const ProtocolResults& system) {
  std::string text;
  std::size_t width = 33;
  for (const Metric& metric : system.metrics) width = std::max(width, metric.name.size());
  for (const Metric& metric : system.metrics) {
    text += fmt::format("  {:<{}} {}\n", metric.name, width, summary(metric));
  }
  return text;
}

std::string table_of(const std::string& name, const ProtocolResults& system, ShownMetrics shown) {
  const std::string group = system.group.empty() ? "" : " (" + system.group + ")";
  const std::string heading =
      fmt::format("\n{}: {}{} by {}, {}, {}\n", name, system.protocol, group, system.label,
                  counted(system.samples, "sample"), counted(system.runs.size(), "seed"));
  const bool continual = system.protocol == "object_after_object";
  const std::string main =
      continual ? learners_table(system) : main_metrics(system) + names_table(system);
  return heading + (shown == ShownMetrics::kAll ? all_metrics(system) : main) +
         missing_accuracy(system) + collapse(system) + sentences(system) + advice(system);
}

}  // namespace

std::string study_table(const PartResults& results, ShownMetrics shown) {
  std::string text;
  for (const ProtocolResults& one : results.protocols) {
    text += table_of(results.system, one, shown);
  }
  return text;
}

}  // namespace somato::program
