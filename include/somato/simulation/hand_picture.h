#pragma once

#include <string>

#include "somato/simulation/simulated_hand.h"

namespace somato {

/// Draws the hand and its object as they stand into a PNG file, from the camera of the hand's
/// model; taxels that feel something are marked. Needs no display. Errors: kSystem with the
/// system's reason.
Result<void> save_hand_picture(const SimulatedHand& hand, const std::string& path);

}  // namespace somato
