#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/files/csv.h"
#include "somato/recording/recording.h"

namespace somato {

/// Unit of the numbers in a time column, or ISO 8601: dates and times of day.
enum class TimeUnit { kSeconds, kMilliseconds, kMicroseconds, kNanoseconds, kIso };

/// Treatment of a field without a number: an empty one, NaN, NA, null and the like.
enum class MissingValues {
  kRefuse,  ///< It is an error.
  kMask,    ///< The value is 0, and the channel's mask marks it as invalid.
};

/// Treatment of columns and files that the description does not mention.
enum class Unmentioned {
  kRefuse,  ///< An error, so that nothing is ignored without notice.
  kIgnore,  ///< They are ignored.
};

/// Treatment of the rows at the end that do not fill a window.
enum class IncompleteWindow {
  kLeaveOut,  ///< They are left out and counted.
  kKeep,      ///< They are a shorter exploration.
};

/// Meaning of a row of a file.
enum class CsvRows {
  kFrames,        ///< A frame of the file's exploration, or of one of its windows.
  kExplorations,  ///< An exploration with one frame.
};

/// The files of the trials, and the settings shared by all their channels: the table [import].
struct CsvTrials {
  std::string files;  ///< Such as "{fabric}_F{force:number}_{trial:number}.csv".
  CsvRows rows = CsvRows::kFrames;
  std::vector<std::string> labels;  ///< Names of columns.
  std::string exploration;          ///< A column; an exploration begins where its value changes.
  std::optional<std::size_t>
      window;               ///< Number of rows of an exploration; without it: all rows of the file.
  std::size_t overlap = 0;  ///< Number of rows that a window shares with the preceding one.
  IncompleteWindow incomplete = IncompleteWindow::kLeaveOut;
  bool header = true;
  DecimalMark decimal = DecimalMark::kPoint;
  std::vector<std::string> time;  ///< A column; or two, with dates and times of day.
  TimeUnit time_unit = TimeUnit::kSeconds;
  double rate = 0.0;
  MissingValues missing = MissingValues::kRefuse;
  std::vector<std::string> ignore;
  Unmentioned other_columns = Unmentioned::kRefuse;
  Unmentioned other_files = Unmentioned::kRefuse;

  static const Declarations<CsvTrials>& declarations();
};

/// One channel, from columns or from a label: a table [[channel]].
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

/// Description of the import of CSV files as a recording.
struct CsvImport {
  CsvTrials trials;
  std::vector<CsvChannel> channels;
};

template <>
struct Choices<IncompleteWindow> {
  static const std::vector<std::pair<IncompleteWindow, std::string>>& all();
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

/// Checks the consistency of the description. Errors (kUsage) name the key: no labels, an invalid
/// pattern, both time and rate, two columns of times without ISO 8601, an overlap without a window
/// or not below it, 'incomplete' without a window, rows that are explorations with a window, time
/// or rate, a column of explorations with a window or such rows, two labels with the same name, no
/// channels, two channels with the same name, a channel with neither columns nor label or with
/// both, a column used twice, an invalid range, a shape that the columns do not fill.
Result<void> check_csv_import(const CsvImport& description);

/// Reads a description from its tables [import] and [[channel]] and checks it. Errors (kUsage) with
/// their location: also unknown keys (with the nearest known one) and values out of range.
Result<CsvImport> read_csv_import(const Table& file);

/// The parts that an import leaves out, and doubts about its data.
struct CsvImportReport {
  std::size_t rows_left_out = 0;      ///< Rows outside of all windows.
  std::size_t files_left_out = 0;     ///< Files without any window.
  std::vector<std::string> warnings;  ///< About times: without a period at their end.
};

/// Reads a folder of CSV files, one per trial, according to `description`; `folder` may also be one
/// file.
///
/// Files with the extension of the pattern are searched in the folder and its subfolders; the
/// pattern is matched with as many final parts of their path as the pattern has. A name that
/// matches in more than one way is refused, and so are, unless the description permits them, names
/// that do not match, columns that are not mentioned and fields without a number.
///
/// Each file, each window, each row or each run of rows with the same value in the column
/// `exploration` is one exploration. The explorations are in natural order of
/// files (trial 2 before trial 10) with the labels of the file name and of their columns, and the
/// path of the file as source. Explorations from divided files have the labels `file`, the path
/// below the folder, and `window` or `row`, which counts from 1 in each file. Windows begin window
/// - overlap rows apart, and restart where a label of a column changes; rows that do not fill a
/// window are left out, or are a shorter one.
///
/// A channel of columns has one frame per row and the columns as names of its elements; a channel
/// from a label has one frame, and neither times nor rate. A pattern includes the columns that
/// match it and that are neither named elsewhere nor ignored, in the order of the first file. Times
/// are seconds since the exploration's first row, in double precision: of nanoseconds since 1970
/// the last two digits are lost.
///
/// The text is as in parse_csv(): any separator, quotation marks, comments, line endings, a byte
/// order mark. A column without a name is (column 3), or its number 3 unless that is a name; no
/// pattern of a channel includes it. Errors: those of check_csv_import(); kSystem for files that
/// cannot be read; kData with file, line and column for deviations from the description, ragged
/// rows, times that decrease, that are the same in all rows or that no clock shows (see
/// ClockTimes), files without rows, labels that are missing or that change in a file that is not
/// divided, patterns without columns or with other columns than in the first file, ignored columns
/// that occur in no file, no window.
Result<Recording> import_csv_trials(const std::filesystem::path& folder,
                                    const CsvImport& description,
                                    CsvImportReport* report = nullptr);

}  // namespace somato
