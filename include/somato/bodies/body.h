#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// Properties of a servo of a body: a hinge in deg, a slide in mm.
struct DegreeOfFreedom {
  std::string name;  ///< Such as "wrist" or "finger1_proximal".
  std::string unit;  ///< "deg" or "mm".
  double least = 0.0;
  double most = 0.0;
  double fastest = 0.0;  ///< Units per second.
};

/// The description of a body, for code that moves it.
struct BodyDescription {
  std::string name;
  std::vector<DegreeOfFreedom> degrees_of_freedom;
  /// Its sensors. A sensor with a rate samples on its own clock, the others once per step.
  std::vector<ChannelDescription> sensors;
};

/// The readings of a body at one moment.
struct BodyState {
  double time = 0.0;  ///< Seconds since the body was created.
  std::vector<double>
      positions;  ///< The position to which each servo has been driven so far, according to the
                  ///< driver: on the way to its target, in the unit of the servo.
  /// For each sensor the frames recorded during the last step: frames x elements. A sensor without
  /// a rate has one, recorded at the end of the step. A reading that is missing is NaN.
  std::vector<Matrix<float>> readings;
  /// For each sensor the times of these frames, in order, if they are not those of the step: the
  /// sensor may then give any number of frames in a step, without a rate. Empty for the others;
  /// empty as a whole if there is no such sensor.
  std::vector<std::vector<double>> times = {};
};

/// Whether the readings of a step belong to the exploration, unlike those between two grasps.
enum class Readings { kLeftOut, kRecorded };

/// Called after each step of a body, which waits until it returns. An error ends the step with that
/// error.
using AfterStep = std::function<Result<void>(Readings readings)>;

/// Limits of an exploration.
struct BodyLimits {
  double longest = std::numeric_limits<double>::infinity();  ///< Seconds of the body's time.
  std::function<bool()> should_continue =
      {};  ///< Called regularly; if it returns false, the exploration ends.
  /// Bytes of the frames that an exploration collects. One with more has no frames at its end: its
  /// observer has received them.
  std::size_t memory = std::numeric_limits<std::size_t>::max();
};

/// A body with servos and sensors. Code that explores only uses this interface: the implementation
/// may be a simulation, or real servos and sensors.
class Body {
 public:
  Body() = default;
  Body(const Body&) = delete;
  Body(Body&&) = delete;
  Body& operator=(const Body&) = delete;
  Body& operator=(Body&&) = delete;
  virtual ~Body() = default;

  virtual const BodyDescription& description() const = 0;
  virtual const BodyState& state() const = 0;

  /// Sets the target position of each servo, one for each degree of freedom in its unit; the servos
  /// move there at their own speed during steps. Errors (kData) name the servo whose target is
  /// beyond its limits or is not finite; no target changes then. Throws InvalidArgument for a wrong
  /// number of targets.
  Result<void> command(std::span<const double> targets);

  /// Advances by `seconds`, then calls the observer. Throws InvalidArgument unless they are above
  /// 0. Errors: kData if its limits leave less time, kInterrupted if they stop it; external
  /// failures, such as a simulation that diverged or a device that does not answer; those of the
  /// observer. The body cannot be used afterwards.
  Result<void> step(double seconds, Readings readings = Readings::kLeftOut);

  /// Sets the limits for step(); initially a body has none.
  void keep_to(BodyLimits limits) { limits_ = std::move(limits); }

  const BodyLimits& limits() const { return limits_; }

  /// Sets a function that is called after each step.
  void observe(AfterStep after_step) { after_step_ = std::move(after_step); }

 protected:
  /// Fails (kInterrupted) if its limits stop it; pass() should call it regularly.
  Result<void> check_stop() const;

  virtual Result<void> drive_to(std::span<const double> targets) = 0;
  virtual Result<void> pass(double seconds) = 0;

 private:
  BodyLimits limits_;
  AfterStep after_step_;
};

/// The index of the degree of freedom with that name; an unknown name is an error (kUsage) with the
/// nearest known one.
Result<std::size_t> find_degree_of_freedom(const BodyDescription& description,
                                           std::string_view name);
/// The same for a sensor.
Result<std::size_t> find_sensor(const BodyDescription& description, std::string_view name);

}  // namespace somato
