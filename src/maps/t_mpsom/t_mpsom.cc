#include "somato/maps/t_mpsom.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/core/lanes.h"
#include "base/kernels/t_mpsom_kernels.h"
#include "maps/t_mpsom/t_mpsom_input.h"
#include "maps/t_mpsom/t_mpsom_moving.h"
#include "maps/t_mpsom/t_mpsom_neighbourhood.h"
#include "maps/t_mpsom/t_mpsom_receptive_input.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

TMpsomParameters checked(TMpsomParameters parameters) {
  const Result<void> valid = parameters.validate();
  if (!valid) throw InvalidArgument(to_string(valid.error()));
  return parameters;
}

// Columns are counted on from input to input, so that no two weights are the same number.
LaneMatrix<float> initial_weights(const TMpsomParameters& parameters, std::size_t input) {
  std::size_t first = 0;
  for (std::size_t before = 0; before < input; ++before) first += parameters.input_sizes[before];
  LaneMatrix<float> weights(parameters.neurons(), parameters.input_sizes[input]);
  for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) {
    for (std::size_t k = 0; k < weights.columns(); ++k) {
      weights(neuron, k) =
          uniform_at(parameters.seed, Stream::kInitialWeights, static_cast<std::uint32_t>(neuron),
                     static_cast<std::uint32_t>(first + k));
    }
  }
  return weights;
}

bool all_finite(std::span<const float> values) {
  return std::all_of(values.begin(), values.end(),
                     [](float value) { return std::isfinite(value); });
}

Result<void> check_weights(const TMpsomParameters& parameters,
                           const std::vector<Matrix<float>>& weights) {
  const std::size_t inputs = parameters.input_sizes.size();
  if (weights.size() != inputs) {
    return fail(ErrorKind::kData, fmt::format("weights for {} inputs given, but the T-MPSOM has {}",
                                              weights.size(), inputs));
  }
  for (std::size_t a = 0; a < inputs; ++a) {
    const Matrix<float>& w = weights[a];
    if (w.rows() != parameters.neurons() || w.columns() != parameters.input_sizes[a]) {
      return fail(ErrorKind::kData,
                  fmt::format("the weights of input {} are {} x {}, not {} x {}", a, w.rows(),
                              w.columns(), parameters.neurons(), parameters.input_sizes[a]));
    }
    if (!all_finite(w.values())) {
      return fail(ErrorKind::kData, fmt::format("a weight of input {} is not finite", a));
    }
  }
  return {};
}

// Takes the partial activations of one input into y, in double precision.
void take_partial(std::span<const float> partial, bool is_first, TMpsomCombination combination,
                  std::span<double> activity) {
  const kernels::TMpsomTable& kernels = kernels::t_mpsom_table();
  const auto take = is_first                                        ? kernels.start_activity
                    : combination == TMpsomCombination::kMultiplied ? kernels.multiply_activity
                                                                    : kernels.add_activity;
  take(partial.data(), activity.size(), activity.data());
}

}  // namespace

TMpsom::Workspace::Workspace(const TMpsom& map)
    : activity_(map.neurons()),
      neighbourhood_(map.neurons()),
      spread_(map.neighbourhood_->make_workspace()) {
  const std::size_t groups = (map.neurons() + TMpsomArbor::kNeurons - 1) / TMpsomArbor::kNeurons;
  gains_.resize(groups * TMpsomArbor::kNeurons);
  const std::vector<std::size_t>& sizes = map.parameters_.input_sizes;
  inputs_.reserve(sizes.size());
  for (const std::size_t size : sizes) inputs_.emplace_back(size, gains_.size());
  sample_.resize(*std::max_element(sizes.begin(), sizes.end()));
}

TMpsom::Workspace::Workspace(const Workspace& other) = default;
TMpsom::Workspace::Workspace(Workspace&& other) noexcept = default;
TMpsom::Workspace& TMpsom::Workspace::operator=(const Workspace& other) = default;
TMpsom::Workspace& TMpsom::Workspace::operator=(Workspace&& other) noexcept = default;
TMpsom::Workspace::~Workspace() = default;

TMpsom::TMpsom(const TMpsom& other) = default;
TMpsom::TMpsom(TMpsom&& other) noexcept = default;
TMpsom& TMpsom::operator=(const TMpsom& other) = default;
TMpsom& TMpsom::operator=(TMpsom&& other) noexcept = default;
TMpsom::~TMpsom() = default;

