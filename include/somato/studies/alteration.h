#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// A change of the test explorations: how well is a system that was trained on unchanged
/// explorations without a sense, with a noisy or a contradicting one, or before the end of an
/// exploration? Changes are applied in the order of the fields.
struct Alteration {
  std::string name = {};   ///< That of its table [altered.NAME].
  std::string where = {};  ///< The location of the table.
  std::vector<std::string> swapped = {};
  std::vector<std::string> noisy = {};
  double noise = 1.0;
  std::vector<std::string> missing = {};
  double first = 1.0;

  static const Declarations<Alteration>& declarations();
};

/// The tables [altered.NAME] of a study's file. Errors (kUsage) with their location: unknown keys,
/// values out of range, a table that changes nothing, noise without channels.
Result<std::vector<Alteration>> read_alterations(const Table& file);

/// The tables as TOML that is read back to the same alterations.
std::string to_toml(const std::vector<Alteration>& alterations);

/// The explorations of `recording`, altered, in the same order and with the same labels.
///
/// The readings of `swapped` channels are those of a randomly drawn exploration with another value
/// of `label`. Readings with a rate, such as sound, are taken as they are; all others are repeated
/// or left out evenly, so that each exploration keeps its number of frames. `noisy` channels
/// receive normal noise with `noise` standard deviations of each element over the recording.
/// `missing` channels read 0. `first` keeps that share of the frames of each channel, at least one.
/// The draws depend only on the number of the exploration, so that equal recordings are altered
/// equally.
///
/// Errors: an unknown channel or label (kUsage, at the alteration); only one value of `label`
/// (kData), if channels are swapped.
Result<std::vector<Exploration>> altered(const Recording& recording, const Alteration& alteration,
                                         const std::string& label);

}  // namespace somato
