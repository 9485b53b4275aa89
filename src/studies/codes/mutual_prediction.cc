#include "studies/codes/mutual_prediction.h"

#include <algorithm>
#include <functional>

#include "studies/codes/neighbours.h"

namespace somato {
namespace {

using Nearest = std::vector<std::uint32_t>;

double mean_of_splits(const Neighbourhoods& sense, const std::function<Nearest(View)>& nearest_in) {
  double sum = 0.0;
  for (const Split& split : kSplits) {
    sum += information_imbalance(nearest_in(split.from), sense.ranks[split.to]);
  }
  return sum / static_cast<double>(kSplits.size());
}

bool uses(const Part& part, std::size_t sense) {
  return std::ranges::find(part.senses, sense) != part.senses.end();
}

// The combined distances when the parts that use the sense are seen in that view.
Matrix<float> combined(std::span<const WeightedPart> parts, std::size_t sense, View view) {
  const std::size_t count = parts.front().part->distances[View::kWhole].rows();
  Matrix<float> sum(count, count);
  for (const WeightedPart& weighted : parts) {
    const View seen = uses(*weighted.part, sense) ? view : View::kWhole;
    const std::span<const float> distances = weighted.part->distances[seen].values();
    const bool is_squared = weighted.part->similarity == Similarity::kEuclidean;
    const auto factor =
        static_cast<float>(is_squared ? weighted.weight * weighted.weight : weighted.weight);
    const std::span<float> sums = sum.values();
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += factor * distances[i];
  }
  return sum;
}

double from_whole(const Nearest& whole, const Neighbourhoods& sense, bool is_used) {
  const double imbalance = information_imbalance(whole, sense.ranks[View::kWhole]);
  return is_used ? std::max(imbalance, sense.least) : imbalance;
}

// Adds the terms of the information imbalance, times the factor.
void add_terms(const Nearest& nearest, const Matrix<float>& ranks, double factor,
               std::vector<double>& terms) {
  const double each = factor * 2.0 / static_cast<double>(nearest.size());
  for (std::size_t i = 0; i < nearest.size(); ++i) terms[i] += each * double{ranks(i, nearest[i])};
}

}  // namespace

std::vector<double> imbalances(const PerView<Nearest>& nearest, std::span<const std::size_t> used,
                               std::span<const Neighbourhoods> senses) {
  std::vector<double> found;
  for (std::size_t sense = 0; sense < senses.size(); ++sense) {
    const bool is_used = std::ranges::find(used, sense) != used.end();
    const auto nearest_in = [&](View view) { return nearest[view]; };
    found.push_back(is_used && senses[sense].has_halves
                        ? mean_of_splits(senses[sense], nearest_in)
                        : from_whole(nearest[View::kWhole], senses[sense], is_used));
  }
  return found;
}

std::vector<double> imbalances(std::span<const WeightedPart> parts,
                               std::span<const Neighbourhoods> senses) {
  const Nearest whole = nearest_others(combined(parts, senses.size(), View::kWhole));
  std::vector<double> found;
  for (std::size_t sense = 0; sense < senses.size(); ++sense) {
    const bool is_used =
        std::ranges::any_of(parts, [&](const WeightedPart& p) { return uses(*p.part, sense); });
    const auto nearest_in = [&](View view) { return nearest_others(combined(parts, sense, view)); };
    found.push_back(is_used && senses[sense].has_halves
                        ? mean_of_splits(senses[sense], nearest_in)
                        : from_whole(whole, senses[sense], is_used));
  }
  return found;
}

double score_of(std::span<const double> imbalances) {
  double sum = 0.0;
  for (const double imbalance : imbalances) sum += imbalance;
  return sum / static_cast<double>(imbalances.size());
}

std::vector<double> errors_of(std::span<const WeightedPart> parts,
                              std::span<const Neighbourhoods> senses) {
  const Nearest whole = nearest_others(combined(parts, senses.size(), View::kWhole));
  const double each = 1.0 / static_cast<double>(senses.size());
  std::vector<double> errors(whole.size(), 0.0);
  for (std::size_t sense = 0; sense < senses.size(); ++sense) {
    if (!senses[sense].has_halves) {
      add_terms(whole, senses[sense].ranks[View::kWhole], each, errors);
      continue;
    }
    for (const Split& split : kSplits) {
      add_terms(nearest_others(combined(parts, sense, split.from)), senses[sense].ranks[split.to],
                each / static_cast<double>(kSplits.size()), errors);
    }
  }
  return errors;
}

}  // namespace somato