TMpsom::TMpsom(TMpsomParameters parameters, WithoutWeights /*tag*/)
    : parameters_(checked(std::move(parameters))),
      neighbourhood_(
          std::make_shared<const GridGaussian>(parameters_.shape, parameters_.neighbourhood_sigma)),
      state_(new_state()) {
  inputs_.reserve(parameters_.input_sizes.size());
  for (std::size_t a = 0; a < parameters_.input_sizes.size(); ++a) {
    inputs_.push_back({LaneMatrix<float>(), TMpsomArbor(parameters_, a), false});
  }
}

TMpsom::TMpsom(TMpsomParameters parameters) : TMpsom(std::move(parameters), WithoutWeights{}) {
  for (std::size_t a = 0; a < inputs_.size(); ++a) {
    inputs_[a].weights = initial_weights(parameters_, a);
  }
  if (parameters_.weight_norm == TMpsomNorm::kNone) return;
  Workspace workspace(*this);
  for (std::size_t a = 0; a < inputs_.size(); ++a) {
    move(inputs_[a], workspace.inputs_[a], workspace);  // by gains of zero
  }
}

Result<TMpsom> TMpsom::from_weights(TMpsomParameters parameters,
                                    const std::vector<Matrix<float>>& weights) {
  Result<void> valid = parameters.validate();
  if (valid) valid = check_weights(parameters, weights);
  if (!valid) return fail(std::move(valid.error()));
  TMpsom map(std::move(parameters), WithoutWeights{});
  for (std::size_t a = 0; a < weights.size(); ++a) {
    map.inputs_[a].weights = LaneMatrix<float>(weights[a]);
  }
  return map;
}

Matrix<float> TMpsom::weights(std::size_t input) const {
  require(input < inputs_.size(), "T-MPSOM: an input does not exist");
  return inputs_[input].weights.to_matrix();
}

Matrix<float> TMpsom::arbor(std::size_t input) const {
  require(input < inputs_.size(), "T-MPSOM: an input does not exist");
  return inputs_[input].arbor.to_matrix();
}

void TMpsom::activation(std::span<const SignalView> inputs, Workspace& workspace,
                        std::span<float> out) const {
  check(inputs, workspace);
  require(out.size() == neurons(), "T-MPSOM: the activity needs one value per neuron");
  find_activity(inputs, workspace);
  std::transform(workspace.activity_.begin(), workspace.activity_.end(), out.begin(),
                 [](double activity) { return static_cast<float>(activity); });
}

bool TMpsom::learn(std::span<const SignalView> inputs, double alpha, Workspace& workspace) {
  check(inputs, workspace);
  require(alpha >= 0.0 && alpha <= 1.0, "T-MPSOM: alpha must be from 0 to 1");
  find_activity(inputs, workspace);
  if (!find_gains(alpha, workspace)) return false;
  state_ = new_state();
  for (std::size_t a = 0; a < inputs_.size(); ++a) {
    move(inputs_[a], workspace.inputs_[a], workspace);
  }
  return true;
}

std::size_t TMpsom::winner(std::span<const float> activity) {
  require(!activity.empty(), "T-MPSOM: a winner requires an activity");
  return static_cast<std::size_t>(std::max_element(activity.begin(), activity.end()) -
                                  activity.begin());
}

bool TMpsom::operator==(const TMpsom& other) const {
  return parameters_ == other.parameters_ &&
         std::equal(inputs_.begin(), inputs_.end(), other.inputs_.begin(), other.inputs_.end(),
                    [](const Input& a, const Input& b) { return a.weights == b.weights; });
}

void TMpsom::check(std::span<const SignalView> inputs, const Workspace& workspace) const {
  require(inputs.size() == inputs_.size(),
          "T-MPSOM: the number of inputs differs from that of the map");
  require(workspace.inputs_.size() == inputs_.size() && workspace.activity_.size() == neurons(),
          "T-MPSOM: the workspace belongs to another map");
  for (std::size_t a = 0; a < inputs_.size(); ++a) {
    const std::size_t size = parameters_.input_sizes[a];
    require(inputs[a].size == size,
            "T-MPSOM: the size of an input differs from what the map expects");
    require(workspace.inputs_[a].size() == size, "T-MPSOM: the workspace belongs to another map");
  }
}

