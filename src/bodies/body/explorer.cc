#include "somato/bodies/explorer.h"

#include <fmt/format.h>

#include "somato/core/check.h"

namespace somato {

std::vector<Label> Explorer::labels(std::size_t thing, std::size_t trial) const {
  const ExploredThing& explored = things_.at(thing);
  if (explored.object) return labels_of(*explored.object, trial);
  if (!explored.material.name.empty()) return labels_of(explored.material, trial);
  return {{"object", explored.name}, {"trial", fmt::format("{}", trial + 1)}};
}

Result<Exploration> Explorer::explore(std::size_t thing, std::size_t trial,
                                      const ExploreOptions& options) {
  require(thing < things_.size(), "Explorer::explore: no such thing");
  return named(thing, explore_thing(thing, trial, options));
}

Result<Exploration> Explorer::named(std::size_t thing, Result<Exploration> explored) const {
  if (explored) {
    explored->source = source_;
  } else if (explored.error().where.empty()) {
    explored.error().where = things_[thing].name;
  }
  return explored;
}

Result<Exploration> SimulatedExplorer::explore(std::size_t thing, std::size_t trial,
                                               const ExploreOptions& options) const {
  require(thing < things().size(), "Explorer::explore: no such thing");
  return named(thing, simulate(thing, trial, options));
}

Result<void> prepare_body(Body& body, const ExploreOptions& options,
                          const std::function<Scene()>& scene,
                          std::function<std::vector<ScenePose>()> poses) {
  body.keep_to(options.limits);
  const ExplorationObserver& observer = options.observer;
  if (observer.on_step) {
    body.observe([&body, &observer, poses = std::move(poses)](Readings readings) {
      return observer.on_step({body.state(), poses(), readings});
    });
  }
  return observer.on_begin ? observer.on_begin(body.description(), scene()) : Result<void>();
}

}  // namespace somato
