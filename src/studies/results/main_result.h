#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/studies/results.h"

namespace somato {

/// The accuracy of a protocol on the label of the study, over its runs.
struct MainResult {
  std::size_t protocol = 0;  ///< Its number in PartResults::protocols.
  double accuracy = 0.0;
  double deviation = 0.0;          ///< The standard deviation over the runs; 0 for a single one.
  std::optional<double> baseline;  ///< That of the nearest neighbour; empty: not measured.
  double chance = 0.0;             ///< See accuracy_by_chance().
};

/// The result that a summary states: the lowest accuracy on samples that were held out, or else
/// that of the training samples. Empty if no protocol measured it.
std::optional<MainResult> main_result(const PartResults& part);

/// The accuracy that is expected if the predicted classes are in random order, the mean over the
/// runs. Empty without predictions.
std::optional<double> accuracy_by_chance(const ProtocolResults& protocol);

/// The accuracy minus best_neighbour_accuracy, below 0 if the map is less accurate. Empty if one of
/// them was not measured, and for samples that were not held out, each of which is its own nearest
/// neighbour.
std::optional<double> above_best_neighbour(const ProtocolResults& protocol);

/// The same in a sentence, with the kinds of neighbours that were chosen, for the text of results.
std::string best_neighbour_sentence(const ProtocolResults& protocol);

/// By how much the accuracy is below that of the nearest neighbour, the better of baseline_accuracy
/// and best_neighbour_accuracy, from 0 to 1, if this is more than 0.05 and both are of samples that
/// were held out; otherwise empty.
std::optional<double> far_below_baseline(const ProtocolResults& protocol);

/// A map with fewer winners than there are classes.
struct CollapsedMap {
  std::size_t winners = 0;
  std::size_t classes = 0;
};

/// The map of the run with the fewest winners of tested samples, if they are fewer than the classes
/// of these samples, so that it cannot separate the classes. Empty if no accuracy was measured.
std::optional<CollapsedMap> collapsed_map(const ProtocolResults& protocol);

/// Samples of a class for which another one was predicted.
struct Confusion {
  std::string label;      ///< The true class.
  std::string predicted;  ///< The predicted one.
  std::size_t count = 0;  ///< Over all runs.
  std::size_t of = 0;     ///< All samples of the true class, over all runs.
};

/// The most frequent confusions, at most `most` of them, in descending order; of equal ones, the
/// first in alphabetical order comes first.
std::vector<Confusion> confusions(const ProtocolResults& protocol, std::size_t most);

}  // namespace somato
