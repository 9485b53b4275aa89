#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "base/support/no_malloc.h"
#include "base/support/temporary_folder.h"
#include "somato/c/c_system.h"
#include "somato/graph/answers.h"
#include "somato/graph/further_learning.h"
#include "systems/walk/model_of_first.h"

namespace somato {
namespace {

using testing::kKinds;
using testing::map_of;
using testing::model_of_first;
using testing::recording;

using LoadedSystem = std::unique_ptr<somato_system, decltype(&somato_free)>;

// The model as a file that the interface has loaded.
LoadedSystem loaded(const SystemModel& model) {
  const TemporaryFolder folder;
  EXPECT_TRUE(save_system(folder.file("model"), model));
  std::array<char, 200> message{};
  LoadedSystem system(somato_load(folder.file("model").c_str(), message.data(), message.size()),
                      somato_free);
  EXPECT_NE(system, nullptr) << message.data();
  return system;
}

somato_status step(const LoadedSystem& system, std::span<const float> joints) {
  const float* const values = joints.data();
  return somato_step(system.get(), &values);
}

// Processes all frames of an exploration.
void follow(const LoadedSystem& system, const Recording& all, std::size_t exploration) {
  ASSERT_EQ(somato_start(system.get(), 0.0), SOMATO_OK);
  const Matrix<float>& frames = testing::frames_of(all, "joints", exploration);
  for (std::size_t frame = 0; frame < frames.rows(); ++frame) {
    ASSERT_EQ(step(system, frames.row(frame)), SOMATO_OK) << somato_message(system.get());
  }
}

somato_answer read(const LoadedSystem& system) {
  somato_answer answer{};
  EXPECT_EQ(somato_read(system.get(), &answer), SOMATO_OK) << somato_message(system.get());
  return answer;
}

SystemModel model_with_two(const std::string& kind) {
  SystemModel model = model_of_first(kind);
  EXPECT_TRUE(teach(model, recording(), 15, "cup"));
  return model;
}

TEST(CSystem, AnswersAsTheLibrary) {
  const Recording all = recording();
  for (const std::string& kind : kKinds) {
    for (const bool knows_unknown : {false, true}) {
      SystemModel model = model_with_two(kind);
      if (knows_unknown) model.answer->novelty = Novelty{0.1, 9, 0.8, {20.0, 50.0}};
      const auto expected = answers(model, all).value();
      const LoadedSystem system = loaded(model);
      for (std::size_t i = 0; i < all.explorations.size(); ++i) {
        follow(system, all, i);
        const somato_answer answer = read(system);
        EXPECT_EQ(answer.winner, expected[i].winner);
        EXPECT_EQ(answer.winner_distance, expected[i].winner_distance);
        EXPECT_EQ(answer.nearest, expected[i].nearest);
        EXPECT_EQ(answer.distance, expected[i].distance);
        EXPECT_EQ(answer.is_unknown != 0, expected[i].is_unknown());
        EXPECT_EQ(std::isnan(answer.novelty), !knows_unknown);
        if (knows_unknown) {
          EXPECT_EQ(answer.novelty, *expected[i].novelty);
        }
      }
    }
  }
}

TEST(CSystem, DescribesTheFrameAndTheClasses) {
  const LoadedSystem system = loaded(model_with_two("som"));
  ASSERT_EQ(somato_channels(system.get()), 1U);
  EXPECT_STREQ(somato_channel_name(system.get(), 0), "joints");
  EXPECT_EQ(somato_channel_elements(system.get(), 0),
            testing::frames_of(recording(), "joints", 0).columns());
  EXPECT_EQ(somato_channel_name(system.get(), 1), nullptr);
  EXPECT_EQ(somato_channel_elements(system.get(), 1), 0U);
  EXPECT_STREQ(somato_class_name(system.get(), 1), "cup");
  EXPECT_EQ(somato_class_name(system.get(), 2), nullptr);
  EXPECT_STREQ(somato_message(system.get()), "");
}

TEST(CSystem, TeachesAndSaves) {
  const Recording all = recording();
  for (const std::string& kind : kKinds) {
    SystemModel model = model_of_first(kind);
    const LoadedSystem system = loaded(model);
    follow(system, all, 15);
    ASSERT_EQ(somato_teach(system.get(), "cup"), SOMATO_OK) << somato_message(system.get());
    somato_answer answer{};
    EXPECT_EQ(somato_read(system.get(), &answer), SOMATO_USAGE);
    EXPECT_EQ(step(system, testing::frames_of(all, "joints", 15).row(0)), SOMATO_USAGE)
        << "the exploration has ended";
    follow(system, all, 15);
    EXPECT_STREQ(somato_class_name(system.get(), read(system).nearest), "cup");

    const TemporaryFolder folder;
    ASSERT_EQ(somato_save(system.get(), folder.file("taught").c_str()), SOMATO_OK);
    ASSERT_TRUE(teach(model, all, 15, "cup"));
    EXPECT_EQ(bytes_of(folder.file("taught")), testing::bytes_of_saved(model)) << kind;
  }
}

TEST(CSystem, SaysWhyAFileCannotBeLoaded) {
  const TemporaryFolder folder;
  std::array<char, 400> message{};
  EXPECT_EQ(somato_load(folder.file("none").c_str(), message.data(), message.size()), nullptr);
  EXPECT_NE(std::string(message.data()).find("none"), std::string::npos) << message.data();

  std::array<char, 5> cut{'x', 'x', 'x', 'x', 'x'};
  EXPECT_EQ(somato_load(folder.file("none").c_str(), cut.data(), cut.size()), nullptr);
  EXPECT_EQ(std::string(cut.data()), std::string(message.data()).substr(0, 4));
  EXPECT_EQ(somato_load(folder.file("none").c_str(), nullptr, 0), nullptr);
  EXPECT_EQ(somato_load(nullptr, message.data(), message.size()), nullptr);

  SystemModel model = model_of_first("som");
  model.answer = {};
  ASSERT_TRUE(save_system(folder.file("nameless"), model));
  EXPECT_EQ(somato_load(folder.file("nameless").c_str(), message.data(), message.size()), nullptr);
  EXPECT_STRNE(message.data(), "");
}

TEST(CSystem, RefusesCallsAtTheWrongTime) {
  const LoadedSystem system = loaded(model_with_two("som"));
  somato_answer answer{};
  answer.winner = 77;
  EXPECT_EQ(somato_read(system.get(), &answer), SOMATO_USAGE);
  EXPECT_STRNE(somato_message(system.get()), "");
  EXPECT_EQ(answer.winner, 77U);
  EXPECT_EQ(somato_teach(system.get(), "cup"), SOMATO_USAGE);
  EXPECT_EQ(somato_start(system.get(), -1.0), SOMATO_USAGE);
  EXPECT_EQ(somato_start(system.get(), std::nan("")), SOMATO_USAGE);

  const Recording all = recording();
  follow(system, all, 0);
  ASSERT_EQ(somato_start(system.get(), 10.0), SOMATO_OK);
  EXPECT_STREQ(somato_message(system.get()), "");
  EXPECT_EQ(somato_read(system.get(), &answer), SOMATO_USAGE) << "the last exploration has ended";
}

TEST(CSystem, RefusesFramesThatAreNoNumbersAndContinuesAfterAStart) {
  const Recording all = recording();
  const LoadedSystem system = loaded(model_with_two("som"));
  follow(system, all, 3);
  const somato_answer before = read(system);
  for (const float value : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    std::vector<float> frame(somato_channel_elements(system.get(), 0), 1.0F);
    frame.back() = value;
    EXPECT_EQ(step(system, frame), SOMATO_DATA);
    EXPECT_NE(std::string(somato_message(system.get())).find("joints"), std::string::npos);
  }
  EXPECT_EQ(somato_step(system.get(), nullptr), SOMATO_USAGE);
  EXPECT_EQ(read(system).distance, before.distance) << "a refused frame is not part of the answer";
  follow(system, all, 3);
  EXPECT_EQ(read(system).distance, before.distance);
}

// The code refuses values outside its range.
SystemModel model_with_code() {
  const Recording all = recording();
  const std::string text =
      "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n" +
      testing::module("code", "one_hot",
                      "input = 'joints'\nlow = -1000\nhigh = 1000\nelements = 100") +
      testing::module("sum", "accumulate", "input = 'code'") +
      testing::module("map", "som", "input = 'sum'\nrows = 2\ncolumns = 2\niterations = 20\n");
  SystemModel model{testing::trained(testing::build(text, all), all, 6, 3), {}};
  model.answer = answer_of(model.system, 3, "object", {"a"}, {0}, {0});
  return model;
}

TEST(CSystem, NeedsAStartAfterAFrameThatAModuleRefuses) {
  const Recording all = recording();
  const LoadedSystem system = loaded(model_with_code());
  follow(system, all, 0);
  const std::vector<float> outside(somato_channel_elements(system.get(), 0), 5000.0F);
  EXPECT_EQ(step(system, outside), SOMATO_DATA);
  EXPECT_NE(std::string(somato_message(system.get())).find("code"), std::string::npos);
  EXPECT_EQ(step(system, testing::frames_of(all, "joints", 0).row(0)), SOMATO_USAGE);
  somato_answer answer{};
  EXPECT_EQ(somato_read(system.get(), &answer), SOMATO_USAGE);
  follow(system, all, 0);
  EXPECT_EQ(somato_read(system.get(), &answer), SOMATO_OK);
}

TEST(CSystem, RefusesNamesAndPathsThatCannotBe) {
  const Recording all = recording();
  const LoadedSystem system = loaded(model_with_two("som"));
  follow(system, all, 3);
  for (const char* name : {"", "unknown", "two\nlines"}) {
    EXPECT_EQ(somato_teach(system.get(), name), SOMATO_USAGE) << name;
  }
  EXPECT_EQ(somato_teach(system.get(), nullptr), SOMATO_USAGE);
  EXPECT_EQ(somato_save(system.get(), nullptr), SOMATO_USAGE);
  EXPECT_EQ(somato_save(system.get(), "/no/such/folder/model"), SOMATO_FAILED);
  EXPECT_GT(read(system).winner_distance, -1.0) << "the exploration continues";
  somato_free(nullptr);
}

TEST(CSystem, AllocatesNothingAfterTheFirstFrame) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "sanitizers bring their own operator new";
  const Recording all = recording();
  SystemModel model = model_with_two("som");
  model.answer->novelty = Novelty{0.1, 9, 0.8, {20.0, 50.0}};
  const LoadedSystem system = loaded(model);
  const auto frame = testing::frames_of(all, "joints", 0).row(0);
  ASSERT_EQ(step(system, frame), SOMATO_OK);
  EXPECT_GE(read(system).distance, 0.0);
  const testing::AllocationCounter counter;
  for (std::size_t i = 1; i < all.explorations.size(); ++i) {
    ASSERT_EQ(step(system, testing::frames_of(all, "joints", i).row(0)), SOMATO_OK);
    EXPECT_GE(read(system).distance, 0.0);
  }
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace somato
