#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/core/value.h"
#include "somato/graph/system_description.h"
#include "somato/maps/measured_size.h"
#include "somato/maps/som_parameters.h"
#include "somato/recording/format.h"
#include "somato/recording/recording.h"

namespace somato {

/// The settings of a suggestion. docs/mathematics/suggest.md describes the search.
struct SuggestionParameters {
  std::string name = "suggested";
  std::string label = "object";
  std::size_t budget = 2000;
  std::optional<std::size_t> explorations;
  std::size_t candidates = 3;
  std::size_t products = 12;
  std::size_t elements = 20000;
  std::vector<double> weights{1.0, 0.5, 2.0, 0.25, 4.0};
  double least_gain = 0.002;
  std::optional<std::size_t> least_side;
  std::uint64_t seed = 1;

  static const Declarations<SuggestionParameters>& declarations();
};

/// A code of a sense, or of two, in a scaling.
struct SuggestedCode {
  std::string code;     ///< Such as "curve", or "product".
  std::string scaling;  ///< "none", "standardized" or "unit".
  std::string module;   ///< The module that outputs the vector.
  std::size_t elements = 0;
  double score = 1.0;              ///< The mean of `imbalances`; lower is better.
  std::vector<double> imbalances;  ///< For each kept sense.
  std::string failure;             ///< The reason if it could not be compared; else empty.
};

/// The contribution of a channel.
enum class ChannelRole {
  kSense,      ///< It is compared and combined.
  kConstant,   ///< It never changes.
  kSetting,    ///< It does not change during any exploration.
  kUnrelated,  ///< It is not predicted better than by chance, and predicts nothing.
};

template <>
struct Choices<ChannelRole> {
  static const std::vector<std::pair<ChannelRole, std::string>>& all();
};

/// A channel with its codes, or two channels with those of their product; in the order of the
/// search.
struct SuggestedGroup {
  std::vector<std::string> channels;
  ChannelRole role = ChannelRole::kSense;
  std::vector<SuggestedCode> codes;
};

/// A part of the suggested system, in the order of the search.
struct SuggestedPart {
  std::size_t group = 0;
  std::size_t code = 0;  ///< In the group.
  double weight = 1.0;   ///< Relative to the other parts, at unit spread.
  double factor = 1.0;   ///< By which the vector is multiplied: the weight by the inverse spread.
  double score = 1.0;    ///< The score of the combination up to this part.
};

/// A choice at the end of the search, and what was compared with it.
struct SuggestedComparison {
  std::string name;  ///< Such as "the plain standardized vector".
  double score = 1.0;
  bool is_chosen = false;
};

/// A system for a recording, selected without labels.
struct Suggestion {
  SuggestionParameters parameters;
  std::size_t explorations = 0;  ///< The number in the recording.
  std::size_t compared = 0;      ///< The number of these that was compared.
  std::vector<std::string> senses;
  std::vector<SuggestedGroup> groups;
  std::vector<SuggestedPart> parts;
  std::vector<SuggestedComparison> comparisons;  ///< The combination, the plain vector, Manhattan.
  Similarity similarity = Similarity::kEuclidean;  ///< The distance of the map.
  MeasuredSize size;                               ///< No checks if 'least_side' decides.
  std::size_t combinations = 0;                    ///< The number that was compared.
  bool nothing_related = false;  ///< No sense was predicted better than by chance; all are kept.
  SystemDescription system;
};

/// Options that do not affect the suggestion.
struct SuggestionOptions {
  std::size_t threads = 1;
  Progress progress;
};

/// Selects codes, weights and a combination of the channels of a recording without labels: labels
/// and sources of the explorations do not affect the result, and neither does the number of
/// threads.
///
/// Errors: a recording that is not valid; a single exploration; no channel that distinguishes
/// explorations (kData); parameters out of range (kUsage); kInterrupted.
Result<Suggestion> suggest(const Recording& recording, const SuggestionParameters& parameters,
                           const SuggestionOptions& options = {});

/// The suggestion as the TOML file of a study, with its reasons as comments. The tables `[study]`
/// and `[explore]` of `like`, the file of another study, replace those of the suggestion, except
/// for the name and the map, so that both can be compared on the same recordings. `recording` is
/// how the recording was read.
std::string to_toml(const Suggestion& suggestion, const Table& like = {},
                    const RecordingParameters& recording = {});

/// All scores, as JSON, version 1.
std::string to_json(const Suggestion& suggestion);

}  // namespace somato
