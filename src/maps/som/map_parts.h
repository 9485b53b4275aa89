#pragma once

#include <string>
#include <utility>

#include "base/archives/archive.h"
#include "base/files/toml_file.h"
#include "somato/core/matrix.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"

namespace somato {

/// The failure for a part of a model file that cannot be kData.
tl::unexpected<Error> damaged_model(std::string what, const std::string& where);

/// Errors in a file are data errors: returns the error as kData, at `where` unless it has a
/// location.
tl::unexpected<Error> damaged_model(Error error, const std::string& where);

/// Puts a matrix into an archive: an array of float32, rows x columns.
void add_matrix(Archive& archive, std::string name, const Matrix<float>& matrix);

/// The matrix that add_matrix put there. Errors (kData, at `where`): missing, of another type or
/// not of two dimensions, a value that is not finite.
Result<Matrix<float>> matrix_from(const Archive& archive, const std::string& name,
                                  const std::string& where);

/// The parameters in an archive, in TOML. Errors (kData, at `where`): missing, unknown, out of
/// range.
template <typename Parameters>
Result<Parameters> parameters_from(const Archive& archive, const std::string& name,
                                   const std::string& where) {
  SOMATO_TRY(const std::string* toml, archive.get<std::string>(name, where));
  Result<Parameters> parameters = parse_toml(*toml, where).and_then([](const Table& table) {
    return read_parameters<Parameters>(table);
  });
  if (!parameters) return damaged_model(std::move(parameters.error()), where);
  return parameters;
}

}  // namespace somato
