#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "somato/simulation/explorer.h"

namespace somato::detail {

/// What stands behind an Explorer: one way to explore things. Constant, so that threads may share
/// it.
class ThingExplorer {
 public:
  ThingExplorer() = default;
  ThingExplorer(const ThingExplorer&) = delete;
  ThingExplorer(ThingExplorer&&) = delete;
  ThingExplorer& operator=(const ThingExplorer&) = delete;
  ThingExplorer& operator=(ThingExplorer&&) = delete;
  virtual ~ThingExplorer() = default;

  virtual std::vector<std::string> things() const = 0;
  virtual Result<Exploration> explore(std::size_t thing, std::size_t trial,
                                      const ExploreOptions& options) const = 0;
};

/// What is drawn at random in an exploration.
enum class Draws : std::uint32_t { kPlacement, kHand, kTexture, kHardness };

/// The seed of these draws in one exploration; far apart from all others.
std::uint64_t seed_of(std::uint64_t seed, std::size_t thing, std::size_t trial, Draws draws);

}  // namespace somato::detail
