#include "studies/suggestion/vector_choice.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "maps/analysis/paired_errors.h"
#include "studies/suggestion/combination.h"
#include "studies/suggestion/suggested_system.h"

namespace somato {
namespace {

class VectorChoice {
 public:
  explicit VectorChoice(SuggestionState& state) : state_(state) {}

  Result<void> run() {
    SOMATO_TRY_VOID(combine());
    return measure_size();
  }

 private:
  // The best usable codes of a group.
  std::vector<std::size_t> best_codes(std::size_t group) const {
    const std::vector<SuggestedCode>& codes = state_.suggestion.groups[group].codes;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < codes.size(); ++i) {
      if (codes[i].failure.empty()) numbers.push_back(i);
    }
    std::ranges::sort(numbers, {},
                      [&](std::size_t code) { return std::pair(codes[code].score, code); });
    if (numbers.size() > state_.parameters.candidates) numbers.resize(state_.parameters.candidates);
    return numbers;
  }

  Result<void> combine() {
    std::vector<Choice> choices;
    for (std::size_t i = 0; i < state_.groups.size(); ++i) {
      SOMATO_TRY_VOID(
          state_.proceed(kProductsDone + (kPartsDone - kProductsDone) * static_cast<double>(i) /
                                             static_cast<double>(state_.groups.size())));
      if (state_.suggestion.groups[i].role != ChannelRole::kSense) continue;
      const std::vector<std::size_t> codes = best_codes(i);
      SOMATO_TRY(auto parts,
                 parts_of(state_.recording, state_.groups[i], codes, state_.limits(0.0, 1.0)));
      for (std::size_t k = 0; k < codes.size(); ++k) {
        choices.push_back({i, codes[k], std::move(parts[k])});
      }
    }
    const CombinationSettings settings{
        state_.parameters.weights, state_.parameters.least_gain, state_.parameters.budget,
        state_.options.threads,
        [this](double share) { return state_.proceed(kPartsDone + (1.0 - kPartsDone) * share); }};
    SOMATO_TRY(const auto found, state_.suggestion.nothing_related
                                     ? Result<Combination>(all_of(choices, state_.predicted))
                                     : best_combination(choices, state_.predicted, settings));
    state_.suggestion.combinations = found.compared;
    for (const ChosenPart& part : found.parts) {
      const Choice& choice = choices[part.choice];
      const double spread = state_.groups[choice.group].candidates[choice.code].spread;
      state_.suggestion.parts.push_back(
          {choice.group, choice.code, part.weight, part.weight / std::sqrt(spread), part.score});
    }
    return state_.suggestion.nothing_related ? Result<void>() : settle();
  }

  // The plain vector replaces a combination that is not clearly better, and Manhattan distance the
  // Euclidean one if it is clearly better.
  Result<void> settle() {
    SOMATO_TRY(std::vector<double> errors, errors_of_parts(Similarity::kEuclidean));
    add_comparison("the combination", errors, true);
    const std::vector<SuggestedPart> plain = plain_parts();
    if (!plain.empty() && !is_same(plain, state_.suggestion.parts)) {
      std::vector<SuggestedPart> found = std::exchange(state_.suggestion.parts, plain);
      SOMATO_TRY(std::vector<double> of_plain, errors_of_parts(Similarity::kEuclidean));
      const bool is_kept = is_clearly_better(errors, of_plain);
      state_.suggestion.comparisons.back().is_chosen = is_kept;
      add_comparison("the plain standardized vector", of_plain, !is_kept);
      if (is_kept) std::swap(state_.suggestion.parts, found);
      if (!is_kept) std::swap(errors, of_plain);
      if (!is_kept) SOMATO_TRY_VOID(score_parts());
    }
    SOMATO_TRY(const auto of_manhattan, errors_of_parts(Similarity::kManhattan));
    const bool is_manhattan = is_clearly_better(of_manhattan, errors);
    if (is_manhattan) state_.suggestion.similarity = Similarity::kManhattan;
    add_comparison("the chosen vector by Manhattan distance", of_manhattan, is_manhattan);
    return {};
  }

