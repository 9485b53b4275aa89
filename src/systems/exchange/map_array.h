#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/graph/som_model.h"

namespace somato {

/// The weights of a map in an array of (rows, columns, features) or (neurons, features).
struct MapArray {
  std::vector<std::uint64_t> shape;
  Matrix<float> weights;  ///< neurons x features, the neurons row by row.
};

/// The array in the bytes of an NPY file, from the source `where`. Errors (kData): another number
/// of dimensions, another type, a file that is damaged, a number that is not a finite float32, and
/// columns of numbers of which float32 does not hold what differs.
Result<MapArray> map_array_in_npy(std::string_view bytes, const std::string& where);

/// A map with these weights. Rows and columns are those of the array; an array of (neurons,
/// features) requires them in `parameters`, or one of them. Other automatic parameters are resolved
/// as for a training. Errors (kUsage, at `where`): `parameters` contradict the array or each other,
/// `features` are not as many as the columns, a weight is not finite, or the weights of a
/// dot-product map do not have length 1.
Result<SomModel> map_of_weights(SomParameters parameters, const MapArray& array,
                                std::vector<std::string> features, const std::string& where);

}  // namespace somato
