#pragma once

#include <stdexcept>
#include <string>

namespace somato {

/// A caller's mistake: an argument the documentation rules out. Thrown, never returned.
class InvalidArgument : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Throws InvalidArgument with `message` unless `holds`.
inline void require(bool holds, const char* message) {
  if (!holds) throw InvalidArgument(message);
}

/// The same for a message that has to be put together.
inline void require(bool holds, const std::string& message) {
  if (!holds) throw InvalidArgument(message);
}

namespace detail {
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);
}  // namespace detail

}  // namespace somato

/// An invariant of our own; a broken one ends the program, in release builds too.
#define SOMATO_ASSERT(condition) \
  ((condition) ? void(0) : ::somato::detail::assertion_failed(#condition, __FILE__, __LINE__))
