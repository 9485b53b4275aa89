#include "hardware/devices/device_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hardware/devices/device_io.h"
#include "hardware/devices/safe_motion.h"
#include "hardware/devices/sensor_reader.h"
#include "hardware/devices/servo_watch.h"
#include "somato/core/check.h"

namespace somato::devices {
namespace {

constexpr double kFirstFrame = 2.0;   // s; boards that restart when a port opens need a second
constexpr double kSwitchOn = 0.2;     // s between two servos, so that the supply does not collapse
constexpr double kLateSamples = 0.5;  // s for which samples may be late
constexpr double kPause = 3.0;        // periods after which the host has paused
constexpr double kBacklog = 0.25;     // s of samples that may wait

using BeforeJump = std::function<Result<void>(const ServoSettings& servo)>;
using ShouldContinue = std::function<bool()>;

std::vector<std::string> names_of(const DeviceFile& file) {
  std::vector<std::string> names;
  names.reserve(file.servos.size());
  for (const ServoSettings& servo : file.servos) names.push_back(servo.name);
  return names;
}

}  // namespace

class DeviceBody::Impl {
 public:
  Impl(DeviceFile file, wire::Lines& lines)
      : file_(std::move(file)),
        description_(describe(file_)),
        io_(file_, lines),
        motion_(file_.servos),
        reader_(file_),
        watch_(file_),
        history_(names_of(file_)) {}

  const BodyDescription& description() const { return description_; }
  const BodyState& state() const { return state_; }
  const StateLog& history() const { return history_; }
  bool is_on() const { return is_on_; }
  SafeMotion& motion() { return motion_; }
  const DeviceFile& file() const { return file_; }

  Result<void> start(const BeforeJump& before_jump, const ShouldContinue& should_continue) {
    is_on_ = true;  // A start that fails may have switched some of them on.
    SOMATO_TRY_VOID(io_.start());
    SOMATO_TRY_VOID(begin_motion());
    SOMATO_TRY_VOID(wait_for_frame());
    SOMATO_TRY_VOID(io_.wait_for_samples());
    reader_.prepare(state_.readings);
    SOMATO_TRY_VOID(permit_jump(before_jump));
    return begin().and_then([&] { return switch_on(should_continue); }).and_then([&] {
      return begin();
    });
  }

  Result<void> begin() {
    SOMATO_TRY_VOID(catch_up());
    start_ = io_.now();
    io_.begin(start_);
    next_tick_ = start_;
    moved_ = start_;
    samples_taken_ = 0;
    watch_.begin();
    if (io_.samples() != nullptr) io_.samples()->keep(0);
    state_.time = 0.0;
    state_.times.clear();
    state_.positions.assign(motion_.positions().begin(), motion_.positions().end());
    read();
    return {};
  }

  // Advances until the state's time is `seconds` later; `should_continue` is checked every period.
  template <typename Condition>
  Result<void> pass(double seconds, const Condition& should_continue) {
    require(is_on_, "the device was stopped; start it again");
    if (auto held_up = check_pause(may_have_paused_); !held_up) {
      return stop(std::move(held_up.error()));
    }
    may_have_paused_ = false;
    skip_pause(0.0);
    const double end = state_.time + seconds;
    const std::size_t due = samples_due(end);
    while (time() < end || is_waiting_for_samples(due, end)) {
      auto ticked = should_continue().and_then([&] { return tick(end); });
      if (!ticked) return stop(std::move(ticked.error()));
    }
    if (auto held_up = check_pause(false); !held_up) return stop(std::move(held_up.error()));
    if (samples_missing(due)) return stop(no_samples());
    // The servos moved on while late samples were awaited: the body's time passes as much later.
    start_ = std::max(start_, moved_ - end);
    move(start_ + end);
    state_.time = end;
    state_.positions.assign(motion_.positions().begin(), motion_.positions().end());
    read();
    take_frames();
    take_samples(due);
    return {};
  }

