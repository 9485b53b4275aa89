#include "hardware/emulation/emulated_body.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "hardware/buses/bus_kind.h"
#include "hardware/emulation/sensor_board.h"
#include "somato/core/check.h"

namespace somato::emulation {
namespace {

constexpr double kStep = 0.005;          // s; the boards are slower than that
constexpr double kMilliamperes = 100.0;  // per newton on a servo's own taxels

std::unique_ptr<EmulatedSensors> sensor_board(const devices::FrameLine& line) {
  SensorBoardSettings settings;
  settings.elements = line.elements;
  settings.rate = line.rate;
  settings.format = line.format;
  return std::make_unique<SensorBoard>(settings);
}

}  // namespace

EmulatedBody::EmulatedBody(devices::DeviceFile file, std::unique_ptr<Body> body)
    : file_(std::move(file)), body_(std::move(body)), stuck_(file_.servos.size(), 0) {
  if (file_.servo_line) {
    servos_ = devices::traits_of(file_.servo_line->bus).emulated(file_.bus_servos());
    wires_.push_back(
        std::make_unique<EmulatedWire>(*servos_, static_cast<double>(file_.servo_line->baud), 1));
  }
  if (file_.frame_line) {
    sensors_ = sensor_board(*file_.frame_line);
    frame_.resize(file_.frame_line->elements);
    wires_.push_back(
        std::make_unique<EmulatedWire>(*sensors_, static_cast<double>(file_.frame_line->baud), 2));
  }
  if (file_.microphone) {
    sound_.emplace();
    wires_.push_back(std::make_unique<EmulatedWire>(*sound_, 0.0, 3));
  }
  for (const devices::ServoSettings& servo : file_.servos) {
    const auto found = find_degree_of_freedom(body_->description(), servo.name);
    require(found.has_value(), "EmulatedBody: the body lacks a servo of the device");
    servo_of_.push_back(*found);
  }
  sense();
}

std::vector<EmulatedWire*> EmulatedBody::wires() {
  std::vector<EmulatedWire*> wires;
  wires.reserve(wires_.size());
  for (const auto& wire : wires_) wires.push_back(wire.get());
  return wires;
}

EmulatedServos& EmulatedBody::servos() {
  require(servos_ != nullptr, "the device has no servos");
  return *servos_;
}

std::size_t EmulatedBody::servos_on() const {
  std::size_t on = 0;
  for (std::size_t i = 0; i < file_.servos.size(); ++i) on += servos_->driven_position(i) ? 1 : 0;
  return on;
}

void EmulatedBody::replace(std::unique_ptr<Body> body) {
  body_ = std::move(body);
  sense();
}

// A servo without a pulse, or without torque, keeps its position: its gears do not turn back.
double EmulatedBody::target(std::size_t servo) const {
  const std::size_t own = servo_of_[servo];
  const auto driven = servos_->driven_position(servo);
  if (!driven || stuck_[servo] != 0) return body_->state().positions[own];
  return file_.servos[servo].from_bus(*driven);
}

Result<void> EmulatedBody::drive() {
  targets_ = body_->state().positions;
  for (std::size_t i = 0; i < servo_of_.size(); ++i) targets_[servo_of_[i]] = target(i);
  // The servos have ends, whatever the controller says.
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const DegreeOfFreedom& servo = body_->description().degrees_of_freedom[i];
    targets_[i] = std::clamp(targets_[i], servo.least, servo.most);
  }
  return body_->command(targets_);
}

// The frames of the last step of a sensor; without rows before the first one.
const Matrix<float>& EmulatedBody::readings_of(std::size_t sensor) const {
  static const Matrix<float> none;
  const auto& readings = body_->state().readings;
  return sensor < readings.size() ? readings[sensor] : none;
}

double EmulatedBody::current(std::size_t servo) const {
  const auto touch = find_sensor(body_->description(), "touch");
  if (!touch) return 0.0;
  const std::string name = file_.servos[servo].name + "_";
  const std::vector<std::string>& elements = body_->description().sensors[*touch].element_names;
  const Matrix<float>& forces = readings_of(*touch);
  double force = 0.0;
  for (std::size_t i = 0; i < elements.size() && forces.rows() > 0; ++i) {
    if (elements[i].starts_with(name)) force += static_cast<double>(forces(0, i));
  }
  return kMilliamperes * force;
}

void EmulatedBody::measure() {
  for (std::size_t i = 0; i < servo_of_.size(); ++i) {
    const double position = body_->state().positions[servo_of_[i]];
    servos_->set_measured(i, file_.servos[i].on_bus(position), current(i));
  }
}

void EmulatedBody::sense() {
  measure();
  for (const devices::SensorSettings& sensor : file_.sensors) {
    const auto found = find_sensor(body_->description(), sensor.name);
    if (!found) continue;
    const Matrix<float>& readings = readings_of(*found);
    if (readings.rows() == 0) continue;
    const auto raw = [&](float value) {
      return static_cast<float>((static_cast<double>(value) - sensor.offset) / sensor.gain);
    };
    if (sensor.from == devices::SensorOrigin::kMicrophone) {
      for (const float value : readings.values()) sound_->add(raw(value));
    }
    if (sensor.from != devices::SensorOrigin::kFrames) continue;
    const std::span<const float> last = readings.row(readings.rows() - 1);
    require(last.size() == devices::elements_of(sensor),
            "EmulatedBody: a sensor of the body has other elements than that of the device");
    std::transform(last.begin(), last.end(),
                   frame_.begin() + static_cast<std::ptrdiff_t>(sensor.first), raw);
  }
  if (sensors_) sensors_->set_values(frame_);
}

Result<void> EmulatedBody::step() {
  SOMATO_TRY_VOID(drive());
  SOMATO_TRY_VOID(body_->step(kStep));
  sense();
  return {};
}

Result<void> EmulatedBody::advance(double now) {
  while (done_ + kStep <= now) {
    done_ += kStep;
    SOMATO_TRY_VOID(step());
  }
  for (const auto& wire : wires_) wire->advance(now);
  return {};
}

}  // namespace somato::emulation
