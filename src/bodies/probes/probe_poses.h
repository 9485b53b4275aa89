#pragma once

#include <memory>

#include "somato/bodies/scene.h"

namespace somato {

/// Plays the recordings of one or both probes on a slab with the colour of the label `material` if
/// a simulated probe explored built-in materials (is_of_built_in_things()), else on a grey one.
/// Returns nullptr for explorations without any of the channels of the probes: `sound` and
/// `potentiometer`, with one element in counts; the sound must have the probe's rate, since other
/// sensors record sound as well.
///
/// The position of the stick is derived from its potentiometer, with the declared stroke and bits.
/// No channel contains the angle of the lever; since a stroke has constant speed, the angle is
/// derived from the number of the frame of the sound. If the number of frames differs from that of
/// the declared stroke, or the reading is outside the potentiometer's range, the pose is unknown,
/// and the probe rests at 0.
std::unique_ptr<ScenePlayer> play_probes(const Exploration& exploration);

}  // namespace somato
