#include "studies/suggestion/suggestion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "maps/analysis/paired_errors.h"
#include "somato/core/random.h"
#include "somato/recording/layout.h"
#include "studies/suggestion/candidates.h"
#include "studies/suggestion/channel_roles.h"
#include "studies/suggestion/combination.h"
#include "studies/suggestion/frame_source.h"
#include "studies/suggestion/suggested_system.h"

namespace somato {
namespace {

constexpr std::size_t kMostPostureElements = 16;  // of the one-hot side of a product

// The shares of the work, for progress.
constexpr double kCodesDone = 0.6;
constexpr double kProductsDone = 0.75;
constexpr double kPartsDone = 0.85;

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

Result<void> check_usable(const Recording& recording) {
  SOMATO_TRY_VOID(validate(recording));
  if (recording.explorations.size() > 1) return {};
  return fail(ErrorKind::kData, "the recording has only one exploration", {},
              "a comparison requires at least two; explore more, or cut a long recording into "
              "windows when it is imported ('window')");
}

// A search through the codes of one recording.
class Search {
 public:
  Search(const Recording& recording, const SuggestionParameters& parameters,
         const SuggestionOptions& options)
      : parameters_(parameters),
        options_(options),
        whole_(recording),
        has_frames_(have_several_frames(recording)),
        recording_(without_labels(
            recording, drawn(recording.explorations.size(), most_compared(), parameters.seed))),
        layout_(layout_of(recording_)) {
    suggestion_.parameters = parameters;
    suggestion_.parameters.explorations = most_compared();
    suggestion_.parameters.least_side = parameters.least_side.value_or(has_frames_ ? 15 : 1);
    suggestion_.explorations = recording.explorations.size();
    suggestion_.compared = recording_.explorations.size();
  }

  Result<Suggestion> run() {
    SOMATO_TRY_VOID(assign_roles());
    SOMATO_TRY_VOID(compare_senses());
    drop_unrelated();
    SOMATO_TRY_VOID(compare_products());
    record_scores();
    SOMATO_TRY_VOID(combine());
    SOMATO_TRY_VOID(measure_size());
    suggestion_.system = system_of(suggestion_, groups_);
    return std::move(suggestion_);
  }

 private:
  // Rows of a table are compared sooner than explorations of many frames.
  std::size_t most_compared() const {
    return parameters_.explorations.value_or(has_frames_ ? 200 : 500);
  }

  Result<void> proceed(double share) const {
    constexpr double kSteps = 1000.0;
    const auto done = static_cast<std::uint64_t>(share * kSteps);
    if (!options_.progress || options_.progress(done, std::uint64_t{1000})) return {};
    return fail(ErrorKind::kInterrupted, "the search was interrupted", {}, "nothing was written");
  }

  ComparisonLimits limits(double from, double to) const {
    return {parameters_.elements, options_.threads,
            [this, from, to](double share) { return proceed(from + share * (to - from)); }};
  }

  const std::vector<Channel>& channels() const { return recording_.explorations.front().channels; }

  Result<void> assign_roles() {
    const std::vector<ChannelRole> roles = roles_of(recording_);
    speed_ = find_speed(recording_);
    for (std::size_t i = 0; i < roles.size(); ++i) {
      suggestion_.groups.push_back({{channels()[i].name}, roles[i], {}});
    }
    if (std::ranges::find(roles, ChannelRole::kSense) != roles.end()) return {};
    return fail(ErrorKind::kData, "no channel differs between explorations", {},
                "check the sensors, or record further channels");
  }

  std::vector<std::size_t> channels_with(ChannelRole role) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < channels().size(); ++i) {
      if (suggestion_.groups[i].role == role) found.push_back(i);
    }
    return found;
  }

  FrameSource source_of_channel(std::size_t channel) const {
    return channel_source(names_of_channels()[channel], whole_, channel);
  }

  FrameSource source_of(std::size_t channel) const {
    FrameSource source = source_of_channel(channel);
    if (!speed_ || *speed_ == channel) return source;
    const FrameSource speed = source_of_channel(*speed_);
    source.modules.push_back(speed.modules.front());
    source.outputs.push_back(speed.outputs.front());
    return source;
  }

  std::vector<std::string> names_of_channels() const {
    std::vector<std::string> names;
    for (const Channel& channel : channels()) names.push_back(channel.name);
    return module_names(names);
  }

