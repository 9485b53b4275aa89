#include "bodies/physics/object_mjcf.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "base/support/temporary_folder.h"
#include "bodies/physics/physics.h"

namespace somato::detail {
namespace {

Object object_of(Shape shape, double width, double depth, double height) {
  Object object;
  object.name = "thing";
  object.shape = shape;
  object.size = {width, depth, height};
  object.material.density = 1000.0;
  object.mass = 0.0;
  return object;
}

std::shared_ptr<mjModel> compiled(const Object& object, const ObjectSettings& settings = {}) {
  const auto measured = measure_object(object);
  EXPECT_TRUE(measured) << measured.error().what;
  const ObjectMjcf mjcf = object_mjcf(*measured, settings);
  auto model =
      compile_model(fmt::format("<mujoco><asset>{}</asset><worldbody>{}</worldbody></mujoco>",
                                mjcf.assets, mjcf.bodies),
                    "object");
  EXPECT_TRUE(model) << model.error().what;
  return *model;
}

// How far a ray from `point` along `way` goes until it meets the object; in mm.
double ray(const mjModel& model, std::array<mjtNum, 3> point, std::array<mjtNum, 3> way) {
  const PhysicsData data(mj_makeData(&model));
  mj_forward(&model, data.get());
  int geom = -1;
#if mjVERSION_HEADER >= 3000000
  return 1000 *
         mj_ray(&model, data.get(), point.data(), way.data(), nullptr, 1, -1, &geom, nullptr);
#else
  return 1000 * mj_ray(&model, data.get(), point.data(), way.data(), nullptr, 1, -1, &geom);
#endif
}

// The outer size of the object along the axes through its middle, measured from outside, in mm; it
// must stand on z = 0 over the origin.
std::array<double, 3> measured_size(const mjModel& model, double at_height) {
  const double z = at_height / 1000;
  const double right = 1000 - ray(model, {1, 0, z}, {-1, 0, 0});
  const double left = 1000 - ray(model, {-1, 0, z}, {1, 0, 0});
  const double front = 1000 - ray(model, {0, -1, z}, {0, 1, 0});
  const double back = 1000 - ray(model, {0, 1, z}, {0, -1, 0});
  EXPECT_NEAR(ray(model, {0, 0, -1}, {0, 0, 1}), 1000, 0.1);
  EXPECT_NEAR(left, right, 0.1);
  EXPECT_NEAR(front, back, 0.1);
  return {left + right, front + back, 1000 - ray(model, {0, 0, 1}, {0, 0, -1})};
}

void expect_size(const std::array<double, 3>& measured, const std::array<double, 3>& expected) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(measured[axis], expected[axis], 0.002 * expected[axis]) << axis;
  }
}

struct Case {
  Object object;
  double widest_at;  ///< mm above the table.
  std::array<double, 3> size;
  double volume;  ///< mm^3.
};

std::vector<Case> cases() {
  constexpr double kPi = std::numbers::pi;
  Object cut = object_of(Shape::kCone, 60, 60, 90);
  cut.top_diameter = 30;
  return {
      {object_of(Shape::kSphere, 72, 72, 72), 36, {72, 72, 72}, kPi * 72 * 72 * 72 / 6},
      {object_of(Shape::kCylinder, 62, 62, 121), 50, {62, 62, 121}, kPi * 31 * 31 * 121},
      {object_of(Shape::kBlock, 58, 50, 110), 50, {58, 50, 110}, 58 * 50 * 110},
      {object_of(Shape::kEllipsoid, 60, 40, 100), 50, {60, 40, 100}, kPi * 60 * 40 * 100 / 6},
      {object_of(Shape::kCapsule, 50, 50, 120),
       60,
       {50, 50, 120},
       kPi * 25 * 25 * (70 + 4.0 / 3 * 25)},
      {object_of(Shape::kCone, 60, 60, 90), 0.001, {60, 60, 90}, kPi * 30 * 30 * 90 / 3},
      {cut, 0.001, {60, 60, 90}, kPi * 90 / 3 * (30 * 30 + 30 * 15 + 15 * 15)},
  };
}

