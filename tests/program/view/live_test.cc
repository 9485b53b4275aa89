#include "program/support/program_test.h"
#include "somato/recording/format.h"
#include "somato/recording/recording_file.h"
#include "views/support/http_client.h"

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/support/eventually.h"

namespace somato {
namespace {

using nlohmann::json;

// The readings on standard output: every line is whole.
std::vector<json> lines_in(const std::string& out) {
  std::vector<json> lines;
  std::size_t begin = 0;
  while (begin < out.size()) {
    const std::size_t end = out.find('\n', begin);
    EXPECT_NE(end, std::string::npos) << "an incomplete line: " << out.substr(begin);
    if (end == std::string::npos) return lines;
    const json line = json::parse(out.substr(begin, end - begin), nullptr, false);
    EXPECT_TRUE(line.is_object()) << out.substr(begin, end - begin);
    lines.push_back(line);
    begin = end + 1;
  }
  return lines;
}

std::vector<json> finals_in(const std::string& out) {
  std::vector<json> finals;
  for (const json& line : lines_in(out)) {
    if (line.value("final", false)) finals.push_back(line);
  }
  return finals;
}

class Live : public ProgramTest {
 protected:
  // out/system.somato, trained on the example's recording.
  void learn() const {
    write_study();
    output_of({"run", "study.toml", "--data", kTrials, "--out", "out"});
  }

  // The same from explorations of Hand II; few of the many neurons are labelled.
  void learn_by_hand() const {
    write("study.toml",
          "[study]\nname = 'small'\nseeds = 1\n"
          "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
          "[module.closed]\ntype = 'last'\ninput = 'joints'\n"
          "[module.map]\ntype = 'som'\ninput = 'closed'\nrows = 12\ncolumns = 12\n"
          "iterations = 500\n");
    output_of({"explore", "--body", "lucs2", "--explorations", "1", "-o", "train.mcap"});
    output_of({"run", "study.toml", "--data", "train.mcap", "--out", "out"});
  }

  void learn_by_probe() const {
    write("study.toml",
          "[study]\nname = 'small'\nlabel = 'material'\nseeds = 1\n"
          "[module.depth]\ntype = 'channel'\nchannel = 'potentiometer'\n"
          "[module.end]\ntype = 'last'\ninput = 'depth'\n"
          "[module.map]\ntype = 'som'\ninput = 'end'\nrows = 3\ncolumns = 3\niterations = 100\n");
    output_of({"explore", "--body", "hardness", "--explorations", "1", "-o", "train.mcap"});
    output_of({"run", "study.toml", "--data", "train.mcap", "--out", "out"});
  }

  std::vector<json> answers_of(const std::string& data) const {
    const std::string text = output_of({"apply", "out/system.somato", data, "--json"});
    return json::parse(text)["answers"].get<std::vector<json>>();
  }

