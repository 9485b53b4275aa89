// The kernels of online_kernels.h.

#include <cstdint>
#include <vector>

#include "base/kernels/kernels.h"
#include "base/kernels/online_kernels.h"
#include "guard.h"

namespace somato::bench {
namespace {

using kernels::kPending;

static_assert(kKernels<kernels::OnlineTable> == 13, "count each of them");

constexpr std::size_t kLanes = LaneMatrix<float>::kLanes;
constexpr std::size_t kColumns = 250;
constexpr std::size_t kStride = 17 * kLanes;
constexpr std::size_t kSome = 7;  // inputs that are not as many as registers

AlignedVector<std::int16_t> noise_of_integers(std::size_t count, std::uint64_t seed) {
  constexpr float kGreatest = 30000.0F;
  const auto values = noise<float>(count, seed);
  AlignedVector<std::int16_t> integers(count);
  for (std::size_t i = 0; i < count; ++i) {
    integers[i] = static_cast<std::int16_t>(kGreatest * values[i]);
  }
  return integers;
}

void count_tiles(const Counted& counted) {
  const auto& table = kernels::online_table();
  const auto tile = noise<float>(kColumns * kLanes, 31);
  const auto values = noise<float>(kStride * kPending, 32);
  const kernels::InputRows inputs{values.data(), kStride};
  AlignedVector<float> sums(kPending * kLanes);
  counted(
      "online.multiply",
      [&] {
        table.multiply(tile.data(), kColumns, inputs, kPending, sums.data(), kLanes);
        table.multiply(tile.data(), kColumns, inputs, kSome, sums.data(), kLanes);
      },
      [&] { return digest_of(sums); });
  const auto integers = noise_of_integers(kColumns * kLanes, 41);
  counted(
      "online.multiply_integers",
      [&] {
        table.multiply_integers(integers.data(), kColumns, inputs, kPending, sums.data(), kLanes);
        table.multiply_integers(integers.data(), kColumns, inputs, kSome, sums.data(), kLanes);
      },
      [&] { return digest_of(sums); });
  const auto kept = noise<float>(kLanes, 33);
  const auto gains = noise<float>(kPending * kLanes, 34);
  AlignedVector<float> to(tile.size());
  AlignedVector<float> squares(kLanes);
  const auto combine = [&](const AlignedVector<float>& from, std::size_t count) {
    table.combine(from.data(), kColumns, kept.data(), gains.data(), inputs, count,
                  kernels::kNegligible<float>, to.data(), squares.data());
  };
  counted(
      "online.combine",
      [&] {
        combine(tile, kPending);
        combine(to, kSome);
      },
      [&] { return digest_of(to, digest_of(squares)); });
  constexpr std::size_t kPadded = 16 * kLanes;
  counted(
      "online.combine_row",
      [&] {
        table.combine_row(to.data(), kPadded, kept[0], gains.data(), inputs, kPending,
                          kernels::kNegligible<float>);
      },
      [&] { return digest_of(to); });
}

void count_block(const Counted& counted) {
  constexpr std::size_t kChunkOfColumns = 24;
  const auto tile = noise<float>(kColumns * kLanes, 35);
  const auto input = noise<float>(kColumns, 36);
  AlignedVector<float> sums(kLanes);
  counted(
      "online.multiply_block",
      [&] {
        kernels::online_table().multiply_block(tile.data(), kColumns, kChunkOfColumns, input.data(),
                                               sums.data());
      },
      [&] { return digest_of(sums); });
}

void count_integers(const Counted& counted) {
  constexpr std::size_t kChunkOfColumns = 24;
  const auto& table = kernels::online_table();
  const auto integers = noise_of_integers(kColumns * kLanes, 42);
  const auto input = noise<float>(kColumns, 36);
  AlignedVector<float> sums(kLanes);
  counted(
      "online.multiply_block_of_integers",
      [&] {
        table.multiply_block_of_integers(integers.data(), kColumns, kChunkOfColumns, input.data(),
                                         sums.data());
      },
      [&] { return digest_of(sums); });
  const auto tile = noise<float>(kColumns * kLanes, 43);
  const AlignedVector<float> factors(kLanes, 30000.0F);
  AlignedVector<std::int16_t> to(tile.size());
  AlignedVector<float> greatest(kLanes);
  counted(
      "online.round_tile",
      [&] { table.round_tile(tile.data(), kColumns, factors.data(), to.data(), greatest.data()); },
      [&] { return digest_of(to, digest_of(greatest)); });
}

void count_rows(const Counted& counted) {
  const auto& table = kernels::online_table();
  constexpr std::size_t kNeurons = 63 * kLanes;
  constexpr std::size_t kRows = 5;
  auto values = noise<float>(kRows * kNeurons, 37);
  std::vector<float*> rows(kRows);
  for (std::size_t i = 0; i < kRows; ++i) rows[i] = values.data() + i * kNeurons;
  AlignedVector<float> products(kRows);
  counted(
      "online.multiply_rows",
      [&] {
        table.multiply_rows({rows[0], kNeurons}, kRows, rows[1], kNeurons, kColumns,
                            products.data());
      },
      [&] { return digest_of(products); });
  counted(
      "online.multiply_long_rows",
      [&] {
        table.multiply_long_rows({rows[0], kNeurons}, kRows, rows[1], kNeurons, products.data());
      },
      [&] { return digest_of(products); });
  const auto factors = noise<float>(kNeurons, 38);
  const auto scales = noise<double>(kNeurons, 39);
  AlignedVector<double> sums(kNeurons);
  AlignedVector<float> to(kNeurons);
  const Digest bits = [&] { return digest_of(values, digest_of(sums, digest_of(to))); };
  counted(
      "online.add_rows",
      [&] { table.add_rows(rows.data(), factors.data(), kRows, kNeurons, sums.data()); }, bits);
  counted(
      "online.move_rows",
      [&] {
        table.move_rows(rows.data(), factors.data(), kRows, factors.data(), kNeurons, sums.data());
      },
      bits);
  counted(
      "online.fold_row", [&] { table.fold_row(rows[0], factors.data(), kNeurons, sums.data()); },
      bits);
  counted(
      "online.scale_row",
      [&] { table.scale_row(rows[0], scales.data(), kNeurons, to.data(), kLanes); }, bits);
}

}  // namespace

void count_online_kernels(const Counted& counted) {
  count_tiles(counted);
  count_block(counted);
  count_integers(counted);
  count_rows(counted);
}

}  // namespace somato::bench
