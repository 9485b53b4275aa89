#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "hardware/lines/serial_port.h"
#include "somato/core/result.h"

namespace somato::wire {

/// The process of a recorder, which ends with the object.
class Recorder {
 public:
  explicit Recorder(pid_t process = 0) : process_(process) {}
  Recorder(const Recorder&) = delete;
  Recorder(Recorder&& other) noexcept : process_(std::exchange(other.process_, 0)) {}
  Recorder& operator=(const Recorder&) = delete;
  Recorder& operator=(Recorder&& other) noexcept {
    std::swap(process_, other.process_);
    return *this;
  }
  ~Recorder();

 private:
  pid_t process_;
};

/// An open source of sound.
struct SoundSource {
  Descriptor samples;
  Descriptor words;  ///< The messages of a recorder; not open for a source that has none.
  Recorder recorder;
};

/// Opens a source of sound, from which samples of 16 bits, little-endian, one channel, are read as
/// they arise:
/// - "alsa:DEVICE": a sound device of ALSA, such as "alsa:default", through ALSA's own recorder
///   (arecord, of the Debian package alsa-utils);
/// - "wav:FILE": a WAV file of one channel, played once in the time of its samples;
/// - "raw:FILE": a file or pipe with nothing but samples.
/// Errors (kUsage): another kind of source; (kSystem): it cannot be opened; (kData): a WAV file of
/// another kind or with another rate than `rate`.
Result<SoundSource> open_sound(const std::string& source, double rate);

/// The fault that the messages of ALSA's recorder at `source` report, in English: another rate than
/// it should have, samples that it lost, a device that is in use; nothing for other messages.
std::optional<Error> fault_in_words(std::string_view words, const std::string& source);

/// The error (kSystem) of a source that has ended, with the last of those messages.
Error ended_sound(std::string_view words, const std::string& source);

}  // namespace somato::wire
