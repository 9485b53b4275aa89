// Fixed work for each family of kernels, and small whole trainings, for callgrind to count the
// instructions of (bench/guard.py): no clock, and the same count on every run.
//
//     guard SET         does everything with this instruction set, printing a name and a checksum
//     each guard --check   with every set that this processor has; fails when results are not the
//     same bits

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/kernels.h"
#include "core/lanes.h"
#include "somato/core/instruction_set.h"
#include "somato/core/random.h"
#include "somato/maps/batch_training.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_training.h"
#include "somato/maps/t_mpsom.h"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_ZERO_STATS
#define CALLGRIND_DUMP_STATS_AT(name)
#endif

namespace somato::bench {
namespace {

constexpr std::size_t kRows = 240;
constexpr std::size_t kColumns = 300;
constexpr std::size_t kListed = 64;

using Work = std::function<void()>;
using Checksum = std::function<double()>;

// Counts what `work` does under `name`; the bits of the checksum taken afterwards are the result.
using Counted = std::function<void(const std::string& name, const Work& work, const Checksum& sum)>;

template <typename Real>
AlignedVector<Real> noise(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  AlignedVector<Real> values(count);
  for (Real& value : values) value = static_cast<Real>(random.uniform());
  return values;
}

template <typename Real>
double total(const AlignedVector<Real>& values) {
  double sum = 0.0;
  for (const Real value : values) sum += static_cast<double>(value);
  return sum;
}

template <typename Real>
LaneMatrix<Real> noisy_map() {
  LaneMatrix<Real> map(kRows, kColumns);
  Random random(7);
  for (std::size_t row = 0; row < kRows; ++row) {
    for (std::size_t d = 0; d < kColumns; ++d) map(row, d) = static_cast<Real>(random.uniform());
  }
  return map;
}

std::vector<std::uint32_t> listed_columns() {
  std::vector<std::uint32_t> columns;
  columns.reserve(kListed);
  for (std::uint32_t i = 0; i < kListed; ++i) columns.push_back(i * 4 + i % 3);
  return columns;
}

template <typename Real>
double total(const LaneMatrix<Real>& map) {
  double sum = 0.0;
  for (std::size_t row = 0; row < map.rows(); ++row) {
    for (std::size_t d = 0; d < map.columns(); ++d) sum += static_cast<double>(map(row, d));
  }
  return sum;
}

// The kernels that only read the map.
template <typename Real>
void count_sums(const std::string& type, const Counted& counted) {
  const auto& table = kernels::table<Real>();
  const LaneMatrix<Real> map = noisy_map<Real>();
  const auto w = kernels::lanes(map);
  const auto x = noise<Real>(kColumns, 1);
  const auto mask = noise<Real>(map.padded_rows() * kColumns, 2);
  const auto columns = listed_columns();
  AlignedVector<Real> out(map.padded_rows());
  const auto count = [&](const std::string& name, const Work& kernel) {
    counted(type + "." + name, kernel, [&] { return total(out); });
  };
  count("squared_distances", [&] { table.squared_distances(w, x.data(), out.data()); });
  count("inner_products", [&] { table.inner_products(w, x.data(), out.data()); });
  count("sparse_inner_products",
        [&] { table.sparse_inner_products(w, columns.data(), x.data(), kListed, out.data()); });
  count("sparse_masked_inner_products", [&] {
    table.sparse_masked_inner_products(w, mask.data(), columns.data(), x.data(), kListed,
                                       out.data());
  });
  count("squared_norms", [&] { table.squared_norms(w, out.data()); });
  count("invert_square_roots", [&] { table.invert_square_roots(out.data(), map.blocks()); });
}

// Those that change it.
template <typename Real>
void count_updates(const std::string& type, const Counted& counted) {
  const auto& table = kernels::table<Real>();
  LaneMatrix<Real> map = noisy_map<Real>();
  const auto w = kernels::lanes(map);
  const auto x = noise<Real>(kColumns, 1);
  const auto gains = noise<Real>(map.padded_rows(), 3);
  AlignedVector<Real> norms(map.padded_rows());
  const auto count = [&](const std::string& name, const Work& kernel) {
    counted(type + "." + name, kernel, [&] { return total(map) + total(norms); });
  };
  count("move_towards", [&] { table.move_towards(w, x.data(), gains.data()); });
  count("move_and_measure",
        [&] { table.move_and_measure(w, x.data(), gains.data(), norms.data()); });
  count("scale_rows", [&] { table.scale_rows(w, gains.data()); });
  count("clear_negligible", [&] { table.clear_negligible(w); });
}

// Those on plain vectors.
template <typename Real>
void count_vectors(const std::string& type, const Counted& counted) {
  const auto& table = kernels::table<Real>();
  constexpr std::size_t kLength = 4096;
  constexpr std::size_t kReach = 8;
  const auto a = noise<Real>(kLength, 4);
  const auto b = noise<Real>(kLength, 5);
  const auto columns = listed_columns();
  std::vector<double> sums(kLength);
  counted(
      type + ".add_scaled", [&] { table.add_scaled(a.data(), 0.3, kLength, sums.data()); },
      [&] { return sums[1] + sums[kLength - 1]; });
  double product = 0.0;
  const Checksum of_product = [&] { return product; };
  counted(
      type + ".product", [&] { product = table.product(a.data(), b.data(), kLength); }, of_product);
  counted(
      type + ".sparse_product",
      [&] { product = table.sparse_product(columns.data(), a.data(), kListed, b.data()); },
      of_product);
  constexpr std::size_t kMiddle = kReach + kernels::kSpreadGroup;
  AlignedVector<Real> factors(2 * kMiddle + 1);
  for (std::size_t i = kMiddle - kReach; i <= kMiddle + kReach; ++i) factors[i] = b[i];
  AlignedVector<Real> out(kLength);
  counted(
      type + ".spread",
      [&] {
        table.spread(a.data(), kLength * sizeof(Real) / 64, factors.data() + kMiddle, kReach,
                     out.data());
      },
      [&] { return total(out); });
}

template <typename Real>
void count_kernels(const std::string& type, const Counted& counted) {
  count_sums<Real>(type, counted);
  count_updates<Real>(type, counted);
  count_vectors<Real>(type, counted);
}

Samples samples_of(std::size_t count, std::size_t size) {
  const auto values = noise<float>(count * size, 6);
  return Samples(Matrix<float>(count, size, std::vector<float>(values.begin(), values.end())));
}

SomParameters map_of(std::size_t side) {
  SomParameters parameters;
  parameters.rows = side;
  parameters.columns = side;
  return parameters;
}

void count_batch(Lattice lattice, const std::string& name, const Counted& counted) {
  SomParameters parameters = map_of(20);
  parameters.training = Training::kBatch;
  parameters.lattice = lattice;
  const Samples samples = samples_of(200, 64);
  Som som = untrained_som(parameters, samples).value();
  counted(name, [&] { batch_epoch(som, samples, 5.0, 1); }, [&] { return total(som.weights()); });
}

void count_stream(const Counted& counted) {
  const Samples samples = samples_of(50, 256);
  Som som = untrained_som(map_of(15), samples).value();
  const auto learn = [&] {
    SomLearner learner(som);
    for (std::size_t i = 0; i < samples.count(); ++i) learner.learn(samples[i], 0.1, 3.0);
  };
  counted("online_50_iterations", learn, [&] { return total(som.weights()); });
}

void count_few_samples(const Counted& counted) {
  SomParameters parameters = map_of(15);
  parameters.iterations = 100;
  const Samples samples = samples_of(20, 512);
  Som som;
  counted(
      "few_samples_100_iterations", [&] { som = train_som(parameters, samples).value(); },
      [&] { return total(som.weights()); });
}

void count_winners(const Counted& counted) {
  const Samples samples = samples_of(200, 64);
  const Som som = untrained_som(map_of(20), samples).value();
  std::vector<std::size_t> winners;
  counted(
      "winners_200", [&] { winners = winners_of(som, samples, 1); },
      [&] { return std::accumulate(winners.begin(), winners.end(), 0.0); });
}

void count_t_mpsom(const Counted& counted) {
  TMpsomParameters parameters;
  parameters.shape = {46, 23};
  parameters.input_sizes = {90, 45};
  TMpsom map(parameters);
  TMpsom::Workspace workspace(map);
  const auto posture = noise<float>(90, 8);
  const auto touch = noise<float>(45, 9);
  const std::vector<SignalView> frame{SignalView::dense(posture), SignalView::dense(touch)};
  counted(
      "t_mpsom_iteration", [&] { map.learn(frame, 0.1, workspace); },
      [&] { return workspace.activity()[0] + double{map.weights(1)(5, 5)}; });
}

void count_all(const Counted& counted) {
  count_kernels<float>("float", counted);
  count_kernels<double>("double", counted);
  count_batch(Lattice::kRectangular, "batch_epoch", counted);
  count_batch(Lattice::kHexagonal, "batch_epoch_hexagonal", counted);
  count_stream(counted);
  count_few_samples(counted);
  count_winners(counted);
  count_t_mpsom(counted);
}

using Checksums = std::map<std::string, std::uint64_t>;

Checksums checksums_with(InstructionSet set) {
  use_instruction_set(set);
  Checksums sums;
  count_all([&](const std::string& name, const Work& work, const Checksum& sum) {
    CALLGRIND_ZERO_STATS;
    work();
    CALLGRIND_DUMP_STATS_AT(name.c_str());
    sums[name] = std::bit_cast<std::uint64_t>(sum());
  });
  return sums;
}

int check_sets() {
  const Checksums portable = checksums_with(InstructionSet::kPortable);
  for (const InstructionSet set : available_instruction_sets()) {
    if (checksums_with(set) == portable) continue;
    std::cerr << "guard: " << choice_name(set) << " gives other bits\n";
    return 1;
  }
  return 0;
}

int run_with(const std::string& name) {
  for (const InstructionSet set : available_instruction_sets()) {
    if (choice_name(set) != name) continue;
    for (const auto& [what, bits] : checksums_with(set)) fmt::print("{} {:016x}\n", what, bits);
    return 0;
  }
  std::cerr << "guard: there is no instruction set '" << name << "' here\n";
  return 3;
}

}  // namespace
}  // namespace somato::bench

int main(int count, char** arguments) {
  const std::string what = count > 1 ? arguments[1] : "--check";
  if (what == "--compiler") {
#if defined(__clang__)
    fmt::print("clang++ {}.{}\n", __clang_major__, __clang_minor__);
#else
    fmt::print("g++ {}.{}\n", __GNUC__, __GNUC_MINOR__);
#endif
    return 0;
  }
  return what == "--check" ? somato::bench::check_sets() : somato::bench::run_with(what);
}
