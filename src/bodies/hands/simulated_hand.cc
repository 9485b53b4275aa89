#include "somato/simulation/simulated_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bodies/hands/silhouette.h"
#include "bodies/hands/simulated_hand_impl.h"
#include "bodies/physics/units.h"
#include "somato/core/check.h"

namespace somato {
namespace {

std::vector<double> in_units(const HandScene::Impl& scene, std::span<const double> positions) {
  std::vector<double> units(positions.size());
  for (std::size_t i = 0; i < units.size(); ++i) units[i] = positions[i] / scene.scales[i];
  return units;
}

std::vector<double> in_model(const HandScene::Impl& scene, std::span<const double> positions) {
  std::vector<double> model(positions.size());
  for (std::size_t i = 0; i < model.size(); ++i) model[i] = positions[i] * scene.scales[i];
  return model;
}

// Sets the joints that the servos act upon.
void set_joints(const mjModel& model, std::span<const double> positions, mjData& data) {
  for (std::size_t i = 0; i < positions.size(); ++i)
    data.qpos[model.jnt_qposadr[model.actuator_trnid[2 * i]]] = positions[i];
}

Matrix<float> row(std::span<const double> values) {
  Matrix<float> matrix(1, values.size());
  std::transform(values.begin(), values.end(), matrix.row(0).begin(),
                 [](double value) { return static_cast<float>(value); });
  return matrix;
}

std::size_t count_joints(const HandScene::Impl& scene) {
  return scene.hand == Hand::kLucs2 ? 0 : static_cast<std::size_t>(scene.model->nsensor);
}

// The angles of the servos of Hand III, where its potentiometers are, in deg.
std::vector<double> servo_angles(const mjModel& model, const mjData& data, std::size_t count) {
  std::vector<double> angles(count);
  for (std::size_t i = 0; i < angles.size(); ++i)
    angles[i] = data.sensordata[model.sensor_adr[i]] * 180.0 / std::numbers::pi;
  return angles;
}

}  // namespace

Placement draw_placement(const SimulationParameters& parameters, Random& random) {
  const double turn = parameters.placement_turn.value_or(2.0 * parameters.placement_noise);
  Placement placement;
  placement.x = parameters.placement_noise * random.normal();
  placement.y = parameters.placement_noise * random.normal();
  placement.turn = turn * random.normal();
  return placement;
}

SimulatedHand::SimulatedHand(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SimulatedHand::~SimulatedHand() = default;

const BodyDescription& SimulatedHand::description() const {
  return impl_->scene->description;
}

const BodyState& SimulatedHand::state() const {
  return impl_->state;
}

namespace {

// Reads the camera: the silhouette of the object; the centre of the view is above the place of the
// object.
void read_silhouette(SimulatedHand::Impl& impl) {
  const HandScene::Impl& scene = *impl.scene;
  const mjModel& model = *scene.model;
  const mjtNum* place = detail::row_of(impl.data->site_xpos, scene.place, 3);
  const double height = scene.parameters.silhouette_centre * detail::kMetres;
  const detail::ParallelView view =
      detail::view_of_camera(model, *impl.data, "view", {place[0], place[1], place[2] + height},
                             scene.parameters.silhouette_side * detail::kMetres);
  impl.state.readings.push_back(row(
      detail::silhouette(model, *impl.data, scene.object_geom, view, scene.parameters.silhouette)));
}

void read_sensors(SimulatedHand::Impl& impl) {
  const HandScene::Impl& scene = *impl.scene;
  BodyState& state = impl.state;
  state.positions = in_units(scene, impl.driver.positions());
  state.readings.clear();
  if (scene.hand == Hand::kLucs2) {
    const std::span<const double> positions = state.positions;
    state.readings.push_back(row(positions.first(1)));
    state.readings.push_back(row(positions.subspan(1, 1)));
    state.readings.push_back(row(positions.subspan(2)));
  }
  const std::vector<double> angles = servo_angles(*scene.model, *impl.data, count_joints(scene));
  for (Matrix<float>& reading : impl.sensors.read(angles)) {
    state.readings.push_back(std::move(reading));
  }
  if (scene.parameters.true_values) impl.truth.read(angles);
  if (scene.parameters.silhouette > 0) read_silhouette(impl);
}

}  // namespace

Result<std::unique_ptr<SimulatedHand>> SimulatedHand::create(const HandScene& scene,
                                                             const Placement& placement,
                                                             std::uint64_t seed,
                                                             std::uint64_t hand_seed) {
  const auto& parts = scene.shared_impl();
  SOMATO_TRY(auto data, detail::make_data(parts->model));
  auto impl = std::make_unique<Impl>(
      Impl{parts,
           std::move(data),
           detail::ServoDriver(*parts->model, parts->start, parts->parameters.servo_play,
                               Random(seed, Stream::kServoPlay)),
           detail::HandSensors(parts->parameters,
                               {count_joints(*parts), parts->taxels.names.size()}, seed, hand_seed),
           detail::object_pose(*parts, placement),
           std::vector<double>(parts->taxels.names.size(), 0.0),
           0.0,
           BodyState{},
           {}});
  set_joints(*parts->model, parts->start, *impl->data);
  detail::put_object(*parts, impl->placed, *impl->data);
  mj_forward(parts->model.get(), impl->data.get());
  SOMATO_TRY_VOID(detail::check_apart(*parts, *impl->data));
  read_sensors(*impl);
  return std::unique_ptr<SimulatedHand>(new SimulatedHand(std::move(impl)));
}

Result<void> SimulatedHand::check_clear(std::span<const double> positions) const {
  const HandScene::Impl& scene = *impl_->scene;
  require(positions.size() == scene.scales.size(),
          "check_clear: one position for each servo is required");
  SOMATO_TRY(auto data, detail::make_data(scene.model));
  set_joints(*scene.model, in_model(scene, positions), *data);
  detail::put_object(scene, impl_->placed, *data);
  mj_forward(scene.model.get(), data.get());
  return detail::check_apart(scene, *data);
}

void SimulatedHand::keep_true_values() {
  impl_->truth.keep();
}

Result<void> SimulatedHand::drive_to(std::span<const double> targets) {
  impl_->driver.set_targets(in_model(*impl_->scene, targets));
  return {};
}

Result<void> SimulatedHand::pass(double seconds) {
  Impl& impl = *impl_;
  const HandScene::Impl& scene = *impl.scene;
  const mjModel& model = *scene.model;
  const std::span<mjtNum> commands(impl.data->ctrl, static_cast<std::size_t>(model.nu));
  impl.state.time += seconds;
  constexpr std::size_t kStepsBetweenStops = 256;
  std::size_t steps = 0;
  // Half a step of slack, or rounding would leave out a step now and then.
  for (impl.owed += seconds; impl.owed >= 0.5 * model.opt.timestep;
       impl.owed -= model.opt.timestep) {
    impl.driver.step(model, commands);
    mj_step(&model, impl.data.get());
    detail::read_forces(model, *impl.data, scene.taxels, impl.forces);
    impl.sensors.piezo().step(impl.forces, model.opt.timestep);
    if (scene.parameters.true_values) impl.truth.step(impl.forces);
    if (++steps % kStepsBetweenStops != 0) continue;
    SOMATO_TRY_VOID(check_stop());
  }
  if (auto stable = detail::check_stable(*impl.data); !stable) {
    stable.error().where = scene.object.name;
    return stable;
  }
  read_sensors(impl);
  return detail::check_object(scene, impl.placed, *impl.data);
}

}  // namespace somato
