#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/support/instruction_sets.h"
#include "base/support/sanitized.h"
#include "maps/support/t_mpsom_problems.h"
#include "maps/t_mpsom/t_mpsom_archive.h"
#include "maps/t_mpsom/t_mpsom_reference.h"
#include "somato/maps/t_mpsom.h"

namespace somato {
namespace {

// Maps of many groups of neurons, with arbors from less than an element to the whole input, against
// TMpsomReference, which knows no bands.

using testing::activation;
using testing::random_signal;
using testing::Sign;
using testing::views;

std::vector<TMpsomParameters> size_variants() {
  std::vector<TMpsomParameters> all;
  for (const auto& [combination, name] : Choices<TMpsomCombination>::all()) {
    for (const double sigma : {0.2, 1.0, 6.0, 1000.0}) {
      TMpsomParameters p;
      p.combination = combination;
      p.arbor_sigma = sigma;
      p.neighbourhood_sigma = 1.5;
      p.shape = {21, 17};
      p.input_sizes = {44, 33};
      all.push_back(p);
      p.shape = {150};
      p.input_sizes = {20};
      all.push_back(p);
      p.shape = {5, 4, 9};
      p.input_sizes = {30, 3, 290, 11};
      p.input_axes = {0, 1, 2, 2};
      all.push_back(p);
    }
  }
  return all;
}

// None is zero throughout.
std::vector<Signal> random_frame(Random& random, const TMpsomParameters& p) {
  std::vector<Signal> frame;
  for (const std::size_t size : p.input_sizes) {
    std::vector<float> values = random_signal(random, size, Sign::kPositive).to_dense();
    values[random.below(size)] = 0.7F;
    frame.push_back(Signal::dense(values));
  }
  return frame;
}

std::vector<std::vector<double>> in_double(const std::vector<Signal>& frame) {
  std::vector<std::vector<double>> inputs;
  inputs.reserve(frame.size());
  for (const Signal& signal : frame) {
    inputs.emplace_back(signal.values().begin(), signal.values().end());
  }
  return inputs;
}

void expect_activation(const TMpsom& map, const TMpsomReference& reference,
                       const std::vector<Signal>& frame, double tolerance) {
  const std::vector<double> expected = reference.activation(in_double(frame));
  const std::vector<float> y = activation(map, frame);
  const double most = *std::max_element(expected.begin(), expected.end());
  for (std::size_t n = 0; n < y.size(); ++n) {
    EXPECT_NEAR(double{y[n]}, expected[n], tolerance * (expected[n] + 1e-12 * most));
  }
}

double greatest_difference(const TMpsom& map, const TMpsomReference& reference) {
  double most = 0.0;
  for (std::size_t a = 0; a < map.parameters().input_sizes.size(); ++a) {
    const Matrix<float> weights = map.weights(a);
    const auto expected = reference.weights(a).values();
    for (std::size_t i = 0; i < expected.size(); ++i) {
      most = std::max(most, std::fabs(double{weights.values()[i]} - expected[i]));
    }
  }
  return most;
}

TEST(TMpsomSizes, BandsGiveWhatWholeInputsGive) {
  Random random(1);
  for (const TMpsomParameters& p : size_variants()) {
    TMpsom map(p);
    TMpsomReference reference(p);
    TMpsom::Workspace workspace(map);
    for (int step = 0; step < 3; ++step) {
      const std::vector<Signal> frame = random_frame(random, p);
      expect_activation(map, reference, frame, 1e-5);
      EXPECT_TRUE(map.learn(views(frame), 0.4, workspace));
      EXPECT_TRUE(reference.learn(in_double(frame), 0.4));
      EXPECT_LT(greatest_difference(map, reference), 2e-6);
    }
  }
}

// A training of many iterations stays where double precision goes.
TEST(TMpsomSizes, LongTrainingStaysAccurate) {
  Random random(2);
  TMpsomParameters p;
  p.shape = {9, 7};
  p.input_sizes = {19, 16};
  for (const auto& [combination, name] : Choices<TMpsomCombination>::all()) {
    p.combination = combination;
    std::vector<std::vector<Signal>> frames;
    frames.reserve(20);
    for (int i = 0; i < 20; ++i) frames.push_back(random_frame(random, p));
    TMpsom map(p);
    TMpsomReference reference(p);
    TMpsom::Workspace workspace(map);
    constexpr int kSteps = testing::fewer_if_sanitized(2000);
    for (int step = 0; step < kSteps; ++step) {
      const std::vector<Signal>& frame = frames[random.below(frames.size())];
      const double alpha = 0.3 * (1.0 - double(step) / kSteps);
      map.learn(views(frame), alpha, workspace);
      reference.learn(in_double(frame), alpha);
    }
    EXPECT_LT(greatest_difference(map, reference), 1e-5) << name;
    for (const auto& frame : frames) expect_activation(map, reference, frame, 1e-4);
  }
}

TEST(TMpsomSizes, TheSameBitsOnEveryInstructionSetAndFromAFile) {
  for (const TMpsomParameters& p : size_variants()) {
    std::vector<float> expected;
    testing::for_each_instruction_set([&](InstructionSet set) {
      Random random(3);
      TMpsom map(p);
      TMpsom::Workspace workspace(map);
      for (int step = 0; step < 10; ++step) {
        map.learn(views(random_frame(random, p)), 0.5, workspace);
      }
      const std::vector<Signal> frame = random_frame(random, p);
      const std::vector<float> y = activation(map, frame);
      if (expected.empty()) expected = y;
      EXPECT_EQ(y, expected) << name_of(set);
      Archive archive("test");
      add_t_mpsom(archive, "", map);
      const TMpsom again = t_mpsom_from(archive, "", "here").value();
      EXPECT_EQ(again, map);
      EXPECT_EQ(activation(again, frame), y);
    });
  }
}

}  // namespace
}  // namespace somato
