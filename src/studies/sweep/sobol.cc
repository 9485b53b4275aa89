#include "studies/sweep/sobol.h"

#include <array>
#include <bit>

#include "somato/core/check.h"

namespace somato {
namespace {

constexpr unsigned kBits = 32;

// A line of new-joe-kuo-6: a primitive polynomial over GF(2) of that degree, its coefficients
// without the first and the last, and as many initial numbers.
struct SobolLine {
  unsigned degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 7> initial;
};

// For dimensions 2, 3, and so on.
constexpr std::array<SobolLine, kSobolDimensions - 1> kSobolLines{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
    {7, 7, {1, 1, 3, 13, 7, 35, 63}},
    {7, 8, {1, 3, 5, 9, 1, 25, 53}},
    {7, 14, {1, 3, 1, 13, 9, 35, 107}},
    {7, 19, {1, 3, 1, 5, 27, 61, 31}},
    {7, 21, {1, 1, 5, 11, 19, 41, 61}},
    {7, 28, {1, 3, 5, 3, 3, 13, 69}},
    {7, 31, {1, 1, 7, 13, 1, 19, 1}},
    {7, 32, {1, 3, 7, 5, 13, 19, 59}},
    {7, 37, {1, 1, 3, 9, 25, 29, 41}},
    {7, 41, {1, 3, 5, 13, 23, 1, 55}},
    {7, 42, {1, 3, 7, 3, 13, 59, 17}},
}};

// Direction number k belongs to bit k of the point's number, the lowest first.
using Directions = std::array<std::uint32_t, kBits>;

Directions van_der_corput() {
  Directions directions{};
  for (unsigned k = 0; k < kBits; ++k) directions[k] = std::uint32_t{1} << (kBits - 1 - k);
  return directions;
}

Directions directions_of(const SobolLine& line) {
  const unsigned degree = line.degree;
  Directions directions{};
  for (unsigned k = 0; k < degree; ++k) directions[k] = line.initial[k] << (kBits - 1 - k);
  for (unsigned k = degree; k < kBits; ++k) {
    directions[k] = directions[k - degree] ^ (directions[k - degree] >> degree);
    for (unsigned j = 1; j < degree; ++j) {
      if ((line.coefficients >> (degree - 1 - j)) & 1U) directions[k] ^= directions[k - j];
    }
  }
  return directions;
}

const std::vector<Directions>& all_directions() {
  static const std::vector<Directions> all = [] {
    std::vector<Directions> made{van_der_corput()};
    for (const SobolLine& line : kSobolLines) made.push_back(directions_of(line));
    return made;
  }();
  return all;
}

}  // namespace

std::vector<double> sobol_point(std::uint32_t index, std::size_t dimensions) {
  require(dimensions <= kSobolDimensions, "Sobol' points support at most 32 dimensions");
  std::vector<double> point;
  point.reserve(dimensions);
  for (std::size_t d = 0; d < dimensions; ++d) {
    std::uint32_t bits = 0;
    for (std::uint32_t left = index; left != 0; left &= left - 1) {
      bits ^= all_directions()[d][static_cast<std::size_t>(std::countr_zero(left))];
    }
    point.push_back(bits * 0x1p-32);
  }
  return point;
}

}  // namespace somato
