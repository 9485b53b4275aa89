#include "bodies/physics/surface.h"

#include <cmath>
#include <string_view>

#include "base/core/elementary.h"
#include "somato/core/random.h"

namespace somato::detail {
namespace {

using Words = std::array<std::uint32_t, 4>;
using Key = std::array<std::uint32_t, 2>;

// The last word of a counter identifies the use of the numbers.
constexpr std::uint32_t kNodes = 0;
constexpr std::uint32_t kShifts = 1;
constexpr std::uint32_t kWeave = 2;
constexpr std::uint32_t kWorld = 3;

// Mean over a cell of the sum of squared weights of cubic B-splines.
constexpr double kSplineVariance = 151.0 / 315.0;

double fraction(std::uint32_t word) {
  return static_cast<double>(word) * 0x1p-32;
}

// FNV-1a.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return hash;
}

Key surface_key(std::string_view material, std::uint64_t world_seed) {
  const std::uint64_t hash = hash_of(material);
  const Words words = philox4x32(
      {static_cast<std::uint32_t>(hash), static_cast<std::uint32_t>(hash >> 32), 0, kWorld},
      {static_cast<std::uint32_t>(world_seed), static_cast<std::uint32_t>(world_seed >> 32)});
  return {words[0], words[1]};
}

// Nearly normal with mean 0 and variance 1: the sum of four uniform numbers.
double node_height(const Words& words) {
  const double sum =
      fraction(words[0]) + fraction(words[1]) + fraction(words[2]) + fraction(words[3]);
  return (sum - 2.0) * std::sqrt(3.0);
}

std::array<double, 4> spline_weights(double t) {
  const double u = 1.0 - t;
  const double t2 = t * t;
  return {u * u * u / 6.0, (3.0 * t2 * t - 6.0 * t2 + 4.0) / 6.0,
          (-3.0 * t2 * t + 3.0 * t2 + 3.0 * t + 1.0) / 6.0, t2 * t / 6.0};
}

}  // namespace

Surface::Surface(const Material& material, double finest, std::uint64_t world_seed)
    : key_(surface_key(material.name, world_seed)),
      correlation_length_(material.correlation_length),
      weave_period_(material.weave_period),
      weave_amplitude_(0.5 * material.weave_period >= finest ? 0.5 * material.weave_height : 0.0),
      weave_phase_(fraction(philox4x32({0, 0, 0, kWeave}, key_)[0])) {
  double refinement = 1.0;
  while (correlation_length_ / refinement >= finest) {
    lattices_.push_back(
        make_lattice(material, static_cast<std::uint32_t>(lattices_.size()), refinement));
    refinement *= 2.0;
  }
}

Surface::Lattice Surface::make_lattice(const Material& material, std::uint32_t number,
                                       double refinement) const {
  const Words words = philox4x32({0, 0, number, kShifts}, key_);
  const double first = std::sqrt(1.0 - power(2.0, -2.0 * material.hurst));
  Lattice lattice;
  lattice.refinement = refinement;
  lattice.amplitude = material.roughness * first * power(2.0, -material.hurst * number) /
                      kSplineVariance;  // its root, for each of two directions
  lattice.number = number;
  lattice.shift_x = fraction(words[0]);
  lattice.shift_y = fraction(words[1]);
  return lattice;
}

// Whether the cell has changed.
bool Surface::move(Position& position, double cells) {
  if (position.cells == cells) return false;
  const double below = std::floor(cells);
  const auto cell = static_cast<std::int64_t>(below);
  const bool is_new = position.cell != cell;
  position = {cells, cell, spline_weights(cells - below)};
  return is_new;
}

// Moves to a position in cells.
void Surface::visit(Lattice& lattice, double x, double y) const {
  const bool is_new_x = move(lattice.x, x);
  const bool is_new_y = move(lattice.y, y);
  if (!is_new_x && !is_new_y) return;
  for (std::size_t i = 0; i < 16; ++i) {
    const auto node_x =
        static_cast<std::uint32_t>(lattice.x.cell + static_cast<std::int64_t>(i % 4));
    const auto node_y =
        static_cast<std::uint32_t>(lattice.y.cell + static_cast<std::int64_t>(i / 4));
    lattice.nodes[i] = node_height(philox4x32({node_x, node_y, lattice.number, kNodes}, key_));
  }
}

// At a position in correlation lengths; its product with a power of two is exact.
double Surface::height_of(Lattice& lattice, double x, double y) const {
  visit(lattice, x * lattice.refinement + lattice.shift_x,
        y * lattice.refinement + lattice.shift_y);
  const std::array<double, 4>& along = lattice.x.weights;
  const std::array<double, 4>& across = lattice.y.weights;
  double sum = 0.0;
  for (std::size_t i = 0; i < 16; ++i) sum += along[i % 4] * across[i / 4] * lattice.nodes[i];
  return lattice.amplitude * sum;
}

double Surface::weave(double x) const {
  if (weave_period_ == 0.0) return 0.0;
  return weave_amplitude_ * cosine_of_turns(x / weave_period_ + weave_phase_);
}

double Surface::height(double x, double y) {
  double sum = weave(x);
  const double lengths_x = x / correlation_length_;
  const double lengths_y = y / correlation_length_;
  for (Lattice& lattice : lattices_) sum += height_of(lattice, lengths_x, lengths_y);
  return sum;
}

}  // namespace somato::detail
