#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "maps/grid/neighbourhood.h"
#include "somato/core/matrix.h"
#include "somato/maps/grid.h"

namespace somato {

/// Weighted sums over whole neighbourhoods: out(k) = sum over j of h(k, j) in(j), with h the
/// neighbourhood function at one radius, for eight values (a cache line of doubles) a neuron at
/// once. Sums have one fixed order.
///
/// A Gaussian without cut-off is a product of a factor of the rows' distance and a factor of the
/// columns', so it takes two passes, each along one side of the grid; on a hexagonal grid the
/// latter also depends on both rows' parities. Other shapes are summed row by row.
class NeighbourhoodMixing {
 public:
  static constexpr std::size_t kLanes = LaneMatrix<double>::kLanes;

  /// Scratch memory: one object a thread.
  struct Workspace {
    AlignedVector<double> columns_mixed;
    AlignedVector<double> rows_mixed;
  };

  NeighbourhoodMixing(const Grid& grid, NeighbourhoodShape shape, double radius);

  /// `in` and `out` hold kLanes values a neuron, on cache lines.
  void apply(std::span<const double> in, std::span<double> out, Workspace& workspace) const;

 private:
  void apply_separable(std::span<const double> in, std::span<double> out,
                       Workspace& workspace) const;
  void apply_by_rows(std::span<const double> in, std::span<double> out) const;
  void prepare_separable(double radius);
  void prepare_by_rows(NeighbourhoodShape shape, double radius);
  void prepare_blocks_from(std::size_t row, Neighbourhood& neighbourhood, double radius);
  std::size_t block_of(std::size_t row, std::size_t other) const;

  Grid grid_;
  bool separable_;
  std::size_t parities_;
  // Separable: for out and in parity, columns x columns; for each out parity, its rows x rows.
  std::vector<AlignedVector<double>> column_factors_;
  std::vector<AlignedVector<double>> row_factors_;
  // By rows: for each parity of a row and distance of another row, columns x columns, or nothing
  // where all are 0.
  std::vector<AlignedVector<double>> blocks_;
};

}  // namespace somato
