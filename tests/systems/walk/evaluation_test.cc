#include "somato/graph/evaluation.h"

#include <gtest/gtest.h>

#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::build;
using testing::dense;
using testing::first_explorations;
using testing::hand_recording;
using testing::trained;

const std::string kText =
    "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n"
    "[module.code]\ntype = \"one_hot\"\ninput = \"joints\"\nlow = 0\nhigh = 1\nelements = 4\n"
    "[module.stm]\ntype = \"accumulate\"\ninput = \"code\"\n"
    "[module.unused]\ntype = \"last\"\ninput = \"joints\"\n"
    "[module.map]\ntype = \"som\"\ninput = \"stm\"\nrows = 3\ncolumns = 3\niterations = 50\n"
    "[module.winner]\ntype = \"winner\"\ninput = \"map\"\n";

TEST(Evaluation, WhatNeverLearnsIsComputedOnceWhereLearnersListen) {
  const Recording recording = hand_recording(5, 3);
  const System system = build(kText, recording);
  const auto fixed = evaluate_fixed(system, recording, {}, 1);
  ASSERT_TRUE(fixed);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(fixed->find(*system.find("joints"), i), nullptr);  // on the way: not kept
    EXPECT_EQ(fixed->find(*system.find("code"), i), nullptr);
    EXPECT_EQ(fixed->find(*system.find("unused"), i), nullptr);
    EXPECT_EQ(fixed->find(*system.find("map"), i), nullptr);
    const Sequence* stm = fixed->find(*system.find("stm"), i);
    ASSERT_NE(stm, nullptr);
    EXPECT_EQ(dense(*stm), dense(testing::output_of(system, recording, "stm", i)));
  }
  const std::vector<std::size_t> also{*system.find("unused"), *system.find("map")};
  const auto more = evaluate_fixed(system, recording, also, 1);
  EXPECT_NE(more->find(also[0], 4), nullptr);
  EXPECT_EQ(more->find(also[1], 4), nullptr);  // it learns
}

// Known values are taken as they are, even when they could be computed.
TEST(Evaluation, StartsFromWhatIsKnown) {
  const Recording recording = hand_recording(5, 3);
  const System system = build(kText, recording);
  Activations activations(system.modules().size(), 5);
  const auto made = std::make_shared<const Sequence>(
      Sequence{Samples(Matrix<float>(2, 3, {0, 0, 0, 0.9F, 0.9F, 0.9F})), 0.0});
  activations.set(*system.find("joints"), 2, made);
  const std::vector<std::size_t> explorations{2, 4};
  ASSERT_TRUE(evaluate(system, recording, explorations, {*system.find("stm")}, 1, activations));
  EXPECT_EQ(dense(*activations.find(*system.find("stm"), 2)),
            Matrix<float>(1, 12, {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}));
  EXPECT_EQ(activations.find(*system.find("stm"), 3), nullptr);  // was not requested
  EXPECT_NE(activations.find(*system.find("stm"), 4), nullptr);
}

TEST(Activations, PutValuesOfExplorationsTogetherOnce) {
  const Recording recording = hand_recording(5, 3);
  const System system = build(kText, recording);
  const std::size_t stm = *system.find("stm");
  Activations activations(system.modules().size(), 5);
  const std::vector<std::size_t> some{1, 4};
  ASSERT_TRUE(evaluate(system, recording, some, {stm}, 1, activations));
  const ExplorationValues values = activations.values_of(stm);
  EXPECT_EQ(values.explorations, some);
  EXPECT_EQ(Signal::copy_of(values.samples[1]),
            Signal::copy_of(activations.find(stm, 4)->values[0]));
  EXPECT_EQ(values.places_of(std::vector<std::size_t>{4, 1}), (std::vector<std::size_t>{1, 0}));
  Activations copy = activations;
  EXPECT_TRUE(copy.values_of(stm).samples.is_same_as(values.samples));
  const std::vector<std::size_t> more{2};
  ASSERT_TRUE(evaluate(system, recording, more, {stm}, 1, copy));
  EXPECT_EQ(copy.values_of(stm).explorations, (std::vector<std::size_t>{1, 2, 4}));
  EXPECT_EQ(activations.values_of(stm).explorations, some);
}

