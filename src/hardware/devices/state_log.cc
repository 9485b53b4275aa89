#include "hardware/devices/state_log.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <utility>

#include "somato/core/check.h"

namespace somato::devices {
namespace {

std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{:g}", value) : std::string();
}

}  // namespace

StateLog::StateLog(std::vector<std::string> servos) : names_(std::move(servos)), states_(kStates) {
  for (State& state : states_) state.servos.resize(names_.size());
}

void StateLog::add(double time, std::span<const double> targets, std::span<const double> positions,
                   std::span<const ServoReport> reports, double frame_age) {
  require(targets.size() == names_.size() && positions.size() == names_.size() &&
              reports.size() == names_.size(),
          "StateLog: one value for each servo");
  State& state = states_[count_++ % kStates];
  state.time = time;
  state.frame_age = frame_age;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    state.servos[i] = {targets[i], positions[i], reports[i]};
  }
}

std::string StateLog::to_csv() const {
  std::string text = "time,frame_age";
  for (const std::string& name : names_) {
    fmt::format_to(std::back_inserter(text),
                   ",{0} target,{0} position,{0} reported,{0} current,{0} error", name);
  }
  text += '\n';
  for (std::size_t i = count_ - size(); i < count_; ++i) {
    const State& state = states_[i % kStates];
    fmt::format_to(std::back_inserter(text), "{:.4f},{}", state.time, cell(state.frame_age));
    for (const Servo& servo : state.servos) {
      fmt::format_to(std::back_inserter(text), ",{},{},{},{},{}", cell(servo.target),
                     cell(servo.position), cell(servo.report.position), cell(servo.report.current),
                     servo.report.error);
    }
    text += '\n';
  }
  return text;
}

}  // namespace somato::devices
