#include "study_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "wording.h"

namespace somato::program {
namespace {

// A single map has no deviation.
std::string summary(const Metric& metric) {
  if (metric.values.size() == 1) return fmt::format("{:.3f}", metric.mean());
  return fmt::format("{:.3f} +- {:.3f}", metric.mean(), metric.standard_deviation());
}

// A map that is much worse than the nearest known sample needs more of something. Where it is
// tested on what it has learned, the nearest known sample is the tested one.
std::string advice(const SystemResults& system) {
  constexpr double kMuch = 0.05;
  const Metric* accuracy = system.find_metric("accuracy");
  const Metric* baseline = system.find_metric("baseline_accuracy");
  if (accuracy == nullptr || baseline == nullptr || system.protocol == "train_is_test") return {};
  const double below = baseline->mean() - accuracy->mean();
  if (below <= kMuch) return {};
  return fmt::format(
      "  The map is {:.0f} points below the nearest known sample. More neurons (rows, columns), "
      "more\n"
      "  iterations or a standardization may help: docs/below-the-baseline.md.\n",
      100 * below);
}

std::string missing_accuracy(const SystemResults& system) {
  if (system.find_metric("accuracy") != nullptr) return {};
  return fmt::format("  accuracy: not measured, because no tested {} is among those learned\n",
                     system.label);
}

std::string table_of(const SystemResults& system, std::size_t seeds) {
  const std::string group = system.group.empty() ? "" : " (" + system.group + ")";
  std::string text =
      fmt::format("\n{}: {}{} by {}, {}, {}\n", system.name, system.protocol, group, system.label,
                  counted(system.samples, "sample"), counted(seeds, "seed"));
  std::size_t width = 33;
  for (const Metric& metric : system.metrics) width = std::max(width, metric.name.size());
  for (const Metric& metric : system.metrics) {
    text += fmt::format("  {:<{}} {}\n", metric.name, width, summary(metric));
  }
  return text + missing_accuracy(system) + advice(system);
}

}  // namespace

std::string study_table(const StudyResults& results) {
  std::string text;
  for (const SystemResults& system : results.systems) text += table_of(system, results.seeds);
  return text;
}

}  // namespace somato::program
