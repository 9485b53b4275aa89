#include "somato/core/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/core/elementary.h"
#include "base/kernels/product_kernels.h"
#include "somato/core/check.h"

namespace somato {
namespace {

std::array<std::uint32_t, 2> key_of(std::uint64_t seed) {
  return {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
}

}  // namespace

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t first = std::uint64_t{0xD2511F53U} * counter[0];
    const std::uint64_t second = std::uint64_t{0xCD9E8D57U} * counter[2];
    counter = {static_cast<std::uint32_t>(second >> 32) ^ counter[1] ^ key[0],
               static_cast<std::uint32_t>(second),
               static_cast<std::uint32_t>(first >> 32) ^ counter[3] ^ key[1],
               static_cast<std::uint32_t>(first)};
    key[0] += 0x9E3779B9U;
    key[1] += 0xBB67AE85U;
  }
  return counter;
}

Random::Random(std::uint64_t seed, Stream stream)
    : key_(key_of(seed)), stream_(static_cast<std::uint32_t>(stream)) {}

std::uint32_t Random::next() {
  if (used_ == words_.size()) {
    words_ = philox4x32({static_cast<std::uint32_t>(counter_),
                         static_cast<std::uint32_t>(counter_ >> 32), stream_, 0},
                        key_);
    ++counter_;
    used_ = 0;
  }
  return words_[used_++];
}

std::uint64_t Random::next64() {
  const std::uint64_t low = next();
  return low | (std::uint64_t{next()} << 32);
}

double Random::uniform() {
  return static_cast<double>(next64() >> 11) * 0x1p-53;
}

std::uint64_t Random::below(std::uint64_t bound) {
  require(bound > 0, "Random::below needs a bound of at least 1");
  const std::uint64_t rejected = (0 - bound) % bound;  // 2^64 modulo bound
  std::uint64_t word = next64();
  while (word < rejected) word = next64();
  return word % bound;
}

double Random::normal() {
  if (has_spare_normal_) {
    has_spare_normal_ = false;
    return spare_normal_;
  }
  double x = 0.0;
  double y = 0.0;
  double square = 0.0;
  do {
    x = 2.0 * uniform() - 1.0;
    y = 2.0 * uniform() - 1.0;
    square = x * x + y * y;
  } while (square >= 1.0 || square == 0.0);
  const double factor = std::sqrt(-2.0 * natural_log(square) / square);
  spare_normal_ = y * factor;
  has_spare_normal_ = true;
  return x * factor;
}

namespace {

// The four numbers of columns 4 quarter .. 4 quarter + 3 of a row.
std::array<float, 4> four_uniform(std::uint64_t seed, Stream stream, std::uint32_t row,
                                  std::uint32_t quarter) {
  const auto words =
      philox4x32({quarter, row, static_cast<std::uint32_t>(stream), 1}, key_of(seed));
  std::array<float, 4> numbers{};
  for (std::size_t i = 0; i < 4; ++i) numbers[i] = static_cast<float>(words[i] >> 8) * 0x1p-24F;
  return numbers;
}

}  // namespace

std::vector<std::size_t> random_order(std::size_t count, Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  shuffle(order, random);
  return order;
}

float uniform_at(std::uint64_t seed, Stream stream, std::uint32_t row, std::uint32_t column) {
  return four_uniform(seed, stream, row, column / 4)[column % 4];
}

void uniform_row(std::uint64_t seed, Stream stream, std::uint32_t row, std::span<float> out) {
  const auto [low, high] = key_of(seed);
  const std::size_t quarters = out.size() / 4;
  kernels::product_table().uniform_row({{low, high}, static_cast<std::uint32_t>(stream), row}, 0,
                                       quarters, out.data());
  for (std::size_t i = 4 * quarters; i < out.size(); ++i) {
    out[i] = uniform_at(seed, stream, row, static_cast<std::uint32_t>(i));
  }
}

void uniform_row(std::uint64_t seed, Stream stream, std::uint32_t row,
                 std::span<const std::uint32_t> columns, std::span<float> out) {
  require(columns.size() == out.size(), "uniform_row needs space for one number per column");
  std::array<float, 4> numbers{};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::uint32_t quarter = columns[i] / 4;
    const bool there = i > 0 && columns[i - 1] / 4 == quarter;
    if (!there) numbers = four_uniform(seed, stream, row, quarter);
    out[i] = numbers[columns[i] % 4];
  }
}

}  // namespace somato
