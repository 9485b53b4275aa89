#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/csv_import.h"

namespace somato {

/// The columns of a description: names and patterns, with expanded ranges.
struct CsvLayout {
  std::vector<std::vector<std::string>> channels;  ///< The columns of each channel.
  std::set<std::string> ignored;                   ///< Names and patterns.
  std::vector<std::string> ignored_patterns;       ///< The patterns among them.
  std::set<std::string> named;  ///< Columns of channels, time, explorations and labels.
};

/// Errors: as expand_columns().
Result<CsvLayout> csv_layout_of(const CsvImport& description);

enum class CsvUse { kNothing, kTime, kExploration, kLabel, kValue };

/// Destination of the fields of a column.
struct CsvColumn {
  CsvUse use = CsvUse::kNothing;
  std::size_t channel = 0;  ///< The channel of a value.
  /// Index of a value; of a label or a time its index among the labels or the times of columns.
  std::size_t element = 0;
};

/// The columns of one file.
struct CsvColumns {
  std::vector<CsvColumn> columns;                  ///< In the order of the file.
  std::vector<std::vector<std::string>> channels;  ///< The columns' names of each channel.
  std::set<std::string> ignored;      ///< Those of the layout's ignored columns that it has.
  std::vector<std::string> others;    ///< Those that are mentioned nowhere.
  std::vector<std::size_t> nameless;  ///< The indices of those among them that have no name.
};

/// Finds the columns of a file whose columns have these `names`. A pattern takes the columns that
/// fit, in the order of the file, except those that are named anywhere or ignored, and those
/// without a name (see is_nameless()), which may be mentioned by number.
/// Errors (without a place): kData for a missing column and a pattern without columns, with the
/// nearest name, and for a column that two channels take; kUsage as check_csv_shape().
Result<CsvColumns> find_csv_columns(const CsvImport& description, const CsvLayout& layout,
                                    const std::vector<std::string>& names);

/// The properties shared by all files: the columns of their channels.
class CsvFilesInCommon {
 public:
  /// Takes the columns of the file `where`; a later file's elements come in the order of the first
  /// file. Errors (kData): other columns than in the first file.
  Result<void> take(CsvColumns& columns, const std::vector<std::string>& names,
                    const std::string& where);

  /// Checks after all files that each had a use. Errors (kData, at `where`): an ignored column or
  /// pattern that was in none.
  Result<void> check_ignored(const CsvLayout& layout, const std::string& where) const;

 private:
  std::string first_file_;
  std::vector<std::string> first_names_;
  std::vector<std::vector<std::string>> channels_;
  std::set<std::string> ignored_;
};

}  // namespace somato
