#include "somato/recording/recording_file.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cmath>
#include <filesystem>

#include "base/files/file_system.h"
#include "base/files/whole_file.h"
#include "base/support/failing_file_system.h"
#include "base/support/temporary_folder.h"
#include "recordings/support/made_recording.h"
#include "recordings/support/random_recordings.h"

namespace somato {
namespace {

namespace fs = std::filesystem;
using testing::FailingFileSystem;
using testing::objects_apart;
using testing::random_recording;

constexpr Compression kAll[] = {Compression::kNone, Compression::kLz4, Compression::kZstd};

RecordingFileParameters packed(Compression compression, std::size_t chunk_size = 1 << 20) {
  RecordingFileParameters parameters;
  parameters.compression = compression;
  parameters.chunk_size = chunk_size;
  return parameters;
}

void expect_same(const Recording& read, const Recording& written) {
  ASSERT_EQ(read.explorations.size(), written.explorations.size());
  for (std::size_t i = 0; i < read.explorations.size(); ++i) {
    const Exploration& a = read.explorations[i];
    const Exploration& b = written.explorations[i];
    EXPECT_EQ(a.labels, b.labels);
    EXPECT_EQ(a.source, b.source);
    ASSERT_EQ(a.channels.size(), b.channels.size());
    for (std::size_t c = 0; c < a.channels.size(); ++c) {
      EXPECT_EQ(a.channels[c].name, b.channels[c].name);
      EXPECT_EQ(a.channels[c].unit, b.channels[c].unit);
      EXPECT_EQ(a.channels[c].times, b.channels[c].times);
      EXPECT_EQ(a.channels[c].rate, b.channels[c].rate);
      EXPECT_EQ(a.channels[c].shape, b.channels[c].shape);
      EXPECT_EQ(a.channels[c].element_names, b.channels[c].element_names);
      EXPECT_TRUE(a.channels[c].frames == b.channels[c].frames);
      EXPECT_TRUE(a.channels[c].valid == b.channels[c].valid);
    }
  }
  EXPECT_TRUE(read == written);
}

TEST(RecordingFile, OneExplorationAtATimeGivesTheSameFile) {
  const TemporaryFolder folder;
  Random random(4);
  const Recording recording = random_recording(random);
  ASSERT_TRUE(write_recording(folder.file("whole.mcap"), recording));
  auto file = RecordingFile::begin(folder.file("pieces.mcap"));
  ASSERT_TRUE(file);
  for (const Exploration& exploration : recording.explorations) {
    ASSERT_TRUE(file->add(exploration));
    EXPECT_FALSE(fs::exists(folder.file("pieces.mcap")));
  }
  ASSERT_TRUE(file->finish());
  EXPECT_TRUE(*read_whole(folder.file("pieces.mcap")) == *read_whole(folder.file("whole.mcap")));
}

TEST(RecordingFile, WithoutItsEndNothingChanges) {
  const TemporaryFolder folder;
  const std::string path = folder.with("a.mcap", "as it was");
  Random random(4);
  {
    auto file = RecordingFile::begin(path);
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->add(random_recording(random).explorations.front()));
  }
  EXPECT_EQ(*read_whole(path), "as it was");
  EXPECT_EQ(folder.count(), 1);
}

TEST(RecordingFile, RefusesAnExplorationThatIsNone) {
  const TemporaryFolder folder;
  auto file = RecordingFile::begin(folder.file("a.mcap"));
  ASSERT_TRUE(file);
  const auto refused = file->add(Exploration{});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
}

TEST(RecordingFile, ReadsWhatItWrote) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.mcap");
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Recording recording = random_recording(random);
    ASSERT_TRUE(validate(recording)) << to_string(validate(recording).error());
    for (const Compression compression : kAll) {
      const std::size_t chunk_size = std::size_t{1} << (2 * random.below(11));
      const Result<void> written =
          write_recording(path, recording, packed(compression, chunk_size));
      ASSERT_TRUE(written) << to_string(written.error());
      const Result<Recording> read = read_recording(path);
      ASSERT_TRUE(read) << to_string(read.error());
      expect_same(*read, recording);
    }
    if (HasFailure()) break;
  }
}

