#include "somato/maps/contributions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato::contributions_test {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kColumns = 7;
constexpr std::size_t kNeuronsOfMap = 12;

const std::vector<Similarity> kAll{Similarity::kEuclidean, Similarity::kDotProduct,
                                   Similarity::kManhattan, Similarity::kCosine,
                                   Similarity::kChebyshev};

using Row = std::vector<float>;

SomParameters parameters_for(Similarity similarity) {
  SomParameters parameters;
  parameters.rows = 3;
  parameters.columns = 4;
  parameters.similarity = similarity;
  parameters.normalize_input = false;
  return parameters;
}

Row random_row(Random& random) {
  Row row(kColumns);
  for (float& value : row) value = static_cast<float>(4.0 * random.uniform() - 2.0);
  return row;
}

Matrix<float> random_weights(Random& random) {
  Matrix<float> weights(kNeuronsOfMap, kColumns);
  for (float& value : weights.values()) value = static_cast<float>(random.normal());
  return weights;
}

// Three classes, and a neuron without one.
NeuronLabels three_classes() {
  std::vector<std::optional<std::size_t>> classes(kNeuronsOfMap);
  for (std::size_t i = 1; i < kNeuronsOfMap; ++i) classes[i] = i % 3;
  return NeuronLabels(classes);
}

// The definition of the distance, element by element; for a dot product the negative product.
double distance_of(Similarity similarity, const Row& x, const Row& w) {
  double squares = 0.0;
  double magnitudes = 0.0;
  double most = 0.0;
  double product = 0.0;
  double of_x = 0.0;
  double of_w = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isnan(x[i])) continue;
    const double apart = double{x[i]} - double{w[i]};
    squares += apart * apart;
    magnitudes += std::fabs(apart);
    most = std::max(most, std::fabs(apart));
    product += double{x[i]} * double{w[i]};
    of_x += double{x[i]} * double{x[i]};
    of_w += double{w[i]} * double{w[i]};
  }
  switch (similarity) {
    case Similarity::kEuclidean:
      return std::sqrt(squares);
    case Similarity::kManhattan:
      return magnitudes;
    case Similarity::kChebyshev:
      return most;
    case Similarity::kDotProduct:
      return -product;
    case Similarity::kCosine:
      break;
  }
  return of_x == 0.0 || of_w == 0.0 ? 1.0 : 1.0 - product / std::sqrt(of_x * of_w);
}

Row row_of(const Som& som, std::size_t neuron) {
  Row row(som.input_size());
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = som.weight(neuron, i);
  return row;
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

Samples samples_of(const std::vector<Row>& rows) {
  Matrix<float> matrix(rows.size(), rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::copy(rows[i].begin(), rows[i].end(), matrix.row(i).begin());
  }
  return Samples(std::move(matrix));
}

std::vector<double> values_of(const Som& som, const Row& x, DecidingNeurons neurons) {
  return contributions(som, SignalView::dense(x), neurons).values;
}

TEST(Contributions, SumToTheDifferenceOfTheDistances) {
  Random random(7);
  for (const Similarity similarity : kAll) {
    const Som som(parameters_for(similarity), random_weights(random));
    for (int trial = 0; trial < 50; ++trial) {
      const Row x = random_row(random);
      const DecidingNeurons two{random.below(kNeuronsOfMap), random.below(kNeuronsOfMap)};
      const double a = distance_of(similarity, x, row_of(som, two.nearest));
      const double b = distance_of(similarity, x, row_of(som, two.other));
      const Contributions found = contributions(som, SignalView::dense(x), two);
      EXPECT_NEAR(sum_of(found.values), b - a, 1e-12) << choice_name(similarity);
      const double sign = similarity == Similarity::kDotProduct ? -1.0 : 1.0;
      EXPECT_NEAR(found.of_nearest, sign * a, 1e-12);
      EXPECT_NEAR(found.of_other, sign * b, 1e-12);
    }
  }
}

TEST(Contributions, OfEachElementAreThoseOfTheDefinition) {
  SomParameters parameters = parameters_for(Similarity::kEuclidean);
  parameters.rows = 1;
  parameters.columns = 2;
  Matrix<float> weights(2, 3);
  const std::vector<float> numbers{1, 2, 3, /**/ 4, 6, 3};
  std::copy(numbers.begin(), numbers.end(), weights.values().begin());
  const Row x{1, 2, 7};  // 4 from the first neuron, sqrt(9 + 16 + 16) from the second
  const auto by = [&](Similarity similarity) {
    parameters.similarity = similarity;
    return values_of(Som(parameters, weights), x, {0, 1});
  };
  const double both = 4.0 + std::sqrt(41.0);
  const auto euclidean = by(Similarity::kEuclidean);
  EXPECT_NEAR(euclidean[0], 9.0 / both, 1e-15);
  EXPECT_NEAR(euclidean[1], 16.0 / both, 1e-15);
  EXPECT_EQ(euclidean[2], 0.0);
  EXPECT_EQ(by(Similarity::kManhattan), (std::vector<double>{3, 4, 0}));
  EXPECT_EQ(by(Similarity::kDotProduct), (std::vector<double>{-3, -8, 0}));
  // 4 is the greatest difference of the third from a, and of the second and third from b.
  EXPECT_EQ(by(Similarity::kChebyshev), (std::vector<double>{0, 2, -2}));
}

TEST(Contributions, OfMissingElementsAreNothing) {
  Random random(8);
  for (const Similarity similarity : kAll) {
    const Som som(parameters_for(similarity), random_weights(random));
    Row x = random_row(random);
    x[2] = x[5] = kMissing;
    const Contributions found = contributions(som, SignalView::dense(x), {3, 8});
    EXPECT_EQ(found.values[2], 0.0);
    EXPECT_EQ(found.values[5], 0.0);
    const double difference =
        distance_of(similarity, x, row_of(som, 8)) - distance_of(similarity, x, row_of(som, 3));
    EXPECT_NEAR(sum_of(found.values), difference, 1e-12) << choice_name(similarity);
  }
  const Som som(parameters_for(Similarity::kEuclidean), random_weights(random));
  const Contributions none = contributions(som, SignalView::dense(Row(kColumns, kMissing)), {0, 1});
  EXPECT_EQ(none.values, std::vector<double>(kColumns, 0.0));
  EXPECT_EQ(none.of_other, 0.0);
}

// The neurons have the value of the samples in such a column.
TEST(Contributions, OfAConstantColumnAreNothing) {
  Random random(9);
  for (const Similarity similarity : {Similarity::kEuclidean, Similarity::kDotProduct,
                                      Similarity::kManhattan, Similarity::kChebyshev}) {
    Matrix<float> weights = random_weights(random);
    for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) weights(neuron, 4) = 1.5F;
    const Som som(parameters_for(similarity), weights);
    Row x = random_row(random);
    x[4] = 1.5F;
    EXPECT_EQ(values_of(som, x, {1, 6})[4], 0.0) << choice_name(similarity);
  }
}

