#pragma once

#include <cstddef>
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

/// Which files hold the trials, and what is the same for all their channels: the table [import].
struct CsvTrials {
  std::string files;  ///< Such as "{fabric}_F{force:number}_{trial:number}.csv".
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
  std::vector<std::string> columns;  ///< Names, and ranges such as "taxel1..taxel16".
  std::vector<std::size_t> shape;
  std::string from_label;
  double factor = 1.0;
  bool absolute = false;

  static const Declarations<CsvChannel>& declarations();
};

/// How a folder of CSV files, one a trial, becomes a recording.
struct CsvImport {
  CsvTrials trials;
  std::vector<CsvChannel> channels;
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

/// Checks what the description says by itself. Errors (kUsage) name the key: a pattern without
/// labels or that cannot be read, both time and rate, no channels, two channels of one name, a
/// channel with neither columns nor label or with both, a column used twice, a wrong range, a shape
/// that the columns do not fill.
Result<void> check_csv_import(const CsvImport& description);

/// Reads a description from its tables [import] and [[channel]] and checks it. Errors (kUsage) with
/// their place: also unknown keys (with the nearest known one) and values out of range.
Result<CsvImport> read_csv_import(const Table& file);

/// The columns that a list of names and ranges means: "a", "b1..b3" are a, b1, b2, b3. A range
/// counts up, keeping leading zeros: "b08..b11". Errors (kUsage): a range whose ends do not differ
/// in a number at their end alone, that counts down, or of more than 100,000 columns.
Result<std::vector<std::string>> expand_columns(const std::vector<std::string>& columns);

}  // namespace somato
