#include "studies/sweep/sweep_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text/number_of_text.h"
#include "maps/svg/strip_picture.h"

namespace somato {
namespace {

// Short enough for an edge or a cell; texts without their quotation marks.
std::string shown(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.content)) return *text;
  if (const auto* number = std::get_if<double>(&value.content)) {
    return fmt::format("{:.3g}", *number);
  }
  return to_toml(value);
}

bool is_parted(const SweepDescription& sweep, const Unknown& unknown) {
  return unknown.parameters.is_range() && !has_levels(sweep.sweep.design);
}

bool is_in(const SweepCell& cell, const std::string& own) {
  if (to_toml(cell.from) == own) return true;
  const auto number = number_of_text<double>(own);
  const auto from = number_of_text<double>(to_toml(cell.from));
  const auto to = number_of_text<double>(to_toml(cell.to));
  return number && from && to && *number >= *from && *number <= *to;
}

// The middle of the cell with the system's own value, or nothing.
std::optional<double> place_among(const std::vector<SweepCell>& cells, const std::string& own) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!is_in(cells[i], own)) continue;
    return (static_cast<double>(i) + 0.5) / static_cast<double>(cells.size());
  }
  return {};
}

StripMark mark_of(const SweepDescription& sweep, const Unknown& unknown, const std::string& own,
                  const std::vector<SweepCell>& cells, std::optional<double> system_share) {
  StripMark mark{{}, "the system: " + own};
  if (system_share) mark.text += fmt::format(" ({:.0f} %)", 100.0 * *system_share);
  const auto number = number_of_text<double>(own);
  if (!is_parted(sweep, unknown) || unknown.parameters.whole) {
    mark.place = place_among(cells, own);
  } else if (number) {
    mark.place = place_in_range(unknown.parameters, *number);
  }
  return mark;
}

std::string label_of(const SweepCell& cell) {
  return cell.from == cell.to ? shown(cell.from) : shown(cell.from) + " to " + shown(cell.to);
}

StripCell strip_cell(const SweepCell& cell, const CellOutcome& outcome) {
  StripCell drawn{label_of(cell), {}, label_of(cell) + ": no points"};
  if (outcome.points == 0) return drawn;
  drawn.share = outcome.share;
  drawn.tooltip =
      fmt::format("{}: holds in {:.1f} % of the pairs of {} point{}", label_of(cell),
                  100.0 * outcome.share, outcome.points, outcome.points == 1 ? "" : "s");
  return drawn;
}

std::string keys_of(const Unknown& unknown) {
  std::string keys;
  for (const std::string& key : unknown.parameters.key) keys += (keys.empty() ? "" : ", ") + key;
  return keys;
}

void add_figure(const SweepDescription& sweep, const UnknownEffect& effect, Strip& strip) {
  if (effect.order) {
    strip.figure = fmt::format("{:.2f}", effect.order->index);
    strip.figure_note = fmt::format("by chance {:.2f}", effect.order->by_chance);
  } else if (sweep.sweep.design == SweepDesign::kOneAtATime) {
    strip.figure = fmt::format("{:.0f} %", 100.0 * effect.change);
    strip.figure_note = "least to greatest";
  }
}

Strip strip_of(const SystemSweep& planned, std::size_t number, const UnknownEffect& effect,
               std::optional<double> system_share) {
  const SweepDescription& sweep = planned.sweep;
  const Unknown& unknown = sweep.unknowns[number];
  const std::vector<SweepCell> cells = sweep_cells(sweep, unknown);
  Strip strip{.name = unknown.name, .note = keys_of(unknown)};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    strip.cells.push_back(strip_cell(cells[i], effect.cells[i]));
  }
  if (is_parted(sweep, unknown) && !unknown.parameters.whole) {
    for (const SweepCell& cell : cells) strip.edges.push_back(shown(cell.from));
    strip.edges.push_back(shown(cells.back().to));
  }
  strip.mark = mark_of(sweep, unknown, planned.own_values[number], cells, system_share);
  add_figure(sweep, effect, strip);
  return strip;
}

std::string bound_of(const Claim& claim) {
  std::string text =
      claim.protocol + (claim.group.empty() ? "" : " " + claim.group) + ", " + claim.measured();
  if (claim.at_least) text += fmt::format(", at least {:g}", *claim.at_least);
  if (claim.at_most) text += fmt::format(", at most {:g}", *claim.at_most);
  return text;
}

StripPanel panel_of(const SweepResults& results, std::size_t number) {
  const Claim& claim = results.sweep.claims[number];
  const ClaimEffects over = effects_on(results, number);
  StripPanel panel{.title = claim.text};
  if (!claim.variation.empty()) panel.title += " (" + claim.variation + ")";
  const std::string paper = claim.paper.empty() ? "" : claim.paper + ": ";
  if (over.points == 0) {
    panel.note = paper + bound_of(claim) + ". It could not be judged at any point.";
    return panel;
  }
  panel.note = fmt::format(
      "{}{}. Holds at {:.0f} % of the points, and in {:.0f} % of the pairs of a point on average.",
      paper, bound_of(claim), 100.0 * over.holds, 100.0 * over.mean_share);
  const auto changes = [](const UnknownEffect& effect) { return effect.change > 0.0; };
  if (std::none_of(over.effects.begin(), over.effects.end(), changes)) {
    panel.note += " No unknown changes that.";
    return panel;
  }
  for (std::size_t i = 0; i < over.effects.size(); ++i) {
    panel.strips.push_back(strip_of(results.sweep, i, over.effects[i], over.system_share));
  }
  return panel;
}

std::string caption_of(const SweepResults& results) {
  const SweepParameters& sweep = results.sweep.sweep.sweep;
  const std::string figure =
      sweep.design == SweepDesign::kOneAtATime
          ? "At the right: how far the greatest share is from the least."
          : "At the right: the share of the variance between points that the unknown explains by "
            "itself, and what is expected by chance.";
  return fmt::format(
      "{} points ({}), {} pairs of recording and seed at each. A bar is the share of pairs, in "
      "percent, in which the claim holds, over all points with that value. A claim holds at a "
      "point where it does in at least {:.0f} % of the pairs. The triangle is the system's own "
      "value. {}",
      results.points.size(), choice_name(sweep.design), sweep.pairs, 100.0 * kHoldsFrom, figure);
}

}  // namespace

std::string sweep_picture(const SweepResults& results) {
  std::vector<StripPanel> panels;
  panels.reserve(results.sweep.claims.size());
  for (std::size_t i = 0; i < results.sweep.claims.size(); ++i) {
    panels.push_back(panel_of(results, i));
  }
  return draw_strips("Where the claims hold: " + names_of(results.sweep), caption_of(results),
                     panels);
}

}  // namespace somato
