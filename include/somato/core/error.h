#pragma once

#include <string>

namespace somato {

/// What kind of failure it is; a program turns it into an exit code.
enum class ErrorKind {
  kUsage,        ///< A wrong flag, key or value in a description: exit code 2.
  kData,         ///< The content of a file or recording cannot be used: exit code 1.
  kSystem,       ///< The operating system said no (missing path, full disk): exit code 1.
  kIncomplete,   ///< Done, but not all could be saved: exit code 3.
  kInterrupted,  ///< Somebody asked to stop; whatever is on disk is whole: exit code 130.
};

/// A failure that depends on the world: what is wrong, where, and what to do about it.
///
/// `what` and `advice` are sentences without a full stop; `where` is a place such as
/// `data.csv:3:7` (line, column), `model.somato` or `port code.out`. `where` and `advice` may be
/// empty.
struct Error {
  ErrorKind kind = ErrorKind::kData;
  std::string what;
  std::string where;
  std::string advice;
};

/// One line for a person: `where: what; advice`.
std::string to_string(const Error& error);

}  // namespace somato
