#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "base/support/sanitized.h"
#include "program/support/program_test.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

constexpr std::uintmax_t kFiveGigabytes = std::uintmax_t{5} << 30;
// The size of files that are read to their end: many times the memory that is permitted.
constexpr std::uintmax_t kReadBytes = std::uintmax_t{1} << 30;

class RecordingFiles : public ProgramTest {
 protected:
  static Recording recording() {
    const auto exploration = [](const char* object, const char* trial, std::size_t frames) {
      Channel joints{"joints", "deg", {"a", "b"}, Matrix<float>(frames, 2, 1.5F), {}, 50.0};
      Channel skin{"skin", "", {}, Matrix<float>(2, 6, 2.0F), {0.5, 1.25}, 0.0, {2, 3}};
      return Exploration{{{"object", object}, {"trial", trial}}, "", {joints, skin}};
    };
    return {{exploration("cup", "1", 3), exploration("cup", "2", 10), exploration("ball", "1", 3)}};
  }

  std::string write_recording_file(const std::string& name, Compression compression) const {
    RecordingFileParameters parameters;
    parameters.compression = compression;
    EXPECT_TRUE(write_recording(path(name), recording(), parameters));
    return path(name);
  }

  // Runs a command that may not take more than 64 MB, whatever the file.
  ProgramRun run_small(const Words& arguments) const {
    const ProgramRun done = run(arguments);
#ifndef SOMATO_TESTS_SANITIZED
    EXPECT_LT(done.most_memory, 64'000'000U);
#endif
    return done;
  }
};

TEST_F(RecordingFiles, InspectSummarizesTheContent) {
  write_recording_file("a.mcap", Compression::kLz4);
  EXPECT_EQ(output_of({"inspect", "a.mcap"}),
            "size: " + std::to_string(std::filesystem::file_size(path("a.mcap"))) +
                " bytes\n"
                "compression: lz4\n"
                "explorations: 3\n"
                "duration: 3.75 s\n"
                "label \"object\": \"cup\" 2, \"ball\" 1\n"
                "label \"trial\": \"1\" 2, \"2\" 1\n"
                "channel \"joints\": 2 \"deg\", 50 Hz, 3 to 10 frames an exploration\n"
                "  2 of 2 elements never changed: \"a\", \"b\"\n"
                "channel \"skin\": 2 x 3, with times, 2 frames an exploration\n"
                "whole: yes\n");
}

TEST_F(RecordingFiles, InspectNamesDeadSensorsAndSeveralRates) {
  const auto exploration = [](double rate) {
    Channel skin{"skin", "uT", {"dead", "stuck", "good"}, Matrix<float>(5, 3), {}, rate};
    for (std::size_t i = 0; i < 5; ++i) {
      skin.frames(i, 1) = 2.5F;
      skin.frames(i, 2) = static_cast<float>(i);
    }
    skin.valid = Matrix<std::uint8_t>(5, 3, 1);
    skin.valid(0, 2) = 0;
    return Exploration{{{"object", "cup"}}, "", {skin}};
  };
  ASSERT_TRUE(write_recording(path("a.mcap"), {{exploration(8000.0), exploration(44100.0)}}));
  const std::string text = output_of({"inspect", "a.mcap"});
  EXPECT_NE(text.find("channel \"skin\": 3 \"uT\", 8000 to 44100 Hz, 5 frames an exploration\n"
                      "  1 of 3 elements always 0: \"dead\"\n"
                      "  1 of 3 elements never changed: \"stuck\"\n"
                      "  1 of 3 elements lacking 2 readings: \"good\"\n"),
            std::string::npos)
      << text;
  const std::string json = output_of({"inspect", "a.mcap", "--json"});
  for (const char* const part : {"\"always_zero\"", "\"dead\"", "\"unchanged\"", "\"stuck\"",
                                 "\"missing_values\"", "\"least_rate\"", "\"most_rate\""}) {
    EXPECT_NE(json.find(part), std::string::npos) << part << json;
  }
}

