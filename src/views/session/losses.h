#pragma once

#include <cstddef>

namespace somato {

/// The losses that a session has survived so far.
struct Losses {
  std::size_t failed = 0;   ///< Explorations that failed.
  std::size_t unsaved = 0;  ///< Explorations that could not be saved.
  std::size_t viewers = 0;  ///< Viewers whose connection has ended.

  bool operator==(const Losses&) const = default;
};

}  // namespace somato