  Words live(const Words& more) const {
    Words words{"live", "--model", "out/system.somato", "--speed", "max"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  void expect_as_applied(const std::vector<json>& finals, const std::string& data) const {
    const std::vector<json> answers = answers_of(data);
    ASSERT_EQ(finals.size(), answers.size());
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const json& answer = answers[i];
      EXPECT_EQ(finals[i]["exploration"], answer["exploration"]);
      EXPECT_EQ(finals[i]["label"], "object");
      EXPECT_EQ(finals[i]["value"], answer["object"]);
      EXPECT_EQ(finals[i]["winner"], answer["winner"]);
      EXPECT_NEAR(finals[i]["distance"].get<double>(), answer["distance"].get<double>(), 1e-6);
      EXPECT_EQ(finals[i]["given"], answer["given_object"]);
      EXPECT_EQ(finals[i]["right"], answer["object"] == answer["given_object"]);
    }
  }
};

TEST_F(Live, FinalReadingsAreThoseOfApply) {
  learn();
  output_of({"import", "icub_grasp", kTrials, "-o", "grasps.mcap"});
  const std::string out = output_of(live({"--recording", "grasps.mcap"}));
  expect_as_applied(finals_in(out), "grasps.mcap");
  // A line for each frame, with the explorations and frames in order.
  const Recording recording = read_recording(path("grasps.mcap")).value();
  const std::vector<json> lines = lines_in(out);
  std::size_t line = 0;
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    const std::size_t frames = recording.explorations[i].channels.front().frames.rows();
    for (std::size_t frame = 1; frame <= frames + 1; ++frame, ++line) {
      ASSERT_LT(line, lines.size());
      EXPECT_EQ(lines[line]["exploration"], i + 1);
      EXPECT_EQ(lines[line]["frame"], std::min(frame, frames));
      EXPECT_EQ(lines[line]["final"], frame == frames + 1);
      EXPECT_EQ(lines[line].contains("right"), frame == frames + 1);
    }
  }
  EXPECT_EQ(line, lines.size());
}

// A file is read moment by moment, a folder as a whole.
TEST_F(Live, AFolderAndItsFileGiveTheSameLines) {
  learn();
  output_of({"import", "icub_grasp", kTrials, "-o", "grasps.mcap"});
  EXPECT_EQ(output_of(live({"--recording", "grasps.mcap"})),
            output_of(live({"--recording", kTrials})));
}

// A name that was not given is "unknown", unless something has that name.
TEST_F(Live, ReadingsOfExplorationsWithoutANameAreNeitherRightNorWrong) {
  for (const bool is_name : {false, true}) {
    Recording recording = load_recording(RecordingFormat::kAutomatic, kTrials).value();
    for (std::size_t i = 0; i < recording.explorations.size(); i += is_name ? 1 : 2) {
      std::string& object = recording.explorations[i].labels[0].value;
      if (!is_name || object == "ball_small") object = "unknown";
    }
    ASSERT_TRUE(write_recording(path("named.mcap"), recording));
    write_study();
    output_of(
        {"run", "study.toml", "--data", is_name ? path("named.mcap") : kTrials, "--out", "out"});
    const std::vector<json> finals = finals_in(output_of(live({"--recording", "named.mcap"})));
    ASSERT_EQ(finals.size(), recording.explorations.size());
    for (std::size_t i = 0; i < finals.size(); ++i) {
      EXPECT_EQ(finals[i].contains("right"), is_name || i % 2 == 1) << finals[i];
      EXPECT_EQ(finals[i].contains("given"), is_name || i % 2 == 1) << finals[i];
    }
  }
}

TEST_F(Live, ABodyAndItsRecordingGiveTheSameLines) {
  learn_by_hand();
  const std::string body =
      output_of(live({"--body", "lucs2", "--explorations", "1", "-o", "live.mcap"}));
  EXPECT_EQ(read_recording(path("live.mcap")).value(), read_recording(path("train.mcap")).value());
  const std::vector<json> finals = finals_in(body);
  EXPECT_EQ(finals.size(), 6U);
  expect_as_applied(finals, "live.mcap");
  EXPECT_EQ(output_of(live({"--recording", "live.mcap"})), body);
}

TEST_F(Live, ReadsWhatIsNewLikeApply) {
  learn_by_hand();
  output_of({"explore", "--body", "lucs2", "--explorations", "1", "--seed", "2", "-o", "new.mcap"});
  expect_as_applied(finals_in(output_of(live({"--recording", "new.mcap"}))), "new.mcap");
  const std::string one = output_of(
      live({"--body", "lucs2", "--object", "boule", "--explorations", "1", "--seed", "2"}));
  ASSERT_EQ(finals_in(one).size(), 1U);
  EXPECT_EQ(finals_in(one)[0]["given"], "boule");
}

// Only part of what a probe feels is recorded.
TEST_F(Live, TheFinalReadingOfAProbeIsThatOfItsRecording) {
  learn_by_probe();
  const std::string body = output_of(live({"--body", "hardness", "--explorations", "1"}));
  const std::vector<json> of_body = finals_in(body);
  const std::vector<json> of_file = finals_in(output_of(live({"--recording", "train.mcap"})));
  ASSERT_EQ(of_body.size(), of_file.size());
  EXPECT_GT(lines_in(body).size(), 10 * of_body.size());
  for (std::size_t i = 0; i < of_body.size(); ++i) {
    for (const char* field :
         {"exploration", "value", "confidence", "distance", "winner", "given"}) {
      EXPECT_EQ(of_body[i][field], of_file[i][field]) << field;
    }
  }
}

// The signal comes at any time; usually during the first exploration.
// A limit on the size of files is like a disk that is full.
TEST_F(Live, GoesOnWhenTheDiskIsFull) {
  learn_by_probe();
  const Words two{"--body", "hardness", "--explorations", "2"};
  const std::string whole = output_of(live(two));
  ProgramWorld world;
  world.largest_file = 3000;
  Words words = live(two);
  words.insert(words.end(), {"-o", "hand.mcap"});
  const ProgramRun done = run(words, world);
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_EQ(done.out, whole);
  EXPECT_NE(done.err.find("the readings continue"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("could not be saved"), std::string::npos) << done.err;
}

TEST_F(Live, RecordsIntoSeveralFilesWithinItsMemory) {
  learn_by_probe();
  const Words two{"--body", "hardness", "--explorations", "2"};
  const std::string whole = output_of(live(two));
  Words words = live(two);
  words.insert(words.end(), {"-o", "hand_{time}.mcap", "--every", "1kB", "--page-memory", "1MiB"});
  EXPECT_EQ(output_of(words), whole);
  std::size_t files = 0;
  std::size_t explorations = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path(""))) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("hand_")) continue;
    ++files;
    explorations += read_recording(entry.path().string()).value().explorations.size();
  }
  EXPECT_GT(files, 1U);
  EXPECT_EQ(explorations, finals_in(whole).size());
}

