#pragma once

#include <span>

#include "somato/core/signal.h"
#include "somato/core/signal_buffer.h"

namespace somato {

/// The tensor product of one or more signals: M_ij = x_i y_j, rows put after each other (P06
/// section 1), and so on for further signals.
///
/// The shape is the shapes of `inputs` one after the other, flattened row-major, so the product of
/// a product with a third signal equals the product of all three. Elements are multiplied from left
/// to right, in single precision. The result is sparse when any input is; then only the non-zero
/// elements of the inputs are visited, dense inputs included, and no zero is stored. Infinities and
/// NaN have no place here: a sparse result forgets those that meet a zero.
///
/// Throws InvalidArgument for no input and for more than 2^32 - 1 elements.
Signal tensor_product(std::span<const Signal> inputs);

/// The same, flat, into `out`; `scratch` is needed on the way. Neither may be among the inputs.
/// Nothing is allocated once both have grown.
void tensor_product(std::span<const SignalView> inputs, SignalBuffer& scratch, SignalBuffer& out);

}  // namespace somato