TEST(Contributions, ArePermutedWithTheElements) {
  Random random(10);
  for (const Similarity similarity : kAll) {
    Matrix<float> weights = random_weights(random);
    weights(2, 0) = weights(2, 1) = 9.0F;  // equal greatest differences
    Row x = random_row(random);
    x[0] = x[1] = 0.5F;
    Matrix<float> turned(weights.rows(), kColumns);
    Row turned_x(kColumns);
    for (std::size_t i = 0; i < kColumns; ++i) {
      const std::size_t from = (i + 3) % kColumns;
      turned_x[i] = x[from];
      for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) {
        turned(neuron, i) = weights(neuron, from);
      }
    }
    const auto plain = values_of(Som(parameters_for(similarity), weights), x, {5, 2});
    const auto permuted = values_of(Som(parameters_for(similarity), turned), turned_x, {5, 2});
    for (std::size_t i = 0; i < kColumns; ++i) {
      EXPECT_NEAR(permuted[i], plain[(i + 3) % kColumns], 1e-14) << choice_name(similarity);
    }
  }
}

TEST(Contributions, ChangeTheirSignWithTheNeurons) {
  Random random(11);
  for (const Similarity similarity : kAll) {
    const Som som(parameters_for(similarity), random_weights(random));
    const Row x = random_row(random);
    const auto there = values_of(som, x, {4, 9});
    const auto back = values_of(som, x, {9, 4});
    for (std::size_t i = 0; i < kColumns; ++i) EXPECT_EQ(there[i], -back[i]);
    EXPECT_EQ(values_of(som, x, {4, 4}), std::vector<double>(kColumns, 0.0));
  }
}

TEST(Contributions, OfAnInputThatIsScaledToLengthOne) {
  Random random(12);
  SomParameters parameters = parameters_for(Similarity::kEuclidean);
  parameters.normalize_input = true;
  const Som som(parameters, random_weights(random));
  const Row x = random_row(random);
  SomWorkspace workspace;
  const SignalView input = SignalView::dense(x);
  const Contributions found = contributions(som, input, {2, 7});
  EXPECT_NEAR(sum_of(found.values),
              som.distance(input, 7, workspace) - som.distance(input, 2, workspace), 1e-12);
  EXPECT_EQ(contributions(som, SignalView::dense(Row(kColumns)), {2, 2}).of_nearest,
            som.distance(SignalView::dense(Row(kColumns)), 2, workspace));
}

