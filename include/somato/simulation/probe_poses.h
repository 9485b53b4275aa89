#pragma once

#include <memory>

#include "somato/bodies/scene.h"

namespace somato {

/// Plays what the probes recorded, one of them or both beside each other, on a slab in the colour
/// of the label `material`; grey where that is missing or not known. nullptr for explorations that
/// do not have one of the channels that the probes record as they are declared: `sound` and
/// `potentiometer`, of one element in counts; the sound at its own rate, for others listen too.
///
/// The stick is where its potentiometer reads, by the declared stroke and bits. No channel tells
/// where the lever is; but a stroke goes at one speed all the way, so that each frame of the sound
/// has its angle. Where there are not as many frames as the declared stroke has, or the reading
/// lies outside the potentiometer's, nobody knows, and the probe rests at 0.
std::unique_ptr<ScenePlayer> play_probes(const Exploration& exploration);

}  // namespace somato
