#include "somato/recording/csv_import.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "recordings/support/csv_trials_test.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

using ImportCsvTrials = CsvTrialsTest;

TEST_F(ImportCsvTrials, ReadsEveryNumberToItsPlace) {
  plan_.trials.time = {"t"};
  plan_.channels = {channel_of("touch", {"b1..b2"}), channel_of("joints", {"a"})};
  plan_.channels[0].unit = "counts";
  plan_.channels[0].shape = {2, 1};
  const Exploration trial = read("t,b2,a,b1\n0,1,2,3\n0.5,4,5,6\n");
  EXPECT_EQ(trial.labels, (std::vector<Label>{{"object", "x"}, {"trial", "1"}}));
  EXPECT_EQ(trial.source, folder_.file("x_1.csv"));
  Channel touch{"touch", "counts", {"b1", "b2"}, matrix(2, {3, 1, 6, 4}), {0, 0.5}};
  touch.shape = {2, 1};
  EXPECT_EQ(trial.channels,
            (std::vector<Channel>{touch, {"joints", "", {"a"}, matrix(2, {2, 5}), {0, 0.5}}}));
}

TEST_F(ImportCsvTrials, ComesInNaturalOrder) {
  for (const char* name : {"x_10.csv", "x_9.csv", "w_11.csv"}) folder_.with(name, "a,b\n1,2\n");
  const Recording recording = import().value();
  EXPECT_EQ(label_values(recording, "trial"), (Names{"11", "9", "10"}));
}

TEST_F(ImportCsvTrials, MakesTimesRelativeAndSeconds) {
  plan_.trials.time = {"t"};
  const std::pair<TimeUnit, const char*> units[] = {
      {TimeUnit::kSeconds, "t,a,b\n1700000000,0,0\n1700000000.25,0,0\n1700000003,0,0\n"},
      {TimeUnit::kMilliseconds, "t,a,b\n1700000000000,0,0\n1700000000250,0,0\n1700000003000,0,0\n"},
      {TimeUnit::kMicroseconds, "t,a,b\n-1000000,0,0\n-750000,0,0\n2000000,0,0\n"},
      {TimeUnit::kNanoseconds, "t,a,b\n1e9,0,0\n1.25e9,0,0\n4e9,0,0\n"}};
  for (const auto& [unit, text] : units) {
    plan_.trials.time_unit = unit;
    EXPECT_EQ(read(text).channels[0].times, (std::vector<double>{0, 0.25, 3})) << text;
  }
}

TEST_F(ImportCsvTrials, TakesARateInstead) {
  plan_.trials.rate = 97.0;
  const Exploration trial = read("a,b\n1,2\n");
  EXPECT_EQ(trial.channels[0].rate, 97.0);
  EXPECT_TRUE(trial.channels[0].times.empty());
}

TEST_F(ImportCsvTrials, MakesAChannelOfALabel) {
  plan_.channels.push_back(channel_of("speed", {}));
  plan_.channels[1].unit = "m/s";
  plan_.channels[1].from_label = "trial";
  plan_.channels[1].factor = 0.001;
  plan_.trials.rate = 10.0;
  folder_.with("x_-250.csv", "a,b\n1,2\n3,4\n");
  const Channel speed = import()->explorations[0].channels[1];
  EXPECT_EQ(speed, (Channel{"speed", "m/s", {}, matrix(1, {-0.25F}), {}}));
  plan_.channels[1].absolute = true;
  EXPECT_EQ(import()->explorations[0].channels[1].frames, matrix(1, {0.25F}));
}

TEST_F(ImportCsvTrials, RefusesALabelThatIsNoNumberForAChannel) {
  plan_.channels.push_back(channel_of("speed", {}));
  plan_.channels[1].from_label = "object";
  EXPECT_EQ(error_for("a,b\n1,2\n"),
            "x_1.csv: label 'object' is 'x', which is not a number for channel 'speed'; rename or "
            "remove the file");
}

TEST_F(ImportCsvTrials, ScalesColumns) {
  plan_.channels[0].factor = -0.5;
  EXPECT_EQ(read("a,b\n1,-2\n").channels[0].frames, matrix(1, {-0.5, 1}));
  plan_.channels[0].absolute = true;
  EXPECT_EQ(read("a,b\n1,-2\n").channels[0].frames, matrix(1, {0.5, 1}));
}

