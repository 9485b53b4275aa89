#include "maps/t_mpsom/t_mpsom_learner.h"

#include <algorithm>

#include "base/core/lanes.h"
#include "base/kernels/kernels.h"
#include "maps/t_mpsom/t_mpsom_arbor.h"
#include "maps/t_mpsom/t_mpsom_input.h"
#include "maps/t_mpsom/t_mpsom_moving.h"
#include "maps/t_mpsom/t_mpsom_receptive_input.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::size_t kGroup = TMpsomArbor::kNeurons;

std::size_t blocks_of(const LaneMatrix<float>& weights, std::size_t group) {
  return std::min(TMpsomArbor::kBlocks, weights.blocks() - group * TMpsomArbor::kBlocks);
}

kernels::Lanes<float> lanes_of(LaneMatrix<float>& weights, std::size_t group) {
  return {weights.data() + group * kGroup * weights.columns(), blocks_of(weights, group),
          weights.columns()};
}

}  // namespace

TMpsomLearner::Part::Part(std::size_t elements, std::size_t padded_neurons, std::size_t groups)
    : receptive(elements),
      sample(elements),
      keep(padded_neurons),
      add(padded_neurons),
      doubtful(padded_neurons),
      products(padded_neurons),
      squares(padded_neurons),
      waits(groups) {}

kernels::Moves TMpsomLearner::Part::moves(std::size_t neuron) {
  return {keep.data() + neuron, add.data() + neuron, doubtful.data() + neuron};
}

kernels::Measures TMpsomLearner::Part::measures(std::size_t neuron, std::span<float> partial) {
  return {partial.data() + neuron, products.data() + neuron, squares.data() + neuron};
}

TMpsomLearner::TMpsomLearner(TMpsom& map) : map_(map), workspace_(map) {
  const std::vector<std::size_t>& sizes = map.parameters().input_sizes;
  puts_off_ = *std::max_element(sizes.begin(), sizes.end()) <= kernels::kChunk;
  if (!puts_off_) return;
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    parts_.emplace_back(sizes[a], workspace_.gains_.size(), map.inputs_[a].arbor.groups());
  }
}

void TMpsomLearner::activation(std::span<const SignalView> inputs, std::span<float> out) {
  if (!puts_off_) return map_.activation(inputs, workspace_, out);
  map_.check(inputs, workspace_);
  require(out.size() == map_.neurons(), "T-MPSOM: the activity needs one value per neuron");
  find_activity(inputs);
  std::transform(workspace_.activity_.begin(), workspace_.activity_.end(), out.begin(),
                 [](double activity) { return static_cast<float>(activity); });
}

bool TMpsomLearner::learn(std::span<const SignalView> inputs, double alpha) {
  if (!puts_off_) return map_.learn(inputs, alpha, workspace_);
  map_.check(inputs, workspace_);
  require(alpha >= 0.0 && alpha <= 1.0, "T-MPSOM: alpha must be from 0 to 1");
  find_activity(inputs);
  if (!map_.find_gains(alpha, workspace_)) return false;
  map_.state_ = TMpsom::new_state();
  for (std::size_t a = 0; a < parts_.size(); ++a) put_off(a);
  return true;
}

void TMpsomLearner::settle() {
  for (std::size_t a = 0; a < parts_.size(); ++a) {
    Part& part = parts_[a];
    for (std::size_t group = 0; group < part.waits.size(); ++group) {
      if (!part.waits[group]) continue;
      kernels::t_mpsom_table().move(lanes_of(map_.inputs_[a].weights, group), part.sample.data(),
                                    part.moves(group * kGroup));
      part.waits[group] = false;
    }
  }
}

// As TMpsom::find_activity(). Updates remain deferred as long as there is no input.
void TMpsomLearner::find_activity(std::span<const SignalView> inputs) {
  map_.take(inputs, workspace_);
  if (map_.is_silent(workspace_)) {
    std::fill(workspace_.activity_.begin(), workspace_.activity_.end(), 0.0);
    return;
  }
  for (std::size_t a = 0; a < parts_.size(); ++a) {
    if (workspace_.inputs_[a].state() != map_.state_) pass(a);
  }
  map_.combine(workspace_);
}

void TMpsomLearner::pass(std::size_t input) {
  auto& [weights, arbor, normalized] = map_.inputs_[input];
  TMpsomReceptiveInput& receptive = workspace_.inputs_[input];
  Part& part = parts_[input];
  receptive.write_dense(part.receptive);
  for (std::size_t group = 0; group < arbor.groups(); ++group) {
    const TMpsomArbor::Field& field = arbor.field(group);
    const std::size_t neuron = group * kGroup;
    kernels::t_mpsom_table().move_and_measure(
        lanes_of(weights, group), part.waits[group] ? part.sample.data() : nullptr,
        part.moves(neuron),
        {kernels::lanes(field.mask), field.first, part.receptive.data(), receptive.is_zero()},
        part.measures(neuron, receptive.partial()));
    part.waits[group] = false;
  }
  receptive.set_state(map_.state_);
}

// The moves by the workspace's gains; none waits by now.
void TMpsomLearner::put_off(std::size_t input) {
  Part& part = parts_[input];
  std::swap(part.sample, part.receptive);
  for (std::size_t group = 0; group < part.waits.size(); ++group) {
    part.waits[group] = find_moves(input, group);
  }
  map_.inputs_[input].normalized = map_.parameters_.weight_norm == TMpsomNorm::kL2;
}

// Whether the group moves at all.
bool TMpsomLearner::find_moves(std::size_t input, std::size_t group) {
  const kernels::TMpsomTable& kernels = kernels::t_mpsom_table();
  Part& part = parts_[input];
  TMpsomReceptiveInput& receptive = workspace_.inputs_[input];
  const std::size_t neuron = group * kGroup;
  const std::size_t blocks = blocks_of(map_.inputs_[input].weights, group);
  const float* const gains = workspace_.gains_.data() + neuron;
  if (map_.inputs_[input].normalized && !kernels.any(gains, blocks)) return false;
  if (map_.parameters_.weight_norm == TMpsomNorm::kNone) {
    kernels.find_plain_moves(gains, blocks, part.moves(neuron));
  } else if (!kernels.find_measured_moves(part.measures(neuron, receptive.partial()), blocks,
                                          receptive.squared_length(), gains, part.moves(neuron))) {
    move_doubtful_rows(map_.inputs_[input].weights, {neuron, blocks}, part.sample, gains,
                       part.moves(neuron));
  }
  return true;
}

}  // namespace somato
