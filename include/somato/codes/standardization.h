#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/core/signal.h"

namespace somato {

/// Treatment of a column that is constant in the training samples.
enum class ConstantColumns {
  kRefuse,  ///< It is an error.
  kZero,    ///< The column becomes 0 for all samples.
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

/// Shifts and scales every column so that the samples used for fitting have mean 0 and standard
/// deviation 1. In a study it is fitted to the training part only.
struct Standardization {
  std::vector<double> means;
  /// Population standard deviations (divided by the count, not the count minus one), in the unit of
  /// their column; 0 marks a constant column.
  std::vector<double> deviations;

  /// Fits means and deviations to at least two samples, summed in order in double precision.
  /// `column_names`, used in messages, has one name per column or is empty. Errors (kData): fewer
  /// than two samples; a value that is not finite; with `refuse` a constant column. They state
  /// sample and column counted from 1.
  static Result<Standardization> fit(const Samples& samples,
                                     const StandardizationParameters& parameters = {},
                                     const std::vector<std::string>& column_names = {});

  /// The same for samples that need not fit into memory, which are read in two passes. Also fails
  /// if the source does.
  static Result<Standardization> fit(SampleSource& samples,
                                     const StandardizationParameters& parameters = {},
                                     const std::vector<std::string>& column_names = {});

  /// The means of columns that lie far from 0, and 0 for others: what has to be subtracted in
  /// double precision before the numbers are rounded to float32.
  std::vector<double> offsets() const;

  /// The same for numbers from which the offsets have been subtracted.
  Standardization without(std::span<const double> offsets) const;

  /// Writes the standardized `sample` to `out`; throws InvalidArgument if a size differs.
  void apply(const SignalView& sample, std::span<float> out) const;

  /// All samples standardized, dense; throws InvalidArgument if the sizes differ.
  Samples apply(const Samples& samples) const;
};

}  // namespace somato
