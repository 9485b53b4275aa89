#include "maps/online/growing_when_required.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/core/elementary.h"
#include "maps/som/map_parts.h"
#include "somato/core/check.h"

namespace somato {
namespace {

const std::string kNearestDistances = "nearest_distances";
const std::string kSeenOfClasses = "seen_of_classes";
constexpr std::size_t kFirstNeurons = 2;
constexpr std::uint64_t kMost = std::uint64_t{1} << 53U;  // a class, or inputs won

// Classes in ascending order, each followed by a number of samples.
Result<std::map<std::uint64_t, std::uint64_t>> pairs_from(const Archive& archive,
                                                          const std::string& name,
                                                          const std::string& where) {
  SOMATO_TRY(const auto found, archive.get<Array<std::int64_t>>(name, where));
  SOMATO_TRY(const auto values, counts_from(archive, name, found->values.size(), kMost, where));
  std::map<std::uint64_t, std::uint64_t> pairs;
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) pairs[values[i]] = values[i + 1];
  if (2 * pairs.size() == values.size()) return pairs;
  return damaged_model("'" + name + "' has no number of samples for each class", where);
}

}  // namespace

const Declarations<GrowingWhenRequiredParameters>& GrowingWhenRequiredParameters::declarations() {
  using P = GrowingWhenRequiredParameters;
  static const auto declared =
      Declarations<P>()
          .add_from(&P::growth, GrowthParameters::declarations(),
                    {"iterations", "draws", "most_neurons"})
          .add("activity_threshold", &P::activity_threshold, "", Range::between(0, 1),
               "A neuron is inserted if exp(-d / distance_unit) is below it, for the distance d of "
               "the winner from the input. Not given in the paper.")
          .add("distance_unit", &P::distance_unit, "", Range::above(0),
               "Unit of distances in the activity; 1 in Marsland and others 2002. Automatic: the "
               "mean "
               "distance of the inputs learned so far from their nearest neighbours, so that "
               "neither the unit of the inputs nor a constant element has an effect. Not given in "
               "the paper.")
          .add("habituation_threshold", &P::habituation_threshold, "", Range::between(0, 2),
               "A neuron is inserted only if the winner's habituation is below it. It is 1 for a "
               "new neuron and falls to 0.05: above 1, every neuron allows insertion. Not given in "
               "the paper.")
          .add("insertion_share", &P::insertion_share, "", Range::between(0, 1),
               "Place of an inserted neuron on the way from the winner to the input; 0.5 in "
               "Marsland and others 2002, 1: at the input.")
          .add("winner_rate", &P::winner_rate, "", Range::between(0, 1),
               "Learning rate of the winner, times its habituation. Not given in the paper.")
          .add("neighbour_rate", &P::neighbour_rate, "", Range::between(0, 1),
               "Learning rate of the neurons connected with the winner, times their habituation. "
               "Not given in the paper.")
          .add("winner_habituation_time", &P::winner_habituation_time, "inputs",
               Range::between(1.05, 1e6),
               "Time constant with which the winner habituates; 3.33 in Marsland and others 2002.")
          .add("neighbour_habituation_time", &P::neighbour_habituation_time, "inputs",
               Range::between(1.05, 1e6),
               "Time constant with which the neurons connected with the winner habituate; 14.3 in "
               "Marsland and others 2002.")
          .add("recovery", &P::recovery, "", Range::between(1, 2),
               "Constant of recovery: habituation ends at 1 - 1 / recovery; 1.05 in Marsland and "
               "others 2002.")
          .add("oldest_edge", &P::oldest_edge, "inputs", Range::between(1, 1e9),
               "Age at which an edge is kept for the last time. Not given in the paper.")
          .add("replace_when_full", &P::replace_when_full, "", Range::any(),
               "Whether a map with `most_neurons` neurons removes one of the two that are nearest "
               "to each other, to insert a neuron for an input that is farther from the winner "
               "than these are from each other. Not given in the paper.")
          .add("by_names", &P::by_names, "", Range::any(),
               "Whether a neuron is also inserted, at the input, where the nearest neuron has "
               "another class than the input, in place of moving towards it. Needs a label. Not "
               "given in the paper.")
          .add("most_share", &P::most_share, "", Range::between(0, 1),
               "Greatest number of neurons of a class, as a share of its inputs: rounded down, at "
               "least one. Beyond it, the class's nearest neuron moves in place of an insertion. "
               "Automatic: no limit but most_neurons. With by_names only. Not given in the paper.")
          .add("similarity", &P::similarity, "", Range::any(),
               "Distance of neurons and inputs: euclidean, as in Marsland and others 2002, or "
               "manhattan. Not given in the paper.")
          .add_from(&P::refinement, RefinementParameters::declarations(),
                    {"refine", "refine_passes", "refine_learning_rate", "refine_steepness_start",
                     "refine_steepness_end"})
          .add_from(&P::growth, GrowthParameters::declarations(),
                    {"softmax", "softmax_exponent", "activity_norm", "seed"});
  return declared;
}

