#include "hardware/devices/safe_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "somato/core/check.h"

namespace somato::devices {

SafeMotion::SafeMotion(std::span<const ServoSettings> servos)
    : servos_(servos.begin(), servos.end()),
      positions_(servos.size()),
      targets_(servos.size()),
      on_(servos.size(), 0),
      on_bus_(servos.size()) {
  for (std::size_t i = 0; i < servos.size(); ++i) positions_[i] = servos_[i].resting();
  targets_ = sent_ = positions_;
}

void SafeMotion::begin(std::span<const double> positions) {
  require(positions.size() == servos_.size(), "SafeMotion: one position for each servo");
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    on_[i] = std::isfinite(positions[i]) ? 1 : 0;
    positions_[i] = std::isfinite(positions[i])
                        ? std::clamp(positions[i], servos_[i].least, servos_[i].most)
                        : servos_[i].resting();
  }
  targets_ = sent_ = positions_;
}

void SafeMotion::switch_on(std::size_t servo) {
  on_.at(servo) = 1;
}

void SafeMotion::set_targets(std::span<const double> targets) {
  require(targets.size() == servos_.size(), "SafeMotion: one target for each servo");
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    if (!std::isfinite(targets[i])) continue;
    targets_[i] = std::clamp(targets[i], servos_[i].least, servos_[i].most);
  }
}

void SafeMotion::note_sent() {
  std::copy(positions_.begin(), positions_.end(), sent_.begin());
}

void SafeMotion::hold() {
  std::copy(sent_.begin(), sent_.end(), positions_.begin());
  std::copy(sent_.begin(), sent_.end(), targets_.begin());
}

std::span<const double> SafeMotion::advance(double seconds) {
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    const double most = servos_[i].fastest * std::max(0.0, seconds);
    const double way = targets_[i] - positions_[i];
    // Assigned, not added up: the target is reached exactly.
    positions_[i] = std::abs(way) <= most ? targets_[i] : positions_[i] + std::copysign(most, way);
    on_bus_[i] =
        on_[i] != 0 ? servos_[i].on_bus(positions_[i]) : std::numeric_limits<double>::quiet_NaN();
  }
  return on_bus_;
}

}  // namespace somato::devices
