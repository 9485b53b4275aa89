#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "maps/products/sample_products.h"
#include "somato/core/matrix.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// Where random initial weights may lie, element by element.
struct InitialRanges {
  std::vector<float> low;
  std::vector<float> span;
};

/// The elements whose weights training by products multiplies with samples, or forms, in strips
/// that stay in a processor's first cache. Weights are made for one strip of sixteen neurons at a
/// time and used at once, so that they need no memory.
class WeightStrips {
 public:
  /// `elements`, ascending, are those where weights can be other than 0; their weights stand at
  /// `places` of the whole.
  WeightStrips(SomParameters parameters, const SampleProducts& samples,
               std::vector<std::uint32_t> elements, std::vector<std::uint32_t> places,
               InitialRanges ranges);

  /// Adds to `products` (samples x padded neurons) those of the initial weights with the samples,
  /// to `squares` their own: for neurons 16 begin .. 16 end - 1.
  void add_products(std::size_t begin, std::size_t end, std::span<double> products,
                    std::span<double> squares) const;

  /// Writes the weights of the same neurons: of_start times the initial ones and coefficients
  /// (samples x padded neurons) times the samples.
  void form(std::size_t begin, std::size_t end, std::span<const double> of_start,
            std::span<const double> coefficients, LaneMatrix<float>& weights) const;

 private:
  struct Strip {
    std::size_t first = 0;  // of the elements
    std::size_t count = 0;
    std::size_t first_quarter = 0;  // groups of four numbers, see random.h
    std::size_t quarters = 0;
  };
  class Workspace;

  bool random() const { return !ranges_.low.empty(); }
  void cut();
  void find_columns();
  kernels::ListedValues listed(const Strip& strip) const;
  void start(const Strip& strip, std::size_t block, Workspace& workspace) const;
  void form_block(const Strip& strip, const Workspace& workspace, const double* of_start,
                  const double* coefficients, float* out) const;

  SomParameters parameters_;
  const SampleProducts& samples_;
  std::vector<std::uint32_t> elements_;
  std::vector<std::uint32_t> places_;
  InitialRanges ranges_;
  std::vector<Strip> strips_;
  std::vector<std::uint32_t> quarters_;
  std::vector<std::uint32_t> numbers_;  // where an element's number stands among its strip's
  std::vector<std::uint32_t> begins_;   // of sparse samples: the values in an element's column
  std::vector<std::uint32_t> ends_;
};

}  // namespace somato
