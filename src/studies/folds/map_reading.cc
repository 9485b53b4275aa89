#include "studies/folds/map_reading.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

#include "maps/grid/size_order.h"
#include "maps/reading/winner_measures.h"
#include "somato/maps/labels.h"
#include "studies/folds/metrics.h"
#include "studies/measures/most_similar.h"
#include "studies/measures/paper_measures.h"
#include "studies/measures/wrong_groupings.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using Readings = std::vector<MeasuredValue>;
using MapMeasure = std::function<double(const Numbers& classes)>;

Numbers first_of(const Numbers& values, std::size_t count) {
  return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count)};
}

// For each classification, the correct one and wrong ones.
struct Groupings {
  Numbers right;
  std::vector<Numbers> wrong;
};

void add_measure(const std::string& name, const Groupings& groupings, const MapMeasure& measure,
                 Readings& values) {
  values.push_back({name, measure(groupings.right)});
  if (groupings.wrong.empty()) return;  // a value of 0 would state that it never occurs by chance
  MeasuredValue by_chance{name + "_chance"};
  double sum = 0.0;
  for (const Numbers& wrong : groupings.wrong) {
    const double value = measure(wrong);
    sum += value;
    ++by_chance.of_each[value];
  }
  by_chance.value = sum / static_cast<double>(groupings.wrong.size());
  values.push_back(std::move(by_chance));
}

double count_true(const std::vector<bool>& flags) {
  return static_cast<double>(std::count(flags.begin(), flags.end(), true));
}

// Samples of class `a` whose surroundings are of class `b`.
std::size_t mapped_with(const Numbers& classes, const Numbers& surroundings, std::size_t a,
                        std::size_t b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    count += classes[i] == a && surroundings[i] == b ? 1 : 0;
  }
  return count;
}

void read_label(const std::string& prefix, const Groupings& groupings, const Grid& grid,
                const Numbers& winners, Readings& values) {
  add_measure(
      prefix + "classes_separated", groupings,
      [&](const Numbers& classes) { return count_true(separated_classes(winners, classes)); },
      values);
  add_measure(
      prefix + "samples_ambiguous", groupings,
      [&](const Numbers& classes) {
        return static_cast<double>(ambiguous_samples(winners, classes));
      },
      values);
  add_measure(
      prefix + "neighbours_same_class", groupings,
      [&](const Numbers& classes) {
        const Numbers surroundings = classes_of_surroundings(grid, winners, classes);
        double own = 0.0;
        for (std::size_t i = 0; i < classes.size(); ++i)
          own += surroundings[i] == classes[i] ? 1 : 0;
        return own;
      },
      values);
  add_measure(
      prefix + "winner_shared_within_class", groupings,
      [&](const Numbers& classes) {
        return static_cast<double>(samples_sharing_within_class(winners, classes));
      },
      values);
}

// The number of a class, or none that a sample could have.
std::size_t class_named(const Classes& classes, const std::string& name) {
  const auto found = std::find(classes.names.begin(), classes.names.end(), name);
  return static_cast<std::size_t>(found - classes.names.begin());
}

void read_pairs(const StudyParameters& study, const Classes& classes, const Groupings& groupings,
                const Grid& grid, const Numbers& winners, Readings& values) {
  for (const std::string& pair : study.mapped_with) {
    const std::size_t gap = pair.find(' ');
    const std::size_t a = class_named(classes, pair.substr(0, gap));
    const std::size_t b = class_named(classes, pair.substr(gap + 1));
    add_measure(
        "mapped_with " + pair, groupings,
        [&](const Numbers& grouped) {
          return static_cast<double>(
              mapped_with(grouped, classes_of_surroundings(grid, winners, grouped), a, b));
        },
        values);
  }
}

// A measure and its mean over the shuffles.
void add_exceptions(const std::string& name, const CircularOrder& found,
                    const CircularOrderByChance& by_chance, std::size_t CircularOrder::* exceptions,
                    Readings& values) {
  values.push_back({name, static_cast<double>(found.*exceptions)});
  MeasuredValue shuffled{name + "_chance"};
  for (const CircularOrder& one : by_chance.of_each) {
    const auto value = static_cast<double>(one.*exceptions);
    shuffled.value += value;
    ++shuffled.of_each[value];
  }
  shuffled.value /= static_cast<double>(by_chance.of_each.size());
  values.push_back(std::move(shuffled));
}

void read_exceptions(const CircularOrder& found, const CircularOrderByChance& by_chance,
                     Readings& values) {
  add_exceptions("exceptions_around", found, by_chance, &CircularOrder::exceptions_around, values);
  add_exceptions("exceptions_within", found, by_chance, &CircularOrder::exceptions_within, values);
}

