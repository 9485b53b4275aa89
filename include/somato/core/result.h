#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace somato {

/// The kind of a failure; a program turns it into an exit code.
enum class ErrorKind {
  kUsage,        ///< A wrong flag, key or value in a description: exit code 2.
  kData,         ///< The content of a file or recording cannot be used: exit code 1.
  kSystem,       ///< The operating system reported an error (missing path, full disk): exit code 1.
  kIncomplete,   ///< Completed, but not everything could be saved: exit code 3.
  kInterrupted,  ///< Stopped on request; files on disk are complete: exit code 130.
  kUnavailable,  ///< A device cannot be used, so that trying again is useless: exit code 1.
};

/// A failure with an external cause: what is wrong, where, and how to correct it.
///
/// `what` and `advice` are sentences without a full stop; `where` is a place such as `data.csv:3:7`
/// (line, column), `model.somato` or `port code.out`. `where` and `advice` may be empty.
struct Error {
  ErrorKind kind = ErrorKind::kData;
  std::string what;
  std::string where;
  std::string advice;
};

/// One line for users: `where: what; advice`.
std::string to_string(const Error& error);

/// A value, or the Error that prevented it. Returned by functions that depend on files, devices or
/// data.
template <typename T>
using Result = tl::expected<T, Error>;

/// Creates the failed state of any Result.
inline tl::unexpected<Error> fail(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

/// Creates the failed state of any Result from its parts; see Error.
inline tl::unexpected<Error> fail(ErrorKind kind, std::string what, std::string where = {},
                                  std::string advice = {}) {
  return fail(Error{kind, std::move(what), std::move(where), std::move(advice)});
}

}  // namespace somato

#define SOMATO_JOINED_AGAIN(a, b) a##b
#define SOMATO_JOINED(a, b) SOMATO_JOINED_AGAIN(a, b)

#define SOMATO_TRY_VOID_AS(name, ...) \
  if (auto name = (__VA_ARGS__); !name) return ::somato::fail(std::move(name).error())

// NOLINTBEGIN(bugprone-macro-parentheses): a declaration stands in no parentheses.
#define SOMATO_TRY_AS(name, declaration, ...)                \
  auto name = (__VA_ARGS__);                                 \
  if (!name) return ::somato::fail(std::move(name).error()); \
  declaration = std::move(*name)
// NOLINTEND(bugprone-macro-parentheses)

/// Returns the error of a Result from the current function, if there is one; the value is not used:
/// `SOMATO_TRY_VOID(file.finish());`
#define SOMATO_TRY_VOID(...) \
  SOMATO_TRY_VOID_AS(SOMATO_JOINED(somato_result_, __COUNTER__), __VA_ARGS__)

/// The same; otherwise declares a variable with the value of the Result: `SOMATO_TRY(const auto
/// file, open(path));`
#define SOMATO_TRY(declaration, ...) \
  SOMATO_TRY_AS(SOMATO_JOINED(somato_result_, __COUNTER__), declaration, __VA_ARGS__)
