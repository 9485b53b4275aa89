#include "recordings/file/growing_recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/support/eventually.h"
#include "base/support/failing_file_system.h"
#include "base/support/temporary_folder.h"
#include "base/support/traced_file_system.h"
#include "somato/recording/inspect_recording.h"
#include "somato/recording/recover_recording.h"
#include "systems/support/systems.h"

namespace somato {
namespace {

namespace fs = std::filesystem;
using testing::FailingFileSystem;
using testing::TracedFileSystem;

class GrowingRecordingTest : public ::testing::Test {
 protected:
  std::string path() const { return folder_.file("hand.mcap"); }
  std::string partial() const { return folder_.file("hand.mcap.partial"); }

  std::unique_ptr<GrowingRecording> begin() const {
    return GrowingRecording::begin(path()).value();
  }

  // The recording that is recovered from the partial file as it is now.
  Recording recovered() const {
    const auto report = recover_recording(partial(), folder_.file("recovered"));
    if (!report) return {};
    return read_recording(folder_.file("recovered")).value();
  }

  static ExplorationStart draft_start() {
    ExplorationStart start;
    start.labels = {{"object", "ball"}};
    start.channels.resize(1);
    start.channels[0].name = "touch";
    return start;
  }

  // A draft of some frames.
  static void draft(GrowingRecording& file, int frames = 3) {
    ASSERT_TRUE(file.begin_draft(draft_start()));
    for (int i = 0; i < frames; ++i) {
      ASSERT_TRUE(file.draft_frame(0, std::vector<float>{1.0F, 2.0F}, 0.1 * i));
    }
  }

