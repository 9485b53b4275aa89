#include "somato/codes/one_hot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::size_t kMostOneHotElements = std::size_t{1} << 20;

std::vector<float> bin_edges(const OneHotParameters& parameters) {
  const auto count = static_cast<double>(parameters.elements);
  const double width = parameters.high - parameters.low;
  std::vector<float> edges(parameters.elements + 1);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    edges[i] = static_cast<float>(parameters.low + width * static_cast<double>(i) / count);
  }
  edges.back() = static_cast<float>(parameters.high);
  return edges;
}

bool is_float_range(double low, double high) {
  return std::isfinite(static_cast<float>(low)) && std::isfinite(static_cast<float>(high)) &&
         static_cast<float>(low) < static_cast<float>(high);
}

}  // namespace

const std::vector<std::pair<OutsideRange, std::string>>& Choices<OutsideRange>::all() {
  static const std::vector<std::pair<OutsideRange, std::string>> kAll{
      {OutsideRange::kRefuse, "refuse"}, {OutsideRange::kClamp, "clamp"}};
  return kAll;
}

const Declarations<OneHotParameters>& OneHotParameters::declarations() {
  using P = OneHotParameters;
  static const Declarations<P> kAll =
      Declarations<P>()
          .add("low", &P::low, "unit of the value", Range::any(),
               "Lower end of the first bin. Not given in the paper.")
          .add("high", &P::high, "unit of the value", Range::any(),
               "Upper end of the last bin. Not given in the paper.")
          .add("elements", &P::elements, "",
               Range::between(1, static_cast<double>(kMostOneHotElements)),
               "Bins for each element of the input; 10 in the papers.")
          .add("outside", &P::outside, "", Range::any(),
               "Treatment of a value outside the range: an error, or the nearest bin.");
  return kAll;
}

OneHot::OneHot(const OneHotParameters& parameters) : parameters_(parameters) {
  require(parameters.elements >= 1 && parameters.elements <= kMostOneHotElements,
          "a one-hot code needs 1 to 2^20 elements");
  require(is_float_range(parameters.low, parameters.high),
          "the range of a one-hot code must be finite, with low below high");
  edges_ = bin_edges(parameters);
}

Result<std::uint32_t> OneHot::bin(float value) const {
  if (std::isnan(value)) {
    return fail(ErrorKind::kData, "the value to be encoded is not a number", {},
                "remove the frame from the recording, or repair it");
  }
  const bool outside = value < edges_.front() || value > edges_.back();
  if (outside && parameters_.outside == OutsideRange::kRefuse) {
    return fail(ErrorKind::kData,
                fmt::format("the value {} is outside the range {} to {} of its one-hot code", value,
                            parameters_.low, parameters_.high),
                {}, "widen 'low' and 'high', or set outside = \"clamp\"");
  }
  const auto inner = edges_.begin() + 1;
  return static_cast<std::uint32_t>(std::upper_bound(inner, edges_.end() - 1, value) - inner);
}

Result<Signal> OneHot::encode(float value) const {
  return bin(value).map(
      [&](std::uint32_t index) { return Signal::sparse({elements()}, {index}, {1.0F}); });
}

OneHotSequence::OneHotSequence(const std::vector<OneHotParameters>& joints)
    : codes_(joints.begin(), joints.end()) {
  require(!joints.empty(), "a one-hot sequence needs at least one joint");
  for (const OneHotParameters& joint : joints) {
    require(joint.elements == joints.front().elements,
            "the joints of a one-hot sequence must have equal numbers of elements");
  }
}

Result<Signal> OneHotSequence::encode(std::span<const float> values) const {
  SignalBuffer code;
  SOMATO_TRY_VOID(encode(values, code));
  return Signal::copy_of(code.view(), {joints(), codes_.front().elements()});
}

Result<void> OneHotSequence::encode(std::span<const float> values, SignalBuffer& out) const {
  require(values.size() == joints(), "a one-hot sequence needs one value for each joint");
  const std::size_t elements = codes_.front().elements();
  out.begin_sparse(joints() * elements);
  for (std::size_t joint = 0; joint < joints(); ++joint) {
    Result<std::uint32_t> bin = codes_[joint].bin(values[joint]);
    if (!bin) {
      bin.error().where = fmt::format("joint {}", joint + 1);
      return fail(std::move(bin.error()));
    }
    out.add(static_cast<std::uint32_t>(joint * elements) + *bin, 1.0F);
  }
  return {};
}

}  // namespace somato
