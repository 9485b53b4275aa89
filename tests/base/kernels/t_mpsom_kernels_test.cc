#include "base/kernels/t_mpsom_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/core/lanes.h"
#include "base/support/instruction_sets.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr std::size_t kArborLanes = LaneMatrix<float>::kLanes;

LaneMatrix<float> random_lanes(Random& random, std::size_t rows, std::size_t columns) {
  LaneMatrix<float> lanes(rows, columns);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t k = 0; k < columns; ++k) lanes(row, k) = static_cast<float>(random.uniform());
  }
  return lanes;
}

template <typename Values>
Values random_values(Random& random, std::size_t count) {
  Values values(count);
  for (auto& value : values) value = static_cast<typename Values::value_type>(random.uniform());
  return values;
}

// Six values a lane: moves of up to four blocks.
struct RoomForMoves {
  AlignedVector<float> keep = AlignedVector<float>(4 * kArborLanes);
  AlignedVector<float> add = AlignedVector<float>(4 * kArborLanes);
  AlignedVector<float> doubtful = AlignedVector<float>(4 * kArborLanes);
  kernels::Moves moves() { return {keep.data(), add.data(), doubtful.data()}; }
};

TEST(TMpsomKernels, SumProductsOverABand) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const std::size_t rows = 1 + random.below(64);
    const std::size_t columns = 1 + random.below(600);
    const std::size_t first = random.below(columns);
    const LaneMatrix<float> w = random_lanes(random, rows, columns);
    const LaneMatrix<float> mask = random_lanes(random, rows, 1 + random.below(columns - first));
    std::vector<std::uint32_t> listed;
    for (std::size_t k = 0; k < mask.columns(); ++k) {
      if (random.below(3) > 0) listed.push_back(static_cast<std::uint32_t>(first + k));
    }
    const auto x = random_values<std::vector<float>>(random, listed.size());
    AlignedVector<float> before;
    testing::for_each_instruction_set([&](InstructionSet set) {
      AlignedVector<float> out(w.padded_rows());
      kernels::t_mpsom_table().banded_inner_products(kernels::lanes(w), kernels::lanes(mask), first,
                                                     listed.data(), x.data(), listed.size(),
                                                     out.data());
      for (std::size_t row = 0; row < rows; ++row) {
        double expected = 0.0;
        for (std::size_t j = 0; j < listed.size(); ++j) {
          expected +=
              double{mask(row, listed[j] - first)} * double{w(row, listed[j])} * double{x[j]};
        }
        EXPECT_NEAR(double{out[row]}, expected, 1e-5 * expected) << name_of(set);
      }
      if (before.empty()) before = out;
      EXPECT_EQ(out, before) << name_of(set);
    });
  }
}

TEST(TMpsomKernels, FindMovesToUnitLength) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const std::size_t blocks = 1 + random.below(4);
    const std::size_t columns = 1 + random.below(600);
    const LaneMatrix<float> w = random_lanes(random, blocks * kArborLanes, columns);
    const auto x = random_values<std::vector<float>>(random, columns);
    const auto gains = random_values<AlignedVector<float>>(random, blocks * kArborLanes);
    double squared = 0.0;
    for (const float value : x) squared += double{value} * double{value};
    AlignedVector<float> before;
    testing::for_each_instruction_set([&](InstructionSet set) {
      RoomForMoves room;
      EXPECT_TRUE(kernels::t_mpsom_table().find_unit_moves(
          kernels::lanes(w), x.data(), static_cast<float>(squared), gains.data(), room.moves()));
      for (std::size_t row = 0; row < w.rows(); ++row) {
        double length = 0.0;
        for (std::size_t k = 0; k < columns; ++k) {
          const double moved =
              double{room.keep[row]} * double{w(row, k)} + double{room.add[row]} * double{x[k]};
          length += moved * moved;
        }
        EXPECT_NEAR(length, 1.0, 2e-6) << name_of(set);
        EXPECT_NEAR(room.add[row] * (1.0F - gains[row]), room.keep[row] * gains[row], 1e-6F);
      }
      AlignedVector<float> found = room.keep;
      found.insert(found.end(), room.add.begin(), room.add.end());
      if (before.empty()) before = found;
      EXPECT_EQ(found, before) << name_of(set);
    });
  }
}

