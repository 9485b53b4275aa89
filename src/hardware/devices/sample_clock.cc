#include "hardware/devices/sample_clock.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace somato::devices {
namespace {

// Blocks that are read one after the other arrived together.
constexpr double kTogether = 0.005;  // s
// The time in which the least delay of a block shows, and a late one is followed by the next.
constexpr double kSettling = 0.5;  // s
// A busy computer delays blocks by some 10 ms; a recorder that overruns loses a block of 125 ms.
constexpr double kDelay = 0.05;    // s
constexpr double kMostSlip = 0.1;  // s
// The buffer of a sound device; it may become empty while samples are taken, which then come
// faster.
constexpr double kMostLatency = 0.5;  // s
// The clocks of sound devices and computers differ by 0.01 %, of bad ones by ten times as much.
constexpr double kDrift = 0.002;
// In this time clocks drift apart by less than a loss that is to be found.
constexpr double kWindow = 10.0;  // s
// Rates in use differ by 9 % (44.1 and 48 kHz) or more; ALSA itself warns from 5 %.
constexpr double kRateTolerance = 0.03;

// The rate that a device has, if it is one in use.
double likely_rate(double measured) {
  constexpr std::array kRates{8000.0,  11025.0, 12000.0, 16000.0, 22050.0, 24000.0,
                              32000.0, 44100.0, 48000.0, 88200.0, 96000.0, 192000.0};
  for (const double rate : kRates) {
    if (std::abs(measured / rate - 1.0) < kRateTolerance) return rate;
  }
  return std::round(measured);
}

std::string rate_advice(const MicrophoneSettings& microphone, double rate) {
  std::string advice = fmt::format("set rate = {:g} of [microphone]", rate);
  if (!microphone.source.starts_with("alsa:")) return advice;
  const std::string device =
      microphone.source.starts_with("alsa:hw:") ? microphone.source.substr(8) : "...";
  return fmt::format("{}, or use source = \"alsa:plughw:{}\", which converts the rate", advice,
                     device);
}

}  // namespace

SampleClock::SampleClock(MicrophoneSettings microphone, double clock)
    : microphone_(std::move(microphone)), clock_(std::max(1.0, clock)) {}

void SampleClock::add(std::size_t samples, double now) {
  if (samples == 0) return;
  last_ = now;
  if (!first_) {
    first_ = now;
    samples_ = 0;
    window_ = now;
    least_ = least_before_ = least_in_window_ = delay_ = 0.0;
    off_since_.reset();
    rate_before_ = 0.0;
  }
  if (now - *first_ < kTogether) return;
  samples_ += samples;
  const double delay = now - *first_ - static_cast<double>(samples_) / microphone_.rate;
  note_delay(delay, now);
  const bool is_off =
      late() > kMostSlip * clock_ || early() > kMostLatency * clock_ + kDrift * (now - *first_);
  if (!is_off) {
    off_since_.reset();
    rate_before_ = rate();
  } else if (!off_since_) {
    off_since_ = now;
  }
}

// The least delays: in the beginning, and in the last windows of time.
void SampleClock::note_delay(double delay, double now) {
  delay_ = delay;
  if (now - *first_ <= kSettling * clock_) least_ = std::min(least_, delay);
  if (now - window_ > kWindow * clock_ && !off_since_) {
    window_ = now;
    least_before_ = std::exchange(least_in_window_, delay);
  }
  least_in_window_ = std::min(least_in_window_, delay);
}

// Seconds by which the last block is later than the others before it, or earlier than the first.
double SampleClock::late() const {
  return delay_ - std::min(least_before_, least_in_window_);
}

double SampleClock::early() const {
  return least_ - delay_;
}

double SampleClock::rate() const {
  return first_ && samples_ > 0 ? static_cast<double>(samples_) / (last_ - *first_) : 0.0;
}

double SampleClock::missing(double now) const {
  return first_ ? now - *first_ - static_cast<double>(samples_) / microphone_.rate - least_ : 0.0;
}

// More samples within a short time may also be those of a buffer that becomes empty.
bool SampleClock::is_other_rate(double rate, double latency) const {
  if (rate == 0.0) return false;
  const double share = rate / microphone_.rate - 1.0;
  const double seconds = (share > 0.0 ? latency : kDelay) * clock_ / (last_ - *first_);
  return std::abs(share) > kRateTolerance + seconds;
}

tl::unexpected<Error> SampleClock::fault() const {
  // Samples that were lost changed the mean rate; the rate before was right.
  const bool was_right = rate_before_ > 0.0 && !is_other_rate(rate_before_, kMostLatency);
  if (late() > kMostSlip * clock_ && was_right) {
    return fail(ErrorKind::kSystem, fmt::format("the microphone lost {:.2f} s of sound", late()),
                microphone_.source, "use a computer that is less busy, or a lower 'rate'");
  }
  return fail(ErrorKind::kSystem,
              fmt::format("the microphone gave {:.0f} samples per second, not {:g}", rate(),
                          microphone_.rate),
              microphone_.source, rate_advice(microphone_, likely_rate(rate())));
}

Result<void> SampleClock::check() const {
  if (!off_since_ || last_ - *off_since_ < kSettling * clock_) return {};
  return fault();
}

Result<void> SampleClock::check_all() const {
  if (off_since_ || is_other_rate(rate(), kMostLatency)) return fault();
  return {};
}

Result<void> SampleClock::check_rate() const {
  if (off_since_ || is_other_rate(rate(), kDelay)) return fault();
  return {};
}

}  // namespace somato::devices
