#include "views/report/confused_samples.h"

#include "views/report/three_explorations.h"

namespace somato {
namespace {

using detail::confused_samples;
using detail::TestedSample;
using detail::tests_of;
using Words = std::vector<std::string>;

// Explorations of two balls and a cube.
class ConfusedSamples : public testing::ThreeExplorations {
 protected:
  void add_run(Words predictions, std::size_t recording = 0) {
    const Words labels{"ball", "ball", "cube"};
    results_.protocols[0].runs.push_back({1, {0, 0, 0}, labels, std::move(predictions), {}, {}});
    results_.pairs.push_back({recording, results_.pairs.size()});
    results_.protocols[0].metrics = {{"accuracy", std::vector<double>(results_.pairs.size(), 0.5)}};
  }

  static std::string in_words(const std::vector<TestedSample>& all) {
    std::string words;
    for (const TestedSample& one : all) {
      words += std::to_string(one.sample) + " " + one.predicted + " " +
               std::to_string(one.confused) + "/" + std::to_string(one.tests) + "; ";
    }
    return words;
  }
};

TEST_F(ConfusedSamples, AreTheMostFrequentOfEachConfusion) {
  add_run({"cube", "ball", "ball"});
  add_run({"ball", "cube", "cube"});
  add_run({"ball", "cube", "cube"});
  EXPECT_EQ(in_words(confused_samples(evidence_, 8)), "1 cube 2/3; 2 ball 1/3; ");
  EXPECT_EQ(in_words(confused_samples(evidence_, 1)), "1 cube 2/3; ");
  EXPECT_EQ(in_words({tests_of(evidence_, 0)}), "0 cube 1/3; ");
}

TEST_F(ConfusedSamples, AreListedOnce) {
  add_run({"cube", "ball", "cube"});
  add_run({"cube", "cube", "cube"});
  add_run({"cone", "cube", "cube"});
  add_run({"cone", "cone", "cube"});
  // Each ball is confused twice as a cube, the first one twice as a cone.
  EXPECT_EQ(in_words(confused_samples(evidence_, 8)), "0 cube 2/4; 1 cone 1/4; ");
  // The first in alphabetical order.
  EXPECT_EQ(in_words({tests_of(evidence_, 0)}), "0 cone 2/4; ");
}

TEST_F(ConfusedSamples, AreThoseOfTheRecordingAtHand) {
  add_run({"cube", "ball", "cube"}, 1);
  add_run({"ball", "cube", "cube"});
  EXPECT_EQ(in_words(confused_samples(evidence_, 8)), "1 cube 1/1; ");
  EXPECT_EQ(in_words({tests_of(evidence_, 2)}), "2  0/1; ");
}

TEST_F(ConfusedSamples, NeedTestsOfAllSamples) {
  EXPECT_TRUE(confused_samples(evidence_, 8).empty());
  add_run({"cube", "ball", "cube"});
  EXPECT_EQ(confused_samples(evidence_, 8).size(), 1U);
  results_.protocols[0].protocol = "test_data";
  EXPECT_TRUE(confused_samples(evidence_, 8).empty());
  results_.protocols[0].protocol = "train_is_test";
  evidence_.explorations = {0, 1};
  EXPECT_TRUE(confused_samples(evidence_, 8).empty());
  EXPECT_EQ(tests_of(evidence_, 0).tests, 0U);
}

}  // namespace
}  // namespace somato