// Room for what a pass measures of up to four blocks.
struct RoomForMeasures {
  AlignedVector<float> partial = AlignedVector<float>(4 * kArborLanes);
  AlignedVector<float> products = AlignedVector<float>(4 * kArborLanes);
  AlignedVector<float> squares = AlignedVector<float>(4 * kArborLanes);
  kernels::Measures measures() { return {partial.data(), products.data(), squares.data()}; }
};

// One pass gives the bits of the passes that it stands for: the move, the sums over the field, and
// the moves to unit length that follow.
TEST(TMpsomKernels, MoveAndMeasureInOnePass) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const std::size_t rows = 1 + random.below(4 * kArborLanes);
    const std::size_t columns = 1 + random.below(kernels::kChunk);
    const std::size_t first = random.below(columns + 1);
    LaneMatrix<float> before = random_lanes(random, rows, columns);
    const LaneMatrix<float> mask = random_lanes(random, rows, random.below(columns - first + 1));
    const auto sample = random_values<std::vector<float>>(random, columns);
    const bool is_moving = random.below(4) > 0;
    const bool is_zero = random.below(4) == 0;
    std::vector<float> x(columns);
    std::vector<std::uint32_t> seen;
    std::vector<float> of_seen;
    double squared = 0.0;
    for (std::uint32_t k = 0; k < columns && !is_zero; ++k) {
      if (random.below(3) == 0) continue;
      x[k] = static_cast<float>(random.normal());
      squared += double{x[k]} * double{x[k]};
      if (k < first || k >= first + mask.columns()) continue;
      seen.push_back(k);
      of_seen.push_back(x[k]);
    }
    RoomForMoves move;
    move.keep = random_values<AlignedVector<float>>(random, 4 * kArborLanes);
    move.add = random_values<AlignedVector<float>>(random, 4 * kArborLanes);
    before(0, 0) = -0.0F;
    move.add[0] = 0.0F;
    const auto gains = random_values<AlignedVector<float>>(random, 4 * kArborLanes);
    testing::for_each_instruction_set([&](InstructionSet set) {
      const kernels::TMpsomTable& table = kernels::t_mpsom_table();
      LaneMatrix<float> w = before;
      RoomForMeasures found;
      table.move_and_measure(kernels::lanes(w), is_moving ? sample.data() : nullptr, move.moves(),
                             {kernels::lanes(mask), first, x.data(), is_zero}, found.measures());
      LaneMatrix<float> expected = before;
      if (is_moving) table.move(kernels::lanes(expected), sample.data(), move.moves());
      EXPECT_EQ(w, expected) << name_of(set);
      RoomForMeasures sums;
      table.banded_inner_products(kernels::lanes(std::as_const(expected)), kernels::lanes(mask),
                                  first, seen.data(), of_seen.data(), seen.size(),
                                  sums.partial.data());
      EXPECT_EQ(found.partial, sums.partial) << name_of(set);
      RoomForMoves next;
      RoomForMoves next_expected;
      const auto length = static_cast<float>(squared);
      const bool certain = table.find_measured_moves(found.measures(), w.blocks(), length,
                                                     gains.data(), next.moves());
      EXPECT_EQ(certain, table.find_unit_moves(kernels::lanes(std::as_const(expected)), x.data(),
                                               length, gains.data(), next_expected.moves()));
      EXPECT_EQ(next.doubtful, next_expected.doubtful) << name_of(set);
      for (std::size_t row = 0; row < w.padded_rows(); ++row) {
        if (next.doubtful[row] != 0.0F) continue;  // may be no number
        EXPECT_EQ(next.keep[row], next_expected.keep[row]) << name_of(set);
        EXPECT_EQ(next.add[row], next_expected.add[row]) << name_of(set);
      }
    });
  }
}