  Result<void> compare_senses() {
    const std::vector<std::size_t> senses = channels_with(ChannelRole::kSense);
    groups_.resize(channels().size());
    neighbourhoods_.resize(channels().size());
    for (std::size_t i = 0; i < senses.size(); ++i) {
      const double each = kCodesDone / static_cast<double>(senses.size());
      const double from = each * static_cast<double>(i);
      CandidateGroup& group = groups_[senses[i]];
      group.sources = {source_of(senses[i])};
      // Only standardized vectors do not depend on the units of their elements.
      if (may_mix_units(recording_, senses[i])) group.scalings = {Scaling::kStandardized};
      const bool has_speed = group.sources.front().outputs.size() > 1;
      SOMATO_TRY(neighbourhoods_[senses[i]],
                 compare_codes(recording_, group, has_speed, limits(from, from + each)));
    }
    limit_senses_without_halves(senses);
    set_senses(senses);
    return {};
  }

  // They are assumed to be as stable as the most stable code of the other senses.
  void limit_senses_without_halves(const std::vector<std::size_t>& senses) {
    std::optional<double> least;
    for (const std::size_t sense : senses) {
      if (!neighbourhoods_[sense].has_halves) continue;
      for (const CandidateCode& candidate : groups_[sense].candidates) {
        if (!candidate.is_usable()) continue;
        least = std::min(least.value_or(candidate.stability), candidate.stability);
      }
    }
    for (const std::size_t sense : senses) neighbourhoods_[sense].least = least.value_or(0.0);
  }

  // The senses that are predicted, by the numbers of their channels.
  void set_senses(const std::vector<std::size_t>& senses) {
    predicted_.clear();
    suggestion_.senses.clear();
    for (std::size_t i = 0; i < senses.size(); ++i) {
      groups_[senses[i]].senses = {i};
      predicted_.push_back(neighbourhoods_[senses[i]]);
      suggestion_.senses.push_back(channels()[senses[i]].name);
    }
  }

  std::vector<double> imbalances_of(const CandidateGroup& group,
                                    const CandidateCode& candidate) const {
    return imbalances(candidate.nearest, group.senses, predicted_);
  }

  // Whether a candidate of the sense predicts something better than by chance: three standard
  // deviations of the mean of random ranks.
  // Elements of a single frame may be independent of each other, and such a sense is kept.
  bool is_related(std::size_t channel) const {
    if (!has_several_frames(recording_, channel)) return has_usable_code(channel);
    const auto count = static_cast<double>(recording_.explorations.size());
    const double least = 1.0 - 3.0 / std::sqrt(3.0 * count);
    return std::ranges::any_of(groups_[channel].candidates, [&](const CandidateCode& candidate) {
      return candidate.is_usable() &&
             std::ranges::min(imbalances_of(groups_[channel], candidate)) < least;
    });
  }

  bool has_usable_code(std::size_t channel) const {
    return std::ranges::any_of(groups_[channel].candidates, &CandidateCode::is_usable);
  }

  void drop_unrelated() {
    std::vector<std::size_t> related;
    std::vector<std::size_t> usable;
    for (const std::size_t sense : channels_with(ChannelRole::kSense)) {
      if (is_related(sense)) related.push_back(sense);
      if (has_usable_code(sense)) usable.push_back(sense);
    }
    suggestion_.nothing_related = related.empty();
    if (related.empty()) related = usable;
    for (const std::size_t sense : channels_with(ChannelRole::kSense)) {
      if (std::ranges::find(related, sense) != related.end()) continue;
      suggestion_.groups[sense].role = ChannelRole::kUnrelated;
    }
    set_senses(related);
  }

  double best_score(std::size_t group) const {
    double best = 1.0;
    for (const CandidateCode& candidate : groups_[group].candidates) {
      if (!candidate.is_usable()) continue;
      best = std::min(best, score_of(imbalances_of(groups_[group], candidate)));
    }
    return best;
  }

  bool can_be_multiplied(std::size_t posture, std::size_t other) const {
    const std::vector<ChannelLayout>& known = layout_.channels;
    const auto has_frames = [&](const Exploration& exploration) {
      return exploration.channels[posture].frames.rows() > 1;
    };
    return posture != other && known[posture].clock == known[other].clock &&
           channels()[posture].frames.columns() <= kMostPostureElements &&
           std::ranges::any_of(recording_.explorations, has_frames);
  }

