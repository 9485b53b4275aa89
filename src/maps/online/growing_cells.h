#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "maps/online/growing_map.h"

namespace somato {

/// The parameters of growing cell structures (Fritzke, Neural Networks 7, 1994). declarations()
/// gives the meaning, unit and range of each.
struct GrowingCellsParameters {
  GrowthParameters growth;
  std::uint64_t insertion_interval = 100;
  double winner_rate = 0.06;
  double neighbour_rate = 0.002;
  double counter_decay = 0.005;
  double deletion_threshold = 0.0;

  static const Declarations<GrowingCellsParameters>& declarations();
};

/// Neurons are the corners of triangles. With each input x, the nearest neuron s and the neurons
/// connected with it move: w += rate (x - w); the counter of s increases by 1, and all counters are
/// multiplied by 1 - counter_decay.
///
/// With every insertion_interval-th input, a neuron is inserted in the middle of an edge, which
/// divides its triangles: the edge leads from the neuron with the greatest counter to the most
/// distant one that is connected with it. Each of the n neurons connected with the new one gives it
/// 1 / n of its counter.
///
/// Then, with a deletion_threshold above 0, neurons whose counter is below this share of the mean
/// counter are removed with their triangles, and so are all neurons without a triangle. The map can
/// fall apart; the last triangle remains.
class GrowingCells : public GrowingMap {
 public:
  /// Three corners, ascending.
  using Triangle = std::array<std::size_t, 3>;

  /// Starts with a triangle at samples drawn at random.
  GrowingCells(const GrowingCellsParameters& parameters, const Samples& samples);

  /// Learns further from a map of this kind, before load().
  GrowingCells(const GrowingCellsParameters& parameters, const Som& som);

  void learn(std::span<const float> input) override;
  std::size_t neurons() const override { return weights_.neurons(); }
  Som map() const override;
  std::unique_ptr<GrowingMap> copy() const override {
    return std::make_unique<GrowingCells>(*this);
  }
  void place(std::size_t neuron, std::span<const float> input, std::size_t /*the_class*/) override {
    weights_.place(neuron, input);
  }
  void resume() override { weights_.number_anew(); }
  const NeuronOrigins& origins() const override { return weights_.origins(); }
  void save(Archive& archive, const std::string& prefix) const override;
  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override;

  /// The triangles, ascending.
  const std::vector<Triangle>& triangles() const { return triangles_; }

  /// The number of wins of each neuron, with decay.
  const std::vector<double>& counters() const { return counters_; }

 private:
  void insert();
  void share_counters(std::size_t inserted);
  void divide(std::size_t a, std::size_t b, std::size_t inserted);
  void remove_rare();
  void keep(const std::vector<Triangle>& triangles);
  void connect_again();

  GrowingCellsParameters parameters_;
  GrowingWeights weights_;
  std::vector<double> counters_;
  std::vector<Triangle> triangles_;
  std::vector<std::set<std::size_t>> neighbours_;
  std::uint64_t inputs_ = 0;
};

}  // namespace somato
