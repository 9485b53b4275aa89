#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace somato {

/// Philox4x32-10, a counter-based generator: ten rounds that turn a counter and a key into four
/// random words. Source: Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3",
/// SC 2011.
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key);

/// The purpose of a stream of random numbers; different streams of one seed are independent.
enum class Stream : std::uint32_t {
  kInitialWeights = 0,
  kDraws = 1,
  kGroupings = 2,
  kNoise = 3,
  kSizeOrder = 4,
  kDesign = 5,
  kAlterations = 6,
  kTextureProbe = 20,
  kHardnessProbe = 21,
  kServoPlay = 103,
  kHandSensors = 104,
  kUser = 1000,  ///< Values from here on are available to programs that use the library.
};

/// A sequence of random numbers. A seed and a stream determine the same numbers on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed, Stream stream = Stream::kUser);

  std::uint32_t next();

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform();

  /// Uniform in 0 .. bound-1 without bias; throws InvalidArgument when `bound` is 0.
  std::uint64_t below(std::uint64_t bound);

  /// Normal with mean 0 and standard deviation 1 (Marsaglia's polar method).
  double normal();

 private:
  std::uint64_t next64();

  std::array<std::uint32_t, 2> key_;
  std::uint32_t stream_;
  std::uint64_t counter_ = 0;
  std::array<std::uint32_t, 4> words_{};
  unsigned used_ = 4;
  double spare_normal_ = 0.0;
  bool has_spare_normal_ = false;
};

/// Puts the values into a random order (Fisher and Yates), each order with the same probability.
template <typename Value>
void shuffle(std::vector<Value>& values, Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
}

/// The numbers 0 .. count-1 in a random order.
std::vector<std::size_t> random_order(std::size_t count, Random& random);

/// The number at a position, which need not be stored: uniform in [0, 1), a multiple of 2^-24, for
/// this seed, stream, row and column. The order of calls has no effect.
float uniform_at(std::uint64_t seed, Stream stream, std::uint32_t row, std::uint32_t column);

/// Numbers of uniform_at() for one row and columns 0 .. out.size()-1; faster.
void uniform_row(std::uint64_t seed, Stream stream, std::uint32_t row, std::span<float> out);

/// Numbers of uniform_at() for one row and the given columns; faster for consecutive columns.
/// Throws InvalidArgument if the sizes differ.
void uniform_row(std::uint64_t seed, Stream stream, std::uint32_t row,
                 std::span<const std::uint32_t> columns, std::span<float> out);

}  // namespace somato
