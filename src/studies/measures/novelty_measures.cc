#include "studies/measures/novelty_measures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "somato/core/check.h"
#include "somato/maps/novelty.h"

namespace somato {
namespace {

constexpr double kRounding = 1e-9;  // of rate n, which is often a whole number

std::vector<double> sorted(std::vector<double> scores) {
  require(!scores.empty(), "a measure of unknown explorations needs known and unknown ones");
  std::sort(scores.begin(), scores.end());
  return scores;
}

void append(const std::vector<double>& from, std::vector<double>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

void append(const NoveltyScores& from, NoveltyScores& to) {
  append(from.novelty, to.novelty);
  append(from.distance, to.distance);
  append(from.nearest, to.nearest);
}

double share_above(const std::vector<double>& scores, double limit) {
  require(!scores.empty(), "a share of scores needs at least one");
  const auto above =
      std::count_if(scores.begin(), scores.end(), [&](double score) { return score > limit; });
  return static_cast<double>(above) / static_cast<double>(scores.size());
}

}  // namespace

void NoveltyOutcome::add(const NoveltyOutcome& other) {
  append(other.known, known);
  append(other.unknown, unknown);
  calibrated.insert(calibrated.end(), other.calibrated.begin(), other.calibrated.end());
}

double area_under_curve(const std::vector<double>& known, const std::vector<double>& unknown) {
  require(!unknown.empty(), "a measure of unknown explorations needs known and unknown ones");
  const std::vector<double> ascending = sorted(known);
  double pairs = 0.0;  // twice those in the right order
  for (const double score : unknown) {
    const auto [low, high] = std::equal_range(ascending.begin(), ascending.end(), score);
    pairs += static_cast<double>((low - ascending.begin()) + (high - ascending.begin()));
  }
  return pairs / (2.0 * static_cast<double>(known.size()) * static_cast<double>(unknown.size()));
}

double noticed_at(const std::vector<double>& known, const std::vector<double>& unknown,
                  double rate) {
  require(rate >= 0.0 && rate < 1.0, "a false-alarm rate is from 0 and below 1");
  const std::vector<double> ascending = sorted(known);
  const double allowed = std::floor(rate * static_cast<double>(known.size()) + kRounding);
  return share_above(unknown, ascending[known.size() - 1 - static_cast<std::size_t>(allowed)]);
}

double share_unknown(const std::vector<double>& novelty) {
  require(!novelty.empty(), "a share of scores needs at least one");
  const auto unknown = std::count_if(novelty.begin(), novelty.end(), is_unknown);
  return static_cast<double>(unknown) / static_cast<double>(novelty.size());
}

}  // namespace somato