  // The pairs of senses with the best candidates, as channels.
  std::vector<std::pair<std::size_t, std::size_t>> pairs() const {
    std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> scored;
    const std::vector<std::size_t> senses = channels_with(ChannelRole::kSense);
    for (const std::size_t posture : senses) {
      for (const std::size_t other : senses) {
        if (!can_be_multiplied(posture, other)) continue;
        scored.push_back({best_score(posture) + best_score(other), {posture, other}});
      }
    }
    std::ranges::sort(scored);
    if (scored.size() > parameters_.products) scored.resize(parameters_.products);
    std::vector<std::pair<std::size_t, std::size_t>> found;
    found.reserve(scored.size());
    for (const auto& pair : scored) found.push_back(pair.second);
    return found;
  }

  Result<void> compare_products() {
    const auto chosen = pairs();
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const auto [posture, other] = chosen[i];
      CandidateGroup group;
      group.senses = {groups_[posture].senses.front(), groups_[other].senses.front()};
      group.sources = {source_of_channel(posture)};
      const FrameSource second = source_of_channel(other);
      group.sources.front().modules.push_back(second.modules.front());
      group.sources.front().outputs.push_back(second.outputs.front());
      const double each = (kProductsDone - kCodesDone) / static_cast<double>(chosen.size());
      const double from = kCodesDone + each * static_cast<double>(i);
      SOMATO_TRY_VOID(compare_product(recording_, group, limits(from, from + each)));
      groups_.push_back(std::move(group));
      suggestion_.groups.push_back(
          {{channels()[posture].name, channels()[other].name}, ChannelRole::kSense, {}});
    }
    return {};
  }

  void record_scores() {
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      for (const CandidateCode& candidate : groups_[i].candidates) {
        suggestion_.groups[i].codes.push_back(scored(i, candidate));
      }
    }
  }

  SuggestedCode scored(std::size_t group, const CandidateCode& candidate) const {
    const Code code = scaled(candidate.code, candidate.scaling);
    SuggestedCode found{candidate.code.name,
                        choice_name(candidate.scaling),
                        code.output,
                        candidate.elements,
                        1.0,
                        {},
                        candidate.failure};
    if (suggestion_.groups[group].role != ChannelRole::kSense || !candidate.is_usable()) {
      return found;
    }
    found.imbalances = imbalances_of(groups_[group], candidate);
    found.score = score_of(found.imbalances);
    return found;
  }

  // The best usable codes of a group.
  std::vector<std::size_t> best_codes(std::size_t group) const {
    const std::vector<SuggestedCode>& codes = suggestion_.groups[group].codes;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < codes.size(); ++i) {
      if (codes[i].failure.empty()) numbers.push_back(i);
    }
    std::ranges::sort(numbers, {},
                      [&](std::size_t code) { return std::pair(codes[code].score, code); });
    if (numbers.size() > parameters_.candidates) numbers.resize(parameters_.candidates);
    return numbers;
  }

  Result<void> combine() {
    std::vector<Choice> choices;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      SOMATO_TRY_VOID(
          proceed(kProductsDone + (kPartsDone - kProductsDone) * static_cast<double>(i) /
                                      static_cast<double>(groups_.size())));
      if (suggestion_.groups[i].role != ChannelRole::kSense) continue;
      const std::vector<std::size_t> codes = best_codes(i);
      SOMATO_TRY(auto parts, parts_of(recording_, groups_[i], codes, limits(0.0, 1.0)));
      for (std::size_t k = 0; k < codes.size(); ++k) {
        choices.push_back({i, codes[k], std::move(parts[k])});
      }
    }
    const CombinationSettings settings{
        parameters_.weights, parameters_.least_gain, parameters_.budget, options_.threads,
        [this](double share) { return proceed(kPartsDone + (1.0 - kPartsDone) * share); }};
    SOMATO_TRY(const auto found, suggestion_.nothing_related
                                     ? Result<Combination>(all_of(choices, predicted_))
                                     : best_combination(choices, predicted_, settings));
    suggestion_.combinations = found.compared;
    for (const ChosenPart& part : found.parts) {
      const Choice& choice = choices[part.choice];
      const double spread = groups_[choice.group].candidates[choice.code].spread;
      suggestion_.parts.push_back(
          {choice.group, choice.code, part.weight, part.weight / std::sqrt(spread), part.score});
    }
    return suggestion_.nothing_related ? Result<void>() : settle();
  }

  // The plain vector replaces a combination that is not clearly better, and Manhattan distance the
  // Euclidean one if it is clearly better.
  Result<void> settle() {
    SOMATO_TRY(std::vector<double> errors, errors_of_parts(Similarity::kEuclidean));
    add_comparison("the combination", errors, true);
    const std::vector<SuggestedPart> plain = plain_parts();
    if (!plain.empty() && !is_same(plain, suggestion_.parts)) {
      std::vector<SuggestedPart> found = std::exchange(suggestion_.parts, plain);
      SOMATO_TRY(std::vector<double> of_plain, errors_of_parts(Similarity::kEuclidean));
      const bool is_kept = is_clearly_better(errors, of_plain);
      suggestion_.comparisons.back().is_chosen = is_kept;
      add_comparison("the plain standardized vector", of_plain, !is_kept);
      if (is_kept) std::swap(suggestion_.parts, found);
      if (!is_kept) std::swap(errors, of_plain);
      if (!is_kept) SOMATO_TRY_VOID(score_parts());
    }
    SOMATO_TRY(const auto of_manhattan, errors_of_parts(Similarity::kManhattan));
    const bool is_manhattan = is_clearly_better(of_manhattan, errors);
    if (is_manhattan) suggestion_.similarity = Similarity::kManhattan;
    add_comparison("the chosen vector by Manhattan distance", of_manhattan, is_manhattan);
    return {};
  }

  // With fewer neurons than `least_side` requires nothing needs to be measured.
  Result<void> measure_size() {
    const std::size_t least = *suggestion_.parameters.least_side;
    if (side_of_map(suggestion_.explorations, 1, 1.0) <= least) return {};
    SOMATO_TRY(const Samples vectors, vectors_of_parts());
    SOMATO_TRY(suggestion_.size, measured_size(vectors, suggestion_.similarity, options_.threads,
                                               [this] { return proceed(1.0); }));
    return {};
  }

  // The input of the map.
  Result<Samples> vectors_of_parts() const {
    Matrix<float> vectors(recording_.explorations.size(), elements_of_parts());
    std::size_t first = 0;
    for (const SuggestedPart& part : suggestion_.parts) {
      SOMATO_TRY(const Samples samples,
                 vectors_of(recording_, groups_[part.group], part.code, limits(1.0, 1.0)));
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
    for (const SuggestedPart& part : suggestion_.parts) {
      elements += groups_[part.group].candidates[part.code].elements;
    }
    return elements;
  }

  void add_comparison(const std::string& name, const std::vector<double>& errors, bool is_chosen) {
    const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
    suggestion_.comparisons.push_back({name, sum / static_cast<double>(errors.size()), is_chosen});
  }

  static bool is_same(const std::vector<SuggestedPart>& some,
                      const std::vector<SuggestedPart>& others) {
    return some.size() == 1 && others.size() == 1 && some[0].group == others[0].group &&
           some[0].code == others[0].code;
  }

  Result<std::vector<Part>> distances_of_parts(Similarity similarity) const {
    std::vector<Part> parts;
    for (const SuggestedPart& part : suggestion_.parts) {
      SOMATO_TRY_VOID(proceed(1.0));
      SOMATO_TRY(auto found, parts_of(recording_, groups_[part.group], {&part.code, 1},
                                      limits(1.0, 1.0), similarity));
      parts.push_back(std::move(found.front()));
    }
    return parts;
  }

  Result<std::vector<double>> errors_of_parts(Similarity similarity) const {
    SOMATO_TRY(const std::vector<Part> parts, distances_of_parts(similarity));
    return errors_of(weighted(parts), predicted_);
  }

  // The score of the combination up to each part.
  Result<void> score_parts() {
    SOMATO_TRY(const std::vector<Part> parts, distances_of_parts(Similarity::kEuclidean));
    const std::vector<WeightedPart> all = weighted(parts);
    for (std::size_t i = 0; i < all.size(); ++i) {
      suggestion_.parts[i].score = score_of(imbalances(std::span(all).first(i + 1), predicted_));
    }
    return {};
  }

  // `parts` are the distances of those of the suggestion.
  std::vector<WeightedPart> weighted(std::span<const Part> parts) const {
    std::vector<WeightedPart> found;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const SuggestedPart& part = suggestion_.parts[i];
      const double spread = groups_[part.group].candidates[part.code].spread;
      found.push_back({&parts[i], part.factor * std::sqrt(spread)});
    }
    return found;
  }

  // The standardized plain code of every sense, all elements with the same weight; empty if a sense
  // has none.
  std::vector<SuggestedPart> plain_parts() const {
    std::vector<SuggestedPart> parts;
    for (const std::size_t sense : channels_with(ChannelRole::kSense)) {
      const std::optional<std::size_t> code = plain_code(groups_[sense].candidates);
      if (!code) return {};
      parts.push_back({sense, *code, 1.0, 1.0, 1.0});
    }
    return parts;
  }

  const SuggestionParameters& parameters_;
  const SuggestionOptions& options_;
  const Recording& whole_;
  bool has_frames_;      // whether an exploration has several
  Recording recording_;  // the explorations that are compared, without labels
  RecordingLayout layout_;
  std::optional<std::size_t> speed_;
  std::vector<CandidateGroup> groups_;          // of all channels, then of the products
  std::vector<Neighbourhoods> neighbourhoods_;  // of all channels
  std::vector<Neighbourhoods> predicted_;       // of the kept senses
  Suggestion suggestion_;
};

}  // namespace

