#include "maps/som/map_parts.h"

#include <algorithm>
#include <cmath>

namespace somato {

namespace {

// All files whose content is wrong have the only format that there is so far.
constexpr const char* kAdvice =
    "the file is damaged, or another version of Somato wrote it in format 1: train it again, or "
    "use "
    "that version";

}  // namespace

tl::unexpected<Error> damaged_model(std::string what, const std::string& where) {
  return fail(ErrorKind::kData, std::move(what), where, kAdvice);
}

tl::unexpected<Error> damaged_model(Error error, const std::string& where) {
  if (error.where.empty()) error.where = where;
  return fail(ErrorKind::kData, std::move(error.what), std::move(error.where), kAdvice);
}

void add_matrix(Archive& archive, std::string name, const Matrix<float>& matrix) {
  archive.add(std::move(name), Array<float>{{matrix.rows(), matrix.columns()},
                                            {matrix.values().begin(), matrix.values().end()}});
}

Result<Matrix<float>> matrix_from(const Archive& archive, const std::string& name,
                                  const std::string& where) {
  SOMATO_TRY(const Array<float>* found, archive.get<Array<float>>(name, where));
  const Array<float>& array = *found;
  if (array.shape.size() != 2) return damaged_model("'" + name + "' is not a matrix", where);
  const auto is_finite = [](float value) { return std::isfinite(value); };
  if (!std::all_of(array.values.begin(), array.values.end(), is_finite)) {
    return damaged_model("'" + name + "' holds a value that is not finite", where);
  }
  return Matrix<float>(array.shape[0], array.shape[1], array.values);
}

}  // namespace somato
