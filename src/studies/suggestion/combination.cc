#include "studies/suggestion/combination.h"

#include <algorithm>
#include <optional>

#include "base/core/threads.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// A way to continue a combination.
struct Addition {
  std::size_t choice = 0;
  double weight = 1.0;
};

class ForwardSelection {
 public:
  ForwardSelection(std::span<const Choice> choices, std::span<const Neighbourhoods> senses,
                   const CombinationSettings& settings)
      : choices_(choices), senses_(senses), settings_(settings) {}

  Result<Combination> run() {
    double score = 2.0;  // more than that of any combination
    while (found_.compared < settings_.budget) {
      const std::vector<Addition> additions = affordable_additions();
      if (additions.empty()) break;
      SOMATO_TRY(const auto scores, scores_of(additions));
      found_.compared += additions.size();
      const auto best = std::ranges::min_element(scores);
      if (!found_.parts.empty() && score - *best < settings_.least_gain) break;
      score = *best;
      const Addition& addition = additions[static_cast<std::size_t>(best - scores.begin())];
      found_.parts.push_back({addition.choice, addition.weight, score});
    }
    return std::move(found_);
  }

 private:
  bool is_group_used(std::size_t group) const {
    return std::ranges::any_of(
        found_.parts, [&](const ChosenPart& part) { return choices_[part.choice].group == group; });
  }

  // All weights are equivalent for the first part.
  std::vector<Addition> affordable_additions() const {
    std::vector<Addition> additions;
    for (std::size_t i = 0; i < choices_.size(); ++i) {
      if (is_group_used(choices_[i].group)) continue;
      if (found_.parts.empty()) additions.push_back({i, 1.0});
      for (const double weight : settings_.weights) {
        if (!found_.parts.empty()) additions.push_back({i, weight});
      }
    }
    const std::size_t rest = settings_.budget - found_.compared;
    if (additions.size() > rest) additions.resize(rest);
    return additions;
  }

  Result<std::vector<double>> scores_of(const std::vector<Addition>& additions) const {
    constexpr std::size_t kAtOnce = 16;  // between two calls of proceed()
    std::vector<double> scores(additions.size());
    for (std::size_t begin = 0; begin < additions.size(); begin += kAtOnce) {
      const std::size_t count = std::min(kAtOnce, additions.size() - begin);
      for_each_task(count, settings_.threads, [&](std::size_t task) {
        scores[begin + task] = score_with(additions[begin + task]);
      });
      const std::size_t done = found_.compared + begin + count;
      SOMATO_TRY_VOID(
          settings_.proceed(static_cast<double>(done) / static_cast<double>(settings_.budget)));
    }
    return scores;
  }

  double score_with(const Addition& addition) const {
    std::vector<WeightedPart> parts;
    parts.reserve(found_.parts.size() + 1);
    for (const ChosenPart& part : found_.parts) {
      parts.push_back({&choices_[part.choice].part, part.weight});
    }
    parts.push_back({&choices_[addition.choice].part, addition.weight});
    return score_of(imbalances(parts, senses_));
  }

  std::span<const Choice> choices_;
  std::span<const Neighbourhoods> senses_;
  const CombinationSettings& settings_;
  Combination found_;
};

}  // namespace

Result<Combination> best_combination(std::span<const Choice> choices,
                                     std::span<const Neighbourhoods> senses,
                                     const CombinationSettings& settings) {
  require(!choices.empty(), "a combination needs choices");
  return ForwardSelection(choices, senses, settings).run();
}

Combination all_of(std::span<const Choice> choices, std::span<const Neighbourhoods> senses) {
  Combination all;
  std::optional<std::size_t> group;
  std::vector<WeightedPart> parts;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (group == choices[i].group || choices[i].part.senses.size() > 1) continue;
    group = choices[i].group;
    parts.push_back({&choices[i].part, 1.0});
    all.parts.push_back({i, 1.0, score_of(imbalances(parts, senses))});
  }
  all.compared = all.parts.size();
  return all;
}

}  // namespace somato
