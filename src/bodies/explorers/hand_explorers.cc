#include "bodies/explorers/hand_explorers.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "bodies/body/exploration_plan.h"
#include "bodies/hands/hand_picture.h"
#include "bodies/hands/hand_poses.h"
#include "bodies/hands/simulated_hand_impl.h"
#include "bodies/sensors/exploration_draws.h"
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

// The same options with an observer that keeps the true values of recorded steps.
ExploreOptions keeping_true_values(ExploreOptions options, SimulatedHand& hand) {
  options.observer.on_step = [&hand, seen = std::move(options.observer.on_step)](
                                 const ExplorationStep& step) -> Result<void> {
    if (step.readings == Readings::kRecorded) hand.keep_true_values();
    return seen ? seen(step) : Result<void>();
  };
  return options;
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
                              setup_.seed_of(thing, trial, Draws::kHand), setup_.seed));
    const auto draw = [&](std::size_t grasp) -> Result<void> {
      if (setup_.pictures == nullptr) return {};
      setup_.pictures->save(*hand, scene.object().name, trial, grasp);
      return {};
    };
    const ExploreOptions observed =
        setup_.keeps_true_values() ? keeping_true_values(options, *hand) : options;
    auto exploration =
        prepare_body(
            *hand, observed, [&] { return scene_of(scene); }, [&] { return poses_of(*hand); })
            .and_then([&] { return explore_with(*hand, draw); });
    if (!exploration) return exploration;
    exploration->labels = labels_of(scene.object(), trial);
    if (setup_.keeps_true_values()) add_true_values(*hand, thing, trial, *exploration);
    return exploration;
  }

 private:
  void add_true_values(const SimulatedHand& hand, std::size_t thing, std::size_t trial,
                       Exploration& exploration) const {
    const auto names_of = [&](const char* sensor) {
      const auto found = find_sensor(hand.description(), sensor);
      return found ? hand.description().sensors[*found].element_names : std::vector<std::string>();
    };
    const bool has_potentiometers = hand_ == Hand::kLucs3;
    hand.impl().truth.add_to(exploration,
                             has_potentiometers ? names_of("joints") : std::vector<std::string>(),
                             names_of("touch"));
    put_draws(setup_.draws_of(thing, trial), exploration);
  }

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
