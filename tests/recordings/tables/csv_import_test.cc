#include "somato/recording/csv_import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/files/toml_file.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

Result<CsvImport> read(const std::string& toml) {
  return parse_toml(toml, "import.toml").and_then([](const Table& file) {
    return read_csv_import(file);
  });
}

std::string refusal(const std::string& toml) {
  const auto description = read(toml);
  if (description) return "none";
  EXPECT_EQ(description.error().kind, ErrorKind::kUsage);
  return to_string(description.error());
}

const std::string kImport = "[import]\nfiles = \"{a}_{b}.csv\"\n";
const std::string kTouch = "[[channel]]\nname = \"touch\"\ncolumns = \"t1..t4\"\n";

TEST(ReadCsvImport, ReadsEveryKey) {
  const CsvImport all = read(R"([import]
files = "{fabric}_{velocity:number}.csv"
header = false
labels = ["10"]
window = 500
overlap = 250
time = "1"
time_unit = "us"
missing = "mask"
ignore = ["7", "8..9"]
other_columns = "ignore"
other_files = "ignore"
[[channel]]
name = "touch"
unit = "counts"
columns = ["2..5"]
shape = [2, 2]
factor = 0.5
[[channel]]
name = "speed"
from_label = "velocity"
absolute = true
)")
                            .value();
  EXPECT_EQ(all.trials.files, "{fabric}_{velocity:number}.csv");
  EXPECT_FALSE(all.trials.header);
  EXPECT_EQ(all.trials.rows, CsvRows::kFrames);
  EXPECT_EQ(all.trials.labels, Names{"10"});
  EXPECT_EQ(all.trials.window, 500U);
  EXPECT_EQ(all.trials.overlap, 250U);
  EXPECT_EQ(all.trials.time, Names{"1"});
  EXPECT_EQ(all.trials.time_unit, TimeUnit::kMicroseconds);
  EXPECT_EQ(all.trials.missing, MissingValues::kMask);
  EXPECT_EQ(all.trials.ignore, (Names{"7", "8..9"}));
  EXPECT_EQ(all.trials.other_columns, Unmentioned::kIgnore);
  EXPECT_EQ(all.trials.other_files, Unmentioned::kIgnore);
  ASSERT_EQ(all.channels.size(), 2U);
  EXPECT_EQ(all.channels[0].name, "touch");
  EXPECT_EQ(all.channels[0].unit, "counts");
  EXPECT_EQ(all.channels[0].columns, (Names{"2..5"}));
  EXPECT_EQ(all.channels[0].shape, (std::vector<std::size_t>{2, 2}));
  EXPECT_EQ(all.channels[0].factor, 0.5);
  EXPECT_FALSE(all.channels[0].absolute);
  EXPECT_EQ(all.channels[1].from_label, "velocity");
  EXPECT_TRUE(all.channels[1].absolute);
}

TEST(ReadCsvImport, NeedsFilesAndAChannelOnly) {
  const CsvImport least = read(kImport + kTouch).value();
  EXPECT_TRUE(least.trials.header);
  EXPECT_EQ(least.trials.rows, CsvRows::kFrames);
  EXPECT_EQ(least.trials.labels, Names{});
  EXPECT_FALSE(least.trials.window);
  EXPECT_EQ(least.trials.time, Names{});
  EXPECT_EQ(least.trials.decimal, DecimalMark::kPoint);
  EXPECT_EQ(least.trials.rate, 0.0);
  EXPECT_EQ(least.trials.missing, MissingValues::kRefuse);
  EXPECT_EQ(least.trials.other_columns, Unmentioned::kRefuse);
  EXPECT_EQ(least.trials.other_files, Unmentioned::kRefuse);
  EXPECT_EQ(least.channels[0].factor, 1.0);
  EXPECT_EQ(read(kImport + "rate = 97\n" + kTouch)->trials.rate, 97.0);
}

TEST(ReadCsvImport, NamesFileAndLineOfWhatIsUnknown) {
  EXPECT_EQ(refusal(kImport + "tine = \"t\"\n" + kTouch),
            "import.toml:3: unknown key 'tine'; did you mean 'time'?");
  EXPECT_EQ(refusal(kImport + kTouch + "colums = \"x\"\n"),
            "import.toml:6: unknown key 'colums'; did you mean 'columns'?");
  EXPECT_EQ(refusal(kImport + kTouch + "[chanel]\n"),
            "import.toml:6: unknown table 'chanel'; did you mean 'channel'?");
  EXPECT_EQ(refusal(kImport + "rate = -1\n" + kTouch),
            "import.toml:3: 'rate' must be a number, at least 0, not -1");
  EXPECT_EQ(
      refusal(kImport + "time_unit = \"m\"\n" + kTouch),
      "import.toml:3: 'time_unit' must be one of s, ms, us, ns, iso, not \"m\"; did you mean 's'?");
}

