#include "studies/sweep/first_order.h"

#include <map>
#include <utility>

#include "somato/core/check.h"

namespace somato {
namespace {

struct CellSum {
  double sum = 0.0;
  double count = 0.0;

  double mean() const { return sum / count; }
};

}  // namespace

std::optional<FirstOrder> first_order(const std::vector<double>& values,
                                      const std::vector<std::size_t>& cells) {
  require(values.size() == cells.size(), "each point has a value and a cell");
  CellSum all;
  std::map<std::size_t, CellSum> of_cell;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (CellSum* sums : {&all, &of_cell[cells[i]]}) {
      sums->sum += values[i];
      sums->count += 1.0;
    }
  }
  double total = 0.0;
  for (const double value : values) total += (value - all.mean()) * (value - all.mean());
  constexpr double kRounding = 1e-12;  // of shares, which are at most 1
  if (of_cell.size() < 2 || total <= kRounding * all.count) return {};
  double between = 0.0;
  for (const auto& [cell, sums] : of_cell) {
    between += sums.count * (sums.mean() - all.mean()) * (sums.mean() - all.mean());
  }
  const auto count = static_cast<double>(of_cell.size());
  return FirstOrder{between / total, (count - 1.0) / (all.count - 1.0)};
}

}  // namespace somato
