#include "somato/codes/standardization.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "somato/core/check.h"
#include "somato/core/matrix.h"

namespace somato {
namespace {

std::string column_text(std::size_t column, const std::vector<std::string>& names) {
  if (names.empty()) return fmt::format("column {}", column + 1);
  return fmt::format("column {} ('{}')", column + 1, names[column]);
}

// The result of one pass for a column.
struct Column {
  float first = 0.0F;
  bool constant = true;
  double sum = 0.0;
  std::size_t bad_sample = 0;  // The first that is not finite there, from 1; 0: none.
  float bad_value = 0.0F;

  void take(std::size_t sample, float value) {
    if (sample == 1) first = value;
    constant = constant && value == first;
    sum += double{value};
    if (bad_sample > 0 || std::isfinite(value)) return;
    bad_sample = sample;
    bad_value = value;
  }
};

// Calls `take(column, sample, value)` for all values, samples counted from 1; returns how many
// samples there are.
template <typename Take>
Result<std::size_t> for_each_value(SampleSource& samples, const Take& take) {
  std::vector<float> row(samples.size());
  std::size_t sample = 0;
  return for_each_part(samples,
                       [&](const Samples& part) -> Result<void> {
                         for (std::size_t i = 0; i < part.count(); ++i) {
                           write_dense(part[i], row);
                           ++sample;
                           for (std::size_t d = 0; d < row.size(); ++d) take(d, sample, row[d]);
                         }
                         return {};
                       })
      .map([&] { return sample; });
}

Error too_few(std::size_t samples) {
  return {ErrorKind::kData,
          fmt::format("a standardization needs at least 2 training samples, not {}", samples),
          {},
          "record more explorations, or train without standardization"};
}

Error not_finite(const Column& column, const std::string& name) {
  return {ErrorKind::kData,
          fmt::format("sample {} holds {} in {}", column.bad_sample, column.bad_value, name),
          {},
          "leave the sample out, or repair it"};
}

Error constant_column(const Column& column, std::size_t samples, const std::string& name) {
  return {ErrorKind::kData,
          fmt::format("{} is {} in all {} training samples, so it cannot be standardized", name,
                      column.first, samples),
          {},
          "leave the column out, or set constant_columns = \"zero\""};
}

Result<void> check_columns(const std::vector<Column>& columns, std::size_t samples,
                           ConstantColumns constant, const std::vector<std::string>& names) {
  if (samples < 2) return fail(too_few(samples));
  for (std::size_t d = 0; d < columns.size(); ++d) {
    const std::string name = column_text(d, names);
    if (columns[d].bad_sample > 0) return fail(not_finite(columns[d], name));
    if (columns[d].constant && constant == ConstantColumns::kRefuse) {
      return fail(constant_column(columns[d], samples, name));
    }
  }
  return {};
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
      "constant_columns", &P::constant_columns, "", Range::any(),
      "Treatment of a column that is constant in the training samples: an error, or it "
      "becomes 0. Not given in the paper.");
  return kAll;
}

Result<Standardization> Standardization::fit(const Samples& samples,
                                             const StandardizationParameters& parameters,
                                             const std::vector<std::string>& column_names) {
  SamplesInMemory source(samples);
  return fit(source, parameters, column_names);
}

Result<Standardization> Standardization::fit(SampleSource& samples,
                                             const StandardizationParameters& parameters,
                                             const std::vector<std::string>& column_names) {
  require(column_names.empty() || column_names.size() == samples.size(),
          "a standardization needs one name for each column, or none");
  std::vector<Column> columns(samples.size());
  const auto counted = for_each_value(samples, [&](std::size_t d, std::size_t sample, float value) {
    columns[d].take(sample, value);
  });
  if (!counted) return fail(counted.error());
  SOMATO_TRY_VOID(check_columns(columns, *counted, parameters.constant_columns, column_names));
  const auto count = static_cast<double>(*counted);
  Standardization fitted;
  fitted.means.reserve(columns.size());
  for (const Column& column : columns) fitted.means.push_back(column.sum / count);
  fitted.deviations.resize(columns.size());
  const auto again = for_each_value(samples, [&](std::size_t d, std::size_t, float value) {
    const double difference = double{value} - fitted.means[d];
    fitted.deviations[d] = std::fma(difference, difference, fitted.deviations[d]);
  });
  if (!again) return fail(again.error());
  for (std::size_t d = 0; d < columns.size(); ++d) {
    fitted.deviations[d] = columns[d].constant ? 0.0 : std::sqrt(fitted.deviations[d] / count);
  }
  return fitted;
}

std::vector<double> Standardization::offsets() const {
  // Up to here rounding changes a number by at most 3e-5 deviations.
  constexpr double kFar = 1000.0;
  std::vector<double> offsets(means.size(), 0.0);
  for (std::size_t d = 0; d < means.size(); ++d) {
    if (std::fabs(means[d]) > kFar * deviations[d]) offsets[d] = means[d];
  }
  return offsets;
}

Standardization Standardization::without(std::span<const double> offsets) const {
  require(offsets.size() == means.size(), "a standardization needs one offset for each column");
  Standardization moved = *this;
  for (std::size_t d = 0; d < means.size(); ++d) moved.means[d] -= offsets[d];
  return moved;
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
