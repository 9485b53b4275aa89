#include "studies/codes/candidates.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/codes/neighbours.h"
#include "studies/codes/representation.h"
#include "studies/codes/rounding.h"

namespace somato {
namespace {

constexpr double kFloorShare = 0.01;   // of the median magnitude
constexpr double kEqualShare = 1e-12;  // spread by the mean square, below which vectors are equal
constexpr double kMostSpread = 1e30;   // of squared distances in single precision

double mean_square(const Samples& vectors) {
  double sum = 0.0;
  for (std::size_t i = 0; i < vectors.count(); ++i) sum += inner_product(vectors[i], vectors[i]);
  return sum / static_cast<double>(vectors.count());
}

std::string failure_of(const Samples& vectors, double spread, Scaling scaling) {
  if (scaling == Scaling::kUnit && vectors.size() < 2) return "a single element";
  if (!(spread > kEqualShare * mean_square(vectors))) return "the same for all explorations";
  return spread < kMostSpread ? "" : "its values are too large";
}

// The value below which magnitudes are not distinguished by their logarithm.
double floor_of(const Samples& spectra) {
  std::vector<float> magnitudes;
  for (std::size_t i = 0; i < spectra.count(); ++i) {
    for (const float value : spectra[i].values) {
      if (value > 0.0F) magnitudes.push_back(value);
    }
  }
  if (magnitudes.empty()) return kFloorShare;
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
  std::ranges::nth_element(magnitudes, middle);
  return std::max(rounded(kFloorShare * double{*middle}), 1e-30);
}

// Adds the ranks of a candidate to those of its sense.
void add_neighbourhoods(const PerView<Matrix<float>>& distances, std::size_t threads,
                        CandidateCode& candidate, Neighbourhoods& sum) {
  PerView<Matrix<float>> ranks;
  for (const View view : kAllViews) {
    ranks[view] = Matrix<float>(distances[view].rows(), distances[view].rows());
    add_ranks(distances[view], threads, ranks[view]);
    const std::span<float> sums = sum.ranks[view].values();
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += ranks[view].values()[i];
  }
  candidate.stability = 0.0;
  for (const Split& split : kSplits) {
    candidate.stability += information_imbalance(candidate.nearest[split.from], ranks[split.to]) /
                           static_cast<double>(kSplits.size());
  }
}

CandidateCode candidate_of(const Representation& representation, const Code& code,
                           std::size_t source, Neighbourhoods* sum, std::size_t threads) {
  CandidateCode candidate{source, code, representation.scaling, 0, 0.0, {}, 1.0, {}};
  const Samples& whole = representation.vectors[View::kWhole];
  candidate.elements = whole.size();
  PerView<Matrix<float>> distances;
  distances[View::kWhole] = squared_distances(whole, threads);
  candidate.spread = spread_of(distances[View::kWhole]);
  candidate.failure = failure_of(whole, candidate.spread, candidate.scaling);
  if (!candidate.is_usable()) return candidate;
  for (const View view : kAllViews) {
    if (view != View::kWhole) {
      distances[view] = squared_distances(representation.vectors[view], threads);
    }
    candidate.nearest[view] = nearest_others(distances[view]);
  }
  if (sum) add_neighbourhoods(distances, threads, candidate, *sum);
  return candidate;
}

// Adds the candidates of a code, and their ranks to `sum`; returns its vectors, empty on failure.
Samples add_candidates(const ViewedFrames& frames, const Code& code, std::size_t source,
                       const std::vector<Scaling>& scalings, const ComparisonLimits& limits,
                       CandidateGroup& group, Neighbourhoods* sum) {
  auto found = represent(frames, code, scalings, limits.elements, limits.threads);
  if (!found) {
    for (const Scaling scaling : scalings) {
      group.candidates.push_back({source, code, scaling, 0, 0.0, {}, 1.0, found.error().what});
    }
    return {};
  }
  for (const Representation& representation : *found) {
    group.candidates.push_back(candidate_of(representation, code, source, sum, limits.threads));
  }
  return found->front().vectors[View::kWhole];
}

Neighbourhoods no_ranks(std::size_t explorations) {
  Neighbourhoods sum;
  for (const View view : kAllViews) sum.ranks[view] = Matrix<float>(explorations, explorations);
  return sum;
}

Result<ViewedFrames> viewed_frames(const Recording& recording, const FrameSource& source,
                                   std::size_t threads) {
  SOMATO_TRY(const auto frames, frames_of(recording, source, threads));
  return all_views_of(frames);
}

// With the onset as a further source if contact begins at different moments.
Result<void> add_onset(const Recording& recording, CandidateGroup& group, std::size_t threads) {
  SOMATO_TRY(const auto frames, frames_of(recording, group.sources.front(), threads));
  if (const auto onset = find_varying_onset(frames)) {
    group.sources.push_back(from_onset(group.sources.front(), *onset));
  }
  return {};
}

Result<void> compare_source(const Recording& recording, std::size_t number, bool has_speed,
                            const ComparisonLimits& limits, CandidateGroup& group,
                            Neighbourhoods& sum) {
  const FrameSource source = group.sources[number];
  SOMATO_TRY(const auto frames, viewed_frames(recording, source, limits.threads));
  const FrameFacts facts = facts_of(frames[View::kWhole], has_speed);
  const bool has_elements = facts.most_frames == 1 && facts.elements > 1;
  sum.has_halves = facts.shortest_half > 0 || has_elements;
  std::vector<Code> codes = codes_of(source, facts);
  Samples preceding;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (!codes[i].logarithm_of.empty()) set_floor(codes[i], floor_of(preceding));
    preceding = add_candidates(frames, codes[i], number, group.scalings, limits, group, &sum);
    const double done = static_cast<double>(i + 1) / static_cast<double>(codes.size());
    SOMATO_TRY_VOID(limits.proceed((static_cast<double>(number) + done) /
                                   static_cast<double>(group.sources.size())));
  }
  return {};
}

Result<Representation> represented(const Recording& recording, const CandidateGroup& group,
                                   std::size_t number, const ComparisonLimits& limits) {
  const CandidateCode& candidate = group.candidates[number];
  SOMATO_TRY(const auto frames,
             viewed_frames(recording, group.sources[candidate.source], limits.threads));
  SOMATO_TRY(auto found, represent(frames, candidate.code, {candidate.scaling}, limits.elements,
                                   limits.threads));
  return std::move(found.front());
}

PerView<Matrix<float>> unit_distances(const Representation& representation, double spread,
                                      Similarity similarity, std::size_t threads) {
  const bool is_manhattan = similarity == Similarity::kManhattan;
  const auto distances_of = is_manhattan ? manhattan_distances : squared_distances;
  const auto factor = static_cast<float>(1.0 / (is_manhattan ? std::sqrt(spread) : spread));
  PerView<Matrix<float>> distances;
  for (const View view : kAllViews) {
    distances[view] = distances_of(representation.vectors[view], threads);
    for (float& distance : distances[view].values()) distance *= factor;
  }
  return distances;
}

}  // namespace

