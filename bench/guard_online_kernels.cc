// The kernels of online_kernels.h.

#include <cstdint>
#include <vector>

#include "core/kernels.h"
#include "core/online_kernels.h"
#include "guard.h"

namespace somato::bench {
namespace {

using kernels::kPending;

static_assert(kKernels<kernels::OnlineTable> == 5, "count each of them");

constexpr std::size_t kLanes = LaneMatrix<float>::kLanes;
constexpr std::size_t kColumns = 250;
constexpr std::size_t kSome = 7;  // inputs that are not as many as registers

void count_tiles(const Counted& counted) {
  const auto& table = kernels::online_table();
  const auto tile = noise<float>(kColumns * kLanes, 31);
  const auto inputs = noise<float>(kColumns * kPending, 32);
  AlignedVector<float> sums(kPending * kLanes);
  counted(
      "online.multiply",
      [&] {
        table.multiply(tile.data(), kColumns, inputs.data(), kPending, sums.data(), kLanes);
        table.multiply(tile.data(), kColumns, inputs.data(), kSome, sums.data(), kLanes);
      },
      [&] { return digest_of(sums); });
  const auto kept = noise<float>(kLanes, 33);
  const auto gains = noise<float>(kPending * kLanes, 34);
  AlignedVector<float> to(tile.size());
  AlignedVector<float> squares(kLanes);
  const auto combine = [&](const AlignedVector<float>& from, std::size_t count) {
    table.combine(from.data(), kColumns, kept.data(), gains.data(), inputs.data(), count,
                  kernels::kNegligible<float>, to.data(), squares.data());
  };
  counted(
      "online.combine",
      [&] {
        combine(tile, kPending);
        combine(to, kSome);
      },
      [&] { return digest_of(to, digest_of(squares)); });
}

void count_blocks(const Counted& counted) {
  constexpr std::size_t kBlocks = 7;
  constexpr std::size_t kChunkOfColumns = 64;
  const auto weights = noise<float>(kBlocks * kColumns * kLanes, 35);
  const auto input = noise<float>(kColumns, 36);
  std::vector<const float*> blocks(kBlocks);
  for (std::size_t i = 0; i < kBlocks; ++i) blocks[i] = weights.data() + i * kColumns * kLanes;
  AlignedVector<float> sums(kBlocks * kLanes);
  counted(
      "online.multiply_blocks",
      [&] {
        kernels::online_table().multiply_blocks(blocks.data(), kBlocks, kColumns, kChunkOfColumns,
                                                input.data(), sums.data());
      },
      [&] { return digest_of(sums); });
}

void count_rows(const Counted& counted) {
  const auto& table = kernels::online_table();
  constexpr std::size_t kNeurons = 1003;
  auto row = noise<float>(kNeurons, 37);
  const auto factors = noise<float>(kNeurons, 38);
  AlignedVector<double> squares(kNeurons);
  const Digest bits = [&] { return digest_of(row, digest_of(squares)); };
  counted(
      "online.move_row",
      [&] { table.move_row(row.data(), 0.7F, factors.data(), kNeurons, squares.data()); }, bits);
  counted(
      "online.fold_row",
      [&] { table.fold_row(row.data(), factors.data(), kNeurons, squares.data()); }, bits);
}

}  // namespace

void count_online_kernels(const Counted& counted) {
  count_tiles(counted);
  count_blocks(counted);
  count_rows(counted);
}

}  // namespace somato::bench
