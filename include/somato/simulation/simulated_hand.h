#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "somato/bodies/body.h"
#include "somato/bodies/object.h"
#include "somato/bodies/placement.h"
#include "somato/core/random.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato {

/// The hands that can be simulated: models/lucs_haptic_hand_2.xml and ..._3.xml.
enum class Hand { kLucs2, kLucs3 };

/// A placement drawn with the standard deviations of the parameters.
Placement draw_placement(const SimulationParameters& parameters, Random& random);

/// A hand with an object before it: constant, so that any number of threads can simulate it.
class HandScene {
 public:
  /// Puts the two together. Errors: kData for what the physics engine refuses, such as a mesh
  /// without volume; kUsage for an object that does not fit the hand.
  static Result<HandScene> build(Hand hand, const Object& object,
                                 const SimulationParameters& parameters = {});

  /// The object with what building found out: size and mass of a mesh.
  const Object& object() const;

  class Parts;
  const std::shared_ptr<const Parts>& shared_parts() const { return parts_; }

 private:
  explicit HandScene(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}
  std::shared_ptr<const Parts> parts_;
};

/// A simulated hand, moved by its servos (pace, torque, resolution and play limited) and touching
/// what stands before it.
///
/// Sensors of Hand II: `height` (mm), `wrist` (deg) and `joints` (6, deg) as the driver knows them;
/// of Hand III: `joints` (11, deg), the potentiometers inside its servos. Of a hand with taxels:
/// `touch` (N), the normal force on each taxel alone, not below 0; `touch_change` (N), the same as
/// a piezo element with its amplifier gives it: what changed within piezo_time.
class SimulatedHand : public Body {
 public:
  /// A hand, open, with the object at its placement; `seed` is that of all noise. Errors (kUsage):
  /// the open hand meets the object there.
  static Result<std::unique_ptr<SimulatedHand>> create(const HandScene& scene,
                                                       const Placement& placement,
                                                       std::uint64_t seed);
  SimulatedHand(const SimulatedHand&) = delete;
  SimulatedHand(SimulatedHand&&) = delete;
  SimulatedHand& operator=(const SimulatedHand&) = delete;
  SimulatedHand& operator=(SimulatedHand&&) = delete;
  ~SimulatedHand() override;

  const BodyDescription& description() const override;
  const BodyState& state() const override;

  /// Fails (kUsage) when the hand with its servos at `positions` meets the object, which then does
  /// not fit it. Moves nothing. Only for hands whose servos turn their joints directly (Hand II).
  Result<void> check_clear(std::span<const double> positions) const;

  class Works;
  const Works& works() const { return *works_; }

 protected:
  Result<void> drive_to(std::span<const double> targets) override;
  Result<void> pass(double seconds) override;

 private:
  explicit SimulatedHand(std::unique_ptr<Works> works);
  std::unique_ptr<Works> works_;
};

}  // namespace somato
