#include "somato/maps/som_learner.h"

#include "core/lanes.h"
#include "maps/map_rows.h"

namespace somato {
namespace {

// Weights of elements that are mostly zero decay until they are slow to compute with; their squares
// have left the range of single precision long before.
constexpr std::uint64_t kIterationsBetweenClearings = 64;

}  // namespace

SomLearner::SomLearner(Som& som)
    : som_(som),
      neighbourhood_(som.grid(), som.parameters().neighbourhood),
      gains_(som.weights().padded_rows()) {}

std::size_t SomLearner::learn(const SignalView& input, double learning_rate, double radius) {
  std::span<const float> seen = som_.prepare(input, workspace_);
  if (workspace_.left_out_ > 0.0) {
    som_.store_all();
    seen = som_.prepare(input, workspace_);
  }
  const std::size_t winner = som_.winner_of(seen, workspace_);
  neighbourhood_.around(winner, radius, gains_);
  const auto rate = static_cast<float>(learning_rate);
  for (float& gain : gains_) gain *= rate;
  kernels::table<float>().move_towards(kernels::lanes(som_.weights()), seen.data(), gains_.data());
  if (som_.parameters().similarity == Similarity::kDotProduct) {
    normalize_rows(som_.weights(), factors_);
  }
  if (++learned_ % kIterationsBetweenClearings == 0) {
    kernels::table<float>().clear_negligible(kernels::lanes(som_.weights()));
  }
  return winner;
}

}  // namespace somato
