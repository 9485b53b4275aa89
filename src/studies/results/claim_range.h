#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "somato/studies/claim.h"
#include "somato/studies/results.h"

namespace somato {

/// The central range of values: from the least to the greatest one when as many values are left out
/// at either end as are in half of the share outside of kCentralShare, rounded down. Nothing
/// without values.
std::optional<ClaimRange> central_range(const Distribution& values);

/// The same of a list; nothing if a value is not finite.
std::optional<ClaimRange> central_range(const std::vector<double>& values);

/// The mean of the means of the recordings. `recordings` has the number of the recording of each
/// value. Nothing without values, with one that is not finite, or if the sizes differ.
std::optional<double> mean_of_recordings(const std::vector<double>& values,
                                         const std::vector<std::size_t>& recordings);

/// The two-sided 95 % interval of this mean by Student's t: the recordings are independent, unlike
/// the pairs of one recording. Nothing in the same cases, and with fewer than kLeastRecordings
/// recordings.
std::optional<ClaimRange> interval_of_mean(const std::vector<double>& values,
                                           const std::vector<std::size_t>& recordings);

/// The 97.5 % quantile of Student's t distribution, to 1e-5. Throws InvalidArgument for 0 degrees
/// of freedom.
double t_quantile(std::size_t degrees_of_freedom);

}  // namespace somato