TEST_F(RecordingFiles, InspectReportsTheFirstDamage) {
  write_recording_file("a.mcap", Compression::kNone);
  std::filesystem::resize_file(path("a.mcap"), std::filesystem::file_size(path("a.mcap")) - 1);
  const ProgramRun cut = run({"inspect", "a.mcap"});
  EXPECT_EQ(cut.exit_code, 1);
  EXPECT_NE(cut.out.find("explorations: 3\n"), std::string::npos);
  EXPECT_NE(cut.out.find("whole: no\n"), std::string::npos);
  EXPECT_NE(cut.err.find("a.mcap:byte "), std::string::npos);
  EXPECT_NE(cut.err.find("somato recover a.mcap"), std::string::npos);
}

TEST_F(RecordingFiles, RecoverReportsLossesByItsExitCode) {
  write_recording_file("a.mcap", Compression::kNone);
  EXPECT_EQ(output_of({"recover", "a.mcap", "-o", "b.mcap"}),
            "saved: 3 explorations, 22 frames\nincomplete: 0 explorations\n");
  EXPECT_TRUE(*read_recording(path("b.mcap")) == recording());
  const auto size = std::filesystem::file_size(path("a.mcap"));
  std::filesystem::resize_file(path("a.mcap"), size - 1);
  EXPECT_EQ(run({"recover", "a.mcap", "-o", "b.mcap"}).exit_code, 0) << "only the end is missing";
  EXPECT_TRUE(*read_recording(path("b.mcap")) == recording());

  std::filesystem::resize_file(path("a.mcap"), size / 2);
  const ProgramRun lossy = run({"recover", "a.mcap", "-o", "b.mcap", "--compression", "none"});
  EXPECT_EQ(lossy.exit_code, 3);
  EXPECT_NE(lossy.out.find("incomplete: 1 exploration\n"), std::string::npos) << lossy.out;
  EXPECT_NE(lossy.err.find("some data could not be recovered"), std::string::npos);
  EXPECT_EQ(run({"inspect", "b.mcap"}).exit_code, 0);

  std::filesystem::resize_file(path("a.mcap"), 100);
  std::filesystem::remove(path("b.mcap"));
  expect_refused(1, {"recover", "a.mcap", "-o", "b.mcap"}, {"nothing can be recovered"});
}

TEST_F(RecordingFiles, WrongUsageIsRefused) {
  write_recording_file("a.mcap", Compression::kZstd);
  write("b.csv", "1,2\n");
  expect_refused(2, {{{"recover", "a.mcap"}, {"--output is required"}},
                     {{"inspect"}, {"FILE is required"}},
                     {{"recover", "a.mcap", "-o", "a.mcap"}, {"given twice"}},
                     {{"recover", "a.mcap", "-o", "b.mcap", "--compression", "gzip"},
                      {"--compression", "none", "lz4", "zstd"}}});
  expect_refused(1, {{{"inspect", "b.csv"}, {"b.csv: not an MCAP file"}},
                     {{"inspect", "c.mcap"}, {"c.mcap", "No such file"}},
                     {{"recover", "a.mcap", "-o", "no/b.mcap"}, {"No such file"}}});
}