std::string reason_without_effect(const GrowingWhenRequiredParameters& parameters,
                                  std::string_view name) {
  if (name == "most_share" && !parameters.by_names) return "by_names is false";
  return reason_without_effect(parameters.refinement, name);
}

Result<void> check(const GrowingWhenRequiredParameters& parameters) {
  if (parameters.similarity != Similarity::kEuclidean &&
      parameters.similarity != Similarity::kManhattan) {
    return fail(
        ErrorKind::kUsage,
        fmt::format("a map that grows has no similarity '{}'", choice_name(parameters.similarity)),
        "similarity", "choose euclidean or manhattan");
  }
  const Refinement refine = parameters.refinement.refine;
  if (refine == Refinement::kNone) return {};
  if (refine != Refinement::kGlvq) {
    return fail(ErrorKind::kUsage,
                fmt::format("a map that grows cannot be refined by '{}'", choice_name(refine)),
                "refine", "choose glvq, or leave 'refine' out");
  }
  if (parameters.by_names) return {};
  return fail(ErrorKind::kUsage,
              "a map that grows is refined by the names that it learns, and learns none here",
              "refine", "set by_names = true, or leave 'refine' out");
}

GrowingWhenRequired::GrowingWhenRequired(const GrowingWhenRequiredParameters& parameters,
                                         const NamedSamples& samples)
    : parameters_(parameters),
      weights_(drawn_weights(samples.samples, kFirstNeurons, parameters.growth.seed,
                             parameters.similarity)),
      habituation_(kFirstNeurons, 1.0),
      ages_(kFirstNeurons) {
  require(!parameters_.by_names || samples.classes.size() == samples.samples.count(),
          "a map that learns names needs the class of each sample");
  GrowingWhenRequired::see(samples);
  if (!parameters_.by_names) return;
  for (const std::size_t drawn :
       drawn_samples(samples.samples, kFirstNeurons, parameters.growth.seed)) {
    names_.push_back(samples.classes[drawn]);
  }
  won_.assign(kFirstNeurons, 1);
}

GrowingWhenRequired::GrowingWhenRequired(const GrowingWhenRequiredParameters& parameters,
                                         const Som& som)
    : parameters_(parameters),
      weights_(som),
      habituation_(som.neurons(), 1.0),
      ages_(som.neurons()) {
  for (const auto& [a, b] : som.grid().graph()->edges()) connect(a, b);
}

void GrowingWhenRequired::save(Archive& archive, const std::string& prefix) const {
  archive.add(prefix + "habituation", Array<double>{{neurons()}, habituation_});
  std::vector<std::uint64_t> ages;
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    for (const auto& [other, age] : ages_[neuron]) {
      if (neuron < other) ages.push_back(age);
    }
  }
  add_counts(archive, prefix + "ages", ages);
  if (!parameters_.distance_unit && !has_earlier_unit_) {
    nearest_.save(archive, prefix + kNearestDistances);
  }
  if (!parameters_.by_names) return;
  add_counts(archive, prefix + "names", names_);
  add_counts(archive, prefix + "won", won_);
  if (!parameters_.most_share) return;
  std::vector<std::uint64_t> seen;
  for (const auto& [the_class, samples] : seen_of_class_) {
    seen.push_back(the_class);
    seen.push_back(samples);
  }
  add_counts(archive, prefix + kSeenOfClasses, seen);
}