TEST_F(ImportCsvTrials, TakesAByteOrderMarkAnyLineEndsQuotesAndBlanks) {
  const Matrix<float> expected = matrix(2, {1, 2, 3, 4});
  for (const char* text :
       {"\xEF\xBB\xBF"
        "a,b\n1,2\n3,4\n",
        "a,b\r\n1,2\r\n3,4\r\n", "\"a\",\"b\"\n\"1\",\"2\"\n3,4", "a, b\n 1 , 2\n3 ,4\n\n",
        "# made by hand\na;b\n1;2\n3;4\n", "a\tb\n1\t2\n3\t4\n"}) {
    EXPECT_EQ(read(text).channels[0].frames, expected) << text;
  }
}

TEST_F(ImportCsvTrials, CallsColumnsByNumberWithoutAHeader) {
  plan_.trials.header = false;
  plan_.trials.time = {"1"};
  plan_.channels = {channel_of("touch", {"2..3"})};
  const Channel touch = read("7,1,2\n8,3,4\n").channels[0];
  EXPECT_EQ(touch, (Channel{"touch", "", {"2", "3"}, matrix(2, {1, 2, 3, 4}), {0, 1}}));
}

TEST_F(ImportCsvTrials, MarksMissingValuesOnRequest) {
  plan_.trials.missing = MissingValues::kMask;
  const Channel touch = read("a,b\n1,\nNaN,4\n").channels[0];
  EXPECT_EQ(touch.frames, matrix(2, {1, 0, 0, 4}));
  EXPECT_EQ(touch.valid, Matrix<std::uint8_t>(2, 2, {1, 0, 0, 1}));
  EXPECT_TRUE(read("a,b\n1,2\n").channels[0].valid.empty());
}

TEST_F(ImportCsvTrials, RefusesMissingValuesOtherwise) {
  EXPECT_EQ(error_for("a,b\n1,2\n3,\n"),
            "x_1.csv:3:3: the field is empty; fill in a number, or import with missing = \"mask\"");
  EXPECT_EQ(error_for("a,b\nnan,2\n"),
            "x_1.csv:2:1: 'nan' is not a finite number; fill in a number, or import with missing = "
            "\"mask\"");
}

TEST_F(ImportCsvTrials, RefusesInfinityAndTextEvenWhereMissingValuesAreMarked) {
  plan_.trials.missing = MissingValues::kMask;
  EXPECT_EQ(error_for("a,b\n1,-inf\n"),
            "x_1.csv:2:3: '-inf' is not a finite number; leave the row out or fill in a number");
  EXPECT_EQ(error_for("a,b\n1,two\n"),
            "x_1.csv:2:3: 'two' is not a number; correct it, or list its column under 'ignore'");
  plan_.trials.time = {"t"};
  EXPECT_EQ(error_for("t,a,b\n,1,2\n"),
            "x_1.csv:2:1: the time in column 't' is missing; write the time, or remove the row");
}

TEST_F(ImportCsvTrials, RefusesNumbersBeyondSinglePrecision) {
  EXPECT_EQ(error_for("a,b\n1,3.5e38\n"),
            "x_1.csv:2:3: '3.5e38' exceeds the range of 32-bit numbers; scale the column");
  EXPECT_EQ(read("a,b\n1,3.4e38\n").channels[0].frames, matrix(1, {1, 3.4e38F}));
  EXPECT_EQ(error_for("a,b\n1,-1e999\n"),
            "x_1.csv:2:3: '-1e999' exceeds the range of 32-bit numbers; scale the column");
  plan_.channels[0].factor = 1e30;
  EXPECT_EQ(error_for("a,b\n1,1e9\n"),
            "x_1.csv:2:3: '1e9' exceeds the range of 32-bit numbers; scale the column");
  EXPECT_EQ(read("a,b\n0,1e-60\n").channels[0].frames, matrix(1, {0, 1e-30F}));
}

TEST_F(ImportCsvTrials, RefusesTimesThatRunBackwards) {
  plan_.trials.time = {"t"};
  EXPECT_EQ(error_for("a,t,b\n0,10,0\n0,12,0\n0,11,0\n"),
            "x_1.csv:4:3: the time decreases: '11' in column 't' follows a later time; repair or "
            "remove the file");
  EXPECT_EQ(read("t,a,b\n1,0,0\n1,0,0\n").channels[0].times, (std::vector<double>{0, 0}));
}

