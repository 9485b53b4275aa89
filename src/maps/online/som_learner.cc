#include "somato/maps/som_learner.h"

#include <utility>
#include <vector>

#include "base/core/thread_team.h"
#include "maps/online/dense_map.h"
#include "maps/online/direct_map.h"
#include "maps/online/product_learner.h"
#include "maps/online/sparse_learner.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// Cost of a sparse value relative to a dense one.
constexpr std::size_t kEmptyEnough = 16;

// The memory of a table of this size is small compared with that of the weights.
constexpr std::size_t kMostElements = std::size_t{1} << 26;

// Writing the weights into the map after fewer inputs would take more time than it saves.
constexpr std::size_t kSeldom = 8;

}  // namespace

SomLearner::SomLearner(Som& som, std::size_t threads, bool incomplete)
    : som_(som), incomplete_(incomplete), team_(std::make_unique<ThreadTeam>(threads)) {
  require(som.parameters().relevances.empty(), "a map with relevances does not learn further");
}

SomLearner::~SomLearner() {
  settle();
}

void SomLearner::settle() {
  if (!map_) return;
  map_->settle();
  if (form_ != Form::kSparse) return;
  read_often_ = learned_since_settled_ < kSeldom;
  if (read_often_) begin(Form::kNone);
  learned_since_settled_ = 0;
}

Som SomLearner::look() const {
  return map_ ? map_->look() : som_;
}

// Selects the form. A stream keeps its initial form, except if the map is read after nearly every
// input, or if inputs have more elements.
SomLearner::Form SomLearner::form_for(const OnlineInput& input) const {
  if (input.item) return Form::kProducts;
  const SignalView& x = input.values;
  const bool is_empty_enough = !learns_directly() && x.sparse && x.size <= kMostElements &&
                               x.values.size() * kEmptyEnough < x.size;
  return is_empty_enough && form_ != Form::kDense && !read_often_ ? Form::kSparse : Form::kDense;
}

bool SomLearner::learns_directly() const {
  return incomplete_ || !follows_from_products(som_.parameters());
}

void SomLearner::begin(Form form) {
  if (map_) map_->settle();
  map_.reset();
  form_ = form;
  if (form == Form::kProducts) map_ = std::make_unique<ProductLearner>(som_);
  if (form == Form::kSparse) map_ = std::make_unique<SparseLearner>(som_, *team_);
  if (form != Form::kDense) return;
  if (learns_directly()) {
    map_ = std::make_unique<DirectMap>(som_, *team_);
  } else {
    map_ = std::make_unique<DenseMap>(som_, *team_);
  }
}

OnlineMap& SomLearner::map_for(const OnlineInput& input) {
  const Form form = form_for(input);
  if (form != form_) begin(form);
  return *map_;
}

// The number of inputs that are learned at once.
Learned SomLearner::learn_first(std::span<const OnlineInput> inputs,
                                std::span<const LearningStep> steps) {
  ++learned_since_settled_;
  const Learned learned = map_for(inputs.front()).learn(inputs, steps);
  if (learned.inputs > 0) return learned;
  begin(Form::kNone);  // an element without weights
  som_.store_all();
  begin(Form::kDense);
  return map_->learn(inputs, steps);
}

void SomLearner::learn_all(std::span<const OnlineInput> inputs,
                           std::span<const LearningStep> steps) {
  require(inputs.size() == steps.size(), "learning several inputs needs one step for each");
  for (const OnlineInput& input : inputs) {
    require(input.values.size == som_.input_size(),
            "an input's size differs from the map's input size");
  }
  for (std::size_t done = 0; done < inputs.size();) {
    done += learn_first(inputs.subspan(done), steps.subspan(done)).inputs;
  }
}

std::size_t SomLearner::learn(const SignalView& input, double learning_rate, double radius) {
  require(input.size == som_.input_size(), "the input's size differs from the map's input size");
  const OnlineInput one{input, {}};
  const LearningStep step{learning_rate, radius};
  return learn_first({&one, 1}, {&step, 1}).winner;
}

void SomLearner::learn(std::span<const SignalView> inputs, std::span<const LearningStep> steps) {
  std::vector<OnlineInput> all;
  all.reserve(inputs.size());
  for (const SignalView& input : inputs) all.push_back({input, {}});
  learn_all(all, steps);
}

void SomLearner::learn(const Samples& samples, std::span<const std::size_t> numbers,
                       std::span<const LearningStep> steps) {
  const bool known = som_.knows(samples);
  std::vector<OnlineInput> all;
  all.reserve(numbers.size());
  for (const std::size_t number : numbers) {
    require(number < samples.count(), "a sample to learn does not exist");
    all.push_back({samples[number], known ? som_.products()->state().problem().item_of(number)
                                          : std::optional<std::size_t>()});
  }
  learn_all(all, steps);
}

void SomLearner::activity(const Samples& samples, std::size_t sample, std::span<float> out) {
  require(sample < samples.count() && out.size() == som_.neurons(),
          "an activity needs one of the samples, and space for one value per neuron");
  if (som_.knows(samples)) {
    if (!map_) begin(Form::kProducts);
    if (map_->write_activity(sample, out)) return;
  }
  settle();
  som_.activity(samples[sample], workspace_, out);
}

}  // namespace somato
