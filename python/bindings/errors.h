#pragma once

#include <utility>

#include "nanobind/nanobind.h"
#include "somato/core/result.h"

namespace somato::python {

/// An Error on its way to Python, where it becomes an exception of the module `errors`.
struct Failure {
  Error error;
};

/// Translates Failure for all functions of the extension module.
void register_failures();

/// The value of `result`; throws Failure.
template <typename T>
T value_or_throw(Result<T> result) {
  if (!result) throw Failure{std::move(result.error())};
  return std::move(*result);
}
inline void value_or_throw(Result<void> result) {
  if (!result) throw Failure{std::move(result.error())};
}

}  // namespace somato::python
