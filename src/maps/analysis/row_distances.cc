#include "maps/analysis/row_distances.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "somato/maps/som_training.h"

namespace somato {

// A row of neurons that have the rows as weights; what is compared with them is prepared already.
RowDistances::RowDistances(SomParameters parameters, LaneMatrix<float> rows) {
  parameters.rows = 1;
  parameters.columns = rows.rows();
  parameters.lattice = Lattice::kRectangular;
  parameters.topology = Topology::kPlane;
  parameters.normalize_input = false;
  parameters.relevances.clear();
  as_neurons_ = Som(std::move(parameters), std::move(rows));
}

RowDistances RowDistances::of_neurons(const Som& som) {
  return {som.parameters(), som.weights()};
}

RowDistances RowDistances::of_samples(const Som& som, const Samples& samples) {
  Samples storage;
  const Samples& prepared = prepared_samples(som.parameters(), samples, storage);
  const StoredElements elements = StoredElements::used_by(prepared);
  LaneMatrix<float> rows(prepared.count(), elements.count());
  std::vector<float> row(elements.count());
  for (std::size_t i = 0; i < prepared.count(); ++i) {
    elements.gather(prepared[i], row);
    rows.set_row(i, row);
  }
  return {som.parameters(), std::move(rows)};
}

void RowDistances::write_from(std::size_t row, std::span<double> out) const {
  std::vector<float> values(as_neurons_.weights().columns());
  as_neurons_.weights().copy_row(row, values);
  SomWorkspace workspace;
  for (std::size_t other = 0; other < out.size(); ++other) {
    out[other] = as_neurons_.distance(SignalView::dense(values), other, workspace);
  }
}

std::vector<std::size_t> others_by_distance(const std::vector<double>& distances, std::size_t row) {
  std::vector<std::size_t> others(distances.size());
  std::iota(others.begin(), others.end(), std::size_t{0});
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(row));
  std::sort(others.begin(), others.end(), [&](std::size_t a, std::size_t b) {
    return distances[a] != distances[b] ? distances[a] < distances[b] : a < b;
  });
  return others;
}

}  // namespace somato