TEST(Evaluation, ThreadsMakeNoDifference) {
  const Recording recording = hand_recording(23, 3);
  const System system = trained(build(kText, recording), recording, 12);
  const std::vector<std::size_t> wanted = first_explorations(system.modules().size());
  Activations one(system.modules().size(), 23);
  ASSERT_TRUE(evaluate(system, recording, first_explorations(23), wanted, 1, one));
  for (const std::size_t threads : {2U, 4U, 40U}) {
    Activations many(system.modules().size(), 23);
    ASSERT_TRUE(evaluate(system, recording, first_explorations(23), wanted, threads, many));
    for (const std::size_t module : wanted) {
      for (std::size_t i = 0; i < 23; ++i) {
        EXPECT_EQ(dense(*many.find(module, i)), dense(*one.find(module, i)));
      }
    }
  }
}

TEST(Evaluation, TheFirstErrorIsReportedForAnyThreadsWithExplorationAndModule) {
  Recording recording = hand_recording(9, 3);
  for (const std::size_t bad : {8U, 5U, 6U})
    recording.explorations[bad].channels[2].frames(1, 2) = 7.0F;
  recording.explorations[5].source.clear();
  const System system = build(kText, recording);
  for (const std::size_t threads : {1U, 2U, 4U}) {
    Activations activations(system.modules().size(), 9);
    const auto evaluated = evaluate(system, recording, first_explorations(9), {*system.find("stm")},
                                    threads, activations);
    ASSERT_FALSE(evaluated);
    EXPECT_EQ(evaluated.error().kind, ErrorKind::kData);
    EXPECT_EQ(evaluated.error().where, "exploration 6, system.toml:4, module 'code', joint 3");
    EXPECT_NE(evaluated.error().what.find("(frame 2)"), std::string::npos);
  }
}

TEST(Evaluation, FramesThatDoNotGoTogetherAreRefusedWhenTheyCome) {
  const Recording recording = hand_recording(3, 3);
  const std::string sum =
      "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n"
      "[module.touch]\ntype = \"channel\"\nchannel = \"touch\"\n"
      "[module.m]\ntype = \"concatenation\"\ninputs = [\"joints\", \"touch\"]\n";
  const std::string loop =
      "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n"
      "[module.touch]\ntype = \"channel\"\nchannel = \"touch\"\n"
      "[module.m]\ntype = \"concatenation\"\ninputs = [\"joints\", \"touch\", \"d\"]\n"
      "[module.n]\ntype = \"channel\"\nchannel = \"height\"\n"
      "[module.s]\ntype = \"som\"\ninput = \"m\"\nrows = 2\ncolumns = 1\n"
      "initial_weights = \"uniform\"\n[module.d]\ntype = \"delay\"\ninput = \"s\"\n"
      "shape = [2, 1]\n";
  Recording other = hand_recording(3, 3);
  other.explorations[1].channels[2].frames = Matrix<float>(9, 3);
  for (const std::string& text : {sum, loop}) {
    const System system = trained(build(text, recording), recording, 3);
    ASSERT_TRUE(testing::try_output(system, other, "m", 0));
    const auto given = testing::try_output(system, other, "m", 1);
    ASSERT_FALSE(given);
    EXPECT_EQ(given.error().kind, ErrorKind::kData);
    EXPECT_EQ(given.error().where, "trial 2, system.toml:7, module 'm'");
  }
}

TEST(Evaluation, AChannelThatIsMissingOrOfAnotherSizeIsAnError) {
  const Recording recording = hand_recording(2, 3);
  const System system = build(kText, recording);
  Recording other = recording;
  other.explorations[0].channels[2].name = "joint";
  other.explorations[1].channels[2].frames = Matrix<float>(2, 4);
  const auto missing = testing::try_output(system, other, "joints", 0);
  ASSERT_FALSE(missing);
  EXPECT_NE(to_string(missing.error()).find("did you mean 'joint'?"), std::string::npos);
  EXPECT_NE(missing.error().where.find("module 'joints'"), std::string::npos);
  const auto wide = testing::try_output(system, other, "joints", 1);
  ASSERT_FALSE(wide);
  EXPECT_NE(to_string(wide.error()).find("has 4 elements, but the system requires 3"),
            std::string::npos);
}

}  // namespace
}  // namespace somato
