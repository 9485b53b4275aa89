#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "maps/online/growing_map.h"

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

  static const Declarations<GrowingWhenRequiredParameters>& declarations();
};

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
class GrowingWhenRequired : public GrowingMap {
 public:
  /// Starts with two neurons at samples drawn at random.
  GrowingWhenRequired(const GrowingWhenRequiredParameters& parameters, const Samples& samples);

  /// Learns further from a map of this kind, before load().
  GrowingWhenRequired(const GrowingWhenRequiredParameters& parameters, const Som& som);

  void learn(std::span<const float> input) override;
  bool add_at(std::span<const float> input) override;
  std::size_t neurons() const override { return weights_.neurons(); }
  Som map() const override;
  std::unique_ptr<GrowingMap> copy() const override {
    return std::make_unique<GrowingWhenRequired>(*this);
  }
  void place(std::size_t neuron, std::span<const float> input) override {
    weights_.place(neuron, input);
  }
  void resume() override { weights_.number_anew(); }
  const NeuronOrigins& origins() const override { return weights_.origins(); }
  void save(Archive& archive, const std::string& prefix) const override;
  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override;

 private:
  bool is_full() const { return neurons() >= parameters_.growth.most_neurons; }
  bool make_room(double distance);
  std::size_t insert(const Winners& nearest);
  void adapt(std::size_t winner, std::span<const float> input);
  void habituate(std::size_t neuron, double time);
  void connect(std::size_t a, std::size_t b);
  void disconnect(std::size_t a, std::size_t b);
  void age_edges_of(std::size_t neuron);
  void remove_isolated();
  void remove(const std::vector<std::size_t>& removed);

  GrowingWhenRequiredParameters parameters_;
  double distance_unit_;
  GrowingWeights weights_;
  std::vector<double> habituation_;
  std::vector<std::map<std::size_t, std::size_t>> ages_;  // of the edges to others
};

}  // namespace somato
