#pragma once

#include <span>

namespace somato {

/// Whether the mean of `errors` is below that of `others`, of the same things in the same order, by
/// more than one standard error of the differences (the rule of one standard error of Breiman and
/// others, Classification and Regression Trees, 1984). Throws InvalidArgument if the numbers of
/// errors differ or are 0.
bool is_clearly_better(std::span<const double> errors, std::span<const double> others);

}  // namespace somato