// The same in each run: beside the metrics that they limit.
void read_limits(const std::vector<double>& numbers, const Numbers& groups, Readings& values) {
  const auto limits = order_limits(numbers, groups);
  if (!limits) return;
  values.push_back({"order_around_greatest", limits->around});
  values.push_back({"order_within_greatest", limits->within});
  values.push_back({"exceptions_around_least", static_cast<double>(limits->exceptions_around)});
}

void read_order(const StudiedOrder& order, const Grid& grid, const Numbers& winners,
                std::uint64_t seed, Readings& values) {
  constexpr std::size_t kShuffles = 100;
  const Numbers individuals = first_of(order.individuals, winners.size());
  const std::size_t learned = *std::max_element(individuals.begin(), individuals.end()) + 1;
  const std::vector<double> numbers(order.numbers.begin(),
                                    order.numbers.begin() + static_cast<std::ptrdiff_t>(learned));
  const auto mapped =
      mapped_individuals(grid, winners, individuals, numbers, first_of(order.groups, learned));
  const CircularOrder found = circular_order(mapped);
  const CircularOrderByChance by_chance = circular_order_chance(mapped, kShuffles, seed);
  MeasuredValue around{"order_around_chance", by_chance.mean.around};
  MeasuredValue within{"order_within_chance", by_chance.mean.within};
  for (const CircularOrder& shuffled : by_chance.of_each) {
    ++around.of_each[shuffled.around];
    ++within.of_each[shuffled.within];
  }
  values.push_back({"order_around", found.around});
  values.push_back(std::move(around));
  values.push_back({"order_within", found.within});
  values.push_back(std::move(within));
  read_exceptions(found, by_chance, values);
  read_limits(numbers, first_of(order.groups, learned), values);
  const RankOrder along = order_along(mapped, kShuffles, seed);
  values.push_back({"order_along", along.correlation});
  values.push_back({"order_along_chance", along.shuffled});
}

std::vector<SizedThing> things(const StudiedOrder& order, const Numbers& individuals) {
  std::vector<SizedThing> things;
  things.reserve(individuals.size());
  for (const std::size_t individual : individuals) {
    things.push_back({order.numbers[individual], order.groups[individual]});
  }
  return things;
}

Numbers each_its_own(std::size_t count) {
  Numbers numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

// The training individuals, as the classes of their samples' surroundings.
void read_outliers(const StudyParameters& study, const PreparedStudy& prepared, const Grid& grid,
                   const Numbers& winners, std::uint64_t seed, Readings& values) {
  const Numbers individuals = first_of(prepared.order->individuals, winners.size());
  const std::size_t known = *std::max_element(individuals.begin(), individuals.end()) + 1;
  const std::vector<SizedThing> sized = things(*prepared.order, each_its_own(known));
  const Groupings groupings{individuals, wrong_groupings(individuals, each_its_own(winners.size()),
                                                         study.wrong_groupings, seed)};
  add_measure(
      "right_size_wrong_group", groupings,
      [&](const Numbers& dealt) {
        return static_cast<double>(samples_with_size_in_other_group(grid, winners, dealt, sized));
      },
      values);
}

// Parts are numbered in the order of their first neurons.
std::size_t number_of_parts(const NeuronGraph& graph) {
  return *std::max_element(graph.parts().begin(), graph.parts().end()) + 1;
}

// The share of samples mapped with one of the most similar individuals.
double share_with(const std::vector<Numbers>& similar, const Numbers& placed) {
  double right = 0.0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    right += std::count(similar[i].begin(), similar[i].end(), placed[i]) > 0 ? 1.0 : 0.0;
  }
  return right / static_cast<double>(placed.size());
}

// For each known individual the connected part in which most of its samples are; in a tie, the
// first.
Numbers parts_of_individuals(const Numbers& parts, const Numbers& winners,
                             const Numbers& individuals, std::size_t known) {
  std::vector<std::map<std::size_t, std::size_t>> samples(known);
  for (std::size_t i = 0; i < winners.size(); ++i) ++samples[individuals[i]][parts[winners[i]]];
  Numbers most;
  most.reserve(known);
  for (const auto& of_part : samples) {
    most.push_back(
        std::max_element(of_part.begin(), of_part.end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        })->first);
  }
  return most;
}

