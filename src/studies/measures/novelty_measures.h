#pragma once

#include <cstddef>
#include <vector>

namespace somato {

/// Scores of how unusual explorations are for a trained system, one value each in the same order.
struct NoveltyScores {
  std::vector<double> novelty;   ///< Novelty::of().
  std::vector<double> distance;  ///< From the nearest labelled neuron.
  std::vector<double> nearest;   ///< From the nearest training exploration, for the baseline.

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("novelty", self.novelty);
    visit("distance", self.distance);
    visit("nearest", self.nearest);
  }
  bool operator==(const NoveltyScores&) const = default;
};

/// The scores of explorations of known classes that were held out, and of an unknown class. Those
/// of several trainings are pooled.
struct NoveltyOutcome {
  NoveltyScores known;
  NoveltyScores unknown;
  std::vector<std::size_t> calibrated = {};  ///< Scores behind the threshold of each training.

  void add(const NoveltyOutcome& other);

  /// Visits each field with its name in the journal.
  template <typename Self, typename Visit>
  static void fields(Self& self, const Visit& visit) {
    visit("known", self.known);
    visit("unknown", self.unknown);
    visit("calibrated", self.calibrated);
  }
  bool operator==(const NoveltyOutcome&) const = default;
};

/// The probability that an unknown score is greater than a known one, 0 to 1; a tie counts half
/// (the area under the curve of noticed unknown ones over false alarms, Fawcett 2006, An
/// introduction to ROC analysis). Throws InvalidArgument if one of them is empty.
double area_under_curve(const std::vector<double>& known, const std::vector<double>& unknown);

/// The share of unknown scores above the lowest limit that at most `rate` of the known scores
/// exceed. Throws InvalidArgument if one of them is empty, or for a rate that is not below 1.
double noticed_at(const std::vector<double>& known, const std::vector<double>& unknown,
                  double rate);

/// The share of scores that are read as unknown. Throws InvalidArgument without scores.
double share_unknown(const std::vector<double>& novelty);

}  // namespace somato
