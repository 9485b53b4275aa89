#include "bodies/explorers/hand_explorers.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "bodies/body/exploration_plan.h"
#include "bodies/hands/hand_picture.h"
#include "bodies/hands/hand_poses.h"
#include "somato/bodies/explore_by.h"

namespace somato::detail {
namespace {

std::vector<ExploredThing> objects_of(const std::vector<HandScene>& scenes) {
  std::vector<ExploredThing> things;
  things.reserve(scenes.size());
  for (const HandScene& scene : scenes) {
    things.push_back({scene.object().name, scene.object(), scene.object().material});
  }
  return things;
}

class HandExplorer : public SimulatedExplorer {
 public:
  HandExplorer(Hand hand, std::vector<HandScene> scenes, ExplorerSetup setup)
      : SimulatedExplorer(objects_of(scenes), setup.source),
        hand_(hand),
        scenes_(std::move(scenes)),
        setup_(std::move(setup)) {}

 protected:
  Result<Exploration> simulate(std::size_t thing, std::size_t trial,
                               const ExploreOptions& options) const override {
    const HandScene& scene = scenes_[thing];
    SOMATO_TRY(auto hand, SimulatedHand::create(
                              scene, options.placement.value_or(setup_.placement_of(thing, trial)),
                              setup_.seed_of(thing, trial, Draws::kHand)));
    const auto draw = [&](std::size_t grasp) -> Result<void> {
      if (setup_.pictures == nullptr) return {};
      setup_.pictures->save(*hand, scene.object().name, trial, grasp);
      return {};
    };
    auto exploration =
        prepare_body(
            *hand, options, [&] { return scene_of(scene); }, [&] { return poses_of(*hand); })
            .and_then([&] { return explore_with(*hand, draw); });
    if (exploration) exploration->labels = labels_of(scene.object(), trial);
    return exploration;
  }

 private:
  Result<Exploration> explore_with(Body& hand, const AfterGrasp& after_grasp) const {
    const ExploringParameters& parameters = setup_.parameters;
    if (hand_ == Hand::kLucs2) {
      return explore_by_grasping(hand, parameters.plan, parameters.grasp, after_grasp);
    }
    auto exploration = explore_by_closing(hand, parameters.closing);
    if (!exploration) return exploration;
    SOMATO_TRY_VOID(after_grasp(0));
    return exploration;
  }

  Hand hand_;
  std::vector<HandScene> scenes_;
  ExplorerSetup setup_;
};

Result<std::vector<HandScene>> scenes_of(Hand hand, const std::vector<Object>& objects,
                                         const SimulationParameters& parameters) {
  if (objects.empty()) {
    return fail(ErrorKind::kUsage, "no objects for a hand", {}, "add lines to the table [object]");
  }
  std::vector<HandScene> scenes;
  scenes.reserve(objects.size());
  for (const Object& object : objects) {
    SOMATO_TRY(auto scene, HandScene::build(hand, object, parameters));
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

// The plan must keep to the hand's limits, and the open hand must clear the object wherever it
// goes.
Result<void> check_poses(SimulatedHand& hand, const std::vector<GraspPose>& poses,
                         const GuardedGrasp& grasp) {
  for (const GraspPose& pose : poses) {
    const std::array<double, 8> open{pose.height,         pose.wrist_angle,    grasp.proximal_open,
                                     grasp.distal_open,   grasp.proximal_open, grasp.distal_open,
                                     grasp.proximal_open, grasp.distal_open};
    auto possible = hand.command(open).and_then([&] { return hand.check_clear(open); });
    if (!possible) return possible;
  }
  return {};
}

}  // namespace

Result<std::unique_ptr<SimulatedExplorer>> hand_explorer(Hand hand, const ObjectTable& things,
                                                         ExplorerSetup setup) {
  std::vector<GraspPose> poses;  // Hand III stays where it is
  if (hand == Hand::kLucs2) {
    SOMATO_TRY(auto planned, grasp_poses(setup.parameters.plan));
    poses = std::move(planned);
  }
  SOMATO_TRY(auto scenes, scenes_of(hand, things.objects, setup.parameters.simulation));
  for (const HandScene& scene : scenes) {
    auto clear = SimulatedHand::create(scene, {}, 0)
                     .and_then([&](const std::unique_ptr<SimulatedHand>& placed) {
                       return check_poses(*placed, poses, setup.parameters.grasp);
                     });
    if (!clear) return fail(std::move(clear.error()));
  }
  return std::make_unique<HandExplorer>(hand, std::move(scenes), std::move(setup));
}

}  // namespace somato::detail
