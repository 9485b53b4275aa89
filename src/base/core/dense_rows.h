#pragma once

#include <cstddef>

#include "somato/core/matrix.h"
#include "somato/core/samples.h"

namespace somato {

/// All values of the samples, one row each; elements that sparse samples do not store are 0.
inline Matrix<float> dense_rows(const Samples& samples) {
  Matrix<float> rows(samples.count(), samples.size());
  for (std::size_t i = 0; i < samples.count(); ++i) write_dense(samples[i], rows.row(i));
  return rows;
}

}  // namespace somato
