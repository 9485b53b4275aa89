#include "bodies/hands/silhouette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

#include "bodies/physics/physics.h"
#include "bodies/support/things.h"
#include "somato/bodies/explore_by.h"
#include "somato/simulation/simulated_hand.h"

namespace somato {
namespace {

using detail::find_in;
using detail::ParallelView;
using detail::PhysicsData;
using detail::PhysicsModel;
using detail::silhouette;
using detail::view_of_camera;

constexpr std::size_t kPixels = 32;
constexpr double kSide = 0.2;                                 // m
constexpr double kElevation = 40.0 * std::numbers::pi / 180;  // of the camera

// A geom before a camera that looks down on the origin at kElevation, along y.
class SeenGeom {
 public:
  explicit SeenGeom(const std::string& geom) {
    const std::string text = R"(<mujoco><asset><mesh name="ramp" vertex="-0.03 -0.02 -0.01
        0.03 -0.02 -0.01  -0.03 0.02 -0.01  0.03 0.02 -0.01  -0.03 -0.02 0.05  0.03 -0.02 0.05"/>
      </asset><worldbody><camera name="view" pos="0 -1 1" xyaxes="1 0 0 0 )" +
                             std::to_string(std::sin(kElevation)) + " " +
                             std::to_string(std::cos(kElevation)) + "\"/><geom name=\"g\" " + geom +
                             "/></worldbody></mujoco>";
    model_ = detail::compile_model(text, "scene").value();
    data_ = detail::make_data(model_).value();
    mj_forward(model_.get(), data_.get());
  }

  std::vector<double> seen(std::size_t pixels = kPixels) const {
    const ParallelView view = view_of_camera(*model_, *data_, "view", {0, 0, 0}, kSide);
    return silhouette(*model_, *data_, find_in(*model_, mjOBJ_GEOM, "g"), view, pixels);
  }

  // In mm^2.
  double area() const {
    const std::vector<double> pixels = seen();
    const double pixel = kSide * 1000 / kPixels;
    return std::accumulate(pixels.begin(), pixels.end(), 0.0) * pixel * pixel;
  }

 private:
  PhysicsModel model_;
  PhysicsData data_;
};

// The areas of shadows, from geometry; at 32 x 32 pixels with 16 points each a point is 1.6 mm.
TEST(Silhouette, HasTheAreaOfTheShapesShadow) {
  const double down = std::sin(kElevation);
  const double along = std::cos(kElevation);
  const double pi = std::numbers::pi;
  EXPECT_NEAR(SeenGeom(R"(type="sphere" size="0.036")").area(), pi * 36 * 36, 40);
  EXPECT_NEAR(SeenGeom(R"(type="cylinder" size="0.03 0.05")").area(),
              60 * 100 * along + pi * 30 * 30 * down, 80);
  // The faces that are seen, each by the cosine of its tilt.
  EXPECT_NEAR(SeenGeom(R"(type="box" size="0.03 0.02 0.05")").area(),
              60 * 100 * along + 60 * 40 * down, 80);
  const double turn = pi / 6;
  EXPECT_NEAR(SeenGeom(R"(type="box" size="0.03 0.02 0.05" axisangle="0 0 1 30")").area(),
              (60 * std::cos(turn) + 40 * std::sin(turn)) * 100 * along + 60 * 40 * down, 80);
  // Only the upright side of the ramp is seen, since its slope is steeper than the camera's view.
  EXPECT_NEAR(SeenGeom(R"(type="mesh" mesh="ramp")").area(), 60 * 60 * along, 80);
}

TEST(Silhouette, ShowsRightAndUp) {
  const auto seen = SeenGeom(R"(type="sphere" size="0.02" pos="0.05 0 0.05")").seen();
  double x = 0.0;
  double y = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    x += seen[i] * (static_cast<double>(i % kPixels) + 0.5);
    y += seen[i] * (static_cast<double>(i / kPixels) + 0.5);
    all += seen[i];
  }
  const double pixel = kSide / kPixels;
  EXPECT_NEAR((x / all - 16) * pixel, 0.05, 1e-3);
  EXPECT_NEAR((16 - y / all) * pixel, 0.05 * std::cos(kElevation), 1e-3);
}

TEST(Silhouette, OfAPixelIsItsShare) {
  const SeenGeom scene(R"(type="box" size="0.05 0.2 0.5")");
  // The middle half of the width, from top to bottom, is covered.
  EXPECT_EQ(scene.seen(2), (std::vector<double>{0.5, 0.5, 0.5, 0.5}));
  EXPECT_EQ(scene.seen(4), (std::vector<double>{0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0}));
}

Exploration explored(Hand hand, const Object& object, std::size_t pixels) {
  SimulationParameters parameters;
  parameters.silhouette = pixels;
  parameters.taxels = true;
  const auto scene = HandScene::build(hand, object, parameters).value();
  auto body = SimulatedHand::create(scene, {1.0, 0.5, 3.0}, 4).value();
  if (hand == Hand::kLucs3) return explore_by_closing(*body, {}).value();
  ExplorationPlan plan;
  plan.grasps = 1;
  return explore_by_grasping(*body, plan, {}, {}).value();
}

TEST(SilhouetteOfAHand, IsAChannelThatChangesNoOther) {
  for (const Hand hand : {Hand::kLucs2, Hand::kLucs3}) {
    const Exploration without = explored(hand, cylinder_thing(), 0);
    const Exploration with = explored(hand, cylinder_thing(), 16);
    ASSERT_EQ(with.channels.size(), without.channels.size() + 1);
    for (std::size_t i = 0; i < without.channels.size(); ++i) {
      EXPECT_EQ(with.channels[i], without.channels[i]);
    }
    const Channel& seen = with.channels.back();
    EXPECT_EQ(seen.name, "silhouette");
    EXPECT_EQ(seen.shape, (std::vector<std::size_t>{16, 16}));
    EXPECT_EQ(seen.frames.rows(), with.channels.front().frames.rows());
    // All of the object is in the picture.
    double border = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < 256; ++i) {
      const bool outside = i < 16 || i >= 240 || i % 16 == 0 || i % 16 == 15;
      const auto pixel = static_cast<double>(seen.frames(0, i));
      border += outside ? pixel : 0.0;
      all += pixel;
    }
    EXPECT_EQ(border, 0.0);
    EXPECT_GT(all, 10.0);
  }
}

TEST(SilhouetteOfAHand, DiffersBetweenShapesOfOneSize) {
  const auto seen = [](Shape shape) {
    return explored(Hand::kLucs3, thing(shape, 60, 60, 60), 16).channels.back().frames;
  };
  EXPECT_NE(seen(Shape::kSphere), seen(Shape::kCylinder));
  EXPECT_NE(seen(Shape::kCylinder), seen(Shape::kBlock));
}

}  // namespace
}  // namespace somato
