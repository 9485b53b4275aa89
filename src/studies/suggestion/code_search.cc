#include "studies/suggestion/code_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/recording/layout.h"
#include "studies/codes/frame_source.h"
#include "studies/suggestion/channel_roles.h"

namespace somato {
namespace {

constexpr std::size_t kMostPostureElements = 16;  // of the one-hot side of a product

class CodeSearch {
 public:
  explicit CodeSearch(SuggestionState& state)
      : state_(state), layout_(layout_of(state.recording)) {}

  Result<void> run() {
    SOMATO_TRY_VOID(assign_roles());
    SOMATO_TRY_VOID(compare_senses());
    drop_unrelated();
    SOMATO_TRY_VOID(compare_products());
    record_scores();
    return {};
  }

 private:
  Result<void> assign_roles() {
    const std::vector<ChannelRole> roles = roles_of(state_.recording);
    speed_ = find_speed(state_.recording);
    for (std::size_t i = 0; i < roles.size(); ++i) {
      state_.suggestion.groups.push_back({{state_.channels()[i].name}, roles[i], {}});
    }
    if (std::ranges::find(roles, ChannelRole::kSense) != roles.end()) return {};
    return fail(ErrorKind::kData, "no channel differs between explorations", {},
                "check the sensors, or record further channels");
  }

  FrameSource source_of_channel(std::size_t channel) const {
    return channel_source(names_of_channels()[channel], state_.whole, channel);
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
    for (const Channel& channel : state_.channels()) names.push_back(channel.name);
    return module_names(names);
  }

  Result<void> compare_senses() {
    const std::vector<std::size_t> senses = state_.channels_with(ChannelRole::kSense);
    state_.groups.resize(state_.channels().size());
    neighbourhoods_.resize(state_.channels().size());
    for (std::size_t i = 0; i < senses.size(); ++i) {
      const double each = kCodesDone / static_cast<double>(senses.size());
      const double from = each * static_cast<double>(i);
      CandidateGroup& group = state_.groups[senses[i]];
      group.sources = {source_of(senses[i])};
      // Only standardized vectors do not depend on the units of their elements.
      if (may_mix_units(state_.recording, senses[i])) group.scalings = {Scaling::kStandardized};
      const bool has_speed = group.sources.front().outputs.size() > 1;
      SOMATO_TRY(neighbourhoods_[senses[i]], compare_codes(state_.recording, group, has_speed,
                                                           state_.limits(from, from + each)));
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
      for (const CandidateCode& candidate : state_.groups[sense].candidates) {
        if (!candidate.is_usable()) continue;
        least = std::min(least.value_or(candidate.stability), candidate.stability);
      }
    }
    for (const std::size_t sense : senses) neighbourhoods_[sense].least = least.value_or(0.0);
  }

  // The senses that are predicted, by the numbers of their channels.
  void set_senses(const std::vector<std::size_t>& senses) {
    state_.predicted.clear();
    state_.suggestion.senses.clear();
    for (std::size_t i = 0; i < senses.size(); ++i) {
      state_.groups[senses[i]].senses = {i};
      state_.predicted.push_back(neighbourhoods_[senses[i]]);
      state_.suggestion.senses.push_back(state_.channels()[senses[i]].name);
    }
  }

  std::vector<double> imbalances_of(const CandidateGroup& group,
                                    const CandidateCode& candidate) const {
    return imbalances(candidate.nearest, group.senses, state_.predicted);
  }

  // Whether a candidate of the sense predicts something better than by chance: three standard
  // deviations of the mean of random ranks.
  // Elements of a single frame may be independent of each other, and such a sense is kept.
  bool is_related(std::size_t channel) const {
    if (!has_several_frames(state_.recording, channel)) return has_usable_code(channel);
    const auto count = static_cast<double>(state_.recording.explorations.size());
    const double least = 1.0 - 3.0 / std::sqrt(3.0 * count);
    return std::ranges::any_of(
        state_.groups[channel].candidates, [&](const CandidateCode& candidate) {
          return candidate.is_usable() &&
                 std::ranges::min(imbalances_of(state_.groups[channel], candidate)) < least;
        });
  }

