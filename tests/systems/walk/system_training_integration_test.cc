// Maps that learn after every frame, from the exploration so far: with a leaky memory before them,
// their neurons are leaky integrators (P06 section 5, P11 section V).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "somato/graph/system_model.h"
#include "somato/graph/system_training.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_training.h"
#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::build;
using testing::channels;
using testing::frames_of;
using testing::hand_recording;
using testing::module;
using testing::output_of;
using testing::trained;
using testing::try_build;
using testing::try_train;

constexpr double kLeak = 0.25;
constexpr std::size_t kDraws = 60;

const std::string kOfFrames = "[[phase]]\nlearn = \"map\"\ndraws = 60\nof = \"frames\"\n";

std::string leaky_neurons(const std::string& more) {
  return channels({"joints"}) +
         module("memory", "leaky_accumulate", "input = \"joints\"\nleak = 0.25") +
         module("map", "som",
                "input = \"memory\"\nrows = 3\ncolumns = 2\nsimilarity = \"dot_product\"\n"
                "normalize_input = true\n" +
                    more);
}

// The obvious memory.
class Integrator {
 public:
  explicit Integrator(std::size_t size) : sums_(size) {}

  void add(std::span<const float> frame) {
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      sums_[i] = (1.0 - kLeak) * sums_[i] + static_cast<double>(frame[i]);
    }
  }
  std::vector<float> value() const { return {sums_.begin(), sums_.end()}; }

 private:
  std::vector<double> sums_;
};

std::vector<float> integrated(const Matrix<float>& frames) {
  Integrator integrator(frames.columns());
  for (std::size_t f = 0; f < frames.rows(); ++f) integrator.add(frames.row(f));
  return integrator.value();
}

const Som& integrated_map_of(const System& system) {
  return *som_of(system, *system.find("map"));
}

TEST(LeakyNeurons, LearnAfterEveryFrameAsInAnObviousLoop) {
  const Recording recording = hand_recording(6, 5);
  const System system = trained(build(leaky_neurons(kOfFrames), recording), recording, 4, 9);
  Matrix<float> ends(4, 3);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::vector<float> end = integrated(frames_of(recording, "joints", i));
    std::copy(end.begin(), end.end(), ends.row(i).begin());
  }
  SomParameters parameters = integrated_map_of(system).parameters();
  parameters.iterations = kDraws;
  Som map = untrained_som(parameters, Samples(ends)).value();
  SomLearner learner(map);
  DrawSequence order(Draws::kWithReplacement, 4, 9);
  for (std::size_t t = 0; t < kDraws;) {
    const Matrix<float>& frames = frames_of(recording, "joints", order.next());
    Integrator integrator(3);
    for (std::size_t f = 0; f < frames.rows() && t < kDraws; ++f, ++t) {
      integrator.add(frames.row(f));
      const std::vector<float> sofar = integrator.value();
      learner.learn(SignalView::dense(sofar), parameters.learning_rate().at(t),
                    parameters.radius().at(t));
    }
  }
  learner.settle();
  EXPECT_EQ(integrated_map_of(system).weights(), map.weights());
}

// A leaky-integrator neuron adds its input, weighted, to a potential of which it loses a share with
// every frame: u(t) = (1 - leak) u(t - 1) + w x(t). The neuron with the highest potential at the
// end is the winner for the memory.
TEST(LeakyNeurons, TheWinnerHasTheHighestPotential) {
  const Recording recording = hand_recording(40, 7);
  const System system = trained(build(leaky_neurons(kOfFrames), recording), recording, 40, 3);
  const LaneMatrix<float>& weights = integrated_map_of(system).weights();
  std::vector<std::size_t> winners;
  for (std::size_t i = 0; i < 40; ++i) {
    std::vector<double> potentials(6);
    const Matrix<float>& frames = frames_of(recording, "joints", i);
    for (std::size_t f = 0; f < frames.rows(); ++f) {
      for (std::size_t neuron = 0; neuron < 6; ++neuron) {
        double weighted = 0.0;
        for (std::size_t j = 0; j < 3; ++j) {
          weighted += static_cast<double>(weights(neuron, j)) * static_cast<double>(frames(f, j));
        }
        potentials[neuron] = (1.0 - kLeak) * potentials[neuron] + weighted;
      }
    }
    const auto highest = std::max_element(potentials.begin(), potentials.end());
    winners.push_back(static_cast<std::size_t>(highest - potentials.begin()));
    const Matrix<float> activity = testing::dense(output_of(system, recording, "map", i));
    const auto most = std::max_element(activity.row(0).begin(), activity.row(0).end());
    EXPECT_EQ(static_cast<std::size_t>(most - activity.row(0).begin()), winners.back()) << i;
  }
  std::sort(winners.begin(), winners.end());
  EXPECT_GE(std::unique(winners.begin(), winners.end()) - winners.begin(), 3);
}

// The value known before the phase, from another module that uses the memory, is the one at the
// end; the phase needs those in between.
TEST(LeakyNeurons, LearnFromFramesThoughTheEndIsKnown) {
  const Recording recording = hand_recording(6, 5);
  const std::string other = module("other", "som", "input = \"memory\"\nrows = 2\ncolumns = 2");
  const std::string first = "[[phase]]\nlearn = \"other\"\n";
  const System one = trained(build(leaky_neurons(kOfFrames), recording), recording, 4, 9);
  const System two =
      trained(build(leaky_neurons(other + first + kOfFrames), recording), recording, 4, 9);
  EXPECT_EQ(integrated_map_of(one).weights(), integrated_map_of(two).weights());
}

// The map scales its input to length 1 itself.
TEST(LeakyNeurons, LearnFromModulesBehindTheMemory) {
  const Recording recording = hand_recording(6, 5);
  const std::string unit = module("unit", "normalization", "input = \"memory\"");
  std::string text = leaky_neurons(kOfFrames);
  const System plain = trained(build(text, recording), recording, 4, 9);
  text.replace(text.find("input = \"memory\""), 16, "input = \"unit\"");
  const System system = trained(build(unit + text, recording), recording, 4, 9);
  for (std::size_t neuron = 0; neuron < 6; ++neuron) {
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_NEAR(integrated_map_of(plain).weight(neuron, j),
                  integrated_map_of(system).weight(neuron, j), 1e-5F);
    }
  }
}

TEST(LeakyNeurons, NeedModulesThatFollowTheFrames) {
  const Recording recording = hand_recording(6, 5);
  const auto refused =
      try_build(channels({"sound"}) + module("bands", "spectrum", "input = \"sound\"") +
                    module("map", "som", "input = \"bands\"\nrows = 3\ncolumns = 2") + kOfFrames,
                recording);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what,
            "'bands' requires whole explorations, so that 'map' cannot learn from frames");
  EXPECT_EQ(refused.error().advice, "remove 'of'");
}

TEST(LeakyNeurons, NeedFramesThatAreRecordedTogether) {
  const Recording recording = hand_recording(6, 5);
  const std::string sums = module("sound_sum", "accumulate", "input = \"sound\"") +
                           module("both", "concatenation", "inputs = [\"memory\", \"sound_sum\"]");
  std::string text = leaky_neurons(kOfFrames);
  text.replace(text.find("input = \"memory\""), 16, "input = \"both\"");
  System system = build(channels({"sound"}) + sums + text, recording);
  const auto refused = try_train(system, recording, 4);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("channels that learn after every frame have"),
            std::string::npos)
      << to_string(refused.error());
}

}  // namespace
}  // namespace somato
