#include "workload_data.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <utility>
#include <vector>

#include "somato/core/random.h"

namespace somato::bench {
namespace {

constexpr std::uint64_t kSeed = 2026;
constexpr std::size_t kClusters = 50;
constexpr double kSpread = 0.1;

Matrix<float> uniform_rows(std::size_t count, std::size_t size) {
  Matrix<float> rows(count, size);
  for (std::size_t i = 0; i < count; ++i) {
    uniform_row(kSeed, Stream::kUser, static_cast<std::uint32_t>(i), rows.row(i));
  }
  return rows;
}

Samples uniform(const Workload& workload) {
  return Samples(uniform_rows(workload.samples, workload.features));
}

// Every element is drawn by itself, so that samples differ in how many they use.
Samples sparse(const Workload& workload) {
  Random random(kSeed);
  std::vector<Signal> signals;
  signals.reserve(workload.samples);
  for (std::size_t i = 0; i < workload.samples; ++i) {
    std::vector<std::uint32_t> indices;
    std::vector<float> values;
    for (std::uint32_t element = 0; element < workload.features; ++element) {
      if (random.below(100) != 0) continue;
      indices.push_back(element);
      values.push_back(static_cast<float>(random.uniform()));
    }
    signals.push_back(Signal::sparse({workload.features}, std::move(indices), std::move(values)));
  }
  return Samples::from_signals(signals);
}

Samples clustered(const Workload& workload) {
  Random random(kSeed);
  const Matrix<float> centres = uniform_rows(kClusters, workload.features);
  Matrix<float> rows(workload.samples, workload.features);
  for (std::size_t i = 0; i < workload.samples; ++i) {
    const auto centre = centres.row(random.below(kClusters));
    for (std::size_t d = 0; d < workload.features; ++d) {
      rows(i, d) = centre[d] + static_cast<float>(kSpread * random.normal());
    }
  }
  return Samples(std::move(rows));
}

// Version 1.0 of the format, filled up to 128 bytes.
std::string npy_header(std::size_t rows, std::size_t columns) {
  constexpr std::size_t kDictionary = 118;
  const std::string text =
      fmt::format("{{'descr': '<f4', 'fortran_order': False, 'shape': ({}, {}), }}", rows, columns);
  return fmt::format("\x93NUMPY{}{}{:<{}}\n", std::string("\x01\0", 2), std::string("v\0", 2), text,
                     kDictionary - 1);
}

}  // namespace

Samples make_samples(const Workload& workload) {
  if (workload.kind == DataKind::kSparse) return sparse(workload);
  return workload.kind == DataKind::kClustered ? clustered(workload) : uniform(workload);
}

Result<void> write_large_npy(const std::string& path, std::size_t rows, std::size_t columns) {
  std::ofstream file(path, std::ios::binary);
  file << npy_header(rows, columns);
  std::vector<float> row(columns);
  for (std::size_t i = 0; i < rows; ++i) {
    uniform_row(kSeed, Stream::kUser, static_cast<std::uint32_t>(i), row);
    file.write(reinterpret_cast<const char*>(row.data()),  // NOLINT: bytes of a file
               static_cast<std::streamsize>(columns * sizeof(float)));
  }
  if (!file.flush()) return fail(ErrorKind::kData, "cannot be written", path);
  return {};
}

}  // namespace somato::bench
