#include "somato/maps/t_mpsom.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace somato {
namespace {

// The neighbourhood keeps a square table an axis: this bounds it to 128 MiB.
constexpr std::size_t kLongestAxis = 4096;
constexpr std::size_t kLargestInput = 100'000'000;
// Rows and columns of initial weights are counted in 32 bits.
constexpr std::size_t kMostCounted = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kMostWeights = std::size_t{1} << 32;

tl::unexpected<Error> refuse(std::string what, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), {}, std::move(advice));
}

Result<void> check_lists(const TMpsomParameters& parameters) {
  if (parameters.shape.empty()) {
    return refuse("'shape' is empty",
                  "write the number of neurons along each axis, such as [46, 23]");
  }
  if (parameters.input_sizes.empty()) {
    return refuse("'input_sizes' is empty",
                  "write the number of elements of each input, such as [90, 45]");
  }
  return {};
}

Result<void> check_axes_listed(const TMpsomParameters& parameters) {
  const std::size_t inputs = parameters.input_sizes.size();
  const std::size_t axes = parameters.shape.size();
  const std::size_t listed = parameters.input_axes.size();
  if (listed == 0 && inputs != axes) {
    return refuse(
        fmt::format("{} inputs do not fit a grid of {} axes", inputs, axes),
        "add 'input_axes' with the axis of each input, or a 'shape' with one axis per input");
  }
  if (listed != 0 && listed != inputs) {
    return refuse(fmt::format("'input_axes' lists {} axes for {} inputs", listed, inputs),
                  "write one axis for each of 'input_sizes'");
  }
  return {};
}

Result<void> check_axes_used(const TMpsomParameters& parameters) {
  const std::vector<std::size_t> axes = parameters.axes();
  const std::size_t count = parameters.shape.size();
  for (const std::size_t axis : axes) {
    if (axis < count) continue;
    return refuse(fmt::format("'input_axes' names axis {} of a grid of {} axes", axis, count),
                  "axes are counted from 0");
  }
  for (std::size_t axis = 0; axis < count; ++axis) {
    if (std::find(axes.begin(), axes.end(), axis) != axes.end()) continue;
    return refuse(fmt::format("no input is spread along axis {}", axis),
                  "name every axis of 'shape' in 'input_axes', or remove that axis");
  }
  return {};
}

// Multiplied one after the other, because the product of all may not fit in a number.
Result<void> check_sizes(const TMpsomParameters& parameters) {
  std::size_t elements = 0;
  for (const std::size_t size : parameters.input_sizes) elements += size;
  std::size_t neurons = 1;
  for (const std::size_t extent : parameters.shape) {
    neurons *= extent;
    if (neurons > kMostCounted) break;
  }
  if (neurons <= kMostCounted && elements <= kMostCounted &&
      neurons <= kMostWeights / std::max<std::size_t>(1, elements)) {
    return {};
  }
  return refuse(fmt::format("'shape' and 'input_sizes' require more than {} weights", kMostWeights),
                "use fewer neurons or smaller inputs");
}

Result<void> check_rates(const TMpsomParameters& parameters) {
  if (parameters.learning_rate_end > parameters.learning_rate_start) {
    return refuse("'learning_rate_end' is above 'learning_rate_start'",
                  "the learning rate must not increase");
  }
  return parameters.learning_rate().validate("learning rate");
}