TEST(RecordingFile, KeepsTheSignOfZero) {
  const TemporaryFolder folder;
  Recording recording = objects_apart(1, 1, 1.0, 1);
  recording.explorations[0].channels[0].frames(0, 0) = -0.0F;
  ASSERT_TRUE(write_recording(folder.file("a"), recording));
  EXPECT_TRUE(
      std::signbit(read_recording(folder.file("a"))->explorations[0].channels[0].frames(0, 0)));
}

TEST(RecordingFile, IsKnownByItsFirstBytes) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_recording(folder.file("a"), objects_apart(2, 2, 1.0, 1)));
  EXPECT_TRUE(is_mcap_file(folder.file("a")));
  EXPECT_TRUE(is_mcap(bytes_of(folder.file("a")).substr(0, 8)));
  EXPECT_FALSE(is_mcap(bytes_of(folder.file("a")).substr(0, 7)));
  EXPECT_FALSE(is_mcap_file(folder.with("b", "a,b\n1,2\n")));
  EXPECT_FALSE(is_mcap_file(folder.with("c", "")));
  EXPECT_FALSE(is_mcap_file(folder.path()));
  EXPECT_FALSE(is_mcap_file(folder.file("missing")));
}

TEST(RecordingFile, IsTheOldOneOrTheNewOneWhateverFails) {
  const Recording old_recording = objects_apart(1, 1, 1.0, 1);
  const Recording new_recording = objects_apart(3, 4, 1.0, 2);
  int failing = 0;
  for (bool failed = true; failed; ++failing) {
    SCOPED_TRACE(failing);
    const TemporaryFolder folder;
    const std::string path = folder.file("a.mcap");
    ASSERT_TRUE(write_recording(path, old_recording));
    FailingFileSystem files(failing, ENOSPC);
    const Result<void> written =
        detail::write_recording(files, path, new_recording, packed(Compression::kNone, 500));
    failed = files.failed();
    EXPECT_EQ(files.opened(), 0);
    EXPECT_EQ(folder.count(), 1);
    const Result<Recording> read = read_recording(path);
    ASSERT_TRUE(read);
    EXPECT_TRUE(*read == old_recording || *read == new_recording);
    EXPECT_TRUE(!written || *read == new_recording);
    EXPECT_TRUE(written || written.error().kind == ErrorKind::kSystem);
  }
  EXPECT_GT(failing, 12);
}

TEST(RecordingFile, RefusesWhatIsNoRecording) {
  const TemporaryFolder folder;
  Recording recording = objects_apart(2, 1, 1.0, 1);
  recording.explorations[1].channels[0].unit = "rad";
  EXPECT_EQ(write_recording(folder.file("a"), recording).error().kind, ErrorKind::kData);
  EXPECT_EQ(write_recording(folder.file("a"), {}).error().kind, ErrorKind::kData);
  EXPECT_EQ(folder.count(), 0);
}

TEST(RecordingFile, RefusesTextsThatReadersWouldNotTake) {
  const TemporaryFolder folder;
  Recording recording = objects_apart(1, 1, 1.0, 1);
  recording.explorations[0].labels[0].value = "\xFF";
  const Result<void> no_text = write_recording(folder.file("a"), recording);
  ASSERT_FALSE(no_text);
  EXPECT_NE(no_text.error().what.find("not UTF-8"), std::string::npos);
  recording.explorations[0].labels[0].value = std::string(300'000, 'x');
  const Result<void> too_long = write_recording(folder.file("a"), recording);
  ASSERT_FALSE(too_long);
  EXPECT_NE(too_long.error().what.find("too long"), std::string::npos);
  EXPECT_EQ(folder.count(), 0);
}

}  // namespace
}  // namespace somato