// The share of new samples in the part of one of the most similar individuals, and the share that
// is expected if the new samples exchange their places at random.
void read_parts(const Grid& grid, const FoldOutcome& outcome, const Numbers& individuals,
                const std::vector<Numbers>& similar, std::size_t known, Readings& values) {
  const Numbers& parts = grid.graph()->parts();
  const Numbers of_known =
      parts_of_individuals(parts, outcome.training_winners, individuals, known);
  const auto is_right = [&](std::size_t sample, std::size_t winner) {
    return std::any_of(similar[sample].begin(), similar[sample].end(),
                       [&](std::size_t one) { return of_known[one] == parts[winner]; });
  };
  const std::size_t count = outcome.winners.size();
  double right = 0.0;
  double by_chance = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    right += is_right(i, outcome.winners[i]) ? 1.0 : 0.0;
    for (const std::size_t winner : outcome.winners) by_chance += is_right(i, winner) ? 1.0 : 0.0;
  }
  const auto all = static_cast<double>(count);
  values.push_back({"placed_in_part_of_most_similar", right / all});
  values.push_back({"placed_in_part_of_most_similar_chance",
                    by_chance / (all * all),
                    {{by_chance / (all * all), 1}}});
}

}  // namespace

std::vector<Numbers> wrong_classes(const StudiedLabel& label, std::size_t explorations,
                                   std::size_t count, std::uint64_t seed) {
  return wrong_groupings(first_of(label.classes.of_sample, explorations),
                         first_of(label.individuals, explorations), count, seed);
}

std::vector<MeasuredValue> read_map(const StudyParameters& study, const PreparedStudy& prepared,
                                    const Grid& grid, const Numbers& winners, std::uint64_t seed) {
  Readings values;
  for (const StudiedLabel& label : prepared.labels) {
    const bool own = &label == &prepared.labels.front();
    const Groupings groupings{first_of(label.classes.of_sample, winners.size()),
                              wrong_classes(label, winners.size(), study.wrong_groupings, seed)};
    read_label(own ? "" : label.name + ".", groupings, grid, winners, values);
    if (!own) continue;
    read_pairs(study, label.classes, groupings, grid, winners, values);
  }
  if (prepared.order) {
    // A graph can be drawn in many ways, so that positions have no meaning.
    if (!grid.graph()) read_order(*prepared.order, grid, winners, seed, values);
    read_outliers(study, prepared, grid, winners, seed, values);
  }
  if (grid.graph()) {
    values.push_back({"neurons", static_cast<double>(grid.size())});
    values.push_back({"connected_parts", static_cast<double>(number_of_parts(*grid.graph()))});
  } else {
    values.push_back({"on_border", share_on_border(grid, winners)});
    const double evenly_spread = border_of(grid);  // an expectation over all groupings
    values.push_back({"on_border_chance", evenly_spread, {{evenly_spread, 1}}});
  }
  if (prepared.fixed_vectors) {
    values.push_back(
        {"cosine_between_classes",
         cosine_between_classes(prepared.fixed_vectors->samples,
                                first_of(prepared.classes().of_sample, winners.size()))});
  }
  return values;
}

std::vector<MeasuredValue> read_placed(const PreparedStudy& prepared, const FoldOutcome& outcome,
                                       std::uint64_t seed) {
  if (!prepared.order) return {};
  const StudiedOrder& order = *prepared.order;
  const std::size_t learned = prepared.samples.samples;
  const Numbers tested(order.individuals.begin() + static_cast<std::ptrdiff_t>(learned),
                       order.individuals.end());
  const Numbers known_samples = first_of(order.individuals, learned);
  const std::size_t known = *std::max_element(known_samples.begin(), known_samples.end()) + 1;
  const auto similar = most_similar(things(order, each_its_own(known)), things(order, tested));
  const Classes individuals{std::vector<std::string>(known), order.individuals};
  Fold fold;
  for (std::size_t i = 0; i < learned; ++i) fold.training.push_back(i);
  const auto neighbours = [&](const Numbers& nearest) {
    Numbers individuals_of_nearest;
    for (const std::size_t sample : nearest)
      individuals_of_nearest.push_back(order.individuals[sample]);
    return individuals_of_nearest;
  };
  Readings values{
      {"placed_with_most_similar", share_with(similar, predictions(individuals, fold, outcome))},
      {"baseline_placed_with_most_similar",
       std::max(share_with(similar, neighbours(outcome.nearest.raw)),
                share_with(similar, neighbours(outcome.nearest.standardized)))}};
  Numbers winners = outcome.training_winners;
  winners.insert(winners.end(), outcome.winners.begin(), outcome.winners.end());
  const Grid& grid = outcome.map.grid;
  if (grid.graph()) {
    read_parts(grid, outcome, order.individuals, similar, known, values);
  } else {
    read_order(order, grid, winners, seed, values);
  }
  return values;
}

}  // namespace somato
