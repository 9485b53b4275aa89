#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "somato/simulation/simulated_hand.h"

namespace somato {

/// Writes a picture of the hand and its object as a PNG file, from the camera of the hand's model;
/// taxels with contact are marked. Does not require a display. Errors: kSystem with the system's
/// reason.
Result<void> save_hand_picture(const SimulatedHand& hand, const std::string& path);

/// A folder for pictures of the grasps of explorations, which several threads can save. A picture
/// that cannot be saved is counted and does not end the exploration.
class GraspPictures {
 public:
  explicit GraspPictures(std::string folder) : folder_(std::move(folder)) {}

  /// Saves THING-TRIAL-GRASP.png, the numbers from 1 on; they are given from 0 on.
  void save(const SimulatedHand& hand, const std::string& thing, std::size_t trial,
            std::size_t grasp);

  /// The number of pictures that could not be saved, and the first error.
  std::size_t lost() const { return lost_; }
  const std::optional<Error>& first_error() const { return first_error_; }

 private:
  std::string folder_;
  std::mutex mutex_;
  std::size_t lost_ = 0;
  std::optional<Error> first_error_;
};

}  // namespace somato