TEST_F(Live, EndsBetweenTwoLinesWhenItIsInterrupted) {
  learn_by_hand();
  for (const int signal : {SIGINT, SIGTERM}) {
    ProgramWorld world;
    world.terminal = true;
    world.interrupt_at = "Press Ctrl-C to end.";
    world.interrupt_with = signal;
    const ProgramRun done =
        run(live({"--body", "lucs2", "--explorations", "1000", "-o", "live.mcap"}), world);
    EXPECT_EQ(done.exit_code, 128 + signal);
    EXPECT_NE(done.err.find("stopped before all"), std::string::npos) << done.err;
    const std::size_t finals = finals_in(done.out).size();
    const auto saved = read_recording(path("live.mcap"));
    // The last exploration may have been saved before its line was written.
    const std::size_t explorations = saved ? saved->explorations.size() : 0;
    EXPECT_TRUE(explorations == finals || explorations == finals + 1) << explorations;
    std::filesystem::remove(path("live.mcap"));
  }
}

TEST_F(Live, EndsWhenItsOutputIsClosed) {
  learn();
  output_of({"import", "icub_grasp", kTrials, "-o", "grasps.mcap"});
  ProgramWorld world;
  world.closes_output = true;
  const ProgramRun done = run(live({"--recording", "grasps.mcap"}), world);
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_EQ(done.signal, 0);
  EXPECT_EQ(done.err, "");
  world = {};
  world.output_to = "/dev/full";
  const ProgramRun full = run(live({"--recording", "grasps.mcap"}), world);
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_NE(full.err.find("standard output: cannot write"), std::string::npos) << full.err;
}

