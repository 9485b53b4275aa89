#include "recordings/tables/csv_times.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/tables/csv_number.h"
#include "base/text/flag_hint.h"
#include "base/text/iso_time.h"
#include "base/text/text.h"

namespace somato {
namespace {

constexpr std::pair<TimeUnit, double> kUnitsPerSecond[] = {{TimeUnit::kSeconds, 1.0},
                                                           {TimeUnit::kMilliseconds, 1e3},
                                                           {TimeUnit::kMicroseconds, 1e6},
                                                           {TimeUnit::kNanoseconds, 1e9},
                                                           {TimeUnit::kIso, 1.0}};

double units_per_second(TimeUnit unit) {
  for (const auto& [known, units] : kUnitsPerSecond) {
    if (known == unit) return units;
  }
  return 1.0;
}

// The unit in which `number` is a time between 2000 and 2100, if any.
std::optional<TimeUnit> unit_of_epoch(double number) {
  for (const auto& [unit, units] : kUnitsPerSecond) {
    if (number / units >= kYear2000 && number / units <= kYear2100) return unit;
  }
  return std::nullopt;
}

std::string with_unit(const std::string& unit) {
  return fmt::format("import with time_unit = \"{}\"{}", unit, flag_hint("time-unit", unit));
}

}  // namespace

std::string CsvTimes::text() const {
  std::string text = fields_.front()->text;
  for (std::size_t i = 1; i < fields_.size(); ++i) text += "T" + fields_[i]->text;
  return text;
}

std::string CsvTimes::how_to_convert() const {
  std::vector<std::string> columns;
  columns.reserve(trials_.time.size());
  for (const std::string& name : trials_.time)
    columns.push_back(fmt::format("frame[{}]", shown(name)));
  return fmt::format(
      "convert the {} with pandas: {} = pandas.to_datetime({}, "
      "dayfirst=True).map(pandas.Timestamp.isoformat), and import {} with time_unit = \"iso\"{}",
      columns.size() == 1 ? "column, for example" : "two columns into one, for example",
      columns.front(), fmt::join(columns, " + ' ' + "), shown(trials_.time.front()),
      flag_hint("time-unit", "iso"));
}

std::string CsvTimes::names() const {
  std::vector<std::string> names;
  names.reserve(trials_.time.size());
  for (const std::string& name : trials_.time) names.push_back(shown(name));
  return fmt::format("{} {}", names.size() == 1 ? "column" : "columns", fmt::join(names, " and "));
}

tl::unexpected<Error> CsvTimes::refuse(std::string what, std::string advice) const {
  return fail(ErrorKind::kData, std::move(what), records_.place(*fields_.front()),
              std::move(advice));
}

Result<CsvTimes::Time> CsvTimes::read() {
  return trials_.time_unit == TimeUnit::kIso ? read_iso() : read_number();
}

Result<CsvTimes::Time> CsvTimes::read_number() {
  const std::string& field = fields_.front()->text;
  const auto [meaning, number] = read_csv_number<double>(field, trials_.decimal);
  if (meaning == CsvMeaning::kMissing) {
    return refuse(fmt::format("the time in {} is missing", names()),
                  "write the time, or remove the row");
  }
  if (meaning == CsvMeaning::kText) {
    const std::string decimals = decimal_advice(field, trials_.decimal);
    const std::string advice = read_iso_time(field) ? with_unit("iso") : how_to_convert();
    return refuse(fmt::format("{} in {} is not a time in {}", shown(field), names(),
                              choice_name(trials_.time_unit)),
                  decimals.empty() ? advice : decimals);
  }
  if (meaning != CsvMeaning::kNumber) {
    return refuse(fmt::format("{} in {} is not a finite number", shown(field), names()),
                  "correct the time, or remove the row");
  }
  SOMATO_TRY_VOID(check_unit(number));
  return Time{0, number};
}

// A time beyond 2100 is most probably one of the epoch in a smaller unit.
Result<void> CsvTimes::check_unit(double number) const {
  if (number / units_per_second(trials_.time_unit) <= kYear2100) return {};
  const auto unit = unit_of_epoch(number);
  if (!unit) return {};
  return refuse(fmt::format("{} in {} is a time after the year 2100 in the unit {}", shown(text()),
                            names(), choice_name(trials_.time_unit)),
                with_unit(choice_name(*unit)));
}

Result<CsvTimes::Time> CsvTimes::read_iso() {
  const auto time = read_iso_time(text());
  if (!time || (fields_.size() > 1 && !time->has_date)) {
    const bool is_number =
        read_csv_number<double>(text(), trials_.decimal).meaning == CsvMeaning::kNumber;
    return refuse(fmt::format("{} in {} is not a time in ISO 8601", shown(text()), names()),
                  is_number ? "import with the unit of the numbers, s, ms, us or ns" +
                                  flag_hint("time-unit", "s")
                            : fmt::format("such as 2025-04-17T17:00:08.25; {}", how_to_convert()));
  }
  if (time->has_date != has_date_.value_or(time->has_date) ||
      time->has_zone != has_zone_.value_or(time->has_zone)) {
    const bool is_date = time->has_date != *has_date_;
    return refuse(fmt::format("{} in {} has {} {}, unlike the times before it", shown(text()),
                              names(), (is_date ? time->has_date : time->has_zone) ? "a" : "no",
                              is_date ? "date" : "time zone"),
                  "write all times in the same form");
  }
  has_date_ = time->has_date;
  has_zone_ = time->has_zone;
  return Time{time->seconds, time->fraction};
}

Result<void> CsvTimes::end_row(bool begins_exploration) {
  if (fields_.empty()) return {};
  SOMATO_TRY(const Time time, read());
  if (begins_exploration) first_ = time;
  const double units = units_per_second(trials_.time_unit);
  const double seconds =
      static_cast<double>(time.seconds - first_.seconds) + (time.rest - first_.rest) / units;
  if (!begins_exploration && seconds < seconds_.back()) {
    const bool is_midnight = has_date_.has_value() && !*has_date_;
    return refuse(
        fmt::format("the time decreases: {} in {} follows a later time", shown(text()), names()),
        is_midnight ? "after midnight times of day need the column of the date as the first of "
                      "two columns of the time" +
                          flag_hint("time", "Date,Time")
                    : "repair or remove the file");
  }
  is_constant_ = is_constant_ && seconds == 0.0;
  has_long_exploration_ = has_long_exploration_ || !begins_exploration;
  seconds_.push_back(seconds);
  if (has_date_.value_or(true)) {
    clock_times_.take(
        static_cast<double>(time.seconds) + time.rest / units, [&] { return text(); },
        [&] { return records_.place(*fields_.front()); });
  }
  return {};
}

Result<void> CsvTimes::check() const {
  return clock_times_.check(names());
}

CsvClock CsvTimes::clock() const {
  return {!seconds_.empty() && has_date_.value_or(true), clock_times_.holds_epoch(),
          is_constant_ && has_long_exploration_};
}

}  // namespace somato
