// The kernels of t_mpsom_kernels.h.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/core/lanes.h"
#include "base/kernels/t_mpsom_kernels.h"
#include "guard.h"

namespace somato::bench {
namespace {

static_assert(kKernels<kernels::TMpsomTable> == 15, "count each of them");

constexpr std::size_t kRows = 240;
constexpr std::size_t kColumns = 300;
constexpr std::size_t kNeurons = 1003;

void count_band(const Counted& counted) {
  constexpr std::size_t kFirst = 20;
  constexpr std::size_t kListed = 120;
  const LaneMatrix<float> map = noisy_map<float>(kRows, kColumns);
  const LaneMatrix<float> mask = noisy_map<float>(kRows, 2 * kListed);
  std::vector<std::uint32_t> columns(kListed);
  for (std::uint32_t i = 0; i < kListed; ++i)
    columns[i] = static_cast<std::uint32_t>(kFirst) + 2 * i;
  const auto x = noise<float>(kListed, 71);
  AlignedVector<float> out(map.padded_rows());
  counted(
      "t_mpsom.banded_inner_products",
      [&] {
        kernels::t_mpsom_table().banded_inner_products(kernels::lanes(map), kernels::lanes(mask),
                                                       kFirst, columns.data(), x.data(), kListed,
                                                       out.data());
      },
      [&] { return digest_of(out); });
}

void count_moves(const Counted& counted) {
  const auto& table = kernels::t_mpsom_table();
  LaneMatrix<float> map = noisy_map<float>(kRows, kColumns);
  const auto w = kernels::lanes(map);
  const auto x = noise<float>(kColumns, 72);
  const auto gains = noise<float>(map.padded_rows(), 73);
  AlignedVector<float> keep(gains.size());
  AlignedVector<float> add(gains.size());
  AlignedVector<float> doubtful(gains.size());
  const kernels::Moves moves{keep.data(), add.data(), doubtful.data()};
  const kernels::Lanes<const float> read{w.values, w.blocks, w.columns};
  const Digest of_moves = [&] { return digest_of(keep, digest_of(add, digest_of(doubtful))); };
  bool certain = false;
  counted(
      "t_mpsom.find_unit_moves",
      [&] { certain = table.find_unit_moves(read, x.data(), 100.0F, gains.data(), moves); },
      [&] { return digest_with(of_moves(), certain ? 1.0 : 0.0); });
  counted("t_mpsom.move", [&] { table.move(w, x.data(), moves); }, [&] { return digest_of(map); });
  AlignedVector<float> partial(gains.size());
  AlignedVector<float> products(gains.size());
  AlignedVector<float> squares(gains.size());
  const kernels::Measures measures{partial.data(), products.data(), squares.data()};
  const LaneMatrix<float> mask = noisy_map<float>(kRows, kColumns / 2);
  const kernels::ReceptiveInput input{kernels::lanes(mask), 20, x.data(), false};
  counted(
      "t_mpsom.move_and_measure",
      [&] { table.move_and_measure(w, x.data(), moves, input, measures); },
      [&] { return digest_of(partial, digest_of(products, digest_of(squares, digest_of(map)))); });
  counted(
      "t_mpsom.find_measured_moves",
      [&] {
        certain = table.find_measured_moves(measures, map.blocks(), 100.0F, gains.data(), moves);
      },
      [&] { return digest_with(of_moves(), certain ? 1.0 : 0.0); });
  counted(
      "t_mpsom.find_plain_moves",
      [&] { table.find_plain_moves(gains.data(), map.blocks(), moves); }, of_moves);
}

void count_activity(const Counted& counted) {
  const auto& table = kernels::t_mpsom_table();
  const auto p = noise<float>(kNeurons, 74);
  AlignedVector<double> y(kNeurons);
  const Digest bits = [&] { return digest_of(y); };
  counted(
      "t_mpsom.start_activity", [&] { table.start_activity(p.data(), kNeurons, y.data()); }, bits);
  counted(
      "t_mpsom.multiply_activity", [&] { table.multiply_activity(p.data(), kNeurons, y.data()); },
      bits);
  counted("t_mpsom.add_activity", [&] { table.add_activity(p.data(), kNeurons, y.data()); }, bits);
}

void count_gains(const Counted& counted) {
  const auto& table = kernels::t_mpsom_table();
  auto y = noise<double>(kNeurons, 75);
  for (double& value : y) value -= 0.5;
  AlignedVector<double> out(kNeurons);
  bool finite = false;
  counted(
      "t_mpsom.rectify", [&] { finite = table.rectify(y.data(), kNeurons, out.data()); },
      [&] { return digest_with(digest_of(out), finite ? 1.0 : 0.0); });
  double largest = 0.0;
  counted(
      "t_mpsom.largest", [&] { largest = table.largest(out.data(), kNeurons); },
      [&] { return digest_with(1, largest); });
  AlignedVector<float> gains(kNeurons);
  counted(
      "t_mpsom.find_gains",
      [&] { table.find_gains(out.data(), kNeurons, largest, 0.1, gains.data()); },
      [&] { return digest_of(gains, digest_of(out)); });
  const AlignedVector<float> zeros(1024);  // so that all are looked at
  bool found = true;
  counted(
      "t_mpsom.any",
      [&] { found = table.any(zeros.data(), zeros.size() / LaneMatrix<float>::kLanes); },
      [&] { return digest_with(1, found ? 1.0 : 0.0); });
}

void count_spreading(const Counted& counted) {
  const auto& table = kernels::t_mpsom_table();
  constexpr std::size_t kReach = 8;
  constexpr std::size_t kMiddle = kReach + kernels::kSpreadGroup;
  constexpr std::size_t kPlaces = 46;
  constexpr std::size_t kWidth = 23;
  const auto some = noise<double>(2 * kReach + 1, 76);
  std::vector<double> factors(2 * kMiddle + 1);
  std::copy(some.begin(), some.end(), factors.begin() + kernels::kSpreadGroup);
  const auto in = noise<double>(kPlaces * kWidth, 77);
  std::vector<double> out(in.size());
  const Digest bits = [&] { return digest_of(out); };
  counted(
      "t_mpsom.spread_rows",
      [&] {
        table.spread_rows(in.data(), kPlaces, kWidth, factors.data() + kMiddle, kReach, out.data());
      },
      bits);
  std::vector<double> line(in.size() + 2 * kReach);
  std::copy(in.begin(), in.end(), line.begin() + kReach);
  counted(
      "t_mpsom.spread_line",
      [&] {
        table.spread_line(line.data() + kReach, in.size(), factors.data() + kMiddle, kReach,
                          out.data());
      },
      bits);
}

}  // namespace

void count_t_mpsom_kernels(const Counted& counted) {
  count_band(counted);
  count_moves(counted);
  count_activity(counted);
  count_gains(counted);
  count_spreading(counted);
}

}  // namespace somato::bench
