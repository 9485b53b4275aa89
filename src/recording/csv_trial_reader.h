#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/csv_import.h"
#include "somato/recording/recording.h"

namespace somato {

/// Where the values of a column go.
struct CsvSlot {
  std::size_t channel;
  std::size_t element;
};

/// What a description says of columns, ready to be looked up.
struct CsvLayout {
  std::map<std::string, CsvSlot> slots;
  std::set<std::string> ignored;
  std::vector<std::vector<std::string>> columns;  ///< Of each channel.
};

/// Errors: as expand_columns().
Result<CsvLayout> csv_layout_of(const CsvImport& description);

/// The value of `channel` that a number of a file or its name stands for, or nothing when it is too
/// large.
std::optional<float> csv_value(const CsvChannel& channel, double number);

/// The channels in the text of one file, which is `where`; those made of a label have no frames
/// yet. Errors: as import_csv_trials().
Result<std::vector<Channel>> read_csv_trial(const CsvImport& description, const CsvLayout& layout,
                                            std::string_view text, const std::string& where);

}  // namespace somato
