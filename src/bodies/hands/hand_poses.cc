#include "bodies/hands/hand_poses.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

#include "bodies/hands/object_motion.h"
#include "bodies/hands/played_frames.h"
#include "bodies/hands/simulated_hand_impl.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using detail::row_of;

constexpr int kHiddenGroup = 3;

GeomShape shape_of(const mjModel& model, int geom) {
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      return GeomShape::kSphere;
    case mjGEOM_CAPSULE:
      return GeomShape::kCapsule;
    case mjGEOM_CYLINDER:
      return GeomShape::kCylinder;
    case mjGEOM_ELLIPSOID:
      return GeomShape::kEllipsoid;
    case mjGEOM_MESH:
      return GeomShape::kMesh;
    default:
      return GeomShape::kBox;
  }
}

bool is_shown(const mjModel& model, int geom) {
  return model.geom_group[geom] < kHiddenGroup && row_of(model.geom_rgba, geom, 4)[3] > 0 &&
         model.geom_type[geom] != mjGEOM_PLANE;
}

GeomRole role_of(const HandScene::Impl& scene, int geom) {
  const int body = scene.model->geom_bodyid[geom];
  if (body == scene.object_body || (body == scene.stand_body && body >= 0)) {
    return GeomRole::kObject;
  }
  return body == 0 ? GeomRole::kTable : GeomRole::kHand;
}

template <std::size_t Count, typename Number>
std::array<double, Count> numbers(const Number* first) {
  std::array<double, Count> all{};
  std::copy(first, first + Count, all.begin());
  return all;
}

void add_mesh(const mjModel& model, int geom, SceneGeom& shown) {
  const int mesh = model.geom_dataid[geom];
  const float* vertex = model.mesh_vert + std::ptrdiff_t{3} * model.mesh_vertadr[mesh];
  shown.vertices.assign(vertex, vertex + std::ptrdiff_t{3} * model.mesh_vertnum[mesh]);
  const int* face = model.mesh_face + std::ptrdiff_t{3} * model.mesh_faceadr[mesh];
  const int* end = face + std::ptrdiff_t{3} * model.mesh_facenum[mesh];
  std::transform(face, end, std::back_inserter(shown.faces),
                 [](int corner) { return static_cast<std::uint32_t>(corner); });
}

SceneGeom scene_geom(const HandScene::Impl& scene, int geom) {
  const mjModel& model = *scene.model;
  const int body = model.geom_bodyid[geom];
  const int taxel = scene.taxels.taxel_of_geom[static_cast<std::size_t>(geom)];
  const char* name = mj_id2name(&model, mjOBJ_GEOM, geom);
  SceneGeom shown;
  // The world is body 0 of the model, and none of the scene.
  if (body > 0) shown.body = static_cast<std::size_t>(body - 1);
  if (name != nullptr) shown.name = name;
  shown.shape = shape_of(model, geom);
  shown.size = numbers<3>(row_of(model.geom_size, geom, 3));
  shown.pose = {numbers<3>(row_of(model.geom_pos, geom, 3)),
                numbers<4>(row_of(model.geom_quat, geom, 4))};
  shown.colour = numbers<4>(row_of(model.geom_rgba, geom, 4));
  shown.role = role_of(scene, geom);
  if (taxel >= 0) shown.taxel = static_cast<std::size_t>(taxel);
  if (shown.shape == GeomShape::kMesh) add_mesh(model, geom, shown);
  return shown;
}

// The view of the model's camera, to a point one hand's length ahead.
void add_camera(const mjModel& model, Scene& scene) {
  constexpr double kAhead = 0.45;  // m
  const int camera = detail::find_in(model, mjOBJ_CAMERA, "view");
  if (camera < 0) return;
  scene.camera = numbers<3>(row_of(model.cam_pos, camera, 3));
  std::array<mjtNum, 3> ahead{};
  const std::array<mjtNum, 3> own{0, 0, -kAhead};
  mju_rotVecQuat(ahead.data(), own.data(), row_of(model.cam_quat, camera, 4));
  for (std::size_t i = 0; i < 3; ++i) scene.target[i] = scene.camera[i] + ahead[i];
}

Scene scene_of_parts(const HandScene::Impl& parts) {
  const mjModel& model = *parts.model;
  Scene scene;
  scene.bodies.reserve(static_cast<std::size_t>(model.nbody));
  for (int body = 1; body < static_cast<int>(model.nbody); ++body) {
    const char* name = mj_id2name(&model, mjOBJ_BODY, body);
    scene.bodies.emplace_back(name != nullptr ? name : "");
  }
  for (int geom = 0; geom < static_cast<int>(model.ngeom); ++geom) {
    if (is_shown(model, geom)) scene.geoms.push_back(scene_geom(parts, geom));
  }
  add_camera(model, scene);
  return scene;
}

