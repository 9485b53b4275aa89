#include "base/tables/column_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/text.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// Shares of the deviation that rounding may change. Above the second, a map whose neurons are a few
// hundredths of the deviation apart moves them by visible steps.
constexpr double kTolerated = 1.0 / 20;
constexpr double kNoted = 1.0 / 1000;

ColumnPrecision::ColumnText text_of_columns(const std::vector<std::string>& names) {
  return [&names](std::size_t column) {
    const std::string name =
        column < names.size() ? fmt::format(" ({})", shown(names[column])) : std::string();
    return fmt::format("column {}{}", column + 1, name);
  };
}

}  // namespace

ColumnPrecision::Column& ColumnPrecision::at(std::size_t column) {
  if (column >= columns_.size()) columns_.resize(column + 1);
  return columns_[column];
}

// Mean and squares as Welford updates them: the numbers may be large, and their differences small.
// A number that no float holds is refused for that reason by those who use it.
void ColumnPrecision::take(std::size_t column, double exact, float kept) {
  if (!std::isfinite(kept)) return;
  Column& of = at(column);
  of.count += 1.0;
  const double difference = exact - of.mean;
  of.mean += difference / of.count;
  of.squares += difference * (exact - of.mean);
  const double lost = exact - double{kept};
  of.lost += lost * lost;
  if (lost != 0.0) of.example = exact;
}

// Chan, Golub and LeVeque, "Algorithms for computing the sample variance", 1983, for a second part
// without deviation.
void ColumnPrecision::take_zeros(std::size_t column, std::size_t count) {
  Column& of = at(column);
  const auto zeros = static_cast<double>(count);
  if (zeros == 0.0) return;
  of.squares += of.mean * of.mean * of.count * zeros / (of.count + zeros);
  of.mean *= of.count / (of.count + zeros);
  of.count += zeros;
}

double ColumnPrecision::deviation(std::size_t column) const {
  const Column& of = columns_[column];
  const double known = column < scales_.size() ? scales_[column].deviation : 0.0;
  return of.count > 0.0 ? std::max(std::sqrt(of.squares / of.count), known) : known;
}

bool ColumnPrecision::loses(std::size_t column, double tolerated) const {
  const Column& of = columns_[column];
  const double most = tolerated * deviation(column);
  return most > 0.0 && of.lost > most * most * of.count;
}

std::string ColumnPrecision::distance_of_floats(std::size_t column) const {
  const double example = columns_[column].example;
  const float near = std::fabs(static_cast<float>(example));
  return fmt::format("32-bit numbers near {} are {:g} apart, and its standard deviation is {:g}",
                     example, std::nextafter(near, INFINITY) - near, deviation(column));
}

Result<void> ColumnPrecision::check_as(const ColumnText& text, std::string_view where) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!loses(i, kTolerated)) continue;
    return fail(
        ErrorKind::kData, fmt::format("{} loses precision: {}", text(i), distance_of_floats(i)),
        std::string(where), "subtract an offset from it, standardize the table, or leave it out");
  }
  return {};
}

Result<void> ColumnPrecision::check(const std::vector<std::string>& names,
                                    std::string_view where) const {
  return check_as(text_of_columns(names), where);
}

std::vector<std::string> ColumnPrecision::notes_as(const ColumnText& text) const {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!loses(i, kNoted)) continue;
    notes.push_back(fmt::format("{} is rounded: {}", text(i), distance_of_floats(i)));
  }
  return notes;
}

std::vector<std::string> ColumnPrecision::notes(const std::vector<std::string>& names) const {
  return notes_as(text_of_columns(names));
}

std::vector<double> ColumnPrecision::statistics() const {
  std::vector<double> all;
  for (const Column& of : columns_) {
    all.insert(all.end(), {of.count, of.mean, of.squares, of.lost, of.example});
  }
  return all;
}

ColumnPrecision ColumnPrecision::with(const std::vector<double>& statistics) {
  constexpr std::size_t kOfColumn = 5;
  require(statistics.size() % kOfColumn == 0, "a column has five statistics");
  ColumnPrecision made;
  for (std::size_t i = 0; i < statistics.size(); i += kOfColumn) {
    made.columns_.push_back({statistics[i], statistics[i + 1], statistics[i + 2], statistics[i + 3],
                             statistics[i + 4]});
  }
  return made;
}

std::vector<double> ColumnPrecision::deviations() const {
  std::vector<double> deviations;
  deviations.reserve(columns_.size());
  for (const Column& column : columns_) {
    deviations.push_back(column.count > 0.0 ? std::sqrt(column.squares / column.count) : 0.0);
  }
  return deviations;
}

}  // namespace somato