TEST(ReadCsvImport, RefusesTablesOfAnotherKind) {
  EXPECT_EQ(refusal(kImport + "[channel]\n"),
            "import.toml:3: 'channel' must be a list of tables; write [[channel]] on a separate "
            "line, followed by its keys");
  EXPECT_EQ(refusal("import = 1\n" + kTouch),
            "import.toml:1: 'import' must be a table; write [import] on a separate line, "
            "followed by its keys");
}

TEST(ReadCsvImport, RefusesWhatDoesNotFitTogether) {
  EXPECT_EQ(refusal(kTouch),
            "import.toml:1: 'files' is missing; write for example files = "
            "\"{object}_{trial:number}.csv\"");
  EXPECT_EQ(refusal(kImport),
            "import.toml:1: there are no channels; add a channel with name, unit "
            "and columns ([[channel]] in a description)");
  EXPECT_EQ(refusal("[import]\nfiles = \"all.csv\"\n" + kTouch),
            "import.toml:1: 'files': the pattern has no labels; write for example "
            "\"{object}_{trial:number}.csv\"");
  EXPECT_EQ(refusal(kImport + "time = \"t\"\nrate = 5\n" + kTouch),
            "import.toml:1: there are both 'time' and 'rate'; keep the correct one");
  EXPECT_EQ(refusal(kImport + kTouch + "from_label = \"a\"\n"),
            "import.toml:3: channel 'touch' has both columns and a label; write columns = [...] or "
            "from_label = \"...\"");
  EXPECT_EQ(refusal(kImport + "[[channel]]\nname = \"x\"\n"),
            "import.toml:3: channel 'x' has neither columns nor a label; write columns = [...] or "
            "from_label = \"...\"");
  EXPECT_EQ(refusal(kImport + "[[channel]]\ncolumns = \"x\"\n"),
            "import.toml:3: the channel has no name; write name = \"touch\"");
  EXPECT_EQ(refusal(kImport + kTouch + "[[channel]]\nname = \"touch\"\ncolumns = \"x\"\n"),
            "import.toml:6: there are two channels 'touch'; rename one of them");
  EXPECT_EQ(refusal(kImport + kTouch + "[[channel]]\nname = \"x\"\ncolumns = [\"y\", \"t3\"]\n"),
            "import.toml:6: column 't3' is used twice; name each column once");
  EXPECT_EQ(refusal(kImport + "time = \"t1\"\n" + kTouch),
            "import.toml:4: column 't1' is used twice; name each column once");
  EXPECT_EQ(refusal(kImport + kTouch + "[[channel]]\nname = \"x\"\nfrom_label = \"bb\"\n"),
            "import.toml:6: unknown label 'bb'; did you mean 'b'?");
  EXPECT_EQ(refusal(kImport + "[[channel]]\nname = \"x\"\ncolumns = \"\"\n"),
            "import.toml:3: a column has no name; name it, or leave it out");
  EXPECT_EQ(refusal(kImport + "ignore = \"b2..b1\"\n" + kTouch),
            "import.toml:1: 'ignore': 'b2..b1' is not a range of columns; write for example "
            "\"taxel1..taxel16\", the first column first");
}

TEST(ReadCsvImport, RefusesWindowsThatAreNone) {
  EXPECT_EQ(refusal(kImport + "window = 0\n" + kTouch),
            "import.toml:3: 'window' must be a whole number, at least 1, not 0; \"automatic\" is "
            "also accepted");
  EXPECT_EQ(refusal(kImport + "window = 500.5\n" + kTouch),
            "import.toml:3: 'window' must be a whole number, at least 1, not 500.5; \"automatic\" "
            "is also accepted");
  for (const char* overlap : {"3", "4"}) {
    EXPECT_EQ(refusal(kImport + "window = 3\noverlap = " + overlap + "\n" + kTouch),
              std::string("import.toml:1: 'overlap' is ") + overlap +
                  ", which is not below 'window', 3; windows must begin at least one row apart");
  }
  EXPECT_EQ(refusal(kImport + "overlap = 2\n" + kTouch),
            "import.toml:1: there is 'overlap', but no 'window'; write for example window = 500");
  EXPECT_EQ(refusal(kImport + "window = 3\noverlap = -1\n" + kTouch),
            "import.toml:4: 'overlap' must be a whole number, at least 0, not -1");
}

TEST(ReadCsvImport, RefusesWhatHasNoEffectOnExplorationsOfOneRow) {
  for (const char* key : {"window = 3", "time = \"t\"", "rate = 100"}) {
    const std::string name(key, std::string(key).find(' '));
    EXPECT_EQ(refusal(kImport + "rows = \"explorations\"\n" + key + "\n" + kTouch),
              "import.toml:1: '" + name +
                  "' has no effect with rows = \"explorations\"; leave one of them out");
  }
}

