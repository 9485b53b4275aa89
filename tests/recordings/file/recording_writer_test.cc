#include "somato/recording/recording_writer.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <thread>
#include <utility>

#include "base/files/open_file.h"
#include "base/support/eventually.h"
#include "base/support/failing_file_system.h"
#include "base/support/temporary_folder.h"
#include "somato/core/random.h"
#include "somato/recording/recording_file.h"
#include "somato/recording/recover_recording.h"

namespace somato {
namespace {

namespace fs = std::filesystem;
using testing::FailingFileSystem;

RecordingFileParameters packed_writer(Compression compression, std::size_t chunk_size = 1 << 20,
                                      double flush_after = 3600.0) {
  return {compression, chunk_size, flush_after};
}

ExplorationStart start_of_two() {
  ExplorationStart start;
  start.labels = {{"object", "ball"}};
  start.source = "live";
  start.channels.resize(2);
  start.channels[0].name = "joints";
  start.channels[0].unit = "deg";
  start.channels[1].name = "touch";
  start.channels[1].shape = {2, 2};
  return start;
}

TEST(RecordingWriter, WritesFramesOfChannelsAsTheyCome) {
  const TemporaryFolder folder;
  auto writer = RecordingWriter::create(folder.file("a")).value();
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(writer.begin_exploration(start_of_two()));
    ASSERT_TRUE(writer.frame(1, std::vector<float>{1, 2, 3, 4}, 0.2));
    ASSERT_TRUE(writer.frame(0, std::vector<float>{90}, 0.1));  // Before: another sensor's clock.
    ASSERT_TRUE(writer.frame(1, std::vector<float>{5, 6, 7, 8}, 0.3,
                             std::vector<std::uint8_t>{1, 0, 1, 1}));
    ASSERT_TRUE(writer.frame(0, std::vector<float>{std::nanf("")}, 0.4));
    ASSERT_TRUE(writer.end_exploration());
  }
  ASSERT_TRUE(writer.close());
  const Recording read = read_recording(folder.file("a")).value();
  const Channel joints{"joints",   "deg", {}, Matrix<float>(2, 1, {90, 0}),
                       {0.1, 0.4}, 0.0,   {}, Matrix<std::uint8_t>(2, 1, {1, 0})};
  const Channel touch{
      "touch",    "",  {},     Matrix<float>(2, 4, {1, 2, 3, 4, 5, 0, 7, 8}),
      {0.2, 0.3}, 0.0, {2, 2}, Matrix<std::uint8_t>(2, 4, {1, 1, 1, 1, 1, 0, 1, 1})};
  const Exploration one{{{"object", "ball"}}, "live", {joints, touch}};
  EXPECT_TRUE(read == (Recording{{one, one}}));
}

TEST(RecordingWriter, KeepsExplorationsWithoutFrames) {
  const TemporaryFolder folder;
  auto writer = RecordingWriter::create(folder.file("a")).value();
  for (int i = 0; i < 10'000; ++i) {
    ASSERT_TRUE(writer.begin_exploration(start_of_two()));
    ASSERT_TRUE(writer.end_exploration());
  }
  ASSERT_TRUE(writer.close());
  const Recording read = read_recording(folder.file("a")).value();
  ASSERT_EQ(read.explorations.size(), 10'000U);
  EXPECT_EQ(read.explorations[9'999].channels[1].shape, (std::vector<std::size_t>{2, 2}));
  EXPECT_TRUE(read.explorations[9'999].channels[1].frames.empty());
  EXPECT_FALSE(validate(read));
}

TEST(RecordingWriter, RefusesTimesThatRunBackwardsOrTooFar) {
  const TemporaryFolder folder;
  auto writer = RecordingWriter::create(folder.file("a")).value();
  ASSERT_TRUE(writer.begin_exploration(start_of_two()));
  const std::vector<float> value{1};
  ASSERT_TRUE(writer.frame(0, value, 0.2));
  for (const double time :
       {0.1, -1.0, 1e10, std::nan(""), -std::numeric_limits<double>::infinity()}) {
    const Result<void> refused = writer.frame(0, value, time);
    ASSERT_FALSE(refused) << time;
    EXPECT_EQ(refused.error().kind, ErrorKind::kData);
  }
  EXPECT_TRUE(writer.frame(0, value, 0.2));
}

TEST(RecordingWriter, ThrowsAtMistakesOfTheCaller) {
  const TemporaryFolder folder;
  auto writer = RecordingWriter::create(folder.file("a")).value();
  const std::vector<float> one{1};
  EXPECT_THROW((void)writer.frame(0, one, 0.0), InvalidArgument);
  EXPECT_THROW((void)writer.end_exploration(), InvalidArgument);
  ASSERT_TRUE(writer.begin_exploration(start_of_two()));
  EXPECT_THROW((void)writer.begin_exploration(start_of_two()), InvalidArgument);
  EXPECT_THROW((void)writer.close(), InvalidArgument);
  EXPECT_THROW((void)writer.frame(2, one, 0.0), InvalidArgument);
  EXPECT_THROW((void)writer.frame(1, one, 0.0), InvalidArgument) << "the shape says four";
  EXPECT_THROW((void)writer.frame(0, {}, 0.0), InvalidArgument);
  EXPECT_THROW((void)writer.frame(0, one, 0.0, std::vector<std::uint8_t>{1, 1}), InvalidArgument);
  ASSERT_TRUE(writer.frame(0, one, 0.0));
  EXPECT_THROW((void)writer.frame(0, std::vector<float>{1, 2}, 0.0), InvalidArgument);
  ASSERT_TRUE(writer.end_exploration());
  ASSERT_TRUE(writer.close());
  EXPECT_THROW((void)writer.close(), InvalidArgument);
  EXPECT_THROW((void)writer.label(0, {"object", "cup"}), InvalidArgument);
  constexpr std::size_t kLargest = 4U << 20U;
  for (const std::size_t chunk_size : {std::size_t{0}, kLargest + 1}) {
    EXPECT_THROW((void)RecordingWriter::create(folder.file("b"),
                                               packed_writer(Compression::kNone, chunk_size)),
                 InvalidArgument)
        << chunk_size;
  }
  auto open = OpenFile::open(operating_system(), folder.file("c"), Opening::kCreate);
  EXPECT_THROW((void)RecordingWriter::write_into(std::move(*open), folder.file("c"),
                                                 packed_writer(Compression::kNone, 0)),
               InvalidArgument);
  EXPECT_TRUE(
      RecordingWriter::create(folder.file("b"), packed_writer(Compression::kNone, kLargest)));
}

TEST(RecordingWriter, DoesNotTouchAFileThatIsThere) {
  const TemporaryFolder folder;
  const auto refused = RecordingWriter::create(folder.with("a", "precious"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kSystem);
  EXPECT_EQ(bytes_of(folder.file("a")), "precious");
}

// Records frames 0, 1, 2, ... until a failure; returns their number.
std::size_t record(RecordingWriter& writer, std::size_t count, Result<void>& done) {
  std::size_t taken = 0;
  done = writer.begin_exploration(start_of_two());
  for (std::size_t i = 0; done && i < count; ++i) {
    const auto value = static_cast<float>(i);
    done = writer.frame(1, std::vector<float>(4, value), 0.01 * value);
    taken += done ? 1 : 0;
  }
  if (done) done = writer.end_exploration();
  if (done) done = writer.close();
  return taken;
}

// The saved frames are the first ones; how many.
std::size_t saved_frames(const std::string& path, const std::string& out) {
  const Result<RecoveryReport> report = recover_recording(path, out);
  if (!report) return 0;
  const Recording saved = read_recording(out).value();
  if (saved.explorations.empty()) return 0;
  EXPECT_EQ(saved.explorations.size(), 1U);
  const Matrix<float>& frames = saved.explorations[0].channels[1].frames;
  for (std::size_t i = 0; i < frames.rows(); ++i) EXPECT_EQ(frames(i, 3), static_cast<float>(i));
  return frames.rows();
}

TEST(RecordingWriter, ReturnsWhatFailsAndLeavesWhatCanBeSaved) {
  constexpr std::size_t kFrames = 150;
  for (const Compression compression :
       {Compression::kNone, Compression::kLz4, Compression::kZstd}) {
    std::size_t most = 0;
    for (int failing = 0;; ++failing) {
      SCOPED_TRACE(failing);
      const TemporaryFolder folder;
      FailingFileSystem files(failing, ENOSPC);
      Result<void> done;
      std::size_t taken = 0;
      {
        auto writer =
            RecordingWriter::create(files, folder.file("a"), packed_writer(compression, 2600));
        if (!writer) {
          EXPECT_EQ(writer.error().kind, ErrorKind::kSystem);
          continue;
        }
        taken = record(*writer, kFrames, done);
        if (!done && taken < kFrames) {
          const Result<void> again = writer->frame(1, std::vector<float>(4), 1e6);
          ASSERT_FALSE(again) << "nothing may follow a failure";
          EXPECT_EQ(again.error().what, done.error().what);
        }
      }
      EXPECT_EQ(files.opened(), 0);
      EXPECT_EQ(done.has_value(), !files.failed());
      const std::size_t saved = saved_frames(folder.file("a"), folder.file("b"));
      EXPECT_GE(saved, most) << "less than when an earlier write failed";
      EXPECT_LE(saved, taken + 1);
      most = saved;
      if (!files.failed()) break;
      EXPECT_EQ(done.error().kind, ErrorKind::kSystem);
      EXPECT_EQ(done.error().where, folder.file("a"));
    }
    EXPECT_EQ(most, kFrames);
  }
}

TEST(RecordingWriterThread, WritesOutWhatIsOldWithoutACall) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  auto writer =
      RecordingWriter::create(path, packed_writer(Compression::kZstd, 1 << 20, 0.01)).value();
  ASSERT_TRUE(writer.begin_exploration(start_of_two()));
  ASSERT_TRUE(writer.frame(1, std::vector<float>(4, 0.0F), 0.0));
  EXPECT_TRUE(testing::eventually([&] { return saved_frames(path, folder.file("b")) == 1; }));
}

TEST(RecordingWriterThread, TakesFramesFromSeveralThreads) {
  constexpr std::size_t kFrames = 400;
  const TemporaryFolder folder;
  auto writer =
      RecordingWriter::create(folder.file("a"), packed_writer(Compression::kLz4, 3000, 0.001))
          .value();
  ASSERT_TRUE(writer.begin_exploration(start_of_two()));
  const auto feed = [&](std::size_t channel, std::size_t elements) {
    for (std::size_t i = 0; i < kFrames; ++i) {
      const auto value = static_cast<float>(i);
      EXPECT_TRUE(writer.frame(channel, std::vector<float>(elements, value), 0.001 * value));
    }
  };
  std::thread joints(feed, 0, 3);
  std::thread touch(feed, 1, 4);
  joints.join();
  touch.join();
  ASSERT_TRUE(writer.end_exploration());
  ASSERT_TRUE(writer.close());
  const Recording read = read_recording(folder.file("a")).value();
  for (const Channel& channel : read.explorations.at(0).channels) {
    ASSERT_EQ(channel.frames.rows(), kFrames);
    EXPECT_EQ(channel.frames(kFrames - 1, 2), static_cast<float>(kFrames - 1));
  }
}

using Clock = std::chrono::steady_clock;

// Records without end and reports the time of each frame through `pipe`.
[[noreturn]] void record_for_ever(const std::string& path, Compression compression, int pipe) {
  auto writer = RecordingWriter::create(path, packed_writer(compression, 1 << 20, 0.5));
  if (!writer || !writer->begin_exploration(start_of_two())) ::_exit(1);
  for (std::size_t i = 0;; ++i) {
    if (!writer->frame(1, std::vector<float>(4, static_cast<float>(i)),
                       0.001 * static_cast<double>(i)))
      ::_exit(1);
    const Clock::time_point now = Clock::now();
    if (::write(pipe, &now, sizeof now) != sizeof now) ::_exit(1);
    ::usleep(2'000);
  }
}

struct Recorder {
  pid_t process = 0;
  int pipe = -1;
  std::string path;
  Clock::time_point killed;
};

Recorder start_recorder(const std::string& path, Compression compression) {
  int ends[2] = {};
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) record_for_ever(path, compression, ends[1]);
  ::close(ends[1]);
  return {child, ends[0], path, {}};
}

// How many frames were taken more than a second before the end.
std::size_t frames_to_be_saved(const Recorder& recorder) {
  std::size_t count = 0;
  Clock::time_point taken;
  while (::read(recorder.pipe, &taken, sizeof taken) == sizeof taken) {
    count += taken < recorder.killed - std::chrono::seconds(1) ? 1 : 0;
  }
  ::close(recorder.pipe);
  return count;
}

TEST(RecordingWriter, LosesNoMoreThanTheLastSecondWhenKilled) {
  constexpr int kAtOnce = 20;
  const TemporaryFolder folder;
  Random random(1);
  std::size_t most = 0;
  for (int round = 0; round < 100 / kAtOnce; ++round) {
    std::vector<Recorder> recorders;
    for (int i = 0; i < kAtOnce; ++i) {
      recorders.push_back(start_recorder(folder.file(std::to_string(round * kAtOnce + i)),
                                         i % 2 == 0 ? Compression::kNone : Compression::kZstd));
    }
    ::usleep(1'000'000);
    for (Recorder& recorder : recorders) {
      ::usleep(static_cast<useconds_t>(random.below(100'000)));
      recorder.killed = Clock::now();
      ASSERT_EQ(::kill(recorder.process, SIGKILL), 0);
      int status = 0;
      ASSERT_EQ(::waitpid(recorder.process, &status, 0), recorder.process);
      ASSERT_TRUE(WIFSIGNALED(status)) << "the child stopped recording by itself";
    }
    for (const Recorder& recorder : recorders) {
      const std::size_t expected = frames_to_be_saved(recorder);
      EXPECT_GE(saved_frames(recorder.path, folder.file("out")), expected);
      most = std::max(most, expected);
    }
  }
  EXPECT_GT(most, 50U) << "no child lived for more than a second";
}

}  // namespace
}  // namespace somato