std::vector<ScenePose> poses_in(const mjModel& model, const mjData& data) {
  std::vector<ScenePose> poses;
  poses.reserve(static_cast<std::size_t>(model.nbody));
  for (int body = 1; body < static_cast<int>(model.nbody); ++body) {
    poses.push_back(
        {numbers<3>(row_of(data.xpos, body, 3)), numbers<4>(row_of(data.xquat, body, 4))});
  }
  return poses;
}

struct NeededChannel {
  const char* name;
  std::size_t elements;
};

std::vector<NeededChannel> channels_of(Hand hand) {
  if (hand == Hand::kLucs2) return {{"height", 1}, {"wrist", 1}, {"joints", 6}};
  return {{"joints", 11}};
}

double& joint_of(const mjModel& model, mjData& data, int joint) {
  return data.qpos[model.jnt_qposadr[joint]];
}

// The share of a cable's travel for a joint, according to its lever and its spring.
double yielding(const mjModel& model, int joint, double lever) {
  const double stiffness = model.jnt_stiffness[joint];
  return stiffness > 0 ? lever / stiffness : lever;
}

// The joints that a servo's cable pulls go where it is not stretched. Its first joint is the servo.
void pull(const mjModel& model, int tendon, mjData& data) {
  const int first = model.tendon_adr[tendon];
  const int last = first + model.tendon_num[tendon];
  const double pulled = -model.wrap_prm[first] * joint_of(model, data, model.wrap_objid[first]);
  double give = 0.0;
  for (int wrap = first + 1; wrap < last; ++wrap) {
    give += model.wrap_prm[wrap] * yielding(model, model.wrap_objid[wrap], model.wrap_prm[wrap]);
  }
  for (int wrap = first + 1; wrap < last; ++wrap) {
    const int joint = model.wrap_objid[wrap];
    const mjtNum* range = row_of(model.jnt_range, joint, 2);
    const double angle = pulled * yielding(model, joint, model.wrap_prm[wrap]) / give;
    joint_of(model, data, joint) = std::clamp(angle, range[0], range[1]);
  }
}

class HandPlayer : public ScenePlayer {
 public:
  HandPlayer(std::shared_ptr<const HandScene::Impl> parts, detail::PhysicsData data,
             bool with_object)
      : parts_(std::move(parts)), data_(std::move(data)), scene_(scene_of_parts(*parts_)) {
    detail::put_object(*parts_, detail::object_pose(*parts_, {}), *data_);
    if (with_object) return;
    std::erase_if(scene_.geoms,
                  [](const SceneGeom& geom) { return geom.role == GeomRole::kObject; });
  }

  const Scene& scene() const override { return scene_; }

  std::vector<ScenePose> poses(const Exploration& exploration, std::size_t frame) override {
    const mjModel& model = *parts_->model;
    const std::size_t frames = detail::most_frames(exploration);
    std::size_t servo =
        parts_->hand == Hand::kLucs2 ? 0 : 1;  // the pose of Hand III's wrist is unknown
    for (const NeededChannel& needed : channels_of(parts_->hand)) {
      const Channel* channel = detail::played_channel(exploration, needed.name, needed.elements);
      require(channel != nullptr && frame < frames,
              "the frame does not exist in the recording of this hand");
      const std::size_t row = detail::played_row(exploration, *channel, frame);
      for (std::size_t element = 0; element < needed.elements; ++element) {
        set_servo(servo++, double{detail::played_value(*channel, row, element)});
      }
    }
    for (int tendon = 0; tendon < static_cast<int>(model.ntendon); ++tendon) {
      pull(model, tendon, *data_);
    }
    mj_kinematics(&model, data_.get());
    return poses_in(model, *data_);
  }

 private:
  void set_servo(std::size_t servo, double position) {
    const mjModel& model = *parts_->model;
    joint_of(model, *data_, model.actuator_trnid[2 * servo]) = position * parts_->scales[servo];
  }

  std::shared_ptr<const HandScene::Impl> parts_;
  detail::PhysicsData data_;
  Scene scene_;
};

}  // namespace

Scene scene_of(const HandScene& scene) {
  return scene_of_parts(*scene.shared_impl());
}

std::vector<ScenePose> poses_of(const SimulatedHand& hand) {
  return poses_in(*hand.impl().scene->model, *hand.impl().data);
}

std::unique_ptr<ScenePlayer> play_hand(const HandScene& scene, bool with_object) {
  auto data = detail::make_data(scene.shared_impl()->model);
  if (!data) return nullptr;
  return std::make_unique<HandPlayer>(scene.shared_impl(), std::move(*data), with_object);
}

bool is_of_hand(const Exploration& exploration, Hand hand) {
  const auto needed = channels_of(hand);
  return std::all_of(needed.begin(), needed.end(), [&](const NeededChannel& one) {
    return detail::played_channel(exploration, one.name, one.elements) != nullptr;
  });
}

}  // namespace somato
