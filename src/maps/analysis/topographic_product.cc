#include "maps/analysis/topographic_product.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "base/core/elementary.h"
#include "base/core/threads.h"
#include "maps/analysis/grid_distances.h"
#include "maps/analysis/row_distances.h"

namespace somato {
namespace {

std::vector<double> logarithms(const std::vector<double>& values) {
  std::vector<double> logs(values.size());
  std::transform(values.begin(), values.end(), logs.begin(),
                 [](double value) { return natural_log(value); });
  return logs;
}

// The sum of log P3(neuron, k) over k: equations 11 to 15 of the paper.
double product_around(const RowDistances& inputs, const Grid& grid, std::size_t neuron) {
  std::vector<double> of_weights(grid.size());
  inputs.write_from(neuron, of_weights);
  const std::vector<double> squares = squared_grid_distances(grid, neuron);
  const std::vector<std::size_t> near_on_grid = others_by_distance(squares, neuron);
  const std::vector<std::size_t> near_in_input = others_by_distance(of_weights, neuron);
  if (of_weights[near_in_input.front()] == 0.0 || std::isinf(squares[near_on_grid.back()])) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::vector<double> log_weights = logarithms(of_weights);
  const std::vector<double> log_squares = logarithms(squares);
  double log_product = 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < near_on_grid.size(); ++k) {
    const std::size_t a = near_on_grid[k];
    const std::size_t v = near_in_input[k];
    log_product += log_weights[a] - log_weights[v] + 0.5 * (log_squares[a] - log_squares[v]);
    sum += log_product / (2.0 * static_cast<double>(k + 1));
  }
  return sum;
}

}  // namespace

double topographic_product(const Som& som, std::size_t threads) {
  const std::size_t neurons = som.neurons();
  if (neurons < 2) return std::numeric_limits<double>::quiet_NaN();
  const RowDistances inputs = RowDistances::of_neurons(som);
  std::vector<double> sums(neurons);
  for_each_range(neurons, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) sums[j] = product_around(inputs, som.grid(), j);
  });
  const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
  return sum / (static_cast<double>(neurons) * static_cast<double>(neurons - 1));
}

}  // namespace somato
