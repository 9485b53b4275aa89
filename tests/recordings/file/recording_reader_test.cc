#include "somato/recording/recording_file.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/support/temporary_folder.h"
#include "recordings/file/recording_layout.h"
#include "recordings/mcap/mcap_compression.h"
#include "recordings/mcap/mcap_writer.h"
#include "recordings/support/made_recording.h"
#include "recordings/support/mcap_walk.h"

namespace somato {
namespace {

using Event = ExplorationMessage::Event;

// Puts a file together message by message, with mistakes.
class MadeFile {
 public:
  explicit MadeFile(const std::string& profile = "somato")
      : file_(
            [this](std::string_view bytes) -> Result<void> {
              bytes_ += bytes;
              return {};
            },
            Compression::kNone, 1 << 20) {
    (void)file_.begin({profile, "test"});
  }

  void say(Event event, std::uint64_t index = 0, std::vector<std::string> channels = {"touch"}) {
    ExplorationMessage message;
    message.event = event;
    message.index = index;
    message.channels = std::move(channels);
    say(exploration_json(message));
  }
  void say(const std::string& json) {
    const McapSchema schema = exploration_schema();
    (void)file_.add({file_.channel(&schema, exploration_channel()).value(), 0, 0, 0, json});
  }
  void frame(const std::string& name, std::size_t elements, std::uint64_t time,
             std::vector<std::size_t> shape = {}) {
    ChannelDescription description;
    description.name = name;
    description.shape = std::move(shape);
    frame(description, frame_message(description, time, std::vector<float>(elements)), time);
  }
  void frame(const ChannelDescription& description, const std::string& bytes, std::uint64_t time) {
    const McapSchema schema = schema_for(description);
    (void)file_.add(
        {file_.channel(&schema, channel_for(description)).value(), 0, time, time, bytes});
  }
  std::string whole() {
    (void)file_.finish();
    return bytes_;
  }

