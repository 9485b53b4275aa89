#pragma once

// The data of the benchmarks: a function of the sizes only, so that all programs use the same data.

#include <cstddef>
#include <string>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som_parameters.h"

namespace somato::bench {

enum class DataKind {
  kUniform,    ///< Uniform in [0, 1).
  kSparse,     ///< One element in a hundred is not zero, and uniform in [0, 1).
  kClustered,  ///< 50 Gaussian clusters of standard deviation 0.1 around uniform centres.
};

/// A case to run: data, a map and how long it learns.
struct Workload {
  std::string name;
  DataKind kind = DataKind::kUniform;
  std::size_t samples = 0;
  std::size_t features = 0;
  SomParameters parameters;

  bool is_batch() const { return parameters.training == Training::kBatch; }
};

/// The samples of a case.
Samples make_samples(const Workload& workload);

/// Writes `rows` x `columns` uniform numbers as an NPY file, a row at a time, so that the file may
/// be larger than memory.
Result<void> write_large_npy(const std::string& path, std::size_t rows, std::size_t columns);

}  // namespace somato::bench