// Never 0, which stands for no weights.
std::uint64_t TMpsom::new_state() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

void TMpsom::take(std::span<const SignalView> inputs, Workspace& workspace) const {
  for (std::size_t a = 0; a < inputs_.size(); ++a) {
    TMpsomReceptiveInput& receptive = workspace.inputs_[a];
    if (!receptive.is_again(inputs[a])) receptive.take(inputs[a], parameters_.input_norm);
  }
}

// Whether an input of zeros makes every product zero. With norms partial activations are finite;
// without, zero times one that has left its range would have to be found.
bool TMpsom::is_silent(const Workspace& workspace) const {
  const auto is_zero = [](const TMpsomReceptiveInput& receptive) { return receptive.is_zero(); };
  const auto is_normalized = [](const Input& input) { return input.normalized; };
  return parameters_.combination == TMpsomCombination::kMultiplied &&
         parameters_.input_norm == TMpsomNorm::kL2 &&
         std::any_of(workspace.inputs_.begin(), workspace.inputs_.end(), is_zero) &&
         std::all_of(inputs_.begin(), inputs_.end(), is_normalized);
}

// y. An input that is the same again, for weights that are the same, too, has its partial
// activations already.
void TMpsom::find_activity(std::span<const SignalView> inputs, Workspace& workspace) const {
  take(inputs, workspace);
  if (is_silent(workspace)) {
    std::fill(workspace.activity_.begin(), workspace.activity_.end(), 0.0);
    return;
  }
  for (std::size_t a = 0; a < inputs_.size(); ++a) {
    TMpsomReceptiveInput& receptive = workspace.inputs_[a];
    if (receptive.state() != state_) find_partial(inputs_[a], receptive);
  }
  combine(workspace);
}

void TMpsom::combine(Workspace& workspace) const {
  for (std::size_t a = 0; a < inputs_.size(); ++a) {
    take_partial(workspace.inputs_[a].partial(), a == 0, parameters_.combination,
                 workspace.activity_);
  }
}

// Each group of neurons takes what it sees of the elements that are not zero.
void TMpsom::find_partial(const Input& input, TMpsomReceptiveInput& receptive) const {
  const auto& [weights, arbor, normalized] = input;
  const kernels::TMpsomTable& kernels = kernels::t_mpsom_table();
  for (std::size_t group = 0; group < arbor.groups(); ++group) {
    const TMpsomArbor::Field& field = arbor.field(group);
    const TMpsomReceptiveInput::Elements seen = receptive.elements(field.first, field.end);
    const std::size_t neuron = group * TMpsomArbor::kNeurons;
    kernels.banded_inner_products(
        {weights.data() + neuron * weights.columns(), field.mask.blocks(), weights.columns()},
        kernels::lanes(field.mask), field.first, seen.places, seen.values, seen.count,
        receptive.partial().data() + neuron);
  }
  receptive.set_state(state_);
}

// N and the gains alpha N from y; false when there is nothing to learn.
bool TMpsom::find_gains(double alpha, Workspace& workspace) const {
  if (is_silent(workspace)) {
    std::fill(workspace.neighbourhood_.begin(), workspace.neighbourhood_.end(), 0.0);
    return false;
  }
  const kernels::TMpsomTable& kernels = kernels::t_mpsom_table();
  const std::span<double> spread = workspace.neighbourhood_;
  const char* const too_large = "T-MPSOM: the activity is too large; normalize the inputs";
  require(kernels.rectify(workspace.activity_.data(), spread.size(), spread.data()), too_large);
  neighbourhood_->spread(spread, workspace.spread_);
  const double maximum = kernels.largest(spread.data(), spread.size());
  require(std::isfinite(maximum), too_large);
  if (maximum <= 0.0) return false;
  kernels.find_gains(spread.data(), spread.size(), maximum, alpha, workspace.gains_.data());
  return true;
}

void TMpsom::move(Input& input, const TMpsomReceptiveInput& receptive, Workspace& workspace) const {
  receptive.write_dense(workspace.sample_);
  const TMpsomNorm norm = parameters_.weight_norm;
  move_weights(input.weights,
               {workspace.sample_, receptive.squared_length(), workspace.gains_, !input.normalized},
               norm);
  input.normalized = norm == TMpsomNorm::kL2;
}

}  // namespace somato
