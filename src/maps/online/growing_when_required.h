#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "maps/online/growing_map.h"
#include "maps/online/nearest_distances.h"
#include "somato/maps/refinement.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The parameters of a map that grows when required (Marsland, Shapiro and Nehmzow, Neural Networks
/// 15, 2002). declarations() gives the meaning, unit and range of each.
struct GrowingWhenRequiredParameters {
  GrowthParameters growth;
  double activity_threshold = 0.4;
  std::optional<double> distance_unit;
  double habituation_threshold = 0.3;
  double insertion_share = 0.5;
  double winner_rate = 0.1;
  double neighbour_rate = 0.01;
  double winner_habituation_time = 3.33;
  double neighbour_habituation_time = 14.3;
  double recovery = 1.05;
  std::size_t oldest_edge = 50;
  bool replace_when_full = false;
  bool by_names = false;
  std::optional<double> most_share;
  Similarity similarity = Similarity::kEuclidean;
  RefinementParameters refinement;

  static const Declarations<GrowingWhenRequiredParameters>& declarations();
};

/// Why the parameter `name` has no effect with the other ones; empty if it has an effect.
std::string reason_without_effect(const GrowingWhenRequiredParameters& parameters,
                                  std::string_view name);

/// Refuses (kUsage) a similarity that is neither Euclidean nor Manhattan, a refinement other than
/// GLVQ, and one of a map that does not learn names.
Result<void> check(const GrowingWhenRequiredParameters& parameters);

/// With the input x, s is the nearest neuron and t the second nearest one, and both are connected
/// by an edge of age 0. If exp(-|x - w_s| / distance_unit) < activity_threshold and the habituation
/// h_s < habituation_threshold, a neuron with the weights w_s + insertion_share (x - w_s) is
/// inserted between them. Otherwise w_s += winner_rate h_s (x - w_s), and w_i += neighbour_rate h_i
/// (x - w_i) for the neurons i connected with s. In both cases all edges of s become older by 1, s
/// and the neurons connected with it habituate: h += (recovery (1 - h) - 1) / time, from 1 for a
/// new neuron; and edges older than oldest_edge and neurons without an edge are removed.
///
/// With replace_when_full, a map with most_neurons neurons makes room for an inserted one, if the
/// two neurons that are nearest to each other are nearer than x and w_s: the later one of these two
/// is removed, and the earlier one takes over its edges. The distances that are represented by one
/// neuron then increase only as far as the limit requires, as in incremental clustering (Charikar,
/// Chekuri, Feder and Motwani, STOC 1997). Not in Marsland and others 2002.
///
/// The automatic distance_unit is NearestDistances::mean() of the samples that were learned so far;
/// while it is 0, every input that differs from all neurons is far. A map of an earlier version
/// keeps its unit, the square root of the number of elements.
///
/// With by_names, each neuron has the class of the input for which it was inserted. Where the
/// nearest neuron has another class than the input, a neuron with the input as weights is inserted,
/// whatever the distance and the habituation. Where none is inserted, the nearest neuron of the
/// input's class takes the mean of the inputs that moved it since it was inserted (MacQueen 1967),
/// no other neuron moves, and neurons without an edge are kept. Not in Marsland and others 2002;
/// inserting what is named wrongly follows Hart 1968 (The condensed nearest neighbor rule).
///
/// With most_share in addition, no neuron is inserted for a class that has as many neurons as this
/// share of its samples, rounded down, but at least one. Samples that are learned again count
/// again.
class GrowingWhenRequired : public GrowingMap {
 public:
  /// Starts with two neurons at samples drawn at random. Throws InvalidArgument with by_names
  /// unless each sample has a class.
  GrowingWhenRequired(const GrowingWhenRequiredParameters& parameters, const NamedSamples& samples);

  /// Learns further from a map of this kind, before load().
  GrowingWhenRequired(const GrowingWhenRequiredParameters& parameters, const Som& som);

  void learn(std::span<const float> input) override { learn_named(input, 0); }
  void learn_named(std::span<const float> input, std::size_t the_class) override;
  void see(const NamedSamples& samples) override;
  void refine(const Som& refined, const std::vector<std::size_t>& classes) override;
  bool add_at(std::span<const float> input, std::size_t the_class) override;
  std::size_t neurons() const override { return weights_.neurons(); }
  Som map() const override;
  std::unique_ptr<GrowingMap> copy() const override {
    return std::make_unique<GrowingWhenRequired>(*this);
  }
  void place(std::size_t neuron, std::span<const float> input, std::size_t the_class) override;
  void resume() override { weights_.number_anew(); }
  const NeuronOrigins& origins() const override { return weights_.origins(); }
  void save(Archive& archive, const std::string& prefix) const override;
  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override;

 private:
  bool is_full() const { return neurons() >= parameters_.growth.most_neurons; }
  bool make_room(double distance);
  double distance_unit() const;
  bool is_far(double distance) const;
  std::size_t insert(const Winners& nearest, std::size_t the_class);
  bool grow_for(Winners& nearest, std::span<const float> input, std::size_t the_class);
  bool class_is_full(std::size_t the_class) const;
  void move_own(std::span<const float> input, std::size_t the_class);
  void adapt(std::size_t winner, std::span<const float> input);
  void habituate(std::size_t neuron, double time);
  void connect(std::size_t a, std::size_t b);
  void disconnect(std::size_t a, std::size_t b);
  void age_edges_of(std::size_t neuron);
  void remove_isolated();
  void remove(const std::vector<std::size_t>& removed);

  GrowingWhenRequiredParameters parameters_;
  NearestDistances nearest_;
  bool has_earlier_unit_ = false;  // of a file of an earlier version
  GrowingWeights weights_;
  std::vector<double> habituation_;
  std::vector<std::map<std::size_t, std::size_t>> ages_;  // of the edges to others
  std::vector<std::uint64_t> names_;                      // classes, with by_names; otherwise empty
  std::vector<std::uint64_t> won_;  // inputs since a neuron was inserted, likewise
  std::map<std::uint64_t, std::uint64_t> seen_of_class_;  // samples, with most_share
};

}  // namespace somato
