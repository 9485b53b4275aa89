#include "somato/maps/t_mpsom.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/lanes.h"
#include "somato/core/check.h"
#include "somato/core/elementary.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr std::size_t kLanes = LaneMatrix<float>::kLanes;

// So many blocks of neurons are taken at once.
constexpr std::size_t kGroup = 4;

float factor(double value) {
  return value < kernels::kNegligible<float> ? 0.0F : static_cast<float>(value);
}

TMpsomParameters checked(TMpsomParameters parameters) {
  const Result<void> valid = parameters.validate();
  if (!valid) throw InvalidArgument(to_string(valid.error()));
  return parameters;
}

// A(u, k) of every neuron and element; u and k count from 1 (P06): counted from 0 the receptive
// fields would be shifted by up to one neuron.
LaneMatrix<float> make_arbor(const TMpsomParameters& parameters, std::size_t input) {
  const std::size_t axis = parameters.axes()[input];
  const std::size_t size = parameters.input_sizes[input];
  const double ratio = static_cast<double>(parameters.shape[axis]) / static_cast<double>(size);
  const double twice_variance = 2.0 * parameters.arbor_sigma * parameters.arbor_sigma;
  LaneMatrix<float> arbor(parameters.neurons(), size);
  for (std::size_t neuron = 0; neuron < arbor.rows(); ++neuron) {
    const auto u = static_cast<double>(parameters.place(neuron, axis) + 1);
    for (std::size_t k = 0; k < size; ++k) {
      const double distance = u - ratio * static_cast<double>(k + 1);
      arbor(neuron, k) = factor(exponential(-distance * distance / twice_variance));
    }
  }
  return arbor;
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

// Of values not below zero, some at a time: a chain of comparisons would wait for each.
double largest(std::span<const double> values) {
  constexpr std::size_t kAtOnce = 8;
  double best[kAtOnce] = {};
  const double* value = values.data();
  for (std::size_t left = values.size(); left >= kAtOnce; left -= kAtOnce, value += kAtOnce) {
    for (std::size_t i = 0; i < kAtOnce; ++i) best[i] = best[i] < value[i] ? value[i] : best[i];
  }
  for (; value != values.data() + values.size(); ++value) best[0] = std::max(best[0], *value);
  return *std::max_element(std::begin(best), std::end(best));
}

// Never 0, which stands for no weights.
std::uint64_t new_state() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

// Divides a row whose squared norm is beyond what float holds well.
void normalize_row(LaneMatrix<float>& weights, std::size_t row) {
  double squared = 0.0;
  for (std::size_t k = 0; k < weights.columns(); ++k) {
    const double weight = weights(row, k);
    squared = std::fma(weight, weight, squared);
  }
  if (!(squared > 0.0)) return;
  const double length = std::sqrt(squared);
  for (std::size_t k = 0; k < weights.columns(); ++k) {
    weights(row, k) = static_cast<float>(double{weights(row, k)} / length);
  }
}

Result<void> check_weights(const TMpsomParameters& parameters,
                           const std::vector<Matrix<float>>& weights) {
  const std::size_t inputs = parameters.input_sizes.size();
  if (weights.size() != inputs) {
    return fail(ErrorKind::kData,
                fmt::format("weights of {} inputs for a T-MPSOM of {}", weights.size(), inputs));
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

// The place in the signal of its stored value number i.
std::uint32_t index_of(const SignalView& signal, std::size_t i) {
  return signal.sparse ? signal.indices[i] : static_cast<std::uint32_t>(i);
}

double length_of(std::span<const float> values, TMpsomNorm norm) {
  double squared = 0.0;
  for (const float value : values) squared += double{value} * double{value};  // exact products
  require(std::isfinite(squared), "T-MPSOM: an input holds a value that is not finite");
  return norm == TMpsomNorm::kL2 && squared > 0.0 ? std::sqrt(squared) : 1.0;
}

}  // namespace

TMpsom::Workspace::Heard::Heard(std::size_t elements, std::size_t padded_neurons)
    : indices(elements),
      values(elements),
      normalized(elements),
      ranks(elements + 1),
      partial(padded_neurons) {}

// Whether no element is another than in the last signal; NaN is another than itself.
bool TMpsom::Workspace::Heard::is_again(const SignalView& signal) const {
  std::size_t at = 0;
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    if (signal.values[i] == 0.0F) continue;
    if (at == count || values[at] != signal.values[i] || indices[at] != index_of(signal, i)) {
      return false;
    }
    ++at;
  }
  return at == count;
}

void TMpsom::Workspace::Heard::take(const SignalView& signal, TMpsomNorm norm) {
  const double length = length_of(signal.values, norm);  // or throws, and nothing is changed
  state = 0;
  count = 0;
  std::size_t element = 0;
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    const std::uint32_t index = index_of(signal, i);
    for (; element <= index; ++element) ranks[element] = static_cast<std::uint32_t>(count);
    indices[count] = index;
    values[count] = signal.values[i];
    count += signal.values[i] != 0.0F ? 1 : 0;
  }
  for (; element < ranks.size(); ++element) ranks[element] = static_cast<std::uint32_t>(count);
  for (std::size_t i = 0; i < count; ++i) {
    normalized[i] = static_cast<float>(double{values[i]} / length);
  }
}

