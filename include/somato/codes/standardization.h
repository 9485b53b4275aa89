#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/sample_source.h"
#include "somato/core/samples.h"
#include "somato/core/signal.h"

namespace somato {

/// What happens to a column that has the same value in all training samples.
enum class ConstantColumns {
  kRefuse,  ///< It is an error.
  kZero,    ///< The column becomes 0, whatever it holds later.
};

template <>
struct Choices<ConstantColumns> {
  static const std::vector<std::pair<ConstantColumns, std::string>>& all();
};

/// The parameters of a standardization.
struct StandardizationParameters {
  ConstantColumns constant_columns = ConstantColumns::kRefuse;

  static const Declarations<StandardizationParameters>& declarations();
};

/// Shifts and scales every column so that the samples it was fitted to have mean 0 and standard
/// deviation 1. In a study it is fitted to the training part alone.
struct Standardization {
  std::vector<double> means;
  /// Population standard deviations (divided by the count, not the count less one), in the unit of
  /// their column; 0 marks a constant column.
  std::vector<double> deviations;

  /// Learns means and deviations from at least two samples, summed in their order in double
  /// precision. `column_names` may be empty; otherwise one a column, used in messages.
  /// Errors (kData): fewer than two samples; a value that is not finite; with `refuse` a constant
  /// column. They give sample and column counted from 1.
  static Result<Standardization> fit(const Samples& samples,
                                     const StandardizationParameters& parameters = {},
                                     const std::vector<std::string>& column_names = {});

  /// The same from samples that need not fit into memory, which are gone through twice. Fails also
  /// as the source does.
  static Result<Standardization> fit(SampleSource& samples,
                                     const StandardizationParameters& parameters = {},
                                     const std::vector<std::string>& column_names = {});

  /// Writes the standardized `sample` to `out`; throws InvalidArgument when a size differs.
  void apply(const SignalView& sample, std::span<float> out) const;

  /// All samples standardized, dense; throws InvalidArgument when the sizes differ.
  Samples apply(const Samples& samples) const;
};

}  // namespace somato
