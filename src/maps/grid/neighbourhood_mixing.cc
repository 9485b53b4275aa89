#include "maps/grid/neighbourhood_mixing.h"

#include <algorithm>

#include "base/kernels/batch_kernels.h"
#include "somato/core/check.h"

namespace somato {

NeighbourhoodMixing::NeighbourhoodMixing(const Grid& grid, NeighbourhoodShape shape, double radius)
    : grid_(grid),
      separable_(shape == NeighbourhoodShape::kGaussian),
      parities_(grid.lattice() == Lattice::kHexagonal ? 2 : 1) {
  if (separable_) {
    prepare_separable(radius);
  } else {
    prepare_by_rows(shape, radius);
  }
}

void NeighbourhoodMixing::prepare_separable(double radius) {
  const std::size_t columns = grid_.columns();
  const std::size_t rows = grid_.rows();
  for (std::size_t out_parity = 0; out_parity < parities_; ++out_parity) {
    for (std::size_t in_parity = 0; in_parity < parities_; ++in_parity) {
      AlignedVector<double>& factors = column_factors_.emplace_back();
      factors.reserve(columns * columns);
      for (std::size_t i = 0; i < columns * columns; ++i) {
        factors.push_back(gaussian_factor(
            grid_.horizontal_difference(i / columns, out_parity, i % columns, in_parity), radius));
      }
    }
    AlignedVector<double>& factors = row_factors_.emplace_back();
    factors.reserve(rows * rows);
    for (std::size_t row = out_parity; row < rows; row += parities_) {
      for (std::size_t other = 0; other < rows; ++other) {
        factors.push_back(gaussian_factor(grid_.vertical_difference(row, other), radius));
      }
    }
  }
}

// Rows of the same distance, beginning at a row of the same parity, have the same factors. Pairs
// that begin at the first and at the last row of a parity have all distances.
void NeighbourhoodMixing::prepare_by_rows(NeighbourhoodShape shape, double radius) {
  const std::size_t rows = grid_.rows();
  Neighbourhood neighbourhood(grid_, shape);
  blocks_.resize(parities_ * rows);
  for (std::size_t parity = 0; parity < std::min(parities_, rows); ++parity) {
    prepare_blocks_from(parity, neighbourhood, radius);
    prepare_blocks_from(rows - 1 - (rows - 1 - parity) % parities_, neighbourhood, radius);
  }
}

void NeighbourhoodMixing::prepare_blocks_from(std::size_t row, Neighbourhood& neighbourhood,
                                              double radius) {
  const std::size_t columns = grid_.columns();
  std::vector<double> around(grid_.size());
  for (std::size_t column = 0; column < columns; ++column) {
    neighbourhood.around(row * columns + column, radius, around);
    for (std::size_t other = 0; other < grid_.rows(); ++other) {
      const auto factors = std::span(around).subspan(other * columns, columns);
      const bool any = std::any_of(factors.begin(), factors.end(), [](double f) { return f != 0; });
      AlignedVector<double>& block = blocks_[block_of(row, other)];
      if (!any && block.empty()) continue;
      block.resize(columns * columns);
      std::copy(factors.begin(), factors.end(),
                block.begin() + static_cast<std::ptrdiff_t>(column * columns));
    }
  }
}

std::size_t NeighbourhoodMixing::block_of(std::size_t row, std::size_t other) const {
  const std::size_t distance = row > other ? row - other : other - row;
  return row % parities_ * grid_.rows() + distance;
}

void NeighbourhoodMixing::apply(std::span<const double> in, std::span<double> out,
                                Workspace& workspace) const {
  require(in.size() == grid_.size() * kLanes && out.size() == in.size(),
          "a neighbourhood mixes eight values per neuron");
  std::fill(out.begin(), out.end(), 0.0);
  if (separable_) {
    apply_separable(in, out, workspace);
  } else {
    apply_by_rows(in, out);
  }
}

// Along the columns first, for both parities of the requested rows; the result is stored column by
// column for the second pass along the rows.
void NeighbourhoodMixing::apply_separable(std::span<const double> in, std::span<double> out,
                                          Workspace& workspace) const {
  const auto& kernels = kernels::batch_table();
  const std::size_t columns = grid_.columns();
  const std::size_t rows = grid_.rows();
  auto& mixed = workspace.columns_mixed;
  auto& line = workspace.rows_mixed;
  mixed.resize(grid_.size() * kLanes);
  for (std::size_t parity = 0; parity < parities_; ++parity) {
    for (std::size_t row = 0; row < rows; ++row) {
      line.assign(columns * kLanes, 0.0);
      const auto& factors = column_factors_[parity * parities_ + row % parities_];
      kernels.mix(factors.data(), in.data() + row * columns * kLanes, columns, line.data(),
                  columns);
      for (std::size_t column = 0; column < columns; ++column) {
        std::copy_n(line.data() + column * kLanes, kLanes,
                    mixed.data() + (column * rows + row) * kLanes);
      }
    }
    const std::size_t outputs = (rows - parity + parities_ - 1) / parities_;
    for (std::size_t column = 0; column < columns; ++column) {
      line.assign(outputs * kLanes, 0.0);
      kernels.mix(row_factors_[parity].data(), mixed.data() + column * rows * kLanes, rows,
                  line.data(), outputs);
      for (std::size_t i = 0; i < outputs; ++i) {
        const std::size_t neuron = (parity + i * parities_) * columns + column;
        std::copy_n(line.data() + i * kLanes, kLanes, out.data() + neuron * kLanes);
      }
    }
  }
}

void NeighbourhoodMixing::apply_by_rows(std::span<const double> in, std::span<double> out) const {
  const std::size_t columns = grid_.columns();
  const std::size_t rows = grid_.rows();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t other = 0; other < rows; ++other) {
      const AlignedVector<double>& block = blocks_[block_of(row, other)];
      if (block.empty()) continue;
      kernels::batch_table().mix(block.data(), in.data() + other * columns * kLanes, columns,
                                 out.data() + row * columns * kLanes, columns);
    }
  }
}

}  // namespace somato
