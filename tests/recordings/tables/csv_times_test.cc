#include "recordings/tables/csv_times.h"

#include <gtest/gtest.h>

#include "base/support/temporary_folder.h"
#include "recordings/support/csv_channel.h"

namespace somato {
namespace {

// Imports of one file with the channel a.
class CsvTimesOfAFile : public ::testing::Test {
 protected:
  CsvTimesOfAFile() {
    plan_.trials.files = "{trial}.csv";
    plan_.trials.time = {"t"};
    plan_.channels = {channel_of("touch", {"a"})};
  }

  Result<Recording> import(const std::string& text) {
    folder_.with("x.csv", text);
    return import_csv_trials(folder_.path(), plan_, &report_);
  }

  std::vector<double> times(const std::string& text) {
    const auto recording = import(text);
    EXPECT_TRUE(recording) << to_string(recording.error());
    return recording ? recording->explorations[0].channels[0].times : std::vector<double>();
  }

  std::string refusal(const std::string& text) {
    const auto recording = import(text);
    if (recording) return "none";
    const std::string error = to_string(recording.error());
    return error.starts_with(folder_.path()) ? error.substr(folder_.path().size() + 1) : error;
  }

  void expect_refused(const std::string& text, const std::vector<std::string>& says) {
    const std::string refused = refusal(text);
    for (const std::string& part : says) {
      EXPECT_NE(refused.find(part), std::string::npos) << part << " is not in " << refused;
    }
  }

