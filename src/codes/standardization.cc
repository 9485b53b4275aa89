#include "somato/codes/standardization.h"

#include <fmt/format.h>

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

double column_mean(const Matrix<float>& rows, std::size_t column) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.rows(); ++i) sum += double{rows(i, column)};
  return sum / static_cast<double>(rows.rows());
}

double column_deviation(const Matrix<float>& rows, std::size_t column, double mean) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const double difference = double{rows(i, column)} - mean;
    sum = std::fma(difference, difference, sum);
  }
  return std::sqrt(sum / static_cast<double>(rows.rows()));
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

bool is_constant(const Matrix<float>& rows, std::size_t column) {
  for (std::size_t i = 1; i < rows.rows(); ++i) {
    if (rows(i, column) != rows(0, column)) return false;
  }
  return true;
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
  Standardization fitted;
  for (std::size_t column = 0; column < rows.columns(); ++column) {
    Result<void> finite = check_finite(rows, column, column_names);
    if (!finite) return fail(std::move(finite.error()));
    const bool constant = is_constant(rows, column);
    if (constant && parameters.constant_columns == ConstantColumns::kRefuse) {
      return fail(constant_column(rows, column, column_names));
    }
    fitted.means.push_back(column_mean(rows, column));
    fitted.deviations.push_back(constant ? 0.0
                                         : column_deviation(rows, column, fitted.means.back()));
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
