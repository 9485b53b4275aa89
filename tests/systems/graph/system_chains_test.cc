// The chains of P06, from TOML, compared with calls of the library's functions.

#include <gtest/gtest.h>

#include "somato/codes/memory.h"
#include "somato/codes/one_hot.h"
#include "somato/codes/tensor_product.h"
#include "somato/graph/system_model.h"
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

std::string codes() {
  std::string text;
  for (const std::string name : {"height", "wrist", "joints"}) {
    text += module(name + "_code", "one_hot", "input = \"" + name + "\"\nlow = 0\nhigh = 1");
  }
  return text;
}

Signal code_of(const Recording& recording, const std::string& channel, std::size_t i,
               std::size_t frame) {
  const auto values = frames_of(recording, channel, i).row(frame);
  return OneHotSequence(std::vector<OneHotParameters>(values.size())).encode(values).value();
}

// Height and wrist, then joints, then touch, multiplied and added up.
Signal short_term_memory(const Recording& recording, std::size_t i) {
  Memory memory({10, 10, 30, 4});
  const Matrix<float>& touch = frames_of(recording, "touch", i);
  for (std::size_t frame = 0; frame < touch.rows(); ++frame) {
    const auto row = touch.row(frame);
    const std::vector<Signal> factors{
        code_of(recording, "height", i, frame), code_of(recording, "wrist", i, frame),
        code_of(recording, "joints", i, frame), Signal::dense({row.begin(), row.end()})};
    memory.add(tensor_product(factors).view());
  }
  return memory.value();
}

TEST(SystemChains, TensorProducts) {
  const Recording recording = hand_recording(8, 12);
  const System system = trained(
      build(channels() + codes() +
                module("posture", "tensor_product", "inputs = [\"height_code\", \"wrist_code\"]") +
                module("grip", "tensor_product",
                       "inputs = [\"posture\", \"joints_code\", \"touch\"]") +
                module("stm", "accumulate", "input = \"grip\"") +
                module("map", "som",
                       "input = \"stm\"\nrows = 4\ncolumns = 4\niterations = 200\n"
                       "similarity = \"dot_product\""),
            recording),
      recording, 6, 3);
  std::vector<Signal> memories;
  for (std::size_t i = 0; i < 8; ++i) {
    memories.push_back(short_term_memory(recording, i));
    const Sequence stm = output_of(system, recording, "stm", i);
    EXPECT_TRUE(stm.values.is_sparse());
    EXPECT_EQ(dense(stm), Matrix<float>(1, 12000, memories.back().to_dense()));
  }
  SomParameters parameters;
  parameters.rows = 4;
  parameters.columns = 4;
  parameters.iterations = 200;
  parameters.similarity = Similarity::kDotProduct;
  parameters.seed = 3;
  const Som expected =
      train_som(parameters, Samples::from_signals({memories.begin(), memories.begin() + 6}))
          .value();
  EXPECT_EQ(som_of(system, *system.find("map"))->weights(), expected.weights());
}

TEST(SystemChains, TMpsomsMultipliedAndAddedInPhases) {
  const Recording recording = hand_recording(8, 12);
  const auto text = [](const std::string& combination) {
    const auto map = [&](const std::string& name, const std::string& a, const std::string& b) {
      return module(name, "t_mpsom",
                    "inputs = [\"" + a + "\", \"" + b + "\"]\nshape = [4, 3]\ncombination = \"" +
                        combination + "\"");
    };
    return channels() + codes() + map("posture", "height_code", "wrist_code") +
           map("hand", "joints_code", "touch") + map("grip", "posture", "hand") +
           module("stm", "accumulate", "input = \"grip\"") +
           module("map", "som", "input = \"stm\"\nrows = 3\ncolumns = 3\niterations = 100") +
           "[[phase]]\nlearn = [\"posture\", \"hand\"]\ndraws = 120\n"
           "[[phase]]\nlearn = \"grip\"\ndraws = 80\n";
  };
  for (const std::string combination : {"multiplied", "added"}) {
    const System system = trained(build(text(combination), recording), recording, 6, 3);
    ASSERT_EQ(system.phases().size(), 3U);
    for (std::size_t i = 0; i < 8; ++i) {
      // The last step by hand: the sum of what the last T-MPSOM gives.
      const Matrix<float> grip = dense(output_of(system, recording, "grip", i));
      EXPECT_EQ(grip.columns(), 12U);
      EXPECT_NE(grip(0, 0), grip(1, 0));
      std::vector<float> sums;
      for (std::size_t n = 0; n < 12; ++n) {
        double sum = 0.0;
        for (std::size_t f = 0; f < grip.rows(); ++f) sum += double{grip(f, n)};
        sums.push_back(static_cast<float>(sum));
      }
      EXPECT_EQ(dense(output_of(system, recording, "stm", i)), Matrix<float>(1, 12, sums));
    }
    // Consecutive phases are equivalent to systems trained one after the other: a later phase does
    // not change earlier modules.
    std::string shorter = text(combination);
    shorter.replace(shorter.find("draws = 80"), 10, "draws = 40");
    const System other = trained(build(shorter, recording), recording, 6, 3);
    EXPECT_EQ(dense(output_of(other, recording, "hand", 7)),
              dense(output_of(system, recording, "hand", 7)));
    EXPECT_NE(dense(output_of(other, recording, "grip", 7)),
              dense(output_of(system, recording, "grip", 7)));
  }
}

}  // namespace
}  // namespace somato
