// Each kernel against its formula, lane by lane; the bits are those of every instruction set.

#include "base/kernels/online_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/kernels/kernels.h"
#include "base/support/instruction_sets.h"
#include "somato/core/matrix.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using kernels::InputRows;
using kernels::kPending;

constexpr std::size_t kLanes = LaneMatrix<float>::kLanes;

template <typename Real>
AlignedVector<Real> random_values(std::size_t count, Random& random) {
  AlignedVector<Real> values(count);
  for (Real& value : values) value = static_cast<Real>(random.normal());
  return values;
}

// Some rows of some blocks of lanes; now and then a value that is negligible.
struct Rows {
  Rows(std::size_t number, std::size_t lanes, Random& random)
      : count(lanes), all(random_values<float>(number * lanes, random)) {
    for (float& value : all) {
      if (random.below(9) == 0) value *= kernels::kNegligible<float>;
    }
    for (std::size_t i = 0; i < number; ++i) rows.push_back(all.data() + i * lanes);
  }
  Rows(const Rows& other) = delete;
  Rows& operator=(const Rows& other) = delete;

  float at(std::size_t row, std::size_t lane) const { return all[row * count + lane]; }

  std::size_t count;
  AlignedVector<float> all;
  std::vector<float*> rows;
};

float cleared(float value) {
  return std::fabs(value) < kernels::kNegligible<float> ? 0.0F : value;
}

template <typename Work>
void for_each_problem(const Work& work) {
  testing::for_each_instruction_set([&](InstructionSet) {
    Random random(7);
    for (int i = 0; i < 40; ++i) work(random);
  });
}

AlignedVector<std::int16_t> random_integers(std::size_t count, Random& random) {
  AlignedVector<std::int16_t> values(count);
  for (std::int16_t& value : values) value = static_cast<std::int16_t>(random.below(65536));
  return values;
}

TEST(OnlineKernels, MultiplyIntegersAsTheSameFloats) {
  for_each_problem([](Random& random) {
    const std::size_t columns = 1 + random.below(300);
    const std::size_t chunk = 1 + random.below(90);
    const std::size_t count = 1 + random.below(kPending);
    const auto integers = random_integers(columns * kLanes, random);
    const AlignedVector<float> floats(integers.begin(), integers.end());
    const auto inputs = random_values<float>(columns * kPending, random);
    const auto& table = kernels::online_table();
    AlignedVector<float> expected(kLanes * count, 0.5F);
    AlignedVector<float> sums(kLanes * count, 0.5F);
    const InputRows rows{inputs.data(), columns};
    table.multiply(floats.data(), columns, rows, count, expected.data(), kLanes);
    table.multiply_integers(integers.data(), columns, rows, count, sums.data(), kLanes);
    EXPECT_EQ(sums, expected);
    table.multiply_block(floats.data(), columns, chunk, inputs.data(), expected.data());
    table.multiply_block_of_integers(integers.data(), columns, chunk, inputs.data(), sums.data());
    EXPECT_EQ(sums, expected);
  });
}

TEST(OnlineKernels, RoundATileToIntegers) {
  for_each_problem([](Random& random) {
    const std::size_t columns = 1 + random.below(20);
    auto tile = random_values<float>(columns * kLanes, random);
    // Halves, too.
    for (float& w : tile) w = random.below(2) == 0 ? 3.0F * w : std::floor(9.0F * w) + 0.5F;
    AlignedVector<float> factors(kLanes);
    for (float& factor : factors) factor = random.below(2) == 0 ? 1.0F : 700.0F;
    AlignedVector<float> greatest(kLanes, 0.25F);
    AlignedVector<std::int16_t> to(tile.size());
    kernels::online_table().round_tile(tile.data(), columns, factors.data(), to.data(),
                                       greatest.data());
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      float most = 0.25F;
      for (std::size_t i = lane; i < tile.size(); i += kLanes) {
        ASSERT_EQ(static_cast<float>(to[i]), std::nearbyint(tile[i] * factors[lane])) << tile[i];
        most = std::max(most, std::fabs(tile[i]));
      }
      ASSERT_EQ(greatest[lane], most);
    }
  });
}

