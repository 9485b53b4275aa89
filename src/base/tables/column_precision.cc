#include "base/tables/column_precision.h"

#include <fmt/format.h>

#include <cmath>

#include "base/text/text.h"

namespace somato {

// Mean and squares as Welford updates them: the numbers may be large, and their differences small.
void ColumnPrecision::take(std::size_t column, double exact, float kept) {
  if (column >= columns_.size()) columns_.resize(column + 1);
  Column& of = columns_[column];
  of.count += 1.0;
  const double difference = exact - of.mean;
  of.mean += difference / of.count;
  of.squares += difference * (exact - of.mean);
  const double lost = exact - double{kept};
  of.lost += lost * lost;
  of.example = exact;
}

Result<void> ColumnPrecision::check(const std::vector<std::string>& names,
                                    std::string_view where) const {
  constexpr double kTolerated = 1.0 / 20;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    if (column.lost <= kTolerated * kTolerated * column.squares || column.squares <= 0.0) continue;
    const std::string name = i < names.size() ? fmt::format(" ({})", shown(names[i])) : "";
    return fail(
        ErrorKind::kData,
        fmt::format("column {}{} loses precision: 32-bit numbers near {} are {:g} apart, "
                    "and its standard deviation is {:g}",
                    i + 1, name, column.example,
                    std::nextafter(std::fabs(static_cast<float>(column.example)), INFINITY) -
                        std::fabs(static_cast<float>(column.example)),
                    std::sqrt(column.squares / column.count)),
        std::string(where), "subtract an offset from it, or leave it out");
  }
  return {};
}

}  // namespace somato
