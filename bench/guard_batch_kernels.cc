// The kernels of batch_kernels.h.

#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "base/kernels/batch_kernels.h"
#include "guard.h"

namespace somato::bench {
namespace {

using kernels::kBlockNeurons;
using kernels::kTileSamples;

static_assert(kKernels<kernels::BatchTable> == 13, "count each of them");

constexpr std::size_t kBlocks = 27;
constexpr std::size_t kPairs = 32;
constexpr float kScale = 1e-8F;  // of an integer product

AlignedVector<std::int16_t> integers(std::size_t count, std::uint64_t seed) {
  constexpr std::uint64_t kLimit = 4000;
  Random random(seed);
  AlignedVector<std::int16_t> values(count);
  for (std::int16_t& value : values) {
    value = static_cast<std::int16_t>(static_cast<std::int64_t>(random.below(2 * kLimit + 1)) -
                                      static_cast<std::int64_t>(kLimit));
  }
  return values;
}

using Tile = std::array<kernels::Candidates, kTileSamples>;

Tile fresh() {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  constexpr float kMargin = 0.1F;
  Tile tile{};
  tile.fill({kInfinite, kMargin, kInfinite, kInfinite, 0, false, {}});
  return tile;
}

std::uint64_t digest_of_candidates(const Tile& tile) {
  std::uint64_t digest = 1;
  for (const kernels::Candidates& one : tile) {
    digest = digest_of(std::array{one.threshold, one.least, one.second_least}, digest);
    for (std::uint32_t k = 0; k < one.count; ++k) {
      digest = digest_with(digest_with(digest, double{one.kept[k].score}), one.kept[k].place);
    }
  }
  return digest;
}

void count_scores(const Counted& counted) {
  const auto& table = kernels::batch_table();
  const auto values = integers(kBlocks * kPairs * 2 * kBlockNeurons, 21);
  const auto rows = integers(kTileSamples * 2 * kPairs, 22);
  const auto offsets = noise<float>(kBlocks * kBlockNeurons, 23);
  const std::vector<float> factors(kTileSamples, kScale);
  const kernels::ScreenedNeurons neurons{values.data(), offsets.data(), kPairs};
  std::vector<std::uint32_t> blocks(kBlocks);
  std::iota(blocks.begin(), blocks.end(), 0U);
  Tile candidates = fresh();
  const kernels::ScreenedTile tile{rows.data(), factors.data(), candidates.data(), false};
  counted(
      "batch.screen", [&] { table.screen(neurons, blocks.data(), blocks.size(), tile); },
      [&] { return digest_of_candidates(candidates); });
  AlignedVector<float> scores(kTileSamples * kBlocks * kBlockNeurons);
  counted(
      "batch.score", [&] { table.score(neurons, kBlocks, tile, scores.data()); },
      [&] { return digest_of(scores); });
}

void count_searches(const Counted& counted) {
  const auto& table = kernels::batch_table();
  constexpr std::size_t kLines = 64;
  const auto values = noise<float>(kLines * kBlockNeurons, 24);
  float least = 0.0F;
  counted(
      "batch.least", [&] { least = table.least(values.data(), kLines); },
      [&] { return digest_with(1, double{least}); });
  std::vector<std::uint32_t> places(values.size());
  std::size_t found = 0;
  counted(
      "batch.places_up_to",
      [&] { found = table.places_up_to(values.data(), kLines, 0.1F, places.data()); },
      [&] { return digest_of(places, found); });
  const auto radii = noise<float>(values.size(), 28);
  std::vector<std::int32_t> marks(values.size());
  counted(
      "batch.mark_near",
      [&] {
        table.mark_near(values.data(), radii.data(), values.size(), 0.5F, 0.1F, marks.data());
      },
      [&] { return digest_of(marks); });
}

void count_vectors(const Counted& counted) {
  const auto& table = kernels::batch_table();
  constexpr std::size_t kLength = 1003;
  const auto a = noise<float>(kLength, 25);
  const auto b = noise<float>(kLength, 26);
  std::vector<std::int16_t> rounded(kLength);
  double sum = 0.0;
  const Digest of_sum = [&] { return digest_with(1, sum); };
  counted(
      "batch.to_integers",
      [&] {
        sum = double{table.to_integers(a.data(), b.data(), 30000.0F, kLength, rounded.data())};
      },
      [&] { return digest_of(rounded, of_sum()); });
  // A length in single precision is promised within bounds, not to the bit: who uses it adds them
  // to a margin.
  counted(
      "batch.squared_length",
      [&] { sum = double{table.squared_length(a.data(), b.data(), kLength)}; }, [] { return 0; });
  counted(
      "batch.squared_distance", [&] { sum = table.squared_distance(a.data(), b.data(), kLength); },
      of_sum);
  counted(
      "batch.inner_product", [&] { sum = table.inner_product(a.data(), b.data(), kLength); },
      of_sum);
  counted(
      "batch.absolute_distance",
      [&] { sum = table.absolute_distance(a.data(), b.data(), kLength); }, of_sum);
  counted(
      "batch.greatest_difference",
      [&] { sum = table.greatest_difference(a.data(), b.data(), kLength); }, of_sum);
}

void count_means(const Counted& counted) {
  const auto& table = kernels::batch_table();
  constexpr std::size_t kLanes = 8;
  constexpr std::size_t kSamples = 200;
  constexpr std::size_t kStride = 64;
  constexpr std::size_t kPlaces = 40;
  constexpr std::size_t kOutputs = 43;
  const auto values = noise<float>(kSamples * kStride, 27);
  std::vector<std::size_t> winners(kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) winners[i] = i * i % kPlaces;
  const AlignedVector<double> scales(kLanes, 0x1p40);
  AlignedVector<std::int64_t> sums(kPlaces * kLanes);
  counted(
      "batch.add_by_winner",
      [&] {
        table.add_by_winner(values.data(), kStride, scales.data(), winners.data(), kSamples,
                            sums.data());
      },
      [&] { return digest_of(sums); });
  const auto factors = noise<double>(kOutputs * kPlaces, 28);
  const auto in = noise<double>(kPlaces * kLanes, 29);
  AlignedVector<double> out(kOutputs * kLanes);
  counted(
      "batch.mix", [&] { table.mix(factors.data(), in.data(), kPlaces, out.data(), kOutputs); },
      [&] { return digest_of(out); });
}

}  // namespace

void count_batch_kernels(const Counted& counted) {
  count_scores(counted);
  count_searches(counted);
  count_vectors(counted);
  count_means(counted);
}

}  // namespace somato::bench