TEST(OnlineKernels, MultiplyABlockAsTileByTile) {
  for_each_problem([](Random& random) {
    const std::size_t columns = 1 + random.below(700);
    const std::size_t chunk = 1 + random.below(90);
    const auto tile = random_values<float>(columns * kLanes, random);
    const auto input = random_values<float>(columns, random);
    AlignedVector<float> expected(kLanes);
    AlignedVector<float> sums(kLanes, -1.0F);
    const auto& table = kernels::online_table();
    for (std::size_t start = 0; start < columns; start += chunk) {
      table.multiply(tile.data() + start * kLanes, std::min(chunk, columns - start),
                     {input.data() + start, columns}, 1, expected.data(), kLanes);
    }
    table.multiply_block(tile.data(), columns, chunk, input.data(), sums.data());
    EXPECT_EQ(sums, expected) << columns << " in chunks of " << chunk;
  });
}

TEST(OnlineKernels, CombineInputsInOrderAndMeasure) {
  for_each_problem([](Random& random) {
    const std::size_t columns = 1 + random.below(70);
    const std::size_t count = 1 + random.below(kPending);
    const auto tile = random_values<float>(columns * kLanes, random);
    const auto inputs = random_values<float>(columns * kPending, random);
    const auto kept = random_values<float>(kLanes, random);
    const auto gains = random_values<float>(kPending * kLanes, random);
    const float limit = random.below(2) == 0 ? 0.0F : 0.1F;
    AlignedVector<float> to(tile.size());
    AlignedVector<float> squares(kLanes, 1.0F);
    kernels::online_table().combine(tile.data(), columns, kept.data(), gains.data(),
                                    {inputs.data(), columns}, count, limit, to.data(),
                                    squares.data());
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double square = 1.0;
      for (std::size_t c = 0; c < columns; ++c) {
        float w = kept[lane] * tile[c * kLanes + lane];
        for (std::size_t j = 0; j < count; ++j) {
          w = std::fma(gains[j * kLanes + lane], inputs[j * columns + c], w);
        }
        if (std::fabs(w) < limit) w = 0.0F;
        ASSERT_EQ(to[c * kLanes + lane], w) << c << " of " << columns << ", " << count;
        square += double{w} * double{w};
      }
      ASSERT_NEAR(double{squares[lane]}, square, 1e-5 * square);
    }
  });
}

// The same bits as where a row is a lane.
TEST(OnlineKernels, MultiplyRows) {
  for_each_problem([](Random& random) {
    const std::size_t number = random.below(kLanes);
    const std::size_t columns = 1 + random.below(400);
    const std::size_t chunk = 1 + random.below(90);
    const auto rows = random_values<float>(number * columns, random);
    const auto x = random_values<float>(columns, random);
    AlignedVector<float> tile(columns * kLanes);
    for (std::size_t j = 0; j < number; ++j) {
      for (std::size_t c = 0; c < columns; ++c) tile[c * kLanes + j] = rows[j * columns + c];
    }
    AlignedVector<float> expected(kLanes);
    std::vector<float> sums(number);
    const auto& table = kernels::online_table();
    table.multiply_block(tile.data(), columns, chunk, x.data(), expected.data());
    table.multiply_rows({rows.data(), columns}, number, x.data(), columns, chunk, sums.data());
    for (std::size_t j = 0; j < number; ++j) ASSERT_EQ(sums[j], expected[j]) << j;
  });
}

// Within rounding, and in the same order everywhere.
TEST(OnlineKernels, MultiplyLongRows) {
  Random random(8);
  for (int i = 0; i < 40; ++i) {
    const std::size_t number = random.below(11);
    const Rows rows(number, kLanes * (1 + random.below(40)), random);
    const auto x = random_values<float>(rows.count, random);
    AlignedVector<float> first;
    testing::for_each_instruction_set([&](InstructionSet) {
      AlignedVector<float> sums(number);
      kernels::online_table().multiply_long_rows({rows.all.data(), rows.count}, number, x.data(),
                                                 rows.count, sums.data());
      if (first.empty()) first = sums;
      EXPECT_EQ(sums, first);
    });
    for (std::size_t j = 0; j < number; ++j) {
      double sum = 0.0;
      double most = 0.0;
      for (std::size_t d = 0; d < rows.count; ++d) {
        sum += double{rows.at(j, d)} * double{x[d]};
        most += std::fabs(double{rows.at(j, d)} * double{x[d]});
      }
      EXPECT_NEAR(double{first[j]}, sum, 1e-6 * most);
    }
  }
}