// Writes all elements, normalized, to the front of `out`.
void TMpsom::Workspace::Heard::write_dense(std::span<float> out) const {
  std::fill_n(out.begin(), values.size(), 0.0F);
  for (std::size_t i = 0; i < count; ++i) out[indices[i]] = normalized[i];
}

TMpsom::Input::Input(const TMpsomParameters& parameters, std::size_t input)
    : arbor(make_arbor(parameters, input)) {
  for (std::size_t row = 0; row < arbor.rows(); row += kGroup * kLanes) {
    ReceptiveField& field = fields.emplace_back(ReceptiveField{arbor.columns(), 0});
    const std::size_t end = std::min(row + kGroup * kLanes, arbor.rows());
    for (std::size_t neuron = row; neuron < end; ++neuron) field.widen(arbor, neuron);
    field.first = std::min(field.first, field.end);  // it may see nothing
  }
}

void TMpsom::ReceptiveField::widen(const LaneMatrix<float>& arbor, std::size_t neuron) {
  for (std::size_t k = 0; k < arbor.columns(); ++k) {
    if (arbor(neuron, k) == 0.0F) continue;
    first = std::min(first, k);
    end = std::max(end, k + 1);
  }
}

TMpsom::Workspace::Workspace(const TMpsom& map)
    : activity_(map.neurons()), neighbourhood_(map.neurons()), spread_(map.neighbourhood_) {
  const std::size_t padded = map.inputs_.front().arbor.padded_rows();
  std::size_t longest = 0;
  for (const Input& input : map.inputs_) {
    inputs_.emplace_back(input.arbor.columns(), padded);
    longest = std::max(longest, input.arbor.columns());
  }
  sample_.resize(longest);
  gains_.resize(padded);
  squared_norms_.resize(padded);
}

TMpsom::TMpsom(TMpsomParameters parameters, WithoutWeights /*tag*/)
    : parameters_(checked(std::move(parameters))),
      neighbourhood_(parameters_.shape, parameters_.neighbourhood_sigma),
      state_(new_state()) {
  for (std::size_t a = 0; a < parameters_.input_sizes.size(); ++a) {
    inputs_.emplace_back(parameters_, a);
  }
}

TMpsom::TMpsom(TMpsomParameters parameters) : TMpsom(std::move(parameters), WithoutWeights{}) {
  for (std::size_t a = 0; a < inputs_.size(); ++a) {
    inputs_[a].weights = initial_weights(parameters_, a);
  }
  if (parameters_.weight_norm == TMpsomNorm::kNone) return;
  Workspace workspace(*this);
  for (Input& input : inputs_) normalize_all(input, workspace);
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
  require(input < inputs_.size(), "T-MPSOM: there is no such input");
  return inputs_[input].weights.to_matrix();
}

Matrix<float> TMpsom::arbor(std::size_t input) const {
  require(input < inputs_.size(), "T-MPSOM: there is no such input");
  return inputs_[input].arbor.to_matrix();
}

void TMpsom::activation(std::span<const SignalView> inputs, Workspace& workspace,
                        std::span<float> out) const {
  check(inputs, workspace);
  require(out.size() == neurons(), "T-MPSOM: the activity needs one value a neuron");
  hear(inputs, workspace);
  std::transform(workspace.activity_.begin(), workspace.activity_.end(), out.begin(),
                 [](double activity) { return static_cast<float>(activity); });
}

bool TMpsom::learn(std::span<const SignalView> inputs, double alpha, Workspace& workspace) {
  check(inputs, workspace);
  require(alpha >= 0.0 && alpha <= 1.0, "T-MPSOM: alpha must be in 0 .. 1");
  hear(inputs, workspace);
  if (!find_gains(alpha, workspace)) return false;
  state_ = new_state();
  for (std::size_t a = 0; a < inputs_.size(); ++a) {
    workspace.inputs_[a].write_dense(workspace.sample_);
    move(inputs_[a], workspace);
  }
  return true;
}

std::size_t TMpsom::winner(std::span<const float> activity) {
  require(!activity.empty(), "T-MPSOM: no activity, no winner");
  return static_cast<std::size_t>(std::max_element(activity.begin(), activity.end()) -
                                  activity.begin());
}

bool TMpsom::operator==(const TMpsom& other) const {
  return parameters_ == other.parameters_ &&
         std::equal(inputs_.begin(), inputs_.end(), other.inputs_.begin(), other.inputs_.end(),
                    [](const Input& a, const Input& b) { return a.weights == b.weights; });
}

void TMpsom::check(std::span<const SignalView> inputs, const Workspace& workspace) const {
  require(inputs.size() == inputs_.size(), "T-MPSOM: another number of inputs than the map has");
  require(workspace.inputs_.size() == inputs_.size() && workspace.activity_.size() == neurons(),
          "T-MPSOM: the workspace belongs to another map");
  for (std::size_t a = 0; a < inputs_.size(); ++a) {
    const std::size_t size = parameters_.input_sizes[a];
    require(inputs[a].size == size, "T-MPSOM: an input has another size than the map expects");
    require(workspace.inputs_[a].values.size() == size,
            "T-MPSOM: the workspace belongs to another map");
  }
}