TEST_F(RecordingFiles, LargeFilesTakeLittleMemory) {
  const std::string whole = bytes_of(write_recording_file("a.mcap", Compression::kZstd));
  write("zeros", "");
  std::filesystem::resize_file(path("zeros"), kReadBytes);
  EXPECT_EQ(run_small({"inspect", "zeros"}).exit_code, 1);

  const std::size_t header = 8 + 9 + 4 + 6 + 4 + 6;  // The magic and a record of two texts.
  write("header", whole.substr(0, header));
  std::filesystem::resize_file(path("header"), kReadBytes);
  const ProgramRun zeros = run_small({"inspect", "header"});
  EXPECT_EQ(zeros.exit_code, 1);
  EXPECT_NE(zeros.err.find("header:byte 37: a record of kind 0x00"), std::string::npos)
      << zeros.err;

  write("longer", whole);
  std::filesystem::resize_file(path("longer"), kReadBytes);
  const ProgramRun longer = run_small({"inspect", "longer"});
  EXPECT_EQ(longer.exit_code, 1);
  EXPECT_NE(longer.out.find("explorations: 3\n"), std::string::npos);
  EXPECT_NE(longer.err.find("bytes follow the end"), std::string::npos) << longer.err;

  std::ofstream attachment(path("attachment"), std::ios::binary);
  attachment << whole.substr(0, header) << '\x09';
  for (int shift = 0; shift < 64; shift += 8) {
    attachment << static_cast<char>(kFiveGigabytes >> shift & 0xFF);
  }
  attachment.seekp(static_cast<std::streamoff>(header + 9 + kFiveGigabytes));
  attachment << whole.substr(header);
  attachment.close();
  const ProgramRun attached = run_small({"inspect", "attachment"});
  EXPECT_EQ(attached.exit_code, 0) << attached.err;
  EXPECT_NE(attached.out.find("explorations: 3\n"), std::string::npos);
}

// One exploration of 100 MB, with more values of a label than fit into memory.
TEST_F(RecordingFiles, LongRecordingsTakeLittleMemory) {
  RecordingFileParameters parameters;
  parameters.compression = Compression::kLz4;
  auto writer = RecordingWriter::create(path("a.mcap"), parameters).value();
  ExplorationStart start;
  start.channels.push_back({"touch", "", {}, {}, 0.0, true});
  constexpr int kEmpty = testing::fewer_if_sanitized(300);
  for (int i = 0; i < kEmpty; ++i) {
    start.labels = {{"noise", std::string(60'000, 'x') + std::to_string(i)}};
    ASSERT_TRUE(writer.begin_exploration(start));
    ASSERT_TRUE(writer.end_exploration());
  }
  ASSERT_TRUE(writer.begin_exploration(start));
  const std::vector<float> values(250'000, 1.0F);
  for (int i = 0; i < testing::fewer_if_sanitized(100); ++i) {
    ASSERT_TRUE(writer.frame(0, values, 0.01 * i));
  }
  ASSERT_TRUE(writer.end_exploration());
  ASSERT_TRUE(writer.close());
  const ProgramRun done = run_small({"inspect", "a.mcap"});
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_NE(done.out.find(fmt::format("explorations: {}\n", kEmpty + 1)), std::string::npos);
  EXPECT_NE(done.out.find(" others"), std::string::npos);
  EXPECT_EQ(run_small({"recover", "a.mcap", "-o", "b.mcap"}).exit_code, 0);
}

TEST_F(RecordingFiles, TenThousandEmptyExplorationsAreCounted) {
  auto writer = RecordingWriter::create(path("a.mcap")).value();
  for (int i = 0; i < 10'000; ++i) {
    ASSERT_TRUE(writer.begin_exploration({{{"trial", std::to_string(i)}}, "", {}, 0.0}));
    ASSERT_TRUE(writer.end_exploration());
  }
  ASSERT_TRUE(writer.close());
  const std::string out = output_of({"inspect", "a.mcap"});
  EXPECT_NE(out.find("explorations: 10000\n"), std::string::npos);
  EXPECT_NE(out.find("\"19\" 1, and 9980 others\n"), std::string::npos) << out;
}

// Every valid recording can be recovered: a frame may be as large as a chunk.
TEST_F(RecordingFiles, LargeFramesAreRecovered) {
  constexpr std::size_t kElements = 5'750'000;  // 23 MB
  Channel large{"touch", "", {}, Matrix<float>(1, kElements), {}, 10.0};
  large.frames(0, kElements - 1) = 7.0F;
  ASSERT_TRUE(write_recording(path("large.mcap"), {{{{{"object", "ball"}}, {}, {large}}}}));
  output_of({"recover", "large.mcap", "-o", "saved.mcap"});
  const auto saved = read_recording(path("saved.mcap"));
  ASSERT_TRUE(saved) << to_string(saved.error());
  EXPECT_TRUE(saved->explorations.at(0).channels.at(0).frames == large.frames);
}

}  // namespace
}  // namespace somato
