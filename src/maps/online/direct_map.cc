#include "maps/online/direct_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/core/lanes.h"
#include "maps/som/map_rows.h"

namespace somato {
namespace {

// Below it multiplying gets slow, and no weight moves.
constexpr double kLeastGain = 0x1p-100;

// Vectors to read that take longer than telling other threads.
constexpr std::size_t kVectorsWorthSharing = std::size_t{1} << 12;

// A member that has completed its parts takes over parts of others.
constexpr std::size_t kPartsOfMember = 4;

// Weights of elements that are mostly zero decay until they are slow to compute with.
constexpr std::size_t kInputsBetweenClearings = 64;

}  // namespace

DirectMap::DirectMap(Som& som, ThreadTeam& team)
    : som_(som),
      team_(team),
      neighbourhood_(som.grid(), som.parameters().neighbourhood),
      neighbours_(som.neurons()),
      gains_(som.weights().padded_rows()) {
  weights_to_change(som);  // before threads read them
}

// Blocks of neurons, by several threads if there are enough vectors.
void DirectMap::for_each_part(
    const std::function<void(std::size_t first, std::size_t blocks)>& work) {
  const std::size_t blocks = som_.weights().blocks();
  if (blocks * som_.weights().columns() < kVectorsWorthSharing || team_.size() == 1) {
    work(0, blocks);
    return;
  }
  const std::size_t parts = std::min(blocks, kPartsOfMember * team_.size());
  team_.for_each(parts, [&](std::size_t part) {
    const std::size_t first = part * blocks / parts;
    work(first, (part + 1) * blocks / parts - first);
  });
}

Learned DirectMap::learn(std::span<const OnlineInput> inputs, std::span<const LearningStep> steps) {
  const std::span<const float> input = som_.prepare(inputs.front().values, workspace_);
  if (workspace_.left_out_ > 0.0) return {};
  const std::vector<KnownRun> known = known_runs(input);
  const std::size_t nearest = winner(input, known);
  neighbourhood_.around(nearest, steps.front().radius, neighbours_);
  move(input, known, steps.front().learning_rate);
  return {1, nearest};
}

std::size_t DirectMap::winner(std::span<const float> input, const std::vector<KnownRun>& known) {
  AlignedVector<float>& scores = workspace_.scores_;
  scores.resize(som_.weights().padded_rows());
  const KnownScores known_scores(som_.parameters(), input, known);
  for_each_part([&](std::size_t first, std::size_t blocks) {
    const auto weights = kernels::lanes(std::as_const(weights_to_change(som_)));
    const std::size_t begin = first * kFloatLanes;
    known_scores.write({weights.values + begin * weights.columns, blocks, weights.columns},
                       std::min(som_.neurons() - begin, blocks * kFloatLanes),
                       scores.data() + begin);
  });
  const bool complete = known.size() == 1 && known.front().count == input.size();
  if (!complete) return known_scores.winner(som_, {scores.data(), som_.neurons()});
  std::fill(scores.begin() + static_cast<std::ptrdiff_t>(som_.neurons()), scores.end(),
            std::numeric_limits<float>::infinity());
  return som_.decide(scores, input, false, workspace_).first;
}

void DirectMap::move(std::span<const float> input, const std::vector<KnownRun>& known,
                     double learning_rate) {
  for (std::size_t neuron = 0; neuron < som_.neurons(); ++neuron) {
    const double gain = learning_rate * double{neighbours_[neuron]};
    gains_[neuron] = std::fabs(gain) < kLeastGain ? 0.0F : static_cast<float>(gain);
  }
  const bool clears = ++learned_since_clearing_ >= kInputsBetweenClearings;
  if (clears) learned_since_clearing_ = 0;
  for_each_part([&](std::size_t first, std::size_t blocks) {
    const auto weights = kernels::lanes(weights_to_change(som_));
    const std::size_t begin = first * kFloatLanes;
    const kernels::Lanes<float> part{weights.values + begin * weights.columns, blocks,
                                     weights.columns};
    for (const KnownRun& run : known) {
      kernels::table<float>().move_towards(
          {part.values + run.first * kFloatLanes, blocks, run.count, part.stride},
          input.data() + run.first, gains_.data() + begin);
    }
    if (clears) kernels::table<float>().clear_negligible(part);
  });
}

}  // namespace somato
