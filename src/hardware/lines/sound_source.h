#pragma once

#include <string>

#include "hardware/lines/serial_port.h"
#include "somato/core/result.h"

namespace somato::wire {

/// Opens a source of sound, from which samples of 16 bits, little-endian, one channel, are read as
/// they arise:
/// - "alsa:DEVICE": a sound device of ALSA, such as "alsa:default", through ALSA's own recorder
///   (arecord, of the Debian package alsa-utils);
/// - "wav:FILE": a WAV file of 16 bits and one channel, played once in the time of its samples;
/// - "raw:FILE": a file or pipe with nothing but samples.
/// Errors (kUsage): another kind of source; (kSystem): it cannot be opened; (kData): a WAV file of
/// another kind or with another rate than `rate`.
Result<Descriptor> open_sound(const std::string& source, double rate);

}  // namespace somato::wire