  bool has_usable_code(std::size_t channel) const {
    return std::ranges::any_of(state_.groups[channel].candidates, &CandidateCode::is_usable);
  }

  void drop_unrelated() {
    std::vector<std::size_t> related;
    std::vector<std::size_t> usable;
    for (const std::size_t sense : state_.channels_with(ChannelRole::kSense)) {
      if (is_related(sense)) related.push_back(sense);
      if (has_usable_code(sense)) usable.push_back(sense);
    }
    state_.suggestion.nothing_related = related.empty();
    if (related.empty()) related = usable;
    for (const std::size_t sense : state_.channels_with(ChannelRole::kSense)) {
      if (std::ranges::find(related, sense) != related.end()) continue;
      state_.suggestion.groups[sense].role = ChannelRole::kUnrelated;
    }
    set_senses(related);
  }

  double best_score(std::size_t group) const {
    double best = 1.0;
    for (const CandidateCode& candidate : state_.groups[group].candidates) {
      if (!candidate.is_usable()) continue;
      best = std::min(best, score_of(imbalances_of(state_.groups[group], candidate)));
    }
    return best;
  }

  bool can_be_multiplied(std::size_t posture, std::size_t other) const {
    const std::vector<ChannelLayout>& known = layout_.channels;
    const auto has_frames = [&](const Exploration& exploration) {
      return exploration.channels[posture].frames.rows() > 1;
    };
    return posture != other && known[posture].clock == known[other].clock &&
           state_.channels()[posture].frames.columns() <= kMostPostureElements &&
           std::ranges::any_of(state_.recording.explorations, has_frames);
  }

  // The pairs of senses with the best candidates, as channels.
  std::vector<std::pair<std::size_t, std::size_t>> pairs() const {
    std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> scored;
    const std::vector<std::size_t> senses = state_.channels_with(ChannelRole::kSense);
    for (const std::size_t posture : senses) {
      for (const std::size_t other : senses) {
        if (!can_be_multiplied(posture, other)) continue;
        scored.push_back({best_score(posture) + best_score(other), {posture, other}});
      }
    }
    std::ranges::sort(scored);
    if (scored.size() > state_.parameters.products) scored.resize(state_.parameters.products);
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
      group.senses = {state_.groups[posture].senses.front(), state_.groups[other].senses.front()};
      group.sources = {source_of_channel(posture)};
      const FrameSource second = source_of_channel(other);
      group.sources.front().modules.push_back(second.modules.front());
      group.sources.front().outputs.push_back(second.outputs.front());
      const double each = (kProductsDone - kCodesDone) / static_cast<double>(chosen.size());
      const double from = kCodesDone + each * static_cast<double>(i);
      SOMATO_TRY_VOID(compare_product(state_.recording, group, state_.limits(from, from + each)));
      state_.groups.push_back(std::move(group));
      state_.suggestion.groups.push_back(
          {{state_.channels()[posture].name, state_.channels()[other].name},
           ChannelRole::kSense,
           {}});
    }
    return {};
  }

  void record_scores() {
    for (std::size_t i = 0; i < state_.groups.size(); ++i) {
      for (const CandidateCode& candidate : state_.groups[i].candidates) {
        state_.suggestion.groups[i].codes.push_back(scored(i, candidate));
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
    if (state_.suggestion.groups[group].role != ChannelRole::kSense || !candidate.is_usable()) {
      return found;
    }
    found.imbalances = imbalances_of(state_.groups[group], candidate);
    found.score = score_of(found.imbalances);
    return found;
  }

  SuggestionState& state_;
  RecordingLayout layout_;
  std::optional<std::size_t> speed_;
  std::vector<Neighbourhoods> neighbourhoods_;  // of all channels
};

}  // namespace

Result<void> search_codes(SuggestionState& state) {
  return CodeSearch(state).run();
}

}  // namespace somato
