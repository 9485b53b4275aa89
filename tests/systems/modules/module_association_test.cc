// The module 'association': A-SOMs (Johnsson, Balkenius and Hesslow, 2009).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/support/temporary_folder.h"
#include "somato/graph/system_model.h"
#include "somato/graph/system_training.h"
#include "somato/maps/som_training.h"
#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::build;
using testing::channels;
using testing::dense;
using testing::frames_of;
using testing::hand_recording;
using testing::module;
using testing::output_of;
using testing::trained;
using testing::try_build;

std::string associating(const std::string& settings) {
  return channels({"joints", "touch"}) +
         module("m", "association", "input = \"joints\"\ntarget = \"touch\"\n" + settings);
}

// Double precision, from the definition: W += rate (target - W x) x'.
class ObviousAssociation {
 public:
  explicit ObviousAssociation(double rate) : rate_(rate), weights_(4, std::vector<double>(3)) {}

  static std::vector<double> unit(std::span<const float> joints) {
    std::vector<double> x(joints.begin(), joints.end());
    const double length = std::hypot(x[0], x[1], x[2]);
    for (double& value : x) value /= length;
    return x;
  }
  double predict(std::size_t target, const std::vector<double>& x) const {
    const std::vector<double>& w = weights_[target];
    return w[0] * x[0] + w[1] * x[1] + w[2] * x[2];
  }
  void learn(const std::vector<double>& x, std::span<const float> target) {
    for (std::size_t j = 0; j < 4; ++j) {
      const double error = static_cast<double>(target[j]) - predict(j, x);
      for (std::size_t i = 0; i < 3; ++i) weights_[j][i] += rate_ * error * x[i];
    }
  }

 private:
  double rate_;
  std::vector<std::vector<double>> weights_;
};

TEST(Association, LearnsByTheDeltaRule) {
  const Recording recording = hand_recording(6, 5);
  const System system = trained(
      build(associating("learning_rate = 0.3\niterations = 50"), recording), recording, 4, 9);
  ObviousAssociation expected(0.3);
  DrawSequence order(Draws::kWithReplacement, 4, 9);
  for (std::size_t t = 0; t < 50;) {
    const std::size_t exploration = order.next();
    const Matrix<float>& joints = frames_of(recording, "joints", exploration);
    const Matrix<float>& touch = frames_of(recording, "touch", exploration);
    for (std::size_t f = 0; f < joints.rows() && t < 50; ++f, ++t) {
      expected.learn(ObviousAssociation::unit(joints.row(f)), touch.row(f));
    }
  }
  const Matrix<float> given = dense(output_of(system, recording, "m", 5));
  ASSERT_EQ(given.columns(), 4U);
  for (std::size_t f = 0; f < given.rows(); ++f) {
    const auto x = ObviousAssociation::unit(frames_of(recording, "joints", 5).row(f));
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_NEAR(static_cast<double>(given(f, j)), expected.predict(j, x), 1e-5);
    }
  }
}

// The touch of hand_recording(), as a linear function of the joints.
Recording linear_hand(std::size_t explorations) {
  Recording recording = hand_recording(explorations, 8);
  for (Exploration& exploration : recording.explorations) {
    const Matrix<float>& joints = exploration.channels[2].frames;
    Matrix<float>& touch = exploration.channels[3].frames;
    for (std::size_t f = 0; f < joints.rows(); ++f) {
      for (std::size_t j = 0; j < 4; ++j) {
        touch(f, j) = joints(f, 0) - static_cast<float>(j) * joints(f, 1) + 2.0F * joints(f, 2);
      }
    }
  }
  return recording;
}

TEST(Association, PredictsWhatItHasNotSeenWhereTheRelationIsLinear) {
  const Recording recording = linear_hand(20);
  const System system =
      trained(build(associating("learning_rate = 0.3\niterations = 20000\nnormalize_input = false"),
                    recording),
              recording, 15, 2);
  for (std::size_t i = 15; i < 20; ++i) {
    const Matrix<float> given = dense(output_of(system, recording, "m", i));
    const Matrix<float>& touch = frames_of(recording, "touch", i);
    for (std::size_t f = 0; f < given.rows(); ++f) {
      for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(given(f, j), touch(f, j), 1e-3F);
    }
  }
}

// An A-SOM: the map of touch is called up by the activity of the map of joints. Both learn at the
// same time, and the explorations have three kinds of touch that follow from the joints.
TEST(Association, CallsUpTheWinnersOfAnotherMap) {
  Recording recording = hand_recording(60, 3);
  for (std::size_t i = 0; i < 60; ++i) {
    for (const std::size_t channel : {2U, 3U}) {
      Matrix<float>& frames = recording.explorations[i].channels[channel].frames;
      for (std::size_t f = 0; f < frames.rows(); ++f) {
        for (std::size_t j = 0; j < frames.columns(); ++j) {
          frames(f, j) = 0.1F * frames(f, j) + (j == i % 3 ? 1.0F : 0.0F);
        }
      }
    }
  }
  const std::string map =
      "rows = 3\ncolumns = 3\nsimilarity = \"dot_product\"\nnormalize_input = true\n"
      "radius_end = 0.5\ninput = ";
  const System system = trained(
      build(channels({"joints", "touch"}) + module("posture", "som", map + "\"joints\"") +
                module("contact", "som", map + "\"touch\"") +
                module("recalled", "association", "input = \"posture\"\ntarget = \"contact\"") +
                "[[phase]]\nlearn = [\"posture\", \"contact\", \"recalled\"]\n"
                "draws = 4000\n",
            recording),
      recording, 45, 5);
  const auto winner = [](std::span<const float> activity) {
    return std::max_element(activity.begin(), activity.end()) - activity.begin();
  };
  const auto kind_of = [&](std::ptrdiff_t neuron) {
    const Som& som = *som_of(system, *system.find("contact"));
    std::size_t most = 0;
    for (std::size_t j = 1; j < 3; ++j) {
      const auto n = static_cast<std::size_t>(neuron);
      if (som.weight(n, j) > som.weight(n, most)) most = j;
    }
    return most;
  };
  for (std::size_t i = 45; i < 60; ++i) {
    const Matrix<float> recalled = dense(output_of(system, recording, "recalled", i));
    ASSERT_EQ(recalled.columns(), 9U);
    for (std::size_t f = 0; f < recalled.rows(); ++f) {
      EXPECT_EQ(kind_of(winner(recalled.row(f))), i % 3) << i;
    }
  }
}

TEST(Association, IsTheSameAfterSavingAndLoading) {
  const Recording recording = hand_recording(6, 5);
  const System system = trained(build(associating(""), recording), recording, 4, 9);
  const TemporaryFolder folder;
  ASSERT_TRUE(save_system(folder.file("a"), system));
  const auto loaded = load_system(folder.file("a"));
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_EQ(dense(output_of(loaded->system, recording, "m", 5)),
            dense(output_of(system, recording, "m", 5)));
}

TEST(Association, RefusesInputsThatDoNotComeTogether) {
  const Recording recording = hand_recording(6, 5);
  const auto refused =
      try_build(channels({"sound", "touch"}) +
                    module("m", "association", "input = \"sound\"\ntarget = \"touch\""),
                recording);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("are not recorded together"), std::string::npos);
}

}  // namespace
}  // namespace somato
