#include "systems/exchange/map_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "base/arrays/npy_layout.h"
#include "base/core/memory.h"
#include "base/text/flag_hint.h"
#include "somato/maps/layers.h"

namespace somato {
namespace {

// The neurons of an array in Fortran order are numbered column by column.
Matrix<float> row_by_row(const Matrix<float>& by_columns, std::size_t rows, std::size_t columns) {
  Matrix<float> weights(by_columns.rows(), by_columns.columns());
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const auto from = by_columns.row(column * rows + row);
      std::copy(from.begin(), from.end(), weights.row(row * columns + column).begin());
    }
  }
  return weights;
}

tl::unexpected<Error> refuse_weights(std::string what, const std::string& where,
                                     std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), where, std::move(advice));
}

Result<void> check_given(const std::optional<std::size_t>& given, std::uint64_t found,
                         const std::string& name, const std::string& where) {
  if (!given || *given == found) return {};
  return refuse_weights(
      fmt::format("the array has {} {}, but {} {} are given", found, name, *given, name), where,
      fmt::format("omit {}, or give those of the array", name));
}

Result<void> take_sides(const MapArray& array, SomParameters& parameters,
                        const std::string& where) {
  if (array.shape.size() == 3) {
    SOMATO_TRY_VOID(check_given(parameters.rows, array.shape[0], "rows", where));
    SOMATO_TRY_VOID(check_given(parameters.columns, array.shape[1], "columns", where));
    parameters.rows = array.shape[0];
    parameters.columns = array.shape[1];
    return {};
  }
  const std::size_t neurons = array.weights.rows();
  if (!parameters.rows && !parameters.columns) {
    return refuse_weights(
        fmt::format("an array of {} neurons does not contain the rows and columns of the "
                    "map",
                    neurons),
        where,
        "give the number of rows or of columns" + flag_hint("rows") +
            ", or save an array of rows x columns x features");
  }
  const bool has_rows = parameters.rows.has_value();
  const std::size_t given = has_rows ? *parameters.rows : *parameters.columns;
  auto& other = has_rows ? parameters.columns : parameters.rows;
  if (given == 0 || neurons % given != 0 || (other && *other != neurons / given)) {
    const std::string sides =
        other ? fmt::format("{} rows of {} columns", *parameters.rows, *parameters.columns)
              : fmt::format("a multiple of {} {}", given, has_rows ? "rows" : "columns");
    return refuse_weights(fmt::format("the array has {} neurons, which are not {}", neurons, sides),
                          where, "give the rows and columns of the map");
  }
  other = neurons / given;
  return {};
}

Result<void> check_numbers(const Matrix<float>& weights, const std::string& where) {
  for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) {
    for (std::size_t d = 0; d < weights.columns(); ++d) {
      if (std::isfinite(weights(neuron, d))) continue;
      return refuse_weights(
          fmt::format("the weight of neuron {} for feature {} (counted from 0) is not a "
                      "finite number",
                      neuron, d),
          where, "give numbers that float32 can hold");
    }
  }
  return {};
}

// The winner of a dot-product map is that of the smallest angle only if weights have one length.
Result<void> check_lengths(const SomParameters& parameters, const Matrix<float>& weights,
                           const std::string& where) {
  constexpr double kRounding = 1e-4;  // float32 has seven digits; several steps are rounded.
  if (parameters.similarity != Similarity::kDotProduct) return {};
  for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) {
    double squares = 0.0;
    for (const float weight : weights.row(neuron)) squares += double{weight} * double{weight};
    if (std::abs(std::sqrt(squares) - 1.0) <= kRounding) continue;
    return refuse_weights(
        fmt::format("the weights of neuron {} (counted from 0) have length {:.4g}, but "
                    "those of a dot-product map have length 1",
                    neuron, std::sqrt(squares)),
        where,
        "divide the weights of each neuron by their length, or use another "
        "similarity");
  }
  return {};
}

}  // namespace

Result<MapArray> map_array_in_npy(std::string_view bytes, const std::string& where) {
  SOMATO_TRY(const NpyLayout layout, npy_layout_of_any(bytes, bytes.size(), where));
  const std::size_t dimensions = layout.shape.size();
  if (dimensions < 2 || dimensions > 3) {
    return fail(ErrorKind::kData,
                fmt::format("the array has {} dimensions instead of 2 or 3", dimensions), where,
                "save an array of rows x columns x features, or neurons x features");
  }
  SOMATO_TRY_VOID(check_free_memory(layout.rows * layout.columns, sizeof(float), where));
  SOMATO_TRY(NpyReading reading, npy_reading(layout, {}, where));
  SOMATO_TRY(auto weights, npy_matrix(bytes, layout, reading, where));
  if (layout.fortran_order && dimensions == 3) {
    weights = row_by_row(weights, layout.shape[0], layout.shape[1]);
  }
  return MapArray{layout.shape, std::move(weights)};
}

Result<SomModel> map_of_weights(SomParameters parameters, const MapArray& array,
                                std::vector<std::string> features, const std::string& where) {
  SOMATO_TRY_VOID(take_sides(array, parameters, where));
  const Matrix<float>& weights = array.weights;
  if (!features.empty() && features.size() != weights.columns()) {
    return refuse_weights(
        fmt::format("there are {} names for {} features", features.size(), weights.columns()),
        where, "give one name for each feature, or none");
  }
  if (std::set(features.begin(), features.end()).size() != features.size()) {
    return refuse_weights("two features have the same name", where,
                          "give each feature a name of its own");
  }
  SOMATO_TRY_VOID(check_numbers(weights, where));
  SOMATO_TRY_VOID(check_lengths(parameters, weights, where));
  auto resolved = resolve(parameters, weights.rows(), weights.columns());
  if (!resolved) {
    if (resolved.error().where.empty()) resolved.error().where = where;
    return fail(std::move(resolved.error()));
  }
  for (const auto& fits : {check_layers(*resolved, weights.columns()), check_scales(*resolved)}) {
    if (!fits) return fail(fits.error());
  }
  resolved->arithmetic = Arithmetic::kPlain;  // There are no samples for inner products.
  SomModel model{Som(*resolved, weights), std::move(features), {}, {}, {}, {}};
  if (resolved->training == Training::kOnline) model.samples_seen = 0;  // None are known.
  return model;
}

}  // namespace somato
