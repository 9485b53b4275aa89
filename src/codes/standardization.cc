#include "somato/codes/standardization.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "somato/core/check.h"
#include "somato/core/matrix.h"

namespace somato {
namespace {

Matrix<float> dense_rows(const Samples& samples) {
  Matrix<float> rows(samples.count(), samples.size());
  for (std::size_t i = 0; i < samples.count(); ++i) write_dense(samples[i], rows.row(i));
  return rows;
}

std::string column_text(std::size_t column, const std::vector<std::string>& names) {
  if (names.empty()) return fmt::format("column {}", column + 1);
  return fmt::format("column {} ('{}')", column + 1, names[column]);
}

// Row by row, as they lie in memory: the sum of each column.
std::vector<double> column_means(const Matrix<float>& rows) {
  std::vector<double> means(rows.columns());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const auto row = rows.row(i);
    for (std::size_t column = 0; column < means.size(); ++column) {
      means[column] += double{row[column]};
    }
  }
  for (double& mean : means) mean /= static_cast<double>(rows.rows());
  return means;
}

std::vector<double> column_deviations(const Matrix<float>& rows, const std::vector<double>& means) {
  std::vector<double> deviations(rows.columns());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const auto row = rows.row(i);
    for (std::size_t column = 0; column < means.size(); ++column) {
      const double difference = double{row[column]} - means[column];
      deviations[column] = std::fma(difference, difference, deviations[column]);
    }
  }
  for (double& deviation : deviations) {
    deviation = std::sqrt(deviation / static_cast<double>(rows.rows()));
  }
  return deviations;
}

Result<void> check_finite(const Matrix<float>& rows, std::size_t column,
                          const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    if (std::isfinite(rows(i, column))) continue;
    return fail(
        ErrorKind::kData,
        fmt::format("sample {} holds {} in {}", i + 1, rows(i, column), column_text(column, names)),
        {}, "leave the sample out, or repair it");
  }
  return {};
}

// A flag a column.
std::vector<char> constant_columns(const Matrix<float>& rows) {
  std::vector<char> constant(rows.columns(), 1);
  const auto first = rows.row(0);
  for (std::size_t i = 1; i < rows.rows(); ++i) {
    const auto row = rows.row(i);
    for (std::size_t column = 0; column < constant.size(); ++column) {
      if (row[column] != first[column]) constant[column] = 0;
    }
  }
  return constant;
}

bool all_finite(const Matrix<float>& rows) {
  return std::all_of(rows.values().begin(), rows.values().end(),
                     [](float value) { return std::isfinite(value); });
}

Error constant_column(const Matrix<float>& rows, std::size_t column,
                      const std::vector<std::string>& names) {
  return {ErrorKind::kData,
          fmt::format("{} is {} in all {} training samples, so it cannot be standardized",
                      column_text(column, names), rows(0, column), rows.rows()),
          {},
          "leave the column out, or set constant_columns = \"zero\""};
}

}  // namespace

const std::vector<std::pair<ConstantColumns, std::string>>& Choices<ConstantColumns>::all() {
  static const std::vector<std::pair<ConstantColumns, std::string>> kAll{
      {ConstantColumns::kRefuse, "refuse"}, {ConstantColumns::kZero, "zero"}};
  return kAll;
}

const Declarations<StandardizationParameters>& StandardizationParameters::declarations() {
  using P = StandardizationParameters;
  static const Declarations<P> kAll = Declarations<P>().add(
      "constant_columns", [](P& p) -> ConstantColumns& { return p.constant_columns; }, "",
      Range::any(),
      "What happens to a column that never changes in the training samples: it is an error, or it "
      "becomes 0. Not given in the paper.");
  return kAll;
}

Result<Standardization> Standardization::fit(const Samples& samples,
                                             const StandardizationParameters& parameters,
                                             const std::vector<std::string>& column_names) {
  require(column_names.empty() || column_names.size() == samples.size(),
          "a standardization needs one name for each column, or none");
  if (samples.count() < 2) {
    return fail(
        ErrorKind::kData,
        fmt::format("a standardization needs at least 2 training samples, not {}", samples.count()),
        {}, "record more, or train without standardization");
  }
  const Matrix<float> rows = dense_rows(samples);
  const std::vector<char> constant = constant_columns(rows);
  const bool finite = all_finite(rows);
  for (std::size_t column = 0; column < rows.columns(); ++column) {
    Result<void> checked = finite ? Result<void>() : check_finite(rows, column, column_names);
    if (!checked) return fail(std::move(checked.error()));
    if (constant[column] != 0 && parameters.constant_columns == ConstantColumns::kRefuse) {
      return fail(constant_column(rows, column, column_names));
    }
  }
  Standardization fitted{column_means(rows), {}};
  fitted.deviations = column_deviations(rows, fitted.means);
  for (std::size_t column = 0; column < rows.columns(); ++column) {
    if (constant[column] != 0) fitted.deviations[column] = 0.0;
  }
  return fitted;
}

void Standardization::apply(const SignalView& sample, std::span<float> out) const {
  require(sample.size == means.size(), "a standardization was fitted to another number of columns");
  write_dense(sample, out);
  for (std::size_t column = 0; column < out.size(); ++column) {
    const double deviation = deviations[column];
    out[column] = deviation == 0.0
                      ? 0.0F
                      : static_cast<float>((double{out[column]} - means[column]) / deviation);
  }
}

Samples Standardization::apply(const Samples& samples) const {
  Matrix<float> rows(samples.count(), samples.size());
  for (std::size_t i = 0; i < samples.count(); ++i) apply(samples[i], rows.row(i));
  return Samples(std::move(rows));
}

}  // namespace somato
