#include "somato/maps/t_mpsom_training.h"

#include <gtest/gtest.h>

#include <limits>

#include "somato/core/random.h"

namespace somato {
namespace {

TMpsomParameters small(std::uint64_t iterations) {
  TMpsomParameters p;
  p.shape = {3, 2};
  p.input_sizes = {3, 2};
  p.learning_rate_start = 0.5;
  p.iterations = iterations;
  p.seed = 4;
  return p;
}

TMpsomFrame frame(float a, float b) {
  return {Signal::dense({a, 1.0F, 0.5F}), Signal::sparse({2}, {1}, {b})};
}

// Three explorations of different lengths.
std::vector<TMpsomExploration> explorations() {
  return {{frame(1, 1), frame(2, 1), frame(0.1F, 3)},
          {frame(0, 1), frame(5, 1)},
          {frame(4, 2), frame(3, 1), frame(2, 7), frame(1, 4)}};
}

// The training as its description says, step by step.
TMpsom trained_by_steps(const TMpsomParameters& p, std::uint64_t steps) {
  TMpsom map(p);
  TMpsom::Workspace workspace(map);
  const auto all = explorations();
  Random draws(p.seed, Stream::kDraws);
  std::uint64_t iteration = 0;
  while (true) {
    for (const TMpsomFrame& f : all[draws.below(all.size())]) {
      if (iteration == steps) return map;
      const double alpha = 0.5 - 0.5 * double(iteration) / double(p.iterations);
      map.learn(std::vector{f[0].view(), f[1].view()}, alpha, workspace);
      ++iteration;
    }
  }
}

TEST(TrainTMpsom, LearnsDrawnExplorationsFrameByFrame) {
  for (const std::uint64_t iterations : {1U, 2U, 5U, 64U}) {
    const TMpsomParameters p = small(iterations);
    TMpsom map(p);
    const auto learned = train_t_mpsom(map, explorations());
    ASSERT_TRUE(learned);
    EXPECT_EQ(*learned, iterations);
    const TMpsom expected = trained_by_steps(p, iterations);
    const Matrix<float> first = map.weights(0);
    const Matrix<float> expected_first = expected.weights(0);
    for (std::size_t i = 0; i < first.values().size(); ++i) {
      EXPECT_NEAR(first.values()[i], expected_first.values()[i], 1e-6F);
    }
  }
}

TEST(TrainTMpsom, DoesNotCountFramesWithoutActivity) {
  TMpsom map(small(9));
  const std::vector<TMpsomExploration> half{{frame(1, 0), frame(1, 1), frame(0, 0)}};
  EXPECT_EQ(train_t_mpsom(map, half).value(), 3U);
}

TEST(TrainTMpsom, TellsHowFarItIs) {
  TMpsom map(small(250));
  std::vector<std::uint64_t> told;
  ASSERT_TRUE(train_t_mpsom(map, explorations(), [&](std::uint64_t done, std::uint64_t total) {
    EXPECT_EQ(total, 250U);
    told.push_back(done);
    return true;
  }));
  EXPECT_EQ(told, (std::vector<std::uint64_t>{100, 200, 250}));
}

TEST(TrainTMpsom, StopsWhenAsked) {
  const TMpsomParameters p = small(1000);
  TMpsom map(p);
  const auto stopped = train_t_mpsom(
      map, explorations(), [](std::uint64_t done, std::uint64_t /*total*/) { return done < 200; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::kInterrupted);
  EXPECT_EQ(stopped.error().what, "training stopped after 200 iterations");
  const Matrix<float> weights = map.weights(1);
  const Matrix<float> expected = trained_by_steps(p, 200).weights(1);
  for (std::size_t i = 0; i < weights.values().size(); ++i) {
    EXPECT_NEAR(weights.values()[i], expected.values()[i], 1e-6F);
  }
}

void expect_training_refused(const std::vector<TMpsomExploration>& explorations,
                             const std::string& text) {
  TMpsom map(small(10));
  const auto trained = train_t_mpsom(map, explorations);
  ASSERT_FALSE(trained) << text;
  EXPECT_EQ(trained.error().kind, ErrorKind::kData);
  EXPECT_EQ(to_string(trained.error()), text);
  EXPECT_EQ(map, TMpsom(small(10)));
}

TEST(TrainTMpsom, RefusesExplorationsThatDoNotFit) {
  expect_training_refused({}, "no explorations to learn from");
  auto bad = explorations();
  bad[1].clear();
  expect_training_refused(bad, "exploration 1: an exploration without frames");
  bad = explorations();
  bad[2][1].pop_back();
  expect_training_refused(bad, "exploration 2, frame 1: 1 inputs where the map takes 2");
  bad = explorations();
  bad[2][3][1] = Signal::dense({1.0F, 2.0F, 3.0F});
  expect_training_refused(bad, "exploration 2, frame 3, input 1: 3 elements where the map takes 2");
  bad = explorations();
  bad[0][0][0].values()[1] = std::numeric_limits<float>::infinity();
  expect_training_refused(bad, "exploration 0, frame 0, input 0: a value that is not finite");
}

}  // namespace
}  // namespace somato
