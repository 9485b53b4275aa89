#pragma once

#include <string>

#include "errors.h"
#include "nanobind/nanobind.h"
#include "somato/core/parameter.h"

namespace somato::python {

/// The values of a dictionary as a table, where None is "automatic". `where` is the place in
/// messages. Throws Failure (kUsage) for a value that no parameter can have.
Table table_of(const nanobind::dict& values, const std::string& where);

/// The reverse of a value; "automatic" becomes None.
nanobind::object object_of(const Value& value);

/// An error about the values of a table_of(), with these as Python writes them: None, True and
/// False.
Error in_python(Error error);

/// The value of `result`, which was read from a table_of(); throws Failure.
template <typename T>
T read_or_throw(Result<T> result) {
  return value_or_throw(std::move(result).map_error(in_python));
}

/// The descriptions of parameters: a list of dictionaries.
nanobind::list descriptions_of(const std::vector<ParameterInfo>& infos);

/// The parameters S from a dictionary.
template <typename S>
S parameters_of(const nanobind::dict& values, const std::string& where) {
  return read_or_throw(read_parameters<S>(table_of(values, where)));
}

/// All parameters as a dictionary.
template <typename S>
nanobind::dict dict_of(const S& parameters) {
  nanobind::dict values;
  for (const Parameter<S>& parameter : S::declarations().all()) {
    values[parameter.info.name.c_str()] = object_of(parameter.read(parameters));
  }
  return values;
}

}  // namespace somato::python
