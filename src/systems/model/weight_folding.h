#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "somato/codes/standardization.h"
#include "somato/core/matrix.h"
#include "somato/graph/system.h"

namespace somato::detail {

/// A weight for each element of a module's output, or only for those at `places`, which ascend; all
/// others are 0.
struct FoldedWeights {
  std::size_t size = 0;
  std::vector<std::uint32_t> places;  ///< Empty: `values` has all elements.
  std::vector<double> values;
};

/// An end of the projection: a module, and whether its weights are in the unit of its output.
struct FoldingEnd {
  std::size_t module = 0;
  bool unit = false;
};

/// The kind of values that are projected, which decides how they pass through a module.
enum class Folded {
  kWeights,        ///< Values in place of inputs: see channel_planes().
  kContributions,  ///< Parts of a sum, which is preserved: see ContributionReader.
};

/// The projection of weights or contributions from the output of the module `input` back to
/// channels.
class WeightFolding {
 public:
  /// `unit`: whether the weights are in the unit of the input. The system must have learned,
  /// outlive this object, and not change.
  WeightFolding(const System& system, std::size_t input, bool unit,
                Folded folded = Folded::kWeights);

  /// In the order of fold(); only the input if more than 256 paths lead back from it.
  const std::vector<FoldingEnd>& ends() const { return ends_; }

  /// Whether every element of the input is one of an end.
  bool is_plain() const { return plain_; }

  /// For each end the projected weights at its elements.
  std::vector<std::vector<double>> fold(FoldedWeights weights) const;

 private:
  // Properties of the path from the map: whether weights are in a unit, and still single ones.
  struct Way {
    bool unit = false;
    bool single = true;
  };
  using Rows = std::vector<std::vector<double>>;

  void find_ends(std::size_t module, Way way, std::size_t depth);
  void remember(std::size_t module);
  void fold(std::size_t module, FoldedWeights weights, Way way, std::size_t depth,
            Rows& rows) const;
  void fold_product(std::size_t module, const FoldedWeights& weights, Way way, std::size_t depth,
                    Rows& rows) const;
  void fold_concatenation(std::size_t module, const FoldedWeights& weights, Way way,
                          std::size_t depth, Rows& rows) const;
  void fold_t_mpsom(std::size_t module, const FoldedWeights& weights, Way way, std::size_t depth,
                    Rows& rows) const;
  std::vector<double> sums_of_places(std::size_t module, const FoldedWeights& weights) const;
  std::vector<double> bin_centres(std::size_t module, const FoldedWeights& weights) const;
  std::vector<double> undone(std::size_t module, const FoldedWeights& weights) const;
  std::size_t size_of(std::size_t module) const;

  const System& system_;
  std::size_t input_;
  Folded folded_;
  Way start_;
  std::vector<FoldingEnd> ends_;
  bool plain_ = true;
  bool whole_ = false;  // too many ways
  // By module.
  std::map<std::size_t, Standardization> standardizations_;
  std::map<std::size_t, std::vector<std::pair<double, double>>> ranges_;
  std::map<std::size_t, std::vector<Matrix<float>>>
      receptive_;  // by input: shares that add up to 1
};

}  // namespace somato::detail
