#include "somato/maps/som_learner.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/thread_team.h"
#include "maps/dense_learner.h"
#include "maps/sparse_learner.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// What a sparse value costs more than a dense one.
constexpr std::size_t kEmptyEnough = 16;

// A table of so many elements is small beside their weights.
constexpr std::size_t kMostElements = std::size_t{1} << 26;

// Writing the weights into the map after fewer inputs would take more time than it saves.
constexpr std::size_t kSeldom = 8;

}  // namespace

SomLearner::SomLearner(Som& som, std::size_t threads)
    : som_(som), team_(std::make_unique<ThreadTeam>(threads)) {}

SomLearner::~SomLearner() {
  settle();
}

void SomLearner::settle() {
  if (dense_) dense_->settle();
  if (!sparse_) return;
  sparse_->settle();
  read_often_ = learned_since_settled_ < kSeldom;
  if (read_often_) sparse_.reset();
  learned_since_settled_ = 0;
}

// What it began with it stays with, but for a map that is read after nearly each input.
bool SomLearner::learns_sparsely(const SignalView& input) const {
  return input.sparse && !dense_ && !read_often_ && input.size <= kMostElements &&
         input.values.size() * kEmptyEnough < input.size;
}

std::size_t SomLearner::learn_sparsely(const SignalView& input, const LearningStep& step) {
  if (!sparse_) sparse_ = std::make_unique<SparseLearner>(som_, *team_);
  ++learned_since_settled_;
  return sparse_->learn(input, som_.input_factor(input), step.learning_rate, step.radius);
}

// The input as the dense learner takes it, with weights for all that is in it.
std::span<const float> SomLearner::seen(const SignalView& input) {
  if (sparse_) sparse_->settle();
  sparse_.reset();
  std::span<const float> x = som_.prepare(input, workspace_);
  if (workspace_.left_out_ > 0.0) {
    if (dense_) dense_->settle();
    dense_.reset();
    som_.store_all();
    x = som_.prepare(input, workspace_);
  }
  if (!dense_) dense_ = std::make_unique<DenseLearner>(som_, *team_);
  return x;
}

std::size_t SomLearner::learn(const SignalView& input, double learning_rate, double radius) {
  require(input.size == som_.input_size(), "the input's size differs from the map's input size");
  if (learns_sparsely(input)) return learn_sparsely(input, {learning_rate, radius});
  const std::span<const float> x = seen(input);
  dense_->expect({x});
  return dense_->learn(learning_rate, radius);
}

void SomLearner::learn(std::span<const SignalView> inputs, std::span<const LearningStep> steps) {
  require(inputs.size() == steps.size(), "learning several inputs takes a step for each");
  for (const SignalView& input : inputs) {
    require(input.size == som_.input_size(), "an input's size differs from the map's input size");
  }
  std::size_t done = 0;
  while (done < inputs.size()) {
    if (learns_sparsely(inputs[done])) {
      learn_sparsely(inputs[done], steps[done]);
      ++done;
    } else {
      done += learn_ahead(inputs.subspan(done), steps.subspan(done));
    }
  }
}

// As many of the first inputs as the dense learner takes at once; returns their number.
std::size_t SomLearner::learn_ahead(std::span<const SignalView> inputs,
                                    std::span<const LearningStep> steps) {
  std::span<const float> x = seen(inputs.front());
  const std::size_t most = std::min(dense_->ahead(), inputs.size());
  prepared_.resize(std::max(prepared_.size(), most));
  std::vector<std::span<const float>> expected;
  expected.reserve(most);
  while (true) {
    std::vector<float>& kept = prepared_[expected.size()];
    if (x.data() == workspace_.input_.data()) {
      kept.assign(x.begin(), x.end());
      x = kept;
    }
    expected.push_back(x);
    if (expected.size() == most) break;
    x = som_.prepare(inputs[expected.size()], workspace_);
    if (workspace_.left_out_ > 0.0) break;
  }
  dense_->expect(expected);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    dense_->learn(steps[i].learning_rate, steps[i].radius);
  }
  return expected.size();
}

}  // namespace somato