// Half of the way to the opposite nothing is left; zeros have no length at all.
TEST(TMpsomKernels, DoubtLengthsThatCancel) {
  LaneMatrix<float> w(2 * kArborLanes, 3);
  for (std::size_t row = 0; row < w.rows(); ++row) w(row, 1) = 1.0F;
  w(3, 1) = 0.0F;
  w(4, 1) = 1e20F;
  w(5, 1) = -1.0F;
  const std::vector<float> x{0, -1, 0};
  AlignedVector<float> gains(2 * kArborLanes);
  gains[5] = gains[6] = gains[20] = 0.5F;
  testing::for_each_instruction_set([&](InstructionSet set) {
    RoomForMoves room;
    EXPECT_FALSE(kernels::t_mpsom_table().find_unit_moves(
        kernels::lanes(std::as_const(w)), x.data(), 1.0F, gains.data(), room.moves()));
    for (std::size_t row = 0; row < w.rows(); ++row) {
      const bool doubtful = row == 3 || row == 4 || row == 6 || row == 20;
      EXPECT_EQ(room.doubtful[row] != 0.0F, doubtful) << row << name_of(set);
    }
  });
}

TEST(TMpsomKernels, MoveByTheGivenFactors) {
  Random random(3);
  testing::for_each_instruction_set([&](InstructionSet set) {
    const std::size_t blocks = 1 + random.below(4);
    const LaneMatrix<float> w = random_lanes(random, blocks * kArborLanes, 1 + random.below(50));
    const auto x = random_values<std::vector<float>>(random, w.columns());
    RoomForMoves room;
    auto gains = random_values<AlignedVector<float>>(random, blocks * kArborLanes);
    gains[1] = 1.0F;
    LaneMatrix<float> moved = w;
    kernels::t_mpsom_table().find_plain_moves(gains.data(), blocks, room.moves());
    room.add[2] = 1e-20F;
    room.keep[2] = 1e-20F;
    kernels::t_mpsom_table().move(kernels::lanes(moved), x.data(), room.moves());
    for (std::size_t row = 0; row < w.rows(); ++row) {
      for (std::size_t k = 0; k < w.columns(); ++k) {
        const float kept = w(row, k) * (1.0F - gains[row]);
        const float expected = row == 2 ? 0.0F : std::fma(gains[row], x[k], kept);
        EXPECT_EQ(moved(row, k), expected) << name_of(set);
      }
    }
    EXPECT_EQ(moved(1, 0), x[0]);
  });
}

TEST(TMpsomKernels, TellWhetherAnythingIsNotZero) {
  testing::for_each_instruction_set([](InstructionSet /*set*/) {
    AlignedVector<float> values(4 * kArborLanes);
    EXPECT_FALSE(kernels::t_mpsom_table().any(values.data(), 4));
    values[37] = 1e-30F;
    EXPECT_TRUE(kernels::t_mpsom_table().any(values.data(), 4));
    EXPECT_FALSE(kernels::t_mpsom_table().any(values.data(), 2));
  });
}

TEST(TMpsomKernels, CombineActivity) {
  Random random(4);
  const auto p = random_values<AlignedVector<float>>(random, 37);
  const auto before = random_values<std::vector<double>>(random, 37);
  testing::for_each_instruction_set([&](InstructionSet /*set*/) {
    const kernels::TMpsomTable& table = kernels::t_mpsom_table();
    std::vector<double> started = before;
    std::vector<double> multiplied = before;
    std::vector<double> added = before;
    table.start_activity(p.data(), p.size(), started.data());
    table.multiply_activity(p.data(), p.size(), multiplied.data());
    table.add_activity(p.data(), p.size(), added.data());
    for (std::size_t n = 0; n < p.size(); ++n) {
      EXPECT_EQ(started[n], double{p[n]});
      EXPECT_EQ(multiplied[n], before[n] * double{p[n]});
      EXPECT_EQ(added[n], before[n] + double{p[n]});
    }
  });
}