  // With fewer neurons than `least_side` requires nothing needs to be measured.
  Result<void> measure_size() {
    const std::size_t least = *state_.suggestion.parameters.least_side;
    if (sides_of_map(state_.suggestion.explorations, 1, 1.0).second <= least) return {};
    SOMATO_TRY(const Samples vectors, vectors_of_parts());
    SomParameters parameters;
    parameters.similarity = state_.suggestion.similarity;
    SOMATO_TRY(
        state_.suggestion.size,
        measured_size(parameters, vectors, {.threads = state_.options.threads, .proceed = [this] {
                                              return state_.proceed(1.0);
                                            }}));
    return {};
  }

  // The input of the map.
  Result<Samples> vectors_of_parts() const {
    Matrix<float> vectors(state_.recording.explorations.size(), elements_of_parts());
    std::size_t first = 0;
    for (const SuggestedPart& part : state_.suggestion.parts) {
      SOMATO_TRY(const Samples samples, vectors_of(state_.recording, state_.groups[part.group],
                                                   part.code, state_.limits(1.0, 1.0)));
      for (std::size_t i = 0; i < samples.count(); ++i) {
        const SignalView sample = samples[i];
        for (std::size_t k = 0; k < sample.values.size(); ++k) {
          vectors(i, first + (sample.sparse ? sample.indices[k] : k)) =
              static_cast<float>(part.factor * double{sample.values[k]});
        }
      }
      first += samples.size();
    }
    return Samples(std::move(vectors));
  }

  std::size_t elements_of_parts() const {
    std::size_t elements = 0;
    for (const SuggestedPart& part : state_.suggestion.parts) {
      elements += state_.groups[part.group].candidates[part.code].elements;
    }
    return elements;
  }

  void add_comparison(const std::string& name, const std::vector<double>& errors, bool is_chosen) {
    const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
    state_.suggestion.comparisons.push_back(
        {name, sum / static_cast<double>(errors.size()), is_chosen});
  }

  static bool is_same(const std::vector<SuggestedPart>& some,
                      const std::vector<SuggestedPart>& others) {
    return some.size() == 1 && others.size() == 1 && some[0].group == others[0].group &&
           some[0].code == others[0].code;
  }

  Result<std::vector<Part>> distances_of_parts(Similarity similarity) const {
    std::vector<Part> parts;
    for (const SuggestedPart& part : state_.suggestion.parts) {
      SOMATO_TRY_VOID(state_.proceed(1.0));
      SOMATO_TRY(auto found, parts_of(state_.recording, state_.groups[part.group], {&part.code, 1},
                                      state_.limits(1.0, 1.0), similarity));
      parts.push_back(std::move(found.front()));
    }
    return parts;
  }

  Result<std::vector<double>> errors_of_parts(Similarity similarity) const {
    SOMATO_TRY(const std::vector<Part> parts, distances_of_parts(similarity));
    return errors_of(weighted(parts), state_.predicted);
  }

  // The score of the combination up to each part.
  Result<void> score_parts() {
    SOMATO_TRY(const std::vector<Part> parts, distances_of_parts(Similarity::kEuclidean));
    const std::vector<WeightedPart> all = weighted(parts);
    for (std::size_t i = 0; i < all.size(); ++i) {
      state_.suggestion.parts[i].score =
          score_of(imbalances(std::span(all).first(i + 1), state_.predicted));
    }
    return {};
  }

  // `parts` are the distances of those of the suggestion.
  std::vector<WeightedPart> weighted(std::span<const Part> parts) const {
    std::vector<WeightedPart> found;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const SuggestedPart& part = state_.suggestion.parts[i];
      const double spread = state_.groups[part.group].candidates[part.code].spread;
      found.push_back({&parts[i], part.factor * std::sqrt(spread)});
    }
    return found;
  }

  // The standardized plain code of every sense, all elements with the same weight; empty if a sense
  // has none.
  std::vector<SuggestedPart> plain_parts() const {
    std::vector<SuggestedPart> parts;
    for (const std::size_t sense : state_.channels_with(ChannelRole::kSense)) {
      const std::optional<std::size_t> code = plain_code(state_.groups[sense].candidates);
      if (!code) return {};
      parts.push_back({sense, *code, 1.0, 1.0, 1.0});
    }
    return parts;
  }

  SuggestionState& state_;
};

}  // namespace

Result<void> choose_vector(SuggestionState& state) {
  return VectorChoice(state).run();
}

}  // namespace somato
