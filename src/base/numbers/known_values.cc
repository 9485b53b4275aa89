#include "base/numbers/known_values.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace somato {

void KnownValues::begin(std::size_t columns) {
  if (!low_.empty()) return;
  low_.assign(columns, std::numeric_limits<float>::quiet_NaN());
  high_ = low_;
  sums_.assign(columns, 0.0);
  known_.assign(columns, 0);
}

Result<void> KnownValues::take(const Samples& part) {
  begin(part.size());
  std::vector<float> row(part.size());
  for (std::size_t i = 0; i < part.count(); ++i) {
    write_dense(part[i], row);
    SOMATO_TRY_VOID(take(row));
  }
  return {};
}

Result<void> KnownValues::take(std::span<const float> row) {
  begin(row.size());
  ++samples_;
  std::size_t missing = 0;
  for (std::size_t column = 0; column < row.size(); ++column) {
    const float value = row[column];
    if (std::isnan(value)) {
      ++missing;
      continue;
    }
    low_[column] = std::fmin(low_[column], value);
    high_[column] = std::fmax(high_[column], value);
    sums_[column] += double{value};
    ++known_[column];
  }
  missing_ += missing;
  if (missing > 0) ++incomplete_;
  if (missing < row.size()) return {};
  return fail(ErrorKind::kData, fmt::format("row {} has no known value", samples_), {},
              "leave the row out");
}

Result<std::vector<double>> KnownValues::means(const std::vector<std::string>& names) const {
  std::vector<double> means(sums_.size());
  for (std::size_t column = 0; column < means.size(); ++column) {
    if (known_[column] == 0) {
      return fail(ErrorKind::kData,
                  names.empty() ? fmt::format("column {} has no known value", column + 1)
                                : fmt::format("column {} ('{}') has no known value", column + 1,
                                              names[column]),
                  {}, "leave the column out");
    }
    means[column] = sums_[column] / static_cast<double>(known_[column]);
  }
  return means;
}

}  // namespace somato
