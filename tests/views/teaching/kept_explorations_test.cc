#include "views/teaching/kept_explorations.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <memory>
#include <utility>
#include <vector>

#include "base/support/failing_file_system.h"
#include "base/support/temporary_folder.h"
#include "somato/recording/recording_file.h"
#include "views/live/viewing.h"

namespace somato::live {
namespace {

// Two explorations of a hand, of which the view begins with the first.
class KeptExplorationsTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string path_ = folder_.file("session.mcap");
  Recording recording_ = testing::hand_source(2).recording;
  Exploration second_ = recording_.explorations.back();
  std::unique_ptr<GrowingRecording> file_ = GrowingRecording::begin(path_).value();

  void SetUp() override { recording_.explorations.pop_back(); }

  std::vector<Exploration> saved() {
    EXPECT_TRUE(file_->finish());
    return read_recording(path_).value().explorations;
  }
};

TEST_F(KeptExplorationsTest, SavesWhatIsAddedWithTheGivenLabels) {
  KeptExplorations kept(recording_, file_.get());
  ASSERT_TRUE(kept.name(1, {"object", "cup"})) << "while it takes place";
  ASSERT_TRUE(kept.add(second_, nullptr));
  ASSERT_TRUE(kept.save_last());
  EXPECT_EQ(kept.count(), 2U);
  EXPECT_EQ(kept.scene(1), nullptr);
  ASSERT_TRUE(kept.add(second_, nullptr));
  ASSERT_TRUE(kept.save_last());
  ASSERT_TRUE(kept.name(1, {"object", "bowl"})) << "though it is saved";
  EXPECT_FALSE(kept.name(0, {"object", "bowl"})) << "it is in another file";
  const auto saved = this->saved();
  ASSERT_EQ(saved.size(), 2U);
  EXPECT_EQ(saved[0].labels[0].value, "bowl");
  EXPECT_EQ(saved[0].channels, second_.channels);
  EXPECT_EQ(saved[1].labels, second_.labels);
}

TEST_F(KeptExplorationsTest, RefusesOneThatIsUnlikeTheOthers) {
  KeptExplorations kept(recording_, file_.get());
  ASSERT_TRUE(kept.name(1, {"object", "cup"}));
  Exploration other = second_;
  other.channels.pop_back();
  EXPECT_FALSE(kept.add(other, nullptr));
  EXPECT_EQ(kept.count(), 1U);
  EXPECT_TRUE(kept.names().empty()) << "its labels are forgotten";
  ASSERT_TRUE(kept.add(second_, nullptr));
  ASSERT_TRUE(kept.save_last());
  EXPECT_EQ(saved()[0].labels, second_.labels);
}

// The numbers of explorations and those in the file are no longer the same then.
TEST_F(KeptExplorationsTest, GoesOnThoughTheDiskIsFull) {
  testing::FailingFileSystem files(12, ENOSPC);
  const auto full = GrowingRecording::begin(files, folder_.file("full.mcap")).value();
  KeptExplorations kept(recording_, full.get());
  ASSERT_TRUE(kept.add(second_, nullptr));
  while (kept.save_last()) ASSERT_TRUE(kept.add(second_, nullptr));
  EXPECT_TRUE(files.failed());
  EXPECT_FALSE(kept.name(kept.count() - 1, {"object", "cup"}));
  EXPECT_FALSE(kept.name(1, {"object", "cup"})) << "nothing can be written";
}

TEST_F(KeptExplorationsTest, SavesNothingWithoutAFile) {
  KeptExplorations kept(recording_, nullptr);
  kept.begin_next({}, {});
  EXPECT_TRUE(kept.append_to_next({}));
  ASSERT_TRUE(kept.add(second_, nullptr));
  EXPECT_TRUE(kept.save_last());
  EXPECT_TRUE(kept.name(0, {"object", "cup"}));
}

}  // namespace
}  // namespace somato::live
