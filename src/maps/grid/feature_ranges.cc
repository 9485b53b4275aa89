#include "maps/grid/feature_ranges.h"

#include <algorithm>
#include <limits>

namespace somato {
namespace {

// The greatest of all processes.
void maximize(ProcessGroup& processes, std::vector<float>& values) {
  std::vector<double> numbers(values.begin(), values.end());
  processes.maximize(numbers);
  std::transform(numbers.begin(), numbers.end(), values.begin(),
                 [](double number) { return static_cast<float>(number); });
}

void negate(std::vector<float>& values) {
  for (float& value : values) value = -value;
}

}  // namespace

// Zeros of sparse samples count.
void widen_ranges(const Samples& samples, std::vector<float>& low, std::vector<float>& high) {
  if (samples.count() == 0) return;
  std::vector<float> row(samples.size());
  write_dense(samples[0], row);
  if (low.empty()) low = row;
  if (high.empty()) high = row;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    write_dense(samples[i], row);
    for (std::size_t d = 0; d < row.size(); ++d) {
      low[d] = std::min(low[d], row[d]);
      high[d] = std::max(high[d], row[d]);
    }
  }
}

void combine_ranges(ProcessGroup& processes, std::size_t size, std::vector<float>& low,
                    std::vector<float>& high) {
  low.resize(size, std::numeric_limits<float>::max());
  high.resize(size, std::numeric_limits<float>::lowest());
  negate(low);
  maximize(processes, low);
  negate(low);
  maximize(processes, high);
}

}  // namespace somato
