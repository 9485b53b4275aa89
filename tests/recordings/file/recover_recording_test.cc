#include "somato/recording/recover_recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>

#include "base/support/failing_file_system.h"
#include "base/support/sanitized.h"
#include "base/support/temporary_folder.h"
#include "recordings/file/recording_layout.h"
#include "recordings/support/made_recording.h"
#include "recordings/support/mcap_walk.h"
#include "recordings/support/random_recordings.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

namespace fs = std::filesystem;
using testing::FailingFileSystem;
using testing::WalkedMessage;
using testing::WalkedRecord;

constexpr int kNever = 1 << 30;
constexpr Compression kAllCompressions[] = {Compression::kNone, Compression::kLz4,
                                            Compression::kZstd};

RecordingFileParameters packed_in_chunks(Compression compression, std::size_t chunk_size) {
  RecordingFileParameters parameters;
  parameters.compression = compression;
  parameters.chunk_size = chunk_size;
  return parameters;
}

// Two explorations of two channels, one with a mask, the other with other numbers of frames.
Recording small_recording() {
  Recording recording;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto number = static_cast<float>(i);
    Channel joints{"joints",
                   "deg",
                   {"a", "b"},
                   Matrix<float>(3, 2, {1, 2, 3, 4, 5, number}),
                   {0.25, 0.5, 0.75}};
    Channel touch{"touch", "counts", {}, Matrix<float>(2 + i, 3, number), {}, 10.0};
    touch.valid = Matrix<std::uint8_t>(2 + i, 3, 1);
    touch.valid(1, 2) = 0;
    touch.frames(1, 2) = 0.0F;
    recording.explorations.push_back(
        {{{"object", "cup " + std::to_string(i)}}, "made", {joints, touch}});
  }
  return recording;
}

bool is_control(const WalkedMessage& message) {
  return message.topic == "/exploration";
}

bool says(const WalkedMessage& message, const std::string& event) {
  return is_control(message) && message.data.find("\"event\":\"" + event) != std::string::npos;
}

// The first frames of a channel.
Channel first_frames(const Channel& channel, std::size_t count) {
  Channel first = channel;
  first.frames = {};
  first.valid = {};
  if (!channel.times.empty()) first.times.resize(count);
  if (count == 0) return first;
  const std::size_t columns = channel.frames.columns();
  const auto cut = [&](const auto& values) {
    return std::vector(values.begin(),
                       values.begin() + static_cast<std::ptrdiff_t>(count * columns));
  };
  first.frames = Matrix<float>(count, columns, cut(channel.frames.values()));
  if (channel.valid.empty()) return first;
  const std::vector<std::uint8_t> valid = cut(channel.valid.values());
  if (std::count(valid.begin(), valid.end(), 0) > 0) {
    first.valid = Matrix<std::uint8_t>(count, columns, valid);
  }
  return first;
}

// The content of the messages of `whole`, in order and without gaps.
Recording described_by(const std::vector<WalkedMessage>& messages, const Recording& whole) {
  Recording described;
  std::map<std::string, std::size_t> frames;
  const auto take = [&] {
    if (described.explorations.empty()) return;
    for (Channel& channel : described.explorations.back().channels) {
      channel = first_frames(channel, frames[topic_of(channel.name)]);
    }
    frames.clear();
  };
  for (const WalkedMessage& message : messages) {
    if (!is_control(message)) ++frames[message.topic];
    if (!says(message, "begin")) continue;
    take();
    described.explorations.push_back(whole.explorations[described.explorations.size()]);
  }
  take();
  return described;
}

void expect_cut_file_saved(const std::string& whole, std::size_t size, const Recording& recording,
                           const TemporaryFolder& folder) {
  SCOPED_TRACE("cut to " + std::to_string(size));
  std::vector<WalkedMessage> messages = testing::walk_messages(whole);
  std::erase_if(messages, [&](const WalkedMessage& message) { return message.needs > size; });
  const std::size_t frames = static_cast<std::size_t>(
      std::count_if(messages.begin(), messages.end(), std::not_fn(is_control)));
  const bool has_all = [&] {
    for (const WalkedRecord& record : testing::walk(std::string_view(whole).substr(0, size), 8)) {
      if (record.opcode == 15) return true;
    }
    return false;
  }();
  FailingFileSystem files(kNever);
  files.flushes = false;
  const std::string out = folder.file("out");
  fs::remove(out);
  const Result<RecoveryReport> report = detail::recover_recording(
      files, folder.file("cut"), out, packed_in_chunks(Compression::kNone, 1000));
  if (frames == 0) {
    EXPECT_FALSE(report);
    EXPECT_FALSE(fs::exists(out));
    return;
  }
  ASSERT_TRUE(report) << to_string(report.error());
  EXPECT_EQ(report->messages, frames);
  EXPECT_EQ(report->lossless, has_all);
  EXPECT_EQ(report->damage.empty(), size == whole.size());
  EXPECT_EQ(
      report->incomplete,
      std::count_if(messages.begin(), messages.end(), [](auto& m) { return says(m, "begin"); }) -
          std::count_if(messages.begin(), messages.end(), [](auto& m) { return says(m, "end"); }));
  const Result<Recording> read = read_recording(out);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_TRUE(*read == described_by(messages, recording));
}

