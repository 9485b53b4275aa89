#include "hardware/devices/device_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace somato::devices {
namespace {

constexpr double kBitsPerByte = 10.0;  // a start bit, 8 bits, a stop bit

tl::unexpected<Error> silent(const std::string& port, std::string what, const char* advice) {
  return fail(ErrorKind::kSystem, std::move(what), port, advice);
}

std::string for_periods(const char* what, std::size_t missed) {
  return fmt::format("{} for {} periods", what, missed);
}

}  // namespace

DeviceIo::DeviceIo(const DeviceFile& file, wire::Lines& lines)
    : file_(file), lines_(lines), numbers_(file), bus_(make_bus(file)) {
  if (file.frame_line) stream_ = make_stream(file);
  constexpr double kSeconds = 4.0;
  if (file.microphone) {
    samples_.emplace(static_cast<std::size_t>(kSeconds * file.microphone->rate));
    sound_.emplace(*file.microphone, file.settings.clock);
  }
  unsent_.reserve(4096);
}

Result<void> DeviceIo::check_capacity() const {
  const double needed = static_cast<double>(bus_->bytes_per_tick()) / file_.settings.period;
  const double carried = static_cast<double>(file_.servo_line->baud) / kBitsPerByte;
  if (needed <= carried) return {};
  return fail(ErrorKind::kData,
              fmt::format("the line carries {:.0f} bytes per second, but a command every {:g} s "
                          "requires {:.0f}",
                          carried, file_.settings.period, needed),
              file_.servo_line->port, "raise 'baud' on the device and in its file, or 'period'");
}

Result<void> DeviceIo::start() {
  begin(now());
  if (!bus_) return {};
  SOMATO_TRY_VOID(check_capacity());
  wire::Exchange exchange(lines_, *numbers_.servos, patience_of(file_));
  auto started = at_port(bus_->start(exchange));
  begin(now());
  return started;
}

Result<void> DeviceIo::reboot() {
  if (!bus_) {
    return fail(ErrorKind::kUsage, "the device has no servos that could be restarted", {},
                "omit '--reboot'");
  }
  wire::Exchange exchange(lines_, *numbers_.servos, patience_of(file_));
  for (std::size_t i = 0; i < file_.servos.size(); ++i) {
    auto rebooted = at_port(bus_->reboot(i, exchange));
    if (rebooted) continue;
    relax();
    return rebooted;
  }
  return {};
}

Result<void> DeviceIo::at_port(Result<void> done) const {
  if (!done && done.error().where.empty()) done.error().where = file_.servo_line->port;
  return done;
}

Result<void> DeviceIo::receive() {
  const auto read_all = [&](std::size_t line, const auto& decode) -> Result<void> {
    for (;;) {
      SOMATO_TRY(const auto count, lines_.read(line, received_));
      if (count == 0) return {};
      decode(std::span<const std::uint8_t>(received_).first(count));
    }
  };
  if (bus_) {
    SOMATO_TRY_VOID(
        read_all(*numbers_.servos, [&](auto bytes) { bus_->receive(bytes, lines_.now()); }));
    SOMATO_TRY_VOID(queue(bus_->follow_up()));
  }
  if (stream_) {
    SOMATO_TRY_VOID(
        read_all(*numbers_.frames, [&](auto bytes) { stream_->receive(bytes, lines_.now()); }));
    note_frames();
  }
  if (!samples_) return {};
  return read_all(*numbers_.microphone, [&](auto bytes) {
    const std::size_t before = samples_->received();
    samples_->receive(bytes);
    sound_->add(samples_->received() - before, lines_.now());
  });
}

FrameQueue* DeviceIo::frame_queue() {
  const bool is_kept = stream_ && file_.frame_line->keep == KeptFrames::kEvery;
  return is_kept ? &stream_->queue() : nullptr;
}

void DeviceIo::begin(double now) {
  begun_ = now;
  if (FrameQueue* queue = frame_queue()) queue->begin(now);
}

Result<void> DeviceIo::reopen_microphone() {
  sound_->begin();
  return lines_.reopen(*numbers_.microphone);
}

Result<void> DeviceIo::wait_for_samples() {
  constexpr double kFirstSamples = 2.0;  // s; a sound device needs up to one to start
  const double until = now() + kFirstSamples * std::max(1.0, file_.settings.clock);
  while (sound_ && !sound_->has_begun()) {
    if (now() >= until) {
      return fail(ErrorKind::kSystem,
                  fmt::format("no samples arrived within {:g} s", kFirstSamples),
                  file_.microphone->source, "check the sound device");
    }
    wait(until);
    SOMATO_TRY_VOID(receive());
  }
  return {};
}

