#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "maps/online/growing_map.h"

namespace somato {

/// The parameters of a growing grid (Fritzke, Neural Processing Letters 2, 1995). declarations()
/// gives the meaning, unit and range of each.
struct GrowingGridParameters {
  GrowthParameters growth;
  std::uint64_t growth_inputs = 30;
  std::uint64_t tuning_inputs = 100;
  double radius = 0.7;
  double learning_rate_start = 0.1;
  double learning_rate_end = 0.005;

  static const Declarations<GrowingGridParameters>& declarations();
};

/// A rectangular map that starts with 2 x 2 neurons. With each input x and the nearest neuron s,
/// all neurons r move: w_r += learning_rate exp(-d^2 / (2 radius^2)) (x - w_r), where d is the sum
/// of the differences of their rows and columns; the counter of s increases by 1.
///
/// While the map grows, the rate is learning_rate_start. After growth_inputs inputs for each
/// neuron, a row or column is inserted between the neuron with the greatest counter and the one
/// beside it whose weights are most distant; its weights are the means of those beside it, and all
/// counters become 0. Once another row or column could exceed most_neurons, the rate falls to
/// learning_rate_end exponentially within tuning_inputs inputs for each neuron. Then the map is
/// complete.
class GrowingGrid : public GrowingMap {
 public:
  /// Starts with samples drawn at random.
  GrowingGrid(const GrowingGridParameters& parameters, const Samples& samples);

  /// Learns further from a map of this kind, before load().
  GrowingGrid(const GrowingGridParameters& parameters, const Som& som);

  void learn(std::span<const float> input) override;
  bool is_complete() const override { return tuned_ >= tuning_inputs(); }
  std::size_t neurons() const override { return weights_.neurons(); }
  Som map() const override;
  std::unique_ptr<GrowingMap> copy() const override { return std::make_unique<GrowingGrid>(*this); }
  void place(std::size_t neuron, std::span<const float> input, std::size_t /*the_class*/) override {
    weights_.place(neuron, input);
  }
  void resume() override;
  const NeuronOrigins& origins() const override { return weights_.origins(); }
  void save(Archive& archive, const std::string& prefix) const override;
  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override;

 private:
  Grid grid() const { return {rows_, columns_, Lattice::kRectangular, Topology::kPlane}; }
  bool grows() const {
    return neurons() + std::max(rows_, columns_) <= parameters_.growth.most_neurons;
  }
  std::uint64_t tuning_inputs() const { return parameters_.tuning_inputs * neurons(); }
  double learning_rate() const;
  void adapt(std::size_t winner, std::span<const float> input, double rate);
  void insert();
  void insert_between(std::size_t a, std::size_t b);

  GrowingGridParameters parameters_;
  std::size_t rows_ = 2;
  std::size_t columns_ = 2;
  GrowingWeights weights_;
  std::vector<std::uint64_t> counters_;
  std::uint64_t inputs_ = 0;  // since the last insertion
  std::uint64_t tuned_ = 0;   // since the map has its size
};

}  // namespace somato
