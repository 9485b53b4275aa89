#include "somato/simulation/simulated_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/simulated_hand_works.h"
#include "somato/core/check.h"

namespace somato {
namespace {

std::vector<double> in_units(const HandScene::Parts& scene, std::span<const double> positions) {
  std::vector<double> units(positions.size());
  for (std::size_t i = 0; i < units.size(); ++i) units[i] = positions[i] / scene.scales[i];
  return units;
}

std::vector<double> in_model(const HandScene::Parts& scene, std::span<const double> positions) {
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

std::vector<double> noisy(const std::vector<double>& values, double deviation, Random& noise) {
  std::vector<double> read(values.size());
  for (std::size_t i = 0; i < read.size(); ++i) read[i] = values[i] + deviation * noise.normal();
  return read;
}

// What touch sensors report of what their converters read.
std::vector<double> reported(std::vector<double> read, PiezoConverter converter, double threshold) {
  for (double& value : read) {
    if (converter == PiezoConverter::kUnipolar) value = std::max(0.0, value);
    if (std::abs(value) < threshold) value = 0.0;
  }
  return read;
}

// The potentiometers inside the servos of Hand III, in deg.
std::vector<double> servo_angles(const mjModel& model, const mjData& data) {
  std::vector<double> angles(static_cast<std::size_t>(model.nsensor));
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

SimulatedHand::SimulatedHand(std::unique_ptr<Works> works) : works_(std::move(works)) {}
SimulatedHand::~SimulatedHand() = default;

const BodyDescription& SimulatedHand::description() const {
  return works_->scene->description;
}

const BodyState& SimulatedHand::state() const {
  return works_->state;
}

namespace {

void read_sensors(SimulatedHand::Works& works) {
  const HandScene::Parts& scene = *works.scene;
  BodyState& state = works.state;
  state.positions = in_units(scene, works.driver.positions());
  state.readings.clear();
  if (scene.hand == Hand::kLucs2) {
    const std::span<const double> positions = state.positions;
    state.readings.push_back(row(positions.first(1)));
    state.readings.push_back(row(positions.subspan(1, 1)));
    state.readings.push_back(row(positions.subspan(2)));
  } else {
    state.readings.push_back(row(
        noisy(servo_angles(*scene.model, *works.data), scene.parameters.joint_noise, works.noise)));
  }
  if (works.forces.empty()) return;
  const SimulationParameters& given = scene.parameters;
  const auto report = [&](const std::vector<double>& sensed, PiezoConverter converter) {
    state.readings.push_back(row(reported(noisy(sensed, given.sensor_noise, works.noise), converter,
                                          given.touch_threshold)));
  };
  report(works.forces, PiezoConverter::kUnipolar);  // no contact pulls
  report(works.piezo.signals(), given.piezo_converter);
}

}  // namespace

Result<std::unique_ptr<SimulatedHand>> SimulatedHand::create(const HandScene& scene,
                                                             const Placement& placement,
                                                             std::uint64_t seed) {
  const auto& parts = scene.shared_parts();
  auto data = detail::make_data(parts->model);
  if (!data) return fail(std::move(data.error()));
  auto works = std::make_unique<Works>(
      Works{parts, std::move(*data),
            detail::ServoDriver(*parts->model, parts->start, parts->parameters.servo_play,
                                Random(seed, Stream::kServoPlay)),
            detail::PiezoElements(parts->taxels.names.size(), parts->parameters.piezo_time),
            detail::object_pose(*parts, placement), Random(seed, Stream::kHandSensors),
            std::vector<double>(parts->taxels.names.size(), 0.0), 0.0, BodyState{}});
  set_joints(*parts->model, parts->start, *works->data);
  detail::put_object(*parts, works->placed, *works->data);
  mj_forward(parts->model.get(), works->data.get());
  if (auto apart = detail::check_apart(*parts, *works->data); !apart)
    return fail(std::move(apart.error()));
  read_sensors(*works);
  return std::unique_ptr<SimulatedHand>(new SimulatedHand(std::move(works)));
}

Result<void> SimulatedHand::check_clear(std::span<const double> positions) const {
  const HandScene::Parts& scene = *works_->scene;
  require(positions.size() == scene.scales.size(), "check_clear: one position for each servo");
  auto data = detail::make_data(scene.model);
  if (!data) return fail(std::move(data.error()));
  set_joints(*scene.model, in_model(scene, positions), **data);
  detail::put_object(scene, works_->placed, **data);
  mj_forward(scene.model.get(), data->get());
  return detail::check_apart(scene, **data);
}

Result<void> SimulatedHand::drive_to(std::span<const double> targets) {
  works_->driver.set_targets(in_model(*works_->scene, targets));
  return {};
}

Result<void> SimulatedHand::pass(double seconds) {
  Works& works = *works_;
  const HandScene::Parts& scene = *works.scene;
  const mjModel& model = *scene.model;
  const std::span<mjtNum> commands(works.data->ctrl, static_cast<std::size_t>(model.nu));
  works.state.time += seconds;
  constexpr std::size_t kStepsBetweenStops = 256;
  std::size_t steps = 0;
  // Half a step of slack, or rounding would leave out a step now and then.
  for (works.owed += seconds; works.owed >= 0.5 * model.opt.timestep;
       works.owed -= model.opt.timestep) {
    works.driver.step(model, commands);
    mj_step(&model, works.data.get());
    detail::read_forces(model, *works.data, scene.taxels, works.forces);
    works.piezo.step(works.forces, model.opt.timestep);
    if (++steps % kStepsBetweenStops != 0) continue;
    if (auto goes_on = check_stop(); !goes_on) return goes_on;
  }
  if (auto stable = detail::check_stable(*works.data); !stable) {
    stable.error().where = scene.object.name;
    return stable;
  }
  read_sensors(works);
  return detail::check_object(scene, works.placed, *works.data);
}

}  // namespace somato
