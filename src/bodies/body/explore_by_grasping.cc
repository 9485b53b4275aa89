
#include "somato/bodies/explore_by.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "bodies/body/exploration_plan.h"
#include "bodies/body/frame_log.h"
#include "bodies/body/guarded_grasp.h"
#include "bodies/body/hand_layout.h"
#include "bodies/body/motion.h"

namespace somato {
namespace {

// The servos of a hand that goes from grasp to grasp.
class GraspingHand {
 public:
  GraspingHand(Body& body, const HandLayout& hand, const GuardedGrasp& grasp, std::size_t height,
               std::size_t wrist)
      : body_(body),
        hand_(hand),
        grasp_(grasp),
        height_(height),
        wrist_(wrist),
        targets_(present_targets(body)),
        log_(body.description(), body.limits().memory) {}

  Result<void> open() {
    for (const Finger& finger : hand_.fingers) {
      targets_[finger.proximal.servo] = grasp_.proximal_open;
      targets_[finger.distal.servo] = grasp_.distal_open;
    }
    return move_to(body_, targets_, grasp_.motion);
  }

  Result<void> grasp_at(const GraspPose& pose) {
    targets_[height_] = pose.height;
    targets_[wrist_] = pose.wrist_angle;
    return move_to(body_, targets_, grasp_.motion)
        .and_then([&] { return guarded_grasp(body_, hand_, grasp_, targets_, log_); })
        .map([&](const GraspResult& result) { touching_ += result.touching; });
  }

  Result<Exploration> explored() && {
    if (touching_ > 0) return Exploration{{}, {}, std::move(log_).channels()};
    return fail(ErrorKind::kData, "the hand never touched the object", {},
                "check the position of the object, or lower 'threshold'");
  }

 private:
  Body& body_;
  const HandLayout& hand_;
  const GuardedGrasp& grasp_;
  std::size_t height_;
  std::size_t wrist_;
  std::vector<double> targets_;
  FrameLog log_;
  std::size_t touching_ = 0;
};

tl::unexpected<Error> in_grasp(Error error, const std::vector<GraspPose>& poses,
                               std::size_t index) {
  const GraspPose& pose = poses[index];
  const std::string grasp = fmt::format("grasp {} of {} (height {:g} mm, wrist {:g} deg)",
                                        index + 1, poses.size(), pose.height, pose.wrist_angle);
  error.where = error.where.empty() ? grasp : fmt::format("{}, {}", grasp, error.where);
  return fail(std::move(error));
}

}  // namespace

Result<Exploration> explore_by_grasping(Body& body, const ExplorationPlan& plan,
                                        const GuardedGrasp& grasp, const AfterGrasp& after_grasp) {
  SOMATO_TRY(const auto poses, grasp_poses(plan));
  SOMATO_TRY(const auto layout, hand_layout(body.description()));
  SOMATO_TRY(const auto height, find_degree_of_freedom(body.description(), "height"));
  SOMATO_TRY(const auto wrist, find_degree_of_freedom(body.description(), "wrist"));
  GraspingHand hand(body, layout, grasp, height, wrist);
  SOMATO_TRY_VOID(hand.open());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    auto grasped = hand.grasp_at(poses[i])
                       .and_then([&] { return after_grasp ? after_grasp(i) : Result<void>(); })
                       .and_then([&] { return hand.open(); });
    if (!grasped) return in_grasp(std::move(grasped.error()), poses, i);
  }
  return std::move(hand).explored();
}

}  // namespace somato
