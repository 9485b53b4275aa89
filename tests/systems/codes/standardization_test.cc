#include "somato/codes/standardization.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

Samples samples_of(std::size_t count, std::vector<float> values) {
  const std::size_t columns = values.size() / count;
  return Samples(Matrix<float>(count, columns, std::move(values)));
}

std::vector<float> row(const Samples& samples, std::size_t index) {
  return {samples[index].values.begin(), samples[index].values.end()};
}

constexpr StandardizationParameters kZeroConstants{ConstantColumns::kZero};

// 2 4 4 4 5 5 7 9 has the mean 5 and the population deviation 2; the second column is 10 times it.
const std::vector<float> kTwoColumns{2, 20, 4, 40, 4, 40, 4, 40, 5, 50, 5, 50, 7, 70, 9, 90};

TEST(Standardization, TakesMeanAndPopulationDeviationOfEveryColumn) {
  const auto fitted = Standardization::fit(samples_of(8, kTwoColumns));
  ASSERT_TRUE(fitted);
  EXPECT_EQ(fitted->means, (std::vector<double>{5.0, 50.0}));
  EXPECT_EQ(fitted->deviations, (std::vector<double>{2.0, 20.0}));
}

TEST(Standardization, AppliesToSamplesItHasNotSeen) {
  const auto fitted = Standardization::fit(samples_of(8, kTwoColumns));
  ASSERT_TRUE(fitted);
  const Samples applied = fitted->apply(samples_of(2, {5, 20, 12, 55}));
  ASSERT_EQ(applied.count(), 2U);
  EXPECT_EQ(row(applied, 0), (std::vector<float>{0.0F, -1.5F}));
  EXPECT_EQ(row(applied, 1), (std::vector<float>{3.5F, 0.25F}));
}

// Means of 5 and 5000 deviations.
TEST(Standardization, SubtractsOnlyMeansThatLieFarFromZero) {
  const Standardization fitted{{10.0, -10000.0, 7.0}, {2.0, 2.0, 0.0}};
  EXPECT_EQ(fitted.offsets(), (std::vector<double>{0.0, -10000.0, 7.0}));
  const Standardization moved = fitted.without(fitted.offsets());
  EXPECT_EQ(moved.means, (std::vector<double>{10.0, 0.0, 0.0}));
  EXPECT_EQ(moved.deviations, fitted.deviations);
  EXPECT_THROW((void)fitted.without(std::vector<double>{1.0}), InvalidArgument);
}

TEST(Standardization, ReadsSparseSamplesAsDenseOnes) {
  const std::vector<Signal> sparse{Signal::sparse({3}, {0, 2}, {1.0F, 4.0F}),
                                   Signal::sparse({3}, {1}, {6.0F}),
                                   Signal::sparse({3}, {0, 1, 2}, {5.0F, 3.0F, 2.0F})};
  const Samples dense = samples_of(3, {1, 0, 4, 0, 6, 0, 5, 3, 2});
  const Samples samples = Samples::from_signals(sparse);
  ASSERT_TRUE(samples.is_sparse());
  const auto from_sparse = Standardization::fit(samples);
  const auto from_dense = Standardization::fit(dense);
  ASSERT_TRUE(from_sparse && from_dense);
  EXPECT_EQ(from_sparse->means, (std::vector<double>{2.0, 3.0, 2.0}));
  EXPECT_EQ(from_sparse->deviations, from_dense->deviations);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(row(from_sparse->apply(samples), i), row(from_dense->apply(dense), i));
  }
}

TEST(Standardization, LeavesItsOwnSamplesWithMeanZeroAndDeviationOne) {
  Random random(1);
  Matrix<float> rows(50, 3);
  for (float& value : rows.values()) value = static_cast<float>(1000.0 + 0.01 * random.normal());
  const Samples samples(rows);
  const auto fitted = Standardization::fit(samples);
  ASSERT_TRUE(fitted);
  const auto refitted = Standardization::fit(fitted->apply(samples));
  ASSERT_TRUE(refitted);
  for (std::size_t column = 0; column < 3; ++column) {
    EXPECT_NEAR(refitted->means[column], 0.0, 1e-6);
    EXPECT_NEAR(refitted->deviations[column], 1.0, 1e-6);
  }
}

