#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"

namespace somato {

/// What the frames of a segment are multiplied by before the transform; frame i of n has the weight
///
/// - rectangular: 1
/// - Hann: 0.5 - 0.5 cos(2 pi (i + 1/2) / n)
/// - Hamming: 0.54 - 0.46 cos(2 pi (i + 1/2) / n)
///
/// which is symmetric and nowhere 0, so that a segment of a single frame has a spectrum too.
enum class SpectrumWindow { kRectangular, kHann, kHamming };

template <>
struct Choices<SpectrumWindow> {
  static const std::vector<std::pair<SpectrumWindow, std::string>>& all();
};

/// What a spectrum tells about a frequency.
enum class SpectrumQuantity {
  kMagnitude,  ///< The root of the power: a sine of amplitude A has A / sqrt(2) in its band.
  kPower,      ///< The mean square of what the frames hold at the frequencies of the band or bin.
};

template <>
struct Choices<SpectrumQuantity> {
  static const std::vector<std::pair<SpectrumQuantity, std::string>>& all();
};

/// How the edges of the bands lie between the lowest and the highest frequency.
enum class BandSpacing {
  kLinear,     ///< All bands are equally wide.
  kGeometric,  ///< The edges of all bands have the same ratio.
};

template <>
struct Choices<BandSpacing> {
  static const std::vector<std::pair<BandSpacing, std::string>>& all();
};

/// How the values of a spectrum are written.
enum class SpectrumScale {
  kLinear,       ///< As they are.
  kLogarithmic,  ///< log(floor + value).
};

template <>
struct Choices<SpectrumScale> {
  static const std::vector<std::pair<SpectrumScale, std::string>>& all();
};

/// The parameters of a spectrum; see Spectrum. P11 section IV-B gives 2049 frequencies, as many
/// as a transform of 4096 frames has, and nothing more.
struct SpectrumParameters {
  SpectrumWindow window = SpectrumWindow::kHann;
  std::optional<std::size_t> segment_length;
  double overlap = 0.5;
  std::optional<std::size_t> transform_length;
  bool remove_mean = true;
  SpectrumQuantity quantity = SpectrumQuantity::kMagnitude;
  std::size_t bands = 32;
  BandSpacing band_spacing = BandSpacing::kLinear;
  double low = 0.0;
  std::optional<double> high;
  SpectrumScale scale = SpectrumScale::kLinear;
  double floor = 1e-6;

  static const Declarations<SpectrumParameters>& declarations();

  /// Whether the parameters fit each other. Errors (kUsage): one out of its range; a transform
  /// shorter than its segment; 'low' not below 'high', or 0 with geometric bands; every bin asked
  /// for with an unknown number of bins, or together with 'low' or 'high'.
  Result<void> validate() const;
};

}  // namespace somato