TEST_F(ImportCsvTrials, RefusesRaggedRows) {
  for (const char* row : {"1", "1,2,3"}) {
    EXPECT_EQ(error_for(fmt::format("a,b\n1,2\n{}\n1,2\n", row)),
              fmt::format("x_1.csv:3: expected 2 fields, found {}; repair or remove the file",
                          row[1] == '\0' ? 1 : 3));
  }
}

TEST_F(ImportCsvTrials, RefusesEmptyFiles) {
  for (const char* text : {"", "\n", "\xEF\xBB\xBF", "a,b\n", "# nothing\n"}) {
    EXPECT_EQ(error_for(text), "x_1.csv: there are no rows of numbers; remove the file") << text;
  }
}

TEST_F(ImportCsvTrials, RefusesAHeaderThatLacksAColumn) {
  plan_.channels[0].columns = {"a1..a3"};
  EXPECT_EQ(error_for("a1,a2\n1,2\n"), "x_1.csv:1: there is no column 'a3'; did you mean 'a1'?");
  plan_.trials.time = {"clock"};
  EXPECT_EQ(error_for("\na1,a2,a3\n1,2,3\n"),
            "x_1.csv:2: there is no column 'clock'; known are: a1, a2, a3");
  EXPECT_EQ(error_for("0,1,2\n1,2,3\n"),
            "x_1.csv:1: there is no column 'clock'; write header = false if the first line "
            "contains no names");
  plan_.trials.header = false;
  EXPECT_EQ(error_for("0,1\n"), "x_1.csv:1: there is no column 'clock'; known are: 1, 2");
}

TEST_F(ImportCsvTrials, RefusesTwoColumnsOfOneName) {
  EXPECT_EQ(error_for("a,b,a\n1,2,3\n"),
            "x_1.csv:1:5: there are two columns 'a'; rename one of them");
  plan_.trials.ignore = {"c"};
  EXPECT_EQ(read("a,c,b,c\n1,2,3,4\n").channels[0].frames, matrix(1, {1, 3}));
}

TEST_F(ImportCsvTrials, RefusesColumnsThatAreNotMentioned) {
  EXPECT_EQ(
      error_for("a,c1,b,c2\n1,2,3,4\n"),
      "x_1.csv:1: columns that are not mentioned: 'c1', 'c2'; assign them to a channel, or list "
      "them under 'ignore'");
  plan_.trials.ignore = {"c1..c2"};
  EXPECT_EQ(read("a,c1,b,c2\n1,x,3,\n").channels[0].frames, matrix(1, {1, 3}));
  plan_.trials.ignore = {};
  plan_.trials.other_columns = Unmentioned::kIgnore;
  EXPECT_EQ(read("a,c1,b,c2\n1,x,3,\n").channels[0].frames, matrix(1, {1, 3}));
}

TEST_F(ImportCsvTrials, IgnoresOtherFilesOnRequest) {
  folder_.with("summary.csv", "never read");
  EXPECT_EQ(
      error_for("a,b\n1,2\n"),
      "summary.csv: the file name does not match the pattern \"{object}_{trial:number}.csv\"; "
      "rename it, remove it from the folder, or correct the pattern");
  plan_.trials.other_files = Unmentioned::kIgnore;
  EXPECT_EQ(read("a,b\n1,2\n").channels[0].frames, matrix(1, {1, 2}));
}

TEST_F(ImportCsvTrials, RefusesBinaryContentAndOpenQuotes) {
  EXPECT_EQ(error_for(std::string("a,b\n1,\0\n", 8)),
            "x_1.csv:2: byte 0x00 is not UTF-8 text; save the file as UTF-8 text, or check that it "
            "is the right file");
  EXPECT_EQ(error_for("a,b\n1,\"2\n"),
            "x_1.csv:2:3: the quotation mark is not closed; close it, or write it twice if it "
            "belongs to the text");
}

TEST_F(ImportCsvTrials, RefusesAWrongDescription) {
  plan_.channels.clear();
  const auto recording = import();
  ASSERT_FALSE(recording);
  EXPECT_EQ(recording.error().kind, ErrorKind::kUsage);
}

