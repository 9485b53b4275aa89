#include <gtest/gtest.h>

#include <cerrno>
#include <memory>
#include <string>
#include <utility>

#include "base/support/failing_file_system.h"
#include "base/support/temporary_folder.h"
#include "views/live/reading_listener.h"
#include "views/live/sessions.h"
#include "views/live/view_session.h"
#include "views/replay/fake_explorer.h"

namespace somato {
namespace {

using testing::planned_source;
using testing::ReadingListener;
using testing::source_with_readings;

TEST(SessionLossesThread, ReadingsGoOnWhenTheDiskIsFull) {
  ReadingListener whole;
  ViewSession saved(
      source_with_readings(planned_source(std::make_unique<testing::FakeExplorer>()), whole),
      {false, kFastest});
  saved.start();
  ASSERT_TRUE(whole.wait());
  saved.stop();
  EXPECT_EQ(saved.losses(), Losses());

  const TemporaryFolder folder;
  testing::FailingFileSystem files(12, ENOSPC);
  const auto file = GrowingRecording::begin(files, folder.file("full.mcap")).value();
  ASSERT_FALSE(files.failed());
  ReadingListener listener;
  ViewSource source =
      source_with_readings(planned_source(std::make_unique<testing::FakeExplorer>()), listener);
  source.file = file.get();
  int errors = 0;
  source.readings.on_unsaved = [&](const Error& error) {
    ++errors;
    EXPECT_EQ(error.kind, ErrorKind::kSystem);
  };
  ViewSession session(std::move(source), {false, kFastest});
  session.start();
  ASSERT_TRUE(listener.wait());
  const nlohmann::json state = testing::state_of(session);
  session.stop();
  EXPECT_TRUE(files.failed());
  EXPECT_EQ(listener.said_, whole.said_);
  EXPECT_EQ(errors, 1) << "the error is reported once";
  EXPECT_GE(session.losses().unsaved, 1U);
  EXPECT_EQ(session.losses().unsaved + file->count(), 3U);
  EXPECT_EQ(state["losses"]["unsaved"], session.losses().unsaved);
}

// Its second trial fails.
class FailingOnce : public testing::FakeExplorer {
 protected:
  Result<Exploration> simulate(std::size_t thing, std::size_t trial,
                               const ExploreOptions& options) const override {
    if (trial == 1) return fail(ErrorKind::kData, "the hand is stuck");
    return FakeExplorer::simulate(thing, trial, options);
  }
};

TEST(SessionLossesThread, CountsExplorationsThatFailedAndViewersThatLeft) {
  ReadingListener listener;
  ViewSession session(
      source_with_readings(planned_source(std::make_unique<FailingOnce>()), listener),
      {false, kFastest});
  session.start();
  session.hub().subscribe(1).reset();
  ASSERT_TRUE(listener.wait());
  session.stop();
  EXPECT_EQ(session.losses(), (Losses{1, 0, 1}));
}

}  // namespace
}  // namespace somato
