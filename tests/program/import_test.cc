#include "program/program_test.h"

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

TEST_F(Import, DescribesCsvFilesByToml) {
  EXPECT_EQ(output_of(csv({"--description", "d.toml"})),
            "out.mcap: 2 explorations; labels: object, trial; channels: touch (2 x counts), trial "
            "(1)\n");
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

TEST_F(Import, RefusesWrongUsage) {
  const auto with = [&](const Words& more) {
    Words all = csv(flags_);
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  expect_refused(
      2,
      {{{"import", "csb", "trials", "-o", "x"}, {"unknown format 'csb'", "did you mean 'csv'?"}},
       {{"import", "csv", "trials"}, {"--output is required"}},
       {{"import", "csv"}, {"is required"}},
       {{"import", "hkust_press_slide", "trials", "-o", "x", "--time", "t"},
        {"--time: the format 'hkust_press_slide' is known"}},
       {{"import", "automatic", "trials", "-o", "x", "--description", "d.toml"},
        {"--description: the format 'automatic' is known"}},
       {with({"--description", "d.toml"}), {"--channels: the files are described twice"}},
       {csv({"--description", "d.toml", "--rate", "5"}), {"--rate: the files are described twice"}},
       {csv({}), {"[import]: 'files' is missing"}},
       {csv({"--files", "{a}.csv"}), {"[import]: there are no channels"}},
       {csv({"--files", "{a}.csv", "--channels", "touch"}),
        {"--channels: 'touch' is no channel", "write such as"}},
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

}  // namespace
}  // namespace somato
