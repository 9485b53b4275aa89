#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hardware/buses/sensor_stream.h"
#include "hardware/buses/servo_bus.h"
#include "hardware/device_files/device_file.h"
#include "hardware/devices/device_lines.h"
#include "hardware/devices/sample_clock.h"
#include "hardware/devices/sample_queue.h"
#include "hardware/lines/lines.h"

namespace somato::devices {

/// The bus of a device's servos; nullptr without servos.
std::unique_ptr<ServoBus> make_bus(const DeviceFile& file);

/// The bytes that switch all servos of a device off, for the first of lines_of(): a signal handler
/// can send them at any moment, even while the device starts. Empty without servos.
std::vector<std::uint8_t> relax_bytes_of(const DeviceFile& file);

/// The decoder of a device's sensor line, which it must have.
std::unique_ptr<SensorStream> make_stream(const DeviceFile& file);

/// The traffic on the lines of a device: decoded where it arrives, sent as far as the line accepts
/// it. Nothing allocates after start().
class DeviceIo {
 public:
  DeviceIo(const DeviceFile& file, wire::Lines& lines);

  /// Starts the bus. Errors: those of ServoBus::start(); kData: the line cannot carry a command
  /// each period.
  Result<void> start();

  /// Restarts all servos, which ends an overload, before start(). Errors: those of
  /// ServoBus::reboot(), and then all servos are off; kUsage: there are no servos.
  Result<void> reboot();

  /// Decodes everything that has arrived. Errors (kSystem): a line has hung up.
  Result<void> receive();

  /// Sends the positions on the bus that are to be reached after `seconds`, unless the line is
  /// still sending the ones before. Errors (kSystem): the line has hung up, or is too slow.
  Result<void> send(std::span<const double> on_bus, double seconds);

  /// Whether the last positions are on their way to the servos.
  bool has_sent() const { return has_sent_; }

  /// Switches all servos off.
  void relax() noexcept;

  /// The bytes that do it; empty without servos.
  std::span<const std::uint8_t> relax_bytes() const {
    return bus_ ? bus_->relax_bytes() : std::span<const std::uint8_t>();
  }

  /// `what` with the reason for which the last piece of the sensor line was no frame, if one was
  /// rejected after the last frame.
  std::string with_complaint(std::string what) const;

  /// Fails (kSystem) if a line was silent for too long at the time `now`.
  Result<void> check_fresh(double now) const;

  /// Fails (kData) if a servo reports an error.
  Result<void> check_errors() const;

  /// One for each servo.
  std::span<const ServoReport> reports() const {
    return bus_ ? bus_->reports() : std::span<const ServoReport>();
  }
  /// Whether they contain positions that the servos measure.
  bool measures_positions() const { return bus_ && bus_->measures_positions(); }
  const SensorStream* stream() const { return stream_.get(); }
  /// The frames to be taken; nullptr unless every frame is kept.
  FrameQueue* frame_queue();
  SampleQueue* samples() { return samples_ ? &*samples_ : nullptr; }
  SampleClock* sound() { return sound_ ? &*sound_ : nullptr; }

  /// Opens the microphone again, which it must have. Errors (kSystem): it cannot be opened.
  Result<void> reopen_microphone();

  /// Waits for its first samples, if there is a microphone. Errors (kSystem): none arrive.
  Result<void> wait_for_samples();
  double now() const { return lines_.now(); }
  void wait(double until) { lines_.wait(until); }

  /// Forgets how old the last answers are, and the frames that were not taken, for the moment after
  /// a pause.
  void begin(double now);

 private:
  bool is_silent(std::size_t servo, double now) const;
  Result<void> check_servos_fresh(double now) const;
  Result<void> check_capacity() const;
  void note_frames();
  Result<void> at_port(Result<void> done) const;
  Result<void> queue(std::span<const std::uint8_t> bytes);
  Result<void> flush();

  const DeviceFile& file_;
  wire::Lines& lines_;
  DeviceLines numbers_;
  std::unique_ptr<ServoBus> bus_;
  std::unique_ptr<SensorStream> stream_;
  std::optional<SampleQueue> samples_;
  std::optional<SampleClock> sound_;
  std::array<std::uint8_t, 4096> received_{};
  std::vector<std::uint8_t> unsent_;
  std::size_t delayed_ = 0;  // Periods in which the line was still sending.
  bool has_sent_ = false;
  double begun_ = 0.0;
  std::size_t frames_ = 0;             // Those of the stream when it was last read,
  std::size_t rejected_at_frame_ = 0;  // and what it had rejected when there was a frame.
};

}  // namespace somato::devices
