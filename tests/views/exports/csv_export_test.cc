#include "views/exports/csv_export.h"

#include <gtest/gtest.h>

#include "base/files/toml_file.h"
#include "base/support/temporary_folder.h"
#include "recordings/explorations/exploration_frames.h"
#include "somato/recording/csv_import.h"
#include "views/exports/varied_recording.h"

namespace somato {
namespace {

class CsvExportTest : public ::testing::Test {
 protected:
  void write(const Recording& recording) const {
    auto to = CsvExport::begin(folder_.file("out")).value();
    for (const Exploration& exploration : recording.explorations) {
      ASSERT_TRUE(hand_frames(exploration, *to));
    }
    ASSERT_TRUE(to->finish());
  }

  // The table of that name, read by its description.
  Recording read(const std::string& name) const {
    const auto description =
        read_toml(folder_.file("out/" + name + ".toml")).and_then(read_csv_import);
    EXPECT_TRUE(description) << to_string(description.error());
    auto read = import_csv_trials(folder_.file("out/" + name + ".csv"), description.value());
    EXPECT_TRUE(read) << to_string(read.error());
    return read.value_or(Recording{});
  }

  // The text of a file.
  std::string text(const std::string& name) const { return bytes_of(folder_.file("out/" + name)); }

  TemporaryFolder folder_;
};

TEST_F(CsvExportTest, TablesAreReadBackToTheSameChannels) {
  const Recording written = varied_recording();
  write(written);
  const std::vector<std::string> names{"joints", "skin_left", "other"};
  for (std::size_t c = 0; c < names.size(); ++c) {
    const Recording back = read(names[c]);
    ASSERT_EQ(back.explorations.size(), 2U);
    for (std::size_t e = 0; e < 2; ++e) {
      const Exploration& exploration = written.explorations[e];
      Channel expected = exploration.channels[c];
      Channel found = back.explorations[e].channels.at(0);
      EXPECT_EQ(back.explorations[e].labels, exploration.labels);
      if (names[c] != "joints") found.element_names = expected.element_names;
      EXPECT_EQ(found, expected) << names[c];
    }
  }
}

TEST_F(CsvExportTest, NoTextIsAFormulaAndAllAreReadBack) {
  const std::vector<std::string> labels{"=1+1", "+a", "-wet", "@home", "'=x", "-40", "'70s"};
  Recording recording;
  for (const std::string& label : labels) {
    Channel touch{"touch", "", {"=a", "-b"}, Matrix<float>(1, 2, {-1, 2}), {}};
    recording.explorations.push_back({{{"=kind", label}}, "", {touch}});
  }
  write(recording);
  EXPECT_EQ(text("touch.csv"),
            "exploration,\"'=kind\",time,\"'=a\",\"'-b\"\n1,\"'=1+1\",,-1,2\n"
            "2,\"'+a\",,-1,2\n3,\"'-wet\",,-1,2\n4,\"'@home\",,-1,2\n5,\"''=x\",,-1,2\n"
            "6,\"-40\",,-1,2\n7,\"'70s\",,-1,2\n");
  EXPECT_EQ(label_values(read("touch"), "=kind"), labels);
  EXPECT_EQ(read("touch").explorations.at(0).channels.at(0).element_names,
            (std::vector<std::string>{"=a", "-b"}));
}

TEST_F(CsvExportTest, ElementsWithBlankNamesHaveOthers) {
  Channel touch{"touch", "", {"  ", "a"}, Matrix<float>(1, 2, {1, 2}), {}};
  write({{{{{"kind", "cup"}}, "", {touch}}}});
  EXPECT_EQ(read("touch").explorations.at(0).channels.at(0).element_names,
            (std::vector<std::string>{"touch_1", "touch_2"}));
}

TEST_F(CsvExportTest, ATableHasARowForEachFrame) {
  Channel touch{"touch", "N", {}, Matrix<float>(2, 2, {0.1F, 2, 3e-9F, 4}), {0.25, 0.5}, 0.0};
  touch.valid = Matrix<std::uint8_t>(2, 2, std::vector<std::uint8_t>{1, 1, 1, 0});
  Channel sound{"sound", "", {"time"}, Matrix<float>(1, 1, 5.0F), {}, 0.0};
  write({{{{{"time", "a;b"}}, "", {touch, sound}}}});
  EXPECT_EQ(text("touch.csv"),
            "exploration,time,time_,touch_1,touch_2\n1,\"a;b\",0.25,0.1,2\n1,\"a;b\",0.5,3e-09,\n");
  EXPECT_EQ(text("sound.csv"), "exploration,time,time_,sound_1\n1,\"a;b\",,5\n");
  EXPECT_EQ(text("touch.toml"),
            "# somato import csv touch.csv -o touch.mcap --description touch.toml\n\n[import]\n"
            "exploration = \"exploration\"\nlabels = [\"time\"]\ntime = \"time_\"\n"
            "missing = \"mask\"\n\n[[channel]]\nname = \"touch\"\n"
            "columns = [\"touch_1\", \"touch_2\"]\nunit = \"N\"\n");
  EXPECT_TRUE(read("sound").explorations.at(0).channels.at(0).times.empty());
}

TEST_F(CsvExportTest, NothingIsLeftOfAnExportThatIsNotFinished) {
  {
    auto to = CsvExport::begin(folder_.file("out")).value();
    ASSERT_TRUE(hand_frames(varied_recording().explorations.front(), *to));
    EXPECT_EQ(folder_.count(), 1);
  }
  EXPECT_EQ(folder_.count(), 0);
  folder_.with("out", "");
  const auto refused = CsvExport::begin(folder_.file("out"));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("exists"), std::string::npos);
}

}  // namespace
}  // namespace somato
