#include "somato/codes/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "base/core/elementary.h"
#include "systems/signals/frequency_bands.h"
#include "systems/signals/real_transform.h"

namespace somato {
namespace {

std::optional<std::size_t> known_transform_length(const SpectrumParameters& parameters) {
  if (parameters.transform_length) return parameters.transform_length;
  if (parameters.segment_length) return std::bit_ceil(*parameters.segment_length);
  return std::nullopt;
}

double window_weight(SpectrumWindow window, std::size_t frame, std::size_t count) {
  const double place = (static_cast<double>(frame) + 0.5) / static_cast<double>(count);
  if (window == SpectrumWindow::kHann) return 0.5 - 0.5 * cosine_of_turns(place);
  if (window == SpectrumWindow::kHamming) return 0.54 - 0.46 * cosine_of_turns(place);
  return 1.0;
}

std::vector<double> window_weights(SpectrumWindow window, std::size_t count) {
  std::vector<double> weights(count);
  for (std::size_t i = 0; i < count; ++i) weights[i] = window_weight(window, i, count);
  return weights;
}

double sum_of(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

double sum_of_squares(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum = std::fma(value, value, sum);
  return sum;
}

Result<void> check_finite(const Matrix<float>& frames) {
  for (std::size_t i = 0; i < frames.rows(); ++i) {
    for (std::size_t j = 0; j < frames.columns(); ++j) {
      if (std::isfinite(frames(i, j))) continue;
      return fail(ErrorKind::kData,
                  fmt::format("frame {} contains {} in element {}", i + 1, frames(i, j), j + 1), {},
                  "leave the exploration out, or repair it");
    }
  }
  return {};
}

Result<void> check_frames(const Matrix<float>& frames, const SpectrumParameters& parameters) {
  const std::size_t segment = parameters.segment_length.value_or(1);
  if (frames.rows() < segment) {
    return fail(ErrorKind::kData,
                fmt::format("{} frames are too few for a spectrum of segments of {}", frames.rows(),
                            segment),
                {}, "lower 'segment_length', or leave the exploration out");
  }
  if (!parameters.segment_length && parameters.transform_length &&
      frames.rows() > *parameters.transform_length) {
    return fail(ErrorKind::kData,
                fmt::format("{} frames are too many for a transform of {}", frames.rows(),
                            *parameters.transform_length),
                {}, "raise 'transform_length', or set 'segment_length'");
  }
  return check_finite(frames);
}

// The size of one unit of the axis in Hz: 1, or |speed| for cycles per millimetre.
Result<double> axis_unit(const SpectrumParameters& parameters, std::optional<double> speed) {
  if (!speed) return 1.0;
  if (parameters.bands == 0 || !parameters.high) {
    return fail(ErrorKind::kUsage, "with a speed a spectrum needs 'bands' and 'high'", {},
                "without them its frequencies would depend on the speed");
  }
  const double unit = std::fabs(*speed);
  if (unit > 0.0 && std::isfinite(unit)) return unit;
  return fail(ErrorKind::kData, fmt::format("a spectrum cannot be divided by the speed {}", *speed),
              {}, "leave out the frames without movement");
}

Error bands_beyond(double low, double high, double limit, double rate,
                   std::optional<double> speed) {
  const std::string_view unit = speed ? "cycles/mm" : "Hz";
  const std::string at_speed = speed ? fmt::format(" and {:.6g} mm/s", *speed) : std::string();
  return {
      ErrorKind::kData,
      fmt::format("bands from {:.6g} to {:.6g} {} exceed the range that frames at {:.6g} Hz{} can "
                  "represent, {:.6g} {}",
                  low, high, unit, rate, at_speed, limit, unit),
      {},
      "lower 'low' and 'high'"};
}

// Spectra whose frequencies depend on the rate, of frames at a rate unlike the common one.
Result<void> check_rate(const SpectrumParameters& parameters, double rate) {
  if (!parameters.rate || rate <= 0.0) return {};
  const double share = rate / *parameters.rate;
  const bool is_too_high = parameters.bands == 0 && share > 1.0 + kSpectrumRateTolerance;
  if (!is_too_high && share >= 1.0 - kSpectrumRateTolerance) return {};
  return fail(
      ErrorKind::kData,
      fmt::format("frames at {:.6g} Hz have other frequencies than those at {:.6g} Hz", rate,
                  *parameters.rate),
      {},
      parameters.bands == 0
          ? "set 'bands' and 'high', or use explorations of one rate"
          : "set 'high' to at most half of the lowest rate, or use explorations of one rate");
}

// The edges of the bands, in bins; none where every bin is taken.
Result<std::vector<double>> edges_in_bins(const SpectrumParameters& parameters, double rate,
                                          std::optional<double> speed,
                                          std::size_t transform_length) {
  SOMATO_TRY(const double unit, axis_unit(parameters, speed));
  SOMATO_TRY_VOID(check_rate(parameters, rate));
  if (parameters.bands == 0) return std::vector<double>{};
  if (rate <= 0.0 || !std::isfinite(rate)) {
    return fail(ErrorKind::kData, "bands require the frame rate, which is unknown", {},
                "record times or a rate, or use every bin with 'bands' 0");
  }
  const double limit = rate / 2.0 / unit;
  const double high = parameters.high.value_or(parameters.rate.value_or(rate) / 2.0);
  // A rate that was computed from times has a small error.
  const double tolerance = parameters.high ? 1e-6 : kSpectrumRateTolerance;
  if (high * (1.0 - tolerance) > limit || parameters.low >= std::min(high, limit)) {
    return fail(bands_beyond(parameters.low, high, limit, rate, speed));
  }
  std::vector<double> edges = band_edges(parameters, high);
  const double half = static_cast<double>(transform_length) / 2.0;
  for (double& edge : edges) edge = std::min(edge / limit, 1.0) * half;
  return edges;
}

// The work on one exploration, with the memory for it.
class SegmentPowers {
 public:
  SegmentPowers(const SpectrumParameters& parameters, std::size_t segment_length,
                RealTransform transform)
      : parameters_(parameters),
        weights_(window_weights(parameters.window, segment_length)),
        transform_(std::move(transform)),
        values_(transform_.length(), 0.0),
        squares_(transform_.bins()),
        powers_(transform_.bins()) {}

  // Every bin's power, averaged over the segments of an element; valid until the next call.
  std::span<const double> of(const Matrix<float>& frames, std::size_t element) {
    std::ranges::fill(powers_, 0.0);
    const std::size_t length = weights_.size();
    const auto repeated =
        static_cast<std::size_t>(parameters_.overlap * static_cast<double>(length));
    std::size_t segments = 0;
    for (std::size_t start = 0; start + length <= frames.rows(); start += length - repeated) {
      add_segment(frames, element, start);
      ++segments;
    }
    const double scale = 2.0 / (static_cast<double>(transform_.length()) *
                                sum_of_squares(weights_) * static_cast<double>(segments));
    for (double& power : powers_) power *= scale;
    return powers_;
  }

 private:
  void add_segment(const Matrix<float>& frames, std::size_t element, std::size_t start) {
    const std::span<double> segment = std::span(values_).first(weights_.size());
    for (std::size_t i = 0; i < segment.size(); ++i) segment[i] = frames(start + i, element);
    const double mean =
        parameters_.remove_mean ? sum_of(segment) / static_cast<double>(segment.size()) : 0.0;
    for (std::size_t i = 0; i < segment.size(); ++i) {
      segment[i] = (segment[i] - mean) * weights_[i];
    }
    transform_.squares(values_, squares_);
    for (std::size_t k = 0; k < powers_.size(); ++k) powers_[k] += squares_[k];
  }

  const SpectrumParameters& parameters_;
  std::vector<double> weights_;
  RealTransform transform_;
  std::vector<double> values_;  // a segment, then zeros
  std::vector<double> squares_;
  std::vector<double> powers_;
};

std::vector<double> bands_between(std::span<const double> edges, std::span<const double> powers) {
  if (edges.empty()) return {powers.begin(), powers.end()};
  std::vector<double> bands(edges.size() - 1);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    bands[i] = sum_between(powers, edges[i], edges[i + 1]);
  }
  return bands;
}

float written(const SpectrumParameters& parameters, double power) {
  const bool is_power = parameters.quantity == SpectrumQuantity::kPower;
  const double value = is_power ? power : std::sqrt(power);
  const bool is_linear = parameters.scale == SpectrumScale::kLinear;
  return static_cast<float>(is_linear ? value : natural_log(parameters.floor + value));
}

}  // namespace

Spectrum::Spectrum(const SpectrumParameters& parameters) : parameters_(parameters) {
  const Result<void> valid = parameters.validate();
  if (!valid) throw InvalidArgument(to_string(valid.error()));
  if (const auto length = known_transform_length(parameters)) {
    plan_ = std::make_shared<const RealTransform>(*length);
  }
}

std::size_t Spectrum::bands() const {
  return parameters_.bands == 0 ? plan_->bins() : parameters_.bands;
}

Result<Signal> Spectrum::apply(const Matrix<float>& frames, double rate,
                               std::optional<double> speed) const {
  SOMATO_TRY_VOID(check_frames(frames, parameters_));
  const std::size_t segment_length = parameters_.segment_length.value_or(frames.rows());
  RealTransform transform = plan_ ? *plan_ : RealTransform(std::bit_ceil(segment_length));
  SOMATO_TRY(auto edges, edges_in_bins(parameters_, rate, speed, transform.length()));
  SegmentPowers powers(parameters_, segment_length, std::move(transform));
  std::vector<float> values;
  values.reserve(frames.columns() * bands());
  for (std::size_t element = 0; element < frames.columns(); ++element) {
    for (const double power : bands_between(edges, powers.of(frames, element))) {
      values.push_back(written(parameters_, power));
    }
  }
  return Signal::dense({frames.columns(), bands()}, std::move(values));
}

}  // namespace somato
