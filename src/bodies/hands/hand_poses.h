#pragma once

#include <memory>
#include <vector>

#include "somato/bodies/scene.h"
#include "somato/core/result.h"
#include "somato/simulation/simulated_hand.h"

namespace somato {

/// The scene of a hand with its object, including the table; its bodies are those of the model.
Scene scene_of(const HandScene& scene);

/// The poses of the bodies of its scene.
std::vector<ScenePose> poses_of(const SimulatedHand& hand);

/// Plays the recording of a hand: its pose follows its channels, `height`, `wrist` and `joints` of
/// Hand II, `joints` of Hand III, whose two outer joints of a finger share the travel of their
/// servo as they do without contact. A joint whose value is missing stays where it was last known
/// to be, or is where it first becomes known. The object is at its default position, or is not
/// shown without `with_object`. Throws InvalidArgument in poses() for explorations without these
/// channels.
std::unique_ptr<ScenePlayer> play_hand(const HandScene& scene, bool with_object = true);

/// Whether an exploration has the channels that play_hand() needs.
bool is_of_hand(const Exploration& exploration, Hand hand);

}  // namespace somato