// The same bits as in lanes.
TEST(OnlineKernels, CombineARow) {
  for_each_problem([](Random& random) {
    const std::size_t columns = kLanes * (1 + random.below(5));
    const std::size_t count = 1 + random.below(kPending);
    const auto inputs = random_values<float>(columns * kPending, random);
    const auto gains = random_values<float>(kPending, random);
    AlignedVector<float> row = random_values<float>(columns, random);
    AlignedVector<float> tile(columns * kLanes);
    AlignedVector<float> gains_of_lanes(kPending * kLanes);
    for (std::size_t c = 0; c < columns; ++c) tile[c * kLanes + 3] = row[c];
    for (std::size_t j = 0; j < kPending; ++j) gains_of_lanes[j * kLanes + 3] = gains[j];
    const AlignedVector<float> kept(kLanes, 0.75F);
    AlignedVector<float> squares(kLanes);
    const float limit = random.below(2) == 0 ? 0.0F : 0.1F;
    const auto& table = kernels::online_table();
    const InputRows rows{inputs.data(), columns};
    table.combine(tile.data(), columns, kept.data(), gains_of_lanes.data(), rows, count, limit,
                  tile.data(), squares.data());
    table.combine_row(row.data(), columns, kept[3], gains.data(), rows, count, limit);
    for (std::size_t c = 0; c < columns; ++c) ASSERT_EQ(row[c], tile[c * kLanes + 3]);
  });
}

TEST(OnlineKernels, AddRowsInDoublePrecision) {
  for_each_problem([](Random& random) {
    const std::size_t number = random.below(11);
    const Rows rows(number, kLanes * (1 + random.below(5)), random);
    const auto values = random_values<float>(number, random);
    AlignedVector<double> sums(rows.count, 0.5);
    kernels::online_table().add_rows(rows.rows.data(), values.data(), number, rows.count,
                                     sums.data());
    for (std::size_t lane = 0; lane < rows.count; ++lane) {
      double sum = 0.5;
      for (std::size_t i = 0; i < number; ++i) {
        sum = std::fma(double{values[i]}, double{rows.at(i, lane)}, sum);
      }
      ASSERT_EQ(sums[lane], sum) << lane << " of " << number;
    }
  });
}

TEST(OnlineKernels, MoveRowsAndTellHowSquaresChange) {
  for_each_problem([](Random& random) {
    const std::size_t number = random.below(11);
    const Rows rows(number, kLanes * (1 + random.below(5)), random);
    const AlignedVector<float> before = rows.all;
    const auto values = random_values<float>(number, random);
    const auto factors = random_values<float>(rows.count, random);
    AlignedVector<double> change(rows.count, 0.5);
    kernels::online_table().move_rows(rows.rows.data(), values.data(), number, factors.data(),
                                      rows.count, change.data());
    for (std::size_t lane = 0; lane < rows.count; ++lane) {
      double expected = 0.5;
      for (std::size_t i = 0; i < number; ++i) {
        const float was = before[i * rows.count + lane];
        const float is = std::fma(values[i], factors[lane], was);
        ASSERT_EQ(rows.at(i, lane), is);
        expected = std::fma(-double{was}, double{was}, expected);
        expected = std::fma(double{is}, double{is}, expected);
      }
      ASSERT_EQ(change[lane], expected) << lane << " of " << number;
    }
  });
}

TEST(OnlineKernels, FoldARow) {
  for_each_problem([](Random& random) {
    const Rows rows(1, kLanes * (1 + random.below(5)), random);
    const AlignedVector<float> before = rows.all;
    const auto factors = random_values<float>(rows.count, random);
    AlignedVector<double> squares(rows.count, 0.5);
    kernels::online_table().fold_row(rows.rows[0], factors.data(), rows.count, squares.data());
    for (std::size_t lane = 0; lane < rows.count; ++lane) {
      const float is = cleared(before[lane] * factors[lane]);
      ASSERT_EQ(rows.at(0, lane), is);
      ASSERT_EQ(squares[lane], std::fma(double{is}, double{is}, 0.5));
    }
  });
}

TEST(OnlineKernels, ScaleARowIntoBlocks) {
  for_each_problem([](Random& random) {
    const Rows rows(1, kLanes * (1 + random.below(5)), random);
    const auto scales = random_values<double>(rows.count, random);
    const std::size_t stride = kLanes * (1 + random.below(4));
    AlignedVector<float> to(stride * rows.count / kLanes);
    kernels::online_table().scale_row(rows.rows[0], scales.data(), rows.count, to.data(), stride);
    for (std::size_t lane = 0; lane < rows.count; ++lane) {
      const double scaled = scales[lane] * double{rows.at(0, lane)};
      const bool negligible = std::fabs(scaled) < double{kernels::kNegligible<float>};
      ASSERT_EQ(to[lane / kLanes * stride + lane % kLanes],
                negligible ? 0.0F : static_cast<float>(scaled));
    }
  });
}

}  // namespace
}  // namespace somato
