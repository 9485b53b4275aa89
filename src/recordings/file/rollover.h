#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <string_view>

namespace somato {

/// The condition under which a recording continues in another file: before the next exploration,
/// once its file is as old or as large.
struct Rollover {
  double every = std::numeric_limits<double>::infinity();       ///< Seconds.
  std::size_t bytes = std::numeric_limits<std::size_t>::max();  ///< Bytes of frames, uncompressed.
  std::function<double()> now = {};  ///< Seconds since 1970; empty: by the system's clock.

  double time() const;

  /// Whether a file that began at `begun` with so many bytes is complete.
  bool is_due(double begun, std::size_t written) const {
    return written >= bytes || time() - begun >= every;
  }
};

/// The place in the name of a file for the time at which it begins.
inline constexpr std::string_view kTimePlace = "{time}";

/// The path with that time (seconds since 1970) in its place, in UTC: `touch_{time}.mcap` is
/// "touch_2026-11-27T21-05-00Z.mcap". Of the number `copy` above 1, "-2" and so on follow the time.
std::string path_at(std::string path, double time, std::size_t copy = 1);

}  // namespace somato