TEST(TMpsomKernels, RectifyAndFindWhatIsNotFinite) {
  testing::for_each_instruction_set([](InstructionSet set) {
    const kernels::TMpsomTable& table = kernels::t_mpsom_table();
    for (const std::size_t count : {1U, 8U, 21U}) {
      for (std::size_t strange = 0; strange < count; ++strange) {
        std::vector<double> y(count, -1.5);
        std::vector<double> out(count);
        y[strange] = 1e300;
        EXPECT_TRUE(table.rectify(y.data(), count, out.data())) << name_of(set);
        for (std::size_t n = 0; n < count; ++n) EXPECT_EQ(out[n], n == strange ? 1e300 : 0.0);
        EXPECT_EQ(table.largest(out.data(), count), 1e300);
        for (const double value : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
          y[strange] = value;
          EXPECT_FALSE(table.rectify(y.data(), count, out.data())) << name_of(set);
        }
      }
    }
    EXPECT_EQ(table.largest(nullptr, 0), 0.0);
  });
}

TEST(TMpsomKernels, FindGains) {
  std::vector<double> spread{4.0, 1.0, 0.0, 3e-18, 6e-18, 2.0, 3.0, 0.5, 0.25};
  for (int n = 0; n < 40; ++n) spread.push_back(0.1 * n);
  testing::for_each_instruction_set([&](InstructionSet /*set*/) {
    std::vector<double> values = spread;
    AlignedVector<float> gains(values.size());
    kernels::t_mpsom_table().find_gains(values.data(), values.size(), 4.0, 0.75, gains.data());
    for (std::size_t n = 0; n < values.size(); ++n) {
      EXPECT_EQ(values[n], spread[n] / 4.0);
      EXPECT_EQ(gains[n], n == 3 ? 0.0F : static_cast<float>(0.75 * values[n]));
    }
  });
}

// Rows of values, or a line of single ones, and factors up to `reach` on both sides.
struct Spreading {
  std::size_t places;
  std::size_t width;
  std::size_t reach;
  std::vector<double> in;
  std::vector<double> factors;

  const double* middle() const { return factors.data() + factors.size() / 2; }

  double expected(std::size_t u, std::size_t column) const {
    double sum = 0.0;
    for (std::size_t v = 0; v < places; ++v) {
      if (std::max(u, v) - std::min(u, v) > reach) continue;
      sum = std::fma(in[v * width + column], *(middle() + v - u), sum);
    }
    return sum;
  }
};

Spreading random_spreading(Random& random, std::size_t width) {
  const std::size_t places = 1 + random.below(60);
  const std::size_t reach = random.below(places);
  const std::size_t margin = kernels::kSpreadGroup;
  Spreading s{places, width, reach, random_values<std::vector<double>>(random, places * width),
              std::vector<double>(2 * (reach + margin) + 1)};
  for (std::size_t d = 0; d <= 2 * reach; ++d) s.factors[margin + d] = random.uniform();
  return s;
}

TEST(TMpsomKernels, SpreadRowsWithinTheirReach) {
  Random random(5);
  testing::for_each_instruction_set([&](InstructionSet set) {
    for (int i = 0; i < 100; ++i) {
      const Spreading s = random_spreading(random, 1 + random.below(30));
      std::vector<double> out(s.in.size());
      kernels::t_mpsom_table().spread_rows(s.in.data(), s.places, s.width, s.middle(), s.reach,
                                           out.data());
      for (std::size_t n = 0; n < out.size(); ++n) {
        EXPECT_EQ(out[n], s.expected(n / s.width, n % s.width)) << name_of(set);
      }
    }
  });
}

TEST(TMpsomKernels, SpreadALineWithinItsReach) {
  Random random(6);
  testing::for_each_instruction_set([&](InstructionSet set) {
    for (int i = 0; i < 200; ++i) {
      const Spreading s = random_spreading(random, 1);
      std::vector<double> padded(s.places + 2 * s.reach);
      std::copy(s.in.begin(), s.in.end(), padded.begin() + static_cast<std::ptrdiff_t>(s.reach));
      std::vector<double> out(s.places);
      kernels::t_mpsom_table().spread_line(padded.data() + s.reach, s.places, s.middle(), s.reach,
                                           out.data());
      for (std::size_t u = 0; u < s.places; ++u) {
        EXPECT_EQ(out[u], s.expected(u, 0)) << name_of(set);
      }
    }
  });
}

}  // namespace
}  // namespace somato