Result<void> GrowingWhenRequired::load(const Archive& archive, const std::string& prefix,
                                       const std::string& where) {
  std::size_t edges = 0;
  for (const auto& of_neuron : ages_) edges += of_neuron.size();
  // Its distance from 1 - 1 / recovery does not increase, and is 1 / recovery at first.
  SOMATO_TRY(auto habituation,
             numbers_from(archive, prefix + "habituation", neurons(), -1.0, 1.0, where));
  SOMATO_TRY(const auto ages,
             counts_from(archive, prefix + "ages", edges / 2, parameters_.oldest_edge, where));
  has_earlier_unit_ = archive.find(prefix + kNearestDistances) == nullptr;
  if (!has_earlier_unit_) {
    SOMATO_TRY_VOID(nearest_.load(archive, prefix + kNearestDistances, where));
  }
  if (parameters_.by_names) {
    SOMATO_TRY(names_, counts_from(archive, prefix + "names", neurons(), kMost, where));
    SOMATO_TRY(won_, counts_from(archive, prefix + "won", neurons(), kMost, where));
    if (parameters_.most_share) {
      SOMATO_TRY(seen_of_class_, pairs_from(archive, prefix + kSeenOfClasses, where));
    }
  }
  habituation_ = std::move(habituation);
  auto next = ages.begin();
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    for (auto& [other, age] : ages_[neuron]) {
      if (neuron < other) age = ages_[other][neuron] = *next++;
    }
  }
  return {};
}

void GrowingWhenRequired::see(const NamedSamples& samples) {
  nearest_.see(samples.samples, weights_.rows(), parameters_.similarity);
  if (!parameters_.most_share) return;
  for (const std::size_t the_class : samples.classes) ++seen_of_class_[the_class];
}

void GrowingWhenRequired::refine(const Som& refined, const std::vector<std::size_t>& classes) {
  require(parameters_.by_names && refined.neurons() == neurons() && classes.size() == neurons(),
          "a refined map has the neurons of this one, which must learn names");
  const Matrix<float> rows = refined.weights().to_matrix();
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    weights_.place(neuron, rows.row(neuron));
    names_[neuron] = classes[neuron];
  }
}

double GrowingWhenRequired::distance_unit() const {
  if (has_earlier_unit_ && !parameters_.distance_unit) {
    return std::sqrt(static_cast<double>(weights_.rows().columns()));
  }
  return parameters_.distance_unit.value_or(nearest_.mean());
}

bool GrowingWhenRequired::is_far(double distance) const {
  const double unit = distance_unit();
  if (!(unit > 0.0)) return distance > 0.0;
  return exponential(-distance / unit) < parameters_.activity_threshold;
}

void GrowingWhenRequired::learn_named(std::span<const float> input, std::size_t the_class) {
  Winners nearest = weights_.nearest_two(input);
  connect(nearest.first, nearest.second);
  if (!grow_for(nearest, input, the_class)) {
    if (parameters_.by_names) {
      move_own(input, the_class);
    } else {
      adapt(nearest.first, input);
    }
  }
  habituate(nearest.first, parameters_.winner_habituation_time);
  for (const auto& [other, age] : ages_[nearest.first]) {
    habituate(other, parameters_.neighbour_habituation_time);
  }
  age_edges_of(nearest.first);
  if (!parameters_.by_names) remove_isolated();
}

// Returns whether a neuron was inserted; `nearest` changes if one of them was removed for it.
bool GrowingWhenRequired::grow_for(Winners& nearest, std::span<const float> input,
                                   std::size_t the_class) {
  const double distance = weights_.distance(nearest.first, input);
  const bool is_wrong = parameters_.by_names && names_[nearest.first] != the_class;
  const bool may_grow = habituation_[nearest.first] < parameters_.habituation_threshold;
  if (!is_wrong && !(is_far(distance) && may_grow)) return false;
  if (class_is_full(the_class) || !make_room(distance)) return false;
  nearest = weights_.nearest_two(input);
  weights_.move(insert(nearest, the_class), input, is_wrong ? 1.0 : parameters_.insertion_share);
  return true;
}

bool GrowingWhenRequired::add_at(std::span<const float> input, std::size_t the_class) {
  if (is_full()) return false;
  weights_.place(insert(weights_.nearest_two(input), the_class), input);
  return true;
}

void GrowingWhenRequired::place(std::size_t neuron, std::span<const float> input,
                                std::size_t the_class) {
  weights_.place(neuron, input);
  if (!parameters_.by_names) return;
  names_[neuron] = the_class;
  won_[neuron] = 1;
}

// Returns whether another neuron can be inserted, for an input at that distance from its winner.
bool GrowingWhenRequired::make_room(double distance) {
  if (!is_full()) return true;
  if (!parameters_.replace_when_full || neurons() < 3) return false;
  const auto [kept, removed] = weights_.nearest_pair();
  if (weights_.distance(kept, weights_[removed]) >= distance) return false;
  for (const auto& [other, age] : ages_[removed]) {
    if (other == kept || ages_[kept].contains(other)) continue;
    ages_[kept][other] = age;
    ages_[other][kept] = age;
  }
  remove({removed});
  return true;
}