  // The last samples may only be late.
  Result<void> end() {
    if (io_.sound() == nullptr || !is_on_) return {};
    const double until = io_.now() + kLateSamples * std::max(1.0, file_.settings.clock);
    while (io_.sound()->is_off() && io_.now() < until) {
      io_.wait(until);
      if (auto received = io_.receive(); !received) return stop(std::move(received.error()));
    }
    auto checked = io_.sound()->check_all();
    return checked ? checked : stop(std::move(checked.error()));
  }

  void expect_pause() { may_have_paused_ = true; }

  void relax() noexcept {
    if (std::exchange(is_on_, false)) io_.relax();
  }

 private:
  // Discards what has arrived since the last reading. A recorder whose samples were not taken for
  // long has lost some, and would say so later: it starts anew.
  Result<void> catch_up() {
    auto received = io_.receive();
    if (io_.sound() == nullptr) return received;
    const bool is_recorder = file_.microphone->source.starts_with("alsa:");
    if (is_recorder && (!received || io_.sound()->missing(io_.now()) > kLateSamples)) {
      SOMATO_TRY_VOID(io_.reopen_microphone());
      SOMATO_TRY_VOID(io_.wait_for_samples());
      received = io_.receive();
    }
    io_.sound()->begin();
    return received;
  }

  Result<void> begin_motion() {
    std::vector<double> positions(file_.servos.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const ServoSettings& servo = file_.servos[i];
      positions[i] = servo.from_bus(io_.reports()[i].position);
      SOMATO_TRY_VOID(check_start(servo, positions[i]));
    }
    motion_.begin(positions);
    return io_.check_errors();
  }

  // Seconds of the body.
  double time() const { return io_.now() - start_; }

  // A program that was held up while servos moved, such as one that was stopped and continued,
  // knows nothing of what has happened meanwhile.
  Result<void> check_pause(bool is_expected) const {
    const double pause = io_.now() - moved_;
    if (is_expected || pause <= file_.safety.pause * file_.settings.clock) return {};
    return fail(
        ErrorKind::kSystem,
        fmt::format("the program was held up for {:.1f} s while the servos were on", pause),
        file_.settings.name,
        "do not stop it while it moves servos, and use a computer that is less busy; 'pause' "
        "of [safety] is what is permitted");
  }

  // A host that paused, as a view does between two steps, has neither moved the servos nor
  // requested their states: only `passed` seconds of the body's time have passed.
  void skip_pause(double passed) {
    const double now = io_.now();
    if (now - moved_ <= kPause * file_.settings.period) return;
    start_ += now - moved_ - passed;
    moved_ = now - passed;
    next_tick_ = now;
    // A line that has hung up is noticed in the next step.
    const bool is_connected = catch_up().has_value();
    io_.begin(now);
    if (is_connected && io_.samples() != nullptr) {
      io_.samples()->keep_oldest(samples_due(time()));
    }
  }

  // Lets the servos go on towards their targets until `now`.
  std::span<const double> move(double now) {
    const double passed = std::max(0.0, now - moved_);
    moved_ = std::max(moved_, now);
    return motion_.advance(passed);
  }

  // A servo that starts far outside of its limits would jump into them.
  static Result<void> check_start(const ServoSettings& servo, double position) {
    const double slack = 0.02 * (servo.most - servo.least);
    if (std::isnan(position)) return {};
    if (position >= servo.least - slack && position <= servo.most + slack) return {};
    return fail(ErrorKind::kData,
                fmt::format("the servo is at {:.1f} {}, outside its limits, {:g} to {:g}", position,
                            servo.unit, servo.least, servo.most),
                servo.name,
                "move it into its limits by hand with the power off, or correct zero and scale "
                "('somato device calibrate FILE')");
  }

