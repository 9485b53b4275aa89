#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/core/result.h"
#include "somato/files/csv.h"

namespace somato {

/// Checks the loss of single precision in columns of numbers: times since 1970, for example, are
/// equal within minutes.
class ColumnPrecision {
 public:
  /// The name of a column in a message.
  using ColumnText = std::function<std::string(std::size_t column)>;

  ColumnPrecision() = default;

  /// `scales` are those of columns whose deviation is known before; see check().
  explicit ColumnPrecision(std::vector<ColumnScale> scales) : scales_(std::move(scales)) {}

  /// Adds a number of a column, as it was and as stored.
  void take(std::size_t column, double exact, float kept);

  /// Adds numbers that are 0.
  void take_zeros(std::size_t column, std::size_t count);

  /// Fails (kData) when what rounding changes in a column has a root mean square above a twentieth
  /// of the column's standard deviation, or of the deviation that is known, if that is greater; a
  /// column without deviation keeps all there is. `names` may be empty.
  Result<void> check(const std::vector<std::string>& names, std::string_view where) const;
  Result<void> check_as(const ColumnText& text, std::string_view where) const;

  /// A sentence for each column that passes check() and nevertheless loses more than a thousandth
  /// of that deviation: small differences of a map's weights in it are lost as well.
  std::vector<std::string> notes(const std::vector<std::string>& names) const;
  std::vector<std::string> notes_as(const ColumnText& text) const;

  /// The standard deviation of each column, of the exact numbers.
  std::vector<double> deviations() const;

  /// All statistics as numbers, and the object that has them.
  std::vector<double> statistics() const;
  static ColumnPrecision with(const std::vector<double>& statistics);

  /// The same statistics with other scales.
  void know(std::vector<ColumnScale> scales) { scales_ = std::move(scales); }

 private:
  struct Column {
    double count = 0.0;
    double mean = 0.0;
    double squares = 0.0;  // of the deviations from the mean
    double lost = 0.0;     // squares of what rounding changes
    double example = 0.0;
  };

  Column& at(std::size_t column);
  double deviation(std::size_t column) const;
  bool loses(std::size_t column, double tolerated) const;
  std::string distance_of_floats(std::size_t column) const;

  std::vector<ColumnScale> scales_;
  std::vector<Column> columns_;
};

}  // namespace somato
