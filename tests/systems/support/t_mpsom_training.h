#pragma once

#include <cstdint>
#include <vector>

#include "somato/core/random.h"
#include "somato/core/signal.h"
#include "somato/maps/t_mpsom.h"

namespace somato::testing {

using TMpsomFrame = std::vector<Signal>;
using TMpsomExploration = std::vector<TMpsomFrame>;

/// Trains `map` on drawn explorations, frame by frame, for its number of iterations (P06 section
/// 4.2): one step after the other, as the formulas say.
inline void train_t_mpsom(TMpsom& map, const std::vector<TMpsomExploration>& explorations) {
  const TMpsomParameters& p = map.parameters();
  Random draws(p.seed, Stream::kDraws);
  TMpsom::Workspace workspace(map);
  const Schedule rate = p.learning_rate();
  std::uint64_t iteration = 0;
  while (iteration < p.iterations) {
    for (const TMpsomFrame& frame : explorations[draws.below(explorations.size())]) {
      if (iteration == p.iterations) return;
      std::vector<SignalView> inputs;
      for (const Signal& signal : frame) inputs.push_back(signal.view());
      map.learn(inputs, rate.at(iteration++), workspace);
    }
  }
}

}  // namespace somato::testing