  Result<void> wait_for_frame() {
    const double until = io_.now() + kFirstFrame;
    while (io_.stream() != nullptr && io_.stream()->frames() == 0) {
      if (io_.now() >= until) {
        return fail(ErrorKind::kSystem,
                    io_.with_complaint(
                        fmt::format("no valid sensor frame arrived within {:g} s", kFirstFrame)),
                    file_.frame_line->port,
                    "check the cable, and 'format', 'elements' and 'baud' of [frames]");
      }
      io_.wait(until);
      SOMATO_TRY_VOID(io_.receive());
    }
    io_.begin(io_.now());
    return {};
  }

  Result<void> permit_jump(const BeforeJump& before_jump) const {
    if (!before_jump) return {};
    for (std::size_t i = 0; i < file_.servos.size(); ++i) {
      if (std::isnan(io_.reports()[i].position)) return before_jump(file_.servos[i]);
    }
    return {};
  }

  // Servos of unknown position jump, one after the other.
  Result<void> switch_on(const ShouldContinue& should_continue) {
    const auto check_stop = [&]() -> Result<void> {
      if (!should_continue || should_continue()) return {};
      return fail(ErrorKind::kInterrupted, "the start of the device was interrupted");
    };
    for (std::size_t i = 0; i < file_.servos.size(); ++i) {
      if (!std::isnan(io_.reports()[i].position)) continue;
      motion_.switch_on(i);
      SOMATO_TRY_VOID(pass(kSwitchOn, check_stop));
    }
    return {};
  }

  // One period, or the part that fits before the body's time `end`.
  Result<void> tick(double end) {
    const double now = io_.now();
    if (now < next_tick_) {
      const double until = start_ + end;
      io_.wait(until > now ? std::min(next_tick_, until) : next_tick_);
      return io_.receive();
    }
    SOMATO_TRY_VOID(check_pause(false));
    skip_pause(file_.settings.period);
    SOMATO_TRY_VOID(io_.receive());
    SOMATO_TRY_VOID(check(now));
    const double period = file_.settings.period;
    next_tick_ = std::max(next_tick_ + period, now);
    // Late positions are reached as late, not faster.
    const double seconds = std::max(period, now - moved_);
    const std::span<const double> on_bus = move(now);
    history_.add(time(), motion_.targets(), motion_.positions(), io_.reports(), frame_age(now));
    SOMATO_TRY_VOID(io_.send(on_bus, seconds));
    if (io_.has_sent()) motion_.note_sent();
    return {};
  }

  double frame_age(double now) const {
    return io_.stream() != nullptr ? now - io_.stream()->time()
                                   : std::numeric_limits<double>::quiet_NaN();
  }

  Result<void> check(double now) {
    SOMATO_TRY_VOID(io_.check_fresh(now));
    SOMATO_TRY_VOID(io_.check_errors());
    if (io_.sound() != nullptr) SOMATO_TRY_VOID(io_.sound()->check());
    if (io_.measures_positions()) {
      SOMATO_TRY_VOID(watch_.check(motion_.positions(), io_.reports()));
    }
    if (!file_.safety.limit) return {};
    const double most = reader_.greatest(file_.safety.sensor, io_, motion_.positions());
    if (most <= *file_.safety.limit) return {};
    const std::string gave = std::isinf(most) ? "no reading for an element, which may be above"
                                              : fmt::format("{:g}, above", most);
    return fail(ErrorKind::kData,
                fmt::format("the sensor gave {} the limit of {:g}", gave, *file_.safety.limit),
                file_.safety.sensor,
                "reduce the speed or the threshold of the grasp, or raise 'limit'");
  }

  void take_frames() {
    FrameQueue* const queue = io_.frame_queue();
    if (queue != nullptr) reader_.take_frames(*queue, start_, start_ + state_.time, state_);
  }

  void read() { reader_.read(io_, motion_.positions(), state_.readings); }

  std::size_t samples_due(double time) const {
    if (!file_.microphone) return 0;
    return static_cast<std::size_t>(std::llround(time * file_.microphone->rate)) - samples_taken_;
  }

  bool samples_missing(std::size_t due) {
    return io_.samples() != nullptr && io_.samples()->size() < due;
  }

