#pragma once

#include <memory>
#include <vector>

#include "somato/bodies/scene.h"
#include "somato/core/result.h"
#include "somato/simulation/simulated_hand.h"

namespace somato {

/// What is drawn of a hand with its object, the table among it; its bodies are those of the model.
Scene scene_of(const HandScene& scene);

/// Where the bodies of its scene are.
std::vector<ScenePose> poses_of(const SimulatedHand& hand);

/// Plays what a hand recorded: it stands as its channels say, `height`, `wrist` and `joints` of
/// Hand II, `joints` of Hand III, whose two outer joints of a finger share the way of their servo
/// as they do while nothing touches. The object is at its place, or without `with_object` is not
/// shown. Throws InvalidArgument in poses() for explorations without these channels.
std::unique_ptr<ScenePlayer> play_hand(const HandScene& scene, bool with_object = true);

/// Whether an exploration has the channels that play_hand() needs.
bool is_of_hand(const Exploration& exploration, Hand hand);

}  // namespace somato
