#include "maps/som/known_elements.h"

#include <algorithm>
#include <cmath>

#include "base/core/lanes.h"
#include "maps/som/product_reading.h"
#include "maps/som/similarity_scores.h"

namespace somato {

std::vector<KnownRun> known_runs(std::span<const float> input) {
  std::vector<KnownRun> runs;
  for (std::size_t d = 0; d < input.size(); ++d) {
    if (std::isnan(input[d])) continue;
    const bool continues = !runs.empty() && runs.back().first + runs.back().count == d;
    if (!continues) runs.push_back({d, 0});
    ++runs.back().count;
  }
  return runs;
}

void KnownScores::write(Similarity similarity, kernels::Lanes<const float> weights,
                        std::size_t rows, float* out) const {
  const std::size_t padded = weights.blocks * kFloatLanes;
  std::fill_n(out, padded, 0.0F);
  AlignedVector<float> of_run(runs_.size() > 1 ? padded : 0);
  for (const KnownRun& run : runs_) {
    const kernels::Lanes<const float> columns{weights.values + run.first * kFloatLanes,
                                              weights.blocks, run.count, weights.stride};
    const float* const input = input_.data() + run.first;
    float* const to = runs_.size() > 1 ? of_run.data() : out;
    SimilarityScores(similarity, columns, rows).write({&input, 1}, {&to, 1});
    for (std::size_t row = 0; runs_.size() > 1 && row < rows; ++row) {
      out[row] =
          similarity == Similarity::kChebyshev ? std::max(out[row], to[row]) : out[row] + to[row];
    }
  }
}

// Of sums of positive terms, and of sums of these; see score_margin().
double KnownScores::margin(double least) const {
  std::size_t known = 0;
  for (const KnownRun& run : runs_) known += run.count;
  const auto roundings = static_cast<double>(known + runs_.size() + 4);
  return 2.5 * roundings * 0x1p-24 * least;
}

std::size_t KnownScores::winner(const Som& som, std::span<const float> scores) const {
  std::vector<float> known;
  for (const KnownRun& run : runs_) {
    const auto values = input_.subspan(run.first, run.count);
    known.insert(known.end(), values.begin(), values.end());
  }
  std::vector<float> row(input_.size());
  const auto least = double{*std::min_element(scores.begin(), scores.end())};
  const double limit = least + margin(least);
  BestTwo best;
  for (std::size_t neuron = 0; neuron < scores.size(); ++neuron) {
    if (double{scores[neuron]} > limit) continue;
    som.weights().copy_row(neuron, row);
    std::size_t place = 0;
    for (const KnownRun& run : runs_) {
      for (std::size_t d = run.first; d < run.first + run.count; ++d) row[place++] = row[d];
    }
    best.meet(exact_score(som.parameters().similarity, row.data(), known.data(), known.size()),
              neuron);
  }
  return best.winners().first;
}

}  // namespace somato