TEST(ReadCsvImport, RefusesTwoLabelsOfOneName) {
  EXPECT_EQ(refusal(kImport + "labels = \"b\"\n" + kTouch),
            "import.toml:1: there are two labels 'b'; rename or remove one of them");
  EXPECT_EQ(refusal(kImport + "labels = [\"c\", \"c\"]\n" + kTouch),
            "import.toml:1: there are two labels 'c'; rename or remove one of them");
  EXPECT_EQ(refusal(kImport + "labels = \"window\"\nwindow = 3\n" + kTouch),
            "import.toml:1: the label 'window' is generated from the windows or rows; rename it");
  EXPECT_EQ(refusal("[import]\nfiles = \"{file}.csv\"\nrows = \"explorations\"\n" + kTouch),
            "import.toml:1: the label 'file' is generated from the windows or rows; rename it");
  EXPECT_TRUE(read(kImport + "labels = \"window\"\n" + kTouch));
}

TEST(ReadCsvImport, RefusesALabelWithoutColumnAndOneThatIsAChannel) {
  EXPECT_EQ(refusal(kImport + "labels = \"\"\n" + kTouch),
            "import.toml:1: 'labels': a column has no name; name it, or leave it out");
  EXPECT_EQ(refusal(kImport + "labels = \"t3\"\n" + kTouch),
            "import.toml:4: column 't3' is used twice; use the label for the channel: from_label = "
            "\"t3\"");
  EXPECT_EQ(refusal(kImport + "labels = \"t\"\ntime = \"t\"\n" + kTouch),
            "import.toml:1: column 't' is used twice; name each column once");
  EXPECT_EQ(refusal(kImport + "labels = \"t\"\nignore = \"t\"\n" + kTouch),
            "import.toml:1: column 't' is both used and ignored; remove one of them");
}

TEST(ReadCsvImport, NeedsNoPatternWhereLabelsComeFromElsewhere) {
  for (const char* keys : {"labels = \"a\"\n", "window = 3\n", "rows = \"explorations\"\n"}) {
    EXPECT_TRUE(read(std::string("[import]\n") + keys + kTouch)) << keys;
    EXPECT_TRUE(read(std::string("[import]\nfiles = \"all.csv\"\n") + keys + kTouch)) << keys;
  }
}

TEST(ReadCsvImport, LeavesTheShapeOfAPatternToTheFiles) {
  EXPECT_TRUE(read(kImport + "[[channel]]\nname = \"x\"\ncolumns = \"x*\"\nshape = [4, 4]\n"));
  EXPECT_EQ(refusal(kImport + "[[channel]]\nname = \"x\"\ncolumns = [\"x*\", \"x*\"]\n"),
            "import.toml:3: column 'x*' is used twice; name each column once");
}

TEST(ReadCsvImport, RefusesAColumnThatIsUsedAndIgnored) {
  EXPECT_EQ(refusal(kImport + "ignore = \"t4..t5\"\n" + kTouch),
            "import.toml:1: column 't4' is both used and ignored; remove one of them");
  EXPECT_EQ(refusal(kImport + "time = \"t\"\nignore = \"t\"\n" + kTouch),
            "import.toml:1: column 't' is both used and ignored; remove one of them");
}

TEST(ReadCsvImport, RefusesAShapeThatIsNotFilled) {
  EXPECT_EQ(refusal(kImport + kTouch + "shape = [2, 3]\n"),
            "import.toml:3: channel 'touch' has 4 elements, which do not fill its shape 2 x 3; "
            "correct the columns or the shape");
  EXPECT_EQ(refusal(kImport + kTouch + "shape = [1000000000, 1000000000, 1000000000]\n"),
            "import.toml:3: channel 'touch' has 4 elements, which do not fill its shape 1000000000 "
            "x 1000000000 x 1000000000; correct the columns or the shape");
  EXPECT_EQ(refusal(kImport + "[[channel]]\nname = \"x\"\nfrom_label = \"a\"\nshape = [2]\n"),
            "import.toml:3: channel 'x' has 1 elements, which do not fill its shape 2; correct the "
            "columns or the shape");
  EXPECT_TRUE(read(kImport + kTouch + "shape = [1, 4, 1]\n"));
}

TEST(CheckCsvImport, NamesThePart) {
  CsvImport description = read(kImport + kTouch).value();
  EXPECT_TRUE(check_csv_import(description));
  description.channels.push_back(description.channels[0]);
  EXPECT_EQ(check_csv_import(description).error().where, "[[channel]] 2");
  description.trials.rate = std::nan("");
  EXPECT_EQ(to_string(check_csv_import(description).error()),
            "[import]: the rate is nan Hz; use a rate above 0, or none");
}

}  // namespace
}  // namespace somato
