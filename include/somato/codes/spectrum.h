#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "somato/codes/spectrum_parameters.h"
#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"

namespace somato {

class RealTransform;

/// The magnitude spectrum of each element of an exploration: which frequencies a sensor felt, and
/// how strongly, whenever it felt them (P11 section IV-B for the sound of a texture).
///
/// The frames are cut into overlapping segments of n frames; what is left at the end is dropped.
/// Each segment, less its mean and times the window w, is followed by zeros up to the length L of
/// the transform X. The power of bin k is the mean over the segments of
///
///     2 |X_k|^2 / (L sum_i w_i^2),   at the frequency  k rate / L,
///
/// and that of a band is the sum of its bins, each spread over the frequencies half-way to its
/// neighbours: the mean square of what the frames hold between the edges (all bands from 0 to half
/// the rate together: the mean square of the frames, by Parseval), whatever n, L and rate are.
/// The root is taken, and the scale put on, at the end. With a speed, frequencies are divided by
/// its magnitude: an axis in cycles per millimetre, on which a texture stands at the same place and
/// with the same strength however fast it is stroked. All in double precision, rounded to single at
/// the end.
///
/// Constant while it is used; any number of threads may.
class Spectrum {
 public:
  /// Throws InvalidArgument for what SpectrumParameters::validate() refuses.
  explicit Spectrum(const SpectrumParameters& parameters);

  /// Values an element: the number of bands, or of bins where every bin is taken.
  std::size_t bands() const;

  /// The spectra of `frames` (frames x elements), taken at `rate` Hz (0 where nobody knows; only
  /// bands need it), with the sensor moving at `speed` mm/s over the texture: a dense signal of
  /// shape {elements, bands()}.
  ///
  /// Errors (kData): fewer frames than a segment, none, or more than the transform takes; a value
  /// that is not finite, with frame and element counted from 1; bands and an unknown rate; bands
  /// above half the rate; a speed of 0. Errors (kUsage): a speed without bands, or without 'high'.
  Result<Signal> apply(const Matrix<float>& frames, double rate,
                       std::optional<double> speed = std::nullopt) const;

 private:
  SpectrumParameters parameters_;
  std::shared_ptr<const RealTransform> plan_;  // where its length does not hang on the frames
};

}  // namespace somato