Declarations<TMpsomParameters> declare() {
  using P = TMpsomParameters;
  const auto longest = static_cast<double>(kLongestAxis);
  const auto largest = static_cast<double>(kLargestInput);
  Declarations<P> all;
  all.add("shape", &P::shape, "neurons", Range::between(1, longest),
          "Number of neurons along each axis of the grid. Required.");
  all.add("input_sizes", &P::input_sizes, "elements", Range::between(1, largest),
          "Number of elements of each input. Required.");
  all.add("input_axes", &P::input_axes, "", Range::at_least(0),
          "Axis of the grid, counted from 0, along which each input is distributed; several inputs "
          "may share one. Empty: input 0 has axis 0, input 1 axis 1, and so on.");
  all.add("combination", &P::combination, "", Range::any(),
          "Operation that combines the partial activations of the inputs to a neuron's activity.");
  all.add("arbor_sigma", &P::arbor_sigma, "neurons", Range::above(0),
          "Width of the receptive fields: \"rather small\" in P06. The value is not given in the "
          "paper.");
  all.add("neighbourhood_sigma", &P::neighbourhood_sigma, "neurons", Range::above(0),
          "Width of the Gaussian G with which neurons contribute to each other's learning. Not "
          "given in the paper.");
  all.add("learning_rate_schedule", &P::learning_rate_schedule, "", Range::any(),
          "Course of the learning rate from start to end. Not given in the paper.");
  all.add("learning_rate_start", &P::learning_rate_start, "", Range::between(0, 1),
          "Learning rate of the first iteration. Not given in the paper.");
  all.add("learning_rate_end", &P::learning_rate_end, "", Range::between(0, 1),
          "Learning rate at the end. Not given in the paper.");
  all.add("learning_rate_reached_at", &P::learning_rate_reached_at, "iterations",
          Range::at_least(1),
          "Iteration at which the learning rate reaches its final value, which it then keeps; "
          "automatic: the end of training. Not given in the paper.");
  all.add("input_norm", &P::input_norm, "", Range::any(),
          "Norm by which each input is divided in every iteration; with l2 the strength of an "
          "input is lost. The norm is not given in the paper.");
  all.add("weight_norm", &P::weight_norm, "", Range::any(),
          "Norm by which each weight vector is divided in every iteration. The norm is not given "
          "in the paper.");
  all.add("iterations", &P::iterations, "iterations", Range::at_least(1),
          "Length of training, one frame per iteration; 5000 in P06.");
  all.add("seed", &P::seed, "", Range::at_least(0),
          "Seed of the initial weights, uniform in [0, 1) (not given in the paper), and of the "
          "draws of explorations.");
  return all;
}

}  // namespace

const std::vector<std::pair<TMpsomCombination, std::string>>& Choices<TMpsomCombination>::all() {
  static const std::vector<std::pair<TMpsomCombination, std::string>> choices{
      {TMpsomCombination::kMultiplied, "multiplied"}, {TMpsomCombination::kAdded, "added"}};
  return choices;
}

const std::vector<std::pair<TMpsomNorm, std::string>>& Choices<TMpsomNorm>::all() {
  static const std::vector<std::pair<TMpsomNorm, std::string>> choices{{TMpsomNorm::kL2, "l2"},
                                                                       {TMpsomNorm::kNone, "none"}};
  return choices;
}

const Declarations<TMpsomParameters>& TMpsomParameters::declarations() {
  static const Declarations<TMpsomParameters> all = declare();
  return all;
}

Result<void> TMpsomParameters::validate() const {
  for (const auto check : {check_ranges<TMpsomParameters>, check_lists, check_axes_listed,
                           check_axes_used, check_sizes, check_rates}) {
    Result<void> checked = check(*this);
    if (!checked) return checked;
  }
  return {};
}

std::vector<std::size_t> TMpsomParameters::axes() const {
  if (!input_axes.empty()) return input_axes;
  std::vector<std::size_t> axes(input_sizes.size());
  for (std::size_t input = 0; input < axes.size(); ++input) axes[input] = input;
  return axes;
}

std::size_t TMpsomParameters::neurons() const {
  std::size_t count = 1;
  for (const std::size_t extent : shape) count *= extent;
  return count;
}

std::size_t TMpsomParameters::place(std::size_t neuron, std::size_t axis) const {
  for (std::size_t later = shape.size() - 1; later > axis; --later) neuron /= shape[later];
  return neuron % shape[axis];
}

}  // namespace somato
