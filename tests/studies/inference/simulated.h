#pragma once

#include <cstdint>

#include "somato/core/random.h"
#include "studies/inference/acceptance.h"

namespace somato::test {

/// The mean of four normal numbers with the deviation 1 is observed, and its prior is uniform from
/// -5 to 5: the posterior of an observation well inside is normal with its mean and the deviation
/// 0.5. A second unknown has no effect. `simulations` of each draw.
inline Simulations of_normal_mean(std::size_t draws, std::size_t simulations, std::uint64_t seed) {
  Random random(seed);
  const std::size_t count = draws * simulations;
  Simulations all{Matrix<double>(count, 2), Matrix<double>(count, 1), {}, {true, true}, {}};
  for (std::size_t draw = 0; draw < draws; ++draw) {
    const double place = random.uniform();
    const double other = random.uniform();
    for (std::size_t one = 0; one < simulations; ++one) {
      const std::size_t i = draw * simulations + one;
      all.places(i, 0) = place;
      all.places(i, 1) = other;
      all.statistics(i, 0) = 10.0 * place - 5.0 + 0.5 * random.normal();
      all.draw.push_back(draw);
    }
  }
  return all;
}

}  // namespace somato::test