// Elements without weights are part of both distances.
TEST(Contributions, OfElementsThatHaveNoWeights) {
  Random random(13);
  for (const Similarity similarity : kAll) {
    SomParameters parameters = parameters_for(similarity);
    LaneMatrix<float> weights(kNeuronsOfMap, 2);
    for (std::size_t neuron = 0; neuron < kNeuronsOfMap; ++neuron) {
      weights(neuron, 0) = static_cast<float>(random.uniform());
      weights(neuron, 1) = static_cast<float>(random.uniform());
    }
    const Som som(parameters, weights, StoredElements(kColumns, {1, 4}));
    Row x = random_row(random);
    x[6] = kMissing;
    const double difference =
        distance_of(similarity, x, row_of(som, 5)) - distance_of(similarity, x, row_of(som, 0));
    const Contributions found = contributions(som, SignalView::dense(x), {0, 5});
    EXPECT_EQ(found.values.size(), som.elements().count());
    EXPECT_NEAR(sum_of(found.values), difference, 1e-7) << choice_name(similarity);
  }
}

TEST(Contributions, OfLayersSumToo) {
  Random random(14);
  SomParameters parameters = parameters_for(Similarity::kEuclidean);
  parameters.layers = {{"touch", 0, 3, Similarity::kEuclidean, 2.0, 1.7},
                       {"joints", 3, 2, Similarity::kManhattan, 1.0, 0.4},
                       {"sound", 5, 2, Similarity::kCosine, 1.0, 1.0}};
  const Som som(parameters, random_weights(random));
  const Row x = random_row(random);
  const auto distance = [&](std::size_t neuron) {
    const Row w = row_of(som, neuron);
    double sum = 0.0;
    for (const Layer& layer : parameters.layers) {
      const auto part = [&](const Row& row) {
        const auto first = row.begin() + static_cast<std::ptrdiff_t>(layer.first);
        return Row(first, first + static_cast<std::ptrdiff_t>(layer.count));
      };
      sum += layer.weight / *layer.scale * distance_of(layer.similarity, part(x), part(w));
    }
    return sum;
  };
  const Contributions found = contributions(som, SignalView::dense(x), {10, 1});
  EXPECT_NEAR(found.of_nearest, distance(10), 1e-12);
  EXPECT_NEAR(sum_of(found.values), distance(1) - distance(10), 1e-12);
}

TEST(Contributions, OfZerosAndGreatValuesAreFinite) {
  for (const Similarity similarity : kAll) {
    Matrix<float> weights(kNeuronsOfMap, kColumns, 0.0F);
    for (float& value : weights.row(1)) value = 1e18F;
    const Som som(parameters_for(similarity), weights);
    for (const float one : {0.0F, 1e18F, 1e-30F}) {
      for (const double value : values_of(som, Row(kColumns, one), {0, 1})) {
        EXPECT_TRUE(std::isfinite(value)) << choice_name(similarity);
      }
    }
    EXPECT_EQ(values_of(som, Row(kColumns), {0, 2}), std::vector<double>(kColumns, 0.0));
  }
}

TEST(Contributions, NeedNeuronsOfTheMapAndInputsOfItsSize) {
  Random random(15);
  const Som som(parameters_for(Similarity::kEuclidean), random_weights(random));
  const Row x = random_row(random);
  EXPECT_THROW(contributions(som, SignalView::dense(x), {0, kNeuronsOfMap}), InvalidArgument);
  EXPECT_THROW(contributions(som, SignalView::dense(Row(kColumns - 1)), {0, 1}), InvalidArgument);
}

TEST(DecidingNeurons, AreTheNearestOfTheAnswerAndOfAllOtherClasses) {
  Random random(16);
  const NeuronLabels labels = three_classes();
  for (const Similarity similarity : kAll) {
    const Som som(parameters_for(similarity), random_weights(random));
    std::vector<Row> rows(40);
    for (Row& row : rows) row = random_row(random);
    const auto deciding = deciding_neurons(som, labels, samples_of(rows), 2);
    ASSERT_EQ(deciding.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto nearest_of = [&](std::optional<std::size_t> without) {
        std::size_t best = kNeuronsOfMap;
        for (const std::size_t neuron : labels.labelled()) {
          if (labels[neuron] == without) continue;
          if (best == kNeuronsOfMap || distance_of(similarity, rows[i], row_of(som, neuron)) <
                                           distance_of(similarity, rows[i], row_of(som, best))) {
            best = neuron;
          }
        }
        return best;
      };
      const std::size_t nearest = nearest_of({});
      EXPECT_EQ(deciding[i].nearest, nearest) << choice_name(similarity);
      EXPECT_EQ(deciding[i].other, nearest_of(labels[nearest]));
    }
  }
}

TEST(DecidingNeurons, NeedTwoClasses) {
  Random random(17);
  const Som som(parameters_for(Similarity::kEuclidean), random_weights(random));
  const Samples samples = samples_of({random_row(random)});
  std::vector<std::optional<std::size_t>> one(kNeuronsOfMap, 2);
  EXPECT_THROW(deciding_neurons(som, NeuronLabels(one), samples), InvalidArgument);
  EXPECT_THROW(
      deciding_neurons(som, NeuronLabels(std::vector<std::optional<std::size_t>>(kNeuronsOfMap)),
                       samples),
      InvalidArgument);
}

}  // namespace
}  // namespace somato::contributions_test
