#include "views/teaching/teacher.h"

#include <gtest/gtest.h>

#include "base/support/damaged_files.h"
#include "base/support/temporary_folder.h"
#include "views/live/view_systems.h"
#include "views/replay/timeline.h"
#include "views/session/system_reading.h"

namespace somato::live {
namespace {

std::shared_ptr<const SystemModel> model() {
  return testing::trained_model(testing::crossed_system(), testing::hand_recording(6, 2));
}

std::string bytes_of_saved(const SystemModel& saved) {
  const TemporaryFolder folder;
  EXPECT_TRUE(save_system(folder.file("model"), saved.system, saved.answer));
  return bytes_of(folder.file("model"));
}

// The name that a model answers for a whole exploration.
std::string answer_for(const std::shared_ptr<const SystemModel>& model,
                       const Exploration& exploration) {
  SystemReading reading = SystemReading::build(model).value();
  std::vector<std::size_t> frames;
  for (const Channel& channel : exploration.channels) frames.push_back(channel.frames.rows());
  EXPECT_TRUE(reading.follow(exploration, frames));
  return reading.read().value()->name(model->answer->classes);
}

TEST(Teacher, TeachesNamesAndLeavesTheFirstModelAsItWas) {
  const Recording others = testing::hand_recording(4, 9);
  const auto first = model();
  const std::string bytes = bytes_of_saved(*first);
  Teacher teacher(first);
  EXPECT_EQ(teacher.teach(others, 2, "cup").problem, "");
  EXPECT_EQ(teacher.teach(others, 3, "mug").problem, "");
  ASSERT_EQ(teacher.names().size(), 2U);
  EXPECT_EQ(teacher.names()[0].exploration, 2U);
  EXPECT_EQ(teacher.names()[0].taught.before, answer_for(first, others.explorations[2]));
  EXPECT_EQ(answer_for(teacher.model(), others.explorations[2]), "cup");
  EXPECT_EQ(answer_for(teacher.model(), others.explorations[3]), "mug");
  EXPECT_EQ(bytes_of_saved(*first), bytes);
  teacher.forget();
  EXPECT_EQ(teacher.model(), first);
  EXPECT_TRUE(teacher.names().empty());
}

// The law: a name that is corrected leaves no trace.
TEST(Teacher, CorrectsANameAsIfItHadNotBeenGiven) {
  const Recording others = testing::hand_recording(4, 9);
  Teacher corrected(model());
  corrected.teach(others, 1, "typo");
  corrected.teach(others, 3, "mug");
  corrected.teach(others, 1, "cup");
  Teacher right(model());
  right.teach(others, 1, "cup");
  right.teach(others, 3, "mug");
  EXPECT_EQ(bytes_of_saved(*corrected.model()), bytes_of_saved(*right.model()));
  ASSERT_EQ(corrected.names().size(), 2U);
  EXPECT_EQ(corrected.names()[0].name, "cup");
}

// The law: a name that is taken back leaves no trace.
TEST(Teacher, ForgetsANameThatIsTakenBack) {
  const Recording others = testing::hand_recording(4, 9);
  const auto first = model();
  Teacher teacher(first);
  teacher.teach(others, 1, "typo");
  teacher.teach(others, 3, "mug");
  teacher.take_back(others, 1);
  Teacher right(first);
  right.teach(others, 3, "mug");
  EXPECT_EQ(bytes_of_saved(*teacher.model()), bytes_of_saved(*right.model()));
  ASSERT_EQ(teacher.names().size(), 1U);
  teacher.take_back(others, 3);
  EXPECT_EQ(teacher.model(), first);
}

// The names of explorations that are no longer kept remain learned, and are replaced no more.
TEST(Teacher, SettlesNamesOfExplorationsThatAreDropped) {
  const Recording others = testing::hand_recording(6, 9);
  Teacher right(model());
  for (const auto& [exploration, name] :
       {std::pair(1, "cup"), std::pair(3, "mug"), std::pair(4, "jug")}) {
    right.teach(others, static_cast<std::size_t>(exploration), name);
  }
  Teacher teacher(model());
  teacher.teach(others, 1, "cup");
  teacher.teach(others, 3, "typo");
  teacher.settle_before(2, others, 0);
  ASSERT_EQ(teacher.names().size(), 1U);
  Recording kept = others;
  kept.explorations.erase(kept.explorations.begin(), kept.explorations.begin() + 2);
  teacher.teach(kept, 3, "mug", 2);
  teacher.teach(kept, 4, "jug", 2);
  EXPECT_EQ(bytes_of_saved(*teacher.model()), bytes_of_saved(*right.model()));
  teacher.settle_before(6, kept, 2);
  EXPECT_TRUE(teacher.names().empty());
  teacher.forget();
  EXPECT_EQ(bytes_of_saved(*teacher.model()), bytes_of_saved(*right.model()));
}

TEST(Teacher, KeepsANameThatCannotBeLearnedWithItsReason) {
  const Recording others = testing::hand_recording(4, 9);
  Teacher teacher(model());
  const TaughtName refused = teacher.teach(others, 1, "unknown");
  EXPECT_NE(refused.problem.find("give another name."), std::string::npos) << refused.problem;
  EXPECT_EQ(bytes_of_saved(*teacher.model()), bytes_of_saved(*model()));
  EXPECT_EQ(teacher.teach(others, 1, "cup").problem, "");
}

}  // namespace
}  // namespace somato::live
