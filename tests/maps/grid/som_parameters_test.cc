#include "somato/maps/som_parameters.h"

#include <gtest/gtest.h>

#include "somato/maps/som_training.h"

namespace somato {
namespace {

TEST(SomParameters, DecidesWhatIsAutomatic) {
  SomParameters p;
  p.rows = 10;
  p.columns = 24;
  p.similarity = Similarity::kDotProduct;
  const SomParameters r = resolve(p, 300, 9).value();
  EXPECT_EQ(*r.iterations, 3000U);
  EXPECT_EQ(*r.radius_start, 12.0);
  EXPECT_EQ(*r.radius_reached_at, 3000U);
  EXPECT_TRUE(*r.normalize_input);
  EXPECT_EQ(r.arithmetic, Arithmetic::kPlain);
  EXPECT_EQ(*resolve(p, 30, 9).value().iterations, 2000U);
}

TEST(SomParameters, TakesInnerProductsForFewSamplesOfManyElements) {
  EXPECT_EQ(resolve({}, 30, 270000).value().arithmetic, Arithmetic::kInnerProducts);
  EXPECT_EQ(resolve({}, 30, 40).value().arithmetic, Arithmetic::kPlain);
  SomParameters batch;
  batch.training = Training::kBatch;
  EXPECT_EQ(resolve(batch, 30, 270000).value().arithmetic, Arithmetic::kInnerProducts);
  EXPECT_EQ(resolve(batch, 30, 239).value().arithmetic, Arithmetic::kPlain);
  batch.epochs = 7;
  EXPECT_EQ(resolve(batch, 30, 270000).value().arithmetic, Arithmetic::kPlain);
}

TEST(SomParameters, CountsABatchTrainingsScheduleInEpochs) {
  SomParameters p;
  p.training = Training::kBatch;
  p.epochs = 7;
  EXPECT_EQ(*resolve(p, 30, 9).value().radius_reached_at, 7U);
}

TEST(SomParameters, KnowsWhichHaveNoEffect) {
  SomParameters p;
  EXPECT_EQ(reason_without_effect(p, "epochs"), "training is online");
  EXPECT_EQ(reason_without_effect(p, "iterations"), "");
  EXPECT_EQ(reason_without_effect(p, "radius_end"), "");
  EXPECT_EQ(reason_without_effect(p, "patience"), "tolerance is 0");
  EXPECT_EQ(reason_without_effect(p, "most_checks"), "tolerance is 0");
  p.tolerance = 0.1;
  EXPECT_EQ(reason_without_effect(p, "patience"), "");
  p.training = Training::kBatch;
  EXPECT_EQ(reason_without_effect(p, "epochs"), "");
  for (const char* name : {"iterations", "draws", "learning_rate_start"}) {
    EXPECT_EQ(reason_without_effect(p, name), "training is batch") << name;
  }
  p.radius_schedule = ScheduleShape::kConstant;
  EXPECT_EQ(reason_without_effect(p, "radius_end"), "its schedule is constant");
  EXPECT_EQ(reason_without_effect(p, "radius_start"), "");
}

TEST(SomParameters, RefusesContradictions) {
  SomParameters zero_end;
  zero_end.radius_schedule = ScheduleShape::kExponential;
  zero_end.radius_end = 0.0;
  EXPECT_NE(to_string(resolve(zero_end, 30, 9).error()).find("radius cannot start or end at 0"),
            std::string::npos);
  SomParameters odd;
  odd.rows = 3;
  odd.lattice = Lattice::kHexagonal;
  odd.topology = Topology::kTorus;
  EXPECT_EQ(resolve(odd, 30, 9).error().kind, ErrorKind::kUsage);
}

// A field that is not declared could not be set from a description or a flag, nor be saved.
TEST(SomParameters, EveryDeclaredParameterCanBeSetAndReadBack) {
  SomParameters p;
  for (const auto& parameter : SomParameters::declarations().all()) {
    Value value;
    if (parameter.info.type == "choice") {
      value = {parameter.info.choices.back()};
    } else if (parameter.info.type == "switch") {
      value = {false};
    } else if (parameter.info.type == "integer") {
      value = {std::int64_t{7}};
    } else {
      value = {0.25};
    }
    ASSERT_TRUE(parameter.assign(p, value)) << parameter.info.name;
    EXPECT_EQ(parameter.read(p), value) << parameter.info.name;
  }
  EXPECT_EQ(p.rows, 7U);
  EXPECT_EQ(p.activity_norm, ActivityNorm::kMaximum);
  EXPECT_EQ(p.learning_rate_end, 0.25);
}

// Only distances that follow from inner products can be computed with them.
TEST(SomParameters, RefuseInnerProductsForOtherDistances) {
  for (const auto& [similarity, name] : Choices<Similarity>::all()) {
    SomParameters parameters;
    parameters.similarity = similarity;
    const bool follows = name == "euclidean" || name == "dot_product";
    EXPECT_EQ(resolve(parameters, 30, 270000).value().arithmetic,
              follows ? Arithmetic::kInnerProducts : Arithmetic::kPlain)
        << name;
    parameters.arithmetic = Arithmetic::kInnerProducts;
    const auto resolved = resolve(parameters, 30, 270000);
    EXPECT_EQ(resolved.has_value(), follows) << name;
    if (!follows) {
      EXPECT_EQ(resolved.error().kind, ErrorKind::kUsage) << name;
    }
  }
}

SomParameters automatic() {
  SomParameters parameters;
  parameters.rows.reset();
  parameters.columns.reset();
  return parameters;
}

SomParameters decided(SomParameters parameters, std::size_t samples) {
  decide_size(parameters, samples);
  return parameters;
}

// 10 sqrt(n) by hand: 316 samples 177.8 neurons, 10000 samples 1000.
TEST(MapSize, FollowsTheNumberOfSamples) {
  const SomParameters few = decided(automatic(), 316);
  EXPECT_EQ(few.rows, 13U);
  EXPECT_EQ(few.columns, 14U);
  EXPECT_EQ(few.iterations, 20000U) << "18200 are 100 a neuron";
  EXPECT_EQ(few.radius_end, 0.5);
  const SomParameters many = decided(automatic(), 10000);
  EXPECT_EQ(many.rows, 32U);
  EXPECT_EQ(many.columns, 31U);
  EXPECT_EQ(many.iterations, 99200U);
  const SomParameters one = decided(automatic(), 1);
  EXPECT_EQ(one.rows, 3U);
  EXPECT_EQ(one.columns, 3U);
}

TEST(MapSize, LeavesWhatIsGiven) {
  SomParameters parameters = automatic();
  parameters.columns = 30;
  parameters.iterations = 7;
  const SomParameters wide = decided(parameters, 316);
  EXPECT_EQ(wide.rows, 6U);
  EXPECT_EQ(wide.columns, 30U);
  EXPECT_EQ(wide.iterations, 7U);
  SomParameters given;
  given.rows = given.columns = 15;
  const SomParameters fixed = decided(given, 316);
  EXPECT_EQ(fixed.rows, 15U);
  EXPECT_FALSE(fixed.iterations.has_value()) << "2000, as in P11, is decided later";
  EXPECT_FALSE(fixed.radius_end.has_value());
  EXPECT_EQ(resolve(given, 316, 3)->radius_end, 1.0);
}

TEST(MapSize, HasEvenRowsOnAHexagonalTorus) {
  SomParameters parameters = automatic();
  parameters.lattice = Lattice::kHexagonal;
  parameters.topology = Topology::kTorus;
  EXPECT_EQ(decided(parameters, 316).rows, 14U);
  SomParameters odd = parameters;
  odd.rows = 3;
  EXPECT_FALSE(resolve(odd, 316, 3));
  EXPECT_TRUE(resolve(parameters, 316, 3));
}

TEST(MapSize, OfMillionsOfNeuronsNeedsBothSides) {
  SomParameters parameters = automatic();
  parameters.columns = 1 << 24;
  const auto refused = resolve(parameters, 4, 2);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(refused.error().where, "columns");
  parameters.rows = 1;
  EXPECT_TRUE(resolve(parameters, 4, 2));
}

TEST(MapSize, IsThatOfTheTrainedMap) {
  SomParameters parameters = automatic();
  parameters.iterations = 10;
  const auto som = train_som(parameters, Samples(Matrix<float>(4, 1, {1, 2, 3, 4})));
  ASSERT_TRUE(som);
  EXPECT_EQ(som->grid().rows(), 4U);
  EXPECT_EQ(som->grid().columns(), 5U);
  EXPECT_EQ(som->parameters().rows, 4U);
}

}  // namespace
}  // namespace somato