// y. An input that is the same again, for weights that are the same, too, has its partial
// activations already.
void TMpsom::hear(std::span<const SignalView> inputs, Workspace& workspace) const {
  for (std::size_t a = 0; a < inputs_.size(); ++a) {
    Workspace::Heard& heard = workspace.inputs_[a];
    if (!heard.is_again(inputs[a])) heard.take(inputs[a], parameters_.input_norm);
    if (heard.state != state_) find_partial(a, heard);
    combine(a, workspace);
  }
}

// Each group of blocks takes what it sees of the elements that are not zero.
void TMpsom::find_partial(std::size_t input, Workspace::Heard& heard) const {
  const auto& [weights, arbor, fields] = inputs_[input];
  for (std::size_t group = 0; group < fields.size(); ++group) {
    const std::size_t block = group * kGroup;
    const std::size_t offset = block * weights.columns() * kLanes;
    const std::size_t first = heard.ranks[fields[group].first];
    const std::size_t count = heard.ranks[fields[group].end] - first;
    kernels::table<float>().sparse_masked_inner_products(
        {weights.data() + offset, std::min(kGroup, weights.blocks() - block), weights.columns()},
        arbor.data() + offset, heard.indices.data() + first, heard.normalized.data() + first, count,
        heard.partial.data() + block * kLanes);
  }
  heard.state = state_;
}

// Takes the partial activations of one input into y, in double precision.
void TMpsom::combine(std::size_t input, Workspace& workspace) const {
  double* const activity = workspace.activity_.data();
  const float* const partial = workspace.inputs_[input].partial.data();
  const std::size_t count = neurons();
  if (input == 0) {
    for (std::size_t n = 0; n < count; ++n) activity[n] = partial[n];
  } else if (parameters_.combination == TMpsomCombination::kMultiplied) {
    for (std::size_t n = 0; n < count; ++n) activity[n] *= partial[n];
  } else {
    for (std::size_t n = 0; n < count; ++n) activity[n] += partial[n];
  }
}

// N and the gains alpha N from y; false when there is nothing to learn.
bool TMpsom::find_gains(double alpha, Workspace& workspace) const {
  const std::span<double> spread = workspace.neighbourhood_;
  const double* const activity = workspace.activity_.data();
  bool finite = true;
  for (std::size_t n = 0; double& value : spread) {
    finite &= std::isfinite(activity[n]);
    value = std::max(activity[n++], 0.0);
  }
  const char* const too_large = "T-MPSOM: the activity is too large; normalize the inputs";
  require(finite, too_large);
  neighbourhood_.spread(spread, workspace.spread_);
  const double maximum = largest(spread);
  require(std::isfinite(maximum), too_large);
  if (maximum <= 0.0) return false;
  float* gain = workspace.gains_.data();
  for (double& value : spread) {
    value /= maximum;
    *gain++ = factor(alpha * value);
  }
  return true;
}

// A few blocks at a time are moved and normalized while they are in the nearest cache.
void TMpsom::move(Input& input, Workspace& workspace) const {
  LaneMatrix<float>& weights = input.weights;
  for (std::size_t first = 0; first < weights.blocks(); first += kGroup) {
    const std::size_t count = std::min(kGroup, weights.blocks() - first);
    float* squared_norms = workspace.squared_norms_.data() + first * kLanes;
    kernels::table<float>().move_and_measure(
        {weights.data() + first * weights.columns() * kLanes, count, weights.columns()},
        workspace.sample_.data(), workspace.gains_.data() + first * kLanes, squared_norms);
    if (parameters_.weight_norm == TMpsomNorm::kL2) {
      normalize_blocks(input, first, count, squared_norms);
    }
  }
}

void TMpsom::normalize_all(Input& input, Workspace& workspace) {
  float* squared_norms = workspace.squared_norms_.data();
  kernels::table<float>().squared_norms(kernels::lanes(std::as_const(input.weights)),
                                        squared_norms);
  normalize_blocks(input, 0, input.weights.blocks(), squared_norms);
}

void TMpsom::normalize_blocks(Input& input, std::size_t first, std::size_t count,
                              float* squared_norms) {
  constexpr float kSmallest = 1e-30F;
  constexpr float kLargest = 1e30F;
  for (std::size_t lane = 0; lane < count * kLanes; ++lane) {
    if (squared_norms[lane] > kSmallest && squared_norms[lane] < kLargest) continue;
    const std::size_t row = first * kLanes + lane;
    if (row < input.weights.rows()) normalize_row(input.weights, row);
    squared_norms[lane] = 1.0F;
  }
  const kernels::Table<float>& kernels = kernels::table<float>();
  const std::size_t columns = input.weights.columns();
  kernels.invert_square_roots(squared_norms, count);
  kernels.scale_rows({input.weights.data() + first * columns * kLanes, count, columns},
                     squared_norms);
}

}  // namespace somato
