#include "maps/online/growing_when_required.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/core/elementary.h"

namespace somato {

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
               "square root of the number of elements, so that the threshold applies to the mean "
               "difference of an element. Not given in the paper.")
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
          .add_from(&P::growth, GrowthParameters::declarations(),
                    {"softmax", "softmax_exponent", "activity_norm", "seed"});
  return declared;
}

GrowingWhenRequired::GrowingWhenRequired(const GrowingWhenRequiredParameters& parameters,
                                         const Samples& samples)
    : parameters_(parameters),
      distance_unit_(
          parameters.distance_unit.value_or(std::sqrt(static_cast<double>(samples.size())))),
      weights_(drawn_weights(samples, 2, parameters.growth.seed)),
      habituation_(2, 1.0),
      ages_(2) {}

GrowingWhenRequired::GrowingWhenRequired(const GrowingWhenRequiredParameters& parameters,
                                         const Som& som)
    : parameters_(parameters),
      distance_unit_(
          parameters.distance_unit.value_or(std::sqrt(static_cast<double>(som.input_size())))),
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
  habituation_ = std::move(habituation);
  auto next = ages.begin();
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    for (auto& [other, age] : ages_[neuron]) {
      if (neuron < other) age = ages_[other][neuron] = *next++;
    }
  }
  return {};
}

void GrowingWhenRequired::learn(std::span<const float> input) {
  Winners nearest = weights_.nearest_two(input);
  connect(nearest.first, nearest.second);
  const double distance =
      std::sqrt(GrowingWeights::squared_distance(weights_[nearest.first], input));
  const bool is_far = exponential(-distance / distance_unit_) < parameters_.activity_threshold;
  const bool may_grow = habituation_[nearest.first] < parameters_.habituation_threshold;
  if (is_far && may_grow && make_room(distance)) {
    nearest = weights_.nearest_two(input);  // if one of them was removed
    weights_.move(insert(nearest), input, parameters_.insertion_share);
  } else {
    adapt(nearest.first, input);
  }
  habituate(nearest.first, parameters_.winner_habituation_time);
  for (const auto& [other, age] : ages_[nearest.first]) {
    habituate(other, parameters_.neighbour_habituation_time);
  }
  age_edges_of(nearest.first);
  remove_isolated();
}

bool GrowingWhenRequired::add_at(std::span<const float> input) {
  if (is_full()) return false;
  weights_.place(insert(weights_.nearest_two(input)), input);
  return true;
}

// Returns whether another neuron can be inserted, for an input at that distance from its winner.
bool GrowingWhenRequired::make_room(double distance) {
  if (!is_full()) return true;
  if (!parameters_.replace_when_full || neurons() < 3) return false;
  const auto [kept, removed] = weights_.nearest_pair();
  if (GrowingWeights::squared_distance(weights_[kept], weights_[removed]) >= distance * distance) {
    return false;
  }
  for (const auto& [other, age] : ages_[removed]) {
    if (other == kept || ages_[kept].contains(other)) continue;
    ages_[kept][other] = age;
    ages_[other][kept] = age;
  }
  remove({removed});
  return true;
}

// At the weights of the nearest neuron at first.
std::size_t GrowingWhenRequired::insert(const Winners& nearest) {
  const std::size_t inserted = neurons();
  weights_.add(weights_[nearest.first]);
  habituation_.push_back(1.0);
  ages_.emplace_back();
  connect(inserted, nearest.first);
  connect(inserted, nearest.second);
  disconnect(nearest.first, nearest.second);
  return inserted;
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
  return {parameters_of_grown(parameters_.growth, 1, neurons()), weights_.rows(),
          std::make_shared<const NeuronGraph>(neurons(), std::move(edges))};
}

}  // namespace somato
