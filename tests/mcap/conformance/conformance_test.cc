#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "base/support/places.h"
#include "base/support/run_program.h"
#include "base/support/temporary_folder.h"
#include "recordings/file/recording_layout.h"
#include "recordings/support/random_recordings.h"
#include "somato/recording/inspect_recording.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

using Json = nlohmann::json;

std::string run_script(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), SOMATO_NODE);
  arguments[1] = build_path("tests/mcap/npm/" + arguments[1]);
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return run.out;
}

// The content of the file, as the official reader sees it, must equal the recording.
void expect_frames(const Channel& channel, const std::vector<Json>& messages) {
  ASSERT_EQ(messages.size(), channel.frames.rows());
  const bool joints = channel.name == "joints";
  const double unit = joints && channel.unit == "deg" ? 180.0 / std::numbers::pi : 1.0;
  for (std::size_t f = 0; f < messages.size(); ++f) {
    const Json& message = messages[f];
    EXPECT_EQ(message["schema"],
              joints ? "sensor_msgs/msg/JointState" : "std_msgs/msg/Float32MultiArray");
    const Json& values = message["value"]["values"];
    ASSERT_EQ(values.size(), channel.frames.columns());
    for (std::size_t e = 0; e < values.size(); ++e) {
      const bool valid = channel.valid.empty() || channel.valid(f, e) == 1;
      ASSERT_EQ(values[e].is_null(), !valid);
      if (!valid) continue;
      EXPECT_EQ(static_cast<float>(values[e].get<double>() * unit), channel.frames(f, e));
    }
    if (joints && !channel.element_names.empty()) {
      EXPECT_EQ(message["value"]["names"], Json(channel.element_names));
    }
    if (!joints) {
      const Json& dim = message["value"]["dim"];
      ASSERT_EQ(dim.size(), channel.frame_shape().size());
      std::size_t stride = channel.frames.columns();
      for (std::size_t i = 0; i < dim.size(); ++i) {
        EXPECT_EQ(dim[i]["size"], channel.frame_shape()[i]);
        EXPECT_EQ(dim[i]["stride"], stride);
        stride /= channel.frame_shape()[i];
      }
    }
  }
}

// The messages between begin and end, in the order of the file.
void expect_exploration(const Exploration& exploration, std::size_t index, const Json& messages,
                        std::size_t& at) {
  const Json& begin = messages.at(at++)["value"];
  EXPECT_EQ(begin["event"], "begin");
  EXPECT_EQ(begin["index"], index);
  ASSERT_EQ(begin["labels"].size(), exploration.labels.size());
  for (std::size_t i = 0; i < exploration.labels.size(); ++i) {
    EXPECT_EQ(begin["labels"][i]["name"], exploration.labels[i].name);
    EXPECT_EQ(begin["labels"][i]["value"], exploration.labels[i].value);
  }
  std::map<std::string, std::vector<Json>> frames;
  for (; messages.at(at)["value"].value("event", "") != "end"; ++at) {
    if (messages[at]["schema"] == "somato.Exploration") continue;
    frames[messages[at]["topic"]].push_back(messages[at]);
  }
  EXPECT_EQ(messages[at++]["value"]["index"], index);
  EXPECT_EQ(frames.size(), exploration.channels.size());
  for (const Channel& channel : exploration.channels) {
    expect_frames(channel, frames[topic_of(channel.name)]);
  }
}

// The messages of each topic in order: the indexed reader may mix topics of the same time.
std::map<std::string, std::vector<Json>> by_topic(const Json& messages) {
  std::map<std::string, std::vector<Json>> topics;
  for (const Json& message : messages) topics[message["topic"]].push_back(message);
  return topics;
}

void expect_readable(const std::string& path, const Recording& recording,
                     const std::string& compression) {
  const Json seen = Json::parse(run_script({"read.mjs", path}));
  std::size_t at = 0;
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    expect_exploration(recording.explorations[i], i, seen["stream"], at);
  }
  EXPECT_EQ(at, seen["stream"].size());
  const Json& indexed = seen["indexed"];
  EXPECT_EQ(by_topic(indexed["messages"]), by_topic(seen["stream"]));
  EXPECT_EQ(indexed["profile"], "somato");
  EXPECT_EQ(indexed["compressions"], Json::array({compression}));
  EXPECT_EQ(indexed["summaryOffsets"], 4);
  const Json& statistics = indexed["statistics"];
  EXPECT_EQ(statistics["messages"], at);
  EXPECT_EQ(statistics["chunks"], indexed["chunks"]);
  EXPECT_EQ(statistics["start"], seen["stream"].front()["time"]);
  EXPECT_EQ(statistics["end"], seen["stream"].back()["time"]);
  std::string last = "0";
  for (const Json& message : seen["stream"]) {
    EXPECT_LE(std::stoll(last), std::stoll(message["time"].get<std::string>()));
    last = message["time"];
  }
}

TEST(McapConformance, TheOfficialReadersReadWhatSomatoWrites) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Recording recording = testing::random_recording(random);
    const std::vector<std::string> names{"", "lz4", "zstd"};
    RecordingFileParameters parameters;
    parameters.compression = Choices<Compression>::all()[seed % 3].first;
    parameters.chunk_size = seed % 2 == 0 ? 3000 : 1 << 20;
    const std::string path = folder.file("a.mcap");
    ASSERT_TRUE(write_recording(path, recording, parameters));
    expect_readable(path, recording, names[seed % 3]);
  }
}