  bool is_waiting_for_samples(std::size_t due, double end) {
    const double patience = std::max(kLateSamples, patience_of(file_));
    return samples_missing(due) && time() < end + patience;
  }

  Error no_samples() const {
    return {ErrorKind::kSystem, "the microphone gave fewer samples than its rate",
            file_.microphone->source, "check the sound device and 'rate'"};
  }

  void take_samples(std::size_t due) {
    if (io_.samples() == nullptr) return;
    samples_taken_ += due;
    reader_.take_samples(*io_.samples(), due, state_.readings);
    io_.samples()->keep(static_cast<std::size_t>(kBacklog * file_.microphone->rate));
  }

  // A wait ends with each answer, but a command after each of them would fill the line.
  void receive_until(double end) {
    while (io_.now() < end) {
      io_.wait(end);
      static_cast<void>(io_.receive());
    }
  }

  // Holds for the declared time, then switches off; at once if it was interrupted, and if a servo
  // does not obey, which could not hold.
  tl::unexpected<Error> stop(Error error) {
    motion_.hold();
    const bool hold = error.kind != ErrorKind::kInterrupted && watch_.obeys();
    const double until = io_.now() + (hold ? file_.safety.hold : 0.0);
    const double period = file_.settings.period;
    // A line that hung up may be another one than that of the servos.
    while (io_.now() < until && io_.send(motion_.advance(period), period)) {
      receive_until(std::min(until, io_.now() + period));
    }
    relax();
    if (error.where.empty()) error.where = file_.settings.name;
    return fail(std::move(error));
  }

  const DeviceFile file_;
  BodyDescription description_;
  DeviceIo io_;
  SafeMotion motion_;
  SensorReader reader_;
  ServoWatch watch_;
  StateLog history_;
  BodyState state_;
  double start_ = 0.0;
  double next_tick_ = 0.0;
  double moved_ = 0.0;  // Until when the servos have been moved.
  std::size_t samples_taken_ = 0;
  bool is_on_ = false;
  bool may_have_paused_ = false;  // the observer may have waited since the last step
};

DeviceBody::DeviceBody(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

DeviceBody::~DeviceBody() {
  relax();
}

Result<std::unique_ptr<DeviceBody>> DeviceBody::start(
    const DeviceFile& file, wire::Lines& lines,
    const std::function<Result<void>(const ServoSettings& servo)>& before_jump,
    const std::function<bool()>& should_continue) {
  std::unique_ptr<DeviceBody> body(new DeviceBody(std::make_unique<Impl>(file, lines)));
  SOMATO_TRY_VOID(body->impl_->start(before_jump, should_continue));
  return body;
}

const BodyDescription& DeviceBody::description() const {
  return impl_->description();
}

const BodyState& DeviceBody::state() const {
  return impl_->state();
}

const StateLog& DeviceBody::history() const {
  return impl_->history();
}

Result<void> DeviceBody::begin() {
  return impl_->begin();
}

Result<void> DeviceBody::end() {
  return impl_->end();
}

void DeviceBody::expect_pause() {
  impl_->expect_pause();
}

bool DeviceBody::is_on() const {
  return impl_->is_on();
}

void DeviceBody::relax() noexcept {
  impl_->relax();
}

Result<void> DeviceBody::drive_to(std::span<const double> targets) {
  impl_->motion().set_targets(targets);
  return {};
}

Result<void> DeviceBody::pass(double seconds) {
  return impl_->pass(seconds, [this] { return check_stop(); });
}

Result<void> DeviceBody::go_to_rest() {
  std::vector<double> rest;
  double longest = impl_->file().settings.period;
  for (std::size_t i = 0; i < impl_->file().servos.size(); ++i) {
    const ServoSettings& servo = impl_->file().servos[i];
    rest.push_back(servo.resting());
    longest = std::max(longest, std::abs(state().positions[i] - rest[i]) / servo.fastest);
  }
  SOMATO_TRY_VOID(command(rest));
  return step(longest + impl_->file().settings.period);
}

}  // namespace somato::devices
