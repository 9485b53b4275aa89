#include "reproduction_table.h"

#include <fmt/format.h>

namespace somato::program {
namespace {

std::string cell(const SystemResults& results, const std::string& name) {
  const Metric* metric = results.find_metric(name);
  if (!metric) return "-";
  return fmt::format("{:.3f} +- {:.3f}", metric->mean(), metric->standard_deviation());
}

// Of the system's own label, or where that cannot be named, of the first that can.
std::string label_prefix(const SystemResults& results) {
  for (const Metric& metric : results.metrics) {
    const std::string accuracy = "accuracy";
    if (metric.name == accuracy) return "";
    if (metric.name.ends_with("." + accuracy) && !metric.name.ends_with("baseline_accuracy")) {
      return metric.name.substr(0, metric.name.size() - accuracy.size());
    }
  }
  return "";
}

std::string named(const PartResults& part) {
  return part.variation.empty() ? part.system : part.system + ", " + part.variation;
}

std::string line_of(const PartResults& part, const SystemResults& results) {
  const std::string prefix = label_prefix(results);
  const std::string label = prefix.empty() ? results.label : prefix.substr(0, prefix.size() - 1);
  const std::string protocol =
      results.group.empty() ? results.protocol : results.protocol + " " + results.group;
  return fmt::format("  {:<36} {:<24} {:<10} {:<16} {:<16}\n", named(part), protocol, label,
                     cell(results, prefix + "accuracy"),
                     cell(results, prefix + "baseline_accuracy"));
}

std::string published(const ClaimOutcome& outcome) {
  return outcome.claim.published ? fmt::format("{:g}", *outcome.claim.published) : "-";
}

std::string claim_line(const ClaimOutcome& outcome) {
  const Metric values{outcome.claim.metric, outcome.values};
  const std::string subject = outcome.claim.variation.empty()
                                  ? outcome.claim.system
                                  : outcome.claim.system + ", " + outcome.claim.variation;
  return fmt::format("  {:>4.0f} %  {:>9}  {:>8.3f} +- {:<7.3f} {}: {}\n", 100.0 * outcome.share(),
                     published(outcome), values.mean(), values.standard_deviation(), subject,
                     outcome.claim.text);
}

}  // namespace

std::string reproduction_table(const ReproductionResults& results) {
  std::string text;
  std::string question = "-";
  for (const PartResults& part : results.parts) {
    if (part.question != question) {
      question = part.question;
      text += fmt::format("\n{}\n", question.empty() ? "Systems" : "Question: " + question);
      text += fmt::format("  {:<36} {:<24} {:<10} {:<16} {:<16}\n", "system", "protocol", "label",
                          "accuracy", "nearest neighbour");
    }
    for (const SystemResults& protocol : part.protocols) text += line_of(part, protocol);
  }
  if (!results.claims.empty()) {
    text += "\nClaims: in how many of the pairs each holds, as published, as measured\n";
    for (const ClaimOutcome& outcome : results.claims) text += claim_line(outcome);
  }
  for (const NotApplicable& one : results.not_applicable) {
    text += fmt::format("\nNot applicable: {}: {}", one.system, one.reason);
  }
  return text;
}

}  // namespace somato::program
