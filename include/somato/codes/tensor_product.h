#pragma once

#include <span>

#include "somato/core/signal.h"

namespace somato {

/// The tensor product of one or more signals: M_ij = x_i y_j, with concatenated rows (P06 section
/// 1), and correspondingly for further signals.
///
/// The shape is the concatenation of the shapes of `inputs`, flattened row-major, so the product of
/// a product with a third signal equals the product of all three. Elements are multiplied from left
/// to right, in single precision. The result is sparse if any input is; then only the non-zero
/// elements of the inputs are visited, including those of dense inputs, and no zero is stored.
/// Inputs must be finite: a sparse result omits infinities and NaN that are multiplied by zero.
///
/// Throws InvalidArgument without inputs and for more than 2^32 - 1 elements.
Signal tensor_product(std::span<const Signal> inputs);

/// The same, flat, into `out`; `scratch` is temporary memory. Neither may be among the inputs. Does
/// not allocate if both are large enough.
void tensor_product(std::span<const SignalView> inputs, SignalBuffer& scratch, SignalBuffer& out);

}  // namespace somato
