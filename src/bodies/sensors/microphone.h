#pragma once

#include <cstddef>
#include <cstdint>

#include "somato/core/random.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato::detail {

/// The signals that a microphone receives in a frame of the sound.
struct TrueSound {
  double edge = 0.0;   ///< Velocity of the edge in its band, mm/s.
  double servo = 0.0;  ///< Sound of the servo in its band, as a multiple of its root mean square.
};

/// The sound of a room: white noise through a low-pass of first order, with the root mean square 1.
class RoomSound {
 public:
  /// `cutoff` and `rate` in Hz.
  RoomSound(double cutoff, double rate, std::uint64_t seed);

  /// In the next frame.
  double next();

 private:
  double kept_;
  double fresh_;
  double value_ = 0.0;
  Random random_;
};

/// A microphone and its converter: counts for what it receives, with noise.
class Microphone {
 public:
  /// `rate` in Hz; `seed` is that of the exploration.
  Microphone(const TextureProbeParameters& parameters, double rate, std::uint64_t seed);

  /// The reading of the next frame, with one normal number of `noise`.
  float read(const TrueSound& sound, Random& noise);

  /// Leaves out the next `frames`, which are not recorded.
  void skip(std::uint64_t frames, Random& noise);

 private:
  float counts(double millivolts) const;

  double sensitivity_;
  double servo_;
  double noise_;
  double ambient_;
  RoomSound room_;
  double most_;
  double step_;
};

/// The numbers that a stroke draws before its noise.
struct StrokeDraws {
  double start = 0.0;   ///< Deviation of the place along the track, normal.
  double across = 0.0;  ///< Deviation of the place across it, normal.
  double tone = 0.0;    ///< Deviation of the servo's tone, normal.
  double turns = 0.0;   ///< Phase of the servo's tone, uniform.
};

StrokeDraws draw_stroke(Random& random);

}  // namespace somato::detail
