#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"

namespace somato {

class RealTransform;

/// The window by which the frames of a segment are multiplied before the transform; frame i of n
/// has the weight
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

/// The quantity of a spectrum at a frequency.
enum class SpectrumQuantity {
  kMagnitude,  ///< The root of the power: a sine of amplitude A has A / sqrt(2) in its band.
  kPower,      ///< The mean square of the frames' content at the frequencies of the band or bin.
};

template <>
struct Choices<SpectrumQuantity> {
  static const std::vector<std::pair<SpectrumQuantity, std::string>>& all();
};

/// Distribution of the edges of the bands between the lowest and the highest frequency.
enum class BandSpacing {
  kLinear,     ///< All bands are equally wide.
  kGeometric,  ///< The edges of all bands have the same ratio.
};

template <>
struct Choices<BandSpacing> {
  static const std::vector<std::pair<BandSpacing, std::string>>& all();
};

/// Scale of the values of a spectrum.
enum class SpectrumScale {
  kLinear,       ///< Unchanged.
  kLogarithmic,  ///< log(floor + value).
};

template <>
struct Choices<SpectrumScale> {
  static const std::vector<std::pair<SpectrumScale, std::string>>& all();
};

/// The parameters of a spectrum; see Spectrum. P11 section IV-B only gives 2049 frequencies, the
/// number of a transform of 4096 frames.
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
  std::optional<double> rate;
  SpectrumScale scale = SpectrumScale::kLinear;
  double floor = 1e-6;

  static const Declarations<SpectrumParameters>& declarations();

  /// Whether the parameters are consistent. Errors (kUsage): a parameter out of its range; a
  /// transform shorter than its segment; 'low' not below 'high', or 0 with geometric bands; no
  /// bands with an unknown number of bins, or together with 'low' or 'high'; a 'rate' without
  /// effect.
  Result<void> validate() const;

  /// Whether the frequencies depend on the frame rate: every bin, or bands up to half of it.
  bool depend_on_rate() const { return bands == 0 || !high; }
};

/// The relative difference of two frame rates from which spectra that depend on them are not
/// compared: the nearest rates of sound in use, 44.1 and 48 kHz, differ by 9 %, and a rate that is
/// estimated from times in milliseconds by less than 5 % below 50 Hz.
inline constexpr double kSpectrumRateTolerance = 0.05;

/// The magnitude spectrum of each element of an exploration: the strength of each frequency,
/// independent of time (P11 section IV-B for the sound of a texture).
///
/// The frames are divided into overlapping segments of n frames; an incomplete segment at the end
/// is dropped. Each segment, minus its mean and multiplied by the window w, is padded with zeros to
/// the length L of the transform X. The power of bin k is the mean over the segments of
///
///     2 |X_k|^2 / (L sum_i w_i^2),   at the frequency  k rate / L,
///
/// and that of a band is the sum of its bins, each distributed over the frequencies half-way to its
/// neighbours: the mean square of the frames' content between the edges (all bands from 0 to half
/// the rate together: the mean square of the frames, by Parseval), independent of n, L and rate.
/// The root and the scale are applied at the end. With a speed, frequencies are divided by its
/// magnitude: an axis in cycles per millimetre, on which a texture has the same position and
/// strength for every speed. Computed in double precision and rounded to single at the end.
///
/// Without `high` bands end at half of `rate`, or of the frames' own rate if that is not set.
/// Spectra of frames at other rates are then only comparable with a common `rate`.
///
/// Immutable; can be used by any number of threads.
class Spectrum {
 public:
  /// Throws InvalidArgument for parameters that SpectrumParameters::validate() refuses.
  explicit Spectrum(const SpectrumParameters& parameters);

  /// Number of values per element: the number of bands, or of bins if there are no bands.
  std::size_t bands() const;

  /// The spectra of `frames` (frames x elements), sampled at `rate` Hz (0 if unknown; only bands
  /// require it), with the sensor moving at `speed` mm/s over the texture: a dense signal of shape
  /// {elements, bands()}.
  ///
  /// Errors (kData): fewer frames than a segment, none, or more than the transform takes; a value
  /// that is not finite, with frame and element counted from 1; bands and an unknown rate; bands
  /// above half the rate; with 'rate', another rate for bins, or a lower one for bands, beyond the
  /// tolerance; a speed of 0. Errors (kUsage): a speed without bands, or without 'high'.
  Result<Signal> apply(const Matrix<float>& frames, double rate,
                       std::optional<double> speed = std::nullopt) const;

 private:
  SpectrumParameters parameters_;
  std::shared_ptr<const RealTransform> plan_;  // if its length does not depend on the frames
};

}  // namespace somato
