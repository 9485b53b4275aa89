#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"

namespace somato {

/// What a number in a time column counts.
enum class TimeUnit { kSeconds, kMilliseconds, kMicroseconds, kNanoseconds };

/// What is done with a field that holds no number: an empty one, NaN, NA, null and the like.
enum class MissingValues {
  kRefuse,  ///< It is an error.
  kMask,    ///< Its value is 0, and the channel's mask says that it is not valid.
};

/// What is done with what the description does not mention.
enum class Unmentioned {
  kRefuse,  ///< It is an error, so that nothing is passed over silently.
  kIgnore,  ///< It is passed over.
};

/// What a row of a file is.
enum class CsvRows {
  kFrames,        ///< A frame of the file's exploration, or of one of its windows.
  kExplorations,  ///< An exploration of one frame.
};

/// Which files hold the trials, and what is the same for all their channels: the table [import].
struct CsvTrials {
  std::string files;  ///< Such as "{fabric}_F{force:number}_{trial:number}.csv".
  CsvRows rows = CsvRows::kFrames;
  std::vector<std::string> labels;    ///< Names of columns.
  std::optional<std::size_t> window;  ///< Rows of an exploration; without it: all of the file.
  std::size_t overlap = 0;            ///< Rows that a window shares with the one before it.
  bool header = true;
  std::string time;
  TimeUnit time_unit = TimeUnit::kSeconds;
  double rate = 0.0;
  MissingValues missing = MissingValues::kRefuse;
  std::vector<std::string> ignore;
  Unmentioned other_columns = Unmentioned::kRefuse;
  Unmentioned other_files = Unmentioned::kRefuse;

  static const Declarations<CsvTrials>& declarations();
};

/// One channel, made of columns or of a label: a table [[channel]].
struct CsvChannel {
  std::string name;
  std::string unit;
  std::vector<std::string> columns;  ///< Names, ranges "taxel1..taxel16", patterns "taxel_*".
  std::vector<std::size_t> shape;
  std::string from_label;
  double factor = 1.0;
  bool absolute = false;

  static const Declarations<CsvChannel>& declarations();
};

/// How CSV files become a recording.
struct CsvImport {
  CsvTrials trials;
  std::vector<CsvChannel> channels;
};

template <>
struct Choices<CsvRows> {
  static const std::vector<std::pair<CsvRows, std::string>>& all();
};
template <>
struct Choices<TimeUnit> {
  static const std::vector<std::pair<TimeUnit, std::string>>& all();
};
template <>
struct Choices<MissingValues> {
  static const std::vector<std::pair<MissingValues, std::string>>& all();
};
template <>
struct Choices<Unmentioned> {
  static const std::vector<std::pair<Unmentioned, std::string>>& all();
};

/// Checks what the description says by itself. Errors (kUsage) name the key: no labels, a pattern
/// that cannot be read, both time and rate, an overlap without window or not below it, rows that
/// are explorations with a window, time or rate, two labels of one name, no channels, two channels
/// of one name, a channel with neither columns nor label or with both, a column used twice, a wrong
/// range, a shape that the columns do not fill.
Result<void> check_csv_import(const CsvImport& description);

/// Reads a description from its tables [import] and [[channel]] and checks it. Errors (kUsage) with
/// their place: also unknown keys (with the nearest known one) and values out of range.
Result<CsvImport> read_csv_import(const Table& file);

/// The columns that a list of names and ranges means: "a", "b1..b3" are a, b1, b2, b3. Patterns, in
/// which a star stands for any text, stay as they are. A range counts up, keeping leading zeros:
/// "b08..b11". Errors (kUsage): a range whose ends do not differ in a number at their end alone,
/// that counts down, or of more than 100,000 columns.
Result<std::vector<std::string>> expand_columns(const std::vector<std::string>& columns);

}  // namespace somato