// At the weights of the nearest neuron at first.
std::size_t GrowingWhenRequired::insert(const Winners& nearest, std::size_t the_class) {
  const std::size_t inserted = neurons();
  weights_.add(weights_[nearest.first]);
  habituation_.push_back(1.0);
  ages_.emplace_back();
  if (parameters_.by_names) {
    names_.push_back(the_class);
    won_.push_back(1);
  }
  connect(inserted, nearest.first);
  connect(inserted, nearest.second);
  disconnect(nearest.first, nearest.second);
  return inserted;
}

// With most_share: whether its neurons are that share of its samples already.
bool GrowingWhenRequired::class_is_full(std::size_t the_class) const {
  if (!parameters_.by_names || !parameters_.most_share) return false;
  const auto kept = std::count(names_.begin(), names_.end(), the_class);
  const auto seen = seen_of_class_.find(the_class);
  const auto samples = seen == seen_of_class_.end() ? 0.0 : static_cast<double>(seen->second);
  constexpr double kRounding = 1e-9;  // 0.29 of 100 are 29, and not fewer by the last digit
  const double most = std::floor(*parameters_.most_share * samples * (1.0 + kRounding));
  return static_cast<double>(kept) >= std::max(1.0, most);
}

// The nearest neuron of the input's class, the first in a tie, takes the mean of its inputs.
void GrowingWhenRequired::move_own(std::span<const float> input, std::size_t the_class) {
  const auto own =
      weights_.nearest_of(input, [&](std::size_t neuron) { return names_[neuron] == the_class; });
  if (!own) return;
  won_[*own] += 1;
  weights_.move(*own, input, 1.0 / static_cast<double>(won_[*own]));
}

void GrowingWhenRequired::adapt(std::size_t winner, std::span<const float> input) {
  weights_.move(winner, input, parameters_.winner_rate * habituation_[winner]);
  for (const auto& [other, age] : ages_[winner]) {
    weights_.move(other, input, parameters_.neighbour_rate * habituation_[other]);
  }
}

void GrowingWhenRequired::habituate(std::size_t neuron, double time) {
  double& h = habituation_[neuron];
  h += (parameters_.recovery * (1.0 - h) - 1.0) / time;
}

void GrowingWhenRequired::connect(std::size_t a, std::size_t b) {
  ages_[a][b] = 0;
  ages_[b][a] = 0;
}

void GrowingWhenRequired::disconnect(std::size_t a, std::size_t b) {
  ages_[a].erase(b);
  ages_[b].erase(a);
}

void GrowingWhenRequired::age_edges_of(std::size_t neuron) {
  std::vector<std::size_t> too_old;
  for (auto& [other, age] : ages_[neuron]) {
    age += 1;
    ages_[other][neuron] = age;
    if (age > parameters_.oldest_edge) too_old.push_back(other);
  }
  for (const std::size_t other : too_old) disconnect(neuron, other);
}

void GrowingWhenRequired::remove_isolated() {
  std::vector<std::size_t> isolated;
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    if (ages_[neuron].empty()) isolated.push_back(neuron);
  }
  if (!isolated.empty()) remove(isolated);
}

// With their edges.
void GrowingWhenRequired::remove(const std::vector<std::size_t>& removed) {
  const auto numbers = numbers_after(neurons(), removed);
  weights_.remove(removed);
  std::vector<std::map<std::size_t, std::size_t>> ages(neurons());
  std::vector<double> habituation(neurons());
  for (auto* counts : {&names_, &won_}) {
    for (auto one = removed.rbegin(); one != removed.rend() && !counts->empty(); ++one) {
      counts->erase(counts->begin() + static_cast<std::ptrdiff_t>(*one));
    }
  }
  for (std::size_t neuron = 0; neuron < numbers.size(); ++neuron) {
    if (!numbers[neuron]) continue;
    habituation[*numbers[neuron]] = habituation_[neuron];
    for (const auto& [other, age] : ages_[neuron]) {
      if (numbers[other]) ages[*numbers[neuron]][*numbers[other]] = age;
    }
  }
  ages_ = std::move(ages);
  habituation_ = std::move(habituation);
}

Som GrowingWhenRequired::map() const {
  std::vector<NeuronGraph::Edge> edges;
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    for (const auto& [other, age] : ages_[neuron]) {
      if (neuron < other) edges.emplace_back(neuron, other);
    }
  }
  return {parameters_of_grown(parameters_.growth, 1, neurons(), parameters_.similarity),
          weights_.rows(), std::make_shared<const NeuronGraph>(neurons(), std::move(edges))};
}

}  // namespace somato
