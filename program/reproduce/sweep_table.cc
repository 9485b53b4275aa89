#include "reproduce/result_tables.h"

#include <fmt/format.h>

#include "terminal/wording.h"

namespace somato::program {
namespace {

std::string effect_text(const SweepDescription& sweep, std::size_t number,
                        const UnknownEffect& effect) {
  const std::string& name = sweep.unknowns[number].name;
  if (effect.order) {
    return fmt::format("{} {:.2f} (by chance {:.2f})", name, effect.order->index,
                       effect.order->by_chance);
  }
  return fmt::format("{} {:.0f} %", name, 100.0 * effect.change);
}

std::string effects_line(const SweepDescription& sweep, const ClaimEffects& over) {
  std::string text;
  for (const std::size_t number : over.by_effect()) {
    const UnknownEffect& effect = over.effects[number];
    if (effect.change == 0.0) continue;
    text += (text.empty() ? "" : ", ") + effect_text(sweep, number, effect);
  }
  return text.empty() ? "no unknown affects it" : text;
}

std::string claim_lines(const SweepResults& results, std::size_t number) {
  const Claim& claim = results.sweep.claims[number];
  const ClaimEffects over = effects_on(results, number);
  const std::string text =
      claim.variation.empty() ? claim.text : claim.variation + ": " + claim.text;
  if (over.points == 0) {
    return fmt::format("  {:>6}  {:>6}  {}\n{:18}cannot be judged at any point\n", "-", "-", text,
                       "");
  }
  return fmt::format("  {:>4.0f} %  {:>4.0f} %  {}\n{:18}{}\n", 100.0 * over.holds,
                     100.0 * over.mean_share, text, "", effects_line(results.sweep.sweep, over));
}

}  // namespace

std::string sweep_table(const SweepResults& results) {
  const SweepDescription& sweep = results.sweep.sweep;
  const bool one = sweep.sweep.design == SweepDesign::kOneAtATime;
  std::string text = fmt::format(
      "{}: {} ({}) of {}, {} at each\n\n"
      "  {:>6}  {:>6}  claim, and below it {}\n",
      names_of(results.sweep), counted(results.points.size(), "point"),
      choice_name(sweep.sweep.design), counted(sweep.unknowns.size(), "unknown"),
      counted(sweep.sweep.pairs, "pair"), "holds", "pairs",
      one ? "the change of the share of pairs by each unknown"
          : "the share of the variance explained by each unknown");
  for (std::size_t i = 0; i < results.sweep.claims.size(); ++i) text += claim_lines(results, i);
  for (const std::string& claim : results.sweep.not_judged) {
    text += fmt::format("\nNot judged, because it compares with another system: {}\n", claim);
  }
  return text;
}

}  // namespace somato::program