TEST(ObjectMjcf, EveryShapeHasItsSizeAndStandsOnTheTable) {
  for (const Case& one : cases())
    expect_size(measured_size(*compiled(one.object), one.widest_at), one.size);
}

TEST(ObjectMjcf, AFreeObjectWeighsItsVolumeTimesItsDensityOrWhatItIsSaidTo) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(static_cast<int>(one.object.shape));
    const auto model = compiled(one.object, {.free = true, .friction = 0.3});
    const int body = find_in(*model, mjOBJ_BODY, "object");
    EXPECT_NEAR(model->body_mass[body], one.volume * 1e-6, 0.005 * one.volume * 1e-6);
    Object heavy = one.object;
    heavy.mass = 1.25;
    EXPECT_NEAR(compiled(heavy, {.free = true, .friction = 0.3})->body_mass[body], 1.25, 1e-9);
  }
}

// A cube of 2 units a side, whose middle lies far from its file's origin.
constexpr const char* kCube = R"(v 10 20 30
v 12 20 30
v 10 22 30
v 12 22 30
v 10 20 32
v 12 20 32
v 10 22 32
v 12 22 32
f 1 3 4
f 1 4 2
f 5 6 8
f 5 8 7
f 1 2 6
f 1 6 5
f 3 7 8
f 3 8 4
f 1 5 7
f 1 7 3
f 2 4 8
f 2 8 6
)";

TEST(ObjectMjcf, AMeshIsScaledAndSetOnTheTableWhereverItsFileHasIt) {
  const TemporaryFolder folder;
  Object object = object_of(Shape::kMesh, 0, 0, 0);
  object.mesh_file = folder.with("a cube & more.obj", kCube);
  object.mesh_scale = 25;
  const auto measured = measure_object(object);
  ASSERT_TRUE(measured) << measured.error().what;
  expect_size(measured->object.size, {50, 50, 50});
  const auto model = compiled(object, {.free = true, .friction = 0.5});
  expect_size(measured_size(*model, 25), {50, 50, 50});
  EXPECT_NEAR(model->body_mass[find_in(*model, mjOBJ_BODY, "object")], 0.125, 1e-4);
}

TEST(ObjectMjcf, MeshesWithoutSenseAreRefused) {
  const TemporaryFolder folder;
  const std::string cube = kCube;
  const std::vector<std::pair<std::string, std::string>> hostile = {
      {"empty.obj", ""},
      {"no_faces.obj", "v 0 0 0\nv 1 0 0\n"},
      {"flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"face_beyond.obj", cube + "f 1 2 900\n"},
      {"not_a_number.obj", "v nan nan nan\n" + cube},
      {"huge.obj", "v 1e30 0 0\n" + cube},
      {"cut.stl", "solid"},
      {"random.stl", std::string(200, '\x7f')},
      {"missing.obj", ""},
  };
  for (const auto& [name, bytes] : hostile) {
    Object object = object_of(Shape::kMesh, 0, 0, 0);
    object.mesh_file = name == "missing.obj" ? folder.file(name) : folder.with(name, bytes);
    object.mesh_scale = 25;
    const auto measured = measure_object(object);
    ASSERT_FALSE(measured) << name;
    EXPECT_EQ(measured.error().where, object.mesh_file) << name;
  }
}

TEST(ObjectMjcf, AMeshWithAnotherUnitIsReported) {
  const TemporaryFolder folder;
  Object object = object_of(Shape::kMesh, 0, 0, 0);
  object.mesh_file = folder.with("cube.obj", kCube);
  object.mesh_scale = 1000;
  const auto measured = measure_object(object);
  ASSERT_FALSE(measured);
  EXPECT_NE(measured.error().advice.find("scale"), std::string::npos);
}

}  // namespace
}  // namespace somato::detail
