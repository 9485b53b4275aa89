#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/tables/csv_records.h"
#include "recordings/explorations/clock_times.h"
#include "somato/core/result.h"
#include "somato/recording/csv_import.h"

namespace somato {

/// Properties of the clock of a file, as its times show.
struct CsvClock {
  bool has_times = false;
  bool is_of_epoch = false;  ///< Whether the times are since 1970; otherwise from another moment.
  bool is_constant = false;  ///< Whether several rows of an exploration all have the same time.
};

/// Reads the times of the rows of a file.
class CsvTimes {
 public:
  /// Both must outlive this object.
  CsvTimes(const CsvTrials& trials, const CsvRecords& records)
      : trials_(trials), records_(records), fields_(trials.time.size()) {}

  /// Takes the field of a column of times, with the index `element` among them, in the current row;
  /// it must not change until the row ends.
  void take(const CsvField& field, std::size_t element) { fields_[element] = &field; }

  /// Ends the row. Errors (kData): fields that are no times, or that have a date or a time zone
  /// which the first row lacks, or the other way round; a time that is before the preceding one of
  /// its exploration.
  Result<void> end_row(bool begins_exploration);

  /// Checks after the last row. Errors (kData): those of ClockTimes::check().
  Result<void> check() const;

  /// Seconds since the first row of the exploration; empty without columns of times.
  const std::vector<double>& seconds() const { return seconds_; }

  CsvClock clock() const;

 private:
  // A time whose parts are subtracted separately, so that its last digits are kept.
  struct Time {
    std::int64_t seconds = 0;
    double rest = 0.0;  // In the unit of the column.
  };

  Result<Time> read();
  Result<Time> read_number();
  Result<Time> read_iso();
  Result<void> check_unit(double number) const;
  tl::unexpected<Error> refuse(std::string what, std::string advice) const;
  std::string text() const;
  std::string names() const;
  std::string how_to_convert() const;

  const CsvTrials& trials_;
  const CsvRecords& records_;
  std::vector<const CsvField*> fields_;  // The fields of the current row.
  std::vector<double> seconds_;
  Time first_;  // The first time of the exploration.
  std::optional<bool> has_date_;
  std::optional<bool> has_zone_;
  ClockTimes clock_times_;
  bool is_constant_ = true;
  bool has_long_exploration_ = false;
};

}  // namespace somato
