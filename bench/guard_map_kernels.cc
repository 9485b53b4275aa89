// The kernels of kernels.h, for both types of number.

#include <cstdint>
#include <string>
#include <vector>

#include "base/core/lanes.h"
#include "base/kernels/kernels.h"
#include "guard.h"

namespace somato::bench {
namespace {

constexpr std::size_t kRows = 240;
constexpr std::size_t kColumns = 300;
constexpr std::size_t kListed = 64;

static_assert(kKernels<kernels::Table<float>> == 10, "count each of them");

std::vector<std::uint32_t> listed_columns() {
  std::vector<std::uint32_t> columns;
  columns.reserve(kListed);
  for (std::uint32_t i = 0; i < kListed; ++i) columns.push_back(i * 4 + i % 3);
  return columns;
}

// The kernels that only read the map.
template <typename Real>
void count_sums(const std::string& type, const Counted& counted) {
  const auto& table = kernels::table<Real>();
  const LaneMatrix<Real> map = noisy_map<Real>(kRows, kColumns);
  const auto w = kernels::lanes(map);
  const auto x = noise<Real>(kColumns, 1);
  const auto columns = listed_columns();
  AlignedVector<Real> out(map.padded_rows());
  const auto count = [&](const std::string& name, const Work& kernel) {
    counted(type + "." + name, kernel, [&] { return digest_of(out); });
  };
  count("squared_distances", [&] { table.squared_distances(w, x.data(), out.data()); });
  count("inner_products", [&] { table.inner_products(w, x.data(), out.data()); });
  count("sparse_inner_products",
        [&] { table.sparse_inner_products(w, columns.data(), x.data(), kListed, out.data()); });
  count("squared_norms", [&] { table.squared_norms(w, out.data()); });
}

// Those that change it.
template <typename Real>
void count_updates(const std::string& type, const Counted& counted) {
  const auto& table = kernels::table<Real>();
  LaneMatrix<Real> map = noisy_map<Real>(kRows, kColumns);
  const auto w = kernels::lanes(map);
  const auto x = noise<Real>(kColumns, 1);
  const auto gains = noise<Real>(map.padded_rows(), 3);
  const auto count = [&](const std::string& name, const Work& kernel) {
    counted(type + "." + name, kernel, [&] { return digest_of(map); });
  };
  count("move_towards", [&] { table.move_towards(w, x.data(), gains.data()); });
  count("scale_rows", [&] { table.scale_rows(w, gains.data()); });
  count("clear_negligible", [&] { table.clear_negligible(w); });
}

// Those on plain vectors.
template <typename Real>
void count_vectors(const std::string& type, const Counted& counted) {
  const auto& table = kernels::table<Real>();
  constexpr std::size_t kLength = 4096;
  const auto a = noise<Real>(kLength, 4);
  const auto b = noise<Real>(kLength, 5);
  const auto columns = listed_columns();
  std::vector<double> sums(kLength);
  counted(
      type + ".add_scaled", [&] { table.add_scaled(a.data(), 0.3, kLength, sums.data()); },
      [&] { return digest_of(sums); });
  double product = 0.0;
  const Digest of_product = [&] { return digest_with(1, product); };
  counted(
      type + ".product", [&] { product = table.product(a.data(), b.data(), kLength); }, of_product);
  counted(
      type + ".sparse_product",
      [&] { product = table.sparse_product(columns.data(), a.data(), kListed, b.data()); },
      of_product);
}

template <typename Real>
void count_type(const std::string& type, const Counted& counted) {
  count_sums<Real>(type, counted);
  count_updates<Real>(type, counted);
  count_vectors<Real>(type, counted);
}

}  // namespace

void count_map_kernels(const Counted& counted) {
  count_type<float>("float", counted);
  count_type<double>("double", counted);
}

}  // namespace somato::bench
