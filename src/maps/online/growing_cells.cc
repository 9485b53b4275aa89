#include "maps/online/growing_cells.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

#include "maps/som/map_parts.h"

namespace somato {
namespace {

using Triangle = GrowingCells::Triangle;

bool has_corner(const Triangle& triangle, std::size_t neuron) {
  return std::find(triangle.begin(), triangle.end(), neuron) != triangle.end();
}

// The triangle with `to` in place of the corner `from`.
Triangle with_other_corner(Triangle triangle, std::size_t from, std::size_t to) {
  std::replace(triangle.begin(), triangle.end(), from, to);
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

// Ascending, with three ascending corners each; every neuron must be a corner.
Result<std::vector<Triangle>> triangles_from(const Archive& archive, const std::string& name,
                                             std::size_t neurons, const std::string& where) {
  SOMATO_TRY(const auto* found, archive.get<Array<std::int64_t>>(name, where));
  const std::size_t count = found->values.size();
  SOMATO_TRY(const auto corners, counts_from(archive, name, count, neurons - 1, where));
  std::vector<Triangle> triangles;
  std::set<std::size_t> used;
  for (std::size_t i = 0; i + 3 <= count; i += 3) {
    triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    used.insert(triangles.back().begin(), triangles.back().end());
  }
  const bool ascending = std::adjacent_find(triangles.begin(), triangles.end(),
                                            std::greater_equal<>()) == triangles.end() &&
                         std::all_of(triangles.begin(), triangles.end(),
                                     [](const Triangle& t) { return t[0] < t[1] && t[1] < t[2]; });
  if (count % 3 == 0 && ascending && used.size() == neurons) return triangles;
  return damaged_model("'" + name + "' does not list triangles of the map", where);
}

}  // namespace

const Declarations<GrowingCellsParameters>& GrowingCellsParameters::declarations() {
  using P = GrowingCellsParameters;
  static const auto declared =
      Declarations<P>()
          .add_from(&P::growth, GrowthParameters::declarations(),
                    {"iterations", "draws", "most_neurons"})
          .add("insertion_interval", &P::insertion_interval, "inputs", Range::between(1, 1e15),
               "Number of inputs between two insertions. Not given in the paper.")
          .add("winner_rate", &P::winner_rate, "", Range::between(0, 1),
               "Learning rate of the winner. Not given in the paper.")
          .add("neighbour_rate", &P::neighbour_rate, "", Range::between(0, 1),
               "Learning rate of the neurons connected with the winner. Not given in the paper.")
          .add("counter_decay", &P::counter_decay, "", Range::between(0, 1),
               "Share that every counter loses with each input. Not given in the paper.")
          .add("deletion_threshold", &P::deletion_threshold, "", Range::between(0, 1),
               "Share of the mean counter below which a neuron is removed; 0: no neuron is. Not "
               "given in the paper.")
          .add_from(&P::growth, GrowthParameters::declarations(),
                    {"softmax", "softmax_exponent", "activity_norm", "seed"});
  return declared;
}

GrowingCells::GrowingCells(const GrowingCellsParameters& parameters, const Samples& samples)
    : parameters_(parameters),
      weights_(drawn_weights(samples, 3, parameters.growth.seed)),
      counters_(3, 0.0),
      triangles_{{0, 1, 2}} {
  connect_again();
}

GrowingCells::GrowingCells(const GrowingCellsParameters& parameters, const Som& som)
    : parameters_(parameters), weights_(som), counters_(som.neurons(), 0.0) {}

void GrowingCells::save(Archive& archive, const std::string& prefix) const {
  archive.add(prefix + "counters", Array<double>{{neurons()}, counters_});
  std::vector<std::uint64_t> corners;
  corners.reserve(3 * triangles_.size());
  for (const Triangle& triangle : triangles_) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  add_counts(archive, prefix + "triangles", corners);
  add_counts(archive, prefix + "inputs", {inputs_});
}

Result<void> GrowingCells::load(const Archive& archive, const std::string& prefix,
                                const std::string& where) {
  constexpr double kMost = std::numeric_limits<double>::max();
  constexpr std::uint64_t kMostInputs = std::numeric_limits<std::int64_t>::max();
  SOMATO_TRY(auto counters,
             numbers_from(archive, prefix + "counters", neurons(), 0.0, kMost, where));
  SOMATO_TRY(auto triangles, triangles_from(archive, prefix + "triangles", neurons(), where));
  SOMATO_TRY(const auto inputs, counts_from(archive, prefix + "inputs", 1, kMostInputs, where));
  counters_ = std::move(counters);
  triangles_ = std::move(triangles);
  inputs_ = inputs.front();
  connect_again();
  return {};
}

void GrowingCells::learn(std::span<const float> input) {
  const std::size_t winner = weights_.nearest_two(input).first;
  weights_.move(winner, input, parameters_.winner_rate);
  for (const std::size_t other : neighbours_[winner]) {
    weights_.move(other, input, parameters_.neighbour_rate);
  }
  counters_[winner] += 1.0;
  for (double& counter : counters_) counter *= 1.0 - parameters_.counter_decay;
  if (++inputs_ % parameters_.insertion_interval != 0) return;
  if (neurons() < parameters_.growth.most_neurons) insert();
  if (parameters_.deletion_threshold > 0.0) remove_rare();
}

void GrowingCells::insert() {
  const auto most = std::max_element(counters_.begin(), counters_.end());
  const auto from = static_cast<std::size_t>(most - counters_.begin());
  const auto distance = [&](std::size_t other) {
    return GrowingWeights::squared_distance(weights_[from], weights_[other]);
  };
  const std::size_t to =
      *std::max_element(neighbours_[from].begin(), neighbours_[from].end(),
                        [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  const std::size_t inserted = neurons();
  weights_.add_between(weights_[from], weights_[to]);
  counters_.push_back(0.0);
  divide(from, to, inserted);
  share_counters(inserted);
}

// Both halves of every triangle on the edge from a to b.
void GrowingCells::divide(std::size_t a, std::size_t b, std::size_t inserted) {
  std::vector<Triangle> divided;
  divided.reserve(triangles_.size() + 2);
  for (const Triangle& triangle : triangles_) {
    if (has_corner(triangle, a) && has_corner(triangle, b)) {
      divided.push_back(with_other_corner(triangle, a, inserted));
      divided.push_back(with_other_corner(triangle, b, inserted));
    } else {
      divided.push_back(triangle);
    }
  }
  std::sort(divided.begin(), divided.end());
  triangles_ = std::move(divided);
  connect_again();
}

void GrowingCells::share_counters(std::size_t inserted) {
  const std::set<std::size_t>& around = neighbours_[inserted];
  for (const std::size_t other : around) {
    const double share = counters_[other] / static_cast<double>(around.size());
    counters_[other] -= share;
    counters_[inserted] += share;
  }
}

// The rarest first, as long as a triangle remains.
void GrowingCells::remove_rare() {
  const double mean = std::accumulate(counters_.begin(), counters_.end(), 0.0) /
                      static_cast<double>(counters_.size());
  std::vector<std::pair<double, std::size_t>> rare;
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    if (counters_[neuron] < parameters_.deletion_threshold * mean) {
      rare.emplace_back(counters_[neuron], neuron);
    }
  }
  std::sort(rare.begin(), rare.end());
  std::vector<Triangle> left = triangles_;
  for (const auto& [counter, neuron] : rare) {
    std::vector<Triangle> others;
    others.reserve(left.size());
    std::copy_if(left.begin(), left.end(), std::back_inserter(others),
                 [n = neuron](const Triangle& triangle) { return !has_corner(triangle, n); });
    if (others.empty()) break;
    left = std::move(others);
  }
  if (left.size() < triangles_.size()) keep(left);
}

// These triangles and their corners only.
void GrowingCells::keep(const std::vector<Triangle>& triangles) {
  std::set<std::size_t> corners;
  for (const Triangle& triangle : triangles) corners.insert(triangle.begin(), triangle.end());
  std::vector<std::size_t> removed;
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    if (!corners.contains(neuron)) removed.push_back(neuron);
  }
  const auto numbers = numbers_after(neurons(), removed);
  weights_.remove(removed);
  std::vector<double> counters;
  counters.reserve(corners.size());
  for (const std::size_t corner : corners) counters.push_back(counters_[corner]);
  counters_ = std::move(counters);
  triangles_ = triangles;
  for (Triangle& triangle : triangles_) {
    for (std::size_t& corner : triangle) corner = *numbers[corner];
  }
  connect_again();
}

void GrowingCells::connect_again() {
  neighbours_.assign(weights_.neurons(), {});
  for (const Triangle& triangle : triangles_) {
    for (const std::size_t a : triangle) {
      for (const std::size_t b : triangle) {
        if (a != b) neighbours_[a].insert(b);
      }
    }
  }
}

Som GrowingCells::map() const {
  std::vector<NeuronGraph::Edge> edges;
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    for (const std::size_t other : neighbours_[neuron]) {
      if (neuron < other) edges.emplace_back(neuron, other);
    }
  }
  return {parameters_of_grown(parameters_.growth, 1, neurons()), weights_.rows(),
          std::make_shared<const NeuronGraph>(neurons(), std::move(edges))};
}

}  // namespace somato
