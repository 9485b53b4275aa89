#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/recording/recording.h"

namespace somato {

/// A channel whose explorations are described by features.
struct FeaturedChannel {
  std::string name;
  std::size_t elements = 0;
  bool is_series = false;  ///< Whether explorations have at least kLeastSeriesFrames frames.
  /// Frames of the parts of which spectra are taken, a power of two; 0 without a spectrum.
  std::size_t spectrum_frames = 0;
};

/// Channels with at most this number of elements have features of each element.
inline constexpr std::size_t kMostSingleElements = 8;

/// The time course is described by the means of this number of equal parts.
inline constexpr std::size_t kLeastSeriesFrames = 4;

/// The least and the greatest length of the parts of which spectra are taken.
inline constexpr std::size_t kLeastSpectrumFrames = 32;
inline constexpr std::size_t kMostSpectrumFrames = 1024;

/// The numbers of the features that every channel has: the mean and the standard deviation of all
/// values.
inline constexpr std::size_t kMeanFeature = 0;
inline constexpr std::size_t kSpreadFeature = 1;

/// The names of the features, in the order of channel_features(). Octaves are counted from the
/// lowest: octave 1 is the frequency `rate / spectrum_frames`, octave 2 twice and three times it.
std::vector<std::string> channel_feature_names(const FeaturedChannel& channel);

/// The features of one exploration: over all valid values their mean, standard deviation and
/// quantiles (0.05, 0.5, 0.95); the standard deviation of the means of the elements; the root mean
/// variance over time; the root mean square of second differences over the root of 6, which is the
/// standard deviation of white noise on a slow course; the means of the quarters; the mean
/// correlation of all pairs of elements over time, of which a constant one correlates with none;
/// and the root mean square of each octave, in the unit of the channel, as the mean over parts
/// without their mean and over elements. Missing values of a spectrum are at the mean, and a
/// shorter exploration is one part with zeros. NaN where there are no valid values.
std::vector<double> channel_features(const FeaturedChannel& featured, const Channel& channel);

}  // namespace somato
