#include "systems/signals/missing_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "somato/core/check.h"
#include "somato/core/matrix.h"

namespace somato {
namespace {

bool is_complete(std::span<const float> row) {
  return std::none_of(row.begin(), row.end(), [](float value) { return std::isnan(value); });
}

// The columns with a known value in a row, and the divisors of their differences.
struct KnownColumns {
  std::vector<std::size_t> columns;
  std::vector<double> factors;

  KnownColumns(std::span<const float> row, std::span<const double> scale) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (std::isnan(row[column]) || (!scale.empty() && scale[column] == 0.0)) continue;
      columns.push_back(column);
      factors.push_back(scale.empty() ? 1.0 : scale[column]);
    }
  }

  // Squared, or something above `enough` once that is reached.
  double distance(std::span<const float> a, std::span<const float> b, double enough) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < columns.size() && sum <= enough; ++i) {
      const double difference = (double{a[columns[i]]} - double{b[columns[i]]}) / factors[i];
      sum = std::fma(difference, difference, sum);
    }
    return sum;
  }
};

std::size_t nearest_complete(const Matrix<float>& rows, const std::vector<std::size_t>& complete,
                             std::span<const float> row, std::span<const double> scale) {
  const KnownColumns known(row, scale);
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = complete[0];
  for (const std::size_t candidate : complete) {
    const double distance = known.distance(row, rows.row(candidate), least);
    if (distance >= least) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

void fill_row(std::span<float> row, std::span<const float> from) {
  for (std::size_t column = 0; column < row.size(); ++column) {
    if (std::isnan(row[column])) row[column] = from[column];
  }
}

}  // namespace

const std::vector<std::pair<MissingFill, std::string>>& Choices<MissingFill>::all() {
  static const std::vector<std::pair<MissingFill, std::string>> kAll{
      {MissingFill::kRefuse, "refuse"},
      {MissingFill::kMean, "mean"},
      {MissingFill::kNearest, "nearest"},
      {MissingFill::kLeaveOut, "leave_out"}};
  return kAll;
}

Samples filled_with(std::span<const double> values, const Samples& samples) {
  require(values.size() == samples.size(), "missing values need one value for each column");
  Matrix<float> rows(samples.count(), samples.size());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const std::span<float> row = rows.row(i);
    write_dense(samples[i], row);
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (std::isnan(row[column])) row[column] = static_cast<float>(values[column]);
    }
  }
  return Samples(std::move(rows));
}

std::vector<double> known_deviations(const Samples& samples, std::span<const double> means) {
  std::vector<float> row(samples.size());
  std::vector<double> squares(means.size(), 0.0);
  std::vector<double> known(means.size(), 0.0);
  for (std::size_t i = 0; i < samples.count(); ++i) {
    write_dense(samples[i], row);
    for (std::size_t column = 0; column < means.size(); ++column) {
      if (std::isnan(row[column])) continue;
      const double difference = double{row[column]} - means[column];
      squares[column] = std::fma(difference, difference, squares[column]);
      known[column] += 1.0;
    }
  }
  for (std::size_t column = 0; column < means.size(); ++column) {
    squares[column] = std::sqrt(squares[column] / known[column]);
  }
  return squares;
}

Result<Samples> filled_from_nearest(const Samples& samples, std::span<const double> scale,
                                    const Progress& progress) {
  require(scale.empty() || scale.size() == samples.size(), "a scale has one entry for each column");
  Matrix<float> rows(samples.count(), samples.size());
  std::vector<std::size_t> complete;
  std::vector<std::size_t> incomplete;
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    write_dense(samples[i], rows.row(i));
    (is_complete(rows.row(i)) ? complete : incomplete).push_back(i);
  }
  if (complete.empty()) {
    return fail(ErrorKind::kData,
                "no row is complete, so missing values cannot be filled from the nearest row", {},
                "use the means of the columns, or leave columns out");
  }
  for (std::size_t done = 0; done < incomplete.size(); ++done) {
    const std::span<float> row = rows.row(incomplete[done]);
    fill_row(row, rows.row(nearest_complete(rows, complete, row, scale)));
    if (progress && !progress(done + 1, incomplete.size())) {
      return fail(ErrorKind::kInterrupted, "filling missing values was interrupted");
    }
  }
  return Samples(std::move(rows));
}

}  // namespace somato
