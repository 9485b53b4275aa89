#include "recordings/tables/csv_windows.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

namespace somato {
namespace {

template <typename T>
Matrix<T> rows_of(const Matrix<T>& all, const CsvWindow& window) {
  const std::span<const T> values = all.values();
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(window.first * all.columns());
  const auto count = static_cast<std::ptrdiff_t>(window.rows * all.columns());
  return Matrix<T>(window.rows, all.columns(), std::vector<T>(first, first + count));
}

std::vector<double> times_of(const std::vector<double>& all, const CsvWindow& window) {
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(window.first);
  std::vector<double> times(first, first + static_cast<std::ptrdiff_t>(window.rows));
  for (double& time : times) time -= *first;
  return times;
}

bool all_valid(const Matrix<std::uint8_t>& valid) {
  return std::all_of(valid.values().begin(), valid.values().end(),
                     [](std::uint8_t mark) { return mark == 1; });
}

}  // namespace

CsvWindows windows_of(const CsvTrials& trials, const std::vector<LabelledRows>& parts) {
  CsvWindows found;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const std::size_t end = parts[p].first + parts[p].rows;
    const std::size_t size =
        trials.rows == CsvRows::kExplorations ? 1 : trials.window.value_or(parts[p].rows);
    std::size_t first = parts[p].first;
    std::size_t covered = first;
    for (; end - first >= size; first += size - trials.overlap) {
      found.windows.push_back({first, size, p});
      covered = first + size;
    }
    if (trials.incomplete == IncompleteWindow::kKeep && covered < end) {
      found.windows.push_back({first, end - first, p});
      covered = end;
    }
    found.left_out += end - covered;
  }
  return found;
}

Channel cut(const Channel& channel, const CsvWindow& window) {
  Channel part{channel.name, channel.unit, channel.element_names, {}, {}};
  part.shape = channel.shape;
  if (channel.frames.empty()) return part;
  part.frames = rows_of(channel.frames, window);
  part.rate = channel.rate;
  if (!channel.times.empty()) part.times = times_of(channel.times, window);
  if (channel.valid.empty()) return part;
  part.valid = rows_of(channel.valid, window);
  if (all_valid(part.valid)) part.valid = {};
  return part;
}

}  // namespace somato
