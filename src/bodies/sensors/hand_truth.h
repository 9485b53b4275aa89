#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bodies/sensors/exploration_draws.h"
#include "somato/recording/recording.h"

namespace somato::detail {

/// The quantities that the sensors of a hand measure during an exploration: its true joint angles
/// at the recorded readings, and the force on each taxel whenever it changes, also between these
/// readings.
class HandTruth {
 public:
  /// A recorded reading.
  struct Moment {
    std::uint64_t readings = 0;  ///< Readings before it, recorded or not.
    std::uint64_t steps = 0;     ///< Steps of the physics before it.
    std::vector<double> joints;  ///< deg, of the potentiometers.
    std::vector<double> forces;  ///< N, of the taxels.
  };

  /// The force on a taxel changes in a step of the physics.
  struct Contact {
    std::uint64_t step = 0;  ///< From 1.
    std::size_t taxel = 0;
    double force = 0.0;  ///< N.
  };

  /// A step of the physics ends with these forces.
  void step(const std::vector<double>& forces);

  /// The sensors are read.
  void read(const std::vector<double>& joints);

  /// The last reading is recorded.
  void keep();

  const std::vector<Moment>& moments() const { return moments_; }
  const std::vector<Contact>& contacts() const { return contacts_; }

  /// Adds the true channels: `true_readings`; with names of joints `true_joints`; with names of
  /// taxels `true_force` and `true_contacts`.
  void add_to(Exploration& exploration, const std::vector<std::string>& joints,
              const std::vector<std::string>& taxels) const;

  /// The truth in the channels of an exploration, without the forces of moments. Errors (kData):
  /// channels that add_to() does not write.
  static Result<HandTruth> of(const Exploration& exploration);

 private:
  void add_contacts(Exploration& exploration) const;
  Result<void> read_moments(const Exploration& exploration);
  Result<void> read_contacts(const Exploration& exploration);

  std::uint64_t readings_ = 0;
  std::uint64_t steps_ = 0;
  std::vector<double> joints_;  // of the last reading
  std::vector<double> forces_;
  std::vector<Moment> moments_;
  std::vector<Contact> contacts_;
};

/// Whether the exploration is one of a hand with true values.
bool has_hand_truth(const Exploration& exploration);

}  // namespace somato::detail