TEST_F(Live, RefusesFlagsWithoutEffect) {
  write("m", "nothing");
  const auto with = [](const Words& more) {
    Words words{"live", "--model", "m"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  expect_refused(2, {{{"live", "--body", "lucs2"}, {"--model"}},
                     {with({"--body", "lucs2", "--speed", "0"}), {"--speed", "max"}},
                     {with({"--body", "lucs2", "--speed", "fast"}), {"--speed", "max"}},
                     {with({"--body", "lucs2", "--port", "8080"}), {"--port", "--view"}},
                     {with({"--body", "lucs2", "--address", "127.0.0.1"}), {"--address", "--view"}},
                     {with({"--body", "lucs2", "--allow-others"}), {"--allow-others", "--view"}},
                     {with({"--body", "lucs2", "-o", "-"}), {"--output", "for the readings"}},
                     {with({"--body", "lucs2", "--page-memory", "much"}), {"--page-memory", "MiB"}},
                     {with({"--body", "lucs2", "--page-memory", "9kB"}), {"--page-memory", "1MiB"}},
                     {with({"--body", "lucs2", "-o", "x.mcap", "--every", "1h"}), {"{time}"}},
                     {with({"--body", "lucs2", "--every", "1h"}), {"{time}"}},
                     {with({"--body", "lucs2", "-o", "{time}", "--every", "0h"}), {"30min"}},
                     {with({"--body", "lucs2", "-o", "{time}", "--every", "1w"}), {"30min"}},
                     {with({"--body", "lucs2", "-o", "{time}", "--every", "500"}), {"30min"}}});
  learn();
  const Words recorded{"--recording", kTrials};
  const auto replay = [&](const Words& more) {
    Words words = live(recorded);
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  expect_refused(
      2, {{live({}), {"a body, a device or topics that explore, or a recording", "--body"}},
          {replay({"--body", "lucs2"}), {"one of a body, a device or topics", "is required"}},
          {replay({"--object", "boule"}), {"--object", "no effect on a recording"}},
          {replay({"--explorations", "3"}), {"--explorations", "no effect on a recording"}},
          {replay({"--names", "cup"}), {"--names", "without the view"}},
          {replay({"--seed", "3"}), {"--seed", "no effect on a recording"}},
          {replay({"-o", "x.mcap"}), {"--output", "no effect on a recording"}},
          {replay({"--objects", "study.toml"}), {"--objects", "--view"}},
          {live({"--body", "lucs2", "--object", "boul"}), {"boul", "did you mean 'boule'"}},
          {live({"--body", "lucs2", "--explorations", "1000000"}), {"--explorations", "at most"}},
          {live({"--body", "probes"}), {"only one body"}},
          {live({"--body", "lucs4"}), {"lucs4", "did you mean"}}});
}

TEST_F(Live, SaysWhichChannelsASystemLacks) {
  learn();
  output_of({"explore", "--body", "hardness", "--explorations", "1", "-o", "pressed.mcap"});
  write_data();
  expect_refused(1, {{live({"--body", "hardness"}),
                      {"hardness: the body does not fit the system", "'joints'", "use a body"}},
                     {live({"--body", "lucs2", "-o", "live.mcap"}),
                      {"lucs2: the body does not fit", "joints"}},
                     {live({"--recording", "pressed.mcap"}),
                      {"pressed.mcap: the recording does not fit the system", "joints"}},
                     {live({"--recording", "missing.mcap"}), {"missing.mcap"}},
                     {{"live", "--model", "data.csv", "--body", "lucs2"}, {"data.csv"}}});
}

std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t begin = text.find(before) + before.size();
  return text.substr(begin, text.find(after, begin) - begin);
}

// Begins as a viewer does, and waits until an exploration is complete; `said` has the address,
// such as http://127.0.0.1:8080/?token=...
void explore_once(const std::string& said) {
  const auto port = static_cast<std::uint16_t>(std::stoi(between(said, "127.0.0.1:", "/")));
  const std::string token = "?token=" + between(said, "?token=", "\n");
  const std::string played = testing::ask(
      port, testing::post_request(port, "/api/command" + token, R"({"command":"play"})"));
  EXPECT_EQ(testing::status_of(played), 200) << played;
  const std::string state = testing::get_request(port, "/api/state" + token);
  EXPECT_TRUE(testing::eventually([&] {
    return testing::ask(port, state).find(R"({"index":0)") != std::string::npos;
  })) << "the body does not explore";
}

TEST_F(Live, TheViewShowsWhatIsWritten) {
  learn_by_hand();
  const Words one{"--body", "lucs2", "--object", "boule", "--explorations", "1"};
  const std::string single = output_of(live(one));
  ProgramWorld world;
  world.interrupt_at = "Press Ctrl-C to end.";
  world.before_interrupt = explore_once;
  Words words = live(one);
  words.emplace_back("--view");
  const ProgramRun viewed = run(words, world);
  if (has_no_pages(viewed)) GTEST_SKIP() << "the program was built without npm";
  EXPECT_EQ(viewed.exit_code, 0) << viewed.err;
  EXPECT_EQ(viewed.out, single);
}

TEST_F(Live, WhatWasExploredBeforeAnInterruptionIsSaved) {
  learn_by_hand();
  ProgramWorld world;
  world.interrupt_at = "Press Ctrl-C to end.";
  world.before_interrupt = explore_once;
  const ProgramRun done =
      run(live({"--body", "lucs2", "--explorations", "1000", "-o", "live.mcap", "--view"}), world);
  if (has_no_pages(done)) GTEST_SKIP() << "the program was built without npm";
  EXPECT_EQ(done.exit_code, 130) << done.err;
  const std::vector<json> finals = finals_in(done.out);
  const auto saved = read_recording(path("live.mcap"));
  ASSERT_TRUE(saved);
  ASSERT_FALSE(finals.empty());
  ASSERT_GE(saved->explorations.size(), finals.size());
  EXPECT_NE(done.err.find(" saved in live.mcap"), std::string::npos) << done.err;
  EXPECT_EQ(saved->explorations[0], read_recording(path("train.mcap"))->explorations[0]);
}

// Lines of the names that were learned.
std::vector<json> taught_in(const std::string& out) {
  std::vector<json> taught;
  for (const json& line : lines_in(out)) {
    if (line.contains("taught")) taught.push_back(line);
  }
  return taught;
}

// A name in a line for each exploration; the system that is saved answers them.
TEST_F(Live, LearnsNamesFromStandardInput) {
  learn();
  output_of({"import", "icub_grasp", kTrials, "-o", "grasps.mcap"});
  const std::size_t count = answers_of("grasps.mcap").size();
  write("names", "\ncup\n \nunknown\nmug \r\ncup\n");
  ProgramWorld world;
  world.input_from = path("names");
  const ProgramRun done =
      run(live({"--recording", "grasps.mcap", "--teach", "taught.somato"}), world);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  const std::vector<json> taught = taught_in(done.out);
  ASSERT_EQ(taught.size(), 4U) << done.out;
  EXPECT_EQ(taught[0]["exploration"], 2);
  EXPECT_EQ(taught[0]["taught"], "cup");
  EXPECT_TRUE(taught[0]["neuron"].is_number_integer());
  EXPECT_EQ(taught[1]["exploration"], 4);
  EXPECT_TRUE(taught[1].contains("problem")) << "the name unknown";
  EXPECT_NE(done.err.find("exploration 4: the name 'unknown' was not learned"), std::string::npos);
  EXPECT_EQ(taught[2]["taught"], "mug");
  EXPECT_EQ(finals_in(done.out).size(), count);
  const json answers =
      json::parse(output_of({"apply", "taught.somato", "grasps.mcap", "--json"}))["answers"];
  EXPECT_EQ(answers[1]["object"], "cup");
  EXPECT_EQ(answers[4]["object"], "mug");
  EXPECT_EQ(answers[5]["object"], "cup");
  EXPECT_EQ(answers_of("grasps.mcap")[1]["object"], answers_of("grasps.mcap")[1]["given_object"]);
}

TEST_F(Live, WritesNoSystemWithoutAName) {
  learn();
  const ProgramRun done = run(live({"--recording", kTrials, "--teach", "taught.somato"}));
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_FALSE(std::filesystem::exists(path("taught.somato")));
  write("names", std::string(300, 'n') + "\n");
  ProgramWorld world;
  world.input_from = path("names");
  const ProgramRun refused = run(live({"--recording", kTrials, "--teach", "taught.somato"}), world);
  EXPECT_EQ(refused.exit_code, 0);
  EXPECT_NE(refused.err.find("a name is not used"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(path("taught.somato")));
  expect_refused(2, live({"--recording", kTrials, "--teach", "/dev/stdout"}),
                 {"--teach", "standard output is for the readings"});
}

}  // namespace
}  // namespace somato
