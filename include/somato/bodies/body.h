#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/recording/channel_description.h"

namespace somato {

/// What a servo of a body can do: a hinge in deg, a slide in mm.
struct DegreeOfFreedom {
  std::string name;  ///< Such as "wrist" or "finger1_proximal".
  std::string unit;  ///< "deg" or "mm".
  double least = 0.0;
  double most = 0.0;
  double fastest = 0.0;  ///< Units a second.
};

/// What a body is made of, for whoever moves it.
struct BodyDescription {
  std::string name;
  std::vector<DegreeOfFreedom> degrees_of_freedom;
  /// What it feels. A sensor with a rate samples on its own clock, the others once a step.
  std::vector<ChannelDescription> sensors;
};

/// What a body knows about itself at one moment.
struct BodyState {
  double time = 0.0;              ///< Seconds since it came to be.
  std::vector<double> positions;  ///< Where each servo has been driven to so far, as the driver
                                  ///< knows: on the way to its target, in the unit of the servo.
  /// For each sensor the frames taken during the last step: frames x elements. A sensor without a
  /// rate has one, taken at the end of the step.
  std::vector<Matrix<float>> readings;
};

/// What ends an exploration that takes too long.
struct BodyLimits {
  double longest = std::numeric_limits<double>::infinity();  ///< Seconds of the body's time.
  std::function<bool()> goes_on = {};  ///< Called now and then; when it returns false all ends.
};

/// A body that moves and feels. What explores with it knows no more than this: a simulation may
/// stand behind it, or servos and sensors on a table.
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

  /// Sets where each servo is to go, a target for each degree of freedom in its unit; they go there
  /// at their own pace while steps pass. Errors (kData) name the servo whose target lies beyond its
  /// limits or is not finite: then no target changes. Throws InvalidArgument for another number of
  /// targets.
  Result<void> command(std::span<const double> targets);

  /// Lets `seconds` pass. Throws InvalidArgument unless they are above 0. Errors: kData when its
  /// limits leave it less time, kInterrupted when they stop it; what went wrong in the world, such
  /// as a simulation that diverged or a device that does not answer. The body is then of no more
  /// use.
  Result<void> step(double seconds);

  /// From now on step() keeps to `limits`; without, a body has none.
  void keep_to(BodyLimits limits) { limits_ = std::move(limits); }

 protected:
  /// Fails (kInterrupted) when its limits stop it: for pass() to call now and then.
  Result<void> check_stop() const;

  virtual Result<void> drive_to(std::span<const double> targets) = 0;
  virtual Result<void> pass(double seconds) = 0;

 private:
  BodyLimits limits_;
};

/// The index of the degree of freedom, or sensor, of that name; an unknown name is an error
/// (kUsage) with the nearest known one.
Result<std::size_t> find_degree_of_freedom(const BodyDescription& description,
                                           std::string_view name);
Result<std::size_t> find_sensor(const BodyDescription& description, std::string_view name);

}  // namespace somato
