#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/numbers/known_values.h"
#include "somato/core/parameter.h"
#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"

namespace somato {

/// Treatment of missing values, which are NaN in samples.
enum class MissingFill {
  kRefuse,   ///< They are an error.
  kMean,     ///< The mean of their column, over the training samples that know it.
  kNearest,  ///< The value of the nearest complete sample; with a trained map, the winner's weight.
  kLeaveOut,  ///< Left out of distances and updates in training; with a trained map as kNearest.
};

template <>
struct Choices<MissingFill> {
  static const std::vector<std::pair<MissingFill, std::string>>& all();
};

/// The samples, dense, with each missing value replaced by that of its column in `values`, rounded
/// to float32. Throws InvalidArgument when the sizes differ.
Samples filled_with(std::span<const double> values, const Samples& samples);

/// The samples, dense, with the missing values of each replaced by those of the nearest complete
/// sample: the one with the least sum of squared differences over the columns with a known value in
/// the sample, each difference divided by the column's entry in `scale` (not divided if `scale` is
/// empty a column with scale 0 does not count), in double precision; the first one in a tie. This
/// is imputation by the nearest neighbour among the complete cases, a form of hot deck: Chen and
/// Shao, "Nearest neighbor imputation for survey data", Journal of Official Statistics 16(2), 2000;
/// with missing values in patterns, Dixon, "Pattern recognition with partly missing data", IEEE
/// Transactions on Systems, Man, and Cybernetics 9(10), 1979. Errors: kData if no sample is
/// complete; kInterrupted.
Result<Samples> filled_from_nearest(const Samples& samples, std::span<const double> scale,
                                    const Progress& progress = {});

/// The standard deviation (population) of the known values of each column around `means`.
std::vector<double> known_deviations(const Samples& samples, std::span<const double> means);

}  // namespace somato
