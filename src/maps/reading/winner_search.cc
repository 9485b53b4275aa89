#include "maps/reading/winner_search.h"

#include <algorithm>

#include "base/core/threads.h"
#include "maps/reading/score_search.h"
#include "maps/reading/screening_run.h"
#include "somato/core/check.h"
#include "somato/maps/som_training.h"

namespace somato {

WinnerSearch::WinnerSearch(const Som& som, std::size_t threads) : som_(som), map_(som, threads) {}

bool WinnerSearch::pays(const Som& som, const Samples& samples) {
  constexpr std::size_t kFewNeurons = 32;
  constexpr std::size_t kFewSamples = 64;
  return follows_from_products(som.parameters()) && !samples.is_sparse() &&
         samples.count() >= kFewSamples && som.neurons() >= kFewNeurons;
}

std::vector<Winners> WinnerSearch::find_all(const Som& som, const Samples& seen, bool two,
                                            std::size_t threads, bool skip) {
  std::vector<Winners> found(seen.count());
  const SomParameters& parameters = som.parameters();
  if (parameters.layers.empty() && !follows_from_products(parameters)) {
    const ScoreSearch search(som);
    for_each_range(seen.count(), threads, [&](std::size_t begin, std::size_t end) {
      search.find(seen, begin, two, std::span(found).subspan(begin, end - begin));
    });
    return found;
  }
  if (pays(som, seen)) {
    const WinnerSearch search(som, threads);
    for_each_range(seen.count(), threads, [&](std::size_t begin, std::size_t end) {
      search.find(seen, begin, two, skip, std::span(found).subspan(begin, end - begin));
    });
    return found;
  }
  for_each_range(seen.count(), threads, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    AlignedVector<float> dense(seen.size());
    for (std::size_t i = begin; i < end; ++i) {
      write_dense(seen[i], dense);
      found[i] = som.best_of(dense, two, workspace);
    }
  });
  return found;
}

void WinnerSearch::find(const Samples& samples, std::size_t begin, bool two, bool skip,
                        std::span<Winners> found) const {
  if (map_.all_alike()) {
    std::fill(found.begin(), found.end(),
              Winners{0, som_.neurons() > 1 ? std::size_t{1} : std::size_t{0}});
    return;
  }
  ScreeningRun(som_, map_, samples, two, skip).find(begin, found);
}

const Samples& seen_samples(const Som& som, const Samples& samples, Samples& storage) {
  require(samples.size() == som.input_size(),
          "the samples' size differs from the map's input size");
  const Samples& prepared = prepared_samples(som.parameters(), samples, storage);
  // NOLINTNEXTLINE(bugprone-return-const-ref-from-parameter): the caller keeps both alive
  if (som.elements().all()) return prepared;
  storage = som.elements().gather(prepared);
  return storage;
}

std::vector<std::size_t> winners_of_seen(const Som& som, const Samples& seen, std::size_t threads) {
  std::vector<std::size_t> winners;
  winners.reserve(seen.count());
  for (const Winners& found : WinnerSearch::find_all(som, seen, false, threads)) {
    winners.push_back(found.first);
  }
  return winners;
}

}  // namespace somato