 private:
  std::string bytes_;
  McapWriter file_;
};

// The error for a file that `make` puts together.
Error refusal(const std::function<void(MadeFile&)>& make) {
  const TemporaryFolder folder;
  MadeFile file;
  make(file);
  const Result<Recording> read = read_recording(folder.with("a", file.whole()));
  EXPECT_FALSE(read);
  if (read) return {};
  EXPECT_EQ(read.error().kind, ErrorKind::kData);
  EXPECT_EQ(read.error().where.find(folder.file("a") + ":byte "), 0U) << read.error().where;
  EXPECT_NE(read.error().advice.find("somato recover"), std::string::npos);
  return read.error();
}

void expect_refused(const std::string& says, const std::function<void(MadeFile&)>& make) {
  const Error error = refusal(make);
  EXPECT_NE(error.what.find(says), std::string::npos) << error.what << "\n does not say " << says;
}

TEST(RecordingReader, RefusesExplorationsThatDoNotFollow) {
  expect_refused("outside all explorations", [](MadeFile& f) { f.frame("touch", 2, 1); });
  expect_refused("outside all explorations", [](MadeFile& f) {
    f.say(Event::kBegin);
    f.say(Event::kEnd);
    f.frame("touch", 2, 1);
  });
  expect_refused("exploration 1 has no end", [](MadeFile& f) { f.say(Event::kBegin); });
  expect_refused("exploration 2 begins before exploration 1 ends", [](MadeFile& f) {
    f.say(Event::kBegin);
    f.say(Event::kBegin, 1);
  });
  expect_refused("exploration 1 ends or continues, but has not begun",
                 [](MadeFile& f) { f.say(Event::kEnd); });
  expect_refused("exploration 8 ends or continues", [](MadeFile& f) {
    f.say(Event::kBegin);
    f.say(Event::kContinue, 7);
  });
}

TEST(RecordingReader, RefusesFramesThatDoNotFit) {
  expect_refused("has no channel 'skin'", [](MadeFile& f) {
    f.say(Event::kBegin);
    f.frame("skin", 2, 1);
  });
  expect_refused("has 3 elements", [](MadeFile& f) {
    f.say(Event::kBegin);
    f.frame("touch", 2, 1);
    f.frame("touch", 3, 2);
  });
  expect_refused("has 5 elements", [](MadeFile& f) {
    f.say(Event::kBegin);
    f.frame("touch", 5, 1, {2, 3});
  });
  expect_refused("decrease", [](MadeFile& f) {
    f.say(Event::kBegin);
    f.frame("touch", 2, 2);
    f.frame("touch", 2, 1);
  });
  expect_refused("two channels of the file", [](MadeFile& f) {
    f.say(Event::kBegin);
    f.frame("touch", 4, 1);
    f.frame("touch", 4, 2, {2, 2});
  });
  expect_refused("the time 18446744073709551615 ns", [](MadeFile& f) {
    f.say(Event::kBegin);
    f.frame("touch", 4, ~std::uint64_t{0});
  });
  ChannelDescription touch;
  touch.name = "touch";
  const std::string good = frame_message(touch, 0, std::vector<float>(3));
  for (std::size_t size = 0; size < good.size(); ++size) {
    expect_refused("a frame of 'touch': the", [&](MadeFile& f) {
      f.say(Event::kBegin);
      f.frame(touch, good.substr(0, size), 1);
    });
  }
}

TEST(RecordingReader, RefusesWhatMessagesOfExplorationsCannotSay) {
  const std::string begin =
      R"({"event":"begin","index":0,"labels":[],"source":"","channels":[],"zero":"0"})";
  const auto with = [&](const std::string& old_text, const std::string& new_text) {
    std::string json = begin;
    return json.replace(json.find(old_text), old_text.size(), new_text);
  };
  for (const std::string& json :
       {std::string(), std::string("{"), std::string("[]"), with("begin", "start"),
        with(":0,", ":-1,"), with(":0,", ":0.5,"), with("[]", "[1]"), with("\"0\"", "\"-1\""),
        with("\"0\"", "\"99999999999999999999\""), with("\"0\"", "\"\""), with("\"\",", "7,"),
        std::string(100'000, '['), begin + std::string(300'000, ' ')}) {
    SCOPED_TRACE(json.substr(0, 100));
    expect_refused("a message of /exploration", [&](MadeFile& f) { f.say(json); });
  }
  expect_refused("two channels", [](MadeFile& f) { f.say(Event::kBegin, 0, {"a", "a"}); });
}

// The error for the file after `spoil` changed its bytes.
std::string error_after(const std::function<void(std::string&)>& spoil) {
  const TemporaryFolder folder;
  RecordingFileParameters parameters;
  parameters.compression = Compression::kNone;
  (void)write_recording(folder.file("a"), testing::objects_apart(2, 2, 1.0, 1), parameters);
  std::string bytes = bytes_of(folder.file("a"));
  spoil(bytes);
  const Result<Recording> read = read_recording(folder.with("a", bytes));
  return read ? "nothing" : to_string(read.error());
}

// The place of the first chunk record in the file of error_after().
std::size_t chunk_place(const std::string& bytes) {
  return testing::walk(bytes, 8)[0].end;
}

TEST(RecordingReader, BelievesNoLengthAndNoSize) {
  const auto error_with = [](std::size_t offset, std::uint64_t number) {
    return error_after([&](std::string& bytes) {
      std::memcpy(&bytes[chunk_place(bytes) + offset], &number, sizeof number);
    });
  };
  constexpr std::size_t kLength = 1;
  constexpr std::size_t kUnpackedSize = 9 + 16;
  EXPECT_NE(error_with(kLength, ~0ULL).find("longer than the rest"), std::string::npos);
  EXPECT_NE(error_with(kLength, 5000000).find("longer than the rest"), std::string::npos);
  EXPECT_NE(error_with(kUnpackedSize, ~0ULL).find("more than 25165824"), std::string::npos);
  EXPECT_NE(error_with(kUnpackedSize, 25165824).find("its size differs from the declared size"),
            std::string::npos);
  EXPECT_NE(error_after([](std::string& bytes) {
              bytes[chunk_place(bytes) + 9 + 24] ^= 1;
            }).find("the checksum of a chunk does not match"),
            std::string::npos);
  EXPECT_NE(error_after([](std::string& bytes) { bytes += "more"; }).find("4 bytes follow"),
            std::string::npos);
  EXPECT_NE(error_after([](std::string& bytes) { bytes.resize(20); }).find(":byte 8: a record of"),
            std::string::npos);
  EXPECT_NE(error_after([](std::string& bytes) { bytes[8] = 0; }).find("kind 0x00"),
            std::string::npos);
}

TEST(RecordingReader, DecompressesNoMoreThanTheDeclaredSize) {
  const std::string large(5'000'000, 'x');
  for (const Compression compression : {Compression::kLz4, Compression::kZstd}) {
    const std::string packed = pack(compression, large).value();
    const std::string name(mcap_name(compression));
    EXPECT_EQ(unpack(name, packed, large.size()).value(), large);
    for (const std::size_t size : {std::size_t{0}, large.size() - 1, large.size() + 1}) {
      EXPECT_FALSE(unpack(name, packed, size)) << name << " " << size;
    }
    EXPECT_FALSE(unpack(name, packed + "x", large.size()));
    EXPECT_FALSE(unpack(name, packed.substr(0, packed.size() - 1), large.size()));
    EXPECT_FALSE(unpack(name, "", 1));
  }
  const Result<std::string> unknown = unpack("bz2", "x", 1);
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().what.find("bz2"), std::string::npos);
}

TEST(RecordingReader, GivesOneExplorationAfterTheOther) {
  const TemporaryFolder folder;
  const Recording recording = testing::objects_apart(2, 2, 1.0, 1);
  ASSERT_TRUE(write_recording(folder.file("a"), recording));
  auto reader = RecordingReader::open(folder.file("a")).value();
  for (const Exploration& exploration : recording.explorations) {
    EXPECT_TRUE(reader.next().value() == exploration);
  }
  EXPECT_FALSE(reader.next().value());
  EXPECT_FALSE(reader.next().value());
}

TEST(RecordingReader, RefusesWhatIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_recording(folder.file("missing")).error().kind, ErrorKind::kSystem);
  EXPECT_EQ(read_recording(folder.path()).error().kind, ErrorKind::kSystem);
  EXPECT_EQ(read_recording("/dev/zero").error().kind, ErrorKind::kUsage);
  EXPECT_EQ(read_recording(folder.with("a", "")).error().what, "not an MCAP file");
  EXPECT_EQ(read_recording(folder.with("b", "\x89MCAPx\r\n")).error().what, "not an MCAP file");
}

TEST(RecordingReader, RefusesNewerVersionsOfMcapAndOfRecordings) {
  const TemporaryFolder folder;
  const std::string advice = "; update Somato";
  const std::string mcap = folder.with("mcap", "\x89MCAP1\r\n");
  EXPECT_EQ(to_string(read_recording(mcap).error()),
            mcap + ": a file of version 1 of MCAP; version 0 is supported" + advice);
  const auto header = [](const std::string& profile) {
    return std::string(kMcapMagic) + mcap_record(McapHeader{profile, "somato"});
  };
  const std::string newer = folder.with("newer", header("somato 2"));
  EXPECT_EQ(to_string(read_recording(newer).error()),
            newer + ": written by a newer version of Somato (format 2, supported is 1)" + advice);
  for (const char* other : {"somatotopy 2", "somato two", "somato 1"}) {
    const auto read = read_recording(folder.with("other", header(other)));
    EXPECT_FALSE(read);
    EXPECT_EQ(read.error().what.find("newer version"), std::string::npos) << other;
  }
}

}  // namespace
}  // namespace somato