Result<Neighbourhoods> compare_codes(const Recording& recording, CandidateGroup& group,
                                     bool has_speed, const ComparisonLimits& limits) {
  SOMATO_TRY_VOID(add_onset(recording, group, limits.threads));
  Neighbourhoods found = no_ranks(recording.explorations.size());
  for (std::size_t source = 0; source < group.sources.size(); ++source) {
    SOMATO_TRY_VOID(compare_source(recording, source, has_speed, limits, group, found));
  }
  const auto usable = static_cast<float>(std::ranges::count_if(
      group.candidates, [](const CandidateCode& candidate) { return candidate.is_usable(); }));
  for (const View view : kAllViews) {
    for (float& rank : found.ranks[view].values()) rank /= std::max(usable, 1.0F);
  }
  return found;
}

Result<void> compare_product(const Recording& recording, CandidateGroup& group,
                             const ComparisonLimits& limits) {
  const FrameSource& source = group.sources.front();
  SOMATO_TRY(const auto frames, viewed_frames(recording, source, limits.threads));
  const FrameFacts facts = facts_of(frames[View::kWhole], false);
  add_candidates(frames, product_code(source, facts), 0, {Scaling::kUnit}, limits, group, nullptr);
  return limits.proceed(1.0);
}

std::optional<std::size_t> plain_code(std::span<const CandidateCode> candidates) {
  const auto find = [&](const std::string& name) -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const CandidateCode& candidate = candidates[i];
      const bool is_plain = candidate.source == 0 && candidate.code.name == name &&
                            candidate.scaling == Scaling::kStandardized;
      if (is_plain && candidate.is_usable()) return i;
    }
    return std::nullopt;
  };
  const bool is_scalar = std::ranges::any_of(candidates, [](const CandidateCode& candidate) {
    return candidate.code.name == "last" && candidate.elements == 1;
  });
  if (is_scalar) {
    if (const auto bands = find("wide_spectrum")) return bands;
  }
  const auto curve = find("curve");
  return curve ? curve : find("last");
}

Result<std::vector<Part>> parts_of(const Recording& recording, const CandidateGroup& group,
                                   std::span<const std::size_t> chosen,
                                   const ComparisonLimits& limits, Similarity similarity) {
  std::vector<Part> parts;
  for (const std::size_t number : chosen) {
    SOMATO_TRY(const Representation found, represented(recording, group, number, limits));
    const double spread = group.candidates[number].spread;
    parts.push_back(
        {group.senses, unit_distances(found, spread, similarity, limits.threads), similarity});
  }
  return parts;
}

Result<Samples> vectors_of(const Recording& recording, const CandidateGroup& group,
                           std::size_t number, const ComparisonLimits& limits) {
  SOMATO_TRY(const Representation found, represented(recording, group, number, limits));
  return found.vectors[View::kWhole];
}

}  // namespace somato