void DeviceIo::note_frames() {
  if (stream_->frames() == frames_) return;
  frames_ = stream_->frames();
  rejected_at_frame_ = stream_->rejected();
}

Result<void> DeviceIo::flush() {
  SOMATO_TRY(const auto count, lines_.write(*numbers_.servos, unsent_));
  unsent_.erase(unsent_.begin(), unsent_.begin() + static_cast<std::ptrdiff_t>(count));
  return {};
}

Result<void> DeviceIo::queue(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return {};
  unsent_.insert(unsent_.end(), bytes.begin(), bytes.end());
  return flush();
}

Result<void> DeviceIo::send(std::span<const double> on_bus, double seconds) {
  has_sent_ = false;
  if (!bus_) return {};
  SOMATO_TRY_VOID(flush());
  if (unsent_.empty()) {
    delayed_ = 0;
    const std::span<const std::uint8_t> bytes = bus_->tick(on_bus, seconds);
    has_sent_ = bus_->has_sent_positions();
    return queue(bytes);
  }
  if (++delayed_ < file_.safety.missed) return {};
  return silent(file_.servo_line->port, for_periods("the line did not accept a command", delayed_),
                "check the cable and 'baud', or raise 'period'");
}

void DeviceIo::relax() noexcept {
  constexpr double kPatience = 0.2;
  if (!bus_) return;
  try {
    const double until = now() + kPatience;
    std::span<const std::uint8_t> bytes = bus_->relax_bytes();
    // A command cut short must end before the next one begins.
    while (!unsent_.empty() && now() < until && flush()) {
      if (!unsent_.empty()) wait(std::min(until, now() + 0.001));
    }
    while (!bytes.empty() && now() < until) {
      const auto count = lines_.write(*numbers_.servos, bytes);
      if (!count) return;
      bytes = bytes.subspan(*count);
      if (!bytes.empty()) wait(std::min(until, now() + 0.001));
    }
  } catch (...) {  // NOLINT(bugprone-empty-catch): a destructor reports nothing
  }
}

// Where one servo after the other is read, one that answers is as fresh as the last round; the
// bus itself answers all the time.
bool DeviceIo::is_silent(std::size_t servo, double now) const {
  const double patience = std::max(patience_of(file_), bus_->recovery());
  const auto is_late = [&](double time) { return now - std::max(time, begun_) > patience; };
  const std::span<const ServoReport> all = reports();
  if (!bus_->reads_one_by_one()) return is_late(all[servo].time);
  const bool none_answers = std::all_of(all.begin(), all.end(),
                                        [&](const ServoReport& one) { return is_late(one.time); });
  constexpr std::size_t kLost = 2;  // a single answer may be lost
  return none_answers || (is_late(all[servo].time) && all[servo].unanswered > kLost);
}

Result<void> DeviceIo::check_servos_fresh(double now) const {
  if (!bus_ || !bus_->reports_states()) return {};
  for (std::size_t i = 0; i < file_.servos.size(); ++i) {
    if (!is_silent(i, now)) continue;
    return fail(
        ErrorKind::kSystem,
        fmt::format("the servo '{}' gave no answer for {:.0f} periods", file_.servos[i].name,
                    std::max(patience_of(file_), bus_->recovery()) / file_.settings.period),
        file_.servo_line->port, "check the cable, the power and the id of the servo");
  }
  return {};
}

std::string DeviceIo::with_complaint(std::string what) const {
  if (!stream_ || (frames_ > 0 && stream_->rejected() == rejected_at_frame_)) return what;
  const std::string complaint = stream_->complaint();
  return complaint.empty() ? what : fmt::format("{}; {}", what, complaint);
}

Result<void> DeviceIo::check_fresh(double now) const {
  SOMATO_TRY_VOID(check_servos_fresh(now));
  const auto is_late = [&](double time, double periods, double period) {
    return now - std::max(time, begun_) > periods * period;
  };
  const double period = file_.settings.period;
  const auto missed = static_cast<double>(file_.safety.missed);
  if (!stream_ ||
      !is_late(stream_->time(), missed, std::max(period, 1.0 / file_.frame_line->rate))) {
    return {};
  }
  return silent(file_.frame_line->port,
                with_complaint(for_periods("no valid sensor frame arrived", file_.safety.missed)),
                "check the cable and the power of the sensor board, its format and 'baud'");
}

Result<void> DeviceIo::check_errors() const {
  for (std::size_t i = 0; i < file_.servos.size(); ++i) {
    const std::uint8_t error = reports()[i].error;
    if (error == 0) continue;
    Error explained = bus_->explain(error);
    explained.what = fmt::format("the servo '{}' {}", file_.servos[i].name, explained.what);
    explained.where = file_.servo_line->port;
    return fail(std::move(explained));
  }
  return {};
}

}  // namespace somato::devices
