#include "workload_list.h"

#include <algorithm>
#include <utility>

namespace somato::bench {
namespace {

// At least as many as a map needs to learn anything.
std::size_t part(std::size_t whole, std::size_t scale) {
  return std::max<std::size_t>(whole / scale, 10);
}

SomParameters square_map(std::size_t side) {
  SomParameters p;
  p.rows = side;
  p.columns = side;
  p.radius_start = static_cast<double>(side) / 2.0;
  return p;
}

// The radius is at its end in the last epoch, not after it.
SomParameters in_batch(SomParameters p, std::uint64_t epochs) {
  p.training = Training::kBatch;
  p.epochs = epochs;
  p.radius_reached_at = std::max<std::uint64_t>(1, epochs - 1);
  return p;
}

SomParameters online(SomParameters p, std::uint64_t iterations) {
  p.iterations = iterations;
  return p;
}

SomParameters from(SomParameters p, InitialWeights initial) {
  p.initial_weights = initial;
  return p;
}

SomParameters hexagonal(SomParameters p) {
  p.lattice = Lattice::kHexagonal;
  return p;
}

SomParameters by(SomParameters p, Similarity similarity) {
  p.similarity = similarity;
  return p;
}

SomParameters in_two_layers(SomParameters p, std::size_t features) {
  const std::size_t half = features / 2;
  p.layers = {{.name = "left", .first = 0, .count = half},
              {.name = "right",
               .first = half,
               .count = features - half,
               .similarity = Similarity::kManhattan}};
  return p;
}

}  // namespace

std::vector<Workload> all_workloads(std::size_t scale) {
  const SomParameters large = square_map(50);
  const SomParameters small = square_map(15);
  const SomParameters dense = from(in_batch(large, 10), InitialWeights::kUniform);
  const std::size_t many = part(20000, scale);
  const std::size_t wide = part(270000, scale);
  const auto sparse = [&](std::string name, SomParameters parameters) {
    return Workload{std::move(name), DataKind::kSparse, 30, wide, std::move(parameters)};
  };
  const SomParameters steps = online(small, part(1000, scale));
  return {
      {"dense_batch", DataKind::kUniform, many, 256, dense},
      {"hexagonal_batch", DataKind::kUniform, many, 256, hexagonal(dense)},
      {"few_samples", DataKind::kUniform, 40, 2049, online(small, part(2000, scale))},
      {"few_samples_streaming", DataKind::kUniform, 40, 2049, online(small, part(2000, scale))},
      sparse("sparse_uniform_start", from(steps, InitialWeights::kUniform)),
      sparse("sparse_sample_start", from(steps, InitialWeights::kSamples)),
      sparse("sparse_batch", in_batch(small, 33)),
      sparse("sparse_streaming", from(steps, InitialWeights::kUniform)),
      {"winners", DataKind::kUniform, part(100000, scale), 64,
       from(in_batch(large, 0), InitialWeights::kSamples)},
      {"winners_manhattan", DataKind::kUniform, part(100000, scale), 64,
       by(from(in_batch(large, 0), InitialWeights::kSamples), Similarity::kManhattan)},
      {"winners_chebyshev", DataKind::kUniform, part(100000, scale), 64,
       by(from(in_batch(large, 0), InitialWeights::kSamples), Similarity::kChebyshev)},
      {"winners_cosine", DataKind::kUniform, part(100000, scale), 64,
       by(from(in_batch(large, 0), InitialWeights::kSamples), Similarity::kCosine)},
      {"manhattan_batch", DataKind::kUniform, many, 256, by(dense, Similarity::kManhattan)},
      {"many_online", DataKind::kUniform, many, 64, online(large, part(20000, scale))},
      {"many_online_manhattan", DataKind::kUniform, many, 64,
       by(online(large, part(20000, scale)), Similarity::kManhattan)},
      {"layers_batch", DataKind::kUniform, many, 64, in_two_layers(dense, 64)},
      {"layers_online", DataKind::kUniform, many, 64,
       in_two_layers(online(large, part(20000, scale)), 64)},
      {"clustered_search", DataKind::kClustered, many, 256, in_batch(large, 10)},
      {"clustered_search_of_all", DataKind::kClustered, many, 256, in_batch(large, 10)},
  };
}

}  // namespace somato::bench
