#include "reproduce/match_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "reproduce/inference_table.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

std::string compared_lines(const ComparedTouch& compared) {
  std::string text = "Channels:";
  for (const FeaturedChannel& channel : compared.channels) text += " " + printable(channel.name);
  text += "\n";
  for (const IgnoredChannel& channel : compared.ignored) {
    text += fmt::format("Not compared: {}, because {}\n", printable(channel.name),
                        printable(channel.reason));
  }
  if (compared.things.empty()) return text + "All explorations are compared together.\n";
  text += fmt::format("Compared one by one, by the label '{}':", printable(compared.label));
  for (const std::string& thing : compared.things) text += " " + printable(thing);
  return text + "\n";
}

std::string distance_line(const std::string& what, const TouchDistance& distance) {
  return fmt::format("  {:>8.2f}  {:>8.2f}  {:>6.0f} %  {}\n", distance.median,
                     distance.root_mean_square, 100.0 * distance.within_two, what);
}

std::string distance_lines(const Match& match) {
  return fmt::format(
             "\nDistance from the {} that were held out, in units of the scales of the recording\n"
             "  {:>8}  {:>8}  {:>8}\n",
             counted(match.touch.held_out_explorations, "exploration"), "median", "r.m.s.",
             "below 2") +
         distance_line("the body before, with fresh seeds", mean_distance(match, match.system)) +
         distance_line("the body after: " + counted(match.bodies.size(), "setting") +
                           " of the posterior, with fresh seeds",
                       mean_distance(match, match.fresh)) +
         distance_line("the recording: its first half", match.by_chance);
}

std::string statistics_line(const Match& match) {
  const auto left_out = static_cast<std::size_t>(
      std::count_if(match.left_out.begin(), match.left_out.end(),
                    [](const std::string& reason) { return !reason.empty(); }));
  const auto unreached = static_cast<std::size_t>(
      std::count(match.out_of_reach.begin(), match.out_of_reach.end(), true));
  return fmt::format("{}: {} used, {} left out; {} that no draw reaches\n",
                     counted(match.left_out.size(), "statistic"), match.left_out.size() - left_out,
                     left_out, unreached);
}

}  // namespace

std::string match_table(const Match& match) {
  const SystemSweep& sweep = match.draws.sweep;
  return fmt::format("{}: {}, of which the nearest {} are accepted; fitted to {}\n",
                     printable(names_of(sweep)), counted(match.draws.points.size(), "draw"),
                     match.inference.posterior.size(),
                     counted(match.touch.fitted_explorations, "exploration")) +
         compared_lines(match.touch.compared) + statistics_line(match) + distance_lines(match) +
         "\n" + inferred_unknowns_table(sweep.sweep, match.inference, match.parameters.adjusted);
}

}  // namespace somato::program