const std::vector<std::pair<ChannelRole, std::string>>& Choices<ChannelRole>::all() {
  static const std::vector<std::pair<ChannelRole, std::string>> choices{
      {ChannelRole::kSense, "sense"},
      {ChannelRole::kConstant, "constant"},
      {ChannelRole::kSetting, "setting"},
      {ChannelRole::kUnrelated, "unrelated"}};
  return choices;
}

const Declarations<SuggestionParameters>& SuggestionParameters::declarations() {
  using P = SuggestionParameters;
  static const auto declared =
      Declarations<P>()
          .add("name", &P::name, "", Range::any(), "Name of the study in the file.")
          .add("label", &P::label, "", Range::any(),
               "Label by which the study in the file measures accuracy; it does not affect the "
               "search.")
          .add("budget", &P::budget, "combinations", Range::between(1, 1e9),
               "Maximum number of combinations that are compared; not in the papers.")
          .add("explorations", &P::explorations, "", Range::between(2, 4096),
               "Maximum number of explorations that are compared; of more, that many are drawn at "
               "random. Automatic: 200, or 500 if explorations have one frame, as the rows of a "
               "table.")
          .add("candidates", &P::candidates, "", Range::between(1, 1000),
               "Number of the best codes of each sense that are combined with other senses.")
          .add("products", &P::products, "", Range::between(0, 1000),
               "Maximum number of tensor products of two senses.")
          .add("elements", &P::elements, "", Range::between(1, 1e7),
               "Maximum number of elements of a vector; longer ones are not compared.")
          .add("weights", &P::weights, "", Range::between(1e-3, 1e3),
               "Weights with which a part is added, relative to parts of unit spread; the first of "
               "equally good ones is used.")
          .add("least_gain", &P::least_gain, "", Range::between(0, 1),
               "Least decrease of the score for which a further part is added.")
          .add(
              "least_side", &P::least_side, "neurons", Range::between(1, 40),
              "Least number of rows and of columns of the map, which otherwise has at most as many "
              "neurons as explorations to learn; automatic: 15 as in the papers, or 1 if "
              "explorations have one frame, as the rows of a table.")
          .add("seed", &P::seed, "", Range::between(0, 1e15),
               "Seed of the draw of explorations, if there are more than are compared.");
  return declared;
}

Result<Suggestion> suggest(const Recording& recording, const SuggestionParameters& parameters,
                           const SuggestionOptions& options) {
  SOMATO_TRY_VOID(check_ranges(parameters));
  if (parameters.weights.empty()) {
    return fail(ErrorKind::kUsage, "'weights' is empty", "weights", "use a list such as 0.5,1,2");
  }
  SOMATO_TRY_VOID(check_usable(recording));
  return Search(recording, parameters, options).run();
}

}  // namespace somato
