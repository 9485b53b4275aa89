#include "views/teaching/kept_explorations.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/support/failing_file_system.h"
#include "base/support/temporary_folder.h"
#include "recordings/explorations/growing_channel.h"
#include "somato/recording/recording_file.h"
#include "views/live/viewing.h"

namespace somato::live {
namespace {

// Two explorations of a hand, of which the view begins with the first.
class KeptExplorationsTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string path_ = folder_.file("session.mcap");
  ViewSource source_ = testing::hand_source(2);
  Exploration second_ = source_.recording.explorations.back();
  std::unique_ptr<GrowingRecording> file_ = GrowingRecording::begin(path_).value();

  void SetUp() override {
    source_.recording.explorations.pop_back();
    source_.file = file_.get();
  }

  std::vector<Exploration> saved() {
    EXPECT_TRUE(file_->finish());
    return read_recording(path_).value().explorations;
  }
};

TEST_F(KeptExplorationsTest, SavesWhatIsAddedWithTheGivenLabels) {
  KeptExplorations kept(source_);
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

// An index is that of the next exploration if one is discarded, an identifier is not.
TEST_F(KeptExplorationsTest, IdentifiesAnExplorationForEver) {
  source_.file = nullptr;
  KeptExplorations kept(source_);
  EXPECT_EQ(kept.id(0), 0U);
  const std::size_t discarded = kept.id(1);
  kept.discard_next();
  const std::size_t second = kept.id(1);
  EXPECT_NE(second, discarded);
  EXPECT_EQ(kept.index_of(second).value(), 1U);
  EXPECT_FALSE(kept.index_of(discarded));
  EXPECT_FALSE(kept.index_of(second + 1)) << "it has not begun";
  ASSERT_TRUE(kept.add(second_, nullptr));
  EXPECT_EQ(kept.id(1), second) << "it has ended";
  Exploration other = second_;
  other.channels.pop_back();
  const std::size_t unlike = kept.id(2);
  EXPECT_FALSE(kept.add(other, nullptr));
  EXPECT_NE(kept.id(2), unlike);
  kept.drop_before(1);
  EXPECT_FALSE(kept.index_of(0));
  EXPECT_EQ(kept.index_of(second).value(), 1U);
  const std::size_t unkept = kept.id(2);
  kept.drop_before(2);
  ASSERT_TRUE(kept.add_unkept());
  EXPECT_FALSE(kept.index_of(unkept));
  EXPECT_EQ(kept.index_of(kept.id(3)).value(), 3U);
}

TEST_F(KeptExplorationsTest, RefusesOneThatIsUnlikeTheOthers) {
  KeptExplorations kept(source_);
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
  source_.file = full.get();
  KeptExplorations kept(source_);
  ASSERT_TRUE(kept.add(second_, nullptr));
  while (kept.save_last()) ASSERT_TRUE(kept.add(second_, nullptr));
  EXPECT_TRUE(files.failed());
  EXPECT_EQ(kept.unsaved(), 1U);
  ASSERT_TRUE(kept.add(second_, nullptr));
  EXPECT_TRUE(kept.save_last()) << "the error is reported once";
  EXPECT_EQ(kept.unsaved(), 2U);
  EXPECT_TRUE(kept.name(kept.count() - 1, {"object", "cup"}));
  EXPECT_EQ(kept.names().given(kept.count() - 1, "object"), "cup");
}

TEST_F(KeptExplorationsTest, TheOldestMakeRoom) {
  source_.file = nullptr;
  KeptExplorations kept(source_);
  std::size_t bytes = 0;
  for (const Channel& channel : second_.channels) bytes += bytes_of(channel);
  for (std::size_t i = 1; i < 10; ++i) {
    ASSERT_TRUE(kept.name(i, {i == 2 ? "size" : "object", "cup " + std::to_string(i)}));
    ASSERT_TRUE(kept.add(second_, nullptr));
    const std::size_t first = kept.first_within(3 * bytes);
    EXPECT_EQ(first, i < 4 ? 0U : i - 2) << "that of the beginning takes no room";
    kept.drop_before(first);
    EXPECT_EQ(kept.count(), i + 1);
    EXPECT_EQ(kept.first(), first);
  }
  EXPECT_EQ(kept.first_within(0), 9U) << "the last one is kept in any case";
  EXPECT_EQ(kept[8].channels, second_.channels);
  EXPECT_EQ(kept.names().given(8, "object"), "cup 8");
  EXPECT_EQ(kept.names().given(2, "size"), std::nullopt);
  const auto labels = kept.names().labels(8, second_.labels);
  EXPECT_EQ(labels.back(), (Label{"size", "unknown"})) << "explorations have the same labels";
}

TEST_F(KeptExplorationsTest, OneThatIsNotKeptIsInTheFile) {
  KeptExplorations kept(source_);
  BodyDescription body;
  for (const Channel& channel : second_.channels) {
    body.sensors.push_back(description_of(channel));
    body.sensors.back().times_known = true;
  }
  kept.begin_next(body, second_.labels);
  for (std::size_t frame = 0; frame < 3; ++frame) {
    BodyState state;
    state.time = static_cast<double>(frame);
    for (const Channel& channel : second_.channels) {
      const auto row = channel.frames.row(0);
      state.readings.emplace_back(1, row.size(), std::vector<float>(row.begin(), row.end()));
    }
    ASSERT_TRUE(kept.append_to_next(state));
  }
  kept.drop_before(kept.count());
  ASSERT_TRUE(kept.add_unkept());
  EXPECT_EQ(kept.count(), 2U);
  EXPECT_EQ(kept.first(), 2U);
  ASSERT_TRUE(kept.add(second_, nullptr));
  ASSERT_TRUE(kept.save_last());
  ASSERT_TRUE(kept.name(2, {"object", "bowl"}));
  const auto saved = this->saved();
  ASSERT_EQ(saved.size(), 2U);
  EXPECT_EQ(saved[0].labels, second_.labels);
  EXPECT_EQ(saved[0].channels[0].frames.rows(), 3U);
  EXPECT_EQ(saved[1].labels[0].value, "bowl");
}

// The file cannot forget a label: it has the value of before.
TEST_F(KeptExplorationsTest, TakesNamesBackAlsoInTheFile) {
  KeptExplorations kept(source_);
  ASSERT_TRUE(kept.name(1, {"object", "cup"})) << "while it takes place";
  ASSERT_TRUE(kept.name(1, {"object", "mug"}));
  ASSERT_TRUE(kept.take_back_name());
  ASSERT_TRUE(kept.add(second_, nullptr));
  ASSERT_TRUE(kept.save_last());
  ASSERT_TRUE(kept.add(second_, nullptr));
  ASSERT_TRUE(kept.save_last());
  ASSERT_TRUE(kept.name(2, {"object", "bowl"}));
  ASSERT_TRUE(kept.name(2, {"size", "large"}));
  ASSERT_TRUE(kept.take_back_name());
  ASSERT_TRUE(kept.take_back_name());
  EXPECT_EQ(kept.names().last()->label, (Label{"object", "cup"}));
  const auto saved = this->saved();
  EXPECT_EQ(saved[0].labels, kept.names().labels(1, second_.labels));
  EXPECT_EQ(saved[0].labels[0].value, "cup");
  EXPECT_EQ(saved[1].labels, kept.names().labels(2, second_.labels));
  EXPECT_EQ(saved[1].labels.back(), (Label{"size", "unknown"}));
}

TEST_F(KeptExplorationsTest, CountsNames) {
  source_.file = nullptr;
  source_.names = {"cup"};
  KeptExplorations kept(source_);
  using Counts = std::vector<NameCount>;
  EXPECT_EQ(kept.counts().of("object"), (Counts{{"cup", 0}, {"object 0", 1}}));
  ASSERT_TRUE(kept.name(1, {"object", "bowl"}));
  kept.discard_next();
  EXPECT_EQ(kept.counts().of("object"), (Counts{{"cup", 0}, {"object 0", 1}}));
  ASSERT_TRUE(kept.name(1, {"object", "cup"}));
  EXPECT_EQ(kept.counts().of("object"), (Counts{{"cup", 1}, {"object 0", 1}}));
  ASSERT_TRUE(kept.add(second_, nullptr));
  EXPECT_EQ(kept.counts().of("object"), (Counts{{"cup", 1}, {"object 0", 1}})) << "once";
  ASSERT_TRUE(kept.name(1, {"object", "mug"}));
  ASSERT_TRUE(kept.name(1, {"object", "mug"}));
  EXPECT_EQ(kept.counts().of("object"), (Counts{{"cup", 0}, {"object 0", 1}, {"mug", 1}}));
  ASSERT_TRUE(kept.take_back_name());
  EXPECT_EQ(kept.counts().of("object"), (Counts{{"cup", 1}, {"object 0", 1}}));
  kept.drop_before(1);
  EXPECT_EQ(kept.counts().of("object"), (Counts{{"cup", 1}, {"object 0", 1}}))
      << "those that are no longer kept are counted";
}

TEST_F(KeptExplorationsTest, SavesNothingWithoutAFile) {
  source_.file = nullptr;
  KeptExplorations kept(source_);
  kept.begin_next({}, {});
  EXPECT_TRUE(kept.append_to_next({}));
  ASSERT_TRUE(kept.add(second_, nullptr));
  EXPECT_TRUE(kept.save_last());
  EXPECT_TRUE(kept.name(0, {"object", "cup"}));
}

}  // namespace
}  // namespace somato::live
