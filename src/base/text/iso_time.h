#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace somato {

/// A time in the notation of ISO 8601.
struct IsoTime {
  /// Whole seconds since 1970 in the time zone, or in UTC if the zone is known; without a date,
  /// since midnight.
  std::int64_t seconds = 0;
  double fraction = 0.0;  ///< A fraction of a second, at least 0 and below 1.
  bool has_date = false;
  bool has_zone = false;

  bool operator==(const IsoTime&) const = default;
};

/// Reads a date, a time of day, or both, which T or a blank separates: 2025-04-17,
/// 10:30, 10:30:25.5 or 2025-04-17T10:30:25.5+02:00. A fraction of a second follows a point or a
/// comma. The time zone is Z, +02:00, +0200 or +02, after a blank or none. The basic format
/// 20250417T103025 is read where a T separates date and time. 24:00 is the end of the day, and
/// second 60 the first of the next minute. Nothing for any other text, and for a day that does not
/// exist.
std::optional<IsoTime> read_iso_time(std::string_view text);

}  // namespace somato