// Every third place of a plain file is damaged. A compressed chunk is read whole or not at all, and
// sanitizers take long: some places serve.
std::size_t step_of([[maybe_unused]] Compression compression) {
#ifdef SOMATO_TESTS_SANITIZED
  return 23;
#else
  return compression == Compression::kNone ? 3 : 11;
#endif
}

TEST(RecoverRecording, SavesAllThatIsCompleteWhereverTheFileIsCut) {
  const Recording recording = small_recording();
  for (const Compression compression : kAllCompressions) {
    for (const std::size_t chunk_size : {2400U, 100000U}) {
      const TemporaryFolder folder;
      const std::string path = folder.file("cut");
      ASSERT_TRUE(write_recording(path, recording, packed_in_chunks(compression, chunk_size)));
      const std::string whole = bytes_of(path);
      const std::size_t step = step_of(compression);
      for (std::size_t size = whole.size() + 1; size-- > 0;) {
        if (size % step != 0 && size != whole.size()) continue;
        fs::resize_file(path, size);
        expect_cut_file_saved(whole, size, recording, folder);
        if (HasFailure()) return;
      }
    }
  }
}

void turn(std::fstream& file, const std::string& bytes, std::size_t bit) {
  const auto place = static_cast<std::streamoff>(bit / 8);
  file.seekp(place).put(static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8))).flush();
}

// Whether all of a frame's channel values are those of the recording, so that nothing is made up.
bool holds_only_frames_of(const Recording& saved, const Recording& whole) {
  for (const Exploration& exploration : saved.explorations) {
    const auto same =
        std::find_if(whole.explorations.begin(), whole.explorations.end(),
                     [&](const Exploration& other) { return other.labels == exploration.labels; });
    if (same == whole.explorations.end()) return false;
    for (const Channel& channel : exploration.channels) {
      const auto original = find_channel(*same, channel.name);
      if (!original || channel.frames.rows() > (*original)->frames.rows()) return false;
    }
  }
  return true;
}

TEST(RecoverRecording, BitsThatTurnAreFoundOrDoNotMatter) {
  Recording recording = small_recording();
  recording.explorations.pop_back();
  for (const Compression compression : kAllCompressions) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a");
    ASSERT_TRUE(write_recording(path, recording, packed_in_chunks(compression, 1 << 20)));
    const std::string whole = bytes_of(path);
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    FailingFileSystem files(kNever);
    files.flushes = false;
    std::size_t found = 0;
    const std::size_t step = step_of(compression);
    for (std::size_t bit = 0; bit < 8 * whole.size(); bit += step) {
      SCOPED_TRACE("bit " + std::to_string(bit));
      turn(file, whole, bit);
      const Result<Recording> read = read_recording(path);
      found += read ? 0 : 1;
      EXPECT_TRUE(!read || *read == recording);
      if (bit / step % 7 == 0) {
        const auto report = detail::recover_recording(files, path, folder.file("out"),
                                                      packed_in_chunks(Compression::kNone, 1000));
        if (report) {
          const Result<Recording> saved = read_recording(folder.file("out"));
          ASSERT_TRUE(saved) << to_string(saved.error());
          EXPECT_TRUE(holds_only_frames_of(*saved, recording));
          EXPECT_TRUE(!report->lossless || !saved || *saved == recording);
        }
      }
      file.seekp(static_cast<std::streamoff>(bit / 8)).put(whole[bit / 8]).flush();
      if (HasFailure()) return;
    }
    EXPECT_GT(found * step, 7 * whole.size());
  }
}

// Six explorations of one value each, packed in several chunks.
Recording six_things() {
  Recording recording;
  for (std::size_t i = 0; i < 6; ++i) {
    Exploration exploration = testing::exploration_of("thing " + std::to_string(i), {1, 2});
    exploration.channels[0].frames = Matrix<float>(40, 2, static_cast<float>(i));
    recording.explorations.push_back(exploration);
  }
  return recording;
}

