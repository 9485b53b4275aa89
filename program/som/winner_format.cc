#include "som/winner_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "base/core/threads.h"
#include "base/text/value_json.h"
#include "somato/files/csv.h"

namespace somato::program {
namespace {

// Longer than a row with a short label.
constexpr std::size_t kBytesOfRow = 48;
constexpr std::size_t kBytesOfJsonRow = 128;

std::string json_text(const Value& value) {
  return to_json_value(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

WinnerFormat::WinnerFormat(const SomModel& model, bool is_json) : model_(model), is_json_(is_json) {
  for (const std::string& name : model.classes) {
    labels_.push_back(is_json ? fmt::format(",\n  \"label\": {}", json_text(Value{name}))
                              : "," + csv_field(name));
  }
}

std::string WinnerFormat::begin() const {
  if (is_json_) return "[";
  return fmt::format("sample,winner,row,column,distance{}\n", labels_.empty() ? "" : ",label");
}

std::vector<std::string> WinnerFormat::rows(const SampleReadings& readings, std::size_t first,
                                            std::size_t threads) const {
  const std::size_t count = readings.winners.size();
  const std::size_t parts = std::min(threads, count);
  std::vector<std::string> texts(parts);
  for_each_range(parts, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part) {
      const std::size_t last = count * (part + 1) / parts;
      std::size_t i = count * part / parts;
      texts[part].reserve((last - i) * (is_json_ ? kBytesOfJsonRow : kBytesOfRow));
      for (; i < last; ++i) append(readings, i, first + i + 1, texts[part]);
    }
  });
  return texts;
}

// `number` is that of the row, from 1.
void WinnerFormat::append(const SampleReadings& readings, std::size_t i, std::size_t number,
                          std::string& text) const {
  const Grid& grid = model_.som.grid();
  const std::size_t winner = readings.winners[i].first;
  const std::size_t row = grid.row_of(winner);
  const std::size_t column = grid.column_of(winner);
  std::string_view label;
  if (!labels_.empty()) label = labels_[*model_.labels[readings.nearest[i]]];
  if (is_json_) {
    fmt::format_to(std::back_inserter(text),
                   "{}{{\n  \"sample\": {},\n  \"winner\": {},\n  \"row\": {},\n  \"column\": {},\n"
                   "  \"distance\": {}{}\n}}",
                   number == 1 ? "\n" : ",\n", number, winner, row, column,
                   json_text(Value{readings.distances[i]}), label);
  } else {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{:.9g}{}\n", number, winner, row, column,
                   readings.distances[i], label);
  }
}

std::string WinnerFormat::end() const {
  return is_json_ ? "\n]\n" : "";
}

}  // namespace somato::program
