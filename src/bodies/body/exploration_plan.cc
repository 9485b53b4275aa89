#include "bodies/body/exploration_plan.h"

#include <fmt/format.h>

namespace somato {
namespace {

tl::unexpected<Error> refuse(std::string what, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), {}, std::move(advice));
}

}  // namespace

const Declarations<ExplorationPlan>& ExplorationPlan::declarations() {
  using P = ExplorationPlan;
  static const auto declared =
      Declarations<P>()
          .add("heights", &P::heights, "mm", Range::between(0, 1000),
               "Heights of the hand, in order. Two in P06; the values are not given in the paper.")
          .add("wrist_angles", &P::wrist_angles, "deg", Range::between(-360, 360),
               "Angles of the wrist, in reverse order at every second height. Five in P06; the "
               "values are not given in the paper.")
          .add("grasps", &P::grasps, "", Range::between(1, 10000),
               "Number of pairs of height and angle used, in this order. Nine in P06; "
               "which of the ten is left out is not given in the paper.");
  return declared;
}

Result<std::vector<GraspPose>> grasp_poses(const ExplorationPlan& plan) {
  SOMATO_TRY_VOID(check_ranges(plan));
  const std::size_t angles = plan.wrist_angles.size();
  if (plan.heights.empty()) return refuse("the plan has no heights", "set one or more 'heights'");
  if (angles == 0) return refuse("the plan has no angles", "set one or more 'wrist_angles'");
  if (plan.grasps > plan.heights.size() * angles) {
    return refuse(fmt::format("{} grasps are more than the pairs of {} heights and {} wrist angles",
                              plan.grasps, plan.heights.size(), angles),
                  "lower 'grasps', or add heights or angles");
  }
  std::vector<GraspPose> poses;
  poses.reserve(plan.grasps);
  for (std::size_t i = 0; i < plan.grasps; ++i) {
    const std::size_t row = i / angles;
    const std::size_t along = row % 2 == 0 ? i % angles : angles - 1 - i % angles;
    poses.push_back({plan.heights[row], plan.wrist_angles[along]});
  }
  return poses;
}

}  // namespace somato