std::vector<WalkedRecord> chunks_of(const std::string& file) {
  std::vector<WalkedRecord> chunks = testing::walk(file, 8);
  std::erase_if(chunks, [](const WalkedRecord& record) { return record.opcode != 6; });
  return chunks;
}

// Many chunks, one of them damaged: the explorations behind it are saved with their own labels.
TEST(RecoverRecording, SavesWhatStandsBehindADamagedChunk) {
  const TemporaryFolder folder;
  const Recording recording = six_things();
  for (const Compression compression : kAllCompressions) {
    const std::string path = folder.file("a");
    ASSERT_TRUE(write_recording(path, recording, packed_in_chunks(compression, 3000)));
    const std::string whole = bytes_of(path);
    const std::vector<WalkedRecord> chunks = chunks_of(whole);
    ASSERT_GE(chunks.size(), 5U);
    for (const std::size_t back : {1U, 45U}) {  // In the data, and in the checksum or compression.
      std::string damaged = whole;
      const WalkedRecord& third = chunks[2];
      damaged[back == 1 ? third.end - 20 : third.end - third.content.size() + 24] ^= 1;
      folder.with("a", damaged);
      EXPECT_FALSE(read_recording(path));
      const Result<RecoveryReport> report = recover_recording(path, folder.file("b"));
      ASSERT_TRUE(report);
      EXPECT_FALSE(report->lossless);
      EXPECT_GE(report->incomplete, 1U);
      const Result<Recording> saved = read_recording(folder.file("b"));
      ASSERT_TRUE(saved) << to_string(saved.error());
      std::size_t frames = 0;
      for (const Exploration& exploration : saved->explorations) {
        const auto value = static_cast<float>(exploration.labels[0].value.back() - '0');
        for (const float read : exploration.channels[0].frames.values()) EXPECT_EQ(read, value);
        frames += exploration.channels[0].frames.rows();
      }
      EXPECT_EQ(saved->explorations.back(), recording.explorations.back());
      std::size_t lost = 0;
      for (const WalkedMessage& message : testing::walk_messages(whole)) {
        lost += !is_control(message) && message.needs > chunks[1].end && message.needs <= third.end;
      }
      EXPECT_EQ(frames, 240 - lost);
    }
  }
}

// The next chunk begins one byte behind the place where the reader stumbles.
TEST(RecoverRecording, LosesNothingByOneByteTooManyBetweenChunks) {
  const TemporaryFolder folder;
  const Recording recording = six_things();
  for (const Compression compression : kAllCompressions) {
    const std::string path = folder.file("a");
    ASSERT_TRUE(write_recording(path, recording, packed_in_chunks(compression, 3000)));
    const std::string whole = bytes_of(path);
    const std::vector<WalkedRecord> chunks = chunks_of(whole);
    const WalkedRecord& fourth = chunks.at(3);
    std::string damaged = whole;
    damaged.insert(fourth.end - fourth.content.size() - 9, 1, '\0');
    folder.with("a", damaged);
    EXPECT_FALSE(read_recording(path));
    ASSERT_TRUE(recover_recording(path, folder.file("b")));
    const Result<Recording> saved = read_recording(folder.file("b"));
    ASSERT_TRUE(saved) << to_string(saved.error());
    std::size_t frames = 0;
    for (const Exploration& exploration : saved->explorations) {
      frames += exploration.channels[0].frames.rows();
    }
    EXPECT_EQ(frames, 240U);
  }
}

TEST(RecoverRecording, LeavesTheOldFileWhateverFails) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_recording(folder.file("a"), small_recording(),
                              packed_in_chunks(Compression::kNone, 500)));
  for (int failing = 0;; ++failing) {
    folder.with("b", "old");
    FailingFileSystem files(failing, ENOSPC);
    files.flushes = false;
    const auto report = detail::recover_recording(files, folder.file("a"), folder.file("b"),
                                                  packed_in_chunks(Compression::kNone, 500));
    EXPECT_EQ(folder.count(), 2);
    if (!files.failed()) break;
    const std::string bytes = bytes_of(folder.file("b"));
    EXPECT_TRUE(bytes == "old" || read_recording(folder.file("b")));
    EXPECT_TRUE(report || report.error().kind == ErrorKind::kSystem);
    EXPECT_EQ(files.opened(), 0);
  }
}

TEST(RecoverRecording, RefusesWhatIsNoRecording) {
  const TemporaryFolder folder;
  const auto refused = recover_recording(folder.with("a", "1,2\n"), folder.file("b"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what, "not an MCAP file");
  EXPECT_EQ(recover_recording(folder.file("none"), folder.file("b")).error().kind,
            ErrorKind::kSystem);
  EXPECT_EQ(folder.count(), 1);
}

}  // namespace
}  // namespace somato
