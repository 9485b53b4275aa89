#include "maps/online/growing_map.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

#include "somato/core/check.h"

namespace somato {
namespace {

using Floats = std::vector<float>;
using Numbers = std::vector<std::size_t>;

GrowingWeights three_points() {
  GrowingWeights weights(2);
  for (const Floats& point : {Floats{0, 0}, Floats{4, 0}, Floats{0, 2}}) weights.add(point);
  return weights;
}

Floats row(const GrowingWeights& weights, std::size_t neuron) {
  return {weights[neuron].begin(), weights[neuron].end()};
}

TEST(GrowingWeights, FindTheNearestTwo) {
  const Winners winners = three_points().nearest_two(Floats{3, 1});  // 10, 2, 10: the first
  EXPECT_EQ(winners.first, 1U);
  EXPECT_EQ(winners.second, 0U);
}

TEST(GrowingWeights, FindTheNearestPair) {
  GrowingWeights weights = three_points();
  EXPECT_EQ(weights.nearest_pair(), (std::pair<std::size_t, std::size_t>(0, 2)));
  weights.add(Floats{5, 1});
  EXPECT_EQ(weights.nearest_pair(), (std::pair<std::size_t, std::size_t>(1, 3)));
  weights.add(Floats{1, 3});  // as near to (0, 2)
  EXPECT_EQ(weights.nearest_pair(), (std::pair<std::size_t, std::size_t>(1, 3)));
}

TEST(GrowingWeights, MoveAShareOfTheWay) {
  GrowingWeights weights = three_points();
  weights.move(1, Floats{0, 4}, 0.25);
  EXPECT_EQ(row(weights, 1), (Floats{3, 1}));
}

TEST(GrowingWeights, AddTheMiddleOfTheirOwnRows) {
  GrowingWeights weights = three_points();
  weights.add_between(weights[1], weights[2]);
  EXPECT_EQ(row(weights, 3), (Floats{2, 1}));
}

TEST(GrowingWeights, KeepTheOrderOfTheOthersWhereSomeAreRemoved) {
  GrowingWeights weights = three_points();
  weights.remove({1});
  EXPECT_EQ(weights.neurons(), 2U);
  EXPECT_EQ(row(weights, 1), (Floats{0, 2}));
}

TEST(GrowingWeights, KeepTheNumbersThatNeuronsHadBefore) {
  GrowingWeights weights = three_points();
  weights.number_anew();
  weights.remove({1});
  weights.add(Floats{7, 7});
  EXPECT_EQ(weights.origins(), (NeuronOrigins{0, 2, std::nullopt}));
  GrowingWeights others(2);
  others.add_from(weights, 2);
  others.add_from(weights, 1);
  EXPECT_EQ(others.origins(), (NeuronOrigins{std::nullopt, 2}));
  EXPECT_EQ(row(others, 1), (Floats{0, 2}));
  others.number_anew();
  EXPECT_EQ(others.origins(), (NeuronOrigins{0, 1}));
}

TEST(GrowingWeights, StartAtDifferentSamplesIfThereAreEnough) {
  const Samples samples(Matrix<float>(3, 1, {1, 2, 3}));
  const GrowingWeights weights = drawn_weights(samples, 3, 5);
  Floats values{weights[0][0], weights[1][0], weights[2][0]};
  std::sort(values.begin(), values.end());
  EXPECT_EQ(values, (Floats{1, 2, 3}));
}

TEST(NumbersAfter, AreEmptyForThoseRemoved) {
  const auto numbers = numbers_after(4, {0, 2});
  EXPECT_FALSE(numbers[0].has_value());
  EXPECT_EQ(numbers[1], 0U);
  EXPECT_FALSE(numbers[2].has_value());
  EXPECT_EQ(numbers[3], 1U);
}

// Counts what it is given, until it is complete.
class CountingMap : public GrowingMap {
 public:
  explicit CountingMap(std::size_t most) : most_(most) {}
  void learn(std::span<const float> input) override { inputs.push_back(input[0]); }
  bool is_complete() const override { return inputs.size() >= most_; }
  std::size_t neurons() const override { return inputs.size(); }
  Som map() const override { return {}; }
  std::unique_ptr<GrowingMap> copy() const override { return std::make_unique<CountingMap>(*this); }
  void place(std::size_t neuron, std::span<const float> input, std::size_t /*the_class*/) override {
    inputs[neuron] = input[0];
  }
  void resume() override { inputs.clear(); }
  const NeuronOrigins& origins() const override { return origins_; }
  void save(Archive& /*archive*/, const std::string& /*prefix*/) const override {}
  Result<void> load(const Archive& /*archive*/, const std::string& /*prefix*/,
                    const std::string& /*where*/) override {
    return {};
  }

  Floats inputs;

 private:
  std::size_t most_;
  NeuronOrigins origins_;
};

GrowthParameters iterations(std::uint64_t count) {
  GrowthParameters parameters;
  parameters.iterations = count;
  return parameters;
}

TEST(Grow, DrawsEverySampleBeforeOneComesAgain) {
  CountingMap map(100);
  const Samples samples(Matrix<float>(3, 1, {1, 2, 3}));
  ASSERT_TRUE(grow(map, iterations(6), {samples}, {}, {}));
  ASSERT_EQ(map.inputs.size(), 6U);
  std::sort(map.inputs.begin(), map.inputs.begin() + 3);
  EXPECT_EQ(Floats(map.inputs.begin(), map.inputs.begin() + 3), (Floats{1, 2, 3}));
}

TEST(Grow, EndsWithACompleteMap) {
  CountingMap map(4);
  const Samples samples(Matrix<float>(1, 1, 1.0F));
  std::vector<std::uint64_t> moments;
  const auto observer = [&](const TrainingMoment& moment) {
    moments.push_back(moment.step);
    return true;
  };
  ASSERT_TRUE(grow(map, iterations(1000), {samples}, {}, observer));
  EXPECT_EQ(map.inputs.size(), 4U);
  EXPECT_EQ(moments, (std::vector<std::uint64_t>{1000}));
}

TEST(Grow, CanBeStopped) {
  CountingMap map(1000);
  const Samples samples(Matrix<float>(1, 1, 1.0F));
  const auto stopped = grow(map, iterations(1000), {samples},
                            [](std::uint64_t done, std::uint64_t) { return done < 128; }, {});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::kInterrupted);
  EXPECT_EQ(map.inputs.size(), 128U);
  const auto unseen =
      grow(map, iterations(10), {samples}, {}, [](const TrainingMoment&) { return false; });
  ASSERT_FALSE(unseen);
  EXPECT_EQ(unseen.error().kind, ErrorKind::kInterrupted);
}

TEST(CheckGrowing, RefusesWhatCannotBeLearned) {
  EXPECT_FALSE(check_growing(Samples(Matrix<float>(0, 2))));
  EXPECT_FALSE(check_growing(Samples(Matrix<float>(1, 1, 1e30F))));
  EXPECT_TRUE(check_growing(Samples(Matrix<float>(1, 1, 1.0F))));
}

}  // namespace
}  // namespace somato
