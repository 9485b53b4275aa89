#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "bodies/probes/tick_clock.h"
#include "somato/bodies/body.h"

namespace somato::detail {

/// A body of one servo, at 0 to begin with, and one sensor of one element, that lives in ticks: how
/// callers cut time into steps changes nothing.
class ProbeBody : public Body {
 public:
  const BodyDescription& description() const override { return description_; }
  const BodyState& state() const override { return state_; }

 protected:
  ProbeBody(std::string name, DegreeOfFreedom servo, ChannelDescription sensor, double tick_rate)
      : clock_(tick_rate), most_per_tick_(servo.fastest / tick_rate) {
    description_.name = std::move(name);
    description_.degrees_of_freedom = {std::move(servo)};
    description_.sensors = {std::move(sensor)};
    state_.positions = {0.0};
    state_.readings = {Matrix<float>(0, 1)};
  }

  /// Advances by one tick.
  virtual void tick() = 0;

  /// The frames of the step that ends, one element each.
  virtual Matrix<float> read() = 0;

  bool is_driven() const { return state_.positions[0] != target_; }

  /// Takes the servo towards its target for a tick, at its fastest; where it is then.
  double drive() {
    double& driven = state_.positions[0];
    driven += std::clamp(target_ - driven, -most_per_tick_, most_per_tick_);
    return driven;
  }

  Result<void> drive_to(std::span<const double> targets) override {
    target_ = targets[0];
    return {};
  }

  Result<void> pass(double seconds) override {
    constexpr std::int64_t kTicksBetweenStops = 1 << 16;
    for (std::int64_t due = clock_.pass(seconds); due > 0; --due) {
      tick();
      if (due % kTicksBetweenStops != 0) continue;
      SOMATO_TRY_VOID(check_stop());
    }
    state_.readings[0] = read();
    state_.time = clock_.time();
    return {};
  }

 private:
  BodyDescription description_;
  BodyState state_;
  TickClock clock_;
  double most_per_tick_;
  double target_ = 0.0;
};

}  // namespace somato::detail
