#include "studies/suggestion/suggestion_state.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "somato/core/random.h"

namespace somato {
namespace {

std::vector<std::size_t> numbers_to(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

// Explorations drawn without replacement, in their order.
std::vector<std::size_t> drawn(std::size_t count, std::size_t most, std::uint64_t seed) {
  std::vector<std::size_t> numbers = numbers_to(count);
  if (count <= most) return numbers;
  Random random(seed, Stream::kDraws);
  for (std::size_t i = 0; i < most; ++i)
    std::swap(numbers[i], numbers[i + random.below(count - i)]);
  numbers.resize(most);
  std::ranges::sort(numbers);
  return numbers;
}

Recording without_labels(const Recording& recording, const std::vector<std::size_t>& chosen) {
  Recording bare;
  for (const std::size_t number : chosen) {
    bare.explorations.push_back({{}, {}, recording.explorations[number].channels});
  }
  return bare;
}

bool have_several_frames(const Recording& recording) {
  if (recording.explorations.empty()) return false;
  const std::size_t channels = recording.explorations.front().channels.size();
  for (std::size_t i = 0; i < channels; ++i) {
    if (has_several_frames(recording, i)) return true;
  }
  return false;
}

// Rows of a table are compared sooner than explorations of many frames.
std::size_t most_compared(const SuggestionParameters& parameters, bool has_frames) {
  return parameters.explorations.value_or(has_frames ? 200 : 500);
}

}  // namespace

SuggestionState::SuggestionState(const Recording& explored, const SuggestionParameters& settings,
                                 const SuggestionOptions& run_options)
    : parameters(settings),
      options(run_options),
      whole(explored),
      has_frames(have_several_frames(explored)),
      recording(
          without_labels(explored, drawn(explored.explorations.size(),
                                         most_compared(settings, has_frames), settings.seed))) {
  suggestion.parameters = settings;
  suggestion.parameters.explorations = most_compared(settings, has_frames);
  suggestion.parameters.least_side = settings.least_side.value_or(has_frames ? 15 : 1);
  suggestion.explorations = explored.explorations.size();
  suggestion.compared = recording.explorations.size();
}

Result<void> SuggestionState::proceed(double share) const {
  constexpr double kSteps = 1000.0;
  const auto done = static_cast<std::uint64_t>(share * kSteps);
  if (!options.progress || options.progress(done, std::uint64_t{1000})) return {};
  return fail(ErrorKind::kInterrupted, "the search was interrupted", {}, "nothing was written");
}

ComparisonLimits SuggestionState::limits(double from, double to) const {
  return {parameters.elements, options.threads,
          [this, from, to](double share) { return proceed(from + share * (to - from)); }};
}

std::vector<std::size_t> SuggestionState::channels_with(ChannelRole role) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < channels().size(); ++i) {
    if (suggestion.groups[i].role == role) found.push_back(i);
  }
  return found;
}

}  // namespace somato
