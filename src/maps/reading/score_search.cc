#include "maps/reading/score_search.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "base/core/lanes.h"

namespace somato {
namespace {

// Samples whose scores are kept, and vectors of weights that stay in the first cache.
constexpr std::size_t kSamplesTogether = 32;
constexpr std::size_t kVectorsTogether = 256;

}  // namespace

ScoreSearch::ScoreSearch(const Som& som)
    : som_(som),
      scores_(som.parameters().similarity, kernels::lanes(som.weights()), som.neurons()) {}

void ScoreSearch::find(const Samples& seen, std::size_t begin, bool two,
                       std::span<Winners> found) const {
  const std::size_t padded = som_.weights().padded_rows();
  const std::size_t blocks = som_.weights().blocks();
  const std::size_t together =
      std::max<std::size_t>(1, kVectorsTogether / std::max<std::size_t>(1, seen.size()));
  AlignedVector<float> scores(kSamplesTogether * padded, std::numeric_limits<float>::infinity());
  std::vector<float> dense(seen.is_sparse() ? kSamplesTogether * seen.size() : 0);
  SomWorkspace workspace;
  for (std::size_t first = 0; first < found.size(); first += kSamplesTogether) {
    const std::size_t count = std::min(kSamplesTogether, found.size() - first);
    const float* inputs[kSamplesTogether] = {};
    float* out[kSamplesTogether] = {};
    for (std::size_t i = 0; i < count; ++i) {
      const SignalView sample = seen[begin + first + i];
      const std::span row = seen.is_sparse()
                                ? std::span(dense).subspan(i * seen.size(), seen.size())
                                : std::span<float>();
      if (seen.is_sparse()) write_dense(sample, row);
      inputs[i] = seen.is_sparse() ? row.data() : sample.values.data();
      out[i] = scores.data() + i * padded;
    }
    for (std::size_t block = 0; block < blocks; block += together) {
      scores_.write({inputs, count}, {out, count}, block, std::min(together, blocks - block));
    }
    for (std::size_t i = 0; i < count; ++i) {
      std::fill(out[i] + som_.neurons(), out[i] + padded, std::numeric_limits<float>::infinity());
      found[first + i] = som_.decide({out[i], padded}, {inputs[i], seen.size()}, two, workspace);
    }
  }
}

}  // namespace somato
