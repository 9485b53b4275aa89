#include "simulation/hand_explorers.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "somato/bodies/explore_by_grasping.h"
#include "somato/core/random.h"
#include "somato/simulation/hand_picture.h"
#include "somato/simulation/simulated_hand.h"

namespace somato::detail {
namespace {

class HandExplorer : public ThingExplorer {
 public:
  HandExplorer(std::vector<HandScene> scenes, ExploringParameters parameters, std::uint64_t seed)
      : scenes_(std::move(scenes)), parameters_(std::move(parameters)), seed_(seed) {}

  std::vector<std::string> things() const override {
    std::vector<std::string> names;
    names.reserve(scenes_.size());
    for (const HandScene& scene : scenes_) names.push_back(scene.object().name);
    return names;
  }

  Result<Exploration> explore(std::size_t thing, std::size_t trial,
                              const ExploreOptions& options) const override {
    auto hand = placed_hand(thing, trial);
    if (!hand) return fail(std::move(hand.error()));
    (*hand)->keep_to(options.limits);
    const auto draw = [&](std::size_t grasp) -> Result<void> {
      if (options.pictures == nullptr) return {};
      options.pictures->save(**hand, scenes_[thing].object().name, trial, grasp);
      return {};
    };
    auto exploration = grasp(**hand, draw);
    if (exploration) exploration->labels = labels_of(scenes_[thing].object(), trial);
    return exploration;
  }

 protected:
  virtual Result<Exploration> grasp(Body& hand, const AfterGrasp& after_grasp) const = 0;

  const ExploringParameters& parameters() const { return parameters_; }

 private:
  Result<std::unique_ptr<SimulatedHand>> placed_hand(std::size_t thing, std::size_t trial) const {
    Random random(seed_of(seed_, thing, trial, Draws::kPlacement));
    const Placement placement = draw_placement(parameters_.simulation, random);
    return SimulatedHand::create(scenes_[thing], placement,
                                 seed_of(seed_, thing, trial, Draws::kHand));
  }

  std::vector<HandScene> scenes_;
  ExploringParameters parameters_;
  std::uint64_t seed_;
};

class GraspingExplorer : public HandExplorer {
 public:
  using HandExplorer::HandExplorer;

 protected:
  Result<Exploration> grasp(Body& hand, const AfterGrasp& after_grasp) const override {
    return explore_by_grasping(hand, parameters().plan, parameters().grasp, after_grasp);
  }
};

class ClosingExplorer : public HandExplorer {
 public:
  using HandExplorer::HandExplorer;

 protected:
  Result<Exploration> grasp(Body& hand, const AfterGrasp& after_grasp) const override {
    auto exploration = explore_by_closing(hand, parameters().closing);
    if (!exploration) return exploration;
    if (auto drawn = after_grasp(0); !drawn) return fail(std::move(drawn.error()));
    return exploration;
  }
};

Result<std::vector<HandScene>> scenes_of(Hand hand, const std::vector<Object>& objects,
                                         const SimulationParameters& parameters) {
  if (objects.empty()) {
    return fail(ErrorKind::kUsage, "there are no objects for a hand", {},
                "add lines to the table [object]");
  }
  std::vector<HandScene> scenes;
  scenes.reserve(objects.size());
  for (const Object& object : objects) {
    auto scene = HandScene::build(hand, object, parameters);
    if (!scene) return fail(std::move(scene.error()));
    scenes.push_back(std::move(*scene));
  }
  return scenes;
}

// The plan must keep to the hand's limits, and the open hand must clear the object wherever it
// goes.
Result<void> check_poses(const HandScene& scene, const std::vector<GraspPose>& poses,
                         const GuardedGrasp& grasp) {
  auto hand = SimulatedHand::create(scene, {}, 0);
  if (!hand) return fail(std::move(hand.error()));
  for (const GraspPose& pose : poses) {
    const std::array<double, 8> open{pose.height,         pose.wrist_angle,    grasp.proximal_open,
                                     grasp.distal_open,   grasp.proximal_open, grasp.distal_open,
                                     grasp.proximal_open, grasp.distal_open};
    auto possible = (*hand)->command(open).and_then([&] { return (*hand)->check_clear(open); });
    if (!possible) return possible;
  }
  return {};
}

}  // namespace

Result<std::unique_ptr<ThingExplorer>> grasping_explorer(const ObjectTable& things,
                                                         const ExploringParameters& parameters,
                                                         std::uint64_t seed) {
  auto poses = grasp_poses(parameters.plan);
  if (!poses) return fail(std::move(poses.error()));
  auto scenes = scenes_of(Hand::kLucs2, things.objects, parameters.simulation);
  if (!scenes) return fail(std::move(scenes.error()));
  for (const HandScene& scene : *scenes) {
    if (auto clear = check_poses(scene, *poses, parameters.grasp); !clear)
      return fail(std::move(clear.error()));
  }
  return std::make_unique<GraspingExplorer>(std::move(*scenes), parameters, seed);
}

Result<std::unique_ptr<ThingExplorer>> closing_explorer(const ObjectTable& things,
                                                        const ExploringParameters& parameters,
                                                        std::uint64_t seed) {
  auto scenes = scenes_of(Hand::kLucs3, things.objects, parameters.simulation);
  if (!scenes) return fail(std::move(scenes.error()));
  for (const HandScene& scene : *scenes) {
    if (auto hand = SimulatedHand::create(scene, {}, 0); !hand)
      return fail(std::move(hand.error()));
  }
  return std::make_unique<ClosingExplorer>(std::move(*scenes), parameters, seed);
}

}  // namespace somato::detail
