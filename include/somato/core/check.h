#pragma once

#include <stdexcept>
#include <string>

namespace somato {

/// Thrown for an invalid argument, that is, one that the documentation excludes. Never returned.
class InvalidArgument : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Throws InvalidArgument with `message` unless `holds` is true.
inline void require(bool holds, const char* message) {
  if (!holds) throw InvalidArgument(message);
}

/// The same for a message that must be composed.
inline void require(bool holds, const std::string& message) {
  if (!holds) throw InvalidArgument(message);
}

namespace detail {
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);
}  // namespace detail

}  // namespace somato

/// Checks an internal invariant; a violation ends the program, in release builds too.
#define SOMATO_ASSERT(condition) \
  ((condition) ? void(0) : ::somato::detail::assertion_failed(#condition, __FILE__, __LINE__))
