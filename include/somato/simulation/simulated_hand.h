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

/// The simulated hands: models/lucs_haptic_hand_2.xml and ..._3.xml.
enum class Hand { kLucs2, kLucs3 };

/// A placement drawn with the standard deviations of the parameters.
Placement draw_placement(const SimulationParameters& parameters, Random& random);

/// A hand with an object; immutable, so that any number of threads can simulate it.
class HandScene {
 public:
  /// Builds the scene. Errors: kData if the physics engine refuses the model, for example a mesh
  /// without volume; kUsage for an object that does not fit the hand.
  static Result<HandScene> build(Hand hand, const Object& object,
                                 const SimulationParameters& parameters = {});

  /// The object with the values found in building: size and mass of a mesh.
  const Object& object() const;

  class Impl;
  const std::shared_ptr<const Impl>& shared_impl() const { return impl_; }

 private:
  explicit HandScene(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<const Impl> impl_;
};

/// A simulated hand, moved by its servos (limited in speed, torque, resolution and backlash), with
/// an object.
///
/// Sensors of Hand II: `height` (mm), `wrist` (deg) and `joints` (6, deg) according to the driver;
/// of Hand III: `joints` (11, deg), the potentiometers of its servos. A hand with taxels has:
/// `touch` (N), the normal force on each taxel, not below 0; `touch_change` (N), the same measured
/// by a piezo element with an amplifier: the change within piezo_time. With `silhouette` pixels:
/// `silhouette`, pixels x pixels, the share of each pixel that the object covers, seen by a camera.
class SimulatedHand : public Body {
 public:
  /// An open hand, with the object at its placement; `seed` is the seed of all noise, `hand_seed`
  /// that of the differences between its touch sensors. Errors (kUsage): the open hand collides
  /// with the object.
  static Result<std::unique_ptr<SimulatedHand>> create(const HandScene& scene,
                                                       const Placement& placement,
                                                       std::uint64_t seed,
                                                       std::uint64_t hand_seed = 0);
  SimulatedHand(const SimulatedHand&) = delete;
  SimulatedHand(SimulatedHand&&) = delete;
  SimulatedHand& operator=(const SimulatedHand&) = delete;
  SimulatedHand& operator=(SimulatedHand&&) = delete;
  ~SimulatedHand() override;

  const BodyDescription& description() const override;
  const BodyState& state() const override;

  /// Fails (kUsage) if the hand with its servos at `positions` collides with the object, which then
  /// does not fit it. Does not move the hand. Only for hands whose servos turn their joints
  /// directly (Hand II).
  Result<void> check_clear(std::span<const double> positions) const;

  /// Keeps the true values of the last step, whose readings are recorded: with the parameter
  /// `true_values`.
  void keep_true_values();

  class Impl;
  const Impl& impl() const { return *impl_; }

 protected:
  Result<void> drive_to(std::span<const double> targets) override;
  Result<void> pass(double seconds) override;

 private:
  explicit SimulatedHand(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace somato