  TemporaryFolder folder_;
  CsvImport plan_;
  CsvImportReport report_;
};

TEST_F(CsvTimesOfAFile, AreReadInIso8601) {
  plan_.trials.time_unit = TimeUnit::kIso;
  const std::vector<double> expected{0, 0.25, 60};
  for (const char* text :
       {"t,a\n2025-04-17T17:00:08.00,1\n2025-04-17T17:00:08.25,2\n2025-04-17T17:01:08,3\n",
        "t,a\n2025-04-17 17:00:08.5Z,1\n2025-04-17 19:00:08.75+02:00,2\n2025-04-17 17:01:08.5Z,3\n",
        "t;a\n2025-04-17T23:59:30,5;1\n2025-04-17T23:59:30,75;2\n2025-04-18T00:00:30,5;3\n",
        "t,a\n20250417T170008,1\n20250417T170008.25,2\n20250417T170108,3\n",
        "t,a\n10:30:25,1\n10:30:25.25,2\n10:31:25,3\n",
        "sep=;\nt;a\n2025-04-17 17:00:08;1\n2025-04-17 17:00:08.25;2\n2025-04-17 17:01:08;3\n"}) {
    EXPECT_EQ(times(text), expected) << text;
  }
}

TEST_F(CsvTimesOfAFile, KeepNanosecondsOfTheEpoch) {
  plan_.trials.time_unit = TimeUnit::kIso;
  EXPECT_EQ(times("t,a\n2025-04-17T17:00:08Z,1\n2025-04-17T17:00:08.000000001Z,2\n")[1], 1e-9);
}

TEST_F(CsvTimesOfAFile, MayBeInTwoColumns) {
  plan_.trials.time = {"Date", "Time"};
  plan_.trials.time_unit = TimeUnit::kIso;
  EXPECT_EQ(times("a,Time,Date\n1,23:59:59.5,2026-01-01\n2,00:00:00,2026-01-02\n"),
            (std::vector<double>{0, 0.5}));
  expect_refused("Date,Time,a\n2026-01-01,10:30,1\n2026-01-02,,2\n",
                 {"x.csv:3:1: '2026-01-02T' in columns 'Date' and 'Time' is not a time"});
  expect_refused("Date,Time,a\n,10:30,1\n", {"x.csv:2:1: 'T10:30' in columns"});
  plan_.trials.time_unit = TimeUnit::kSeconds;
  expect_refused("Date,Time,a\n1,2,3\n", {"'time' has two columns", "time_unit = \"iso\""});
}

TEST_F(CsvTimesOfAFile, MustHaveOneForm) {
  plan_.trials.time_unit = TimeUnit::kIso;
  expect_refused("t,a\n2025-04-17T17:00Z,1\n2025-04-17T18:00,2\n",
                 {"x.csv:3:1: '2025-04-17T18:00' in column 't' has no time zone, unlike"});
  expect_refused("t,a\n17:00,1\n2025-04-17T18:00,2\n", {"x.csv:3:1: ", "has a date, unlike"});
  expect_refused("t,a\n23:59,1\n00:00,2\n", {"the time decreases", "the column of the date"});
}

TEST_F(CsvTimesOfAFile, AreExplainedWhereTheyAreNoTimes) {
  expect_refused("t,a\n2025-04-17T17:00:08.00,1\n",
                 {"x.csv:2:1: '2025-04-17T17:00:08.00' in column 't' is not a time in s",
                  "time_unit = \"iso\""});
  expect_refused("t,a\n17.04.2025 17:00,1\n", {"is not a time in s", "frame['t'] = pandas"});
  expect_refused("t,a\n,1\n", {"x.csv:2:1: the time in column 't' is missing"});
  expect_refused("t,a\ninf,1\n", {"x.csv:2:1: 'inf' in column 't' is not a finite number"});
  expect_refused("t;a\n0,5;1\n", {"'0,5' in column 't' is not a time in s", "read decimal commas"});
  plan_.trials.missing = MissingValues::kMask;
  expect_refused("t,a\nNA,1\n", {"the time in column 't' is missing", "remove the row"});
  plan_.trials.time_unit = TimeUnit::kIso;
  expect_refused("t,a\n1713373208,1\n",
                 {"is not a time in ISO 8601", "the unit of the numbers, s, ms"});
  expect_refused("t,a\n17/04/2025 17:00,1\n", {"is not a time in ISO 8601", "pandas.to_datetime"});
  for (const std::string text : {"2025-04-17T17:00", "17.04.2025", "1e400", "x"}) {
    EXPECT_EQ(refusal("t,a\n" + text + ",1\n").find("'ignore'"), std::string::npos)
        << "a time cannot be ignored";
  }
  plan_.trials.time = {"d", "t"};
  expect_refused("d,t,a\n2025-04-17,05:00 PM,1\n", {"to_datetime(frame['d'] + ' ' + frame['t'], ",
                                                    "import 'd' with time_unit = \"iso\""});
}

TEST_F(CsvTimesOfAFile, AreRefusedBefore2000BesideLaterOnes) {
  expect_refused("a,t\n1,0\n2,1700000000\n3,1700000001\n",
                 {"x.csv:2:3: 1 of 3 times of column 't' is before the year 2000", "'0'",
                  "'1700000000'", "x.csv:3:3)", "correct these times, or remove them"});
  expect_refused("t,a\n-1,1\n1700000000,2\n", {"before the year 2000, first '-1'"});
  expect_refused("t,a\n1700000000,1\n0,2\n",
                 {"x.csv:3:1: the time decreases: '0' in column 't' follows a later time"});
  plan_.trials.time_unit = TimeUnit::kMilliseconds;
  expect_refused("t,a\n12,1\n1700000000000,2\n", {"before the year 2000, first '12'"});
  plan_.trials.time_unit = TimeUnit::kIso;
  expect_refused("t,a\n1970-01-01T00:00:12,1\n2025-04-17T17:00:08,2\n",
                 {"first '1970-01-01T00:00:12'", "'2025-04-17T17:00:08'"});
  plan_.trials.time_unit = TimeUnit::kSeconds;
  plan_.trials.exploration = "n";
  expect_refused("t,a,n\n1700000000,1,1\n0,2,2\n", {"x.csv:3:1: 1 of 2 times"});
}

TEST_F(CsvTimesOfAFile, AreRefusedInAUnitThatIsTooLarge) {
  expect_refused("t,a\n1700000000000,1\n",
                 {"x.csv:2:1: '1700000000000' in column 't' is a time after the year 2100 in the "
                  "unit s; import with time_unit = \"ms\""});
  expect_refused("t,a\n1700000000000000000,1\n", {"time_unit = \"ns\""});
  EXPECT_EQ(refusal("t,a\n5e9,1\n"), "none") << "no unit makes it a time of the epoch";
  plan_.trials.time_unit = TimeUnit::kMicroseconds;
  EXPECT_EQ(refusal("t,a\n1700000000000000,1\n"), "none");
}

TEST_F(CsvTimesOfAFile, HaveDecimalCommas) {
  plan_.trials.decimal = DecimalMark::kComma;
  EXPECT_EQ(times("t;a\n0,00;1,5\n0,25;2\n"), (std::vector<double>{0, 0.25}));
  expect_refused("t;a\n0.5;1\n", {"'0.5' in column 't' is not a time", "without a point"});
}

TEST_F(CsvTimesOfAFile, AreReportedIfTheyAreConstant) {
  EXPECT_EQ(times("t,a\n7,1\n7,2\n"), (std::vector<double>{0, 0}));
  ASSERT_EQ(report_.warnings.size(), 1U);
  EXPECT_EQ(report_.warnings[0], "the time is the same in all rows of " + folder_.file("x.csv") +
                                     ": import without times, or with a rate");
  for (const char* text : {"t,a\n7,1\n", "t,a\n7,1\n7,2\n8,3\n"}) {
    times(text);
    EXPECT_TRUE(report_.warnings.empty()) << text;
  }
}

TEST_F(CsvTimesOfAFile, AreReportedIfClocksOfFilesDiffer) {
  folder_.with("y.csv", "t,a\n1700000000,1\n1700000001,2\n");
  times("t,a\n5,1\n6,2\n");
  ASSERT_EQ(report_.warnings.size(), 1U);
  EXPECT_EQ(report_.warnings[0],
            "the times of " + folder_.file("x.csv") + " are before the year 2000, those of " +
                folder_.file("y.csv") + " are not: the clock may not have been set");
  times("t,a\n1700000005,1\n1700000006,2\n");
  EXPECT_TRUE(report_.warnings.empty());
}

}  // namespace
}  // namespace somato