TEST(McapConformance, TheOfficialReadersFindTheLabelsThatAreGivenLater) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.mcap");
  auto writer = RecordingWriter::create(path).value();
  ExplorationStart start;
  start.channels.resize(1);
  start.channels[0].name = "touch";
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(writer.begin_exploration(start));
    ASSERT_TRUE(writer.frame(0, std::vector<float>{1.0F}, 0.0));
    ASSERT_TRUE(writer.label(0, {"object", i == 0 ? "mug" : "cup"})) << "within an exploration";
    ASSERT_TRUE(writer.frame(0, std::vector<float>{2.0F}, 0.5));
    ASSERT_TRUE(writer.end_exploration());
  }
  ASSERT_TRUE(writer.leave_out(1));
  ASSERT_TRUE(writer.close());
  const Json indexed = Json::parse(run_script({"read.mjs", path}))["indexed"];
  EXPECT_EQ(indexed["metadata"], Json::parse(R"([
    ["somato.label", {"exploration": "0", "name": "object", "value": "mug"}],
    ["somato.label", {"exploration": "0", "name": "object", "value": "cup"}],
    ["somato.left_out", {"exploration": "1"}]])"));
  EXPECT_EQ(indexed["statistics"]["metadata"], 3);
  EXPECT_EQ(indexed["summaryOffsets"], 5);
  std::size_t frames = 0;
  for (const Json& message : indexed["messages"]) frames += message["topic"] == "/touch" ? 1 : 0;
  EXPECT_EQ(frames, 4U);
}

TEST(McapConformance, SomatoReadsItsLayoutFromTheOfficialWriter) {
  const TemporaryFolder folder;
  for (const std::string compression : {"none", "lz4", "zstd", "unchunked"}) {
    SCOPED_TRACE(compression);
    const std::string path = folder.file(compression);
    run_script({"write.mjs", path, "own", compression});
    const Result<Recording> read = read_recording(path);
    ASSERT_TRUE(read) << to_string(read.error());
    ASSERT_TRUE(validate(*read));
    ASSERT_EQ(read->explorations.size(), 30u);
    const Exploration& seventh = read->explorations[7];
    EXPECT_EQ(seventh.labels, (std::vector<Label>{{"object", "cup 1"}}));
    EXPECT_EQ(seventh.source, "made");
    const Channel touch{"touch",
                        "counts",
                        {},
                        Matrix<float>(4, 6, {7, 0, 0, 0.25, 5, 6,  //
                                             7, 1, 0, 0.25, 5, 6,  //
                                             7, 2, 0, 0.25, 5, 6,  //
                                             7, 3, 0, 0.25, 5, 6}),
                        {},
                        50.0,
                        {2, 3},
                        Matrix<std::uint8_t>(4, 6, {1, 1, 0, 1, 1, 1, 1, 1, 0, 1, 1, 1,
                                                    1, 1, 0, 1, 1, 1, 1, 1, 0, 1, 1, 1})};
    const Channel joints{"joints",
                         "deg",
                         {"a", "b"},
                         Matrix<float>(4, 2, {90, 7, 90, 7, 90, 7, 90, 7}),
                         {0.25, 0.5, 0.75, 1.0}};
    EXPECT_TRUE(seventh.channels == (std::vector<Channel>{touch, joints}));
  }
}

TEST(McapConformance, SomatoReadsWhatKnowsNoExplorations) {
  const TemporaryFolder folder;
  for (const std::string compression : {"none", "lz4", "zstd", "unchunked"}) {
    SCOPED_TRACE(compression);
    const std::string path = folder.file(compression);
    run_script({"write.mjs", path, "foreign", compression});
    const Result<Recording> read = read_recording(path);
    ASSERT_TRUE(read) << to_string(read.error());
    ASSERT_EQ(read->explorations.size(), 1u);
    const Exploration& only = read->explorations[0];
    EXPECT_TRUE(only.labels.empty());
    EXPECT_EQ(only.source, path);
    ASSERT_EQ(only.channels.size(), 3u);
    EXPECT_EQ(only.channels[0].name, "robot/joint_states");
    EXPECT_EQ(only.channels[0].unit, "rad");
    EXPECT_EQ(only.channels[0].element_names, (std::vector<std::string>{"elbow", "wrist"}));
    EXPECT_EQ(only.channels[0].frames(59, 1), 59.0F);
    EXPECT_EQ(only.channels[0].times[59], 0.59);
    EXPECT_EQ(only.channels[1].name, "skin");
    EXPECT_EQ(only.channels[1].shape, (std::vector<std::size_t>{5, 12}));
    EXPECT_EQ(only.channels[1].frames(3, 59), 62.0F);
    EXPECT_EQ(only.channels[1].times[0], 1e-9);
    EXPECT_EQ(only.channels[2].frames(30, 2), 30.0F);
    const Result<RecordingSummary> summary = inspect_recording(path);
    ASSERT_TRUE(summary);
    EXPECT_FALSE(summary->knows_explorations);
    EXPECT_FALSE(summary->damage) << to_string(*summary->damage);
  }
}

}  // namespace
}  // namespace somato
