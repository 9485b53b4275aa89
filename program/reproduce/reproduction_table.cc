#include "reproduce/result_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace somato::program {
namespace {

std::string cell(const ProtocolResults& results, const std::string& name) {
  const Metric* metric = results.find_metric(name);
  if (!metric) return "-";
  return fmt::format("{:.3f} +- {:.3f}", metric->mean(), metric->standard_deviation());
}

// The prefix of the system's own label or, if that cannot be named, of the first that can.
std::string label_prefix(const ProtocolResults& results) {
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

std::string line_of(const PartResults& part, const ProtocolResults& results) {
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

// The value beyond which no map of these individuals can be.
std::string limit_line(const ClaimOutcome& outcome) {
  return fmt::format("{:4}best value that the numbers of the individuals permit: {:.3f}\n", "",
                     *outcome.limit);
}

// The second measure of a claim.
std::string as_written_lines(const ClaimOutcome& outcome) {
  std::string text = fmt::format("{:4}as written: {} ({})\n", "", choice_name(outcome.verdict()),
                                 outcome.summary());
  if (!outcome.reason().empty()) text += fmt::format("{:6}{}\n", "", outcome.reason());
  if (outcome.limit) text += "  " + limit_line(outcome);
  return text;
}

std::string claim_lines(const ClaimOutcome& outcome) {
  const Claim& claim = outcome.claim;
  const Metric values{claim.metric, outcome.values};
  const std::string subject =
      claim.variation.empty() ? claim.system : claim.system + ", " + claim.variation;
  std::string text = fmt::format(
      "  {:<25} {:>4.0f} %  {:>9}  {:>8.3f} +- {:<7.3f} {}: {} ({} {})\n",
      choice_name(outcome.verdict()), 100.0 * outcome.share(), published(outcome), values.mean(),
      values.standard_deviation(), subject, claim.text, claim.measured(), claim.bounds());
  if (!outcome.reason().empty()) text += fmt::format("{:4}{}\n", "", outcome.reason());
  if (outcome.limit) text += limit_line(outcome);
  if (!claim.contradicted_by.empty()) {
    text += fmt::format("{:4}contradicted by {}\n", "", claim.contradicted_by);
  }
  for (const ClaimOutcome& second : outcome.as_written) text += as_written_lines(second);
  return text;
}

// Those of papers, or those of our own; nothing where there is none.
std::string claims_text(const std::vector<ClaimOutcome>& claims, bool of_papers,
                        const std::string& title) {
  std::string text;
  for (const ClaimOutcome& outcome : claims) {
    if (outcome.claim.is_of_paper() == of_papers) text += claim_lines(outcome);
  }
  if (text.empty()) return text;
  return fmt::format(
      "\n{}: verdict, share of pairs in which each claim holds, published value, measured "
      "value\n{}",
      title, text);
}

using Measure = std::function<ClaimVerdict(const ClaimOutcome&)>;

// The number of claims of papers with each verdict.
std::string verdicts_text(const std::string& title, std::size_t width,
                          const std::vector<ClaimOutcome>& claims, const Measure& measure) {
  std::string text;
  for (const auto& [verdict, name] : Choices<ClaimVerdict>::all()) {
    const auto count =
        std::count_if(claims.begin(), claims.end(), [&](const ClaimOutcome& outcome) {
          return outcome.claim.is_of_paper() && measure(outcome) == verdict;
        });
    if (count > 0) text += fmt::format("  {:<{}} {:>4}\n", name, width, count);
  }
  return text.empty() ? text : fmt::format("\n{}\n{}", title, text);
}

// For both measures; for the second one only if a claim has it.
std::string verdicts_text(const std::vector<ClaimOutcome>& claims) {
  const auto first = [](const ClaimOutcome& outcome) { return outcome.verdict(); };
  const auto second = [](const ClaimOutcome& outcome) { return outcome.verdict_as_written(); };
  std::string text = verdicts_text("Verdicts on the claims of papers", 25, claims, first);
  const bool has_second = std::any_of(claims.begin(), claims.end(), [](const auto& outcome) {
    return outcome.claim.is_of_paper() && !outcome.as_written.empty();
  });
  if (has_second) text += verdicts_text("The same as written in the texts", 39, claims, second);
  return text;
}

}  // namespace

std::string reproduction_table(const Results& results) {
  std::string text;
  std::string question = "-";
  for (const PartResults& part : results.parts) {
    if (part.question != question) {
      question = part.question;
      text += fmt::format("\n{}\n", question.empty() ? "Systems" : "Question: " + question);
      text += fmt::format("  {:<36} {:<24} {:<10} {:<16} {:<16}\n", "system", "protocol", "label",
                          "accuracy", "nearest neighbour");
    }
    for (const ProtocolResults& protocol : part.protocols) text += line_of(part, protocol);
  }
  text += claims_text(results.claims, true, "Claims of papers");
  text += verdicts_text(results.claims);
  text += claims_text(results.claims, false, "Comparisons of our own");
  for (const NotApplicable& one : results.not_applicable) {
    text += fmt::format("\nNot applicable: {}: {}", one.system, one.reason);
  }
  return text;
}

}  // namespace somato::program
