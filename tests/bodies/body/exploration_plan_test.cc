#include "bodies/body/exploration_plan.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/files/toml_file.h"

namespace somato {
namespace {

using Poses = std::vector<GraspPose>;

TEST(GraspPoses, AreNineForthLowAndBackHighWithoutTheLast) {
  EXPECT_EQ(grasp_poses({}).value(), (Poses{{126, -48},
                                            {126, -24},
                                            {126, 0},
                                            {126, 24},
                                            {126, 48},
                                            {148, 48},
                                            {148, 24},
                                            {148, 0},
                                            {148, -24}}));
}

TEST(GraspPoses, GoForthAgainAtTheThirdHeight) {
  EXPECT_EQ(grasp_poses({{1, 2, 3}, {10, 20}, 6}).value(),
            (Poses{{1, 10}, {1, 20}, {2, 20}, {2, 10}, {3, 10}, {3, 20}}));
  EXPECT_EQ(grasp_poses({{5}, {7}, 1}).value(), (Poses{{5, 7}}));
}

TEST(GraspPoses, MayStandOnTheTable) {
  EXPECT_EQ(grasp_poses({{0}, {0}, 1}).value(), (Poses{{0, 0}}));
}

TEST(GraspPoses, ThatCannotBeMadeAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [plan, word] :
       std::vector<std::pair<ExplorationPlan, std::string>>{{{{}, {1}, 1}, "heights"},
                                                            {{{1}, {}, 1}, "wrist_angles"},
                                                            {{{1, 2}, {1, 2}, 5}, "5 grasps"},
                                                            {{{1}, {1}, 0}, "grasps"},
                                                            {{{-1}, {1}, 1}, "heights"},
                                                            {{{nan}, {1}, 1}, "heights"},
                                                            {{{1}, {361}, 1}, "wrist_angles"}}) {
    const auto poses = grasp_poses(plan);
    ASSERT_FALSE(poses) << word;
    EXPECT_EQ(poses.error().kind, ErrorKind::kUsage);
    const std::string message = to_string(poses.error());
    EXPECT_NE(message.find(word), std::string::npos) << message;
  }
}

TEST(GraspPoses, ComeFromADescription) {
  const auto table = parse_toml("heights = [90]\nwrist_angles = [0, 30]\ngrasps = 2\n", "plan");
  EXPECT_EQ(grasp_poses(read_parameters<ExplorationPlan>(*table).value()).value(),
            (Poses{{90, 0}, {90, 30}}));
}

}  // namespace
}  // namespace somato