  TemporaryFolder folder_;
  Recording three_ = testing::hand_recording(3, 1);
};

// The same file as if all had been known from the beginning.
TEST_F(GrowingRecordingTest, BecomesTheFileOfARecording) {
  const auto file = begin();
  draft(*file);
  ASSERT_TRUE(file->name(0, {"object", "cone"}));
  ASSERT_TRUE(file->add(three_.explorations[0]));
  draft(*file);
  ASSERT_TRUE(file->drop_draft()) << "an exploration failed";
  ASSERT_TRUE(file->add(three_.explorations[1]));
  draft(*file);
  ASSERT_TRUE(file->name(1, {"object", "egg"}));
  ASSERT_TRUE(file->add(three_.explorations[2]));
  ASSERT_TRUE(file->name(1, {"object", "pear"}));
  draft(*file);
  EXPECT_FALSE(fs::exists(path()));
  ASSERT_TRUE(file->finish());
  EXPECT_EQ(file->count(), 3U);
  EXPECT_EQ(folder_.count(), 1) << "the partial file is removed";
  three_.explorations[0].labels = {{"object", "cone"}};
  three_.explorations[1].labels = {{"object", "pear"}};
  ASSERT_TRUE(write_recording(folder_.file("expected"), three_));
  EXPECT_TRUE(bytes_of(path()) == bytes_of(folder_.file("expected")));
}

TEST_F(GrowingRecordingTest, CanBeRecoveredAtAnyMoment) {
  const auto file = begin();
  for (std::size_t i = 0; i < 3; ++i) {
    draft(*file);
    ASSERT_TRUE(file->add(three_.explorations[i]));
    EXPECT_EQ(recovered().explorations,
              std::vector<Exploration>(three_.explorations.begin(),
                                       three_.explorations.begin() + static_cast<int>(i) + 1));
    ASSERT_TRUE(file->name(i, {"object", "cup"}));
    three_.explorations[i].labels = {{"object", "cup"}};
    EXPECT_EQ(recovered().explorations[i], three_.explorations[i]) << "its name is on the disk";
  }
}

// The frames of an exploration in progress are on the disk half a second after they came.
TEST_F(GrowingRecordingTest, HasTheExplorationInProgress) {
  const auto file = begin();
  ASSERT_TRUE(file->add(three_.explorations[0]));
  draft(*file, 5);
  ASSERT_TRUE(file->name(1, {"object", "cup"}));
  Recording now;
  ASSERT_TRUE(testing::eventually([&] {
    now = recovered();
    return now.explorations.size() == 2 && now.explorations[1].channels[0].frames.rows() == 5;
  }));
  EXPECT_EQ(now.explorations[0], three_.explorations[0]);
  EXPECT_EQ(now.explorations[1].labels, (std::vector<Label>{{"object", "cup"}}));
  EXPECT_EQ(now.explorations[1].channels[0].frames.rows(), 5U);
}

// The program may be killed as soon as a name was confirmed.
TEST_F(GrowingRecordingTest, HasTheNameOfTheExplorationInProgressAtOnce) {
  const auto file = begin();
  draft(*file, 5);
  ASSERT_TRUE(file->name(0, {"object", "cup"}));
  const Recording now = recovered();
  ASSERT_EQ(now.explorations.size(), 1U);
  EXPECT_EQ(now.explorations[0].labels, (std::vector<Label>{{"object", "cup"}}));
  EXPECT_EQ(now.explorations[0].channels[0].frames.rows(), 5U);
}

// A label that one exploration was given is unknown for the others, as validate() requires.
TEST_F(GrowingRecordingTest, AddsALabelToAllExplorations) {
  const auto file = begin();
  for (const Exploration& one : three_.explorations) ASSERT_TRUE(file->add(one));
  ASSERT_TRUE(file->name(1, {"shape", "round"}));
  ASSERT_TRUE(validate(recovered()));
  ASSERT_TRUE(file->finish());
  const Recording read = read_recording(path()).value();
  EXPECT_TRUE(validate(read));
  EXPECT_EQ(read.explorations[0].labels.back(), (Label{"shape", "unknown"}));
  EXPECT_EQ(read.explorations[1].labels.back(), (Label{"shape", "round"}));
}

TEST_F(GrowingRecordingTest, RefusesAnExplorationThatIsNotValid) {
  const auto file = begin();
  Exploration bad = three_.explorations[0];
  bad.labels[0].value = "\xFF";
  EXPECT_EQ(file->add(bad).error().kind, ErrorKind::kData);
  bad = three_.explorations[0];
  bad.channels[1].name = "\xFF";
  draft(*file);
  EXPECT_EQ(file->add(bad).error().kind, ErrorKind::kData);
  EXPECT_EQ(file->count(), 0U);
  ASSERT_TRUE(file->add(three_.explorations[0])) << "others follow";
  ASSERT_TRUE(file->finish());
  EXPECT_EQ(read_recording(path()).value().explorations.size(), 1U);
}

TEST_F(GrowingRecordingTest, LeavesNothingWithoutAnExploration) {
  folder_.with("hand.mcap", "an older one");
  {
    const auto file = begin();
    draft(*file);
    ASSERT_TRUE(file->finish());
  }
  {
    const auto file = begin();
  }
  EXPECT_EQ(folder_.count(), 1);
  EXPECT_EQ(bytes_of(path()), "an older one");
}

TEST_F(GrowingRecordingTest, DoesNotBeginWhereItCouldNotEnd) {
  fs::create_directory(path());
  EXPECT_FALSE(GrowingRecording::begin(path()));
  EXPECT_FALSE(GrowingRecording::begin(folder_.file("none/hand.mcap")));
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(GrowingRecordingTest, RemainsWithoutItsEnd) {
  {
    const auto file = begin();
    ASSERT_TRUE(file->add(three_.explorations[0]));
  }
  EXPECT_FALSE(fs::exists(path()));
  EXPECT_EQ(recovered().explorations.size(), 1U);
  const std::string before = bytes_of(partial());
  const auto again = GrowingRecording::begin(path());
  ASSERT_FALSE(again);
  EXPECT_NE(again.error().advice.find("somato recover "), std::string::npos);
  EXPECT_EQ(bytes_of(partial()), before);
}

TEST_F(GrowingRecordingTest, WritesADeviceDirectly) {
  const auto file = GrowingRecording::begin("/dev/null").value();
  ASSERT_TRUE(file->begin_draft(draft_start()));
  ASSERT_TRUE(file->draft_frame(0, std::vector<float>{1.0F}, 0.0));
  ASSERT_TRUE(file->add(three_.explorations[0]));
  EXPECT_FALSE(file->name(0, {"object", "cup"}));
  EXPECT_EQ(file->count(), 1U);
  EXPECT_TRUE(file->finish());
}

std::ptrdiff_t place_of(const std::vector<std::string>& trace, const std::string& step) {
  return std::find(trace.begin(), trace.end(), step) - trace.begin();
}

// For a power failure: what is reported is synchronized before, and its name in the folder, too.
TEST_F(GrowingRecordingTest, IsSynchronizedBeforeTheEndOfAnExplorationIsReported) {
  TracedFileSystem files;
  const auto file = GrowingRecording::begin(files, path()).value();
  EXPECT_LT(place_of(files.trace, "create hand.mcap.partial"),
            place_of(files.trace, "flush folder"));
  EXPECT_LT(place_of(files.trace, "flush folder"), std::ssize(files.trace));
  for (const Exploration& one : three_.explorations) {
    draft(*file);
    files.trace.clear();
    ASSERT_TRUE(file->add(one));
    EXPECT_EQ(files.trace,
              (std::vector<std::string>{"write hand.mcap.partial", "flush hand.mcap.partial"}));
  }
  files.trace.clear();
  ASSERT_TRUE(file->name(0, {"object", "cup"}));
  EXPECT_EQ(files.trace.back(), "flush hand.mcap.partial");
  draft(*file);
  files.trace.clear();
  ASSERT_TRUE(file->name(3, {"object", "cup"})) << "while it takes place";
  ASSERT_FALSE(files.trace.empty());
  EXPECT_EQ(files.trace.back(), "flush hand.mcap.partial");
  files.trace.clear();
  ASSERT_TRUE(file->keep_draft());
  ASSERT_FALSE(files.trace.empty());
  EXPECT_EQ(files.trace.back(), "flush hand.mcap.partial");
}

TEST_F(GrowingRecordingTest, IsRemovedOnlyAfterTheFileWasReadBack) {
  TracedFileSystem files;
  const auto file = GrowingRecording::begin(files, path()).value();
  ASSERT_TRUE(file->add(three_.explorations[0]));
  files.trace.clear();
  ASSERT_TRUE(file->finish());
  const std::vector<std::string> order{"write new",        "flush new",
                                       "rename hand.mcap", "flush folder",
                                       "read hand.mcap",   "remove hand.mcap.partial"};
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    EXPECT_LT(place_of(files.trace, order[i]), place_of(files.trace, order[i + 1])) << order[i];
  }
  EXPECT_LT(place_of(files.trace, order.back()), std::ssize(files.trace));
}

// An exploration that was reported as added can be read or recovered, also if the disk is full.
TEST_F(GrowingRecordingTest, LosesNothingThatWasReportedWhenTheDiskIsFull) {
  bool failed = true;
  for (int failing = 0; failed; ++failing) {
    SCOPED_TRACE("operation " + std::to_string(failing));
    for (const std::string& left : {path(), partial(), folder_.file("recovered")}) fs::remove(left);
    FailingFileSystem files(failing, ENOSPC);
    files.flushes = false;
    std::size_t reported = 0;
    bool named = false;
    if (const auto begun = GrowingRecording::begin(files, path())) {
      GrowingRecording& file = **begun;
      for (const Exploration& one : three_.explorations) {
        (void)file.begin_draft(draft_start());
        (void)file.draft_frame(0, std::vector<float>{1.0F}, 0.0);
        if (!file.add(one)) break;
        ++reported;
        named = reported == 1 ? file.name(0, {"object", "cup"}).has_value() : named;
      }
      const auto finished = file.finish();
      if (!finished && reported > 0 && fs::exists(partial())) {
        EXPECT_NE(finished.error().advice.find("somato recover"), std::string::npos);
      }
    }
    failed = files.failed();
    if (reported == 0) continue;
    const auto whole = read_recording(path());
    const Recording kept = whole ? *whole : recovered();
    ASSERT_GE(kept.explorations.size(), reported);
    for (std::size_t i = 0; i < reported; ++i) {
      EXPECT_EQ(kept.explorations[i].channels, three_.explorations[i].channels);
    }
    if (named) {
      EXPECT_EQ(kept.explorations[0].labels[0].value, "cup");
    }
  }
}

// Other readers apply the names, too.
TEST_F(GrowingRecordingTest, IsReadWithItsNamesByAllReaders) {
  auto writer = RecordingWriter::create(path()).value();
  ASSERT_TRUE(writer.begin_exploration(draft_start()));
  ASSERT_TRUE(writer.frame(0, std::vector<float>{1.0F}, 0.0));
  ASSERT_TRUE(writer.end_exploration());
  ASSERT_TRUE(writer.begin_exploration(draft_start()));
  ASSERT_TRUE(writer.frame(0, std::vector<float>{2.0F}, 0.0));
  ASSERT_TRUE(writer.end_exploration());
  ASSERT_TRUE(writer.label(0, {"object", "mug"}));
  ASSERT_TRUE(writer.label(0, {"object", "cup"}));
  ASSERT_TRUE(writer.leave_out(1));
  EXPECT_THROW((void)writer.label(2, {"object", "cup"}), InvalidArgument);
  EXPECT_THROW((void)writer.leave_out(2), InvalidArgument);
  EXPECT_EQ(writer.label(0, {"object", "\xFF"}).error().kind, ErrorKind::kData);
  EXPECT_EQ(writer.label(0, {"object", std::string(1 << 20, 'a')}).error().kind, ErrorKind::kData);
  ASSERT_TRUE(writer.close());
  const Recording read = read_recording(path()).value();
  ASSERT_EQ(read.explorations.size(), 1U);
  EXPECT_EQ(read.explorations[0].labels[0].value, "cup");
  const RecordingSummary summary = inspect_recording(path()).value();
  EXPECT_EQ(summary.explorations, 1U);
  EXPECT_EQ(summary.labels[0].values[0].value, "cup");
  const auto report = recover_recording(path(), folder_.file("recovered"));
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->lossless);
  EXPECT_EQ(report->explorations, 1U);
  EXPECT_EQ(read_recording(folder_.file("recovered")).value(), read);
}

// A recording whose files begin at moments of a clock that the test moves.
class RollingRecordingTest : public GrowingRecordingTest {
 protected:
  Rollover rollover(double every) {
    Rollover rollover;
    rollover.every = every;
    rollover.now = [this] { return now_; };
    return rollover;
  }