TEST(Standardization, IsTheSameFromSamplesInParts) {
  Random random(2);
  Matrix<float> rows(50, 3);
  for (float& value : rows.values()) value = static_cast<float>(random.normal());
  for (std::size_t i = 0; i < 50; ++i) rows(i, 1) = 0.1F;
  const Samples samples(rows);
  const auto whole = Standardization::fit(samples, kZeroConstants);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->deviations[1], 0.0);
  for (const std::size_t most : {1U, 7U, 50U}) {
    SamplesInMemory source(samples, most);
    const auto parts = Standardization::fit(source, kZeroConstants);
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->means, whole->means);
    EXPECT_EQ(parts->deviations, whole->deviations);
    EXPECT_EQ(Standardization::fit(source).error().what,
              Standardization::fit(samples).error().what);
  }
}

TEST(Standardization, RefusesAConstantColumnByNumberAndName) {
  const Samples samples = samples_of(3, {1, 0.1F, 2, 0.1F, 3, 0.1F});
  const auto unnamed = Standardization::fit(samples);
  ASSERT_FALSE(unnamed);
  EXPECT_EQ(unnamed.error().kind, ErrorKind::kData);
  EXPECT_EQ(unnamed.error().what,
            "column 2 is 0.1 in all 3 training samples, so it cannot be standardized");
  EXPECT_EQ(unnamed.error().advice, "leave the column out, or set constant_columns = \"zero\"");
  const auto named = Standardization::fit(samples, {}, {"height", "wrist"});
  ASSERT_FALSE(named);
  EXPECT_EQ(named.error().what,
            "column 2 ('wrist') is 0.1 in all 3 training samples, so it cannot be standardized");
}

TEST(Standardization, MakesAConstantColumnZeroOnRequest) {
  const auto fitted =
      Standardization::fit(samples_of(3, {1, 0.1F, 2, 0.1F, 3, 0.1F}), kZeroConstants);
  ASSERT_TRUE(fitted);
  EXPECT_EQ(fitted->deviations[1], 0.0);
  EXPECT_EQ(row(fitted->apply(samples_of(1, {2, 77})), 0), (std::vector<float>{0.0F, 0.0F}));
}

TEST(Standardization, NeedsTwoSamples) {
  for (const Samples& samples : {Samples(), samples_of(1, {1, 2})}) {
    const auto fitted = Standardization::fit(samples, kZeroConstants);
    ASSERT_FALSE(fitted);
    EXPECT_EQ(fitted.error().what, "a standardization needs at least 2 training samples, not " +
                                       std::to_string(samples.count()));
  }
}

TEST(Standardization, RefusesWhatIsNotFinite) {
  for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    const auto fitted = Standardization::fit(samples_of(2, {1, 2, 3, bad}), kZeroConstants);
    ASSERT_FALSE(fitted);
    EXPECT_EQ(fitted.error().what,
              std::string("sample 2 holds ") + (std::isnan(bad) ? "nan" : "inf") + " in column 2");
  }
}

TEST(Standardization, RefusesOtherSizesThanItWasFittedTo) {
  const auto fitted = Standardization::fit(samples_of(2, {1, 2, 3, 4}));
  ASSERT_TRUE(fitted);
  std::vector<float> out(2);
  EXPECT_THROW(fitted->apply(samples_of(1, {1, 2, 3})), InvalidArgument);
  EXPECT_THROW(fitted->apply(SignalView::dense(std::vector<float>{1.0F}), out), InvalidArgument);
  EXPECT_THROW((void)Standardization::fit(samples_of(2, {1, 2, 3, 4}), {}, {"one"}),
               InvalidArgument);
}

TEST(StandardizationParameters, RefuseConstantColumnsByDefault) {
  EXPECT_EQ(parameters_to_toml(StandardizationParameters{}), "constant_columns = \"refuse\"\n");
  const Table table{"", {{"constant_columns", "", Value{std::string("zero")}}}};
  const auto parameters = read_parameters<StandardizationParameters>(table);
  ASSERT_TRUE(parameters);
  EXPECT_EQ(parameters->constant_columns, ConstantColumns::kZero);
}

}  // namespace
}  // namespace somato
