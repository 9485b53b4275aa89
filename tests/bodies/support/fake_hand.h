#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "somato/bodies/body.h"

namespace somato {

/// A hand without physics: servos move directly to their targets at maximum speed, and the readings
/// of the sensors are a function of the servos' positions.
class FakeHand : public Body {
 public:
  /// The reading of a sensor at these positions. With a rate, the last frame of a step has the
  /// current positions, the others the previous ones.
  using Feel = std::function<std::vector<float>(const std::vector<double>& positions)>;

  explicit FakeHand(std::string name) { description_.name = std::move(name); }

  void add_servo(DegreeOfFreedom servo, double start) {
    description_.degrees_of_freedom.push_back(std::move(servo));
    state_.positions.push_back(start);
    targets_.push_back(start);
  }
  void add_sensor(ChannelDescription sensor, Feel feel) {
    description_.sensors.push_back(std::move(sensor));
    feels_.push_back(std::move(feel));
  }

  /// The servos never go further than a stop at these positions, whatever their targets.
  std::vector<double> stops;
  /// The servos move at these speeds, whatever their targets; 0: they obey.
  std::vector<double> drifts;
  /// The step, counting from 1, that fails; 0: none does.
  std::size_t failing_step = 0;
  /// The commands, and the positions of the servos after each step.
  std::vector<std::vector<double>> commands;
  std::vector<std::vector<double>> path;
  std::vector<double> steps;

  const BodyDescription& description() const override { return description_; }
  const BodyState& state() const override { return state_; }

 protected:
  Result<void> drive_to(std::span<const double> targets) override {
    targets_.assign(targets.begin(), targets.end());
    commands.push_back(targets_);
    return {};
  }

  Result<void> pass(double seconds) override {
    steps.push_back(seconds);
    if (steps.size() == failing_step) {
      return fail(ErrorKind::kData, "the simulation diverged", "", "");
    }
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const double way = description_.degrees_of_freedom[i].fastest * seconds;
      double& at = state_.positions[i];
      const double from = at;
      at = std::clamp(targets_[i], at - way, at + way);
      if (!stops.empty()) at = std::min(at, stops[i]);
      if (!drifts.empty() && drifts[i] != 0.0) at = from + drifts[i] * seconds;
    }
    const double before = state_.time;
    state_.time += seconds;
    path.push_back(state_.positions);
    feel(before);
    return {};
  }

 private:
  // How many frames a clock has given until then; the sums of its steps are not exact.
  static std::size_t frames_at(double rate, double time) {
    return static_cast<std::size_t>(rate * time + 1e-6);
  }

  void feel(double before) {
    state_.readings.clear();
    for (std::size_t i = 0; i < feels_.size(); ++i) {
      const std::vector<float> frame = feels_[i](state_.positions);
      const double rate = description_.sensors[i].rate;
      const auto rows = rate == 0.0 ? 1 : frames_at(rate, state_.time) - frames_at(rate, before);
      Matrix<float> frames(rows, frame.size());
      for (std::size_t row = 0; row + 1 < rows; ++row) {
        const std::vector<float> earlier = feels_[i](path[path.size() < 2 ? 0 : path.size() - 2]);
        std::copy(earlier.begin(), earlier.end(), frames.row(row).begin());
      }
      if (rows > 0) std::copy(frame.begin(), frame.end(), frames.row(rows - 1).begin());
      state_.readings.push_back(std::move(frames));
    }
  }

  BodyDescription description_;
  BodyState state_;
  std::vector<double> targets_;
  std::vector<Feel> feels_;
};

/// Taxels of a spring: so much for each deg beyond the wall.
inline float pressed(double angle, double wall, double stiffness) {
  return static_cast<float>(std::max(0.0, angle - wall) * stiffness);
}

/// Servos of a hand's finger: proximal 0 to 30 deg, distal -80 to 30 deg, both fast.
inline void add_finger(FakeHand& hand, const std::string& name, double fastest = 300.0) {
  hand.add_servo({name + "_proximal", "deg", 0, 30, fastest}, 0);
  hand.add_servo({name + "_distal", "deg", -80, 30, fastest}, 0);
}

}  // namespace somato