  std::string file_at(const std::string& time) const {
    return folder_.file("hand_1970-01-01T" + time + "Z.mcap");
  }

  std::size_t explorations_in(const std::string& path) const {
    const auto read = read_recording(path);
    return read ? read->explorations.size() : 0;
  }

  double now_ = 0.0;
  std::string pattern_ = folder_.file("hand_{time}.mcap");
};

TEST_F(RollingRecordingTest, GoesOnInAnotherFileBeforeTheNextExploration) {
  const auto file = GrowingRecording::begin(pattern_, rollover(60.0)).value();
  ASSERT_TRUE(file->add(three_.explorations[0]));
  now_ = 61.0;
  EXPECT_EQ(folder_.count(), 1) << "no exploration has begun yet";
  ASSERT_TRUE(file->name(0, {"object", "cup"}));
  draft(*file);
  EXPECT_EQ(explorations_in(file_at("00-00-00")), 1U);
  EXPECT_EQ(folder_.count(), 2) << "a complete file, and the partial one of the next";
  ASSERT_TRUE(file->name(1, {"object", "egg"}));
  now_ = 200.0;
  ASSERT_TRUE(file->add(three_.explorations[1]));
  ASSERT_TRUE(file->name(1, {"object", "pear"})) << "the file ends with the next exploration";
  const auto late = file->name(0, {"object", "mug"});
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().kind, ErrorKind::kUsage);
  draft(*file);
  ASSERT_TRUE(file->drop_draft());
  ASSERT_TRUE(file->name(2, {"object", "kept for the next"}));
  ASSERT_TRUE(file->add(three_.explorations[2]));
  ASSERT_TRUE(file->finish());
  EXPECT_EQ(file->count(), 3U);
  EXPECT_EQ(file->files(), 3U);
  EXPECT_EQ(folder_.count(), 3) << "no partial file remains";
  EXPECT_EQ(read_recording(file_at("00-00-00"))->explorations[0].labels[0].value, "cup");
  EXPECT_EQ(read_recording(file_at("00-01-01"))->explorations[0].labels[0].value, "pear");
  EXPECT_EQ(read_recording(file_at("00-03-20"))->explorations[0].labels[0].value,
            "kept for the next");
}

