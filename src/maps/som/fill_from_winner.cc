#include "maps/som/fill_from_winner.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "base/core/lanes.h"
#include "base/core/threads.h"
#include "maps/reading/known_elements.h"
#include "somato/core/check.h"
#include "somato/core/matrix.h"

namespace somato {
namespace {

std::size_t winner_by_known(const Som& som, std::span<const float> sample,
                            std::span<float> scores) {
  std::vector<float> seen(sample.begin(), sample.end());
  scale_elements(som.input_scales(), seen);
  const std::vector<KnownRun> runs = known_runs(seen);
  const KnownScores known(som.parameters(), seen, runs);
  known.write(kernels::lanes(som.weights()), som.neurons(), scores.data());
  return known.winner(som, scores.first(som.neurons()));
}

void fill_from_winner(const Som& som, std::span<float> sample, std::span<float> scores) {
  const auto is_missing = [](float value) { return std::isnan(value); };
  if (std::none_of(sample.begin(), sample.end(), is_missing)) return;
  const std::size_t winner = winner_by_known(som, sample, scores);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (std::isnan(sample[i])) sample[i] = som.weight(winner, i);
  }
}

}  // namespace

bool has_missing(const Samples& samples) {
  if (samples.is_sparse()) return false;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    if (std::ranges::any_of(samples[i].values, [](float value) { return std::isnan(value); })) {
      return true;
    }
  }
  return false;
}

Result<void> check_takes_incomplete(const Som& som) {
  const SomParameters& parameters = som.parameters();
  const auto by_cosine = [](const Layer& layer) { return layer.similarity == Similarity::kCosine; };
  const bool by_elements =
      parameters.similarity != Similarity::kDotProduct &&
      parameters.similarity != Similarity::kCosine &&
      std::none_of(parameters.layers.begin(), parameters.layers.end(), by_cosine);
  if (by_elements && !parameters.normalize_input.value_or(false)) return {};
  return fail(ErrorKind::kUsage,
              by_elements
                  ? "the map scales rows to length 1, which missing values leave unknown"
                  : "the map compares by inner products, which missing values leave unknown",
              {}, "use the means of the columns");
}

Samples filled_from_winners(const Som& som, const Samples& samples) {
  require(samples.size() == som.input_size(), "samples have as many elements as the map's inputs");
  Som whole = som.elements().all() ? Som() : som;
  whole.store_all();
  const Som& searched = som.elements().all() ? som : whole;
  Matrix<float> rows(samples.count(), samples.size());
  AlignedVector<float> scores(searched.weights().padded_rows());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    write_dense(samples[i], rows.row(i));
    fill_from_winner(searched, rows.row(i), scores);
  }
  return Samples(std::move(rows));
}

std::vector<std::size_t> winners_by_known(const Som& som, const Samples& samples,
                                          std::size_t threads) {
  std::vector<std::size_t> winners(samples.count());
  for_each_range(winners.size(), threads, [&](std::size_t begin, std::size_t end) {
    AlignedVector<float> scores(som.weights().padded_rows());
    for (std::size_t i = begin; i < end; ++i) {
      winners[i] = winner_by_known(som, samples[i].values, scores);
    }
  });
  return winners;
}

}  // namespace somato
