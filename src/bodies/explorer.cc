#include "somato/bodies/explorer.h"

#include "somato/core/check.h"

namespace somato {

std::vector<Label> Explorer::labels(std::size_t thing, std::size_t trial) const {
  const ExploredThing& explored = things_.at(thing);
  return explored.object ? labels_of(*explored.object, trial) : labels_of(explored.material, trial);
}

Result<Exploration> Explorer::explore(std::size_t thing, std::size_t trial,
                                      const ExploreOptions& options) const {
  require(thing < things_.size(), "Explorer::explore: no such thing");
  auto exploration = explore_thing(thing, trial, options);
  if (exploration) {
    exploration->source = source_;
  } else if (exploration.error().where.empty()) {
    exploration.error().where = things_[thing].name;
  }
  return exploration;
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