TEST_F(RollingRecordingTest, ReplacesNoFileOfTheSameSecond) {
  const auto file = GrowingRecording::begin(pattern_, rollover(0.0)).value();
  for (const Exploration& one : three_.explorations) ASSERT_TRUE(file->add(one));
  ASSERT_TRUE(file->finish());
  EXPECT_EQ(folder_.count(), 3);
  EXPECT_EQ(explorations_in(file_at("00-00-00")), 1U);
  EXPECT_EQ(explorations_in(folder_.file("hand_1970-01-01T00-00-00Z-3.mcap")), 1U);
}

TEST_F(RollingRecordingTest, WithoutAnExplorationNoFileIsLeft) {
  const auto file = GrowingRecording::begin(pattern_, rollover(60.0)).value();
  now_ = 600.0;
  draft(*file);
  ASSERT_TRUE(file->drop_draft());
  ASSERT_TRUE(file->finish());
  EXPECT_EQ(file->files(), 0U);
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(RollingRecordingTest, BeginsAgainOnlyWhenAnotherFileIsDue) {
  const auto file = GrowingRecording::begin(pattern_, rollover(60.0)).value();
  EXPECT_FALSE(file->begin_again().value());
  now_ = 61.0;
  EXPECT_TRUE(file->begin_again().value());
}

// At each operation on files the disk may be full; another file is begun when it is due.
TEST_F(RollingRecordingTest, BeginsAgainAfterAnError) {
  std::size_t failed = 0;
  bool is_over = false;
  for (int operation = 0; !is_over; ++operation) {
    now_ = 0.0;
    FailingFileSystem files(operation, ENOSPC);
    files.flushes = false;
    const TemporaryFolder folder;
    auto begun = GrowingRecording::begin(files, folder.file("hand_{time}.mcap"), rollover(60.0));
    if (!begun) continue;
    const auto file = std::move(*begun);
    std::size_t added = 0;
    for (const Exploration& one : three_.explorations) {
      now_ += 61.0;
      if (file->add(one)) {
        ++added;
        continue;
      }
      ++failed;
      now_ += 61.0;
      EXPECT_TRUE(file->begin_again().value_or(false)) << operation;
      if (file->add(one)) ++added;
    }
    const bool was_hit = files.failed();
    EXPECT_TRUE(file->finish() || !was_hit) << operation;
    is_over = !files.failed();
    EXPECT_EQ(added, 3U) << operation;
    EXPECT_EQ(file->count(), added);
  }
  EXPECT_GT(failed, 10U);
}

}  // namespace
}  // namespace somato
