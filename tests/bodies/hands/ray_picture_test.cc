#include "bodies/hands/ray_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "bodies/physics/physics.h"
#include "somato/core/check.h"

namespace somato::detail {
namespace {

struct World {
  PhysicsModel model;
  PhysicsData data;
};

// A camera at the origin that looks along +y, z up, 60 deg high; it sees what `bodies` describes.
World make_world(const std::string& geoms) {
  const std::string text = R"(<mujoco><asset>
      <material name="clear" rgba="0 1 0 0"/><material name="green" rgba="0 1 0 1"/>
      <mesh name="wedge" vertex="-1 0 -1  1 0 -1  0 0 1  0 1 0"/>
    </asset><worldbody>
      <camera name="view" pos="0 0 0" xyaxes="1 0 0 0 0 1" fovy="60"/>
      )" + geoms + "</worldbody></mujoco>";
  World world{compile_model(text, "test").value(), nullptr};
  world.data = make_data(world.model).value();
  mj_forward(world.model.get(), world.data.get());
  return world;
}

using Pixel = std::array<int, 3>;

constexpr Pixel kWhite{255, 255, 255};

constexpr std::size_t kWidth = 160;
constexpr std::size_t kHeight = 120;

// One ray a pixel, so that every pixel is one colour of one geom.
Image picture(const World& world, std::span<const Tint> tints = {}) {
  return ray_picture(*world.model, *world.data, {kWidth, kHeight, 1, "view"}, tints).value();
}

Pixel at(const Image& image, std::size_t x, std::size_t y) {
  const std::uint8_t* first = &image.rgb[3 * (y * image.width + x)];
  return {first[0], first[1], first[2]};
}

Pixel middle(const Image& image) {
  return at(image, image.width / 2, image.height / 2);
}

bool is_red(const Pixel& pixel) {
  return pixel[0] > 100 && pixel[1] == 0 && pixel[2] == 0;
}
bool is_blue(const Pixel& pixel) {
  return pixel[2] > 100 && pixel[0] == 0 && pixel[1] == 0;
}

TEST(RayPicture, ShowsABallWhereAPinholeDoes) {
  // Off the axis the outline is an ellipse: ask of each pixel's ray how far it passes the centre.
  constexpr double kRadius = 0.3;
  for (const std::array<double, 3> centre :
       {std::array<double, 3>{0, 2, 0}, {0.8, 2, -0.5}, {-1.4, 2, 0.9}, {0.1, 0.31, 0}}) {
    const World world =
        make_world("<geom size='0.3' rgba='1 0 0 1' pos='" + std::to_string(centre[0]) + " " +
                   std::to_string(centre[1]) + " " + std::to_string(centre[2]) + "'/>");
    const Image image = picture(world);
    const double focal = kHeight / 2.0 / std::tan(std::numbers::pi / 6);  // pixels
    std::size_t covered = 0;
    for (std::size_t y = 0; y < kHeight; ++y) {
      for (std::size_t x = 0; x < kWidth; ++x) {
        const double right = static_cast<double>(x) + 0.5 - kWidth / 2.0;
        const double up = kHeight / 2.0 - static_cast<double>(y) - 0.5;
        const double along = (right * centre[0] + focal * centre[1] + up * centre[2]) /
                             std::sqrt(right * right + focal * focal + up * up);
        const double square = centre[0] * centre[0] + centre[1] * centre[1] + centre[2] * centre[2];
        const bool hit = along > 0 && square - along * along < kRadius * kRadius;
        covered += hit;
        ASSERT_EQ(at(image, x, y) != kWhite, hit) << x << ' ' << y;
      }
    }
    ASSERT_GT(covered, 100U);
  }
}

TEST(RayPicture, NearerHidesFarther) {
  const std::string near = "<geom size='0.2' pos='0 1 0' rgba='1 0 0 1'/>";
  const std::string far = "<geom type='box' size='0.9 0.1 0.9' pos='0 3 0' rgba='0 0 1 1'/>";
  for (const std::string& both : {near + far, far + near}) {
    const Image image = picture(make_world(both));
    EXPECT_TRUE(is_red(middle(image)));
    EXPECT_TRUE(is_blue(at(image, kWidth / 2, kHeight / 2 - 25)));
  }
}

TEST(RayPicture, HidesWhatIsNotToBeSeen) {
  const World world = make_world(
      "<geom size='0.2' pos='0 1 0' rgba='1 0 0 1' group='3'/>"
      "<geom size='0.2' pos='0 1 0' rgba='1 0 0 0'/>"
      "<geom size='0.2' pos='0 1 0' material='clear'/>"
      "<geom size='0.2' pos='0 -1 0' rgba='1 0 0 1'/>");
  const Image image = picture(world);
  EXPECT_EQ(std::ranges::count(image.rgb, 255), static_cast<long>(image.rgb.size()));
}

TEST(RayPicture, TakesColoursFromGeomMaterialOrTint) {
  const World world = make_world(
      "<geom type='box' size='0.2 0.1 0.2' pos='-0.5 2 0' material='green'/>"
      "<geom type='box' size='0.2 0.1 0.2' pos='0.5 2 0' material='green' rgba='1 0 0 1'/>");
  const std::size_t left = 54;  // 80 - 0.5 / 1.9 * 104, a little inward
  const std::size_t right = 106;
  Image image = picture(world);
  EXPECT_EQ(at(image, left, 60)[0], 0);
  EXPECT_GT(at(image, left, 60)[1], 100);
  EXPECT_TRUE(is_red(at(image, right, 60)));
  const std::vector<Tint> tints{{1, {1, 0, 0}}, {1, {0, 0, 1}}};
  image = picture(world, tints);
  EXPECT_GT(at(image, left, 60)[1], 100);
  EXPECT_TRUE(is_blue(at(image, right, 60)));
}

// The light: 0.35 back, 0.4 left, 0.85 up, scaled; half of the brightness is ambient.
int brightness(double facing) {
  const double length = std::sqrt(0.35 * 0.35 + 0.4 * 0.4 + 0.85 * 0.85);
  return static_cast<int>(255 * (0.5 + 0.5 * std::max(0.0, facing) / length) + 0.5);
}

TEST(RayPicture, ShadesByTheNormal) {
  // Its face towards the camera; then turned by 30 deg so that the face looks up or down, left or
  // right.
  const auto face = [](const std::string& turn) {
    return middle(picture(make_world(
        "<geom type='box' size='0.3 0.3 0.3' pos='0 2 0' rgba='1 0 0 1' " + turn + "/>")))[0];
  };
  const double cosine = std::cos(std::numbers::pi / 6);
  EXPECT_NEAR(face(""), brightness(0.35), 1);
  EXPECT_NEAR(face("euler='-30 0 0'"), brightness(0.35 * cosine + 0.85 / 2), 1);
  EXPECT_NEAR(face("euler='30 0 0'"), brightness(0.35 * cosine - 0.85 / 2), 1);
  EXPECT_NEAR(face("euler='0 0 -30'"), brightness(0.35 * cosine + 0.4 / 2), 1);
  EXPECT_NEAR(face("euler='0 0 30'"), brightness(0.35 * cosine - 0.4 / 2), 1);
}

TEST(RayPicture, ShadesMeshesBallsAndPlanesAlike) {
  // Each shows the camera a normal of its own: the wedge's flat face, a ball's nearest point, a
  // floor.
  EXPECT_NEAR(
      middle(picture(make_world("<geom type='mesh' mesh='wedge' pos='0 4 0' rgba='1 0 0 1'/>")))[0],
      brightness(0.35), 1);
  // The middle pixel's ray passes half a pixel right of and below the axis, at 1.7 m.
  const double aside = 0.5 / (60 / std::tan(std::numbers::pi / 6)) * 1.7 / 0.3;
  EXPECT_NEAR(middle(picture(make_world("<geom size='0.3' pos='0 2 0' rgba='1 0 0 1'/>")))[0],
              brightness(0.35 - aside * (0.4 + 0.85)), 1);
  const Image floor =
      picture(make_world("<geom type='plane' size='0 0 1' pos='0 0 -1' rgba='1 0 0 1'/>"));
  EXPECT_NEAR(at(floor, 80, 110)[0], brightness(0.85), 1);
  EXPECT_EQ(at(floor, 80, 50), kWhite);  // above the horizon
}

TEST(RayPicture, AThingShadesTheFloorUnderIt) {
  const World world = make_world(
      "<geom type='plane' size='0 0 1' pos='0 0 -1' rgba='1 0 0 1'/>"
      "<geom size='0.3' pos='0 3 -0.7' rgba='0 0 1 1'/>");
  const Image image = picture(world);
  // The light comes from the left: a point of the floor 0.35 right of where the ball touches, at
  // 80 + 104 * 0.35 / 3 across and 60 + 104 / 3 down, lies in the ball's shadow; its mirror image
  // does not.
  EXPECT_EQ(at(image, 92, 94)[0], 128);
  EXPECT_NEAR(at(image, 67, 94)[0], brightness(0.85), 1);
}

TEST(RayPicture, AThingShadesWhatItTouches) {
  // The floor 0.25 right of the middle of a box that reaches to 0.2: pixel 80 + 104 * 0.25 / 3
  // across.
  const World world = make_world(
      "<geom type='plane' size='0 0 1' pos='0 0 -1' rgba='1 0 0 1'/>"
      "<geom type='box' size='0.2 0.2 0.2' pos='0 3 -0.8' rgba='0 0 1 1'/>");
  EXPECT_EQ(at(picture(world), 88, 94)[0], 128);
}

TEST(RayPicture, MoreRaysMixTheEdges) {
  const World world = make_world("<geom size='0.3' pos='0 2 0' rgba='0 0 0 1'/>");
  const Image image = ray_picture(*world.model, *world.data, {80, 60, 2, "view"}).value();
  const Image points = ray_picture(*world.model, *world.data, {160, 120, 1, "view"}).value();
  for (std::size_t y = 0; y < 60; ++y) {
    for (std::size_t x = 0; x < 80; ++x) {
      const int sum = at(points, 2 * x, 2 * y)[0] + at(points, 2 * x + 1, 2 * y)[0] +
                      at(points, 2 * x, 2 * y + 1)[0] + at(points, 2 * x + 1, 2 * y + 1)[0];
      ASSERT_NEAR(at(image, x, y)[0], sum / 4.0, 0.5) << x << ' ' << y;
    }
  }
}

TEST(RayPicture, RefusesWhatItCannotShow) {
  const World world = make_world("");
  const auto unknown = ray_picture(*world.model, *world.data, {8, 6, 1, "above"});
  ASSERT_FALSE(unknown);
  EXPECT_NE(to_string(unknown.error()).find("no camera 'above'"), std::string::npos);
  EXPECT_THROW((void)ray_picture(*world.model, *world.data, {0, 6, 1, "view"}), InvalidArgument);
  EXPECT_THROW((void)ray_picture(*world.model, *world.data, {8, 6, 0, "view"}), InvalidArgument);
  const std::vector<Tint> tints{{0, {}}};
  EXPECT_THROW((void)picture(world, tints), InvalidArgument);
}

}  // namespace
}  // namespace somato::detail
