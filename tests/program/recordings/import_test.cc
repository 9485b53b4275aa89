#include <sys/stat.h>

#include "program/support/program_test.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

class Import : public ProgramTest {
 protected:
  Import() {
    std::filesystem::create_directory(path("trials"));
    write("trials/a_1.csv", "t,x,y\n0,1,2\n10,3,4\n");
    write("trials/a_2.csv", "t,x,y\n5,5,6\n");
    write("d.toml", R"([import]
files = "{object}_{trial:number}.csv"
time = "t"
time_unit = "ms"
[[channel]]
name = "touch"
unit = "counts"
columns = ["x", "y"]
[[channel]]
name = "trial"
from_label = "trial"
)");
  }

  /// `somato import csv trials -o out.mcap` and more.
  static Words csv(const Words& more) {
    Words all{"import", "csv", "trials", "-o", "out.mcap"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  const Words flags_{"--files", "{object}_{trial}.csv", "--time",
                     "t",       "--channels",           "touch:counts=x,force=y"};
};

TEST_F(Import, DescribesCsvFilesByFlags) {
  EXPECT_EQ(output_of(csv(flags_)),
            "out.mcap: 2 explorations; labels: object, trial; channels: touch (1 x counts), force "
            "(1)\n");
}

// A glove beside a pad whose columns have a row and a column, cut where the object changes.
TEST_F(Import, TakesRangesShapesAndExplorationsAsPeopleHaveThem) {
  write("glove.csv",
        "object,thumb,ring,pinky,p00,p01,p10,p11\n"
        "cup,1,2,3,4,5,6,7\ncup,1,2,3,4,5,6,8\nball,9,2,3,4,5,6,7\n");
  output_of({"import", "csv", "glove.csv", "-o", "glove.mcap", "--exploration", "object",
             "--labels", "object", "--channels", "joints:deg=thumb..pinky,touch[2x2]:N=p00..p11"});
  const Recording recording = read_recording(path("glove.mcap")).value();
  ASSERT_EQ(recording.explorations.size(), 2U);
  const auto& [joints, touch] =
      std::tie(recording.explorations[0].channels.at(0), recording.explorations[0].channels.at(1));
  EXPECT_EQ(joints.element_names, (Words{"thumb", "ring", "pinky"}));
  EXPECT_EQ(joints.unit, "deg");
  EXPECT_EQ(touch.element_names, (Words{"p00", "p01", "p10", "p11"}));
  EXPECT_EQ(touch.shape, (std::vector<std::size_t>{2, 2}));
  EXPECT_EQ(touch.frames(1, 3), 8.0F);
}

TEST_F(Import, DescribesCsvFilesByToml) {
  EXPECT_EQ(output_of(csv({"--description", "d.toml"})),
            "out.mcap: 2 explorations; labels: object, trial; channels: touch (2 x counts), trial "
            "(1)\n");
}

TEST_F(Import, ReadsTimesOfClocks) {
  write("times.csv", "Date,Time,x\n2026-01-01,10:30:25.000,23.5\n2026-01-01,10:30:26.5,23.6\n");
  const Words import{"import",  "csv",        "times.csv",  "-o", "out.mcap",
                     "--files", "{name}.csv", "--channels", "f=x"};
  const auto with = [&](const Words& more) {
    Words all = import;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  output_of(with({"--time", "Date,Time", "--time-unit", "iso"}));
  EXPECT_NE(output_of({"inspect", "out.mcap"}).find("1.5"), std::string::npos);
  expect_refused(2, with({"--time", "Date,Time"}), {"'time' has two columns", "--time-unit iso"});
  expect_refused(
      1, with({"--time", "Time", "--ignore", "Date"}),
      {"times.csv:2:12: '10:30:25.000' in column 'Time' is not a time in s", "(--time-unit iso)"});
}

TEST_F(Import, ReadsTablesOfSpreadsheets) {
  write("sheet.csv", "sep=;\nt;x;\n0,00;1,5;\n0,5;2;\n");
  const Words import{"import", "csv", "sheet.csv",  "-o",  "out.mcap", "--files", "{name}.csv",
                     "--time", "t",   "--channels", "f=x", "--ignore", "3"};
  expect_refused(1, import, {"sheet.csv:3:6: '1,5' is not a number", "(--decimal comma)"});
  Words with_comma = import;
  with_comma.insert(with_comma.end(), {"--decimal", "comma"});
  EXPECT_EQ(output_of(with_comma), "out.mcap: 1 explorations; labels: name; channels: f (1)\n");
}

TEST_F(Import, WarnsOfConstantTimes) {
  write("trials/a_2.csv", "t,x,y\n5,5,6\n5,5,6\n");
  EXPECT_NE(
      output_of(csv(flags_))
          .find("\nwarning: the time is the same in all rows of trials/a_2.csv: import without"),
      std::string::npos);
}

TEST_F(Import, KnowsFormatsByNameAndOfItself) {
  std::filesystem::create_directory(path("hkust"));
  write("hkust/Material_Wood_raw_1.csv", "Fx,Fy,Fz\n1,2,3\n");
  for (const char* format : {"hkust_press_slide", "automatic"}) {
    const std::string file = std::string(format) + ".mcap";
    EXPECT_EQ(output_of({"import", format, "hkust", "-o", file}),
              file + ": 1 explorations; labels: material, trial; channels: force (3 x N)\n");
  }
}

TEST_F(Import, ReadsDumpsOfYarp) {
  std::filesystem::create_directories(path("dumps/cup_1/skin"));
  std::filesystem::create_directories(path("dumps/cup_1/speech"));
  write("dumps/cup_1/skin/data.log", "0 5.0 1 2\n1 5.5 3 4\n");
  write("dumps/cup_1/speech/data.log", "0 5.0 hello\n");
  EXPECT_EQ(output_of({"import", "yarp", "dumps", "-o", "out.mcap", "--files",
                       "{object}_{trial:number}"}),
            "out.mcap: 1 explorations; labels: object, trial; channels: skin (2)\n"
            "left out: dumps/cup_1/speech: text\n");
  expect_refused(2, {"import", "yarp", "dumps", "-o", "x.mcap", "--rate", "10"}, {"--rate"});
}

TEST_F(Import, RefusesWrongUsage) {
  const auto with = [&](const Words& more) {
    Words all = csv(flags_);
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  expect_refused(
      2, {{{"import", "csb", "trials", "-o", "x"}, {"unknown format 'csb'", "did you mean 'csv'?"}},
          {{"import", "csv", "trials"}, {"--output is required"}},
          {{"import", "csv"}, {"is required"}},
          {{"import", "hkust_press_slide", "trials", "-o", "x", "--time", "t"},
           {"--time: the format 'hkust_press_slide' needs no description"}},
          {{"import", "automatic", "trials", "-o", "x", "--description", "d.toml"},
           {"--description: the format 'automatic' needs no description"}},
          {with({"--description", "d.toml"}),
           {"--channels: the files are described by both a flag and --description"}},
          {csv({"--description", "d.toml", "--rate", "5"}),
           {"--rate: the files are described by both a flag and --description"}},
          {csv({}), {"[import]: 'files' is missing"}},
          {csv({"--files", "{a}.csv"}), {"[import]: there are no channels"}},
          {csv({"--files", "{a}.csv", "--channels", "touch"}),
           {"--channels: 'touch' is not a channel", "write for example"}},
          {csv({"--files", "{a}.csv", "--channels", "touch[4x]=x"}),
           {"--channels: '4x' is not a shape", "write for example touch[4x4]"}},
          {csv({"--files", "{a}.csv", "--channels", "touch:N[4x4]=x"}),
           {"has brackets where no shape can be", "touch[4x4]:N=t*"}},
          {csv({"--files", "{a}.csv", "--channels", "touch[4x4=x"}),
           {"has brackets where no shape can be"}},
          {csv({"--files", "{a}.csv", "--channels", "touch[2x2]=x"}),
           {"'touch' has 1 elements, which do not fill its shape 2 x 2"}},
          {csv({"--files", "{a}.csv", "--channels", "=x"}), {"the channel has no name"}},
          {csv({"--files", "{a}.csv", "--channels", "touch="}), {"a column has no name"}},
          {with({"--rate", "5"}), {"there are both 'time' and 'rate'"}},
          {with({"--tine", "5"}), {"unknown flag '--tine'", "'--time'"}},
          {{"import", "csv", "trials", "-o", "d.toml", "--description", "d.toml"},
           {"the file is given twice"}}});
}

TEST_F(Import, RefusesBadDataAndWritesNothing) {
  write("trials/a_3.csv", "t,x,y\n5,5,\n");
  expect_refused(1, csv(flags_), {"trials/a_3.csv:2:5: the field is empty", "missing = \"mask\""});
  expect_refused(1, {"import", "automatic", "trials", "-o", "x"}, {"none of the known formats"});
  expect_refused(1, {"import", "icub_grasp", "nowhere", "-o", "x"}, {"nowhere: "});
  expect_refused(1, {"import", "csv", "trials", "-o", "no/x", "--description", "d.toml"},
                 {"no/x: cannot save"});
}

TEST_F(Import, FailsWhereTheDescriptionIsWrongAtItsPlace) {
  write("d.toml", "[import]\nfiles = \"{a}.csv\"\nfactor = 3\n");
  expect_refused(2, csv({"--description", "d.toml"}), {"d.toml:3: unknown key 'factor'"});
}

TEST_F(Import, CutsWindowsAndReportsTheRemainder) {
  write("trials/a_3.csv", "t,x,y\n0,1,2\n1,1,2\n2,1,2\n3,1,2\n4,1,2\n");
  EXPECT_EQ(output_of(csv({"--files", "{object}_{trial}.csv", "--time", "t", "--channels",
                           "touch=*", "--window", "2"})),
            "out.mcap: 3 explorations; labels: object, trial, file, window; channels: touch (2)\n"
            "left out, because they fill no window: 2 rows, with 1 file shorter than a window\n");
  EXPECT_EQ(output_of(csv({"--files", "{object}_{trial}.csv", "--time", "t", "--channels",
                           "touch=*", "--window", "1"})),
            "out.mcap: 8 explorations; labels: object, trial, file, window; channels: touch (2)\n");
}

TEST_F(Import, MakesExplorationsOfTheRowsOfOneTable) {
  write("table.csv", "object,x,grasp,y\ncup,1,1,2\nmug,3,2,4\n");
  EXPECT_EQ(output_of({"import", "csv", "table.csv", "-o", "t.mcap", "--rows", "explorations",
                       "--labels", "object,grasp", "--channels", "touch=*"}),
            "t.mcap: 2 explorations; labels: object, grasp, file, row; channels: touch (2)\n");
  EXPECT_NE(output_of({"inspect", "t.mcap"}).find("mug"), std::string::npos);
}

TEST_F(Import, JoinsRecordingsWithTheLabelsOfTheirNames) {
  std::filesystem::create_directory(path("runs"));
  for (const char* run : {"a_1", "b_2"}) {
    output_of({"import", "csv", "trials", "-o", std::string("runs/") + run + ".mcap", "--files",
               "{object}_{trial}.csv", "--time", "t", "--channels", "touch=x+y"});
  }
  EXPECT_EQ(output_of({"import", "mcap", "runs", "-o", "out.mcap", "--files",
                       "{hand}_{day:number}.mcap"}),
            "out.mcap: 4 explorations; labels: object, trial, hand, day; channels: touch (2)\n");
  expect_refused(
      1, {"import", "mcap", "runs", "-o", "x", "--files", "{object}_{trial}.mcap"},
      {"runs/a_1.mcap: label 'trial' is '2' in the recording, but '1' in the file name"});
  expect_refused(1, {"import", "mcap", "trials", "-o", "x", "--files", "{hand}.mcap"},
                 {"trials: there are no files \"{hand}.mcap\""});
  const Words mcap{"import", "mcap", "runs", "-o"};
  const auto with = [&](const Words& more) {
    Words all = mcap;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  expect_refused(2, {{with({"x"}), {"'files': the pattern has no labels"}},
                     {with({"x", "--files", "{a}.mcap", "--window", "5"}),
                      {"--window: the files define their channels"}},
                     {with({"x", "--description", "d.toml"}), {"--description: the files define"}},
                     {with({"x", "--channels", "touch=x"}), {"--channels: the files define"}},
                     {with({"runs/a_1.mcap", "--files", "{h}_{d}.mcap"}),
                      {"runs/a_1.mcap: saving would overwrite a file of the folder DIR"}}});
  ASSERT_EQ(::mkfifo(path("runs/c_3.mcap").c_str(), 0600), 0);
  expect_refused(1, with({"x", "--files", "{h}_{d}.mcap"}),
                 {"runs/c_3.mcap: it is not a regular file"});
}

TEST_F(Import, RefusesWrongWindowsAndTables) {
  const auto with = [&](const Words& more) {
    Words all = csv({"--files", "{object}_{trial}.csv"});
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  expect_refused(2, {{with({"--channels", "touch=x", "--window", "0"}), {"--window", "at least 1"}},
                     {with({"--channels", "touch=x", "--window", "5", "--overlap", "5"}),
                      {"[import]: 'overlap' is 5, which is not below 'window', 5"}},
                     {with({"--channels", "touch=x", "--rows", "explorations", "--window", "5"}),
                      {"'window' has no effect with rows = \"explorations\""}},
                     {with({"--channels", "touch=x", "--rows", "exploration"}),
                      {"did you mean 'explorations'?"}},
                     {csv({"--channels", "touch=x", "--window", "5"}), {"'files' is missing"}},
                     {{"import", "csv", "trials/a_1.csv", "-o", "trials/a_1.csv", "--window", "1",
                       "--channels", "touch=x"},
                      {"the file is given twice"}}});
  expect_refused(1, with({"--channels", "touch=*", "--window", "3"}),
                 {"trials: no file has 3 rows; the most are 2"});
  expect_refused(1, with({"--channels", "touch=z*", "--other-columns", "ignore"}),
                 {"trials/a_1.csv:1: no column matches 'z*'"});
  expect_refused(1, with({"--channels", "touch=*", "--ignore", "aux*"}),
                 {"trials: 'ignore': no column matches 'aux*'"});
  expect_refused(1, with({"--channels", "touch=*", "--labels", "what"}),
                 {"trials/a_1.csv:1: there is no column 'what'"});
}

}  // namespace
}  // namespace somato