TEST_F(ImportCsvTrials, SaysWhatCannotBeRead) {
  plan_.trials.files = "{object}.csv";
  const auto nowhere = import_csv_trials(folder_.file("nowhere"), plan_);
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().kind, ErrorKind::kSystem);
  EXPECT_EQ(nowhere.error().where, folder_.file("nowhere"));
  if (::geteuid() == 0) return;  // root may read everything
  folder_.with("x.csv", "a,b\n1,2\n");
  std::filesystem::permissions(folder_.file("x.csv"), std::filesystem::perms::none);
  EXPECT_EQ(import().error().where, folder_.file("x.csv"));
}

TEST_F(ImportCsvTrials, RefusesAFileLargerThanFourGibibytes) {
  std::filesystem::resize_file(folder_.with("x_1.csv", ""), (std::uintmax_t{4} << 30) + 1);
  const auto recording = import();
  ASSERT_FALSE(recording);
  EXPECT_EQ(recording.error().what, "the file is larger than 4294967296 bytes");
}

TEST_F(ImportCsvTrials, ReadsTenThousandSmallFiles) {
  for (int i = 0; i < 10000; ++i)
    folder_.with(fmt::format("x_{}.csv", i), fmt::format("a,b\n{},2\n", i));
  const Recording recording = import().value();
  ASSERT_EQ(recording.explorations.size(), 10000U);
  for (std::size_t i = 0; i < 10000; ++i) {
    ASSERT_EQ(recording.explorations[i].channels[0].frames(0, 0), static_cast<float>(i));
  }
}

// Only two cuts remain unnoticed: whole rows, and digits at the end of a file without line end.
TEST_F(ImportCsvTrials, ReadsCutFilesAsFarAsRowsAreWholeOrNotAtAll) {
  const std::string text = "a,b\n11,22\n33,44\n";
  const std::string last_row = "33,";
  for (std::size_t size = 0; size < text.size(); ++size) {
    const std::string cut = text.substr(0, size);
    folder_.with("x_1.csv", cut);
    const auto recording = import();
    const bool whole = cut.ends_with("22") || cut.ends_with("22\n") || cut.ends_with("44");
    const bool digit_lost = cut.ends_with(",2") || cut.ends_with(",4");
    EXPECT_EQ(recording.has_value(), whole || digit_lost) << cut;
  }
}

TEST_F(ImportCsvTrials, ReadsOrRefusesWhateverBitIsTurned) {
  plan_.trials.time = {"t"};
  const std::string text = "t,a,b\n0,11,-2.5\n1,33,4e1\n";
  std::size_t read = 0;
  for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
    std::string turned = text;
    turned[bit / 8] = static_cast<char>(turned[bit / 8] ^ (1 << bit % 8));
    const std::string file = folder_.with("x_1.csv", turned);
    const auto recording = import();
    read += recording.has_value();
    if (recording) {
      EXPECT_TRUE(validate(*recording)) << turned;
    } else {
      EXPECT_EQ(recording.error().kind, ErrorKind::kData) << turned;
      EXPECT_TRUE(recording.error().where.starts_with(file)) << turned;
    }
  }
  EXPECT_GT(read, 0U);  // another digit is a number too
  EXPECT_LT(read, 8 * text.size() / 2);
}

// Random tables with holes, written plainly, come back to the bit.
TEST_F(ImportCsvTrials, ReadsBackRandomTables) {
  Random random(5);
  plan_.trials.missing = MissingValues::kMask;
  for (int round = 0; round < 50; ++round) {
    const std::size_t columns = 1 + random.below(5);
    const std::size_t rows = 1 + random.below(20);
    Channel expected{"touch", "", {}, Matrix<float>(rows, columns), {}};
    Matrix<std::uint8_t> valid(rows, columns, 1);
    std::string text;
    for (std::size_t c = 0; c < columns; ++c) {
      expected.element_names.push_back(fmt::format("c{}", c + 1));
      text += (c > 0 ? ";" : "") + expected.element_names.back();
    }
    bool holes = false;
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < columns; ++c) {
        const bool hole = random.below(8) == 0;
        holes = holes || hole;
        valid(r, c) = hole ? 0 : 1;
        if (!hole) expected.frames(r, c) = static_cast<float>(2000.0 * random.uniform() - 1000.0);
        text += (c > 0 ? ";" : "\n") + (hole ? "NA" : fmt::format("{}", expected.frames(r, c)));
      }
    }
    if (holes) expected.valid = valid;
    plan_.channels = {channel_of("touch", {fmt::format("c1..c{}", columns)})};
    EXPECT_EQ(read(text).channels, std::vector<Channel>{expected}) << text;
  }
}

}  // namespace
}  // namespace somato
